#include "run_folders.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <set>
#include <thread>

#include "talus/files/output_file.hpp"
#include "workplace.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

/// Only names that need no escaping in a URL.
bool can_be_id(const std::string& name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_' || c == '.'; });
}

std::vector<fs::path> folders_in(const fs::path& parent) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (auto entry = fs::directory_iterator(parent, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && !entry->is_symlink(ignored)) folders.push_back(entry->path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

bool has_run_file(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / run_file_name, ignored);
}

/// The list of project files leaves out the same folders.
bool may_contain_projects(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return !name.starts_with('.') && name != "node_modules" && !has_run_file(folder);
}

/// The folders of runs in the folder of a project's runs.
void add_run_folders_in(std::vector<fs::path>& found, const fs::path& project) {
  for (const fs::path& run : folders_in(project))
    if (has_run_file(run) && can_be_id(run.filename().string())) found.push_back(run);
}

/// The folders DIR/runs/PROJECT/ID of runs below `parent`.
void add_run_folders(std::vector<fs::path>& found, const fs::path& parent, int depth) {
  for (const fs::path& folder : folders_in(parent)) {
    if (!may_contain_projects(folder)) continue;
    if (folder.filename() == "runs") {
      for (const fs::path& project : folders_in(folder)) add_run_folders_in(found, project);
    }
    if (depth < deepest_project) add_run_folders(found, folder, depth + 1);
  }
}

BadInput cannot_remove(const Run& run, const char* what, const std::error_code& error) {
  return BadInput(Problem{.file = run.folder.string(), .what = what, .why = error.message()});
}

}  // namespace

fs::path new_folder(const fs::path& parent) {
  make_output_folder(parent);
  for (;;) {
    const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
    const auto part = now.time_since_epoch().count() % 1000;
    fs::path folder =
        parent / fmt::format("{:%Y%m%d-%H%M%S}-{:03}", fmt::gmtime(std::chrono::system_clock::to_time_t(now)), part);
    std::error_code error;
    if (fs::create_directory(folder, error)) return folder;
    if (error)
      throw BadInput(Problem{.file = folder.string(), .what = "cannot create this folder", .why = error.message()});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::vector<Run> find_runs(const fs::path& base) {
  std::vector<fs::path> folders;
  add_run_folders(folders, base, 0);
  std::vector<Run> runs;
  std::set<std::string> ids;
  for (const fs::path& folder : folders) {
    Run run = read_run(folder, base);
    // A copied folder has the id of the original.
    const std::string id = run.id;
    for (int k = 2; !ids.insert(run.id).second; ++k) run.id = fmt::format("{}-{}", id, k);
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<Run> find_runs_in(const fs::path& folder, const fs::path& base) {
  std::vector<fs::path> folders;
  add_run_folders_in(folders, folder);
  std::vector<Run> runs;
  for (const fs::path& run : folders) runs.push_back(read_run(run, base));
  return runs;
}

void create_run_folder(Run& run, const fs::path& parent, const std::string& project, const std::string& study) {
  run.folder = new_folder(parent);
  run.id = run.folder.filename().string();
  const auto write = [&](const char* name, const std::string& text) {
    OutputFile file(run.folder / name);
    file.write(text);
    file.commit();
  };
  write(run_project_name, project);
  if (run.kind == RunKind::calibration) write(run_study_name, study);
  save(run);
}

void remove_run_file(const Run& run) {
  std::error_code error;
  fs::remove(run.folder / run_file_name, error);
  if (error) throw cannot_remove(run, "cannot remove this folder", error);
}

void remove_run_folder(const Run& run) {
  std::error_code error;
  fs::remove_all(run.folder, error);
  if (error) throw cannot_remove(run, "cannot remove all of this folder", error);
  std::error_code ignored;
  for (const fs::path& above : {run.folder.parent_path(), run.folder.parent_path().parent_path()})
    fs::remove(above, ignored);  // only succeeds for an empty folder
}

}  // namespace talus::server
