#pragma once
// What is said of a command line that cannot be read.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace talus::cli {

/// What is wrong, and the command or the option that was probably meant. `words` are those of the command line, without
/// the program's name.
[[nodiscard]] std::string message_about(const CLI::App& app, const CLI::Error& error,
                                        const std::vector<std::string>& words);

/// Throws CLI::ParseError of `--option=` with nothing behind it, for which CLI11 would take the next word.
void refuse_lacking_values(const std::vector<std::string>& words);

/// Of processes that a launcher started with the same words only the first answers for all, unless each runs alone.
[[nodiscard]] bool answers_for_all(const std::vector<std::string>& words);

}  // namespace talus::cli
