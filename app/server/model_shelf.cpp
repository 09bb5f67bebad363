#include "model_shelf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "file_state.hpp"
#include "http/answer.hpp"
#include "http/session.hpp"
#include "run_model.hpp"
#include "talus/files/checksum.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::server {

namespace fs = std::filesystem;

ModelShelf::Held ModelShelf::kept(const std::string& id) const {
  const std::lock_guard lock(shelf_);
  const auto found = std::find_if(models_.begin(), models_.end(), [&](const Held& held) { return held->id == id; });
  return found == models_.end() ? nullptr : *found;
}

ModelShelf::Held ModelShelf::build(const fs::path& file, std::string_view text) {
  project::Reading reading = project::read_project_text(text, file);
  std::string what = fmt::format("{}\n{}\n", file.string(), text), files;
  for (const project::NamedFile& named : reading.project.named_files) {
    const fs::path read = file.parent_path() / named.file;
    const std::optional<std::string> state = state_of_file(read);
    if (named.is_layer()) {  // drawn over the model: it is requested again if the id changes
      what += state.value_or("");
      continue;
    }
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
