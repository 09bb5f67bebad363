#include "load.hpp"

#include "standard_streams.hpp"
#include "talus/project/model.hpp"
#include "talus/project/read.hpp"

namespace talus::cli {

Loaded load(const ProjectOptions& options) {
  project::Reading reading = project::read_project(options.file, {options.settings, options.rocks, options.seed});
  Loaded loaded{std::move(reading.project), {}, std::move(reading.warnings)};
  loaded.model = project::build_model(loaded.project, loaded.warnings);
  return loaded;
}

void print_warnings(const Problems& warnings) {
  if (!warnings.list().empty()) tell("{}\n", warnings.text());
}

}  // namespace talus::cli
