#include <fmt/format.h>

#include <fstream>
#include <mutex>
#include <optional>
#include <sstream>

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

void write(const fs::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

fs::path draft_of(const fs::path& file) { return file.parent_path() / ("." + file.filename().string() + ".draft"); }

Json hash_or_null(const std::optional<std::string>& text) {
  return text ? Json(io::text_of(io::checksum_of(*text))) : Json();
}

}  // namespace

void add_project_routes(Router& router, const Workplace& workplace) {
  // Reading a file's hash and writing it are one step, for tabs that save at the same time.
  static std::mutex writing;

  router.get("/api/project", [&workplace](const Call& call) {
    const std::string name = call.query("file");
    const fs::path file = workplace.project(name);
    const auto text = read(file);
    const auto draft = read(draft_of(file));
    if (!text && !draft) throw Refusal(404, name, "there is no such file");
    return json_answer({{"file", name},
                        {"text", text.value_or("")},
                        {"saved", hash_or_null(text)},
                        {"draft", draft && draft != text ? Json(*draft) : Json()}});
  });
  router.put("/api/project", [&workplace](const Call& call) {
    call.only({"file", "text", "saved"});
    const std::string name = call.text("file"), text = call.text("text"), saved = call.text("saved", "");
    const fs::path file = workplace.project(name);
    const std::lock_guard lock(writing);
    const Json there = hash_or_null(read(file));
    if (there != (saved.empty() ? Json() : Json(saved))) {
      throw Refusal(409, name, there.is_null() ? "is no longer there" : "was changed by another program meanwhile", "",
                    "Read it again, or save under another name");
    }
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    write(file, text);
    fs::remove(draft_of(file), ignored);
    return json_answer({{"saved", io::text_of(io::checksum_of(text))}});
  });
  router.put("/api/draft", [&workplace](const Call& call) {
    call.only({"file", "text"});
    const fs::path draft = draft_of(workplace.project(call.text("file")));
    const std::lock_guard lock(writing);
    std::error_code ignored;
    if (call.body.contains("text") && !call.body["text"].is_null()) {
      fs::create_directories(draft.parent_path(), ignored);
      write(draft, call.text("text"));
    } else {
      fs::remove(draft, ignored);
    }
    return json_answer(Json::object());
  });
}

}  // namespace talus::server
