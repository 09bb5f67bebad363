#include "project_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "draft.hpp"
#include "moves.hpp"
#include "run_folders.hpp"
#include "study_references.hpp"
#include "talus/files/json_file.hpp"
#include "talus/files/output_file.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

constexpr const char* deleted_folder = ".talus-deleted";
constexpr const char* record_name = "deleted.json";
constexpr const char* record_hint = "The files of the project may be intact";
constexpr const char* file_part = "project.toml";
constexpr const char* draft_part = "draft";
constexpr const char* runs_part = "runs";

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

/// The parts of a project in the folder that is served.
struct Parts {
  fs::path file, draft, runs;

  Parts(const Workplace& workplace, const std::string& name)
      : file(workplace.project(name)), draft(draft_place(file)), runs(workplace.at(runs_folder(name))) {}
  explicit Parts(const fs::path& deleted)
      : file(deleted / file_part), draft(deleted / draft_part), runs(deleted / runs_part) {}

  [[nodiscard]] bool is_project() const { return is_there(file) || is_there(draft); }
  void move_to(const Parts& to, Moves& moves) const {
    moves.move(runs, to.runs);
    moves.move(draft, to.draft);
    moves.move(file, to.file);
  }
};

/// Refuses a name without a project, and study files.
Parts project_of(const Workplace& workplace, const std::string& name) {
  Parts parts(workplace, name);
  if (name.ends_with(study_ending))
    throw Refusal(400, name, "is a study, not a project", "its name ends in .study.toml");
  if (!parts.is_project()) throw Refusal(404, name, "there is no such file");
  return parts;
}

/// Refuses a place that is taken. `name`: of the project to be there.
void check_free(const Parts& parts, const std::string& name) {
  if (parts.is_project()) throw Refusal(409, name, "already exists", "", "Choose another name");
  if (is_there(parts.runs))
    throw Refusal(409, name, "cannot have this name", "there are runs of an earlier project of that name",
                  "Choose another name");
}

std::string checked_name(const std::string& name) {
  if (fs::path(name).filename() != name)
    throw Refusal(400, name, "is not the name of a file",
                  "a project keeps its folder, which its files are relative to");
  if (fs::path(name).extension() != ".toml" || name.ends_with(study_ending))
    throw Refusal(400, name, "is not the name of a project", "it must end in .toml, and not in .study.toml");
  return name;
}

void write_text(const fs::path& path, const std::string& text) {
  OutputFile file(place_of_file(path));
  file.write(text);
  file.commit();
}

/// Writes the new texts, or none of them.
void write_references(const std::vector<StudyReference>& references) {
  std::size_t done = 0;
  try {
    for (; done < references.size(); ++done) write_text(references[done].file, references[done].renamed);
  } catch (const BadInput&) {
    while (done-- > 0) write_text(references[done].file, references[done].text);
    throw;
  }
}

}  // namespace

std::string ProjectFiles::rename(const std::string& file, const std::string& name) {
  const std::string to = (fs::path(file).parent_path() / checked_name(name)).generic_string();
  const std::lock_guard lock(project_writing());
  const Parts now = project_of(workplace_, file), next(workplace_, to);
  check_free(next, to);
  runs_.move_project(file, to, [&](const std::vector<fs::path>& calibrations) {
    const auto references = study_references(now.file.parent_path(), now.file.filename().string(), name, calibrations);
    write_references(references);
    try {
      Moves moves;
      now.move_to(next, moves);
      moves.keep();
    } catch (...) {
      for (const StudyReference& reference : references) write_text(reference.file, reference.text);
      throw;
    }
  });
  return to;
}

fs::path ProjectFiles::place_of_deleted(const std::string& id) const {
  return workplace_.folder() / deleted_folder / id;
}

DeletedProject ProjectFiles::deleted_of(const std::string& id) const {
  const fs::path file = place_of_deleted(id) / record_name;
  if (!is_there(file)) throw Refusal(404, id, "there is no such deleted project");
  const Json json = read_json_object<Json>(file, record_hint, 1u << 20u);
  const bool is_record = json.contains("file") && json["file"].is_string() && json.contains("deleted") &&
                         json["deleted"].is_string() && json.contains("runs") && json["runs"].is_number_unsigned();
  if (!is_record) refuse_json_file(file, "", "is damaged", "it is not the record of a deleted project", record_hint);
  return {.id = id, .file = json["file"], .when = json["deleted"], .runs = json["runs"]};
}

DeletedProject ProjectFiles::remove(const std::string& file) {
  const std::lock_guard lock(project_writing());
  const Parts parts = project_of(workplace_, file);
  const fs::path folder = new_folder(workplace_.folder() / deleted_folder);
  DeletedProject record{
      .id = folder.filename().string(), .file = fs::path(file).lexically_normal().generic_string(), .when = time_now()};
  try {
    runs_.remove_project(file, [&](std::size_t runs) {
      record.runs = runs;
      write_text(folder / record_name,
                 Json{{"file", record.file}, {"deleted", record.when}, {"runs", runs}}.dump(1) + "\n");
      Moves moves;
      parts.move_to(Parts(folder), moves);
      moves.keep();
    });
  } catch (...) {
    std::error_code ignored;
    fs::remove(folder / record_name, ignored);
    fs::remove(folder, ignored);  // only if it is empty
    throw;
  }
  return record;
}

std::vector<DeletedProject> ProjectFiles::deleted() const {
  std::vector<DeletedProject> found;
  std::error_code error;
  for (auto entry = fs::directory_iterator(workplace_.folder() / deleted_folder, error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    try {
      found.push_back(deleted_of(entry->path().filename().string()));
    } catch (const Refusal&) {  // it is being deleted, or has been erased in part
    } catch (const BadInput&) {
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.id > b.id; });
  return found;
}

std::string ProjectFiles::restore(const std::string& id) {
  const std::lock_guard lock(project_writing());
  const DeletedProject record = deleted_of(id);
  const Parts place(workplace_, record.file);
  check_free(place, record.file);
  Moves moves;
  Parts(place_of_deleted(id)).move_to(place, moves);
  moves.keep();
  std::error_code ignored;
  fs::remove_all(place_of_deleted(id), ignored);
  fs::remove(workplace_.folder() / deleted_folder, ignored);  // only if it is empty
  runs_.add_project(record.file);
  return record.file;
}

void ProjectFiles::erase(const std::string& id) {
  static_cast<void>(deleted_of(id));
  std::error_code error, ignored;
  fs::remove(place_of_deleted(id) / record_name, error);
  if (!error) fs::remove_all(place_of_deleted(id), error);
  if (error)
    throw BadInput(Problem{
        .file = place_of_deleted(id).string(), .what = "cannot remove all of this folder", .why = error.message()});
  fs::remove(workplace_.folder() / deleted_folder, ignored);
}

}  // namespace talus::server
