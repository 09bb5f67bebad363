#pragma once
// A rock with a shape in the air: its centre on a parabola, its rotation free, until it comes to the ground with
// a corner, or onto a ridge of it.
//
// Before a sphere about the whole rock touches anything, nothing of it can. From there the flight is searched in steps
// in which no corner leaves the chord of its way by more than a millimetre or two, and the first step into the ground
// is narrowed down to the contact. All corners that touch there are struck together.

#include <array>

#include "talus/rocks/free_rotation.hpp"
#include "talus/trajectory/flying.hpp"
#include "talus/trajectory/striking_body.hpp"

namespace talus {

/// The free flight of a body.
struct BodyFlight {
  const Body& body;
  const Parabola& path;
  const LinearDrag& drag;
  const FreeRotation& rotation;
  double begun;  // how long before the path the rotation began [s]

  /// `s`: the parameter of the path.
  [[nodiscard]] FreeRotation::Turned turned_at(double s) const { return rotation.turned_at(begun + drag.time(s)); }
  [[nodiscard]] Posture at(double s) const { return body.at(path.at(s), turned_at(s).matrix); }
  /// Per second of the path's parameter [rad/s]: pieces with drag end before a quarter of 1 / rate.
  [[nodiscard]] double max_turning() const {
    return drag.rate > 0 ? 4.0 / 3 * rotation.max_spin() : rotation.max_spin();
  }
};

/// Just before and just after a body comes to the ground, in the path's parameter.
struct Touchdown {
  double before, after;
  std::optional<TouchPart> part;  // that touches `before`; none if a corner's clearance jumps there
};

/// Where a body comes to the ground, and how it is turned there.
struct BodyTouch {
  ContactSet contacts;
  FreeRotation::Turned turned;
};

template <class Surface>
[[nodiscard]] bool is_free_of_ground(const Surface& surface, const Vec3& centre, double reach) {
  if (clearance(surface, centre) <= reach) return false;
  bool is_free = true;
  surface.supports(centre, reach, 0, [&](const Vec3&, const Vec3&, double, FacetId) { is_free = false; });
  return is_free;
}

/// Narrows a step of the flight from the open into the ground, by the false position of N. Anderson and A. Bjorck, "A
/// new high order method of regula falsi type", BIT 13 (1973): if an end stays twice, its value counts for less.
/// `nearest_at(s)`: what is nearest to the ground.
template <class NearestAt>
[[nodiscard]] Touchdown touchdown_between(NearestAt&& nearest_at, double before, double after, double above,
                                          double below, double sunk) {
  constexpr int max_steps = 60;
  constexpr double aim = 0.5 * tolerance::corner_gap;
  double high = above - aim, low = below - aim;
  enum class End { none, in_the_open, in_the_ground } moved = End::none;
  for (int i = 0; i < max_steps && after - before > tolerance::corner_time; ++i) {
    double s = before + (after - before) * high / (high - low);
    if (i % 8 == 7 || !(s > before && s < after)) s = 0.5 * (before + after);
    const auto [part, nearest] = nearest_at(s);
    const double gap = nearest - sunk, now = gap - aim;
    const auto lowered = [&](double kept, double replaced) {
      const double factor = 1 - now / replaced;
      return kept * (factor > 0 ? factor : 0.5);
    };
    if (gap > 0) {
      if (gap <= tolerance::corner_gap) return {s, after, part};
      if (moved == End::in_the_open) low = lowered(low, high);
      before = s;
      high = now;
      moved = End::in_the_open;
    } else {
      if (moved == End::in_the_ground) high = lowered(high, low);
      after = s;
      low = now;
      moved = End::in_the_ground;
    }
  }
  return {before, after, {}};
}

/// What has come to the ground `after`, there with `below` as what is nearest. Most touches are corners', and ridges
/// need not be looked for on the way to these: none may be in the body where the corner touches.
template <class Surface>
[[nodiscard]] Touchdown narrowed_down(const Surface& surface, const BodyFlight& flight, double before, double after,
                                      double above, const NearestPart& below, double sunk) {
  const auto with_ridges = [&](double s) { return nearest_part(surface, flight.at(s)); };
  double low = below.gap - sunk;
  if (!below.part.is_ridge()) {
    const auto corners = [&](double s) { return nearest_corner(surface, flight.at(s)); };
    const Touchdown touch = touchdown_between(corners, before, after, above, low, sunk);
    if (!flight.body.hull || flight.body.hull->is_empty()) return touch;
    low = with_ridges(touch.before).gap - sunk;
    if (low > 0) return touch;
    after = touch.before;
  }
  return touchdown_between(with_ridges, before, after, above, low, sunk);
}

/// The lengths of steps of the search for a touchdown, in the path's parameter. Between two looks no corner should come
/// into the ground and out again. From the chord of its way it departs by less than a quarter of reach times turn
/// squared, and ground whose slope changes by 1 or less by less than a quarter of the way. So steps are short, or keep
/// both below a share of the clearance.
class SearchSteps {
 public:
  explicit SearchSteps(const BodyFlight& flight)
      : reach_(flight.body.reach), spin_(flight.rotation.max_spin()), fall_(flight.path.a.norm()) {}

  [[nodiscard]] double shortest(double speed) const { return step(speed, 0.25 * reach_, tolerance::turn_in_a_step); }
  /// In which both are at most half of the clearance `gap`.
  [[nodiscard]] double within(double gap, double speed) const {
    return step(speed, std::min(gap, reach_), std::min(std::sqrt(gap / reach_), max_turn));
  }

 private:
  static constexpr double max_turn = 0.5;
  [[nodiscard]] double step(double speed, double way, double turn) const {
    const double by_way = 2 * way / (speed + std::sqrt(speed * speed + 2 * fall_ * way));
    return spin_ > 0 ? std::min(by_way, turn / spin_) : by_way;
  }

  double reach_, spin_, fall_;
};

template <class Surface>
[[nodiscard]] std::optional<Touchdown> first_touchdown(const Surface& surface, const BodyFlight& flight, double s_max) {
  constexpr int steps_near_ground = 4;  // before the sphere is asked for again
  constexpr double share_kept = 0.25;   // of the clearance, at least, in a step that is not short
  const double reach = flight.body.reach;
  const SearchSteps steps(flight);
  double s = 0, above = nearest_part(surface, flight.at(0)).gap;
  // A corner may have sunk in by rounding: the flight begins on the ground all the same.
  const double sunk = std::min(0.0, above - tolerance::corner_gap);
  above -= sunk;
  double sinking = 0;  // of the gap in the last step [m/s]
  for (int near = 0; s < s_max;) {
    const Vec3 centre = flight.path.at(s), velocity = flight.path.velocity(s);
    if (near == 0) {
      if (is_free_of_ground(surface, centre, reach)) {
        const auto contact = surface.first_contact({centre, velocity, flight.path.a}, reach, s_max - s, {});
        if (!contact) return std::nullopt;
        s += contact->t;
        above = nearest_part(surface, flight.at(s)).gap - sunk;
      }
      near = steps_near_ground;
    }
    --near;
    const double speed = velocity.norm(), shortest = steps.shortest(speed);
    double step = std::max(shortest, steps.within(above, speed));
    if (sinking > 0) step = std::max(shortest, std::min(step, (1 - 1.2 * share_kept) * above / sinking));
    double next = std::min(s_max, s + step);
    NearestPart nearest = nearest_part(surface, flight.at(next));
    if (step > shortest && nearest.gap - sunk < share_kept * above) {
      const double gap = nearest.gap - sunk;
      next = std::min(s_max, s + std::max(shortest, std::min(0.5 * step, 0.7 * step * above / (above - gap))));
      nearest = nearest_part(surface, flight.at(next));
    }
    const double gap = nearest.gap - sunk;
    if (gap <= 0) return narrowed_down(surface, flight, s, next, above, nearest, sunk);
    sinking = (above - gap) / (next - s);
    s = next;
    above = gap;
  }
  return std::nullopt;
}

[[nodiscard]] inline FacetId facet_of(const BodyTouch& touch) { return touch.contacts[0].facet; }

[[nodiscard]] inline FreeRotation rotation_of(const Body& body, const Tumbling& phase) {
  return {body.inertia, phase.orientation, phase.spin};
}

/// At the first contact, or at t_max.
template <class Surface>
[[nodiscard]] FlightEnd<BodyTouch> first_contact(const MovingRock<Surface>& rock, const Tumbling& phase,
                                                 const Parabola& path, const LinearDrag& drag, double t_max) {
  const Body& body = *rock.body;
  const FreeRotation rotation = rotation_of(body, phase);
  const BodyFlight flight{body, path, drag, rotation, rock.motion.time - phase.since};
  const auto down = first_touchdown(rock.surface, flight, t_max);
  if (!down) return {t_max, {}, {}};
  const FreeRotation::Turned turned = flight.turned_at(down->before);
  const Posture before = body.at(path.at(down->before), turned.matrix);
  Touched touched = down->part ? touched_by(rock.surface, before, tolerance::one_touch, *down->part)
                               : struck_between(rock.surface, before, flight.at(down->after), tolerance::one_touch);
  for (double wider = 10 * tolerance::one_touch; touched.is_empty() && wider < body.reach; wider *= 10) {
    touched = touched_by(rock.surface, before, wider);
  }
  if (touched.is_empty()) return {t_max, {}, {}};
  return {down->before, BodyTouch{touched.contacts(), turned}, {}};
}

template <class Surface>
[[nodiscard]] std::optional<Crossing> next_crossing_of(MovingRock<Surface>& rock, const Tumbling& phase,
                                                       const Parabola& path, const LinearDrag& drag, double t_max) {
  if (!may_meet(rock.barriers, path, t_max, rock.body->reach)) return std::nullopt;
  const FreeRotation rotation = rotation_of(*rock.body, phase);
  return next_body_crossing(rock, BodyFlight{*rock.body, path, drag, rotation, rock.motion.time - phase.since}, t_max);
}

/// The height of the lowest corner above the ground straight below it, where it is largest in a flight [m], or `known`.
/// It is looked for where a sphere within the body is higher than that. Between two looks lies a quarter of a radian or
/// 0.05 s, or a 128th of the flight: the maximum may be too low by 1 % of the reach and 3 mm, or more in long and fast
/// flights.
template <class Surface>
[[nodiscard]] double max_lowest_corner(const Surface& surface, const BodyFlight& flight, double t_end, double known) {
  constexpr std::size_t max_looks = 128;
  constexpr double turn = 0.25, time = 0.05;  // [rad], [s]
  const double inner = flight.body.inner;
  if (!(surface.max_height(flight.path, t_end, known + inner) > known + inner)) return known;
  const double wanted = t_end * std::max(flight.max_turning() / turn, 1 / time);
  const std::size_t parts = wanted < max_looks ? static_cast<std::size_t>(wanted) + 1 : max_looks;
  const auto time_of = [&](std::size_t look) { return t_end * static_cast<double>(look) / static_cast<double>(parts); };
  std::array<double, max_looks + 1> heights;  // of the centre
  std::size_t highest = 0;
  for (std::size_t look = 0; look <= parts; ++look) {
    const double height = clearance(surface, flight.path.at(time_of(look)));
    heights[look] = std::isfinite(height) ? height : 0;  // off the terrain
    if (heights[look] > heights[highest]) highest = look;
  }
  const auto look_at = [&](std::size_t look) {
    const double height = nearest_corner(surface, flight.at(time_of(look))).gap;
    if (std::isfinite(height)) known = std::max(known, height);
  };
  look_at(highest);
  for (std::size_t look = 0; look <= parts; ++look) {
    if (look != highest && heights[look] > known + inner) look_at(look);
  }
  return known;
}

template <class Surface>
[[nodiscard]] double max_height_after(const MovingRock<Surface>& rock, const Tumbling& phase, double start,
                                      const Parabola& path, const LinearDrag& drag, double t_end) {
  const FreeRotation rotation = rotation_of(*rock.body, phase);
  return max_lowest_corner(rock.surface, BodyFlight{*rock.body, path, drag, rotation, start - phase.since}, t_end,
                           rock.max_height);
}

template <class Surface, class Sink>
[[nodiscard]] Phase come_down(TrackedRock<Surface, Sink>& rock, const Tumbling& phase, const BodyTouch& touch) {
  const double flown = rock.motion.time - phase.since;
  rock.fade_friction(flown);
  return strike_with(rock, Orientation::of_matrix(touch.turned.matrix), touch.turned.spin, touch.contacts,
                     flown < tolerance::quick_impact ? phase.quick + 1 : 0);
}

template <class Surface, class Sink>
void tell_orientation(TrackedRock<Surface, Sink>& rock, const Tumbling& phase) {
  if constexpr (event::is_heard<Sink, event::Turned>) {
    const auto [orientation, spin] = rotation_of(*rock.body, phase).at(rock.motion.time - phase.since);
    rock.tell(event::Turned{rock.motion, *rock.body, orientation, spin});
  }
}

/// The body's spin after a barrier has changed that of the sphere from `before`.
template <class Surface>
[[nodiscard]] Vec3 spin_after(const MovingRock<Surface>& rock, const Vec3& spin, const Vec3& before) {
  const double norm = before.norm();
  return norm > 0 ? rock.motion.spin.norm() / norm * spin : spin;
}

template <class Surface, class Sink>
[[nodiscard]] Phase fly_on(TrackedRock<Surface, Sink>& rock, const Tumbling& phase, const Vec3& spin_before) {
  Motion& motion = rock.motion;
  rock.fade_friction(motion.time - phase.since);
  const auto [orientation, spin] = rotation_of(*rock.body, phase).at(motion.time - phase.since);
  const Vec3 left = spin_after(rock, spin, spin_before);
  motion.spin = spin_of_sphere(rock.rock, *rock.body, orientation, left);
  rock.tell(event::Turned{motion, *rock.body, orientation, left});
  return Tumbling{orientation, left, motion.time};
}

}  // namespace talus
