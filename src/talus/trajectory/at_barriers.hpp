#pragma once
// A rock meets barriers and collectors: it is stopped, rebounds, breaks through, or passes above.

#include "talus/barriers/body_crossing.hpp"
#include "talus/trajectory/tracked_rock.hpp"

namespace talus {

/// The ground that carries a rock when it meets a barrier.
struct GroundBeneath {
  Vec3 normal;                 // of its support
  std::optional<Vec3> valley;  // in a valley: the direction along it, unit
  ContactFriction friction;    // rigid sphere
  Footing footing;
  /// The part of a velocity along it.
  [[nodiscard]] Vec3 along_ground(const Vec3& velocity) const {
    return valley ? velocity.dot(*valley) * *valley : tangential(velocity, normal);
  }
};

/// What a barrier does to a rock's motion.
enum class AtBarrier { unaffected, stopped, continues };

template <class Surface>
[[nodiscard]] std::optional<Crossing> next_crossing(MovingRock<Surface>& rock, const Parabola& path, double t_max) {
  if (rock.barriers.empty()) return std::nullopt;
  rock.crossed.forget_before(rock.motion.time);
  return first_crossing(rock.barriers, path, rock.reach, rock.motion.time, t_max, rock.crossed);
}

/// The same for a rock with a shape. `way`: how it moves (barriers/body_crossing.hpp).
template <class Surface, class Way>
[[nodiscard]] std::optional<Crossing> next_body_crossing(MovingRock<Surface>& rock, const Way& way, double t_max) {
  rock.crossed.forget_before(rock.motion.time);
  return first_body_crossing(rock.barriers, way, rock.motion.time, t_max, rock.crossed);
}

/// `there`: the rock's motion at `crossing.t`, where it passes.
template <class Surface, class Sink>
void pass_above(TrackedRock<Surface, Sink>& rock, const Crossing& crossing, const Motion& there) {
  const double time = rock.motion.time + crossing.t, speed = std::abs(there.velocity.dot(crossing.normal));
  rock.crossed.record_passage(crossing, time, speed > 0 ? time + (rock.extent() + crossing.way_over) / speed : time);
  rock.tell(event::PassedAbove{{crossing, there}});
}

/// The velocity after a rebound from a barrier; nullopt if the rock stops there: if it is pressed against the barrier
/// and is too slow to move on, or would come back within a timestep, again and again. A sphere that only its spin would
/// drive back moves along the barrier until it no longer slips (is_driven_onto). `rebound`: off the barrier alone;
/// `pull`: the acceleration along the path [m/s2]; `on`: the ground that the rock moves along, if any.
template <class Surface>
[[nodiscard]] std::optional<Vec3> rebound_velocity(const MovingRock<Surface>& rock, const Crossing& crossing,
                                                   const Rebound& rebound, const Vec3& pull, const GroundBeneath* on) {
  const Vec3& n = crossing.normal;
  Vec3 leaving = on ? on->along_ground(rebound.velocity) : rebound.velocity;
  if (on && leaving.dot(n) < 0) {
    // Along the ground the rebound leads into the barrier: the rock can only move along both.
    const Vec3 along = on->normal.cross(n);
    const bool can_move = !on->valley && along.squared_norm() > 0;
    leaving = can_move ? leaving.dot(along) / along.squared_norm() * along : Vec3{};
  }
  const double pressing = -pull.dot(n);
  const bool returns_in_a_step = leaving.dot(n) < rock.laws.timestep * pressing;
  if (pressing > tolerance::no_pressing && (returns_in_a_step || leaving.norm() < rock.laws.stopped_velocity))
    return std::nullopt;
  if (on && rock.reach > 0 && !on->valley) {
    const Leg leg = rolling_leg(rock.motion.position, leaving, rebound.spin, on->normal, on->footing, rock.rock,
                                on->friction, rock.laws.timestep);
    const double driving = -leg.path.a.dot(n), parting = leaving.dot(n);
    if (driving > tolerance::no_pressing && parting < rock.laws.timestep * driving) {
      const Vec3 along = on->normal.cross(n).normalized();
      leaving = leaving.dot(along) * along;
    }
  }
  return leaving;
}

/// Whether a sphere at the start of a leg touches a barrier without approaching it, and only its spin drives it there.
/// That is no new contact: the sphere moves along barrier and ground until it no longer slips, or gravity pulls it
/// away.
template <class Surface>
[[nodiscard]] bool is_driven_onto(const MovingRock<Surface>& rock, const Crossing& crossing, const GroundBeneath& on) {
  const Vec3& n = crossing.normal;
  return rock.reach > 0 && !on.valley && !crossing.above && crossing.t < tolerance::same_crossing &&
         !rock.barriers[crossing.barrier.index].is_collector && rock.motion.velocity.dot(n) > -tolerance::no_pressing &&
         on.footing.pull.dot(n) > -tolerance::no_pressing;
}

/// The rock has reached a barrier. `path_time`: the time of its release plus the path's parameter; `pull` and `on` as
/// in rebound_velocity().
template <class Surface, class Sink>
[[nodiscard]] AtBarrier meet_barrier(TrackedRock<Surface, Sink>& rock, const Crossing& crossing, double path_time,
                                     const Vec3& pull, const GroundBeneath* on = nullptr) {
  Motion& motion = rock.motion;
  const Barrier& barrier = rock.barriers[crossing.barrier.index];
  if (rock.crossed.is_over(crossing.barrier, motion.time)) rock.tell(event::NotPassedAbove{crossing.barrier});
  BarrierResponse response = respond(barrier, motion, crossing.normal, rock.rock);
  if (response.outcome == BarrierOutcome::rebounded) {
    const auto velocity = rebound_velocity(rock, crossing, *response.leaving, pull, on);
    response = velocity ? BarrierResponse{BarrierOutcome::rebounded, Rebound{*velocity, response.leaving->spin}}
                        : BarrierResponse{BarrierOutcome::stopped, std::nullopt};
  }
  const Passage passage{crossing, motion, response.outcome};
  if (response.outcome == BarrierOutcome::rebounded) {
    rock.crossed.record_rebound(crossing, path_time, response.leaving->velocity);
  } else if (response.leaving) {
    const double leaving_speed = std::max(response.leaving->velocity.norm(), tolerance::least_passing_speed);
    rock.crossed.record_passage(crossing, path_time, path_time + 4 * rock.extent() / leaving_speed);
  }
  if (barrier.is_collector) {
    rock.tell(event::AtCollector{passage});
    return AtBarrier::unaffected;
  }
  rock.arrive(passage);
  if (!response.leaving) {
    rock.stop_at_barrier();
    return AtBarrier::stopped;
  }
  motion.velocity = response.leaving->velocity;
  motion.spin = response.leaving->spin;
  return AtBarrier::continues;
}

}  // namespace talus
