#include "talus/lines/area_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "talus/archive/design_json.hpp"
#include "talus/archive/design_tables.hpp"
#include "talus/model/build_barrier.hpp"
#include "talus/results/run_figures.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

/// The corners on the ground; those off the terrain without z.
Json outline_json(const Model& model, const AskedArea& area) {
  Json json = Json::array();
  for (const Vec2& corner : area.ring) {
    const auto z =
        std::visit([&](const auto& surface) { return surface.elevation(corner.x(), corner.y()); }, *model.surface);
    const Vec3 place = model.frame.global_from_local({corner.x(), corner.y(), z.value_or(0)});
    json.push_back({place.x(), place.y(), z ? Json(place.z()) : Json()});
  }
  return json;
}

QuantileSketch values_of(const AreaAnswer& answer, std::size_t quantity) {
  QuantileSketch sketch(answer.entering.size());
  for (const RockInside& rock : answer.entering) sketch.add(rock.maxima[quantity]);
  return sketch;
}

Json percentiles_json(const AreaAnswer& answer) {
  Json json = Json::object();
  for (std::size_t q = 0; q < shown_quantity_count; ++q) {
    Json& of_quantity = json[key_of(design_quantities[q])] = Json::object();
    if (answer.entering.empty()) continue;
    const QuantileSketch sketch = values_of(answer, q);
    const RankedValues values(sketch);
    for (const double percentile : answer.plan.percentiles) {
      const Estimate estimate = values.estimate(percentile / 100, answer.plan.confidence);
      of_quantity[fmt::format("{}", percentile)] = {estimate.value, estimate.low ? Json(*estimate.low) : Json(),
                                                    estimate.high ? Json(*estimate.high) : Json()};
    }
  }
  return json;
}

Json count_json(const AreaAnswer& answer, std::uint64_t rocks) {
  return {{"rocks", rocks}, {"share", share_json(share_of(rocks, answer.rocks, answer.plan.confidence))}};
}

Json enough_in_area_json(const AreaAnswer& answer, double precision) {
  Json json{{"precision", precision}};
  const std::uint64_t entering = answer.entering.size();
  std::optional<std::uint64_t> most;
  const auto add = [&](const char* key, const RunFigure& figure, const Estimate& estimate, std::uint64_t values) {
    const auto needed = rocks_needed(figure, estimate, answer.rocks, values, answer.plan.confidence, precision);
    json[key] = {{"is_enough", needed && *needed <= answer.rocks}, {"rocks", needed ? Json(*needed) : Json()}};
    if (needed) most = std::max(most.value_or(0), *needed);
  };
  if (const auto share = share_of(entering, answer.rocks, answer.plan.confidence))
    add("share", {FigureOf::share, 0, 0}, {share->value, share->low, share->high}, answer.rocks);
  if (entering > 0) {
    const auto total = static_cast<std::size_t>(CrossingQuantity::energy_total);
    const QuantileSketch sketch = values_of(answer, total);
    add("energy", {FigureOf::energy, answer.plan.design_percentile, 0},
        RankedValues(sketch).estimate(answer.plan.design_percentile / 100, answer.plan.confidence), entering);
  }
  json["rocks"] = most ? Json(*most) : Json();
  std::string text;
  if (entering == 0) {
    text = fmt::format("None of {} rocks enters: more rocks would show rarer ones", grouped(answer.rocks));
  } else if (most && *most > answer.rocks) {
    text = fmt::format("{} rocks would bring all intervals within {:g} % (now {})", grouped(*most), 100 * precision,
                       grouped(answer.rocks));
  }
  json["text"] = std::move(text);
  return json;
}

}  // namespace

Json area_json(const Model& model, const AskedArea& area, const AreaAnswer& answer, const StoredSources& sources,
               const AnswerOptions& options) {
  const std::vector<std::uint64_t> stopping = answer.stopping();
  std::vector<std::uint64_t> entering;
  std::optional<CrossingMaxima> maxima;
  for (const RockInside& rock : answer.entering) {
    entering.push_back(rock.rock);
    if (!maxima) maxima.emplace();
    for (std::size_t q = 0; q < maxima->size(); ++q) (*maxima)[q] = std::max((*maxima)[q], rock.maxima[q]);
  }
  Json json{{"kind", "polygon"},
            {"area_m2", area.area},
            {"outline", outline_json(model, area)},
            {"confidence", answer.plan.confidence},
            {"entering", count_json(answer, entering.size())},
            {"stopping", count_json(answer, stopping.size())},
            {"percentiles", percentiles_json(answer)},
            {"maxima", maxima_json(maxima)},
            {"enough", enough_in_area_json(answer, options.precision)}};
  if (options.wants_sources) {
    Json of_entering = sources_json(sources, entering, std::nullopt, answer.plan.confidence);
    std::vector<std::uint64_t> stops(sources.stored.size());
    for (const std::uint64_t rock : stopping) ++stops[sources.spots.of_rock(rock)];
    of_entering["stopping"] = Json::array();
    for (const Json& spot : of_entering["release"]) of_entering["stopping"].push_back(stops[spot.get<std::size_t>()]);
    json["sources"] = std::move(of_entering);
  }
  return json;
}

}  // namespace talus
