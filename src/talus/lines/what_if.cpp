#include "talus/lines/what_if.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <compare>
#include <ranges>
#include <utility>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/core/stop.hpp"
#include "talus/lines/line_answer.hpp"
#include "talus/lines/line_follower.hpp"
#include "talus/lines/varied_models.hpp"
#include "talus/model/samples.hpp"
#include "talus/results/summary.hpp"
#include "talus/store/rock_choice.hpp"

namespace talus::what_if {

namespace {

/// Rocks that a thread simulates in one go with one set of values: enough to fill the lanes of glides.
constexpr std::uint64_t rocks_in_task = 64;
/// Rocks by which the speed is first measured.
constexpr std::uint64_t first_rocks = 16;

/// Replicas of a bootstrap of so many rocks: at most `wanted`, fewer where they would take seconds and the intervals
/// are narrow.
std::size_t affordable_replicas(std::size_t wanted, std::size_t rocks) {
  constexpr std::size_t draws = 40'000'000, least = 200;
  return std::min(wanted, std::max(least, draws / std::max<std::size_t>(rocks, 1)));
}

MemberValues values_of(std::uint64_t place, const CrossingMaxima& values) {
  const auto of = [&](CrossingQuantity quantity) { return values[static_cast<std::size_t>(quantity)]; };
  return {place,
          {of(CrossingQuantity::energy_translational), of(CrossingQuantity::energy_total), of(CrossingQuantity::height),
           of(CrossingQuantity::velocity)}};
}

/// A path for a picture: the ends of its pieces, and places of a flight in between.
std::vector<Vec3> drawn_path(const RockLog& log) {
  constexpr int parts_of_flight = 8;
  std::vector<Vec3> points;
  log.for_each_piece([&](const PathPiece& piece) {
    if (points.empty()) points.push_back(piece.path.at(0));
    const int parts = piece.on_ground ? 1 : parts_of_flight;
    for (int k = 1; k <= parts; ++k) points.push_back(piece.path.at(piece.duration * k / parts));
  });
  return points;
}

/// What a rock of one set does at the line or in the polygon; each thread has its own.
class Asker {
 public:
  Asker(const Model& model, const AskedPlace& place, const AskedBarriers& barriers, const DesignPlan& plan)
      : model_(model), place_(place), number_(barriers.numbers.empty() ? 0 : barriers.numbers.front()), plan_(plan) {
    if (std::holds_alternative<AskedLine>(place)) follower_.emplace(model, barriers);
  }

  /// Nullopt if it does not cross or enter.
  std::optional<CrossingMaxima> ask(const RockRecord& record, const RockLog& log) {
    if (std::holds_alternative<std::monostate>(place_)) return std::nullopt;
    path_.record = record;
    path_.pieces.clear();
    log.for_each_piece([&](const PathPiece& piece) { path_.pieces.push_back(piece); });
    if (!follower_) {
      const auto inside = rock_inside(model_, std::get<AskedArea>(place_), path_);
      return inside ? std::optional(inside->maxima) : std::nullopt;
    }
    const Passage* const crossing = first_passage(follower_->follow(path_), number_);
    if (crossing == nullptr) return std::nullopt;
    return line_crossing(plan_, plan_.lines.front(), record.body, *crossing).values;
  }

 private:
  const Model& model_;
  const AskedPlace& place_;
  const std::uint32_t number_;
  const DesignPlan& plan_;
  std::optional<LineFollower> follower_;
  RockPath path_;
};

/// The first rocks of a model in the order in which a store keeps them.
std::vector<std::uint64_t> rocks_in_order(const Model& model, std::uint64_t most) {
  struct Placed {
    std::uint64_t place, rock;
    auto operator<=>(const Placed&) const = default;
  };
  std::vector<Placed> first;
  for (std::uint64_t rock = 0; rock < model.rocks(); ++rock) {
    stop_point(rock);
    first.push_back({place_in_choice(model.seed, rock), rock});
    if (first.size() < 2 * most + 1024) continue;  // memory does not grow with the model's rocks
    std::ranges::nth_element(first, first.begin() + static_cast<std::ptrdiff_t>(most));
    first.resize(most);
  }
  std::ranges::sort(first);
  std::vector<std::uint64_t> rocks;
  for (std::uint64_t k = 0; k < std::min<std::uint64_t>(most, first.size()); ++k) rocks.push_back(first[k].rock);
  return rocks;
}

}  // namespace

/// Where a rock ends.
struct RockEnd {
  double runout = 0;  // on plan [m]
  bool has_left = false;
};

std::optional<Estimate> estimate_of(const std::optional<RockShare>& share) {
  return share ? std::optional(Estimate{share->value, share->low, share->high}) : std::nullopt;
}

bool are_apart(const Estimate& one, const Estimate& other) {
  const auto low = [](const Estimate& of) { return of.low.value_or(of.value / 2); };
  const auto high = [](const Estimate& of) { return of.high.value_or(2 * of.value); };
  return low(one) > high(other) || low(other) > high(one);
}

struct WhatIf::Parts {
  const Model& model;
  RockModel rock_model{};
  AskedPlace place;
  AskedBarriers barriers;
  DesignPlan plan;
  std::vector<Variation> variations;
  std::vector<Model> models;                      // of the project's own values, and of the variations
  std::vector<std::uint64_t> rocks;               // in the order in which they are taken
  std::uint64_t done = 0;                         // of these, by all sets
  std::vector<std::vector<MemberValues>> of_set;  // of the rocks that cross, by their place in `rocks`, ascending
  std::vector<std::vector<double>> kit_heights;   // of these rocks at a line: of the kit that each needs [m]
  std::vector<std::vector<RockEnd>> ends;         // of each set, of all rocks that are done
  std::vector<Paths> paths;                       // of each set

  static std::vector<AskedLine> lines_of(const AskedPlace& place) {
    const auto* line = std::get_if<AskedLine>(&place);
    return line != nullptr ? std::vector{*line} : std::vector<AskedLine>{};
  }

  Parts(const Model& of, AskedPlace asked, const project::DesignBasis& basis)
      : model(of), place(std::move(asked)), barriers(of, lines_of(place)), plan(project::design_check(basis)) {
    if (const auto* line = std::get_if<AskedLine>(&place))
      plan = plan_of_line(basis, model, *line, barriers.numbers.front());
  }

  [[nodiscard]] Figures figures(std::size_t set) const {
    const std::vector<MemberValues>& crossing = of_set[set];
    Figures figures{.rocks = crossing.size(),
                    .share = {},
                    .percentile = {},
                    .demand = {},
                    .demand_at_upper_end = {},
                    .runout_median = {},
                    .runout = {},
                    .left = share_of(std::ranges::count(ends[set], true, &RockEnd::has_left), done, plan.confidence)};
    if (!std::holds_alternative<std::monostate>(place))
      figures.share = share_of(crossing.size(), done, plan.confidence);
    if (done > 0) {
      QuantileSketch runouts(done);
      for (const RockEnd& end : ends[set]) runouts.add(end.runout);
      const RankedValues ranked(runouts);
      figures.runout_median = ranked.estimate(0.5, plan.confidence);
      figures.runout = ranked.estimate(plan.design_percentile / 100, plan.confidence);
    }
    if (crossing.empty()) return figures;
    const auto design_percentile = [&](const auto& values) {
      QuantileSketch sketch(crossing.size());
      for (const double value : values) sketch.add(value);
      return RankedValues(sketch).estimate(plan.design_percentile / 100, plan.confidence);
    };
    for (std::size_t q = 0; q < MemberValues::quantities; ++q) {
      figures.percentile[q] =
          design_percentile(std::views::transform(crossing, [q](const MemberValues& each) { return each.values[q]; }));
    }
    if (!std::holds_alternative<AskedLine>(place)) return figures;
    const auto of = [&](Asked quantity) { return *figures.percentile[place_of(quantity)]; };
    const CheckedFigures checked{of(Asked::energy_translational), of(Asked::energy_total), of(Asked::velocity),
                                 design_percentile(kit_heights[set])};
    figures.demand = demand_of(plan.factors, checked);
    figures.demand_at_upper_end = demand_at_upper_end(plan.factors, checked);
    return figures;
  }

  [[nodiscard]] Differences differences(std::size_t set, const Figures& before, const Figures& after,
                                        std::size_t replicas) const {
    Differences found;
    if (done == 0) return found;
    const std::vector<MemberValues>&without = of_set.front(), &with = of_set[set];
    std::uint64_t both = 0;
    for (std::size_t i = 0, k = 0; i < without.size() && k < with.size();) {
      const std::uint64_t one = without[i].member, other = with[k].member;
      both += one == other ? 1 : 0;
      i += one <= other ? 1 : 0;
      k += other <= one ? 1 : 0;
    }
    found.gained = with.size() - both;
    found.lost = without.size() - both;
    found.share = paired_share_difference(found.gained, found.lost, done, plan.confidence);
    const auto quantiles =
        paired_quantile_differences(without, with, plan.design_percentile / 100,
                                    {.replicas = affordable_replicas(replicas, without.size() + found.gained),
                                     .confidence = plan.confidence,
                                     .seed = model.seed});
    for (std::size_t q = 0; quantiles && q < quantiles->size(); ++q) {
      found.percentile[q] = (*quantiles)[q];
      // With few values the figures are not the plain quantiles (RankedValues): the difference is that of the figures.
      if (!found.percentile[q]->low)
        found.percentile[q]->value = after.percentile[q]->value - before.percentile[q]->value;
    }
    return found;
  }
};

WhatIf::WhatIf(const project::Project& project, const Model& model, const project::DesignBasis& basis, AskedPlace place,
               const FactorChoice& choice, std::string_view where, Problems& warnings)
    : parts_(std::make_unique<Parts>(model, std::move(place), basis)) {
  Problems known;  // the model has been built with them
  const project::Project with_samples = project::read_samples(project, known);
  parts_->rock_model = project.analysis.model;
  parts_->variations = variations_of(with_samples, choice, where, warnings);
  parts_->models = varied_models(with_samples, model, parts_->variations, choice.material);
  const std::size_t sets = parts_->models.size();
  parts_->of_set.resize(sets);
  parts_->kit_heights.resize(sets);
  parts_->ends.resize(sets);
  parts_->paths.resize(sets);
}
WhatIf::~WhatIf() = default;

const std::vector<Variation>& WhatIf::variations() const { return parts_->variations; }
const AskedPlace& WhatIf::place() const { return parts_->place; }
const Model& WhatIf::model() const { return parts_->model; }
RockModel WhatIf::rock_model() const { return parts_->rock_model; }
const std::vector<Paths>& WhatIf::paths() const { return parts_->paths; }
std::vector<double> WhatIf::runouts(std::size_t set) const {
  std::vector<double> runouts;
  for (const RockEnd& end : parts_->ends[set]) runouts.push_back(end.runout);
  std::ranges::sort(runouts);
  return runouts;
}
double WhatIf::confidence() const { return parts_->plan.confidence; }
double WhatIf::percentile() const { return parts_->plan.design_percentile; }
const std::string& WhatIf::standard() const { return parts_->plan.standard; }
bool WhatIf::takes_total_energy() const { return parts_->plan.factors.takes_total_energy; }

bool WhatIf::run(const RunOptions& options) {
  Parts& parts = *parts_;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads_for(options.threads)));
  parts.rocks = rocks_in_order(parts.model, std::min(options.rocks, parts.model.rocks()));
  const std::uint64_t most = parts.rocks.size();
  const std::size_t sets = parts.models.size();

  struct Worker {  // by set
    std::vector<std::unique_ptr<Asker>> askers;
    std::vector<std::unique_ptr<Simulator>> simulators;
  };
  tbb::enumerable_thread_specific<Worker> workers([&] {
    Worker worker;
    worker.askers.resize(sets);
    worker.simulators.resize(sets);
    return worker;
  });
  const StopScope* const scope = StopScope::current();
  std::atomic<bool> was_stopped{false};

  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  const Clock::time_point begin = Clock::now();
  double rate = 0;  // rocks of all sets per second, of the last wave
  while (parts.done < most) {
    // A wave is short enough to tell the progress, and at first to measure the speed.
    constexpr double seconds_of_wave = 1;
    std::uint64_t wave = std::max(first_rocks, static_cast<std::uint64_t>(rate * seconds_of_wave));
    wave = std::min({wave, most - parts.done, 8 * std::max(parts.done, first_rocks)});
    if (options.seconds && rate > 0) {
      const auto in_time = static_cast<std::uint64_t>(rate * std::max(0.0, *options.seconds - seconds_since(begin)));
      if (in_time < std::min(first_rocks, wave)) break;
      wave = std::min(wave, in_time);
    }
    const std::uint64_t blocks = (wave + rocks_in_task - 1) / rocks_in_task;
    struct Found {
      std::vector<MemberValues> crossing;
      std::vector<double> kit_heights;
      std::vector<RockEnd> ends;
      Paths paths;
    };
    std::vector<Found> found(blocks * sets);
    const Clock::time_point wave_begin = Clock::now();
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t task) {
      if (was_stopped.load(std::memory_order_relaxed)) return;
      const StopScope here(scope);
      const std::size_t block = task / sets, set = task % sets;
      Worker& worker = workers.local();
      auto& simulator = worker.simulators[set];
      auto& asker = worker.askers[set];
      if (!simulator) {
        simulator = std::make_unique<Simulator>(parts.models[set], *parts.models[set].surface);
        asker = std::make_unique<Asker>(parts.models[set], parts.place, parts.barriers, parts.plan);
      }
      const std::uint64_t first = parts.done + block * rocks_in_task;
      std::uint64_t place = first;
      SimulationOrder order;
      order.rocks = {first, std::min(first + rocks_in_task, parts.done + wave)};
      order.numbers = parts.rocks;
      order.keep_rows = [](std::uint64_t) { return false; };
      order.keep_pieces = true;
      order.see = [&](const RockRecord& record, const RockLog& log) {
        Found& here = found[task];
        here.ends.push_back({talus::runout(record.outcome, parts.model.runout_frame).plan,
                             record.outcome.reason == EndReason::left_model});
        if (place < options.pictured) here.paths.push_back(drawn_path(log));
        if (const auto values = asker->ask(record, log)) {
          here.crossing.push_back(values_of(place, *values));
          here.kit_heights.push_back((*values)[static_cast<std::size_t>(CrossingQuantity::needed_height)]);
        }
        ++place;
      };
      order.stop = StopScope::current();
      if (simulator->simulate(order) < order.rocks.last) was_stopped = true;
    });
    if (was_stopped) return false;
    for (std::size_t task = 0; task < found.size(); ++task) {
      const std::size_t set = task % sets;
      const auto append = [](auto& all, auto& more) {
        all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
      };
      append(parts.of_set[set], found[task].crossing);
      append(parts.kit_heights[set], found[task].kit_heights);
      append(parts.ends[set], found[task].ends);
      append(parts.paths[set], found[task].paths);
    }
    parts.done += wave;
    rate = static_cast<double>(wave) / std::max(seconds_since(wave_begin), 1e-6);
    if (options.progress) {
      std::uint64_t planned = most;
      if (options.seconds) {
        const double left = rate * std::max(0.0, *options.seconds - seconds_since(begin));
        planned =
            left < static_cast<double>(most) ? std::min(most, parts.done + static_cast<std::uint64_t>(left)) : most;
      }
      options.progress(parts.done, planned);
    }
  }
  return true;
}

Answer WhatIf::answer(std::size_t replicas) const {
  const Parts& parts = *parts_;
  Answer answer{.rocks = parts.done, .planned = parts.model.rocks(), .base = parts.figures(0), .variations = {}};
  answer.variations.resize(parts.variations.size());
  const StopScope* const scope = StopScope::current();
  std::atomic<bool> was_stopped{false};
  tbb::parallel_for(std::size_t{0}, answer.variations.size(), [&](std::size_t k) {
    const StopScope here(scope);
    try {
      Answer::Varied& varied = answer.variations[k];
      varied.figures = parts.figures(k + 1);
      varied.differences = parts.differences(k + 1, answer.base, varied.figures, replicas);
    } catch (const Stopped&) {
      was_stopped = true;
    }
  });
  if (was_stopped) throw Stopped{};
  return answer;
}

}  // namespace talus::what_if
