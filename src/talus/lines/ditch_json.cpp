#include "talus/lines/ditch_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "talus/archive/design_json.hpp"
#include "talus/results/design_result.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

/// Distances of rocks. Those from `known_to` on are what a barrier left of a distance that may be longer.
struct Distances {
  std::vector<double> values;
  double known_to = std::numeric_limits<double>::infinity();

  void add(double value) { values.push_back(value); }
  void add_cut(double value) {
    values.push_back(value);
    known_to = std::min(known_to, value);
  }
};

Json distances_json(const Distances& distances, double confidence) {
  // Percentiles of very many rocks are off by up to a 2048th.
  const bool is_exact = distances.values.size() <= QuantileSketch::most_exact;
  const double known_to = is_exact ? distances.known_to : distances.known_to * (1 - 1.0 / 1024);
  Json json{{"rocks", distances.values.size()},
            {"percentiles", Json::object()},
            {"most", nullptr},
            {"known_to_m", std::isfinite(known_to) ? Json(known_to) : Json()}};
  if (distances.values.empty()) return json;
  QuantileSketch sketch(distances.values.size());
  for (const double distance : distances.values) sketch.add(distance);
  const RankedValues values(sketch);
  // Whatever the longer distances are, values below the shortest that was cut keep their ranks.
  const auto upper = [&](const std::optional<double>& value) {
    return value && *value < known_to ? Json(*value) : Json();
  };
  const auto optional = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  for (const double percentile : ditch_percentiles) {
    const Estimate estimate = values.estimate(percentile / 100, confidence);
    json["percentiles"][fmt::format("{}", percentile)] = {estimate.value, optional(estimate.low), upper(estimate.high)};
  }
  json["most"] = *std::ranges::max_element(distances.values);
  return json;
}

Json criteria_json(const DitchAnswer& answer) {
  Json json = Json::array();
  if (!answer.slope) return json;
  for (const DitchCriterion& criterion : ditch_criteria(*answer.slope))
    json.push_back({{"name", criterion.name},
                    {"source", criterion.source},
                    {"width_m", criterion.width ? Json(*criterion.width) : Json()},
                    {"text", criterion.text}});
  return json;
}

}  // namespace

Json ditch_json(const Model& model, const Ditch& ditch, const DitchAnswer& answer, double confidence) {
  const auto count = [&](auto&& is_it) {
    return static_cast<std::uint64_t>(std::ranges::count_if(answer.arriving, is_it));
  };
  const auto share = [&](std::uint64_t rocks, std::uint64_t of) {
    return Json{{"rocks", rocks}, {"share", share_json(share_of(rocks, of, confidence))}};
  };
  const std::uint64_t arriving = answer.arriving.size(), beyond = count(&RockInDitch::gets_beyond),
                      inside = count(&RockInDitch::ends_inside), held = count(&RockInDitch::is_held);
  Distances impacts, rollouts;
  for (const RockInDitch& rock : answer.arriving) {
    if (rock.first_impact) {
      impacts.add(*rock.first_impact);
    } else if (rock.at_barrier) {
      impacts.add_cut(*rock.at_barrier);
    }
    if (rock.at_barrier) {
      rollouts.add_cut(std::max(*rock.at_barrier, rock.farthest));
    } else {
      rollouts.add(rock.farthest);
    }
  }
  Json slope;
  if (answer.slope)
    slope = {{"height_m", answer.slope->height}, {"angle_deg", answer.slope->angle * 180 / std::numbers::pi}};
  return {{"kind", "ditch"},
          {"toe_m", ditch.toe + model.frame.origin.x()},
          {"far_m", ditch.far_edge + model.frame.origin.x()},
          {"width_m", ditch.width()},
          {"confidence", confidence},
          {"rocks", answer.rocks},
          {"released_beyond", answer.released_beyond},
          {"arriving", share(arriving, answer.rocks)},
          {"inside", share(inside, answer.rocks)},
          {"beyond", share(beyond, answer.rocks)},
          {"held", share(held, answer.rocks)},
          {"beyond_or_held", share(beyond + held, answer.rocks)},
          {"kept", share(answer.rocks - beyond, answer.rocks)},
          {"retained", share(arriving - beyond, arriving)},
          {"impact", distances_json(impacts, confidence)},
          {"rollout", distances_json(rollouts, confidence)},
          {"slope", std::move(slope)},
          {"criteria", criteria_json(answer)}};
}

}  // namespace talus
