#include "talus/results/map_observer.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "talus/results/ensemble.hpp"
#include "talus/rocks/energy.hpp"

namespace talus {

namespace {

void raise(float& maximum, double value) {
  // The limit of a fixed-point sum; no rock exceeds it.
  maximum = std::max(maximum, static_cast<float>(std::min(value, FixedSum::largest_term)));
}

double squared_speed(const GlideStep& step) { return step.vx * step.vx + step.vy * step.vy; }

/// A glide's steps on plan.
class GlideOnPlan {
 public:
  explicit GlideOnPlan(const PathPiece& glide)
      : start_(glide.path.p), down_(glide.steps.down), aside_(glide.steps.aside) {}

  [[nodiscard]] bool ends_in(const MapGrid::Borders& cell, const GlideStep& step) const {
    return cell.hold(start_.x() + along(0, step.x, step.y), start_.y() + along(1, step.x, step.y));
  }
  /// Whether it certainly stays between its ends in x and y, and is nowhere faster than at an end. On a plane the
  /// heading of a sliding rock turns towards the pull, by less than half a turn: a coordinate that increases at both
  /// ends increases all the way. The component of the pull along the heading grows with that turn, so that speed is a
  /// convex function of time.
  [[nodiscard]] bool stays_between_ends(std::span<const GlideStep> steps) const {
    const GlideStep &first = steps.front(), &last = steps.back();
    const auto keeps_direction = [&](int axis) {
      return along(axis, first.vx, first.vy) * along(axis, last.vx, last.vy) >= 0;
    };
    return keeps_direction(0) && keeps_direction(1);
  }

 private:
  [[nodiscard]] double along(int axis, double x, double y) const { return x * down_[axis] + y * aside_[axis]; }

  const Vec3 &start_, &down_, &aside_;
};

void raise(MapVisit& visit, const MaxMotion& motion, double height) {
  const auto each = [&]<std::size_t... k>(std::index_sequence<k...>) {
    (raise(visit.maxima[k], value_of(static_cast<MapQuantity>(k), motion, height)), ...);
  };
  each(std::make_index_sequence<map_quantity_count>());
}

}  // namespace

/// Packs the visits of a block's rocks, for the maps when the block is committed.
class MapObserver::Part : public ObserverPart {
 public:
  explicit Part(const MapObserver& of)
      : grid_(of.maps_.front().grid()),
        heights_(of.heights_),
        sources_(of.sources_),
        packer_(of.maps_.front().contents(), of.memory_),
        rocks_(of.maps_.size()) {
    if (!of.of_ensembles().empty()) of_ensembles_.emplace(of.of_ensembles().front().contents(), of.memory_);
  }

  void see(const RockRecord& record, const RockLog& log) override {
    const std::uint32_t map = sources_ > 1 ? record.source.index : 0;
    cells_.begin_rock();
    for (const PathPiece& piece : log.pieces) {
      if (piece.steps.count > 0) {
        glide(log, piece, record.body);
      } else if (leads_anywhere(piece)) {
        follow(piece, record.body);
      }
    }
    // Pieces without length: they belong to a cell that the rock visited.
    for (const PathPiece& piece : log.pieces) {
      if (piece.steps.count > 0 || leads_anywhere(piece)) continue;
      note(visit_at(piece.path.p), piece, record.body);
    }
    for (const Vec3& place : log.impact_places) ++visit_at(place).impacts;
    const EndReason reason = record.outcome.reason;
    MapVisit& last = visit_at(record.outcome.end.position);
    last.is_deposit = reason == EndReason::at_rest || reason == EndReason::stopped_by_barrier;
    ++rocks_[map];
    packer_.add(map, cells_.list());
    if (!of_ensembles_) return;
    const std::size_t own = sources_ + ensemble_of(record.rock, rocks_.size() - sources_);
    ++rocks_[own];
    of_ensembles_->add(static_cast<std::uint32_t>(own), cells_.list());
  }

  [[nodiscard]] std::span<const std::uint64_t> rocks() const { return rocks_; }
  [[nodiscard]] VisitBlock take() { return packer_.take(); }
  [[nodiscard]] VisitBlock take_of_ensembles() { return of_ensembles_ ? of_ensembles_->take() : VisitBlock(); }

 private:
  [[nodiscard]] static bool leads_anywhere(const PathPiece& piece) {
    return (piece.path.at(piece.duration) - piece.path.p).squared_norm() > no_way * no_way;
  }

  void follow(const PathPiece& piece, const Rock& rock) {
    // Most pieces on the ground are steps of a few centimetres: they need no traversal.
    if (piece.on_ground && piece.path.a == Vec3{} && grid_.holds(cell_, piece.path.p) &&
        grid_.holds(cell_, piece.path.at(piece.duration))) {
      note(cells_.at(cell_), piece, rock);
    } else {
      walk_over(piece, rock);
    }
  }

  void walk_over(const PathPiece& piece, const Rock& rock) {
    stays_.clear();
    borders_.assign(1, 0);
    walk(grid_, piece, [&](MapCell cell, double, double leave) {
      stays_.push_back(cell);
      borders_.push_back(leave);
    });
    heights_here_.resize(stays_.size());
    heights_(rock, piece, borders_, heights_here_);
    for (std::size_t k = 0; k < stays_.size(); ++k)
      note(cells_.at(stays_[k]), piece, rock, borders_[k], borders_[k + 1], heights_here_[k]);
    cell_ = stays_.back();
  }

  void note(MapVisit& visit, const PathPiece& piece, const Rock& rock) {
    const std::array<double, 2> ends{0, piece.duration};
    double height = 0;
    heights_(rock, piece, ends, {&height, 1});
    note(visit, piece, rock, 0, piece.duration, height);
  }
  void note(MapVisit& visit, const PathPiece& piece, const Rock& rock, double enter, double leave, double height) {
    raise(visit, max_motion(piece, rock, enter, leave), height);
  }

  /// The visit to the cell that contains a place. For a place on a border, if the rock was not in that cell: the visit
  /// to a neighbouring cell where it was.
  MapVisit& visit_at(const Vec3& place) {
    const MapCell own = grid_.cell_at(place);
    const MapCell first = grid_.cell_at(place - Vec3(no_way, no_way, 0));
    const MapCell last = grid_.cell_at(place + Vec3(no_way, no_way, 0));
    if (first != last && !cells_.has(own)) {
      for (std::int32_t row = first.row; row <= last.row; ++row) {
        for (std::int32_t column = first.column; column <= last.column; ++column) {
          if (cells_.has({column, row})) return cells_.at({column, row});
        }
      }
    }
    return cells_.at(own);
  }

  /// Most steps of a glide, of a few centimetres each, stay in the cell: only the fastest of them counts.
  void glide(const RockLog& log, const PathPiece& piece, const Rock& rock) {
    const double rotational = rotational_energy(rock, piece.spin);
    const auto steps = std::span(log.glide_steps).subspan(piece.steps.first, piece.steps.count);
    const GlideOnPlan plan(piece);
    MapGrid::Borders cell = grid_.borders(cell_);
    double before = piece.ends.start_velocity.squared_norm();
    double fastest = -1;  // squared [m2/s2], of the steps in this cell that are not yet noted
    const auto note_fastest = [&] {
      if (fastest >= 0) raise_motion(cells_.at(cell_), fastest, rock, rotational);
      fastest = -1;
    };
    bool is_within = cell.hold(piece.path.p.x(), piece.path.p.y());
    if (is_within && plan.stays_between_ends(steps) && plan.ends_in(cell, steps.back())) {
      fastest = std::max({before, squared_speed(steps.front()), squared_speed(steps.back())});
    } else {
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const bool ends_within = plan.ends_in(cell, steps[k]);
        const double after = squared_speed(steps[k]);
        if (is_within && ends_within) {
          fastest = std::max({fastest, before, after});
        } else {
          note_fastest();
          walk_over(log.step_of(piece, k), rock);
          cell = grid_.borders(cell_);
          is_within = plan.ends_in(cell, steps[k]);
        }
        before = after;
      }
    }
    note_fastest();
  }

  static void raise_motion(MapVisit& visit, double squared_velocity, const Rock& rock, double rotational) {
    const double translational = 0.5 * rock.mass * squared_velocity;
    // A glide is a lumped mass's, which has no bounce height on the ground.
    raise(visit, {squared_velocity, translational, translational + rotational}, 0);
  }

  MapGrid grid_;
  const MaxHeights& heights_;
  std::size_t sources_;
  VisitPacker packer_;
  std::optional<VisitPacker> of_ensembles_;
  std::vector<std::uint64_t> rocks_;  // by map
  RockVisits cells_;
  MapCell cell_;  // the last one visited
  // Of the current piece: its cells, the borders between them in its parameter, and the bounce heights.
  std::vector<MapCell> stays_;
  std::vector<double> borders_, heights_here_;
};

MapObserver::MapObserver(const MapGrid& grid, MaxHeights heights, std::optional<std::size_t> sources,
                         const MapContents& contents, std::size_t ensembles, const MapContents& contents_of_ensembles)
    : heights_(std::move(heights)),
      is_split_(sources.has_value()),
      sources_(std::max<std::size_t>(1, sources.value_or(1))) {
  for (std::size_t k = 0; k < sources_; ++k) maps_.emplace_back(grid, contents);
  for (std::size_t k = 0; k < ensembles; ++k) maps_.emplace_back(grid, contents_of_ensembles);
}

std::unique_ptr<ObserverPart> MapObserver::new_part() const { return std::make_unique<Part>(*this); }

void MapObserver::commit(ObserverPart& part) {
  auto& seen = static_cast<Part&>(part);
  total_.reset();
  for (std::size_t k = 0; k < maps_.size(); ++k) maps_[k].add_rocks(seen.rocks()[k]);
  for (VisitBlock& block : std::array{seen.take(), seen.take_of_ensembles()}) {
    if (block.pieces.empty()) continue;
    waiting_bytes_ += block.bytes();
    waiting_.push_back(std::move(block));
  }
  if (waiting_bytes_ >= waiting_limit_) return add_waiting();
  memory_taken_ = bytes_of_maps_ + waiting_bytes_;
}

void MapObserver::add_waiting() {
  std::vector<MapTile*> tiles;
  for (const VisitBlock& block : waiting_) {
    for (const VisitRun& run : block.runs) maps_[run.map].wait(run, tiles);
  }
  talus::add_waiting(tiles);
  for (VisitBlock& block : waiting_) {
    for (const VisitBlock::MoreImpacts& more : block.more_impacts) maps_[more.map].add(more);
    memory_.give_back(std::move(block.pieces));
  }
  waiting_.clear();
  waiting_bytes_ = 0;
  update_memory();
}

void MapObserver::update_memory() {
  std::size_t bytes = 0, bytes_of_ensembles = 0;
  for (const Maps& maps : of_sources()) bytes += maps.bytes();
  for (const Maps& maps : of_ensembles()) bytes_of_ensembles += maps.bytes();
  bytes_of_maps_ = (is_split_ ? 2 * bytes : bytes) + bytes_of_ensembles;
  memory_taken_ = bytes_of_maps_ + waiting_bytes_;
  waiting_limit_ = std::max(least_waiting, (bytes + bytes_of_ensembles) / waiting_part);
  const std::size_t most_waiting = (memory_limit_ - std::min(memory_limit_, bytes_of_maps_)) / most_growth;
  if (waiting_limit_ <= most_waiting) return;
  waiting_limit_ = most_waiting;
  memory_.release();
}

void MapObserver::limit_memory(std::size_t bytes) {
  memory_limit_ = bytes;
  update_memory();
}

void MapObserver::settle() {
  add_waiting();
  memory_.release();
  for (Maps& maps : maps_) maps.settle();
}

void MapObserver::save(ByteWriter& out) {
  settle();
  out.flag(is_split_);
  out.count(sources_);
  out.count(maps_.size() - sources_);
  for (const Maps& maps : maps_) maps.save(out);
}

void MapObserver::merge_saved(ByteReader& in) {
  total_.reset();
  expect_bytes(in.flag() == is_split_ && in.get<std::uint64_t>() == sources_, "maps are split by different sources");
  expect_bytes(in.get<std::uint64_t>() == maps_.size() - sources_, "maps are of other ensembles");
  for (Maps& maps : maps_) maps.merge_saved(in);
  update_memory();
}

const Maps& MapObserver::maps() {
  settle();
  if (!is_split_) return maps_.front();
  if (!total_) {
    total_.emplace(maps_.front().grid(), maps_.front().contents());
    for (const Maps& maps : of_sources()) total_->merge(maps);
    total_->settle();
  }
  return *total_;
}

std::span<const Maps> MapObserver::by_source() {
  settle();
  return is_split_ ? of_sources() : std::span<const Maps>();
}

std::span<const Maps> MapObserver::by_ensemble() {
  settle();
  return of_ensembles();
}

}  // namespace talus
