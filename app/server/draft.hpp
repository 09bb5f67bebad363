#pragma once
// What of a project is not saved yet, beside its file as `.NAME.draft`: TOML, with a comment above that says of which
// file it is a draft.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus::server {

/// A change of a draft: which tab of a browser made it, and as its how manyeth. As text `3f9a.12`.
struct Revision {
  std::string tab;
  std::uint64_t count = 0;
};
/// Nothing where the text is none.
[[nodiscard]] std::optional<Revision> revision_of(std::string_view text);
[[nodiscard]] std::string text_of(const Revision& revision);

struct Draft {
  std::string text;
  std::optional<std::string> saved;   // the checksum of the file that it began from; none: there was no file
  std::vector<Revision> revisions{};  // the last of each tab that it comes from; its own is the last; none: not known
};

/// Whether a revision that was made of `after` (none: of no draft) goes on from this draft, or from an older one of its
/// own tab: only then nothing is lost where it takes its place.
[[nodiscard]] bool goes_on_from(const Draft& there, const std::optional<Revision>& after, const Revision& next);
/// The revisions of a draft that takes the place of another one.
[[nodiscard]] std::vector<Revision> followed_by(std::vector<Revision> revisions, const Revision& next);

/// Nothing where there is none. `file` is the project's, here and below.
[[nodiscard]] std::optional<Draft> draft_of(const std::filesystem::path& file);
void keep_draft(const std::filesystem::path& file, const Draft& draft);
void remove_draft(const std::filesystem::path& file);

}  // namespace talus::server
