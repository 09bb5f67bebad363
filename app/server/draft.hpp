#pragma once
// Unsaved changes of a project, next to its file as `.NAME.draft`: TOML, after comments with the checksum of the file
// it began from and the revisions.

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus::server {

/// A change of a draft: the browser tab that made it and the tab's count of changes. As text: `3f9a.12`.
struct Revision {
  std::string tab;
  std::uint64_t count = 0;
};
/// nullopt if the text is not a revision.
[[nodiscard]] std::optional<Revision> revision_of(std::string_view text);
[[nodiscard]] std::string text_of(const Revision& revision);

struct Draft {
  std::string text;
  std::optional<std::string> saved;   // checksum of the file that it began from; nullopt: there was no file
  std::vector<Revision> revisions{};  // the last of each tab involved, the current one at the end; empty: unknown
};

/// Whether revision `next`, made from revision `after` (nullopt: from no draft), continues this draft, or an older one
/// of the same tab. Only then no change is lost if it replaces the draft.
[[nodiscard]] bool continues(const Draft& draft, const std::optional<Revision>& after, const Revision& next);
/// The revisions after adding `next`.
[[nodiscard]] std::vector<Revision> with_revision(std::vector<Revision> revisions, const Revision& next);

/// Held while files and drafts of projects are compared and written: tabs may save at the same time.
[[nodiscard]] std::mutex& project_writing();

/// The place of the draft. `file`, here and below: the project's.
[[nodiscard]] std::filesystem::path draft_place(const std::filesystem::path& file);
/// nullopt if there is none.
[[nodiscard]] std::optional<Draft> draft_of(const std::filesystem::path& file);
void save_draft(const std::filesystem::path& file, const Draft& draft);
void remove_draft(const std::filesystem::path& file);

}  // namespace talus::server
