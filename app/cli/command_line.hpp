#pragma once
// Messages about command lines that cannot be parsed.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace talus::cli {

/// Describes the error and suggests the command or option that was probably meant. `words`: the command line without
/// the program's name.
[[nodiscard]] std::string message_about(const CLI::App& app, const CLI::Error& error,
                                        const std::vector<std::string>& words);

/// Throws CLI::ParseError for `--option=` without a value: CLI11 would use the next word as its value.
void refuse_missing_values(const std::vector<std::string>& words);

/// Whether this process reports errors of the command line. Of processes that a launcher started together only the
/// first does, unless `words` contain --alone.
[[nodiscard]] bool reports_for_all(const std::vector<std::string>& words);

}  // namespace talus::cli
