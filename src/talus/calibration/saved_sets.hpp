#pragma once
// Finished sets on disk, so that a calibration can be continued.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

class SavedSets {
 public:
  /// Reads the sets that were saved in `folder` under this fingerprint. Files of another study, or damaged ones, are
  /// removed.
  SavedSets(std::filesystem::path folder, std::string fingerprint);

  [[nodiscard]] std::size_t size() const { return samples_.size(); }
  [[nodiscard]] std::optional<std::vector<Sample>> of(std::size_t set) const;
  /// Writes consecutive sets to a file.
  void save(std::size_t first, const std::vector<SetResult>& sets) const;

 private:
  void read(const std::filesystem::path& file);

  std::filesystem::path folder_;
  std::string fingerprint_;
  std::map<std::size_t, std::vector<Sample>> samples_;
};

}  // namespace talus::calibration
