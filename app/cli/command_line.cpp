#include "command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "talus/campaign/ranks.hpp"
#include "talus/core/nearest.hpp"

namespace talus::cli {

namespace {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    std::ranges::transform(option->get_lnames(), std::back_inserter(names),
                           [](const std::string& name) { return "--" + name; });
  }
  return names;
}

std::optional<std::string> nearest_of(const std::string& word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  const auto near = nearest(word, names);
  return near ? std::optional(std::string(*near)) : std::nullopt;
}

/// A suggestion for the first unknown option: ". Did you mean ...?", or empty.
std::string suggested_option(const CLI::App& command, const std::vector<std::string>& words) {
  const std::vector<std::string> known = option_names(command);
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!name.starts_with("--") || std::ranges::find(known, name) != known.end()) continue;
    const auto near = nearest_of(name, known);
    return near ? fmt::format(". Did you mean {}?", *near) : "";
  }
  return "";
}

std::string message_about_command(const CLI::App& app, const std::vector<std::string>& words) {
  const std::vector<std::string> known = command_names(app);
  const std::string list = fmt::format("known commands: {}", fmt::join(known, ", "));
  const auto word = std::ranges::find_if(words, [](const std::string& each) { return !each.starts_with('-'); });
  if (word == words.end()) return fmt::format("the command is missing ({}){}", list, suggested_option(app, words));
  const std::string what = fmt::format("there is no command \"{}\"", *word);
  if (word->ends_with(".toml")) return fmt::format("{}. Did you mean `talus run {}`?", what, *word);
  if (const auto near = nearest_of(*word, known)) return fmt::format("{}. Did you mean \"{}\"?", what, *near);
  return fmt::format("{} ({})", what, list);
}

}  // namespace

std::string message_about(const CLI::App& app, const CLI::Error& error, const std::vector<std::string>& words) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  std::string what;
  if (given.empty()) {
    what = error.get_name() == "RequiredError" ? message_about_command(app, words) : error.what();
  } else {
    what = error.what();
    // The error's name cannot tell: here it is the name of the command.
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
      what += suggested_option(*given.front(), words);
  }
  const std::string help = given.empty() ? "talus --help" : fmt::format("talus {} --help", given.front()->get_name());
  return fmt::format("{}\nSee `{}`.\n", what, help);
}

void refuse_missing_values(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (!word.starts_with("--") || word.find('=') + 1 != word.size()) continue;
    throw CLI::ArgumentMismatch(fmt::format("{} has no value", word));
  }
}

bool reports_for_all(const std::vector<std::string>& words) {
  const auto launch = find_launch();
  return !launch || launch->rank == 0 || std::ranges::find(words, "--alone") != words.end();
}

}  // namespace talus::cli
