#pragma once
// What of a project is not saved yet, beside its file as `.NAME.draft`: TOML, with a comment above that says of which
// file it is a draft.

#include <filesystem>
#include <optional>
#include <string>

namespace talus::server {

struct Draft {
  std::string text;
  std::optional<std::string> saved;  // the checksum of the file that it began from; none: there was no file
};

/// Nothing where there is none. `file` is the project's, here and below.
[[nodiscard]] std::optional<Draft> draft_of(const std::filesystem::path& file);
void keep_draft(const std::filesystem::path& file, const Draft& draft);
void remove_draft(const std::filesystem::path& file);

}  // namespace talus::server
