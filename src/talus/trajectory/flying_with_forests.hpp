#pragma once
// Flight in a model with forests.
//
// A forest covers the facets of its material, up to its height above them. A rock is in it if its centre is. This is
// checked at least once per `forest_step` of the path; the place where the rock enters or leaves is then found to
// `forest_border`. Shorter stretches inside or outside a forest may be missed.

#include "talus/trajectory/flying.hpp"

namespace talus {

/// The drag rate k = b/m [1/s] of a rock whose centre is at a place; 0 outside forests.
template <class Surface>
[[nodiscard]] double forest_drag_at(const MovingRock<Surface>& rock, const Vec3& place) {
  const auto ground = rock.surface.ground_below(place);
  if (!ground) return 0;
  const Material& material = rock.ground[rock.material_at(ground->facet)];
  return place.z() - ground->z < material.forest_height ? material.forest_drag / rock.rock.mass : 0;
}

/// A time [s] in which a rock flies no further than `forest_step`, gravity included.
[[nodiscard]] inline double forest_step_time(const Laws& laws, const Vec3& velocity) {
  return tolerance::forest_step / (velocity.norm() + std::sqrt(tolerance::forest_step * laws.gravity.norm()));
}

/// Where between `from` and `to` the drag rate changes from `rate`, by bisection: just beyond the border.
template <class Surface>
[[nodiscard]] double forest_border_between(const MovingRock<Surface>& rock, const Parabola& path, double from,
                                           double to, double rate) {
  while ((path.at(to) - path.at(from)).squared_norm() > tolerance::forest_border * tolerance::forest_border) {
    const double middle = 0.5 * (from + to);
    (forest_drag_at(rock, path.at(middle)) == rate ? from : to) = middle;
  }
  return to;
}

/// The end of a flight, or of a piece of one, if it leaves the ground with this drag rate only there; or else where the
/// rate changes before.
template <class Surface, class End>
[[nodiscard]] End until_forest_border(const MovingRock<Surface>& rock, const Parabola& path, const End& end,
                                      double rate) {
  for (double t = 0; t < end.t;) {
    const double next = std::min(end.t, t + forest_step_time(rock.laws, path.velocity(t)));
    Vec3 place = path.at(next);
    if (next == end.t && end.contact) place += tolerance::box_pad * unit_z;  // not in the ground by rounding
    if (forest_drag_at(rock, place) != rate) return {forest_border_between(rock, path, t, next, rate), {}, {}};
    t = next;
  }
  return end;
}

/// A flight outside forests, up to the first one.
template <class Surface, class Sink, class InAir>
[[nodiscard]] std::optional<Phase> fly_to_forest(TrackedRock<Surface, Sink>& rock, const InAir& phase) {
  const Parabola path{rock.motion.position, rock.motion.velocity, rock.laws.gravity};
  const auto end = end_of_flight(rock, phase, path, rock.laws.max_time - rock.motion.time);
  return fly_along(rock, phase, path, {}, until_forest_border(rock, path, end, 0));
}

/// One piece of a flight in a forest.
template <class Surface, class Sink, class InAir>
[[nodiscard]] std::optional<Phase> fly_in_forest(TrackedRock<Surface, Sink>& rock, const InAir& phase, double rate) {
  const Motion& motion = rock.motion;
  const Laws& laws = rock.laws;
  LinearDrag drag{rate, laws.gravity};
  double length = drag.longest_piece();
  // Pebbles in a dense forest sink slowly, in very short pieces: at terminal velocity they move on a straight line.
  const bool sinks =
      length * motion.velocity.norm() < 0.01 * tolerance::forest_step && drag.sinks_evenly(motion.velocity);
  if (sinks) {
    drag = {};
    length = tolerance::forest_step / std::max(motion.velocity.norm(), tolerance::least_speed);
  }
  length = std::min(length, drag.parameter(laws.max_time - motion.time));
  const Parabola path =
      sinks ? Parabola{motion.position, motion.velocity, Vec3{}} : drag.piece(motion.position, motion.velocity, length);
  auto end = until_forest_border(rock, path, first_contact(rock, phase, path, drag, length), rate);
  if (!end.contact && !rock.surface.ground_below(path.at(end.t))) {
    const Exit exit = rock.exit_of(path);
    if (exit.t <= end.t) end = {exit.t, {}, exit};
  }
  return fly_along(rock, phase, path, drag, end);
}

template <class Surface, class Sink, class InAir>
[[nodiscard]] Phase fly_with_forests(TrackedRock<Surface, Sink>& rock, const InAir& phase) {
  while (true) {
    const double rate = forest_drag_at(rock, rock.motion.position);
    const auto next = rate > 0 ? fly_in_forest(rock, phase, rate) : fly_to_forest(rock, phase);
    if (next) return *next;
    if (rock.motion.time >= rock.laws.max_time) return Ended{EndReason::maximum_time};
    rock.update_max_energy();
  }
}

}  // namespace talus
