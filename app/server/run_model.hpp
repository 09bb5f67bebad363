#pragma once
// The model of a project's text, or of a run.

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "http/answer.hpp"
#include "talus/campaign/model.hpp"
#include "talus/project/project.hpp"
#include "talus/project/read.hpp"

namespace talus::server {

struct BuiltProject {
  project::Project project;
  Model model;
  Problems warnings;
};

/// Approximate memory of a model.
[[nodiscard]] std::size_t bytes_of(const Model& model);

/// How many elements from the front of the row, each with a member `bytes`, need at most `most_bytes` together; at
/// least 1.
template <class Row>
[[nodiscard]] std::size_t count_within(const Row& row, std::size_t most_bytes) {
  std::size_t count = 0, bytes = 0;
  for (const auto& each : row) {
    bytes += each->bytes;
    if (count > 0 && bytes > most_bytes) break;
    ++count;
  }
  return count;
}

/// Builds the model of a project's text, as if it were in `file`. Throws BadInput with all problems.
[[nodiscard]] BuiltProject build(std::string_view text, const std::filesystem::path& file,
                                 const project::Overrides& overrides);

/// Makes the names of files in problems relative to the folder.
[[nodiscard]] Problems seen_from(const std::filesystem::path& folder, const Problems& problems);

}  // namespace talus::server
