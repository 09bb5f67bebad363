#pragma once
// The part of RockRun that flies where there are forests. Included by rock_run.hpp only.
//
// A forest stands on the facets of its material, up to its height above them. Whether a rock is in one is asked of the
// place of its centre, at least once in `forest_step` of its way; where it comes in or out is then found to
// `forest_border`. A stay in, or out of, a forest that is shorter than that step may be missed.

#include "talus/trajectory/rock_run.hpp"

namespace talus {

inline constexpr double forest_step = 0.5;     // [m]
inline constexpr double forest_border = 1e-3;  // [m]

/// The rate k = b/m [1/s] at which a forest brakes a rock whose centre is here; 0 outside.
template <class Surface>
double RockRun<Surface>::forest_drag_at(const Vec3& place) const {
  const auto ground = surface_.ground_below(place);
  if (!ground) return 0;
  const Material& material = ground_[material_at(ground->facet)];
  return place.z() - ground->z < material.forest_height ? material.forest_drag / rock_.mass : 0;
}

/// How long a rock at this velocity is sure not to fly further than `forest_step`, whatever gravity adds [s].
template <class Surface>
double RockRun<Surface>::forest_step_time(const Vec3& velocity) const {
  return forest_step / (velocity.norm() + std::sqrt(forest_step * laws_.gravity.norm()));
}

/// The first parameter in (from, to] at which the forest at the path's place is not what it is at `from`, where it is
/// different at `to`.
template <class Surface>
double RockRun<Surface>::forest_border_between(const Parabola& path, double from, double to, double rate) const {
  while ((path.at(to) - path.at(from)).squaredNorm() > forest_border * forest_border) {
    const double middle = 0.5 * (from + to);
    (forest_drag_at(path.at(middle)) == rate ? from : to) = middle;
  }
  return to;
}

template <class Surface>
auto RockRun<Surface>::fly_where_forests_are() -> Phase {
  while (true) {
    const double rate = forest_drag_at(motion_.position);
    const Next next = rate > 0 ? fly_among_trees(rate) : fly_to_the_trees();
    if (next) return *next;
    if (motion_.time >= laws_.max_time) return end(EndReason::maximum_time);
    note_energy();
  }
}

/// A flight outside forests, up to where one begins.
template <class Surface>
auto RockRun<Surface>::fly_to_the_trees() -> Next {
  const Parabola path{motion_.position, motion_.velocity, laws_.gravity};
  FlightEnd end = end_of_flight(path, laws_.max_time - motion_.time, left_);
  for (double t = 0; t < end.t;) {
    const double next = std::min(end.t, t + forest_step_time(path.velocity(t)));
    if (forest_drag_at(path.at(next)) > 0) {
      end = {forest_border_between(path, t, next, 0), {}, {}};
      break;
    }
    t = next;
  }
  return fly_along(path, {}, end);
}

/// A piece of a flight in a forest.
template <class Surface>
auto RockRun<Surface>::fly_among_trees(double rate) -> Next {
  LinearDrag drag{rate, laws_.gravity};
  double length = std::min(drag.longest_piece(), forest_step_time(motion_.velocity));
  // Pebbles in a dense forest sink slowly, in pieces that would be very short: they go on as they do.
  const bool sinks = length * motion_.velocity.norm() < 0.01 * forest_step && drag.sinks_evenly(motion_.velocity);
  if (sinks) {
    drag = {};
    length = forest_step / std::max(motion_.velocity.norm(), 1e-300);
  }
  length = std::min(length, drag.parameter(laws_.max_time - motion_.time));
  const Parabola path = sinks ? Parabola{motion_.position, motion_.velocity, Vec3::Zero()}
                              : drag.piece(motion_.position, motion_.velocity, length);
  if (forest_drag_at(path.at(length)) != rate) length = forest_border_between(path, 0, length, rate);

  FlightEnd end{length, {}, {}};
  if (const FlightEnd met = first_contact(path, length, left_); met.contact) {
    end = met;
  } else if (!surface_.ground_below(path.at(length))) {
    const Exit exit = surface_.exit(path);
    if (exit.t <= length) end = {exit.t, {}, exit};
  }
  return fly_along(path, drag, end);
}

}  // namespace talus
