#include "talus/report/observed_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/stop.hpp"
#include "talus/core/vec.hpp"
#include "talus/results/runout_frame.hpp"
#include "talus/statistics/by_chance.hpp"
#include "talus/statistics/proper_scores.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_draws = 999, fewest_draws = 99;
constexpr double most_pairs = 4e8;  // of stops whose distances are computed

std::size_t draws_for(std::size_t stops) {
  const auto n = static_cast<double>(stops);
  return static_cast<std::size_t>(
      std::clamp(most_pairs / (n * n), static_cast<double>(fewest_draws), static_cast<double>(most_draws)));
}

/// The frame in which runout is counted, for observed stops too, whose releases are not known.
struct CommonFrame {
  RunoutFrame frame;
  std::string text;  // "from ...", for the reader
};

/// The project's; without one, from the mean release of the shown paths, if there are any.
std::optional<CommonFrame> common_frame(const RunFolder& run) {
  const Json::json_pointer from("/output/runout_from"), along("/output/runout_along");
  const auto& project = *run.summary.project;
  if (project.is_object() && project.contains(from)) {
    const auto point = project.at(from).get<std::vector<double>>();
    return CommonFrame{RunoutFrame::from({point.at(0), point.size() > 1 ? point[1] : 0}), "from the chosen point"};
  }
  if (project.is_object() && project.contains(along) && project.at(along).is_array()) {
    std::vector<Vec2> line;
    for (const auto& point : project.at(along)) line.emplace_back(point.at(0).get<double>(), point.at(1).get<double>());
    return CommonFrame{RunoutFrame::along(std::move(line)), "along the line"};
  }
  if (run.paths.items.empty()) return std::nullopt;
  Vec2 mean;
  for (const Path& path : run.paths.items)
    mean += vector(path.rows.front().position_m).xy() / static_cast<double>(run.paths.items.size());
  return CommonFrame{RunoutFrame::from(mean), "from the mean release"};
}

double quantile_of(const LineSample& sample, double p) {
  const auto [rank, fraction] = quantile_place(p, sample.values().size());
  return fraction > 0 ? between(sample.values()[rank], sample.values()[rank + 1], fraction) : sample.values()[rank];
}

Json facts_of(const LineSample& sample) {
  double mean = 0;
  for (const double value : sample.values()) mean += value / static_cast<double>(sample.values().size());
  constexpr std::size_t most_points = 400;
  auto points = Json::array();
  const std::size_t count = sample.values().size(), step = count / most_points + 1;
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_last_of_equals = k + 1 == count || sample.values()[k + 1] != sample.values()[k];
    if (is_last_of_equals && (k % step == 0 || k + 1 == count))
      points.push_back({sample.values()[k], sample.share_up_to(k)});
  }
  return {{"mean", mean},
          {"p05", quantile_of(sample, 0.05)},
          {"median", quantile_of(sample, 0.5)},
          {"p95", quantile_of(sample, 0.95)},
          {"cumulative", std::move(points)}};
}

Json json_of(double distance, const ByChance& chance) {
  return {{"value", distance}, {"median", chance.median}, {"p95", chance.p95}, {"p_value", chance.p_value}};
}

/// The rocks that chance draws, the same for all quantities.
std::vector<std::vector<std::size_t>> draws_of(std::uint64_t seed, std::size_t rocks, std::size_t stops) {
  std::vector<std::vector<std::size_t>> draws(draws_for(stops), std::vector<std::size_t>(stops));
  for (std::size_t k = 0; k < draws.size(); ++k) draw_members(seed, k, rocks, draws[k]);
  return draws;
}
using Draws = std::vector<std::vector<std::size_t>>;

Json compare_on_line(const char* key, const std::vector<double>& simulated, const std::vector<double>& observed,
                     const Draws& draws) {
  const LineSample rocks(simulated), stops(observed);
  std::vector<double> energy, steps, drawn(observed.size());
  for (const std::vector<std::size_t>& draw : draws) {
    stop_point();
    for (std::size_t k = 0; k < draw.size(); ++k) drawn[k] = simulated[draw[k]];
    const LineSample sample(drawn);
    energy.push_back(energy_distance(rocks, sample));
    steps.push_back(kolmogorov_smirnov(rocks, sample));
  }
  const double distance = energy_distance(rocks, stops), step = kolmogorov_smirnov(rocks, stops);
  return {{"key", key},
          {"simulated", facts_of(rocks)},
          {"observed", facts_of(stops)},
          {"energy_distance", json_of(distance, by_chance(distance, std::move(energy)))},
          {"kolmogorov_smirnov", json_of(step, by_chance(step, std::move(steps)))}};
}

Json compare_in_plane(const std::vector<Vec2>& simulated, const std::vector<Vec2>& observed, const Draws& draws) {
  const PlaneSample rocks(simulated);
  // The mean distance from each rock to all, once for all draws.
  std::vector<double> to_all(simulated.size());
  for (std::size_t k = 0; k < simulated.size(); ++k) {
    stop_point(k);
    to_all[k] = rocks.mean_distance(simulated[k]);
  }
  std::vector<double> distances;
  std::vector<Vec2> drawn(observed.size());
  for (const std::vector<std::size_t>& draw : draws) {
    stop_point();
    double between = 0;
    for (std::size_t k = 0; k < draw.size(); ++k) {
      drawn[k] = simulated[draw[k]];
      between += to_all[draw[k]] / static_cast<double>(draw.size());
    }
    distances.push_back(2 * between - rocks.spread() - PlaneSample(drawn).spread());
  }
  const double distance = energy_distance(rocks, PlaneSample(observed));
  return {{"key", "position"}, {"energy_distance", json_of(distance, by_chance(distance, std::move(distances)))}};
}

Json stops_json(const ObservedStops& observed) {
  auto rows = Json::array();
  for (const ObservedStop& stop : observed.stops) {
    rows.push_back({stop.x_m, stop.y_m, stop.z_m ? Json(*stop.z_m) : Json(), stop.name,
                    stop.mass_kg ? Json(*stop.mass_kg) : Json()});
  }
  return {{"columns", {"x", "y", "z", "name", "mass_kg"}}, {"rows", std::move(rows)}};
}

}  // namespace

Json observed_json(const ObservedStops& observed, const RunFolder& run) {
  const bool is_section = run.summary.terrain.kind == "section";
  const std::size_t rocks = run.endpoints.items.size();
  Json json{{"file", observed.file.filename().string()},
            {"stops", stops_json(observed)},
            {"rocks", rocks},
            {"draws", draws_for(observed.stops.size())},
            {"runout", nullptr},
            {"quantities", Json::array()}};
  if (rocks == 0) return json;

  std::vector<Vec2> ends, stops;
  for (const EndpointRow& end : run.endpoints.items) ends.emplace_back(end.position_m[0], end.position_m[1]);
  for (const ObservedStop& stop : observed.stops) stops.emplace_back(stop.x_m, stop.y_m);
  const Draws draws = draws_of(run.summary.seed, rocks, stops.size());
  Json& quantities = json["quantities"];
  const auto add_line = [&](const char* key, const auto& value_of) {
    std::vector<double> simulated, seen;
    for (const Vec2& each : ends) simulated.push_back(value_of(each));
    for (const Vec2& each : stops) seen.push_back(value_of(each));
    quantities.push_back(compare_on_line(key, simulated, seen, draws));
  };
  if (is_section) {
    add_line("x", [](const Vec2& p) { return p.x(); });
    return json;
  }
  quantities.push_back(compare_in_plane(ends, stops, draws));
  const std::optional<CommonFrame> common = common_frame(run);
  if (!common) return json;
  json["runout"] = common->text;
  add_line("runout", [&](const Vec2& p) { return common->frame.of(p, p).runout; });
  if (common->frame.is_along_line())
    add_line("lateral", [&](const Vec2& p) { return common->frame.of(p, p).lateral.value_or(0); });
  return json;
}

std::vector<std::string> comparison_lines(const Json& observed) {
  std::vector<std::string> lines;
  for (const Json& quantity : observed.at("quantities")) {
    const auto& key = quantity.at("key").get_ref<const std::string&>();
    const Json& distance = quantity.at("energy_distance");
    const auto number = [&](const char* of) { return distance.at(of).get<double>(); };
    lines.push_back(
        fmt::format("{}: energy distance {:.3g} m; by chance {:.3g} m (median), {:.3g} m (95 %); "
                    "chance alone is as far in {:.2g} %",
                    key == "runout" ? "runout " + observed.at("runout").get<std::string>() : key, number("value"),
                    number("median"), number("p95"), 100 * number("p_value")));
  }
  return lines;
}

}  // namespace talus
