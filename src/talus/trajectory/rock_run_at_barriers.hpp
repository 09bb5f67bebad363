#pragma once
// The part of RockRun that meets barriers and collectors. Included by rock_run.hpp only.

#include "talus/trajectory/rock_run.hpp"

namespace talus {

template <class Surface>
std::optional<Crossing> RockRun<Surface>::next_crossing(const Parabola& path, double t_max) {
  if (barriers_.empty()) return std::nullopt;
  crossed_.forget_before(motion_.time);
  return first_crossing(barriers_, path, reach_, motion_.time, t_max, crossed_);
}

/// What comes to a barrier while it is over it, has not passed above.
template <class Surface>
void RockRun<Surface>::take_back_passage(BarrierId barrier) {
  if (!crossed_.is_over(barrier, motion_.time)) return;
  const auto last =
      std::ranges::find(log_.passed_above.rbegin(), log_.passed_above.rend(), barrier, &PassedAbove::barrier);
  if (last != log_.passed_above.rend()) log_.passed_above.erase(std::next(last).base());
}

/// `there` is the rock where it passes.
template <class Surface>
void RockRun<Surface>::pass_above(const Crossing& crossing, const Motion& there) {
  const double time = motion_.time + crossing.t, speed = std::abs(there.velocity.dot(crossing.normal));
  crossed_.note_passage(crossing, time, speed > 0 ? time + (reach_ + crossing.way_over) / speed : time);
  log_.passed_above.push_back({crossing.barrier, crossing.clearance, there, crossing.height, crossing.station});
}

template <class Surface>
auto RockRun<Surface>::meet_barrier(const Crossing& crossing, double noted_time, const Vec3& pull,
                                    const OnGround* phase) -> AtBarrier {
  const Barrier& barrier = barriers_[crossing.barrier.index];
  take_back_passage(crossing.barrier);
  BarrierResponse response = respond(barrier, motion_, crossing.normal, rock_);
  if (response.outcome == BarrierOutcome::rebounded) {
    const auto velocity = thrown_back(crossing, response.leaving->velocity, pull, phase);
    response = velocity ? BarrierResponse{BarrierOutcome::rebounded, Rebound{*velocity, response.leaving->spin}}
                        : BarrierResponse{BarrierOutcome::stopped, std::nullopt};
  }
  const double speed = motion_.velocity.norm();
  const double across = speed > 0 ? std::clamp(-motion_.velocity.dot(crossing.across) / speed, -1.0, 1.0) : 1;
  const double angle = std::copysign(std::acos(across), -motion_.velocity.dot(crossing.up));
  log_.hits.push_back({crossing.barrier, motion_, crossing.height, angle, response.outcome, crossing.station});
  if (response.outcome == BarrierOutcome::rebounded) {
    crossed_.note_rebound(crossing, noted_time, response.leaving->velocity);
  } else if (response.leaving) {
    note_passage(crossing, noted_time, response.leaving->velocity);
  }
  if (barrier.is_collector) return AtBarrier::untouched;

  arrive(PathState::barrier);
  if (!response.leaving) return AtBarrier::held;
  motion_.velocity = response.leaving->velocity;
  motion_.spin = response.leaving->spin;
  return AtBarrier::goes_on;
}

/// How a rock leaves a barrier that throws it back, `velocity` being what the barrier alone would make of it; nothing
/// where it stays: where it is pressed against the barrier, and is as slow as what stops or would turn back within a
/// step, to come again and again.
template <class Surface>
std::optional<Vec3> RockRun<Surface>::thrown_back(const Crossing& crossing, const Vec3& velocity, const Vec3& pull,
                                                  const OnGround* phase) const {
  const Vec3& n = crossing.normal;
  Vec3 kept = phase ? kept_on_ground(*phase, velocity) : velocity;
  if (phase && kept.dot(n) < 0) {
    // What the ground leaves of the rebound leads into the barrier: the rock can go along both only.
    const Vec3 along = phase->normal.cross(n);
    const bool has_way = !phase->valley && along.squaredNorm() > 0;
    kept = has_way ? Vec3(kept.dot(along) / along.squaredNorm() * along) : Vec3(Vec3::Zero());
  }
  constexpr double none = 1e-9;  // [m/s2]
  const double pressing = -pull.dot(n);
  const bool turns_in_a_step = kept.dot(n) < laws_.timestep * pressing;
  if (pressing > none && (turns_in_a_step || kept.norm() < laws_.stopped_velocity)) return std::nullopt;
  return kept;
}

}  // namespace talus
