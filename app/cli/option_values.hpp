#pragma once
// Validators of option values. CLI11 itself reads an empty text as 0, 010 as 8, and a number of more than 64 bits as
// the largest number.

#include <string>

#include <CLI/CLI.hpp>

namespace talus::cli {

/// A whole number from 0 to the largest that a project file can hold.
[[nodiscard]] CLI::Validator natural_number();

/// A whole number; its range is checked with the project.
[[nodiscard]] CLI::Validator number_of_rocks();

/// "500MB", "4GB": converted to bytes.
[[nodiscard]] CLI::Validator memory_size();

/// Refuses an empty text: it comes from an unset variable of a script, and must not act like a missing option.
[[nodiscard]] CLI::Validator not_empty(std::string message);

}  // namespace talus::cli
