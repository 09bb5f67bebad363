#include "load.hpp"

#include <fmt/format.h>

#include "standard_streams.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/run/run_results.hpp"
#include "talus/run/run_size.hpp"

namespace talus::cli {

Loaded load(const ProjectOptions& options) {
  project::Reading reading = project::read_project(options.file, {options.settings, options.rocks, options.seed});
  Loaded loaded{std::move(reading.project), {}, std::move(reading.warnings)};
  loaded.model = project::build_model(loaded.project, loaded.warnings);
  return loaded;
}

void print_if_large(const Loaded& loaded, const RockRange& rocks, int threads, const std::atomic<bool>* stop) {
  const project::RunSize size = project::expected_size(loaded.project, loaded.model, rocks, stop);
  if (const auto text = project::large_run_text(size, threads)) fmt::print("{}\n", *text);
}

void print_warnings(const Problems& warnings) {
  if (!warnings.list().empty()) to_stderr("{}\n", warnings.text());
}

}  // namespace talus::cli
