#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "answer.hpp"
#include "asked_variations.hpp"
#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "stop_signals.hpp"
#include "talus/archive/design_json.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/files/output_file.hpp"
#include "talus/lines/line_json.hpp"
#include "talus/lines/what_if.hpp"
#include "talus/lines/what_if_output.hpp"

namespace talus::cli {

namespace {

/// A question to a project and its variations.
struct WhatIfOptions {
  ProjectOptions project;
  PlaceOptions place;
  std::vector<std::string> steps;  // FACTOR=PERCENT; empty: the usual ones
  std::string material;            // alone; empty: all
  bool models = false;             // the other rock models, too
  std::optional<double> within_s;  // time for the runs
  std::filesystem::path folder;    // for tables; empty: none
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

/// "1,240 kJ, class 3, 4.2 m"
std::string fence_text(const std::optional<KitDemand>& demand) {
  if (!demand) return "none";
  return fmt::format("{} kJ, class {}, {:.2f} m", three_digits(demand->maximum_energy / kJ), demand->kit_class,
                     demand->height);
}

constexpr const char* row_format = "{:<24}{:>14}  {:<28}{:<32}{:<28}{:<28}{}\n";
void print_table(const what_if::WhatIf& asked, const what_if::Answer& answer) {
  const bool is_line = std::holds_alternative<AskedLine>(asked.place());
  fmt::print("{} of {} rocks in each set; {} with the project's own values\n", grouped(answer.rocks),
             grouped(answer.planned), fmt::format("{} {}", grouped(answer.base.rocks), is_line ? "cross" : "enter"));
  const std::string p = fmt::format("{:g} %", asked.percentile());
  const std::string fence_title = !is_line                   ? ""
                                  : asked.standard().empty() ? "fence, without factors"
                                                             : "fence by " + asked.standard();
  fmt::print(row_format, "", "", "share", p + (asked.takes_total_energy() ? " total energy" : " translational energy"),
             p + " height", p + " velocity", fence_title);
  const auto of = [&](const auto& percentile, what_if::Asked quantity, double unit, const char* name, bool is_change) {
    return estimate_text(percentile[what_if::place_of(quantity)], unit, name, is_change);
  };
  const auto print_row = [&](std::string_view title, const std::string& step, const std::string& share_text,
                             const auto& percentile, bool is_change, const std::optional<KitDemand>& demand) {
    fmt::print(row_format, title, step, share_text, of(percentile, asked.energy(), kJ, "kJ", is_change),
               of(percentile, what_if::Asked::height, 1, "m", is_change),
               of(percentile, what_if::Asked::velocity, 1, "m/s", is_change), is_line ? fence_text(demand) : "");
  };
  print_row("base", "", share_text(answer.base.share), answer.base.percentile, false, answer.base.demand);
  fmt::print("changes, for the same rocks (confidence {:g} %){}:\n", 100 * asked.confidence(),
             is_line ? ", and the fence then" : "");
  for (std::size_t k = 0; k < answer.variations.size(); ++k) {
    const what_if::Variation& variation = asked.variations()[k];
    const what_if::Differences& change = answer.variations[k].differences;
    print_row(what_if::title_of(variation), what_if::step_text(variation),
              estimate_text(change.share, percent, "%", true), change.percentile, true,
              answer.variations[k].figures.demand);
    if (!variation.clipped.empty()) fmt::print("    clipped: {}\n", variation.clipped);
  }
}

void write_results(const std::filesystem::path& folder, const what_if::WhatIf& asked, const what_if::Answer& answer) {
  make_output_folder(folder);
  write_file(folder / what_if::WhatIfRow::file_name, table_of(asked, answer));
  write_file(folder / "what_if.json",
             json_of(asked, answer).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

int what_if(const WhatIfOptions& options) {
  take_threads(options.threads);
  catch_stop_signals();
  what_if::FactorChoice choice{.material = options.material, .models = options.models};
  for (const std::string& step : options.steps) {
    if (!choice.steps) choice.steps.emplace();
    choice.steps->push_back(step_of(step));
  }
  const Loaded loaded = load(options.project);
  Problems warnings = loaded.warnings;
  what_if::AskedPlace place = place_asked(options.place, loaded.model, warnings);
  what_if::WhatIf asked(loaded.project, loaded.model, project::design_basis(loaded.project), std::move(place), choice,
                        options.material.empty() ? "--step" : "--step, --material", warnings);
  print_warnings(warnings);
  if (!options.quiet) {
    fmt::print("{} sets of values, the same rocks in each\n", asked.variations().size() + 1);
    flush_output();
  }
  const bool is_complete = run_with_progress(
      asked, {.threads = options.threads, .rocks = what_if::most_rocks, .seconds = options.within_s}, options.quiet);
  const what_if::Answer answer = asked.answer();
  print_table(asked, answer);
  if (!options.folder.empty()) {
    write_results(options.folder, asked, answer);
    if (!options.quiet) fmt::print("what_if.csv and what_if.json are in {}\n", options.folder.string());
  }
  return ended(is_complete);
}

}  // namespace

Command add_what_if(CLI::App& app) {
  const auto options = std::make_shared<WhatIfOptions>();
  CLI::App* command = app.add_subcommand(
      "what-if",
      "Compare what crosses a line, or enters a polygon, with other values of the project, for the same rocks");
  add_project(*command, options->project);
  add_question(*command, options->place.line, options->place.barrier, options->place.polygon);
  add_overrides(*command, "--step", options->steps,
                "A factor and its step, for example --step normal_restitution=10%; repeatable (default: those that "
                "the project has of normal_restitution, tangential_restitution, friction_angle, dynamic_friction, "
                "rolling_friction by 10 %, roughness, forest_drag, mass by 25 %)",
                "FACTOR=PERCENT");
  command->add_option("--material", options->material, "Vary this material alone (default: all)")
      ->check(not_empty("\"\" is not a material"))
      ->type_name("NAME");
  command->add_flag("--models", options->models, "Also run the other rock models (talus compare: these alone)");
  add_time(*command, options->within_s);
  add_output_folder(*command, options->folder, "Folder for what_if.csv and what_if.json (default: none)");
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet, "Print only the table, warnings and errors");
  return {command, [options] { return what_if(*options); }};
}

}  // namespace talus::cli
