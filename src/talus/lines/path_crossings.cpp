#include "talus/lines/path_crossings.hpp"

#include <algorithm>
#include <cmath>

#include "talus/store/ground_parts.hpp"

namespace talus {

namespace {

/// The motion at a crossing.
Motion motion_at(const PathPiece& piece, const Crossing& crossing) {
  const double t = crossing.t;
  Motion motion{piece.path.at(t), piece.velocity(t), piece.spin_at(t), piece.time(t)};
  if (piece.on_ground && t < piece.duration) {
    // As in a run, with its operations (move_along() in trajectory/ground_leg.hpp): closed forms keep their velocity,
    // others change it in proportion to the time. No velocity points back from what the rock crosses.
    const auto& [start, end, end_spin] = piece.ends;
    const bool is_closed_form = piece.path.v == start && piece.path.velocity(piece.duration) == end;
    motion.velocity = is_closed_form ? piece.path.velocity(t) : start + t / piece.duration * (end - start);
    motion.velocity -= std::max(0.0, motion.velocity.dot(crossing.normal)) * crossing.normal;
  }
  return motion;
}

}  // namespace

void PathCrossings::begin(double reach) {
  reach_ = reach;
  recent_ = {};
  met_.reset();
  last_.reset();
  found_.clear();
}

void PathCrossings::add(const PathPiece& piece) {
  if (met_) leave(piece.velocity(0));
  const double start = piece.start_time;
  recent_.forget_before(start);
  // What ended the piece may be beyond its end by rounding.
  const double t_max = piece.duration + tolerance::same_crossing;
  // A stored path along the ground may be below it.
  const double below = piece.on_ground ? StoreTolerance::position : tolerance::barrier_range;
  while (const auto crossing = first_crossing(barriers_, piece.path, reach_, start, t_max, recent_, below)) {
    if (crossing->above) {
      pass_above(piece, *crossing);
      continue;
    }
    const bool was_in_model = !barriers_[crossing->barrier.index].is_collector;
    if (was_in_model && crossing->t > piece.duration - tolerance::same_crossing) {
      met_ = Met{*crossing, piece.time(crossing->t)};
      arrive(piece, *crossing, BarrierOutcome::stopped);
      break;
    }
    // A barrier that did not end the piece is met only by rounding.
    arrive(piece, *crossing, BarrierOutcome::passed);
    const double speed = std::max(piece.velocity(crossing->t).norm(), tolerance::least_passing_speed);
    recent_.record_passage(*crossing, start + crossing->t, start + crossing->t + 4 * reach_ / speed);
  }
  last_ = piece;
  if (piece.drag.rate > 0) recent_.retime(start, [&](double t) { return piece.drag.time(t); });
}

void PathCrossings::end(bool at_barrier) {
  if (at_barrier && !met_ && last_ && last_->on_ground) {
    constexpr double way = 1e-3;  // [m]
    const PathPiece& last = *last_;
    const double t = last.duration, speed = std::max(last.velocity(t).norm(), tolerance::least_passing_speed);
    PathPiece more{.path = {last.path.at(t), last.velocity(t), Vec3{}},
                   .duration = way / speed,
                   .start_time = last.time(t),
                   .spin = last.spin_at(t),
                   .on_ground = true};
    more.ends = {last.velocity(t), last.velocity(t), last.spin_at(t)};
    add(more);
  }
  met_.reset();
}

void PathCrossings::pass_above(const PathPiece& piece, const Crossing& crossing) {
  const Motion there = motion_at(piece, crossing);
  const double time = piece.start_time + crossing.t, speed = std::abs(there.velocity.dot(crossing.normal));
  recent_.record_passage(crossing, time, speed > 0 ? time + (reach_ + crossing.way_over) / speed : time);
  found_.passed_above.push_back({crossing, there});
}

void PathCrossings::arrive(const PathPiece& piece, const Crossing& crossing, BarrierOutcome outcome) {
  const Motion there = motion_at(piece, crossing);
  if (recent_.is_over(crossing.barrier, there.time)) take_back(found_.passed_above, crossing.barrier);
  found_.hits.push_back({crossing, there, outcome});
}

/// `velocity`: with which the rock leaves the barrier that ended the last piece.
void PathCrossings::leave(const Vec3& velocity) {
  const auto [crossing, time] = *met_;
  met_.reset();
  if (velocity.dot(crossing.normal) < -tolerance::no_pressing) {
    found_.hits.back().outcome = BarrierOutcome::broke_through;
    const double speed = std::max(velocity.norm(), tolerance::least_passing_speed);
    recent_.record_passage(crossing, time, time + 4 * reach_ / speed);
  } else {
    found_.hits.back().outcome = BarrierOutcome::rebounded;
    recent_.record_rebound(crossing, time, velocity);
  }
}

bool PathCrossings::is_settled(BarrierId barrier, double time) const {
  const auto is_it = [&](const auto& crossing) { return crossing.barrier == barrier; };
  if (std::ranges::any_of(found_.hits, is_it)) return true;
  return std::ranges::any_of(found_.passed_above, is_it) && !recent_.is_over(barrier, time);
}

}  // namespace talus
