#pragma once
// A rock comes to barriers and collectors: held, thrown back, let through, or passing above.

#include "talus/trajectory/moving_rock.hpp"

namespace talus {

/// What the ground leaves of a velocity while it carries the rock.
struct GroundConstraint {
  Vec3 normal;                 // of what carries it
  std::optional<Vec3> valley;  // unit, the only direction that there is in a valley
  [[nodiscard]] Vec3 kept(const Vec3& velocity) const {
    return valley ? Vec3(velocity.dot(*valley) * *valley) : tangential(velocity, normal);
  }
};

/// How a rock goes on from a barrier.
enum class AtBarrier { untouched, held, goes_on };

template <class Surface>
[[nodiscard]] std::optional<Crossing> next_crossing(MovingRock<Surface>& rock, const Parabola& path, double t_max) {
  if (rock.barriers.empty()) return std::nullopt;
  rock.crossed.forget_before(rock.motion.time);
  return first_crossing(rock.barriers, path, rock.reach, rock.motion.time, t_max, rock.crossed);
}

/// `there` is the rock where it passes; it has moved along until `crossing.t`.
template <class Surface>
void pass_above(MovingRock<Surface>& rock, const Crossing& crossing, const Motion& there) {
  const double time = rock.motion.time + crossing.t, speed = std::abs(there.velocity.dot(crossing.normal));
  rock.crossed.note_passage(crossing, time, speed > 0 ? time + (rock.reach + crossing.way_over) / speed : time);
  rock.log.passed_above.push_back({crossing.barrier, crossing.clearance, there, crossing.height, crossing.station});
}

/// What comes to a barrier while it is over it, has not passed above.
template <class Surface>
void take_back_passage(MovingRock<Surface>& rock, BarrierId barrier) {
  if (!rock.crossed.is_over(barrier, rock.motion.time)) return;
  auto& passed = rock.log.passed_above;
  const auto last = std::ranges::find(passed.rbegin(), passed.rend(), barrier, &PassedAbove::barrier);
  if (last != passed.rend()) passed.erase(std::next(last).base());
}

/// How a rock leaves a barrier that throws it back, `velocity` being what the barrier alone would make of it; nothing
/// where it stays: where it is pressed against the barrier, and is as slow as what stops or would turn back within a
/// step, to come again and again. `pull` is what draws it along its way [m/s2]; `on`, what it moves along, if it does.
template <class Surface>
[[nodiscard]] std::optional<Vec3> thrown_back(const MovingRock<Surface>& rock, const Crossing& crossing,
                                              const Vec3& velocity, const Vec3& pull, const GroundConstraint* on) {
  const Vec3& n = crossing.normal;
  Vec3 kept = on ? on->kept(velocity) : velocity;
  if (on && kept.dot(n) < 0) {
    // What the ground leaves of the rebound leads into the barrier: the rock can go along both only.
    const Vec3 along = on->normal.cross(n);
    const bool has_way = !on->valley && along.squaredNorm() > 0;
    kept = has_way ? Vec3(kept.dot(along) / along.squaredNorm() * along) : Vec3(Vec3::Zero());
  }
  const double pressing = -pull.dot(n);
  const bool turns_in_a_step = kept.dot(n) < rock.laws.timestep * pressing;
  if (pressing > tolerance::no_pressing && (turns_in_a_step || kept.norm() < rock.laws.stopped_velocity))
    return std::nullopt;
  return kept;
}

/// The rock has come to a barrier; `noted_time` is when, on the clock of its path. The rest as in thrown_back().
template <class Surface>
[[nodiscard]] AtBarrier meet_barrier(MovingRock<Surface>& rock, const Crossing& crossing, double noted_time,
                                     const Vec3& pull, const GroundConstraint* on = nullptr) {
  Motion& motion = rock.motion;
  const Barrier& barrier = rock.barriers[crossing.barrier.index];
  take_back_passage(rock, crossing.barrier);
  BarrierResponse response = respond(barrier, motion, crossing.normal, rock.rock);
  if (response.outcome == BarrierOutcome::rebounded) {
    const auto velocity = thrown_back(rock, crossing, response.leaving->velocity, pull, on);
    response = velocity ? BarrierResponse{BarrierOutcome::rebounded, Rebound{*velocity, response.leaving->spin}}
                        : BarrierResponse{BarrierOutcome::stopped, std::nullopt};
  }
  const double speed = motion.velocity.norm();
  const double across = speed > 0 ? std::clamp(-motion.velocity.dot(crossing.across) / speed, -1.0, 1.0) : 1;
  const double angle = std::copysign(std::acos(across), -motion.velocity.dot(crossing.up));
  rock.log.hits.push_back({crossing.barrier, motion, crossing.height, angle, response.outcome, crossing.station});
  if (response.outcome == BarrierOutcome::rebounded) {
    rock.crossed.note_rebound(crossing, noted_time, response.leaving->velocity);
  } else if (response.leaving) {
    const double leaving_speed = std::max(response.leaving->velocity.norm(), tolerance::least_passing_speed);
    rock.crossed.note_passage(crossing, noted_time, noted_time + 4 * rock.reach / leaving_speed);
  }
  if (barrier.is_collector) return AtBarrier::untouched;

  rock.arrive(PathState::barrier);
  if (!response.leaving) return AtBarrier::held;
  motion.velocity = response.leaving->velocity;
  motion.spin = response.leaving->spin;
  return AtBarrier::goes_on;
}

}  // namespace talus
