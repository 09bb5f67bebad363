#include <fmt/format.h>

#include <mutex>
#include <optional>

#include "draft.hpp"
#include "routes/routes.hpp"
#include "talus/io/checksum.hpp"
#include "talus/io/output_file.hpp"
#include "talus/project/document.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

/// Nothing where there is no such file.
std::optional<std::string> read(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  return project::text_of_file(file);
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
  return io::text_of(io::checksum_of(*text));
}

Json text_or_null(const std::optional<std::string>& text) { return text ? Json(*text) : Json(); }

/// The hash of the file that the page read or wrote last; none: there was no file.
std::optional<std::string> saved_in(const Call& call) {
  std::string hash = call.text("saved", "");
  if (hash.empty()) return std::nullopt;
  return hash;
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
    const auto text = read(file);
    const auto draft = draft_of(file);
    if (!text && !draft) throw Refusal(404, name, "there is no such file");
    Json unsaved;
    if (draft && draft->text != text) unsaved = {{"text", draft->text}, {"saved", text_or_null(draft->saved)}};
    return json_answer(
        {{"file", name}, {"text", text.value_or("")}, {"saved", text_or_null(hash_of(text))}, {"draft", unsaved}});
  });
  router.put("/api/project", [&workplace](const Call& call) {
    call.only({"file", "text", "saved", "workplace"});
    check_workplace(call, workplace);
    const std::string name = call.text("file"), text = call.text("text");
    const fs::path file = workplace.project(name);
    const std::lock_guard lock(writing);
    const auto there = hash_of(read(file));
    if (there != saved_in(call)) {
      throw Refusal(409, name, there ? "was changed by another program meanwhile" : "is no longer there", "",
                    "Read it again, or save under another name");
    }
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    write(workplace.written(file), text);
    remove_draft(file);
    return json_answer({{"saved", io::text_of(io::checksum_of(text))}});
  });
  router.put("/api/draft", [&workplace](const Call& call) {
    call.only({"file", "text", "saved", "workplace"});
    check_workplace(call, workplace);
    const fs::path file = workplace.project(call.text("file"));
    const std::lock_guard lock(writing);
    const bool is_given = call.body.contains("text") && !call.body["text"].is_null();
    if (is_given && call.text("text") != read(file))
      keep_draft(file, {.text = call.text("text"), .saved = saved_in(call)});
    else
      remove_draft(file);
    return json_answer(Json::object());
  });
}

}  // namespace talus::server
