#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "draft.hpp"
#include "routes/routes.hpp"
#include "talus/core/utf8.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/output_file.hpp"
#include "talus/project/document.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

/// A page shows letters and writes UTF-8: it would change what it cannot read.
void check_letters(const std::string& name, std::string_view text) {
  const std::string read = as_utf8(text);
  if (read == text) return;
  const auto wrong = std::ranges::mismatch(text, read).in1;
  const auto line = static_cast<int>(1 + std::count(text.begin(), wrong, '\n'));
  throw Refusal(422, Problem{.file = name,
                             .line = line,
                             .what = "cannot be shown as text",
                             .why = "it has bytes that are not UTF-8, and saving it from here would lose them",
                             .hint = "Save it as UTF-8"});
}

/// Nothing where there is no such file; refused where it is not UTF-8.
std::optional<std::string> read(const fs::path& file, const std::string& name) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  std::string text = project::text_of_file(file);
  check_letters(name, text);
  return text;
}

/// Whole or not at all; a file that is there keeps who may read and write it.
void write(const fs::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  std::error_code ignored;
  if (const fs::file_status old = fs::status(path, ignored); fs::is_regular_file(old))
    fs::permissions(OutputFile::part_of(path), old.permissions() & fs::perms::all, ignored);
  file.commit();
}

std::optional<std::string> hash_of(const std::optional<std::string>& text) {
  if (!text) return std::nullopt;
  return text_of(checksum_of(*text));
}

Json text_or_null(const std::optional<std::string>& text) { return text ? Json(*text) : Json(); }

/// The hash of the file that the page read or wrote last; none: there was no file.
std::optional<std::string> saved_in(const Call& call) {
  std::string hash = call.text("saved", "");
  if (hash.empty()) return std::nullopt;
  return hash;
}

std::optional<Revision> revision_in(const Call& call, const char* key) {
  const std::string text = call.text(key, "");
  if (text.empty()) return std::nullopt;
  const auto revision = revision_of(text);
  if (!revision) throw Refusal(400, key, "is not a revision of a draft", "", "Such as 3f9a.12");
  return revision;
}

/// Whether what the request says of the draft may take the place of the one that is there. A script need not name its
/// revision.
bool may_replace(const std::optional<Draft>& there, const Call& call) {
  const auto next = revision_in(call, "revision"), after = revision_in(call, "after");
  return !there || !next || there->text == call.text("text", "") || goes_on_from(*there, after, *next);
}

Json as_json(const Draft& draft) {
  Json revisions = Json::array();
  for (const Revision& revision : draft.revisions) revisions.push_back(text_of(revision));
  return {{"text", draft.text}, {"saved", text_or_null(draft.saved)}, {"revisions", revisions}};
}

/// A page that was opened in another folder, which was served here before, would write into a project of that name.
void check_workplace(const Call& call, const Workplace& workplace) {
  if (const std::string meant = call.text("workplace", ""); !meant.empty() && meant != workplace.identity()) {
    throw Refusal(410, call.text("file"), "belongs to another folder",
                  fmt::format("the server works in {} by now", workplace.folder().string()),
                  "Serve the folder of the project on this port again, and this page goes on");
  }
}

}  // namespace

void add_project_routes(Router& router, const Workplace& workplace) {
  // Reading a file's hash and writing it are one step, for tabs that save at the same time.
  static std::mutex writing;

  router.get("/api/project", [&workplace](const Call& call) {
    const std::string name = call.query("file");
    const fs::path file = workplace.project(name);
    const auto text = read(file, name);
    const auto draft = draft_of(file);
    if (!text && !draft) throw Refusal(404, name, "there is no such file");
    const Json unsaved = draft && draft->text != text ? as_json(*draft) : Json();
    return json_answer(
        {{"file", name}, {"text", text.value_or("")}, {"saved", text_or_null(hash_of(text))}, {"draft", unsaved}});
  });
  router.put("/api/project", [&workplace](const Call& call) {
    call.only({"file", "text", "saved", "workplace", "revision", "after"});
    check_workplace(call, workplace);
    const std::string name = call.text("file"), text = call.text("text");
    const fs::path file = workplace.project(name);
    const std::lock_guard lock(writing);
    const auto there = hash_of(read(file, name));
    if (there != saved_in(call)) {
      throw Refusal(409, name, there ? "was changed by another program meanwhile" : "is no longer there", "",
                    "Read it again, or save under another name");
    }
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    write(workplace.written(file), text);
    if (may_replace(draft_of(file), call)) remove_draft(file);
    return json_answer({{"saved", text_of(checksum_of(text))}});
  });
  router.put("/api/draft", [&workplace](const Call& call) {
    call.only({"file", "text", "saved", "workplace", "revision", "after"});
    check_workplace(call, workplace);
    const std::string name = call.text("file");
    const fs::path file = workplace.project(name);
    const std::lock_guard lock(writing);
    const auto there = draft_of(file);
    if (!may_replace(there, call))
      throw Refusal(409, name, "has another draft", "it was changed in another tab or browser meanwhile");
    const bool is_given = call.body.contains("text") && !call.body["text"].is_null();
    if (is_given && call.text("text") != read(file, name)) {
      Draft draft{.text = call.text("text"), .saved = saved_in(call)};
      if (const auto next = revision_in(call, "revision"))
        draft.revisions = followed_by(there ? there->revisions : std::vector<Revision>(), *next);
      keep_draft(file, draft);
    } else {
      remove_draft(file);
    }
    return json_answer(Json::object());
  });
}

}  // namespace talus::server
