#include "talus/campaign/simulate.hpp"

#include <algorithm>
#include <array>
#include <variant>

#include "talus/campaign/own_section.hpp"
#include "talus/campaign/rock_release.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus {

namespace {

/// A rock in progress, and everything that its run refers to.
template <class Surface>
class RockInProgress {
 public:
  RockLog log{false};
  RockRecord record;

  /// `on_plan`: the index of the model's barriers.
  void begin(const Model& model, const Surface& surface, const PlanIndex& on_plan, std::uint64_t rock) {
    record = {};
    record.rock = rock;
    log.clear();
    const Seeder& seeder = seeder_of(model, rock);
    draws_.emplace(SamplingPlan{model.seed, model.sampling, seeder.first_rock, seeder.rocks}, rock);
    if constexpr (std::is_same_v<Surface, Profile>) {
      if (model.varying) {
        if (section_of_ != &model) section_.emplace(model, model.barriers);  // the barriers of ensembles differ
        section_of_ = &model;
        section_->move_for(model, rock);
        start(model, section_->profile(), {section_->barriers(), on_plan}, seeder);
        return;
      }
    }
    start(model, surface, {model.barriers, on_plan}, seeder);
  }
  [[nodiscard]] RockRun<Surface>& run() { return *run_; }

 private:
  void start(const Model& model, const Surface& surface, const BarrierList& barriers, const Seeder& seeder) {
    const Release release = release_of(model, surface, *draws_, seeder, record, shape_);
    run_.emplace(Scene<Surface>{surface, model.ground, barriers, model.laws}, release, *draws_, log);
  }

  std::optional<Draws> draws_;
  RockShape shape_;  // if only this rock has it
  std::optional<OwnSection> section_;
  const Model* section_of_ = nullptr;
  std::optional<RockRun<Surface>> run_;
};

/// Several rocks in progress. Those that glide are stepped together, in lanes.
template <class Surface>
class RocksInProgress {
 public:
  RocksInProgress(const Model& model, const Surface& surface)
      : model_(model),
        surface_(surface),
        on_plan_(index_of(model.barriers)),
        lanes_(RockRun<Surface>::glide_laws(model.laws)) {}

  /// Returns the end of the range of rocks passed to the order's `see`.
  std::uint64_t follow(const SimulationOrder& order) {
    next_ = seen_ = order.rocks.first;
    while (seen_ < order.rocks.last && !was_stopped_) {
      if (order.stop != nullptr && order.stop->is_requested()) break;
      if (!lanes_.is_full() && ready_count_ > 0) {
        advance(order, ready_[--ready_count_]);
      } else if (!lanes_.is_full() && next_ < order.rocks.last && next_ - seen_ < rocks_.size()) {
        const std::uint64_t number = order.numbers.empty() ? next_ : order.numbers[next_];
        const std::size_t place = next_ % rocks_.size();
        RockInProgress<Surface>& rock = rocks_[place];
        rock.log.keep_rows(order.keep_rows(number));
        rock.log.keep_pieces(order.keep_pieces);
        rock.log.keep_impacts(order.keep_impacts && order.keep_impacts(number));
        rock.begin(model_.of_rock(number), surface_, on_plan_, number);
        ++next_;
        is_done_[place] = false;
        advance(order, place);
      } else {
        lanes_.run(order.stop, [&](std::size_t place) { ready_[ready_count_++] = place; });
      }
    }
    return seen_;
  }

 private:
  void advance(const SimulationOrder& order, std::size_t place) {
    RockRun<Surface>& run = rocks_[place].run();
    const auto pause = run.advance(order.stop);
    was_stopped_ = pause == RockRun<Surface>::Pause::stopped;
    if (was_stopped_) return;
    if (pause == RockRun<Surface>::Pause::gliding) {
      lanes_.add(run.glide(), run.glide_trace(), place);
      return;
    }
    RockRecord& record = rocks_[place].record;
    record.outcome = run.outcome();
    if (record.block) record.block->short_axis_share = rocks_[place].log.spin_axis.share();
    is_done_[place] = true;
    for (; seen_ < next_ && is_done_[seen_ % rocks_.size()]; ++seen_) {
      const RockInProgress<Surface>& rock = rocks_[seen_ % rocks_.size()];
      order.see(rock.record, rock.log);
    }
  }

  // Enough to fill the lanes although finished rocks wait for slower ones before them.
  static constexpr std::size_t slots = 32;

  const Model& model_;
  const Surface& surface_;
  PlanIndex on_plan_;  // of the barriers
  GlideLanes lanes_;
  std::array<RockInProgress<Surface>, slots> rocks_;  // rock n of the order has place n modulo their number
  std::array<bool, slots> is_done_{};
  std::array<std::size_t, slots> ready_{};  // whose glide has ended
  std::size_t ready_count_ = 0;
  bool was_stopped_ = false;           // then this object must not be used again
  std::uint64_t next_ = 0, seen_ = 0;  // of the order: the first not yet started, and the first not yet passed on
};

}  // namespace

namespace {

/// A rock that is only released.
struct Released {
  RockShape own;  // if only this rock has it
  Release release;
};

void release_into(Released& released, const Model& whole, std::uint64_t rock) {
  const Model& model = whole.of_rock(rock);
  const Seeder& seeder = seeder_of(model, rock);
  const Draws draws({model.seed, model.sampling, seeder.first_rock, seeder.rocks}, rock);
  RockRecord record;
  std::visit(
      [&](const auto& surface) { released.release = release_of(model, surface, draws, seeder, record, released.own); },
      *whole.surface);
}

}  // namespace

Vec3 start_of(const Model& model, std::uint64_t rock) {
  Released released;
  release_into(released, model, rock);
  return released.release.motion.position;
}

bool has_blocks(const Model& model) {
  return std::ranges::any_of(model.seeders, [](const Seeder& seeder) { return !seeder.shapes->kinds.empty(); });
}

std::optional<RockBlock> block_of(const Model& model, std::uint64_t rock) {
  Released released;
  release_into(released, model, rock);
  const auto& [own, release] = released;
  if (release.shape == nullptr) return std::nullopt;
  const Body body = body_of(*release.shape, release.rock);
  RockBlock block{{}, release.shape->triangles, body.inertia};
  for (const Vec3& corner : body.corners) block.corners.push_back(body.scale * corner);
  return block;
}

/// The rocks in progress, for the model's kind of surface.
class Simulator::Rocks {
 public:
  Rocks(const Model& model, const ModelSurface& surface) : model_(model), surface_(surface) { begin(); }
  std::uint64_t follow(const SimulationOrder& order) {
    const std::uint64_t next = std::visit(
        [&]<class Each>(Each& rocks) {
          if constexpr (std::is_same_v<Each, std::monostate>)
            return order.rocks.first;
          else
            return rocks.follow(order);
        },
        in_progress_);
    if (next < order.rocks.last) begin();  // drops the rocks in progress
    return next;
  }

 private:
  void begin() {
    std::visit(
        [&]<class Surface>(const Surface& surface) { in_progress_.emplace<RocksInProgress<Surface>>(model_, surface); },
        surface_);
  }

  const Model& model_;
  const ModelSurface& surface_;
  std::variant<std::monostate, RocksInProgress<Profile>, RocksInProgress<TriangleMesh>, RocksInProgress<RasterSurface>>
      in_progress_;
};

Simulator::Simulator(const Model& model) : Simulator(model, *model.surface) {}
Simulator::Simulator(const Model& model, const ModelSurface& surface)
    : rocks_(std::make_unique<Rocks>(model, surface)) {}
Simulator::~Simulator() = default;
Simulator::Simulator(Simulator&&) noexcept = default;

std::uint64_t Simulator::simulate(const SimulationOrder& order) { return rocks_->follow(order); }

RockRecord Simulator::simulate(std::uint64_t rock, bool keep_rows, bool keep_pieces, bool keep_impacts) {
  RockRecord record;
  const std::uint64_t next = rocks_->follow({{rock, rock + 1},
                                             {},
                                             [keep_rows](std::uint64_t) { return keep_rows; },
                                             [keep_impacts](std::uint64_t) { return keep_impacts; },
                                             keep_pieces,
                                             [&](const RockRecord& seen, const RockLog& log) {
                                               record = seen;
                                               log_ = log;
                                             },
                                             StopScope::current()});
  if (next == rock) throw Stopped{};
  return record;
}

}  // namespace talus
