#include "asked_variations.hpp"

#include <fmt/format.h>

#include <utility>

#include "exit_codes.hpp"
#include "progress.hpp"
#include "standard_streams.hpp"
#include "stop_signals.hpp"
#include "talus/archive/design_json.hpp"
#include "talus/core/stop.hpp"
#include "talus/lines/line_input.hpp"
#include "talus/lines/line_json.hpp"

namespace talus::cli {

what_if::AskedPlace place_asked(const PlaceOptions& options, const Model& model, Problems& warnings) {
  if (!options.polygon.empty())
    return drawn_area(model, places_given(options.polygon, PlanShape::polygon, model, "--polygon", warnings),
                      "--polygon", warnings);
  if (!options.barrier.empty()) return line_of_barrier(model, options.barrier, "--barrier");
  return drawn_line(model, places_given(options.line, PlanShape::line, model, "--line", warnings), asked_height,
                    "--line", warnings);
}

void add_time(CLI::App& command, std::optional<double>& seconds) {
  command
      .add_option("--within", seconds,
                  "Time for the runs: as many rocks as fit, a fair sample of the project's (default: all, at most "
                  "200,000)")
      ->check(CLI::Range(1.0, 1e6))
      ->type_name("SECONDS");
}

bool run_with_progress(what_if::WhatIf& asked, what_if::RunOptions how, bool is_quiet) {
  std::optional<Progress> progress;
  if (!is_quiet) {
    progress.emplace(asked.model().rocks());
    how.progress = [&](std::uint64_t rocks, std::uint64_t planned) {
      progress->set_total(planned);
      (*progress)(rocks);
    };
  }
  const StopScope scope(&stop_wanted());
  try {
    return asked.run(how);
  } catch (const Stopped&) {  // before the first rock
    return false;
  }
}

int ended(bool is_complete) {
  if (is_complete) return done;
  to_stderr("stopped; the figures are of the rocks so far, a fair sample\n");
  return stopped;
}

std::string estimate_text(const std::optional<Estimate>& estimate, double unit, const char* name, bool is_change) {
  if (!estimate) return "-";
  const auto number = [&](double value) {
    const std::string text = three_digits(value / unit);
    return is_change && value >= 0 ? "+" + text : text;
  };
  const std::string low = estimate->low ? number(*estimate->low) : "?",
                    high = estimate->high ? number(*estimate->high) : "?";
  return fmt::format("{} ({} to {}) {}", number(estimate->value), low, high, name);
}

std::string share_text(const std::optional<RockShare>& share) {
  return estimate_text(what_if::estimate_of(share), percent, "%");
}

}  // namespace talus::cli
