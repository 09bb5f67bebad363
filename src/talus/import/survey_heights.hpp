#pragma once
// The heights of features, which their geometry or an attribute has.

#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/files/first_problems.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {

class FeatureHeights {
 public:
  /// `may_lack`: whether features without heights are accepted as they are.
  FeatureHeights(const std::filesystem::path& file, std::string attribute, bool may_lack)
      : file_(file), attribute_(std::move(attribute)), may_lack_(may_lack), problems_(file.string(), "features") {}

  [[nodiscard]] std::vector<std::string> attributes() const {
    return attribute_.empty() ? std::vector<std::string>{} : std::vector<std::string>{attribute_};
  }

  /// Sets the heights of the feature's vertices; an error if it has none.
  bool assign(VectorFeature& feature);
  /// Reports errors, and heights that seem not to have been filled in, of all features or of some.
  void finish(bool others_have_heights, const std::string& layer_key, Problems& warnings);

 private:
  struct Level {
    std::size_t features = 0;
    std::string first;
  };

  void warn_of_some(const std::string& layer_key, Problems& warnings) const;
  bool refuse(std::string what, std::string why, std::string hint = "");

  const std::filesystem::path& file_;
  std::string attribute_;
  bool may_lack_;
  FirstProblems problems_;
  std::map<double, Level> fillers_;  // features all of whose vertices are at 0, or at another filler value
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;  // of the others
};

/// "elev_ft", "Z (feet)": as in the columns of text files, a unit in a name counts if it is a word.
[[nodiscard]] bool names_feet(std::string_view attribute);

}  // namespace talus
