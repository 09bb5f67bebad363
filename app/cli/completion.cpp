// `talus completion SHELL`: what a shell runs to complete the commands, options and values of this program.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include <CLI/CLI.hpp>

#include "command_options.hpp"
#include "command_tree.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"

namespace talus::cli {

namespace {

/// The first clause of a description, on one line.
std::string clause_of(const std::string& description) {
  std::size_t end = description.size();
  for (const std::string_view mark : {". ", "; ", ": ", " (", ", for example", "\n"})
    end = std::min(end, description.find(mark));
  return description.substr(0, end);
}

/// `text` with a backslash before each of `characters`.
std::string escaped(const std::string& text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::vector<std::string> names_of(const std::vector<DeclaredOption>& options) {
  std::vector<std::string> names;
  for (const DeclaredOption& option : options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

// --- bash

/// What _talus offers: the name of one of its cases, or the words.
std::string offer_in_bash(const DeclaredOption& option) {
  switch (option.kind) {
    case ValueKind::toml_file:
      return "TOML";
    case ValueKind::file:
      return "FILE";
    case ValueKind::folder:
      return "DIR";
    case ValueKind::words:
      return fmt::format("{}", fmt::join(option.words, " "));
    case ValueKind::none:
      break;
  }
  return "";
}

void print_bash(const std::vector<DeclaredCommand>& commands) {
  std::vector<std::string> names;
  for (const DeclaredCommand& command : commands) names.push_back(command.name);
  fmt::print(R"(_talus() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= options= offer= k
  # --option=value comes as three words.
  if [[ $word == = ]]; then word=
  elif [[ $before == = ]]; then before=${{COMP_WORDS[COMP_CWORD-2]}}; fi
  for ((k = 1; k < COMP_CWORD; ++k)); do
    [[ ${{COMP_WORDS[k]}} == -* ]] || {{ command=${{COMP_WORDS[k]}}; break; }}
  done
  case $command in
)");
  for (const DeclaredCommand& command : commands) {
    const std::string offer = command.name.empty()        ? fmt::format("{}", fmt::join(names, " ")).substr(1)
                              : command.arguments.empty() ? ""
                                                          : offer_in_bash(command.arguments.front());
    fmt::print("    {}) options='{}' offer='{}' ;;\n", command.name.empty() ? "''" : command.name,
               fmt::join(names_of(command.options), " "), offer);
  }
  fmt::print("  esac\n  case \"$command $before\" in\n");
  for (const DeclaredCommand& command : commands) {
    for (const DeclaredOption& option : command.options) {
      if (option.value.empty()) continue;
      std::vector<std::string> cases;
      for (const std::string& name : option.names) cases.push_back(fmt::format("'{} {}'", command.name, name));
      fmt::print("    {}) options= offer='{}' ;;\n", fmt::join(cases, "|"), offer_in_bash(option));
    }
  }
  fmt::print(R"(  esac
  [[ $word == -* ]] && offer=$options
  COMPREPLY=()
  case $offer in
    TOML|FILE|DIR)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(
        compgen -d -- "$word"
        case $offer in
          TOML) compgen -f -X '!*.toml' -- "$word" ;;
          FILE) compgen -f -- "$word" | while IFS= read -r k; do [[ -d $k ]] || printf '%s\n' "$k"; done ;;
        esac) ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$offer" -- "$word") ;;
  esac
}}
complete -F _talus talus
)");
}

// --- zsh

std::string in_brackets(const std::string& text) { return escaped(text, "[]:\\"); }

/// ":what it is:how to complete it", or empty for a flag.
std::string value_in_zsh(const DeclaredOption& option) {
  if (option.value.empty()) return "";
  const std::string name = ":" + in_brackets(option.value) + ":";
  switch (option.kind) {
    case ValueKind::toml_file:
      return name + "_files -g \"*.toml(-.)\"";
    case ValueKind::file:
      return name + "_files";
    case ValueKind::folder:
      return name + "_files -/";
    case ValueKind::words:
      return fmt::format("{}({})", name, fmt::join(option.words, " "));
    case ValueKind::none:
      break;
  }
  return name;
}

/// A word of the shell, in single quotes.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

void print_arguments_in_zsh(const DeclaredCommand& command) {
  for (const DeclaredOption& option : command.options) {
    const std::string rest = fmt::format("[{}]{}", in_brackets(clause_of(option.description)), value_in_zsh(option));
    const std::string others = fmt::format("({})", fmt::join(option.names, " "));
    for (const std::string& name : option.names)
      fmt::print(" \\\n        {}", quoted((option.is_repeatable ? "*" : others) + name + rest));
  }
  for (const DeclaredOption& argument : command.arguments)
    fmt::print(" \\\n        {}", quoted((argument.is_repeatable ? "*" : "") + value_in_zsh(argument)));
}

void print_zsh(const std::vector<DeclaredCommand>& commands) {
  fmt::print("#compdef talus\n\n_talus() {{\n  local state\n  _arguments -C");
  print_arguments_in_zsh(commands.front());
  fmt::print(
      " \\\n        '1:command:->command' '*::argument:->argument'\n  case $state in\n    command)\n"
      "      local -a commands=(");
  for (const DeclaredCommand& command : commands) {
    if (!command.name.empty())
      fmt::print("\n        {}", quoted(command.name + ":" + escaped(clause_of(command.description), ":\\")));
  }
  fmt::print(")\n      _describe command commands ;;\n    argument) case $words[1] in\n");
  for (const DeclaredCommand& command : commands) {
    if (command.name.empty()) continue;
    fmt::print("      {}) _arguments", command.name);
    print_arguments_in_zsh(command);
    fmt::print(" ;;\n");
  }
  fmt::print(
      "    esac ;;\n  esac\n}}\n\n"
      "if [ \"$funcstack[1]\" = _talus ]; then _talus \"$@\"; else compdef _talus talus; fi\n");
}

// --- fish

std::string value_in_fish(const DeclaredOption& option) {
  switch (option.kind) {
    case ValueKind::toml_file:
      return " -x -k -a '(__fish_complete_suffix .toml)'";
    case ValueKind::file:
      return " -r -F";
    case ValueKind::folder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::words:
      return fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
    case ValueKind::none:
      break;
  }
  return option.value.empty() ? "" : " -x";
}

std::string described_in_fish(const std::string& description) {
  return fmt::format(" -d '{}'", escaped(clause_of(description), "'\\"));
}

void print_fish(const std::vector<DeclaredCommand>& commands) {
  fmt::print("complete -c talus -f\n");
  for (const DeclaredCommand& command : commands) {
    const bool is_program = command.name.empty();
    const std::string when = is_program ? "__fish_use_subcommand" : "__fish_seen_subcommand_from " + command.name;
    if (!is_program)
      fmt::print("complete -c talus -n __fish_use_subcommand -a {}{}\n", command.name,
                 described_in_fish(command.description));
    for (const DeclaredOption& option : command.options) {
      fmt::print("complete -c talus -n '{}'", when);
      for (const std::string& name : option.names)
        fmt::print(" {} {}", name.starts_with("--") ? "-l" : "-s", name.substr(name.find_first_not_of('-')));
      fmt::print("{}{}\n", value_in_fish(option), described_in_fish(option.description));
    }
    for (const DeclaredOption& argument : command.arguments) {
      if (argument.kind != ValueKind::none) fmt::print("complete -c talus -n '{}'{}\n", when, value_in_fish(argument));
    }
  }
}

int completion(const CLI::App& app, const std::string& shell) {
  const std::vector<DeclaredCommand> commands = declared_commands(app);
  if (shell == "bash")
    print_bash(commands);
  else if (shell == "zsh")
    print_zsh(commands);
  else
    print_fish(commands);
  return done;
}

}  // namespace

Command add_completion(CLI::App& app) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "completion", "Print a script that completes commands and options in a shell: eval \"$(talus completion bash)\"");
  command->add_option("shell", *shell, "The shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("bash|zsh|fish");
  return {command, [&app, shell] { return completion(app, *shell); }};
}

}  // namespace talus::cli
