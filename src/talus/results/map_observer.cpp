#include "talus/results/map_observer.hpp"

#include <algorithm>
#include <bit>

#include "talus/flight/touch.hpp"

namespace talus {

namespace {

/// Finds the cells of one rock again, however often it comes back: a hash table by linear probing. A slot holds the
/// place of a visit in the list of all rocks' visits, counted from 1; those of earlier rocks are smaller than the
/// present rock's and count as empty, so that nothing is cleared between rocks.
class VisitedCells {
 public:
  void begin_rock(std::size_t visits_so_far) { before_ = visits_so_far; }

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

float& greatest_of(MapVisit& visit, MapQuantity quantity) { return visit.greatest[static_cast<std::size_t>(quantity)]; }

/// Keeps the visits of a block's rocks: 32 bytes each, added to the maps when the block is committed.
class MapPart : public ObserverPart {
 public:
  MapPart(const MapGrid& grid, RockModel model, const GroundHeight& ground)
      : grid_(grid), model_(model), ground_(ground) {}

  void see(const RockRecord& record, const RockLog& log) override {
    ++rocks;
    cells_.begin_rock(visits.size());
    height_here_.reset();
    for (const PathPiece& piece : log.pieces) follow(piece, record.body);
    for (const Vec3& place : log.impacts) ++cells_.visit(grid_.cell_at(place), visits).impacts;
    const EndReason reason = record.outcome.reason;
    MapVisit& last = cells_.visit(grid_.cell_at(record.outcome.end.position), visits);
    last.is_deposit = reason == EndReason::at_rest || reason == EndReason::stopped_by_barrier;
  }

  std::uint64_t rocks = 0;
  std::vector<MapVisit> visits;

 private:
  void follow(const PathPiece& piece, const Rock& rock) {
    const double rotational = 0.5 * rock.inertia * piece.spin.squaredNorm();
    const Parabola& path = piece.path;
    walk(grid_, piece, [&](MapCell cell, double enter, double leave) {
      MapVisit& visit = cells_.visit(cell, visits);
      // The square of the velocity is convex in time.
      const double squared = std::max(path.velocity(enter).squaredNorm(), path.velocity(leave).squaredNorm());
      const double translational = 0.5 * rock.mass * squared;
      raise(greatest_of(visit, MapQuantity::velocity), std::sqrt(squared));
      raise(greatest_of(visit, MapQuantity::energy_translational), translational);
      raise(greatest_of(visit, MapQuantity::energy_total), translational + rotational);
      raise(greatest_of(visit, MapQuantity::bounce_height), greatest_height(piece, enter, leave));
    });
  }

  /// At the samples; 0 where there is no ground below any.
  double greatest_height(const PathPiece& piece, double enter, double leave) {
    if (piece.on_ground && model_ == RockModel::lumped_mass) {
      height_here_ = 0;
      return 0;
    }
    if (!height_here_) height_here_ = height(piece.path.at(enter));
    double greatest = *height_here_;
    if (!piece.on_ground) {
      greatest = std::max(greatest, height(piece.path.at(0.5 * (enter + leave))));
      const double top = -piece.path.v.z() / piece.path.a.z();
      if (top > enter && top < leave) greatest = std::max(greatest, height(piece.path.at(top)));
    }
    height_here_ = height(piece.path.at(leave));
    return std::max(greatest, *height_here_);
  }
  [[nodiscard]] double height(const Vec3& place) const {
    const auto z = ground_(place.x(), place.y(), place.z() + contact_slack);
    return z ? std::max(0.0, place.z() - *z) : 0;
  }

  MapGrid grid_;
  RockModel model_;
  const GroundHeight& ground_;
  VisitedCells cells_;
  std::optional<double> height_here_;  // where the last piece, or its part in the last cell, ended
};

}  // namespace

std::unique_ptr<ObserverPart> MapObserver::new_part() const {
  return std::make_unique<MapPart>(maps_.grid(), model_, ground_);
}

void MapObserver::commit(ObserverPart& part) {
  auto& seen = static_cast<MapPart&>(part);
  waiting_rocks_ += seen.rocks;
  waiting_visits_ += seen.visits.size();
  waiting_.push_back(std::move(seen.visits));
  constexpr std::size_t enough = 1U << 20;  // 32 MB
  if (waiting_visits_ >= enough) add_waiting();
}

void MapObserver::add_waiting() {
  maps_.add(waiting_rocks_, waiting_);
  waiting_.clear();
  waiting_rocks_ = waiting_visits_ = 0;
}

const Maps& MapObserver::maps() {
  add_waiting();
  return maps_;
}

}  // namespace talus
