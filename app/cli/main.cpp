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

const CLI::Validator names_file = not_empty("\"\" is not a file name"),
                     names_folder = not_empty("\"\" is not a folder name"),
                     names_line = not_empty("\"\" is not a line, polygon or barrier"),
                     names_shard = not_empty("\"\" is not a shard; expected i/n with i from 1 to n, for example 2/7");

void add_project_options(CLI::App& command, ProjectOptions& options) {
  command.add_option("project", options.file, "The project file (TOML)")->required()->type_name("PROJECT.toml");
  command
      .add_option("--set", options.settings,
                  "Override a setting, for example --set analysis.gravity_m_s2=9.81; repeatable")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)  // otherwise it also consumes the project
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--rocks", options.rocks, "Total number of rocks, instead of the project's")
      ->transform(number_of_rocks())
      ->type_name("N");
  command.add_option("--seed", options.seed, "Seed of the random numbers, instead of the project's")
      ->transform(natural_number())
      ->type_name("S");
}

void add_maps_memory(CLI::App& command, std::uint64_t& bytes) {
  command
      .add_option("--maps-memory", bytes,
                  "Memory limit for maps, for example 4GB (default: half of the available memory)")
      ->transform(memory_size())
      ->type_name("SIZE");
}

/// One of a line, a barrier and a polygon. Returns their group.
CLI::Option_group& add_question(CLI::App& command, std::string& line, std::string& barrier, std::string& polygon) {
  auto* const asked = command.add_option_group("question", "What is asked");
  asked
      ->add_option("--line", line,
                   "Corners \"x,y x,y ...\" (2D: x), a table (.csv) with the columns x_m and y_m, or a GIS file with "
                   "one line")
      ->check(names_line)
      ->type_name("LINE");
  asked->add_option("--barrier", barrier, "A barrier or collector, by its name")->check(names_line)->type_name("NAME");
  asked->add_option("--polygon", polygon, "As --line: the corners of a polygon")
      ->check(names_line)
      ->type_name("POLYGON");
  asked->require_option(1);
  return *asked;
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Talus, a rockfall simulator: where do rocks go, how fast, how high, and which barrier stops them?",
               "talus"};
  app.set_version_flag("--version", std::string("talus ") + TALUS_VERSION);
  app.require_subcommand(1);
  std::string exits;
  for (const ExitMeaning& exit : exit_meanings)
    exits += fmt::format("{}{} {}", exits.empty() ? "" : ", ", static_cast<int>(exit.code), exit.meaning);
  app.footer("Exit codes: " + exits + ".\n`talus COMMAND --help` describes each command.");

  RunOptions run_options;
  CLI::App* run_command = app.add_subcommand("run", "Run a project, and write tables and a report");
  add_project_options(*run_command, run_options.project);
  run_command
      ->add_option("-o,--output", run_options.folder,
                   "Folder for the results (default: named after the project, next to its file)")
      ->check(names_folder)
      ->type_name("DIR");
  run_command
      ->add_option("--threads", run_options.threads,
                   "Number of threads per process (default: all cores, shared among the processes)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  run_command->add_flag("--quiet,-q", run_options.quiet, "Print only warnings and errors");
  run_command
      ->add_option("--shard", run_options.shard,
                   "Run only part i of n of the campaign (i from 1 to n); `talus merge` combines the parts")
      ->check(names_shard)
      ->type_name("i/n");
  run_command->add_flag("--resume", run_options.resume, "Continue from the last checkpoint in the folder");
  run_command
      ->add_option("--checkpoint-every", run_options.checkpoint_every,
                   "Time between checkpoints, from which --resume continues; 0: no checkpoints")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str()
      ->type_name("SECONDS");
  add_maps_memory(*run_command, run_options.maps_memory);
  run_command->add_flag("--alone", run_options.alone,
                        "Run all rocks in this process, even if mpirun or srun started several");

  ServeOptions serve_options;
  CLI::App* serve_command =
      app.add_subcommand("serve", "Start the workbench: build models, run them and explore results in the browser");
  serve_command
      ->add_option("project", serve_options.project,
                   "Project to open first, or working folder (default: the current folder)")
      ->check(names_file)
      ->type_name("PROJECT.toml");
  serve_command->add_option("--port", serve_options.port, "Port on this machine (0: any free port)")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str()
      ->type_name("N");
  serve_command->add_flag("--open", serve_options.open, "Also open the browser");

  MergeOptions merge_options;
  CLI::App* merge_command = app.add_subcommand("merge", "Merge the shards of a campaign into one result");
  merge_command
      ->add_option("folders", merge_options.folders,
                   "Folders of the shards, in any order, or one folder that contains all of them")
      ->required()
      ->check(names_folder)
      ->type_name("DIR");
  merge_command
      ->add_option("-o,--output", merge_options.folder,
                   "Folder for the results (default: DIR if only one is given, else named after the project)")
      ->check(names_folder)
      ->type_name("DIR");
  merge_command->add_flag("--partial", merge_options.partial,
                          "Merge although shards are missing; marks the result as interrupted");
  merge_command
      ->add_option("--threads", merge_options.threads, "Number of threads for writing maps (default: all cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  add_maps_memory(*merge_command, merge_options.maps_memory);
  merge_command->add_flag("--quiet,-q", merge_options.quiet, "Print only warnings and errors");

  CalibrateOptions calibrate_options;
  CLI::App* calibrate_command = app.add_subcommand(
      "calibrate", "Find the parameters that agree with observed rocks, and how well they are known");
  calibrate_command->add_option("study", calibrate_options.study, "The study file (TOML)")
      ->required()
      ->check(names_file)
      ->type_name("STUDY.toml");
  calibrate_command
      ->add_option("-o,--output", calibrate_options.folder,
                   "Folder for the results (default: named after the study, next to its file). Sets of parameters that "
                   "are finished there are not run again")
      ->check(names_folder)
      ->type_name("DIR");
  calibrate_command->add_option("--threads", calibrate_options.threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  calibrate_command->add_flag("--quiet,-q", calibrate_options.quiet, "Print only warnings and errors");

  ProjectOptions check_options;
  CLI::App* check_command = app.add_subcommand("check", "Report all problems of a project, with file, line and key");
  add_project_options(*check_command, check_options);

  ReplayOptions replay_options;
  CLI::App* replay_command = app.add_subcommand("replay", "Simulate one rock of a project again and print every event");
  add_project_options(*replay_command, replay_options.project);
  replay_command->add_option("--rock", replay_options.rock, "Number of the rock, as in endpoints.csv (zero-based)")
      ->transform(natural_number())
      ->required()
      ->type_name("N");
  replay_command->add_flag("--csv", replay_options.csv, "Print the rows of paths.csv instead of a table");

  LineOptions line_options;
  CLI::App* line_command =
      app.add_subcommand("line", "Ask a finished run what crosses a line, or enters a polygon, on plan");
  line_command->add_option("folder", line_options.folder, "Folder of the run, with its trajectories.bin")
      ->required()
      ->check(names_folder)
      ->type_name("DIR");
  add_question(*line_command, line_options.line, line_options.barrier, line_options.polygon)
      .add_option("--ditch", line_options.ditch,
                  "2D: the toe and the far edge of a ditch or bench: where do rocks strike it, which get beyond it?")
      ->expected(2)
      ->type_name("X");
  auto* const kit_height =
      line_command
          ->add_option("--height", line_options.height_m, "Nominal height of a kit on the line: what does it stop?")
          ->check(CLI::Range(1e-3, 1e3))
          ->type_name("M");
  auto* const kit_energy = line_command->add_option("--energy", line_options.energy_kJ, "Its maximum energy level")
                               ->check(CLI::Range(1e-3, 1e9))
                               ->type_name("KJ");
  kit_height->needs(kit_energy);
  kit_energy->needs(kit_height);
  line_command
      ->add_option("--section", line_options.section_m,
                   "Length of the stretches of the profile (default: section_m of [design], or about a twentieth)")
      ->check(CLI::Range(1e-3, 1e9))
      ->type_name("M");
  line_command
      ->add_option("--design", line_options.design,
                   "Override a key of [design], for example --design standard=none; repeatable")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  line_command
      ->add_option("--files", line_options.files, "Folder of the project's files (default: the folder that DIR is in)")
      ->check(names_folder)
      ->type_name("DIR");
  auto* const json_file = line_command->add_option("--json", line_options.json, "Also write everything as JSON")
                              ->check(names_file)
                              ->type_name("FILE");
  line_command->add_flag("--csv", line_options.csv, "Print the rows of design.csv instead of a table")
      ->excludes(json_file);

  SectionOptions section_options;
  CLI::App* section_command = app.add_subcommand("section", "Cut a section from a terrain along a line on plan");
  section_command->add_option("terrain", section_options.terrain, "A raster or mesh in metres, or a project in 3D")
      ->required()
      ->check(names_file)
      ->type_name("TERRAIN");
  section_command
      ->add_option("--line", section_options.line,
                   "Corners \"x,y x,y ...\", a table (.csv) with the columns x_m and y_m, or a GIS file with one line")
      ->required()
      ->check(names_line)
      ->type_name("LINE");
  section_command
      ->add_option("--tolerance", section_options.tolerance_m,
                   "Leave out vertices within this distance of the line through the others")
      ->check(CLI::Range(0.0, 1e6))
      ->type_name("M");
  section_command->add_option("--crs", section_options.crs, "Coordinate system of a file that names none, or \"local\"")
      ->type_name("CRS");
  section_command->add_option("-o,--output", section_options.file, "File for the table (default: standard output)")
      ->check(names_file)
      ->type_name("FILE.csv");

  WhatIfOptions what_if_options;
  CLI::App* what_if_command = app.add_subcommand(
      "what-if",
      "Compare what crosses a line, or enters a polygon, with other values of the project, for the same rocks");
  add_project_options(*what_if_command, what_if_options.project);
  add_question(*what_if_command, what_if_options.line, what_if_options.barrier, what_if_options.polygon);
  what_if_command
      ->add_option("--step", what_if_options.steps,
                   "A factor and its step, for example --step normal_restitution=10%; repeatable (default: those that "
                   "the project has of normal_restitution, tangential_restitution, friction_angle, dynamic_friction, "
                   "rolling_friction by 10 %, roughness, forest_drag, mass by 25 %)")
      ->type_name("FACTOR=PERCENT")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  what_if_command->add_option("--material", what_if_options.material, "Vary this material alone (default: all)")
      ->check(not_empty("\"\" is not a material"))
      ->type_name("NAME");
  what_if_command
      ->add_option("--within", what_if_options.within_s,
                   "Time for the runs: as many rocks as fit, a fair sample of the project's (default: all, at most "
                   "200,000)")
      ->check(CLI::Range(1.0, 1e6))
      ->type_name("SECONDS");
  what_if_command
      ->add_option("-o,--output", what_if_options.folder, "Folder for what_if.csv and what_if.json (default: none)")
      ->check(names_folder)
      ->type_name("DIR");
  what_if_command->add_option("--threads", what_if_options.threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  what_if_command->add_flag("--quiet,-q", what_if_options.quiet, "Print only the table, warnings and errors");

  ReportOptions report_options;
  CLI::App* report_command = app.add_subcommand("report", "Write report.html of a run again, or compare two runs");
  report_command->add_option("folders", report_options.folders, "Folder of one run, or of two to compare")
      ->required()
      ->expected(1, 2)
      ->check(names_folder)
      ->type_name("DIR [DIR2]");
  report_command
      ->add_option("-o,--output", report_options.file,
                   "Page to write (default: report.html, or compare.html for two runs, in the first folder)")
      ->check(names_file)
      ->type_name("FILE");
  report_command
      ->add_option("--observed", report_options.observed,
                   "Stops of rocks that were observed, laid over the simulated ones and compared with them: a table "
                   "(.csv) with columns x, y (2D: x), or a GIS file of points. A report that is written again without "
                   "it does not show them")
      ->check(names_file)
      ->type_name("FILE");
  report_command
      ->add_option("--pdf", report_options.pdf,
                   "Print the report to this PDF file with an installed Chromium or Chrome, instead of writing a page")
      ->check(names_file)
      ->type_name("FILE.pdf");
  report_command->add_option("--paper", report_options.paper, "Paper, instead of the project's")->type_name("A4|A3");
  report_command
      ->add_option("--units", report_options.units,
                   "Units of results, instead of the project's: metric, or US customary. Other files stay metric")
      ->type_name("metric|us");
  report_command
      ->add_option("--set", report_options.settings,
                   "Override a setting of [report], for example --set report.author=\"A. Meier\"; repeatable")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);

  ExportOptions export_options;
  CLI::App* export_command =
      app.add_subcommand("export", "Make the table paths.csv from the trajectories that a run has stored");
  export_command->add_option("folder", export_options.folder, "Folder of the run")
      ->required()
      ->check(names_folder)
      ->type_name("DIR");
  export_command
      ->add_option("--paths", export_options.paths, "The rocks: all in the store, or a number of them, evenly spread")
      ->default_val("all")
      ->type_name("all|N");
  export_command->add_option("-o,--output", export_options.file, "Table to write (default: standard output)")
      ->check(names_file)
      ->type_name("FILE");

  SensitivityOptions sensitivity_options;
  CLI::App* sensitivity_command =
      app.add_subcommand("sensitivity", "Find which inputs of a project its results depend on");
  sensitivity_command->add_option("study", sensitivity_options.study, "The study file (TOML)")
      ->required()
      ->check(names_file)
      ->type_name("STUDY.toml");
  sensitivity_command
      ->add_option("-o,--output", sensitivity_options.folder,
                   "Folder for the results (default: named after the study, next to its file)")
      ->check(names_folder)
      ->type_name("DIR");
  sensitivity_command->add_option("--threads", sensitivity_options.threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  sensitivity_command->add_flag("--quiet,-q", sensitivity_options.quiet, "Print only warnings and errors");

  VerifyOptions verify_options;
  CLI::App* verify_command =
      app.add_subcommand("verify", "Run the published verification cases and compare every number");
  verify_command->add_option("cases", verify_options.cases, "Case names, or the beginnings of names (default: all)")
      ->type_name("CASE");
  verify_command->add_option("--json", verify_options.json, "Also write the comparison as JSON")
      ->check(names_file)
      ->type_name("FILE");
  verify_command->add_option("--page", verify_options.page, "Also write the comparison as a Markdown page")
      ->check(names_file)
      ->type_name("FILE");
  verify_command
      ->add_option("--cases", verify_options.folder, "Folder of the cases (default: those built into the program)")
      ->check(names_folder)
      ->type_name("DIR");

  ValidateOptions validate_options;
  CLI::App* validate_command = app.add_subcommand(
      "validate", "Predict each half of a field experiment from the other half, and compare with what was observed");
  validate_command
      ->add_option("experiments", validate_options.experiments,
                   "Names of built-in experiments, or folders with an experiment.toml (default: all built-in ones)")
      ->type_name("EXPERIMENT");
  validate_command
      ->add_option("-o,--output", validate_options.folder,
                   "Folder for the results, one folder in it for each experiment (default: out/validation)")
      ->check(names_folder)
      ->type_name("DIR");
  validate_command
      ->add_option("--rocks", validate_options.rocks, "Rocks of each set of parameters, instead of the studies'")
      ->transform(number_of_rocks())
      ->type_name("N");
  validate_command->add_option("--draws", validate_options.draws, "Sets of parameters, instead of the studies'")
      ->check(CLI::Range(50, 1000000))
      ->type_name("N");
  validate_command->add_option("--threads", validate_options.threads, "Number of threads (default: all cores)")
      ->check(CLI::Range(1, 4096))
      ->type_name("N");
  validate_command->add_flag("--quiet,-q", validate_options.quiet, "Print only warnings and errors");

  CLI::App* materials_command =
      app.add_subcommand("materials", "List the library of ground materials, with their sources");

  CLI::App* schema_command = app.add_subcommand("schema", "Print the JSON Schema of the project file");

  NewOptions new_options;
  CLI::App* new_command = app.add_subcommand("new", "Write a project file to start from");
  new_command->add_option("file", new_options.file, "File to write")
      ->required()
      ->check(names_file)
      ->type_name("PROJECT.toml");
  new_command->add_flag("--force", new_options.force, "Overwrite an existing file");

  CLI::App* manual_command = app.add_subcommand("manual", "Print the manual page: talus manual | man -l -");

  std::string shell;
  CLI::App* completion_command = app.add_subcommand(
      "completion", "Print a script that completes commands and options in a shell: eval \"$(talus completion bash)\"");
  completion_command->add_option("shell", shell, "The shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("bash|zsh|fish");

  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  app.failure_message([&](const CLI::App*, const CLI::Error& error) { return message_about(app, error, words); });
  try {
    refuse_missing_values(words);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Not bad_input: the launcher would end the first process, possibly before it has printed the message.
    if (!reports_for_all(words)) return done;
    std::ostringstream out, message;
    const int code = app.exit(error, out, message);
    to_stderr(message.str());
    fmt::print("{}", out.str());
    return code == 0 ? done : bad_input;
  }
  if (*run_command) return run(run_options);
  if (*serve_command) return serve(serve_options);
  if (*merge_command) return merge(merge_options);
  if (*calibrate_command) return calibrate(calibrate_options);
  if (*check_command) return check(check_options);
  if (*replay_command) return replay(replay_options);
  if (*line_command) return line(line_options);
  if (*section_command) return section(section_options);
  if (*what_if_command) return what_if(what_if_options);
  if (*report_command) return report(report_options);
  if (*export_command) return export_paths(export_options);
  if (*sensitivity_command) return sensitivity(sensitivity_options);
  if (*verify_command) return verify(verify_options);
  if (*validate_command) return validate(validate_options);
  if (*materials_command) return materials();
  if (*schema_command) return schema();
  if (*manual_command) return manual(app);
  if (*completion_command) return completion(app, shell);
  return start_project(new_options);
}

}  // namespace
}  // namespace talus::cli

int main(int argc, char** argv) {
  using namespace talus::cli;
  make_streams_safe();
  return finish_output(answer([&] { return dispatch(argc, argv); }));
}
