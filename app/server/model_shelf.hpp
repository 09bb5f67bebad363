#pragma once
// Models that the page looks at: built from the text of a project, and kept while they are looked at.

#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "model_reading.hpp"
#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::server {

struct ShelvedModel {
  std::string id;
  std::string files{};    // a hash of which were read, and of their sizes and times
  std::size_t bytes = 0;  // that the model takes, about
  project::Project project{};
  Model model{};
  Problems warnings{};
};

/// For threads side by side: a model is good as long as it is held, though the shelf let go of it meanwhile.
class ModelShelf {
 public:
  using Held = std::shared_ptr<const ShelvedModel>;

  /// Keeps models of so many bytes, or one that is larger.
  ModelShelf(ModelReading& reading, std::size_t most_bytes) : reading_(reading), most_bytes_(most_bytes) {}

  /// The model of a project, whose files are relative to `file`: built, or the same as before where neither the text
  /// nor a file that was read has changed. Throws BadInput, and as ModelReading.
  [[nodiscard]] Held build(const std::filesystem::path& file, std::string_view text);
  /// Throws a refusal (404) where there is none of this id, or none any more.
  [[nodiscard]] Held find(const std::string& id) const;

 private:
  static constexpr std::size_t most_kept = 4;
  [[nodiscard]] Held kept(const std::string& id) const;

  ModelReading& reading_;
  std::size_t most_bytes_;
  mutable std::mutex shelf_;
  std::deque<Held> models_;  // the one used last in front
};

}  // namespace talus::server
