#pragma once
// Options that several commands have.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "load.hpp"
#include "option_values.hpp"

namespace talus::cli {

inline const CLI::Validator names_file = not_empty("\"\" is not a file name"),
                            names_folder = not_empty("\"\" is not a folder name"),
                            names_line = not_empty("\"\" is not a line, polygon or barrier");

/// A project file and what overrides its settings.
void add_project(CLI::App& command, ProjectOptions& options);

/// A study file.
void add_study(CLI::App& command, std::filesystem::path& study);

/// The folder of a finished run.
void add_run_folder(CLI::App& command, std::filesystem::path& folder, const std::string& description);

/// KEY=VALUE, as often as given; `option`: "--set".
void add_overrides(CLI::App& command, const std::string& option, std::vector<std::string>& settings,
                   const std::string& description, const std::string& type_name = "KEY=VALUE");

void add_output_folder(CLI::App& command, std::filesystem::path& folder, const std::string& description);

void add_threads(CLI::App& command, int& threads,
                 const std::string& description = "Number of threads (default: all cores)");

void add_quiet(CLI::App& command, bool& quiet, const std::string& description = "Print only warnings and errors");

/// `bytes`: 0 is the default.
void add_maps_memory(CLI::App& command, std::uint64_t& bytes);

/// One of a line, a barrier and a polygon. Returns their group.
CLI::Option_group& add_question(CLI::App& command, std::string& line, std::string& barrier, std::string& polygon);

}  // namespace talus::cli
