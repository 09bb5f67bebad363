// The command line: parses, dispatches, and turns failures into exit codes.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>
#include <string>

#include "answer.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "option_values.hpp"
#include "standard_streams.hpp"

namespace talus::cli {
namespace {

const CLI::Validator names_file = not_empty("\"\" is the name of no file"),
                     names_folder = not_empty("\"\" is the name of no folder"),
                     names_shard = not_empty("\"\" is not a shard; expected i/n with i from 1 to n, for example 2/7");

void add_project_options(CLI::App& command, ProjectOptions& options) {
  command.add_option("project", options.file, "The project file (TOML)")->required()->type_name("PROJECT.toml");
  command
      .add_option("--set", options.settings, "Set one value, for example --set analysis.gravity_m_s2=9.81; repeatable")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)  // or it takes the project, too
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--rocks", options.rocks, "Run this many rocks in all")
      ->transform(number_of_rocks())
      ->type_name("N");
  command.add_option("--seed", options.seed, "Start the random numbers elsewhere")
      ->transform(natural_number())
      ->type_name("S");
}

void add_maps_memory(CLI::App& command, std::uint64_t& bytes) {
  command
      .add_option("--maps-memory", bytes,
                  "Most memory that maps may take, for example 4GB (default: half of what there is)")
      ->transform(memory_size())
      ->type_name("SIZE");
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Talus: where do the rocks go, how fast, how high, with what energy, and what barrier stops them?",
               "talus"};
  app.set_version_flag("--version", std::string("talus ") + TALUS_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 a check failed, 2 bad input, 3 stopped by a signal (results so far kept), 4 internal "
      "error.\n"
      "`talus COMMAND --help` says more of each.");

  RunOptions run_options;
  CLI::App* run_command = app.add_subcommand("run", "Run a project, and write tables and a report");
  add_project_options(*run_command, run_options.project);
  run_command
      ->add_option("-o,--output", run_options.folder,
                   "Folder for the results (default: the project's name, beside its file)")
      ->check(names_folder)
      ->type_name("DIR");
  run_command
      ->add_option("--threads", run_options.threads,
                   "Threads to use, in each process of several (default: all cores, shared with the others)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  run_command->add_flag("--quiet,-q", run_options.quiet, "Print nothing but warnings and errors");
  run_command
      ->add_option("--shard", run_options.shard,
                   "Run one of n parts of the campaign, i from 1; `talus merge` puts the parts together")
      ->check(names_shard)
      ->type_name("i/n");
  run_command->add_flag("--resume", run_options.resume, "Go on from the last checkpoint in the folder");
  run_command
      ->add_option("--checkpoint-every", run_options.checkpoint_every,
                   "Keep what is done each time so many seconds have passed, to resume from; 0: never")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str()
      ->type_name("SECONDS");
  add_maps_memory(*run_command, run_options.maps_memory);
  run_command->add_flag("--alone", run_options.alone,
                        "Run all rocks in this process, even if mpirun or srun started others, too");

  ServeOptions serve_options;
  CLI::App* serve_command =
      app.add_subcommand("serve", "Open the workbench: build a model, run it and look at its rocks, in the browser");
  serve_command
      ->add_option("project", serve_options.project,
                   "The project to open first, or the folder to work in (default: this folder)")
      ->check(names_file)
      ->type_name("PROJECT.toml");
  serve_command->add_option("--port", serve_options.port, "Port on this machine (0: any that is free)")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str()
      ->type_name("N");
  serve_command->add_flag("--open", serve_options.open, "Open the browser, too");

  MergeOptions merge_options;
  CLI::App* merge_command = app.add_subcommand("merge", "Put the shards of a campaign together into one result");
  merge_command
      ->add_option("folders", merge_options.folders, "Folders of shards, in any order, or one that has them all")
      ->required()
      ->check(names_folder)
      ->type_name("DIR");
  merge_command
      ->add_option("-o,--output", merge_options.folder,
                   "Folder for the results (default: DIR if it is one; of several, the project's name)")
      ->check(names_folder)
      ->type_name("DIR");
  merge_command->add_flag("--partial", merge_options.partial, "Make do with what there is, marked as interrupted");
  merge_command->add_option("--threads", merge_options.threads, "Threads to write maps with (default: all cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  add_maps_memory(*merge_command, merge_options.maps_memory);
  merge_command->add_flag("--quiet,-q", merge_options.quiet, "Print nothing but warnings and errors");

  ProjectOptions check_options;
  CLI::App* check_command =
      app.add_subcommand("check", "Say all that is wrong with a project, with file, line and key");
  add_project_options(*check_command, check_options);

  ReplayOptions replay_options;
  CLI::App* replay_command = app.add_subcommand("replay", "Repeat one rock of a project, event by event");
  add_project_options(*replay_command, replay_options.project);
  replay_command->add_option("--rock", replay_options.rock, "The rock's number, as in endpoints.csv (from 0)")
      ->transform(natural_number())
      ->required()
      ->type_name("N");
  replay_command->add_flag("--csv", replay_options.csv, "Print the rows of paths.csv instead of a table");

  ReportOptions report_options;
  CLI::App* report_command =
      app.add_subcommand("report", "Make report.html of a run again, or lay two runs over each other");
  report_command->add_option("folders", report_options.folders, "One run's folder, or two")
      ->required()
      ->expected(1, 2)
      ->check(names_folder)
      ->type_name("DIR [DIR2]");
  report_command
      ->add_option("-o,--output", report_options.file,
                   "The page to write (default: report.html, or compare.html for two, in the first folder)")
      ->check(names_file)
      ->type_name("FILE");

  VerifyOptions verify_options;
  CLI::App* verify_command =
      app.add_subcommand("verify", "Run the published verification cases and compare every number");
  verify_command->add_option("cases", verify_options.cases, "Names of cases, or beginnings of names (default: all)")
      ->type_name("CASE");
  verify_command->add_option("--json", verify_options.json, "Write the comparison for machines, too")
      ->check(names_file)
      ->type_name("FILE");
  verify_command->add_option("--page", verify_options.page, "Write the comparison as a Markdown page, too")
      ->check(names_file)
      ->type_name("FILE");
  verify_command->add_option("--cases", verify_options.folder, "The folder that holds the cases")
      ->check(names_folder)
      ->type_name("DIR");

  CLI::App* materials_command =
      app.add_subcommand("materials", "List the usual grounds that a project can name, with their sources");

  CLI::App* schema_command = app.add_subcommand("schema", "Print the JSON Schema of the project file");

  NewOptions new_options;
  CLI::App* new_command = app.add_subcommand("new", "Write a project file to start from");
  new_command->add_option("file", new_options.file, "The file to write")
      ->required()
      ->check(names_file)
      ->type_name("PROJECT.toml");
  new_command->add_flag("--force", new_options.force, "Overwrite a file that is there");

  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  app.failure_message([&](const CLI::App*, const CLI::Error& error) { return message_about(app, error, words); });
  try {
    refuse_lacking_values(words);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // (One that failed without a word might be the first to end, and its launcher would end the one that speaks.)
    if (!answers_for_all(words)) return done;
    std::ostringstream out, message;
    const int code = app.exit(error, out, message);
    to_stderr(message.str());
    fmt::print("{}", out.str());
    return code == 0 ? done : bad_input;
  }
  if (*run_command) return run(run_options);
  if (*serve_command) return serve(serve_options);
  if (*merge_command) return merge(merge_options);
  if (*check_command) return check(check_options);
  if (*replay_command) return replay(replay_options);
  if (*report_command) return report(report_options);
  if (*verify_command) return verify(verify_options);
  if (*materials_command) return materials();
  if (*schema_command) return schema();
  return start_project(new_options);
}

}  // namespace
}  // namespace talus::cli

int main(int argc, char** argv) {
  using namespace talus::cli;
  make_streams_safe();
  return output_taken(answer([&] { return dispatch(argc, argv); }));
}
