#pragma once
// A rock comes to barriers and collectors: held, thrown back, let through, or passing above.

#include "talus/trajectory/moving_rock.hpp"

namespace talus {

/// The ground that carries a rock when it comes to a barrier.
struct GroundBeneath {
  Vec3 normal;                 // of what carries it
  std::optional<Vec3> valley;  // unit, the only direction that there is in a valley
  ContactFriction friction;    // rigid sphere
  Footing footing;
  /// What it leaves of a velocity.
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

/// How a rock leaves a barrier that throws it back, `rebound` being what the barrier alone would make of it; nothing
/// where it stays: where it is pressed against the barrier, and is as slow as what stops or would turn back within a
/// step, to come again and again. What only the spin of a sphere would turn back stays at the barrier as long as that
/// lasts (is_driven_onto). `pull` is what draws it along its way [m/s2]; `on`, what it moves along, if it does.
template <class Surface>
[[nodiscard]] std::optional<Vec3> rebound_velocity(const MovingRock<Surface>& rock, const Crossing& crossing,
                                                   const Rebound& rebound, const Vec3& pull, const GroundBeneath* on) {
  const Vec3& n = crossing.normal;
  Vec3 kept = on ? on->kept(rebound.velocity) : rebound.velocity;
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
  if (on && rock.reach > 0 && !on->valley) {
    const Leg leg = rolling_leg(rock.motion.position, kept, rebound.spin, on->normal, on->footing, rock.rock,
                                on->friction, rock.laws.timestep);
    const double driving = -leg.path.a.dot(n), parting = kept.dot(n);
    if (driving > tolerance::no_pressing && parting < rock.laws.timestep * driving) {
      const Vec3 along = on->normal.cross(n).normalized();
      kept = kept.dot(along) * along;
    }
  }
  return kept;
}

/// Whether a sphere, where a leg begins, touches a barrier without coming to it, and its spin alone drives it there. It
/// does not meet the barrier once more: it goes along it and the ground until there is no slip, or gravity draws it
/// away.
template <class Surface>
[[nodiscard]] bool is_driven_onto(const MovingRock<Surface>& rock, const Crossing& crossing, const GroundBeneath& on) {
  const Vec3& n = crossing.normal;
  return rock.reach > 0 && !on.valley && !crossing.above && crossing.t < tolerance::same_crossing &&
         !rock.barriers[crossing.barrier.index].is_collector && rock.motion.velocity.dot(n) > -tolerance::no_pressing &&
         on.footing.pull.dot(n) > -tolerance::no_pressing;
}

/// The rock has come to a barrier; `noted_time` is when, on the clock of its path. The rest as in rebound_velocity().
template <class Surface>
[[nodiscard]] AtBarrier meet_barrier(MovingRock<Surface>& rock, const Crossing& crossing, double noted_time,
                                     const Vec3& pull, const GroundBeneath* on = nullptr) {
  Motion& motion = rock.motion;
  const Barrier& barrier = rock.barriers[crossing.barrier.index];
  take_back_passage(rock, crossing.barrier);
  BarrierResponse response = respond(barrier, motion, crossing.normal, rock.rock);
  if (response.outcome == BarrierOutcome::rebounded) {
    const auto velocity = rebound_velocity(rock, crossing, *response.leaving, pull, on);
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
