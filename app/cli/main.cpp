// The command line: parses, dispatches, and turns failures into exit codes.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "answer.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "standard_streams.hpp"

namespace talus::cli {
namespace {

/// In the order of the help.
constexpr std::array commands{add_run,       add_serve,  add_merge,       add_calibrate, add_check,
                              add_replay,    add_line,   add_section,     add_what_if,   add_compare,
                              add_report,    add_export, add_sensitivity, add_verify,    add_validate,
                              add_materials, add_schema, add_new,         add_manual,    add_completion};

int dispatch(int argc, char** argv) {
  CLI::App app{"Talus, a rockfall simulator: where do rocks go, how fast, how high, and which barrier stops them?",
               "talus"};
  app.set_version_flag("--version", std::string("talus ") + TALUS_VERSION);
  app.require_subcommand(1);
  std::string exits;
  for (const ExitMeaning& exit : exit_meanings)
    exits += fmt::format("{}{} {}", exits.empty() ? "" : ", ", static_cast<int>(exit.code), exit.meaning);
  app.footer("Exit codes: " + exits + ".\n`talus COMMAND --help` describes each command.");

  std::vector<Command> declared;
  for (const auto add : commands) declared.push_back(add(app));

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
  const auto chosen = std::ranges::find_if(declared, [](const Command& command) { return command.declared->parsed(); });
  return chosen->run();
}

}  // namespace
}  // namespace talus::cli

int main(int argc, char** argv) {
  using namespace talus::cli;
  make_streams_safe();
  return finish_output(answer([&] { return dispatch(argc, argv); }));
}
