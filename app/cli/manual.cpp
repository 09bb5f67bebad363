// `talus manual`: the manual page, in the language of man(7).

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "command_tree.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"

namespace talus::cli {

namespace {

/// Text as troff reads it; what stands between backquotes is bold.
std::string in_troff(const std::string& plain) {
  std::string text;
  bool is_bold = false;
  for (const char c : plain) {
    if (c == '\\')
      text += "\\e";
    else if (c == '-')
      text += "\\-";
    else if (c == '\'')
      text += "\\(aq";
    else if (c == '`')
      text += (is_bold = !is_bold) ? "\\fB" : "\\fP";
    else if (c == '\n')
      text += "\n.br\n";
    else
      text += c;
  }
  return text.starts_with('.') ? "\\&" + text : text;
}

std::string bold(const std::string& plain) { return "\\fB" + in_troff(plain) + "\\fP"; }
std::string italic(const std::string& plain) { return "\\fI" + in_troff(plain) + "\\fP"; }

std::string sentence(const std::string& plain) { return in_troff(plain) + (plain.ends_with('?') ? "" : "."); }

std::string head_of(const DeclaredOption& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back(bold(name));
  std::string head = fmt::format("{}", fmt::join(names, ", "));
  if (!option.value.empty()) head += (head.empty() ? "" : " ") + italic(option.value);
  return head;
}

void print_options(const std::vector<DeclaredOption>& options) {
  for (const DeclaredOption& option : options) {
    if (option.names.size() == 2 && option.names.back() == "--help") continue;
    const bool must_be_given = option.is_required && !option.names.empty();
    fmt::print(".TP\n{}\n{}\n", head_of(option), sentence(option.description + (must_be_given ? " (required)" : "")));
  }
}

std::string usage_of(const DeclaredCommand& command) {
  std::string usage = "talus " + command.name;
  if (command.options.size() > 1) usage += " [OPTIONS]";  // more than --help
  for (const DeclaredOption& argument : command.arguments) {
    const std::string value = argument.value + (argument.is_repeatable && !argument.value.ends_with(']') ? " ..." : "");
    usage += argument.is_required ? " " + value : " [" + value + "]";
  }
  return usage;
}

int manual(const CLI::App& app) {
  const std::vector<DeclaredCommand> commands = declared_commands(app);
  fmt::print(
      ".TH TALUS 1 \"\" \"talus {0}\" \"User Commands\"\n"
      ".SH NAME\ntalus \\- rockfall simulator\n"
      ".SH SYNOPSIS\n.B talus\n.I COMMAND\n.RI [ OPTIONS ]\n.I ARGUMENTS\n"
      ".SH DESCRIPTION\n{1}\n.PP\n"
      "A project is one TOML file, which describes the slope, its materials, where rocks start, and the barriers.\n",
      TALUS_VERSION, in_troff(commands.front().description));
  fmt::print(".SH OPTIONS\n");
  print_options(commands.front().options);
  fmt::print(".SH COMMANDS\n");
  for (const DeclaredCommand& command : commands) {
    if (command.name.empty()) continue;
    fmt::print(".SS {}\n{}\n", in_troff(usage_of(command)), sentence(command.description));
    print_options(command.arguments);
    print_options(command.options);
  }
  fmt::print(".SH EXIT STATUS\n");
  for (const ExitMeaning& exit : exit_meanings)
    fmt::print(".TP\n.B {}\n{}\n", static_cast<int>(exit.code), sentence(exit.meaning));
  fmt::print(
      ".SH EXAMPLES\nA first project, its results, and the workbench:\n.PP\n.nf\n.RS\n"
      "talus new slope.toml\ntalus run slope.toml \\-o out\ntalus serve \\-\\-open slope.toml\n.RE\n.fi\n");
  return done;
}

}  // namespace

Command add_manual(CLI::App& app) {
  return {app.add_subcommand("manual", "Print the manual page: talus manual | man -l -"),
          [&app] { return manual(app); }};
}

}  // namespace talus::cli
