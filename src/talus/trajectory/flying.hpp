#pragma once
// A rock in the air: it flies until it meets the ground, a barrier or the edge of the model.

#include "talus/trajectory/at_barriers.hpp"
#include "talus/trajectory/striking.hpp"

namespace talus {

/// How a flight ends: on the ground, at the edge of the model, or, with neither, when its time is over. `Touch`: what
/// touches the ground.
template <class Touch>
struct FlightEnd {
  double t;  // [s]
  std::optional<Touch> contact;
  std::optional<Exit> exit;
  // MovingRock::max_height until then, in this flight or before [m], if the search for the contact also gives it.
  std::optional<double> max_height = {};
};

[[nodiscard]] inline FacetId facet_of(const Contact& contact) { return contact.facet; }

/// At the first contact, or at t_max.
template <class Surface>
[[nodiscard]] FlightEnd<Contact> first_contact(const MovingRock<Surface>& rock, const Flying& phase,
                                               const Parabola& path, const LinearDrag&, double t_max) {
  const SupportPlanes left = rock.planes_of(phase.left);
  if constexpr (requires { rock.surface.flight(path, rock.reach, t_max, left, 0.0); }) {
    const auto [contact, max_height] = rock.surface.flight(path, rock.reach, t_max, left, rock.max_height);
    if (contact) return {contact->t, contact, {}, max_height};
    return {t_max, {}, {}};
  } else {
    const auto contact = rock.surface.first_contact(path, rock.reach, t_max, left);
    return {contact ? contact->t : t_max, contact, {}};
  }
}

template <class Surface, class InAir>
[[nodiscard]] auto end_of_flight(const MovingRock<Surface>& rock, const InAir& phase, const Parabola& path,
                                 double t_max) {
  const auto end = first_contact(rock, phase, path, {}, t_max);
  using End = std::remove_const_t<decltype(end)>;
  if (end.contact) {
    // A sphere may still touch the rim after its centre has left the model.
    if (rock.reach == 0 || rock.surface.has_ground_below(path.at(end.t), facet_of(*end.contact))) return end;
    const Exit before = rock.exit_of(path);
    return before.t < end.t && !before.beneath ? End{before.t, {}, before} : end;
  }
  const Exit edge = rock.exit_of(path);
  return edge.t < t_max ? End{edge.t, {}, edge} : end;
}

/// The rock has come down.
template <class Surface, class Sink>
[[nodiscard]] Phase come_down(TrackedRock<Surface, Sink>& rock, const Flying& phase, const Contact& contact) {
  return strike(rock, contact, phase.ground);
}

template <class Surface>
[[nodiscard]] std::optional<Crossing> next_crossing_of(MovingRock<Surface>& rock, const Flying&, const Parabola& path,
                                                       const LinearDrag&, double t_max) {
  return next_crossing(rock, path, t_max);
}

/// MovingRock::max_height after a flight that began at the time `start`.
template <class Surface>
[[nodiscard]] double max_height_after(const MovingRock<Surface>& rock, const Flying&, double, const Parabola& path,
                                      const LinearDrag&, double t_end) {
  return max_height_of_flight(rock.surface, path, 0, t_end, rock.max_height);
}

/// A barrier has changed its motion.
template <class Surface, class Sink>
[[nodiscard]] Phase fly_on(TrackedRock<Surface, Sink>&, const Flying&, const Vec3&) {
  return Flying{};
}

/// Where a flight ends without a contact, or arrives at a barrier.
template <class Surface, class Sink>
void tell_orientation(TrackedRock<Surface, Sink>&, const Flying&) {}

/// Flies to `flight_end`, or to a barrier before it, and returns the next phase; nullopt if the rock is still flying.
template <class Surface, class Sink, class InAir, class Touch>
[[nodiscard]] std::optional<Phase> fly_along(TrackedRock<Surface, Sink>& rock, const InAir& phase, const Parabola& path,
                                             const LinearDrag& drag, const FlightEnd<Touch>& flight_end) {
  Motion& motion = rock.motion;
  const double start = motion.time;
  // Barriers record times by the parabola's parameter.
  const auto retime = [&] {
    if (drag.rate > 0) rock.crossed.retime(start, [&](double t) { return drag.time(t); });
  };
  while (const auto crossing = next_crossing_of(rock, phase, path, drag, flight_end.t)) {
    const Motion before = motion;
    rock.advance(path, drag, crossing->t);
    if (crossing->above) {
      pass_above(rock, *crossing, std::exchange(motion, before));
      continue;
    }
    tell_orientation(rock, phase);
    const AtBarrier then = meet_barrier(rock, *crossing, start + crossing->t, rock.laws.gravity);
    if (then == AtBarrier::unaffected) {
      motion = before;
      continue;
    }
    retime();
    rock.tell(event::Flight{before, path, crossing->t, drag});
    rock.max_height = max_height_after(rock, phase, start, path, drag, crossing->t);
    if (then == AtBarrier::stopped) return Ended{EndReason::stopped_by_barrier};
    rock.leave(PathState::projectile);
    return fly_on(rock, phase, before.spin);
  }

  retime();
  rock.max_height =
      flight_end.max_height ? *flight_end.max_height : max_height_after(rock, phase, start, path, drag, flight_end.t);
  rock.tell(event::Flight{motion, path, flight_end.t, drag});
  rock.advance(path, drag, flight_end.t);
  if (flight_end.contact) return come_down(rock, phase, *flight_end.contact);
  tell_orientation(rock, phase);
  if (flight_end.exit) return Ended{reason_of(*flight_end.exit)};
  return std::nullopt;
}

template <class Surface, class Sink, class InAir>
[[nodiscard]] Phase fly(TrackedRock<Surface, Sink>& rock, const InAir& phase) {
  const Parabola path{rock.motion.position, rock.motion.velocity, rock.laws.gravity};
  const auto end = end_of_flight(rock, phase, path, rock.laws.max_time - rock.motion.time);
  const auto next = fly_along(rock, phase, path, {}, end);
  return next ? *next : Ended{EndReason::maximum_time};
}

}  // namespace talus
