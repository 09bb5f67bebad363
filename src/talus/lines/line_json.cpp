#include "talus/lines/line_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "talus/archive/design_json.hpp"
#include "talus/archive/design_tables.hpp"
#include "talus/results/run_figures.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json optional_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Shares with their intervals; equal ones, of which a table has many, are computed once.
class Shares {
 public:
  explicit Shares(double confidence) : confidence_(confidence) {}
  const std::optional<RockShare>& of(std::uint64_t rocks, std::uint64_t all) {
    const auto [found, is_new] = known_.try_emplace({rocks, all});
    if (is_new) found->second = share_of(rocks, all, confidence_);
    return found->second;
  }

 private:
  double confidence_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::optional<RockShare>> known_;
};

/// All kits of the plan, by height and energy.
Json kits_json(const LineAnswer& answer) {
  const DesignPlan& plan = answer.plan;
  const std::uint64_t crossing = answer.crossings.size();
  Shares shares(plan.confidence);
  Json energies = Json::array(), stopped = Json::array(), share = Json::array(), low = Json::array(),
       high = Json::array();
  for (const double energy : plan.energies) energies.push_back(energy / 1000);
  for (std::size_t h = 0; h < plan.heights.size(); ++h) {
    Json counts = Json::array(), values = Json::array(), lows = Json::array(), highs = Json::array();
    for (std::size_t e = 0; e < plan.energies.size(); ++e) {
      const std::uint64_t caught = answer.demands.caught(h, e);
      counts.push_back(caught);
      const auto& of_all = shares.of(caught, crossing);
      values.push_back(of_all ? Json(of_all->value) : Json());
      lows.push_back(of_all ? Json(of_all->low) : Json());
      highs.push_back(of_all ? Json(of_all->high) : Json());
    }
    stopped.push_back(std::move(counts));
    share.push_back(std::move(values));
    low.push_back(std::move(lows));
    high.push_back(std::move(highs));
  }
  return {{"heights_m", plan.heights},     {"energies_kJ", std::move(energies)},
          {"stopped", std::move(stopped)}, {"share", std::move(share)},
          {"low", std::move(low)},         {"high", std::move(high)}};
}

std::string percent(double share) { return fmt::format("{:.1f} %", rounded_percents(share)); }
std::string percents(double low, double high) {
  return fmt::format("{:.1f} to {:.1f} %", rounded_percents(low), rounded_percents(high));
}

Json kit_json(const LineAnswer& answer, const KitSize& size) {
  const KitAnswer kit = judge_kit(answer, size.height, size.maximum_energy);
  const std::string name = fmt::format("{:g} m and {} kJ", kit.height, three_digits(kit.maximum_energy / 1000));
  std::string text = fmt::format("{}: no rock crosses here", name);
  if (kit.stopped) {
    text = fmt::format("{} here stop {} ({}) of the rocks that cross", name, percent(kit.stopped->value),
                       percents(kit.stopped->low, kit.stopped->high));
  }
  return {{"height_m", kit.height},
          {"energy_kJ", kit.maximum_energy / 1000},
          {"class", optional_json(kit_class_of(kit.maximum_energy))},
          {"stopped", kit.stopped ? kit.stopped->rocks : 0},
          {"of", answer.crossings.size()},
          {"share", share_json(kit.stopped)},
          {"above", kit.above},
          {"through", kit.through},
          {"text", std::move(text)}};
}

/// The design percentile of a quantity over the whole line; nullopt if no rock crosses.
std::optional<Estimate> design_estimate(const LineAnswer& answer, CrossingQuantity quantity) {
  if (answer.crossings.empty()) return std::nullopt;
  QuantileSketch sketch(answer.crossings.size());
  for (const CrossingRock& crossing : answer.crossings) sketch.add(crossing.at.of(quantity));
  return RankedValues(sketch).estimate(answer.plan.design_percentile / 100, answer.plan.confidence);
}

CrossingQuantity checked_energy(const DesignPlan& plan) {
  return plan.factors.takes_total_energy ? CrossingQuantity::energy_total : CrossingQuantity::energy_translational;
}

/// "1,100 to 1,420 kJ"; with few rocks "from 1,100 kJ, no upper end".
std::string interval_text(const Estimate& estimate, double unit, const char* name) {
  const auto number = [&](double value) { return three_digits(value / unit); };
  if (estimate.low && estimate.high)
    return fmt::format("{} to {} {}", number(*estimate.low), number(*estimate.high), name);
  if (estimate.low) return fmt::format("from {} {}, no upper end", number(*estimate.low), name);
  if (estimate.high) return fmt::format("up to {} {}, no lower end", number(*estimate.high), name);
  return "too few rocks";
}

Json estimate_json(const std::optional<Estimate>& estimate) {
  if (!estimate) return nullptr;
  return {estimate->value, optional_json(estimate->low), optional_json(estimate->high)};
}

/// The numbers that a card shows.
Json numbers_json(const LineAnswer& answer) {
  return {{"energy_J", estimate_json(design_estimate(answer, checked_energy(answer.plan)))},
          {"height_m", estimate_json(design_estimate(answer, CrossingQuantity::height))},
          {"velocity_m_s", estimate_json(design_estimate(answer, CrossingQuantity::velocity))}};
}

/// The texts of a card. All are empty if no rock crosses, but for the share.
Json card_json(const LineAnswer& answer) {
  Json card = Json::object();
  const auto& share = answer.result.whole.share;
  card["share"] = share ? percent(share->value) : "";
  card["share_interval"] = share ? percents(share->low, share->high) : "";
  struct Shown {
    const char* key;
    CrossingQuantity quantity;
    double unit;
    const char* name;
  };
  for (const Shown& shown :
       {Shown{"energy", checked_energy(answer.plan), 1000, "kJ"}, Shown{"height", CrossingQuantity::height, 1, "m"},
        Shown{"velocity", CrossingQuantity::velocity, 1, "m/s"}}) {
    const auto estimate = design_estimate(answer, shown.quantity);
    card[shown.key] = estimate ? fmt::format("{} {}", three_digits(estimate->value / shown.unit), shown.name) : "";
    card[fmt::format("{}_interval", shown.key)] = estimate ? interval_text(*estimate, shown.unit, shown.name) : "";
  }
  card["needs"] = demand_text(answer.result.whole.demand);
  card["needs_at_upper_end"] = demand_text(answer.result.whole.demand_at_upper_end);
  return card;
}

Json figures_with_maxima(const LineAnswer& answer, const DesignFigures& figures,
                         std::optional<std::uint32_t> section = {}) {
  Json json = figures_json(answer.plan, figures);
  json["maxima"] = maxima_json(answer.maxima(section));
  return json;
}

}  // namespace

double rounded_percents(double share) {
  constexpr double by_rounding = 1e-9;  // of shares of rocks, whose halves are seldom exact numbers
  return std::floor(1000 * share + 0.5 + by_rounding) / 10;
}

std::string three_digits(double value) {
  const double size = std::abs(value);
  if (size >= 999.5)
    return fmt::format("{}{}", value < 0 ? "-" : "", grouped(static_cast<std::uint64_t>(std::llround(size))));
  if (size >= 99.95) return fmt::format("{:.0f}", value);
  if (size >= 9.995) return fmt::format("{:.1f}", value);
  return fmt::format("{:.2f}", value);
}

std::string demand_text(const std::optional<KitDemand>& demand) {
  if (!demand) return {};
  return fmt::format("class {}: {} kJ, {} m", demand->kit_class, three_digits(demand->maximum_energy / 1000),
                     three_digits(demand->height));
}

Json places_json(const Model& model, const std::vector<Vec3>& places) {
  Json json = Json::array();
  for (const Vec3& place : places) {
    const Vec3 p = model.frame.global_from_local(place);
    json.push_back({p.x(), p.y(), p.z()});
  }
  return json;
}

Json maxima_json(const std::optional<CrossingMaxima>& maxima) {
  if (!maxima) return nullptr;
  Json json = Json::object();
  for (std::size_t q = 0; q < shown_quantity_count; ++q) json[key_of(design_quantities[q])] = (*maxima)[q];
  return json;
}

Json enough_json(const LineAnswer& answer, double precision) {
  const std::uint64_t crossing = answer.crossings.size();
  struct Wanted {
    const char* key;
    RunFigure figure;
    std::optional<Estimate> estimate;
    std::uint64_t values;
  };
  const double percentile = answer.plan.design_percentile;
  std::vector<Wanted> wanted;
  if (const auto& share = answer.result.whole.share)
    wanted.push_back({"share", {FigureOf::share, 0, 0}, Estimate{share->value, share->low, share->high}, answer.rocks});
  wanted.push_back(
      {"energy", {FigureOf::energy, percentile, 0}, design_estimate(answer, checked_energy(answer.plan)), crossing});
  wanted.push_back(
      {"velocity", {FigureOf::velocity, percentile, 0}, design_estimate(answer, CrossingQuantity::velocity), crossing});
  wanted.push_back(
      {"height", {FigureOf::height, percentile, 0}, design_estimate(answer, CrossingQuantity::height), crossing});
  Json json{{"precision", precision}};
  std::optional<std::uint64_t> most;
  for (const Wanted& each : wanted) {
    std::optional<std::uint64_t> needed;
    if (each.estimate) {
      needed = rocks_needed(each.figure, *each.estimate, answer.rocks, each.values, answer.plan.confidence, precision);
    }
    json[each.key] = {{"is_enough", needed && *needed <= answer.rocks}, {"rocks", optional_json(needed)}};
    if (needed) most = std::max(most.value_or(0), *needed);
  }
  json["rocks"] = optional_json(most);
  std::string text;
  if (crossing == 0) {
    text = fmt::format("None of {} rocks crosses: more rocks would show rarer ones", grouped(answer.rocks));
  } else if (most && *most > answer.rocks) {
    text = fmt::format("{} rocks would bring all intervals within {:g} % (now {})", grouped(*most), 100 * precision,
                       grouped(answer.rocks));
  }
  json["text"] = std::move(text);
  return json;
}

Json sources_json(const StoredSources& sources, const std::vector<std::uint64_t>& rocks,
                  const std::optional<std::vector<std::uint64_t>>& clearing, double confidence) {
  std::map<std::size_t, std::array<std::uint64_t, 2>> counts;  // by spot
  for (const std::uint64_t rock : rocks) ++counts[sources.spots.of_rock(rock)][0];
  if (clearing) {
    for (const std::uint64_t rock : *clearing) ++counts[sources.spots.of_rock(rock)][1];
  }
  Shares shares(confidence);
  Json json{{"release", Json::array()}, {"rocks", Json::array()}, {"crossing", Json::array()}};
  if (clearing) json["clearing"] = Json::array();
  for (const char* key : {"share", "low", "high"}) json[key] = Json::array();
  for (const auto& [spot, count] : counts) {
    json["release"].push_back(spot);
    json["rocks"].push_back(sources.stored[spot]);
    json["crossing"].push_back(count[0]);
    if (clearing) json["clearing"].push_back(count[1]);
    const auto& share = shares.of(count[clearing ? 1 : 0], sources.stored[spot]);
    json["share"].push_back(share->value);
    json["low"].push_back(share->low);
    json["high"].push_back(share->high);
  }
  return json;
}

Json short_line_json(const Model& model, const AskedLine& line, const LineAnswer& answer) {
  return {{"length_m", answer.plan.lines.front().length},
          {"foot", places_json(model, foot_of(line.barrier))},
          {"whole", figures_with_maxima(answer, answer.result.whole)}};
}

Json line_json(const Model& model, const AskedLine& line, const LineAnswer& answer, const StoredSources& sources,
               const AnswerOptions& options) {
  const DesignPlan& plan = answer.plan;
  Json json{{"kind", !line.of_model              ? "line"
                     : line.barrier.is_collector ? "collector"
                                                 : "barrier"},
            {"name", line.barrier.name},
            {"length_m", plan.lines.front().length},
            {"from_m", plan.lines.front().start},
            {"foot", places_json(model, foot_of(line.barrier))},
            {"standard", plan.standard.empty() ? Json() : Json(plan.standard)},
            {"factors", factors_json(plan.factors)},
            {"applied_factors", applied_json(plan.applied)},
            {"design_percentile", plan.design_percentile},
            {"confidence", plan.confidence},
            {"design", numbers_json(answer)},
            {"whole", figures_with_maxima(answer, answer.result.whole)},
            {"sections", Json::array()}};
  for (std::uint32_t s = 0; s < answer.result.sections.size(); ++s)
    json["sections"].push_back(figures_with_maxima(answer, answer.result.sections[s], s));
  json["worst"] = nullptr;
  if (const auto worst = answer.worst_section()) {
    const DesignFigures& figures = answer.result.sections[*worst];
    json["worst"] = {{"section", *worst}, {"from_m", figures.from}, {"to_m", figures.to}};
  }
  json["kits"] = kits_json(answer);
  json["kit"] = options.kit ? kit_json(answer, *options.kit) : Json();
  json["enough"] = enough_json(answer, options.precision);
  json["card"] = card_json(answer);
  std::vector<std::uint64_t> rocks;
  std::optional<std::vector<std::uint64_t>> clearing;
  if (options.kit) clearing.emplace();
  for (const CrossingRock& crossing : answer.crossings) {
    rocks.push_back(crossing.rock);
    if (clearing && !stops(options.kit->height, options.kit->maximum_energy, crossing.at))
      clearing->push_back(crossing.rock);
  }
  if (options.wants_sources) json["sources"] = sources_json(sources, rocks, clearing, plan.confidence);
  return json;
}

}  // namespace talus
