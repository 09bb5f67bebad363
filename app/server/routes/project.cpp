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

/// Refuses text that is not UTF-8: a page would change it when saving.
void check_utf8(const std::string& name, std::string_view text) {
  const std::string read = as_utf8(text);
  if (read == text) return;
  const auto wrong = std::ranges::mismatch(text, read).in1;
  const auto line = static_cast<int>(1 + std::count(text.begin(), wrong, '\n'));
  throw Refusal(422, Problem{.file = name,
                             .line = line,
                             .what = "cannot be shown as text",
                             .why = "it has bytes that are not UTF-8, which saving it here would lose",
                             .hint = "Save it as UTF-8"});
}

/// nullopt if the file does not exist. Refuses text that is not UTF-8.
std::optional<std::string> read(const fs::path& file, const std::string& name) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  std::string text = project::text_of_file(file);
  check_utf8(name, text);
  return text;
}

/// Writes the file atomically. An existing file keeps its permissions.
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

/// The hash of the file as the page last read or wrote it; nullopt: there was no file.
std::optional<std::string> saved_in(const Call& call) {
  std::string hash = call.text("saved", "");
  if (hash.empty()) return std::nullopt;
  return hash;
}

std::optional<Revision> revision_in(const Call& call, const char* key) {
  const std::string text = call.text(key, "");
  if (text.empty()) return std::nullopt;
  const auto revision = revision_of(text);
  if (!revision) throw Refusal(400, key, "is not a revision of a draft", "expected for example 3f9a.12");
  return revision;
}

/// Whether the request may replace the current draft. Scripts need not give a revision.
bool may_replace(const std::optional<Draft>& draft, const Call& call) {
  const auto next = revision_in(call, "revision"), after = revision_in(call, "after");
  return !draft || !next || draft->text == call.text("text", "") || continues(*draft, after, *next);
}

Json draft_json(const Draft& draft) {
  Json revisions = Json::array();
  for (const Revision& revision : draft.revisions) revisions.push_back(text_of(revision));
  return {{"text", draft.text}, {"saved", text_or_null(draft.saved)}, {"revisions", revisions}};
}

/// Refuses (410) a page opened when this port served another folder: it would write into a project of the same name.
void check_workplace(const Call& call, const Workplace& workplace) {
  if (const std::string meant = call.text("workplace", ""); !meant.empty() && meant != workplace.identity()) {
    throw Refusal(410, call.text("file"), "belongs to another folder",
                  fmt::format("the server now works in {}", workplace.folder().string()),
                  "To continue on this page, serve the project's folder on this port again");
  }
}

}  // namespace

void add_project_routes(Router& router, const Workplace& workplace) {
  router.get("/api/project", [&workplace](const Call& call) {
    const std::string name = call.query("file");
    const fs::path file = workplace.project(name);
    const auto text = read(file, name);
    const auto draft = draft_of(file);
    if (!text && !draft) throw Refusal(404, name, "there is no such file");
    const Json unsaved = draft && draft->text != text ? draft_json(*draft) : Json();
    return json_answer(
        {{"file", name}, {"text", text.value_or("")}, {"saved", text_or_null(hash_of(text))}, {"draft", unsaved}});
  });
  router.put("/api/project", [&workplace](const Call& call) {
    call.only({"file", "text", "saved", "workplace", "revision", "after"});
    check_workplace(call, workplace);
    const std::string name = call.text("file"), text = call.text("text");
    const fs::path file = workplace.project(name);
    const std::lock_guard lock(project_writing());
    const auto current = hash_of(read(file, name));
    if (current != saved_in(call)) {
      throw Refusal(409, name, current ? "was changed by another program meanwhile" : "no longer exists", "",
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
    const std::lock_guard lock(project_writing());
    const auto current = draft_of(file);
    if (!may_replace(current, call))
      throw Refusal(409, name, "has another draft", "it was changed in another tab or browser meanwhile");
    const bool is_given = call.body.contains("text") && !call.body["text"].is_null();
    if (is_given && call.text("text") != read(file, name)) {
      Draft draft{.text = call.text("text"), .saved = saved_in(call)};
      if (const auto next = revision_in(call, "revision"))
        draft.revisions = with_revision(current ? current->revisions : std::vector<Revision>(), *next);
      save_draft(file, draft);
    } else {
      remove_draft(file);
    }
    return json_answer(Json::object());
  });
}

}  // namespace talus::server
