#pragma once
// Models that the page looks at: built from the text of a project, and kept while they are looked at.

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::server {

struct ShelvedModel {
  std::string id;
  std::string files;  // a hash of which were read, and of their sizes and times
  project::Project project;
  Model model;
  Problems warnings;
};

/// For threads side by side: a model is good as long as it is held, though the shelf let go of it meanwhile.
class ModelShelf {
 public:
  using Held = std::shared_ptr<const ShelvedModel>;

  /// `building`: held while a model is built.
  explicit ModelShelf(std::mutex& building) : building_(building) {}

  /// The model of a project, whose files are relative to `file`: built, or the same as before where neither the text
  /// nor a file that was read has changed. One at a time. Throws BadInput.
  [[nodiscard]] Held build(const std::filesystem::path& file, std::string_view text);
  /// Throws a refusal (404) where there is none of this id, or none any more.
  [[nodiscard]] Held find(const std::string& id) const;

 private:
  static constexpr std::size_t most_kept = 4;
  [[nodiscard]] Held kept(const std::string& id) const;

  std::mutex& building_;
  mutable std::mutex shelf_;
  std::deque<Held> models_;  // the one used last in front
  std::uint64_t built_ = 0;
};

}  // namespace talus::server
