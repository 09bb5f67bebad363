#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "answer.hpp"
#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "progress.hpp"
#include "standard_streams.hpp"
#include "stop_signals.hpp"
#include "talus/archive/design_json.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/output_file.hpp"
#include "talus/lines/line_input.hpp"
#include "talus/lines/line_json.hpp"
#include "talus/lines/what_if.hpp"
#include "talus/lines/what_if_output.hpp"

namespace talus::cli {

namespace {

/// A question to a project and its variations; one of line, barrier and polygon.
struct WhatIfOptions {
  ProjectOptions project;
  std::string line, polygon, barrier;  // as in LineOptions
  std::vector<std::string> steps;      // FACTOR=PERCENT; empty: the usual ones
  std::string material;                // alone; empty: all
  std::optional<double> within_s;      // time for the runs
  std::filesystem::path folder;        // for tables; empty: none
  int threads = 0;
  bool quiet = false;
};

/// "normal_restitution=10%"
what_if::Step step_of(const std::string& text) {
  const auto refuse = [&] {
    throw BadInput(Problem{.where = "--step",
                           .what = fmt::format("\"{}\" is not a step", text),
                           .why = "expected a factor and a percentage",
                           .hint = "For example --step normal_restitution=10%"});
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) refuse();
  const std::string_view number = std::string_view(text).substr(equals + 1);
  double percent = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), percent);
  const std::string_view rest(end, number.data() + number.size());
  if (error != std::errc() || (!rest.empty() && rest != "%") || !std::isfinite(percent)) refuse();
  return {text.substr(0, equals), percent / 100};
}

what_if::AskedPlace place_of(const WhatIfOptions& options, const Model& model, Problems& warnings) {
  if (!options.polygon.empty())
    return drawn_area(model, places_given(options.polygon, PlanShape::polygon, model, "--polygon", warnings),
                      "--polygon", warnings);
  if (!options.barrier.empty()) return line_of_barrier(model, options.barrier, "--barrier");
  return drawn_line(model, places_given(options.line, PlanShape::line, model, "--line", warnings), asked_height,
                    "--line", warnings);
}

/// "12.3 % (11.9 to 12.7 %)"; with a sign for a difference.
std::string text_of(const std::optional<Estimate>& estimate, double unit, const char* name, bool is_difference) {
  if (!estimate) return "-";
  const auto number = [&](double value) {
    const std::string text = three_digits(value / unit);
    return is_difference && value >= 0 ? "+" + text : text;
  };
  const std::string low = estimate->low ? number(*estimate->low) : "?",
                    high = estimate->high ? number(*estimate->high) : "?";
  return fmt::format("{} ({} to {}) {}", number(estimate->value), low, high, name);
}

constexpr const char* row_format = "{:<24}{:>8}  {:<28}{:<32}{:<28}{:<28}\n";
constexpr double kJ = 1000, percent = 0.01;

void print_table(const what_if::WhatIf& asked, const what_if::Answer& answer) {
  const bool is_line = std::holds_alternative<AskedLine>(asked.place());
  fmt::print("{} of {} rocks in each set; {} with the project's own values\n", grouped(answer.rocks),
             grouped(answer.planned), fmt::format("{} {}", grouped(answer.base.rocks), is_line ? "cross" : "enter"));
  const std::string p = fmt::format("{:g} %", asked.percentile());
  fmt::print(row_format, "", "", "share", p + (asked.takes_total_energy() ? " total energy" : " translational energy"),
             p + " height", p + " velocity");
  const auto& share = answer.base.share;
  fmt::print(row_format, "base", "",
             text_of(share ? std::optional(Estimate{share->value, share->low, share->high}) : std::nullopt, percent,
                     "%", false),
             text_of(answer.base.percentile[0], kJ, "kJ", false), text_of(answer.base.percentile[1], 1, "m", false),
             text_of(answer.base.percentile[2], 1, "m/s", false));
  fmt::print("changes, for the same rocks (confidence {:g} %):\n", 100 * asked.confidence());
  for (std::size_t k = 0; k < answer.variations.size(); ++k) {
    const what_if::Variation& variation = asked.variations()[k];
    const what_if::Differences& change = answer.variations[k].differences;
    fmt::print(row_format, what_if::factor_kinds[variation.kind].title, what_if::step_text(variation),
               text_of(change.share, percent, "%", true), text_of(change.percentile[0], kJ, "kJ", true),
               text_of(change.percentile[1], 1, "m", true), text_of(change.percentile[2], 1, "m/s", true));
    if (!variation.clipped.empty()) fmt::print("    clipped: {}\n", variation.clipped);
  }
}

void write_results(const std::filesystem::path& folder, const what_if::WhatIf& asked, const what_if::Answer& answer) {
  make_output_folder(folder);
  const auto write = [&](const char* name, const std::string& text) {
    OutputFile out(folder / name);
    out.write(text);
    out.commit();
  };
  write(what_if::WhatIfRow::file_name, table_of(asked, answer));
  write("what_if.json", json_of(asked, answer).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

int what_if(const WhatIfOptions& options) {
  take_threads(options.threads);
  catch_stop_signals();
  what_if::FactorChoice choice{.steps = {}, .material = options.material};
  for (const std::string& step : options.steps) choice.steps.push_back(step_of(step));
  const Loaded loaded = load(options.project);
  Problems warnings = loaded.warnings;
  what_if::AskedPlace place = place_of(options, loaded.model, warnings);
  what_if::WhatIf asked(loaded.project, loaded.model, project::design_basis(loaded.project), std::move(place), choice,
                        options.material.empty() ? "--step" : "--step, --material", warnings);
  print_warnings(warnings);
  what_if::RunOptions how{
      .threads = options.threads, .rocks = what_if::most_rocks, .seconds = options.within_s, .progress = {}};
  std::optional<Progress> progress;
  if (!options.quiet) {
    fmt::print("{} sets of values, the same rocks in each\n", asked.variations().size() + 1);
    flush_output();
    progress.emplace(loaded.model.rocks());
    how.progress = [&](std::uint64_t rocks, std::uint64_t planned) {
      progress->set_total(planned);
      (*progress)(rocks);
    };
  }
  bool is_complete = false;
  {
    const StopScope scope(&stop_wanted());
    try {
      is_complete = asked.run(how);
    } catch (const Stopped&) {  // before the first rock
    }
  }
  progress.reset();
  const what_if::Answer answer = asked.answer();
  print_table(asked, answer);
  if (!options.folder.empty()) {
    write_results(options.folder, asked, answer);
    if (!options.quiet) fmt::print("what_if.csv and what_if.json are in {}\n", options.folder.string());
  }
  if (is_complete) return done;
  to_stderr("stopped; the figures are of the rocks so far, a fair sample\n");
  return stopped;
}

}  // namespace

Command add_what_if(CLI::App& app) {
  const auto options = std::make_shared<WhatIfOptions>();
  CLI::App* command = app.add_subcommand(
      "what-if",
      "Compare what crosses a line, or enters a polygon, with other values of the project, for the same rocks");
  add_project(*command, options->project);
  add_question(*command, options->line, options->barrier, options->polygon);
  add_overrides(*command, "--step", options->steps,
                "A factor and its step, for example --step normal_restitution=10%; repeatable (default: those that "
                "the project has of normal_restitution, tangential_restitution, friction_angle, dynamic_friction, "
                "rolling_friction by 10 %, roughness, forest_drag, mass by 25 %)",
                "FACTOR=PERCENT");
  command->add_option("--material", options->material, "Vary this material alone (default: all)")
      ->check(not_empty("\"\" is not a material"))
      ->type_name("NAME");
  command
      ->add_option("--within", options->within_s,
                   "Time for the runs: as many rocks as fit, a fair sample of the project's (default: all, at most "
                   "200,000)")
      ->check(CLI::Range(1.0, 1e6))
      ->type_name("SECONDS");
  add_output_folder(*command, options->folder, "Folder for what_if.csv and what_if.json (default: none)");
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet, "Print only the table, warnings and errors");
  return {command, [options] { return what_if(*options); }};
}

}  // namespace talus::cli
