#pragma once
// Reads a project file and checks its values and the rules across them; all problems are reported in one pass.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Settings from the command line that override the file.
struct Overrides {
  /// `table.key=value`, the value in TOML or a string without quotes. List entries are addressed by zero-based number
  /// or by name: `seeder.0.rocks=10`, `material.Type One.normal_restitution.mean=0.4`.
  std::vector<std::string> settings;
  /// Total number of rocks. Several seeders share it in proportion to their numbers in the file; a share may be 0.
  std::optional<std::int64_t> rocks;
  std::optional<std::uint64_t> seed;
  /// The settings of [design] are for a line that is asked of a finished run, so that the project needs none of its
  /// own.
  bool asks_a_line = false;
};

struct Reading {
  Project project;
  Problems warnings;
};

/// Throws BadInput with every problem found, warnings among them, in the order of the file.
[[nodiscard]] Reading read_project(const std::filesystem::path& file, const Overrides& overrides = {});

/// Overload for the text of a file of this name.
[[nodiscard]] Reading read_project_text(std::string_view text, const std::filesystem::path& file,
                                        const Overrides& overrides = {});

}  // namespace talus::project
