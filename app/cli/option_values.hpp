#pragma once
// What may stand behind an option: CLI11 itself takes an empty text for 0, 010 for 8, and what needs more than 64 bits
// for the largest number there is.

#include <string>

#include <CLI/CLI.hpp>

namespace talus::cli {

/// 0 or more, and at most what a project file can hold.
[[nodiscard]] CLI::Validator natural_number();

/// A whole number; of its range the project says more.
[[nodiscard]] CLI::Validator number_of_rocks();

/// "500MB", "4GB": becomes bytes.
[[nodiscard]] CLI::Validator memory_size();

/// An empty text is what an unset variable of a script becomes; it is no reason to do what is done without the option.
[[nodiscard]] CLI::Validator not_empty(std::string message);

}  // namespace talus::cli
