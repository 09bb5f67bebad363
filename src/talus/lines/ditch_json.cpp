#include "talus/lines/ditch_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "talus/archive/design_json.hpp"
#include "talus/results/design_result.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

Json distances_json(const std::vector<double>& distances, double confidence) {
  Json json{{"rocks", distances.size()}, {"percentiles", Json::object()}, {"most", nullptr}};
  if (distances.empty()) return json;
  QuantileSketch sketch(distances.size());
  for (const double distance : distances) sketch.add(distance);
  const RankedValues values(sketch);
  const auto optional = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
  for (const double percentile : ditch_percentiles) {
    const Estimate estimate = values.estimate(percentile / 100, confidence);
    json["percentiles"][fmt::format("{}", percentile)] = {estimate.value, optional(estimate.low),
                                                          optional(estimate.high)};
  }
  json["most"] = *std::ranges::max_element(distances);
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
                      inside = count(&RockInDitch::ends_inside);
  std::vector<double> impacts, rollouts;
  for (const RockInDitch& rock : answer.arriving) {
    if (rock.first_impact) impacts.push_back(*rock.first_impact);
    rollouts.push_back(rock.farthest);
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
          {"kept", share(answer.rocks - beyond, answer.rocks)},
          {"retained", share(arriving - beyond, arriving)},
          {"impact", distances_json(impacts, confidence)},
          {"rollout", distances_json(rollouts, confidence)},
          {"slope", std::move(slope)},
          {"criteria", criteria_json(answer)}};
}

}  // namespace talus
