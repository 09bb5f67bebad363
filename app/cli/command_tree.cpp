#include "command_tree.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>

namespace talus::cli {

namespace {

const auto any_option = [](const CLI::Option*) { return true; };
const auto any_command = [](const CLI::App*) { return true; };

/// Parts of "all|N" that are words to type, not placeholders.
std::vector<std::string> words_of(const std::string& value) {
  std::vector<std::string> words;
  std::istringstream parts(value);
  for (std::string part; std::getline(parts, part, '|');) {
    if (part != "N") words.push_back(part);
  }
  return words;
}

ValueKind kind_of(const std::string& value) {
  if (value.find('|') != std::string::npos) return ValueKind::words;
  if (value.ends_with(".toml")) return ValueKind::toml_file;
  if (value.starts_with("FILE") || value == "LINE" || value == "POLYGON") return ValueKind::file;
  if (value.starts_with("DIR") || value == "EXPERIMENT") return ValueKind::folder;
  return ValueKind::none;
}

DeclaredOption declared(const CLI::Option& option) {
  DeclaredOption result;
  for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  result.description = option.get_description();
  result.is_required = option.get_required();
  if (option.get_items_expected_max() == 0) return result;
  // CLI11 appends what the validators say: "N:INT in [1 - 4096]".
  const std::string type = option.get_type_name();
  result.value = type.substr(0, type.find(':'));
  result.kind = kind_of(result.value);
  if (result.kind == ValueKind::words) result.words = words_of(result.value);
  result.is_repeatable = option.get_items_expected_max() >= CLI::detail::expected_max_vector_size ||
                         option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  static const std::regex range(R"( in \[(\S+) - (\S+)\])");
  std::smatch found;
  if (std::regex_search(type, found, range)) {
    result.description += fmt::format(" (from {} to {}", found[1].str(), found[2].str());
    if (!option.get_default_str().empty()) result.description += "; default: " + option.get_default_str();
    result.description += ')';
  } else if (!option.get_default_str().empty()) {
    result.description += fmt::format(" (default: {})", option.get_default_str());
  }
  return result;
}

void add_options(const CLI::App& app, DeclaredCommand& command) {
  for (const CLI::Option* option : app.get_options(any_option))
    (option->get_positional() ? command.arguments : command.options).push_back(declared(*option));
  for (const CLI::App* group : app.get_subcommands(any_command)) {
    if (group->get_name().empty()) add_options(*group, command);
  }
}

DeclaredCommand declared(const CLI::App& app, const std::string& name) {
  DeclaredCommand command{.name = name, .description = app.get_description()};
  add_options(app, command);
  return command;
}

}  // namespace

std::vector<DeclaredCommand> declared_commands(const CLI::App& app) {
  std::vector<DeclaredCommand> commands{declared(app, "")};
  for (const CLI::App* command : app.get_subcommands(any_command))
    commands.push_back(declared(*command, command->get_name()));
  return commands;
}

}  // namespace talus::cli
