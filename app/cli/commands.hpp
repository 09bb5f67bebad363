#pragma once
// The commands of the program, one a file.

#include <functional>

namespace CLI {
class App;
}

namespace talus::cli {

/// A command that a file has declared with its options. run() returns the exit code, and throws BadInput for bad input.
struct Command {
  CLI::App* declared;
  std::function<int()> run;  // once the command line is parsed
};

Command add_run(CLI::App& app);
Command add_serve(CLI::App& app);
Command add_merge(CLI::App& app);
Command add_calibrate(CLI::App& app);
Command add_check(CLI::App& app);
Command add_replay(CLI::App& app);
Command add_line(CLI::App& app);
Command add_section(CLI::App& app);
Command add_what_if(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_report(CLI::App& app);
Command add_export(CLI::App& app);
Command add_sensitivity(CLI::App& app);
Command add_verify(CLI::App& app);
Command add_validate(CLI::App& app);
Command add_materials(CLI::App& app);
Command add_schema(CLI::App& app);
Command add_new(CLI::App& app);
Command add_manual(CLI::App& app);
Command add_completion(CLI::App& app);

}  // namespace talus::cli
