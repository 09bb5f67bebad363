#include "talus/results/map_observer.hpp"

#include <algorithm>

namespace talus {

namespace {

/// Finds the cells of one rock again, however often it comes back: a hash table by linear probing. A slot holds the
/// place of a visit in the list of all rocks' visits, counted from 1; those of earlier rocks are smaller than the
/// present rock's and count as empty, so that nothing is cleared between rocks.
class VisitedCells {
 public:
  void begin_rock(std::size_t visits_so_far) { before_ = visits_so_far; }

  [[nodiscard]] bool has(MapCell cell, const std::vector<MapVisit>& visits) {
    return !slots_.empty() && find(cell, visits) > before_;
  }

  /// The visit of this rock to a cell, made if there is none.
  MapVisit& visit(MapCell cell, std::vector<MapVisit>& visits) {
    if (visits.size() > before_ && visits[recent_].cell == cell) return visits[recent_];
    if (2 * (visits.size() - before_) >= slots_.size()) grow(visits);
    std::uint32_t& slot = find(cell, visits);
    if (slot <= before_) {
      visits.push_back({cell});
      slot = static_cast<std::uint32_t>(visits.size());
    }
    recent_ = slot - 1;
    return visits[recent_];
  }

 private:
  std::uint32_t& find(MapCell cell, const std::vector<MapVisit>& visits) {
    const auto column = static_cast<std::uint32_t>(cell.column), row = static_cast<std::uint32_t>(cell.row);
    const std::size_t mask = slots_.size() - 1;
    std::size_t k = ((column * 0x9E3779B1U) ^ (row * 0x85EBCA77U)) >> 7 & mask;
    while (slots_[k] > before_ && visits[slots_[k] - 1].cell != cell) k = (k + 1) & mask;
    return slots_[k];
  }
  void grow(const std::vector<MapVisit>& visits) {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
    for (std::size_t k = before_; k < visits.size(); ++k) {
      find(visits[k].cell, visits) = static_cast<std::uint32_t>(k + 1);
    }
  }

  std::size_t before_ = 0, recent_ = 0;
  std::vector<std::uint32_t> slots_;
};

void raise(float& greatest, double value) {
  // What a sum in fixed point can hold; no rock has more.
  greatest = std::max(greatest, static_cast<float>(std::min(value, FixedSum::largest_term)));
}

double squared_speed(const GlideStep& step) { return step.vx * step.vx + step.vy * step.vy; }

/// A glide's steps, seen from above.
class GlideOnPlan {
 public:
  explicit GlideOnPlan(const PathPiece& glide)
      : start_(glide.path.p), down_(glide.steps.down), aside_(glide.steps.aside) {}

  [[nodiscard]] bool ends_in(const MapGrid::Borders& cell, const GlideStep& step) const {
    return cell.hold(start_.x() + along(0, step.x, step.y), start_.y() + along(1, step.x, step.y));
  }
  /// Whether it surely goes no further along x and y than its ends are, and is nowhere faster than there. The heading
  /// of what slides on a plane turns towards the pull, and by less than half a turn: what grows at both ends, grows
  /// all the way. And with the heading the pull along it grows, so that speed is a convex function of time.
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

float& greatest_of(MapVisit& visit, MapQuantity quantity) { return visit.greatest[static_cast<std::size_t>(quantity)]; }

}  // namespace

/// Keeps the visits of a block's rocks: 32 bytes each, added to the maps when the block is committed.
class MapObserver::Part : public ObserverPart {
 public:
  Part(const MapGrid& grid, const GreatestHeight& heights, bool is_split)
      : grid_(grid), heights_(heights), is_split_(is_split) {}

  void see(const RockRecord& record, const RockLog& log) override {
    const std::size_t map = is_split_ ? record.source.index : 0;
    if (stretches.empty() || stretches.back().map != map) stretches.push_back({map, 0, visits.size(), visits.size()});
    cells_.begin_rock(visits.size());
    for (const PathPiece& piece : log.pieces) {
      if (piece.steps.count > 0) {
        glide(log, piece, record.body);
      } else if (leads_anywhere(piece)) {
        follow(piece, record.body);
      }
    }
    // What happens in a moment, in a cell where the rock was.
    for (const PathPiece& piece : log.pieces) {
      if (piece.steps.count > 0 || leads_anywhere(piece)) continue;
      note(visit_at(piece.path.p), piece, record.body, 0, piece.duration);
    }
    for (const Vec3& place : log.impacts) ++visit_at(place).impacts;
    const EndReason reason = record.outcome.reason;
    MapVisit& last = visit_at(record.outcome.end.position);
    last.is_deposit = reason == EndReason::at_rest || reason == EndReason::stopped_by_barrier;
    ++stretches.back().rocks;
    stretches.back().end_visit = visits.size();
  }

  std::vector<MapVisit> visits;
  std::vector<Stretch> stretches;

 private:
  [[nodiscard]] static bool leads_anywhere(const PathPiece& piece) {
    return (piece.path.at(piece.duration) - piece.path.p).squaredNorm() > no_way * no_way;
  }

  void follow(const PathPiece& piece, const Rock& rock) {
    // Most pieces on the ground are steps, each a few centimetres long: they need no walk.
    if (piece.on_ground && piece.path.a.isZero(0) && grid_.holds(cell_, piece.path.p) &&
        grid_.holds(cell_, piece.path.at(piece.duration))) {
      note(cells_.visit(cell_, visits), piece, rock, 0, piece.duration);
    } else {
      walk_over(piece, rock);
    }
  }

  void walk_over(const PathPiece& piece, const Rock& rock) {
    walk(grid_, piece, [&](MapCell cell, double enter, double leave) {
      note(cells_.visit(cell, visits), piece, rock, enter, leave);
      cell_ = cell;
    });
  }

  void note(MapVisit& visit, const PathPiece& piece, const Rock& rock, double enter, double leave) {
    const GreatestMotion motion = greatest_motion(piece, rock, enter, leave);
    raise(greatest_of(visit, MapQuantity::velocity), std::sqrt(motion.squared_velocity));
    raise(greatest_of(visit, MapQuantity::energy_translational), motion.energy_translational);
    raise(greatest_of(visit, MapQuantity::energy_total), motion.energy_total);
    float& height = greatest_of(visit, MapQuantity::bounce_height);
    raise(height, heights_(piece, enter, leave, height));
  }

  /// Of a place on a border: the visit to a cell beside it where the rock has been, if it has not been in the one that
  /// holds the place.
  MapVisit& visit_at(const Vec3& place) {
    const MapCell own = grid_.cell_at(place);
    const MapCell first = grid_.cell_at(place - Vec3(no_way, no_way, 0));
    const MapCell last = grid_.cell_at(place + Vec3(no_way, no_way, 0));
    if (first != last && !cells_.has(own, visits)) {
      for (std::int32_t row = first.row; row <= last.row; ++row) {
        for (std::int32_t column = first.column; column <= last.column; ++column) {
          if (cells_.has({column, row}, visits)) return cells_.visit({column, row}, visits);
        }
      }
    }
    return cells_.visit(own, visits);
  }

  /// Most steps of a glide, each a few centimetres long, stay in the cell: of them only the fastest counts.
  void glide(const RockLog& log, const PathPiece& piece, const Rock& rock) {
    const double rotational = 0.5 * rock.inertia * piece.spin.squaredNorm();
    const auto steps = std::span(log.glide_steps).subspan(piece.steps.first, piece.steps.count);
    const GlideOnPlan plan(piece);
    MapGrid::Borders cell = grid_.borders(cell_);
    double before = piece.ends.start_velocity.squaredNorm();
    double fastest = -1;  // squared [m2/s2], of the steps in this cell that are not in the maps yet
    const auto note_fastest = [&] {
      if (fastest >= 0) raise_motion(cells_.visit(cell_, visits), fastest, rock, rotational);
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
    raise(greatest_of(visit, MapQuantity::velocity), std::sqrt(squared_velocity));
    raise(greatest_of(visit, MapQuantity::energy_translational), translational);
    raise(greatest_of(visit, MapQuantity::energy_total), translational + rotational);
  }

  MapGrid grid_;
  const GreatestHeight& heights_;
  bool is_split_;
  VisitedCells cells_;
  MapCell cell_;  // the last one walked over
};

MapObserver::MapObserver(const MapGrid& grid, GreatestHeight heights, std::optional<std::size_t> sources)
    : heights_(std::move(heights)), is_split_(sources.has_value()) {
  for (std::size_t k = 0; k < std::max<std::size_t>(1, sources.value_or(1)); ++k) maps_.emplace_back(grid);
}

std::unique_ptr<ObserverPart> MapObserver::new_part() const {
  return std::make_unique<Part>(maps_.front().grid(), heights_, is_split_);
}

void MapObserver::commit(ObserverPart& part) {
  auto& seen = static_cast<Part&>(part);
  total_.reset();
  waiting_visits_ += seen.visits.size();
  waiting_.push_back({std::move(seen.visits), std::move(seen.stretches)});
  if (waiting_visits_ >= enough_visits) add_waiting();
}

void MapObserver::add_waiting() {
  std::vector<std::uint64_t> rocks(maps_.size());
  std::vector<std::vector<std::span<const MapVisit>>> visits(maps_.size());
  for (const Block& block : waiting_) {
    for (const Stretch& stretch : block.stretches) {
      rocks[stretch.map] += stretch.rocks;
      visits[stretch.map].push_back(
          std::span(block.visits).subspan(stretch.first_visit, stretch.end_visit - stretch.first_visit));
    }
  }
  for (std::size_t k = 0; k < maps_.size(); ++k) {
    if (rocks[k] > 0) maps_[k].add(rocks[k], visits[k]);
  }
  waiting_.clear();
  waiting_visits_ = 0;
}

void MapObserver::settle() {
  add_waiting();
  for (Maps& maps : maps_) maps.settle();
}

void MapObserver::save(ByteWriter& out) {
  settle();
  out.flag(is_split_);
  out.count(maps_.size());
  for (const Maps& maps : maps_) maps.save(out);
}

void MapObserver::merge_saved(ByteReader& in) {
  total_.reset();
  expect_bytes(in.flag() == is_split_ && in.get<std::uint64_t>() == maps_.size(), "maps are split by other sources");
  for (Maps& maps : maps_) maps.merge_saved(in);
}

const Maps& MapObserver::maps() {
  settle();
  if (!is_split_) return maps_.front();
  if (!total_) {
    total_.emplace(maps_.front().grid());
    for (const Maps& maps : maps_) total_->merge(maps);
    total_->settle();
  }
  return *total_;
}

std::span<const Maps> MapObserver::by_source() {
  settle();
  return is_split_ ? std::span<const Maps>(maps_) : std::span<const Maps>();
}

}  // namespace talus
