#include "model_shelf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "http/answer.hpp"
#include "http/session.hpp"
#include "run_model.hpp"
#include "talus/files/checksum.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

/// All files that the project of a model names.
std::vector<fs::path> files_of(const project::Project& project) {
  std::vector<fs::path> files;
  for (const project::NamedFile& named : project.named_files) files.push_back(named.file);
  return files;
}

/// A text that changes when the file, or one that belongs to it (slope.prj, slope.tif.aux.xml), is written again.
/// nullopt if changes cannot be detected: the file may refer to others.
std::optional<std::string> state_of(const fs::path& file) {
  std::error_code error;
  const std::string name = file.string();
  if (!fs::is_regular_file(file, error) || name.starts_with("/vsi") || file.extension() == ".vrt") return std::nullopt;
  const std::string stem = file.stem().string() + '.';
  std::vector<std::string> states;
  for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path(), error)) {
    const std::string sibling = entry.path().filename().string();
    if (!sibling.starts_with(stem)) continue;
    std::error_code ignored;
    states.push_back(fmt::format("{} {} {}", sibling, entry.file_size(ignored),
                                 entry.last_write_time(ignored).time_since_epoch().count()));
  }
  if (error) return std::nullopt;
  std::sort(states.begin(), states.end());
  return fmt::format("{}\n{}\n", name, fmt::join(states, "\n"));
}

}  // namespace

ModelShelf::Held ModelShelf::kept(const std::string& id) const {
  const std::lock_guard lock(shelf_);
  const auto found = std::find_if(models_.begin(), models_.end(), [&](const Held& held) { return held->id == id; });
  return found == models_.end() ? nullptr : *found;
}

ModelShelf::Held ModelShelf::build(const fs::path& file, std::string_view text) {
  project::Reading reading = project::read_project_text(text, file);
  std::string what = fmt::format("{}\n{}\n", file.string(), text), files;
  for (const fs::path& named : files_of(reading.project)) {
    const fs::path read = file.parent_path() / named;
    const std::optional<std::string> state = state_of(read);
    what += state ? *state : fmt::format("unknown {}\n", random_hex(16));
    files += state.value_or(read.string() + '\n');
  }
  std::string id = text_of(checksum_of(what));

  Held held = kept(id);
  if (!held) {
    held = reading_.read<ShelvedModel>(
        id, [id, files_id = text_of(checksum_of(files)), reading = std::move(reading)]() mutable {
          ShelvedModel built{.id = id, .files = files_id};
          built.model = project::build_model(reading.project, reading.warnings);
          built.bytes = bytes_of(built.model);
          built.project = std::move(reading.project);
          built.warnings = std::move(reading.warnings);
          return built;
        });
  }
  const std::lock_guard lock(shelf_);
  std::erase(models_, held);
  models_.push_front(held);
  models_.resize(std::min(most_kept, count_within(models_, most_bytes_)));
  return held;
}

ModelShelf::Held ModelShelf::find(const std::string& id) const {
  if (Held held = kept(id)) return held;
  throw Refusal(404, id, "there is no such model", "only the last few are kept", "Post the project again");
}

}  // namespace talus::server
