#pragma once
// Models for the page: built from the text of a project, and cached.

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
  std::string files{};    // hash of the names, sizes and times of the files that were read
  std::size_t bytes = 0;  // approximate memory of the model
  project::Project project{};
  Model model{};
  Problems warnings{};
};

/// Thread-safe. A model stays valid while it is held, even if the shelf has dropped it.
class ModelShelf {
 public:
  using Held = std::shared_ptr<const ShelvedModel>;

  /// Keeps models of `most_bytes` in total, or a single larger one.
  ModelShelf(ModelReading& reading, std::size_t most_bytes) : reading_(reading), most_bytes_(most_bytes) {}

  /// The model of a project's text, with files relative to `file`. It is only rebuilt if the text or a file that it
  /// reads has changed. Throws BadInput, and as ModelReading::read().
  [[nodiscard]] Held build(const std::filesystem::path& file, std::string_view text);
  /// Refuses (404) an id that is unknown or no longer kept.
  [[nodiscard]] Held find(const std::string& id) const;

 private:
  static constexpr std::size_t most_kept = 4;
  [[nodiscard]] Held kept(const std::string& id) const;

  ModelReading& reading_;
  std::size_t most_bytes_;
  mutable std::mutex shelf_;
  std::deque<Held> models_;  // most recently used first
};

}  // namespace talus::server
