#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "asked_variations.hpp"
#include "command_options.hpp"
#include "commands.hpp"
#include "load.hpp"
#include "standard_streams.hpp"
#include "stop_signals.hpp"
#include "talus/archive/design_json.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/files/output_file.hpp"
#include "talus/lines/line_json.hpp"
#include "talus/lines/side_view.hpp"
#include "talus/lines/what_if_output.hpp"
#include "talus/model/rock_models.hpp"
#include "talus/report/study_page.hpp"

namespace talus::cli {

namespace {

struct CompareOptions {
  ProjectOptions project;
  PlaceOptions place;
  bool models = false;
  std::optional<double> within_s;
  std::filesystem::path folder;  // for tables and the page; empty: none
  int threads = 0;
  bool quiet = false;
};

/// Rocks of each model that are drawn.
constexpr std::uint64_t pictured_rocks = 60;

/// The place that is asked: as given, or the first collector or barrier of the project. Nowhere if it has none.
what_if::AskedPlace place_of(const PlaceOptions& given, const Model& model, std::string& name, Problems& warnings) {
  if (given.is_given()) {
    name = !given.barrier.empty() ? fmt::format("\"{}\"", given.barrier)
                                  : fmt::format("the {}", given.polygon.empty() ? "line" : "polygon");
    return place_asked(given, model, warnings);
  }
  const auto collector = std::ranges::find_if(model.barriers, &Barrier::is_collector);
  const auto chosen = collector != model.barriers.end() ? collector : model.barriers.begin();
  if (chosen == model.barriers.end()) return std::monostate{};
  name = fmt::format("{} \"{}\"", chosen->is_collector ? "collector" : "barrier", chosen->name);
  return line_of_barrier(model, chosen->name, "--barrier");
}

/// A model and its figures.
struct Row {
  std::string name;
  const what_if::Figures* figures;
};

std::vector<Row> rows_of(const what_if::WhatIf& asked, const what_if::Answer& answer) {
  std::vector<Row> rows{{fmt::format("{} (the project's)", project::name_of(asked.rock_model())), &answer.base}};
  for (std::size_t k = 0; k < answer.variations.size(); ++k) {
    const what_if::Variation& variation = asked.variations()[k];
    std::string name(project::name_of(*variation.model));
    std::set<std::string> shapes;
    for (const what_if::Change& change : variation.changes)
      if (change.key == "shape" && change.after) shapes.insert(change.after->get<std::string>());
    if (!shapes.empty()) name += fmt::format(", shape {}", fmt::join(shapes, ", "));
    rows.push_back({std::move(name), &answer.variations[k].figures});
  }
  return rows;
}

/// A figure of the comparison: where it is, and how it is written.
struct FigureText {
  std::string title;
  std::optional<Estimate> (*of)(const what_if::Figures&);
  double unit;
  const char* unit_name;
};

template <what_if::Asked quantity>
std::optional<Estimate> percentile_of(const what_if::Figures& figures) {
  return figures.percentile[what_if::place_of(quantity)];
}
template <std::optional<RockShare> what_if::Figures::*member>
std::optional<Estimate> share_in(const what_if::Figures& figures) {
  return what_if::estimate_of(figures.*member);
}

std::vector<FigureText> figures_of(const what_if::WhatIf& asked) {
  using what_if::Asked, what_if::Figures;
  const std::string p = fmt::format("{:g} % ", asked.percentile());
  std::vector<FigureText> texts;
  if (!std::holds_alternative<std::monostate>(asked.place())) {
    const bool is_line = std::holds_alternative<AskedLine>(asked.place());
    texts = {{is_line ? "cross" : "enter", share_in<&Figures::share>, percent, "%"},
             {p + "translational energy", percentile_of<Asked::energy_translational>, kJ, "kJ"},
             {p + "total energy", percentile_of<Asked::energy_total>, kJ, "kJ"},
             {p + (is_line ? "height of the block's top" : "bounce height"), percentile_of<Asked::height>, 1, "m"},
             {p + "velocity", percentile_of<Asked::velocity>, 1, "m/s"}};
  }
  texts.push_back({"median runout", [](const Figures& figures) { return figures.runout_median; }, 1, "m"});
  texts.push_back({p + "runout", [](const Figures& figures) { return figures.runout; }, 1, "m"});
  texts.push_back({"leave the model", share_in<&Figures::left>, percent, "%"});
  return texts;
}

/// The figures as rows, the models as columns: names of shapes are longer than numbers.
void print_table(const std::vector<Row>& rows, const std::vector<FigureText>& figures, const what_if::WhatIf& asked) {
  const bool is_line = std::holds_alternative<AskedLine>(asked.place());
  const std::string fence = asked.standard().empty() ? "fence needed, no factors" : "fence by " + asked.standard();
  std::size_t widest = is_line ? fence.size() : 0;
  for (const FigureText& figure : figures) widest = std::max(widest, figure.title.size());
  constexpr std::size_t column = 34;
  const auto line = [&](std::string_view title, const auto& text_of) {
    fmt::print("{:<{}}", title, widest + 2);
    for (const Row& row : rows) fmt::print("{:<{}}", text_of(row), column);
    fmt::print("\n");
  };
  line("", [](const Row& row) { return row.name; });
  for (const FigureText& figure : figures)
    line(figure.title,
         [&](const Row& row) { return estimate_text(figure.of(*row.figures), figure.unit, figure.unit_name); });
  if (is_line)
    line(fence, [](const Row& row) { return row.figures->demand ? demand_text(row.figures->demand) : "none crosses"; });
  fmt::print("in brackets: intervals of sampling alone, confidence {:g} %\n", 100 * asked.confidence());
}

/// The figures in which the least and the greatest of the models are apart by more than their intervals.
std::vector<std::string> disagreements(const std::vector<Row>& rows, const std::vector<FigureText>& figures) {
  std::vector<std::string> texts;
  for (const FigureText& figure : figures) {
    std::optional<Estimate> least, greatest;
    std::string of_least, of_greatest;
    for (const Row& row : rows) {
      const auto value = figure.of(*row.figures);
      if (!value) continue;
      if (!least || value->value < least->value) std::tie(least, of_least) = std::tie(value, row.name);
      if (!greatest || value->value > greatest->value) std::tie(greatest, of_greatest) = std::tie(value, row.name);
    }
    if (!least || !what_if::are_apart(*least, *greatest)) continue;
    texts.push_back(fmt::format("{}: {} {} as {}, {} {} as {}", figure.title, three_digits(least->value / figure.unit),
                                figure.unit_name, of_least, three_digits(greatest->value / figure.unit),
                                figure.unit_name, of_greatest));
  }
  return texts;
}

struct Facts {
  const Loaded& loaded;
  std::string place;  // empty: nowhere
  std::vector<std::string> disagreements;
  const Problems& warnings;
};

void write_results(const std::filesystem::path& folder, const what_if::WhatIf& asked, const what_if::Answer& answer,
                   const Facts& facts) {
  nlohmann::ordered_json json{{"name", facts.loaded.project.name},
                              {"talus", {{"version", TALUS_VERSION}}},
                              {"project", facts.loaded.project.file.filename().string()},
                              {"seed", facts.loaded.model.seed},
                              {"place", facts.place},
                              {"is_line", std::holds_alternative<AskedLine>(asked.place())},
                              {"disagreements", facts.disagreements},
                              {"warnings", nlohmann::ordered_json::array()}};
  for (const Problem& warning : facts.warnings.list()) json["warnings"].push_back(warning.text());
  json.update(json_of(asked, answer));
  json["side_view"] = side_view(asked);
  make_output_folder(folder);
  write_file(folder / "compare.csv", table_of(asked, answer));
  write_file(folder / "compare.json", json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  write_file(folder / "compare.html", models_page(facts.loaded.project.name, json));
}

int compare(const CompareOptions& options) {
  if (!options.models) {
    throw BadInput(Problem{.what = "nothing to compare is given",
                           .why = "expected --models",
                           .hint = "talus compare PROJECT --models runs the same rocks with each rock model"});
  }
  take_threads(options.threads);
  catch_stop_signals();
  const Loaded loaded = load(options.project);
  Problems warnings = loaded.warnings;
  std::string name;
  what_if::AskedPlace place = place_of(options.place, loaded.model, name, warnings);
  what_if::WhatIf asked(loaded.project, loaded.model, project::design_basis(loaded.project), std::move(place),
                        {.steps = std::vector<what_if::Step>{}, .models = true}, "--models", warnings);
  print_warnings(warnings);
  const bool is_complete = run_with_progress(asked,
                                             {.threads = options.threads,
                                              .rocks = what_if::most_rocks,
                                              .seconds = options.within_s,
                                              .pictured = options.folder.empty() ? 0 : pictured_rocks},
                                             options.quiet);
  const what_if::Answer answer = asked.answer();
  const std::vector<Row> rows = rows_of(asked, answer);
  const std::vector<FigureText> figures = figures_of(asked);
  fmt::print("{} of {} rocks with each model, the same in all{}\n", grouped(answer.rocks), grouped(answer.planned),
             name.empty() ? "" : fmt::format("; at {}", name));
  print_table(rows, figures, asked);
  const std::vector<std::string> apart = disagreements(rows, figures);
  if (!apart.empty()) fmt::print("the models differ by more than chance:\n");
  for (const std::string& text : apart) fmt::print("  {}\n", text);
  if (!options.folder.empty()) {
    write_results(options.folder, asked, answer, {loaded, name, apart, warnings});
    if (!options.quiet)
      fmt::print("Open {} to see paths and figures of each model\n", (options.folder / "compare.html").string());
  }
  return ended(is_complete);
}

}  // namespace

Command add_compare(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand(
      "compare", "Run the same rocks as lumped masses, as spheres and as blocks, and compare how far the answer moves");
  add_project(*command, options->project);
  command->add_flag("--models", options->models, "Compare the rock models");
  add_question(*command, options->place.line, options->place.barrier, options->place.polygon)
      .description(
          "Where: by default at the first collector or barrier of the project; without one, only how far "
          "rocks go")
      ->require_option(0, 1);
  add_time(*command, options->within_s);
  add_output_folder(*command, options->folder, "Folder for compare.html, compare.csv and compare.json (default: none)");
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet, "Print only the table, warnings and errors");
  return {command, [options] { return compare(*options); }};
}

}  // namespace talus::cli
