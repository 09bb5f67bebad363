#include <fmt/format.h>

#include <memory>

#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "talus/campaign/campaign.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/layers/check_layers.hpp"
#include "talus/model/check_releases.hpp"

namespace talus::cli {

namespace {

int check(const ProjectOptions& options) {
  take_available_threads();
  Loaded loaded = load(options);
  project::warn_of_buried_releases(loaded.model, loaded.warnings);
  project::check_layers(loaded.project, loaded.model, loaded.warnings);
  print_warnings(loaded.warnings);
  if (!loaded.model.terrain_report.empty()) fmt::print("{}\n", loaded.model.terrain_report);
  if (!loaded.model.seeder_report.empty()) fmt::print("{}\n", loaded.model.seeder_report);
  print_if_large(loaded, {0, loaded.model.rocks()}, threads_for(0));
  fmt::print("{}: no errors; {} rocks from {} {}\n", options.file.string(), loaded.model.rocks(),
             loaded.model.seeders.size(), loaded.model.seeders.size() == 1 ? "seeder" : "seeders");
  return done;
}

}  // namespace

Command add_check(CLI::App& app) {
  const auto options = std::make_shared<ProjectOptions>();
  CLI::App* command = app.add_subcommand("check", "Report all problems of a project, with file, line and key");
  add_project(*command, *options);
  return {command, [options] { return check(*options); }};
}

}  // namespace talus::cli
