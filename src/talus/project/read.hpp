#pragma once
// Reads a project file: the values, then the rules across them, and all problems in one pass.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// What the command line says differently from the file.
struct Overrides {
  /// `table.key=value`, the value in TOML (a bare word is a string). Entries of lists are called by number, counted
  /// from 0, or by name: `seeder.0.rocks=10`, `material.Type One.normal_restitution.mean=0.4`.
  std::vector<std::string> settings;
  /// Rocks in all. Several seeders share them in proportion to what the file gives each; one whose share rounds to
  /// nothing gets none.
  std::optional<std::int64_t> rocks;
  std::optional<std::uint64_t> seed;
};

struct Reading {
  Project project;
  Problems warnings;
};

/// Throws BadInput with every problem found, warnings among them, in the order of the file.
[[nodiscard]] Reading read_project(const std::filesystem::path& file, const Overrides& overrides = {});

/// The same from a text that stands in, or came from, a file of this name.
[[nodiscard]] Reading read_project_text(std::string_view text, const std::filesystem::path& file,
                                        const Overrides& overrides = {});

}  // namespace talus::project
