#pragma once
// What the command line declares, as data: for the manual page and for the shells' completion.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace talus::cli {

/// What a shell can offer as a value.
enum class ValueKind { none, toml_file, file, folder, words };

struct DeclaredOption {
  std::vector<std::string> names;  // with their dashes, short ones first; empty: an argument
  std::string value;               // a word for it, as in the help, such as PROJECT.toml; empty: a flag
  ValueKind kind = ValueKind::none;
  std::vector<std::string> words;  // of ValueKind::words
  std::string description;         // with range and default
  bool is_required = false;
  bool is_repeatable = false;
};

struct DeclaredCommand {
  std::string name;  // empty: the program itself
  std::string description;
  std::vector<DeclaredOption> options, arguments;
};

/// The program itself, then its commands.
[[nodiscard]] std::vector<DeclaredCommand> declared_commands(const CLI::App& app);

}  // namespace talus::cli
