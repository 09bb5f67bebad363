#include "talus/run/other_model.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/core/stop.hpp"
#include "talus/model/model.hpp"
#include "talus/model/rock_models.hpp"
#include "talus/model/samples.hpp"
#include "talus/project/words.hpp"
#include "talus/results/summary.hpp"
#include "talus/rocks/heights.hpp"
#include "talus/statistics/quantile_sketch.hpp"
#include "talus/store/rock_choice.hpp"

namespace talus::project {

namespace {

constexpr std::uint64_t rocks_per_sampled = 20, max_sampled = 200;
constexpr std::uint64_t min_sampled = 72;  // statistics/order_statistics.hpp
constexpr double percentile = 0.95, confidence = 0.95, factor = 2;

struct Values {
  double runout = 0, top = 0;  // [m]
};

/// Of the rocks in their order.
std::vector<Values> values_of(const Model& model, const ModelSurface& surface, std::span<const std::uint64_t> rocks) {
  std::vector<Values> values(rocks.size());
  std::atomic<bool> was_stopped{false};
  const StopScope* const scope = StopScope::current();
  constexpr std::size_t grain = 25;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rocks.size(), grain), [&](const auto& block) {
    const StopScope here(scope);
    Simulator simulator(model, surface);
    std::size_t place = block.begin();
    SimulationOrder order;
    order.rocks = {0, block.size()};
    order.numbers = rocks.subspan(block.begin(), block.size());
    order.keep_rows = [](std::uint64_t) { return false; };
    order.see = [&](const RockRecord& record, const RockLog&) {
      values[place++] = {runout(record.outcome, model.runout_frame).plan,
                         top_over(record.outcome.max_bounce, record.body.radius)};
    };
    order.stop = StopScope::current();
    if (simulator.simulate(order) < block.size()) was_stopped = true;
  });
  if (was_stopped) throw Stopped{};
  return values;
}

ModelFigures figures_of(const std::vector<Values>& values) {
  QuantileSketch runouts(values.size()), tops(values.size());
  for (const auto& [runout, top] : values) {
    runouts.add(runout);
    tops.add(top);
  }
  return {RankedValues(runouts).estimate(percentile, confidence), RankedValues(tops).estimate(percentile, confidence)};
}

std::string text_of(const Estimate& estimate) {
  return fmt::format("{:.3g} m ({:.3g} to {:.3g})", estimate.value, *estimate.low, *estimate.high);
}

}  // namespace

bool disagree(const Estimate& one, const Estimate& other) {
  const auto is_above = [](const Estimate& high, const Estimate& low) {
    return high.low && low.high && *high.low > *low.high && high.value > factor * low.value;
  };
  return is_above(one, other) || is_above(other, one);
}

std::vector<std::uint64_t> fair_sample(std::uint64_t rocks, std::uint64_t sample, std::uint64_t seed) {
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t k = 0; k < sample; ++k) {
    const std::uint64_t first = rocks / sample * k + std::min(k, rocks % sample);
    const std::uint64_t count = rocks / sample + (k < rocks % sample ? 1 : 0);
    if (count > 0) numbers.push_back(first + mixed_bits(seed ^ mixed_bits(k)) % count);
  }
  return numbers;
}

std::optional<ModelComparison> compare_models(const Project& project, const Model& model, int threads) {
  const std::uint64_t sample = std::min(model.rocks() / rocks_per_sampled, max_sampled);
  if (sample < min_sampled || !model.ensembles.empty()) return std::nullopt;
  Problems known;  // the model was built with these samples
  Project with_other = read_samples(project, known);
  RockModel& other = with_other.analysis.model;
  other = other == RockModel::lumped_mass ? RockModel::rigid_sphere : RockModel::lumped_mass;
  if (!materials_of_default_friction(with_other).empty()) return std::nullopt;
  Model by_other = model.without_surface();
  set_properties(with_other, by_other);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads_for(threads)));
  const std::vector<std::uint64_t> rocks = fair_sample(model.rocks(), sample, model.seed);
  return ModelComparison{rocks.size(), other, figures_of(values_of(model, *model.surface, rocks)),
                         figures_of(values_of(by_other, *model.surface, rocks))};
}

void warn_of_other_model(const ModelComparison& found, Problems& warnings) {
  const auto compare = [&](const char* what, const Estimate& own, const Estimate& by_other) {
    if (!disagree(own, by_other)) return;
    warnings.add({.severity = Severity::warning,
                  .where = "[analysis]",
                  .what = fmt::format("model = \"{}\" gives another 95th percentile of {}: {}, not {}",
                                      word(found.other), what, text_of(by_other), text_of(own)),
                  .why = fmt::format("for the same {} rocks, and the blocks are neither points nor spheres: what holds "
                                     "for one model alone needs a reason",
                                     found.rocks),
                  .hint = "Choose by observed rocks (docs/calibration.md), or use the worse of both",
                  .path = "analysis.model",
                  .kind = ProblemKind::models_disagree});
  };
  compare("the runout on plan", found.own.runout, found.by_other.runout);
  compare("the greatest height of the block's top over the ground", found.own.top, found.by_other.top);
}

}  // namespace talus::project
