#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "talus/archive/design_json.hpp"
#include "talus/archive/design_tables.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/files/output_file.hpp"
#include "talus/lines/asked_run.hpp"
#include "talus/lines/line_input.hpp"
#include "talus/lines/reopened_run.hpp"

namespace talus::cli {

namespace {

/// A question to a finished run; one of line, barrier, polygon and ditch.
struct LineOptions {
  std::filesystem::path folder;               // of the run
  std::string line, polygon;                  // "x,y x,y ...", or a file
  std::string barrier;                        // of the run
  std::vector<double> ditch;                  // its toe and far edge
  std::optional<double> height_m, energy_kJ;  // of a kit to judge; both or neither
  std::optional<double> section_m;
  std::vector<std::string> design;  // KEY=VALUE of [design]
  std::filesystem::path files;      // folder of the project's files; empty: the one that `folder` is in
  std::filesystem::path json;       // empty: none
  bool csv = false;
};

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// "412 kJ (380 to 456 kJ)"
std::string with_interval(const Json& card, const char* key) {
  return fmt::format("{} ({})", card.at(key).get<std::string>(),
                     card.at(fmt::format("{}_interval", key)).get<std::string>());
}

std::string number_or_blank(const Json& section, const char* quantity, const std::string& percentile, double unit) {
  const Json& values = section.at("percentiles").at(quantity);
  return values.contains(percentile) ? three_digits(values.at(percentile).at(0).get<double>() / unit) : "";
}

/// "37.2 % (35.1 to 39.4 %)"; empty without rocks.
std::string share_text(const Json& share) {
  if (share.is_null()) return {};
  const auto of = [&](const char* key) { return rounded_percents(share.at(key).get<double>()); };
  return fmt::format("{:.1f} % ({:.1f} to {:.1f} %)", of("value"), of("low"), of("high"));
}

void print_sources(const Json& sources, const StoredSources& places, const Model& model) {
  constexpr std::size_t most = 10;
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t k = 0; k < sources.at("release").size(); ++k)
    order.emplace_back(sources.at("crossing")[k].get<std::uint64_t>(), k);
  std::ranges::stable_sort(order, std::greater<>(), [](const auto& each) { return each.first; });
  if (order.empty()) return;
  const std::size_t shown = std::min(most, order.size());
  fmt::print("\nfrom ({}):\n{:>9}  {:<20}{:>14}{:>14}{:>9}{:>10}\n",
             shown == 1 ? "one place of release" : fmt::format("the {} places of release with the most of them", shown),
             "place", "source", "x [m]", "y [m]", "rocks", "of them");
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t k = order[i].second, spot = sources.at("release")[k].get<std::size_t>();
    const ReleaseSpot& release = places.spots.list()[spot];
    const Vec3 place = model.frame.global_from_local(release.place);
    const std::string source =
        release.source.index < model.sources.size() ? model.sources[release.source.index] : std::string();
    fmt::print("{:>9}  {:<20}{:>14.2f}{:>14.2f}{:>9}{:>10}\n", spot, source, place.x(), place.y(),
               sources.at("rocks")[k].get<std::uint64_t>(), order[i].first);
  }
}

void print_run(const Json& run) {
  const auto rocks = run.at("rocks").get<std::uint64_t>(), stored = run.at("stored").get<std::uint64_t>();
  if (stored < rocks)
    fmt::print("The trajectories of {} of {} rocks are stored: shares and intervals are of these.\n", grouped(stored),
               grouped(rocks));
}

/// The range between the ensembles of the run, if it has any.
void print_ensembles(const Json& answer) {
  const Json& spread = answer.at("ensembles");
  if (spread.is_null()) return;
  fmt::print("{:g} % of the {} ensembles of parameters are within:\n", 100 * spread.at("confidence").get<double>(),
             spread.at("ensembles").get<std::uint64_t>());
  const auto range = [&](const char* key, const char* title, double unit, const char* name) {
    if (!spread.contains(key)) return;
    const Json& ends = spread.at(key);
    if (ends.is_null()) {
      fmt::print("  {:<22}unknown, too few ensembles\n", title);
    } else {
      fmt::print("  {:<22}{} to {} {}\n", title, three_digits(ends[1].get<double>() / unit),
                 three_digits(ends[2].get<double>() / unit), name);
    }
  };
  const bool is_area = answer.at("kind") == "polygon";
  range("share", is_area ? "enter" : "cross", 0.01, "%");
  range("stopping", "stop in it", 0.01, "%");
  range("ke_translational_J", "translational energy", 1000, "kJ");
  range("ke_total_J", "total energy", 1000, "kJ");
  range("height_m", "height", 1, "m");
  range("velocity_m_s", "velocity", 1, "m/s");
  range("needs_energy_J", "energy of the fence", 1000, "kJ");
  range("needs_height_m", "height of the fence", 1, "m");
}

void print_line(const Json& answer, const StoredSources& places, const Model& model) {
  const Json &whole = answer.at("whole"), &card = answer.at("card");
  const auto crossing = whole.at("rocks").get<std::uint64_t>();
  print_run(answer.at("run"));
  fmt::print("{} of {} rocks cross the line of {:g} m: {}\n", grouped(crossing),
             grouped(answer.at("run").at("stored").get<std::uint64_t>()), answer.at("length_m").get<double>(),
             with_interval(card, "share"));
  if (crossing == 0) {
    fmt::print("{}\n", answer.at("enough").at("text").get<std::string>());
    return;
  }
  fmt::print("{:g} % of them have at most (intervals from sampling alone, confidence {:g} %):\n",
             answer.at("design_percentile").get<double>(), 100 * answer.at("confidence").get<double>());
  const bool takes_total = answer.at("factors").at("of_total_energy").get<bool>();
  fmt::print("  {:<22}{}\n", takes_total ? "total energy" : "translational energy", with_interval(card, "energy"));
  fmt::print("  {:<22}{}, of the block's top above the foot\n", "height", with_interval(card, "height"));
  fmt::print("  {:<22}{}\n", "velocity", with_interval(card, "velocity"));
  if (!answer.at("standard").is_null()) {
    fmt::print("{} asks for {}\n", answer.at("standard").get<std::string>(), card.at("needs").get<std::string>());
    const auto cautious = card.at("needs_at_upper_end").get<std::string>();
    if (!cautious.empty()) fmt::print("  by the upper ends of the intervals: {}\n", cautious);
  }
  if (!answer.at("kit").is_null()) fmt::print("{}\n", answer.at("kit").at("text").get<std::string>());
  print_ensembles(answer);
  if (const auto text = answer.at("enough").at("text").get<std::string>(); !text.empty()) fmt::print("{}\n", text);

  const std::string percentile = fmt::format("{}", answer.at("design_percentile").get<double>());
  const bool is_known = whole.at("percentiles").at("height_m").contains(percentile);
  const Json& sections = answer.at("sections");
  if (sections.size() > 1) {
    fmt::print("\n{:>8}{:>9}{:>8}{:>13}{:>11}{:>14}{:>12}\n", "from [m]", "to [m]", "rocks",
               takes_total ? "total [kJ]" : "transl. [kJ]", "top [m]", "speed [m/s]", "needs");
    for (std::size_t s = 0; s < sections.size(); ++s) {
      const Json& section = sections[s];
      const bool is_worst = !answer.at("worst").is_null() && answer.at("worst").at("section") == s;
      const auto cell = [&](const char* quantity, double unit) {
        return is_known ? number_or_blank(section, quantity, percentile, unit) : "";
      };
      fmt::print(
          "{:>8.1f}{:>9.1f}{:>8}{:>13}{:>11}{:>14}{:>12}{}\n", section.at("from_m").get<double>(),
          section.at("to_m").get<double>(), section.at("rocks").get<std::uint64_t>(),
          cell(takes_total ? "ke_total_J" : "ke_translational_J", 1000), cell("height_m", 1), cell("velocity_m_s", 1),
          section.at("needs").is_null() ? "" : fmt::format("class {}", section.at("needs").at("class").get<int>()),
          is_worst ? "  the worst" : "");
    }
  }
  print_sources(answer.at("sources"), places, model);
}

void print_area(const Json& answer, const StoredSources& places, const Model& model) {
  print_run(answer.at("run"));
  const auto count = [&](const char* key, const char* does) {
    const Json& counted = answer.at(key);
    const Json& share = counted.at("share");
    fmt::print("{} rocks {} the polygon of {} m2", grouped(counted.at("rocks").get<std::uint64_t>()), does,
               three_digits(answer.at("area_m2").get<double>()));
    const std::string text = share_text(share);
    fmt::print("{}{}\n", text.empty() ? "" : ": ", text);
  };
  count("entering", "enter");
  count("stopping", "stop in");
  if (const Json& maxima = answer.at("maxima"); !maxima.is_null()) {
    fmt::print("at most {} kJ (total), its lowest point {} m above the ground, {} m/s inside\n",
               three_digits(maxima.at("ke_total_J").get<double>() / 1000),
               three_digits(maxima.at("height_m").get<double>()),
               three_digits(maxima.at("velocity_m_s").get<double>()));
  }
  print_ensembles(answer);
  if (const auto text = answer.at("enough").at("text").get<std::string>(); !text.empty()) fmt::print("{}\n", text);
  print_sources(answer.at("sources"), places, model);
}

/// "3.41 m (3.2 to 3.7)"; "unknown" is an end that more rocks would give. ">= 5 m": from `known_to` on (null: all are
/// known) distances are those at which a barrier stopped rocks.
std::string distance_text(const Json& estimate, const Json& known_to) {
  const auto value = estimate.at(0).get<double>();
  const bool is_cut = !known_to.is_null() && value >= known_to.get<double>();
  const std::string text = fmt::format("{}{} m", is_cut ? ">= " : "", three_digits(value));
  if (estimate.at(1).is_null() && estimate.at(2).is_null()) return is_cut ? text : text + " (too few rocks)";
  const auto end = [](const Json& limit) {
    return limit.is_null() ? std::string("unknown") : three_digits(limit.get<double>());
  };
  return fmt::format("{} ({} to {})", text, end(estimate.at(1)), end(estimate.at(2)));
}

void print_ditch(const Json& answer) {
  print_run(answer.at("run"));
  const auto count = [&](const char* key, const char* does, const char* of) {
    const Json& share = answer.at(key).at("share");
    const std::string rocks = grouped(answer.at(key).at("rocks").get<std::uint64_t>());
    const std::string text = share_text(share);
    if (text.empty()) {
      fmt::print("{} rocks {}\n", rocks, does);
    } else {
      fmt::print("{} rocks {}: {} {}\n", rocks, does, text, of);
    }
  };
  const std::string all = fmt::format("of {}", grouped(answer.at("rocks").get<std::uint64_t>()));
  count("arriving", "get past the toe", all.c_str());
  count("inside", "end inside", all.c_str());
  count("beyond",
        fmt::format("get beyond the far edge, {:g} m from the toe", answer.at("width_m").get<double>()).c_str(),
        all.c_str());
  if (answer.at("held").at("rocks") > 0) {
    count("held", "are held by a barrier before it; how far they would get is unknown", all.c_str());
    count("beyond_or_held", "at most would get beyond without that barrier", all.c_str());
  }
  count("retained", "are retained", "of those that get past the toe");
  if (const auto beyond = answer.at("released_beyond").get<std::uint64_t>(); beyond > 0)
    fmt::print("{} rocks are released past the toe and do not count.\n", grouped(beyond));
  fmt::print("\n{:>5}{:>30}{:>30}\n", "", "first impact", "roll-out");
  for (const double percentile : ditch_percentiles) {
    const std::string key = fmt::format("{}", percentile);
    const auto cell = [&](const char* what) {
      const Json& of = answer.at(what);
      const Json& values = of.at("percentiles");
      return values.contains(key) ? distance_text(values.at(key), of.at("known_to_m")) : std::string("-");
    };
    fmt::print("{:>3} %{:>30}{:>30}\n", key, cell("impact"), cell("rollout"));
  }
  if (answer.at("slope").is_null()) return;
  fmt::print("\nThe slope above: {} m at {:.0f} degrees\n",
             three_digits(answer.at("slope").at("height_m").get<double>()),
             answer.at("slope").at("angle_deg").get<double>());
  for (const Json& criterion : answer.at("criteria"))
    fmt::print("  {}: {}\n    ({})\n", criterion.at("name").get<std::string>(), criterion.at("text").get<std::string>(),
               criterion.at("source").get<std::string>());
}

void write_json(const fs::path& file, const Json& json) {
  if (file.empty()) return;
  OutputFile out(file);
  out.write(json.dump(2) + '\n');
  out.commit();
}

int line(const LineOptions& options) {
  take_available_threads();
  std::vector<std::string> settings;
  for (const std::string& setting : options.design) settings.push_back("design." + setting);
  const ReopenedRun run(options.folder, options.files, settings);
  const AskedRun& asked = run.asked();
  const Model& model = run.model();
  project::DesignBasis basis = project::design_basis(run.project());
  AnswerOptions answer_options;
  if (options.height_m) answer_options.kit = KitSize{*options.height_m, *options.energy_kJ * 1000};
  Problems warnings;
  if (!options.polygon.empty()) {
    const auto corners = places_given(options.polygon, PlanShape::polygon, model, "--polygon", warnings);
    const AskedArea area = drawn_area(model, corners, "--polygon", warnings);
    print_warnings(warnings);
    const auto [json, rocks, doubts] = asked.area(basis, area, answer_options);
    print_warnings(doubts);
    write_json(options.json, json);
    print_area(json, asked.sources(), model);
    return done;
  }
  if (!options.ditch.empty()) {
    const Ditch ditch = ditch_between(model, options.ditch[0], options.ditch[1], "--ditch");
    const auto [json, rocks, doubts] = asked.ditch(ditch, basis.design.confidence);
    print_warnings(doubts);
    write_json(options.json, json);
    print_ditch(json);
    return done;
  }
  const double height = answer_options.kit ? answer_options.kit->height : asked_height;
  const AskedLine line = !options.barrier.empty()
                             ? line_of_barrier(model, options.barrier, "--barrier")
                             : drawn_line(model, places_given(options.line, PlanShape::line, model, "--line", warnings),
                                          height, "--line", warnings);
  print_warnings(warnings);
  if (options.section_m) {
    basis.design.section_m = *options.section_m;
  } else if (!run.project().design) {
    basis.design.section_m = usual_section(line.barrier);
  }
  if (options.csv) {
    const LineAnswer answer = ask_lines(model, basis, asked.paths(), std::span(&line, 1)).front();
    DesignResult result;
    result.lines.push_back(answer.result);
    fmt::print("{}", design_table(answer.plan, result));
    return done;
  }
  add_kits_for_sliders(basis);
  const auto [json, rocks, doubts] = asked.line(basis, line, answer_options);
  print_warnings(doubts);
  write_json(options.json, json);
  print_line(json, asked.sources(), model);
  return done;
}

}  // namespace

Command add_line(CLI::App& app) {
  const auto options = std::make_shared<LineOptions>();
  CLI::App* command =
      app.add_subcommand("line", "Ask a finished run what crosses a line, or enters a polygon, on plan");
  add_run_folder(*command, options->folder, "Folder of the run, with its trajectories.bin");
  add_question(*command, options->line, options->barrier, options->polygon)
      .add_option("--ditch", options->ditch,
                  "2D: the toe and the far edge of a ditch or bench: where do rocks strike it, which get beyond it?")
      ->expected(2)
      ->type_name("X");
  auto* const kit_height =
      command->add_option("--height", options->height_m, "Nominal height of a kit on the line: what does it stop?")
          ->check(CLI::Range(1e-3, 1e3))
          ->type_name("M");
  auto* const kit_energy = command->add_option("--energy", options->energy_kJ, "Its maximum energy level")
                               ->check(CLI::Range(1e-3, 1e9))
                               ->type_name("KJ");
  kit_height->needs(kit_energy);
  kit_energy->needs(kit_height);
  command
      ->add_option("--section", options->section_m,
                   "Length of the stretches of the profile (default: section_m of [design], or about a twentieth)")
      ->check(CLI::Range(1e-3, 1e9))
      ->type_name("M");
  add_overrides(*command, "--design", options->design,
                "Override a key of [design], for example --design standard=none; repeatable");
  command->add_option("--files", options->files, "Folder of the project's files (default: the folder that DIR is in)")
      ->check(names_folder)
      ->type_name("DIR");
  auto* const json_file = command->add_option("--json", options->json, "Also write everything as JSON")
                              ->check(names_file)
                              ->type_name("FILE");
  command->add_flag("--csv", options->csv, "Print the rows of design.csv instead of a table")->excludes(json_file);
  return {command, [options] { return line(*options); }};
}

}  // namespace talus::cli
