#pragma once
// A rock in the air where there are forests.
//
// A forest stands on the facets of its material, up to its height above them. Whether a rock is in one is asked of the
// place of its centre, at least once in `forest_step` of its way; where it comes in or out is then found to
// `forest_border`. A stay in, or out of, a forest that is shorter than that step may be missed.

#include "talus/trajectory/flying.hpp"

namespace talus {

/// The rate k = b/m [1/s] at which a forest brakes a rock whose centre is here; 0 outside.
template <class Surface>
[[nodiscard]] double forest_drag_at(const MovingRock<Surface>& rock, const Vec3& place) {
  const auto ground = rock.surface.ground_below(place);
  if (!ground) return 0;
  const Material& material = rock.ground[rock.material_at(ground->facet)];
  return place.z() - ground->z < material.forest_height ? material.forest_drag / rock.rock.mass : 0;
}

/// How long a rock at this velocity is sure not to fly further than `forest_step`, whatever gravity adds [s].
[[nodiscard]] inline double forest_step_time(const Laws& laws, const Vec3& velocity) {
  return tolerance::forest_step / (velocity.norm() + std::sqrt(tolerance::forest_step * laws.gravity.norm()));
}

/// The first parameter in (from, to] at which the forest at the path's place is not what it is at `from`, where it is
/// different at `to`.
template <class Surface>
[[nodiscard]] double forest_border_between(const MovingRock<Surface>& rock, const Parabola& path, double from,
                                           double to, double rate) {
  while ((path.at(to) - path.at(from)).squaredNorm() > tolerance::forest_border * tolerance::forest_border) {
    const double middle = 0.5 * (from + to);
    (forest_drag_at(rock, path.at(middle)) == rate ? from : to) = middle;
  }
  return to;
}

/// A flight outside forests, up to where one begins.
template <class Surface>
[[nodiscard]] std::optional<RockState> fly_to_the_trees(MovingRock<Surface>& rock, const Flying& state) {
  const Parabola path{rock.motion.position, rock.motion.velocity, rock.laws.gravity};
  FlightEnd end = end_of_flight(rock, path, rock.laws.max_time - rock.motion.time, state.left);
  for (double t = 0; t < end.t;) {
    const double next = std::min(end.t, t + forest_step_time(rock.laws, path.velocity(t)));
    if (forest_drag_at(rock, path.at(next)) > 0) {
      end = {forest_border_between(rock, path, t, next, 0), {}, {}};
      break;
    }
    t = next;
  }
  return fly_along(rock, state, path, {}, end);
}

/// A piece of a flight in a forest.
template <class Surface>
[[nodiscard]] std::optional<RockState> fly_among_trees(MovingRock<Surface>& rock, const Flying& state, double rate) {
  const Motion& motion = rock.motion;
  const Laws& laws = rock.laws;
  LinearDrag drag{rate, laws.gravity};
  double length = std::min(drag.longest_piece(), forest_step_time(laws, motion.velocity));
  // Pebbles in a dense forest sink slowly, in pieces that would be very short: they go on as they do.
  const bool sinks =
      length * motion.velocity.norm() < 0.01 * tolerance::forest_step && drag.sinks_evenly(motion.velocity);
  if (sinks) {
    drag = {};
    length = tolerance::forest_step / std::max(motion.velocity.norm(), tolerance::least_speed);
  }
  length = std::min(length, drag.parameter(laws.max_time - motion.time));
  const Parabola path = sinks ? Parabola{motion.position, motion.velocity, Vec3::Zero()}
                              : drag.piece(motion.position, motion.velocity, length);
  if (forest_drag_at(rock, path.at(length)) != rate) length = forest_border_between(rock, path, 0, length, rate);

  FlightEnd end{length, {}, {}};
  if (const FlightEnd met = first_contact(rock, path, length, state.left); met.contact) {
    end = met;
  } else if (!rock.surface.ground_below(path.at(length))) {
    const Exit exit = rock.surface.exit(path);
    if (exit.t <= length) end = {exit.t, {}, exit};
  }
  return fly_along(rock, state, path, drag, end);
}

template <class Surface>
[[nodiscard]] RockState fly_where_forests_are(MovingRock<Surface>& rock, const Flying& state) {
  while (true) {
    const double rate = forest_drag_at(rock, rock.motion.position);
    const auto next = rate > 0 ? fly_among_trees(rock, state, rate) : fly_to_the_trees(rock, state);
    if (next) return *next;
    if (rock.motion.time >= rock.laws.max_time) return Ended{EndReason::maximum_time};
    rock.note_energy();
  }
}

}  // namespace talus
