#pragma once
// What the commands that run a project with other values or models have in common.

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

#include "talus/lines/what_if.hpp"

namespace talus::cli {

/// One of them; as in the options of add_question().
struct PlaceOptions {
  std::string line, barrier, polygon;
  [[nodiscard]] bool is_given() const { return !line.empty() || !barrier.empty() || !polygon.empty(); }
};

/// Expects one of the options. Throws BadInput with all problems of the place.
[[nodiscard]] what_if::AskedPlace place_asked(const PlaceOptions& options, const Model& model, Problems& warnings);

/// --within SECONDS
void add_time(CLI::App& command, std::optional<double>& seconds);

/// Runs all sets, with the progress unless `is_quiet`. False if it was stopped.
[[nodiscard]] bool run_with_progress(what_if::WhatIf& asked, what_if::RunOptions how, bool is_quiet);

/// The exit code after a run, which a stop is reported with.
[[nodiscard]] int ended(bool is_complete);

/// The units of tables, in those of the figures.
inline constexpr double kJ = 1000, percent = 0.01;

/// "12.3 (11.9 to 12.7) kJ"; with a sign for a change.
[[nodiscard]] std::string estimate_text(const std::optional<Estimate>& estimate, double unit, const char* name,
                                        bool is_change = false);
[[nodiscard]] std::string share_text(const std::optional<RockShare>& share);

}  // namespace talus::cli
