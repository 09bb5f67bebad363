#pragma once
// One leg along the ground, common to all phases on it: whether the rock rests, the law that moves it, and what cuts
// the leg short. What differs between phases is in the functions that the concept GroundPhase lists.

#include <concepts>

#include "talus/rocks/arc_length.hpp"
#include "talus/sliding/closed_form.hpp"
#include "talus/sliding/drag.hpp"
#include "talus/sliding/stepped.hpp"
#include "talus/sliding/supports.hpp"
#include "talus/trajectory/at_barriers.hpp"
#include "talus/trajectory/striking.hpp"

namespace talus {

/// Where a leg ends, and what cuts it short.
struct LegEnd {
  double t;                         // duration until then [s]
  std::optional<OutlineEdge> edge;  // the end of the facet's plane
  std::optional<Contact> ahead;     // other ground that a sphere touches
  std::optional<Exit> rim;          // the edge of the model, below a sphere's centre
};

/// A phase of a rock on the ground: the functions that take_leg() needs of it.
template <class Current, class Surface, class Sink>
concept GroundPhase = requires(TrackedRock<Surface, Sink>& rock, Current& phase, Leg& leg, double& t, const LegEnd& end,
                               const Footing& footing) {
  { footing_of(rock, phase) } -> std::same_as<Footing>;
  /// Maximum duration of a leg [s].
  { longest_leg(rock, phase, footing) } -> std::same_as<double>;
  { rolling_plane(rock, phase) } -> std::same_as<RollingPlane>;
  { ground_beneath(rock, phase, footing) } -> std::same_as<GroundBeneath>;
  /// What carries the rock, so that a leg does not collide with it.
  { carrying(rock, phase) } -> std::same_as<SupportPlanes>;
  /// The next leg also runs along a guide.
  { set_guide(phase, Guide{}) } -> std::same_as<void>;
  /// The guide of the next leg, or null.
  { guide_of(phase) } -> std::same_as<const Guide*>;
  /// Applies the phase's side contact, if any, to this leg, and clears it.
  { apply_side_contact(rock, phase, leg, t) } -> std::same_as<void>;
  /// The end of the plane, if the leg reaches it before `t`, which is then set to that time.
  { outline_ahead(rock, phase, leg.path, t) } -> std::same_as<std::optional<OutlineEdge>>;
  /// Moves the rock to the end of the leg, and returns the phase there if it has changed.
  { finish_leg(rock, phase, leg, end) } -> std::same_as<std::optional<NextPhase>>;
};

template <class Surface, class Current>
[[nodiscard]] Leg leg_without_drag(const MovingRock<Surface>& rock, const Current& phase, const Footing& footing,
                                   double timestep) {
  const auto& [position, velocity, spin, time] = rock.motion;
  if (!rock.is_sphere()) {
    const auto law = rock.laws.sliding == SlidingMethod::stepped ? stepped_leg : closed_form_leg;
    return law(position, velocity, spin, footing, phase.friction.mu, timestep);
  }
  const auto [n, round, friction] = rolling_plane(rock, phase);
  return rolling_leg(position, velocity, spin, n, footing, round, friction, timestep);
}

template <class Surface, class Current>
[[nodiscard]] Leg next_leg(const MovingRock<Surface>& rock, const Current& phase, const Footing& footing) {
  const double longest = longest_leg(rock, phase, footing), drag = phase.friction.drag;
  if (drag == 0) return leg_without_drag(rock, phase, footing, longest);
  const Vec3& velocity = rock.motion.velocity;
  const bool rolls = rock.is_sphere() && rock.state_on(phase.on.normal) == PathState::rolling;
  const RollingPlane plane = rolling_plane(rock, phase);
  const double friction = footing.normal_acceleration * (rolls              ? plane.friction.rolling
                                                         : rock.is_sphere() ? plane.friction.dynamic
                                                                            : phase.friction.mu);
  const double timestep = dragged_timestep(drag, longest, net_pull(footing, friction, velocity), velocity);
  const double share = rolls ? rolling_share(plane.rock) : 1;
  return cut_short(leg_without_drag(rock, phase, dragged(footing, velocity, drag, timestep, share), timestep),
                   timestep);
}

/// Whether the rock stops here.
template <class Surface, class Current>
[[nodiscard]] bool rests(const MovingRock<Surface>& rock, const Current& phase, const Footing& footing) {
  const Motion& motion = rock.motion;
  const double speed = motion.velocity.norm();
  const bool has_closed_form = !rock.is_sphere() && rock.laws.sliding == SlidingMethod::closed_form;
  if (speed > rock.laws.stopped_velocity) return false;
  if (rock.is_sphere() && phase.friction.sphere.dynamic > 0) {
    // Friction accelerates a sphere that stands and spins.
    const Vec3 slip = slip_velocity(motion.velocity, motion.spin, phase.on.normal, rock.rock.radius);
    if (slip.norm() > rock.laws.stopped_velocity) return false;
  }
  const auto is_held = [&](Footing f) {
    // A pull that drag balances below the stopping velocity does not move the rock.
    const double crawl = phase.friction.drag * rock.laws.stopped_velocity, pull = f.pull.norm();
    if (crawl > 0) f.pull *= std::max(0.0, 1 - crawl / std::max(pull, tolerance::least_speed));
    return rock.is_sphere() ? holds(f, rolling_plane(rock, phase).friction) : holds(f, phase.friction.mu);
  };
  if (is_held(footing))
    return !has_closed_form || speed < tolerance::standstill;  // closed form: slides to a standstill
  // Several facets in a corner may hold a rock that one of them alone would not.
  Supports supports;
  supports.add(phase.on.normal);
  rock.surface.supports(motion.position, rock.reach, tolerance::support_reach,
                        [&](const Vec3& n, const Vec3& middle, double, FacetId) {
                          // A point on a ridge touches both its sides, but neither holds it: only facets that rise
                          // from here count.
                          const bool rises = (middle - motion.position).dot(phase.on.normal) > 0;
                          if (rock.reach > 0 || rises) supports.add(n);
                        });
  return supports.count() > 1 && is_held(footing_on(rock.laws.gravity, supports));
}

/// Moves the rock along a leg until `t`. If it then crosses something, `back` is the unit normal of that, towards where
/// the rock comes from; otherwise zero.
template <class Surface>
void move_along(MovingRock<Surface>& rock, const Leg& leg, double t, const Vec3& back) {
  Motion& motion = rock.motion;
  motion.position = leg.path.at(t);
  motion.time += t;
  if (t >= leg.duration) {
    motion.velocity = leg.end_velocity;
    motion.spin = leg.end_spin;
    return;
  }
  if (!std::isfinite(leg.duration)) {  // closed form; the spin does not change
    motion.velocity = leg.path.velocity(t);
    return;
  }
  // A step that is cut short changes the velocity in proportion to its duration: a rock must not gain speed or turn on
  // ground that it has not covered.
  const double share = t / leg.duration;
  motion.velocity += share * (leg.end_velocity - motion.velocity);
  motion.spin += share * (leg.end_spin - motion.spin);
  // A step of a slide moves with the velocity at its end. The interpolated velocity may therefore still point back from
  // what the step crosses: that component is removed.
  motion.velocity -= std::max(0.0, motion.velocity.dot(back)) * back;
}

/// Where a sphere on a leg until `t` leaves the model: its centre may be off the terrain before its facet ends. `t` is
/// then set to that time.
template <class Surface>
[[nodiscard]] std::optional<Exit> rim_ahead(const MovingRock<Surface>& rock, FacetId facet, const Parabola& leg,
                                            double& t) {
  const auto is_off_terrain = [&](double at) { return !rock.surface.has_ground_below(leg.at(at), facet); };
  if (rock.reach == 0 || !is_off_terrain(t)) return std::nullopt;
  double inside = 0, outside = t;
  for (double middle = 0.5 * outside; middle > inside && middle < outside; middle = 0.5 * (inside + outside)) {
    (is_off_terrain(middle) ? outside : inside) = middle;
  }
  // The exit is searched from the last place with ground below: off the terrain, a surface cannot distinguish open air
  // from underground.
  const auto exit = rock.exit_from(leg.at(inside), leg.velocity(inside));
  if (exit) t = outside;
  return exit;
}

/// Other ground that a sphere touches on a leg until `t`.
template <class Surface, class Current>
[[nodiscard]] std::optional<Contact> ground_ahead(const MovingRock<Surface>& rock, const Current&, const Parabola& leg,
                                                  double t, const SupportPlanes& on) {
  return rock.surface.first_contact_on_leg(leg, rock.reach, t, on);
}

/// What cuts a leg short: the facet's outline, other ground that a sphere touches, the edge of the model. In this order
/// at ties.
template <class Surface, class Current>
[[nodiscard]] LegEnd end_of_leg(MovingRock<Surface>& rock, Current& phase, const Leg& leg, double t,
                                const SupportPlanes& on) {
  LegEnd end{t, outline_ahead(rock, phase, leg.path, t), {}, {}};
  if (rock.reach > 0) {
    end.ahead = ground_ahead(rock, phase, leg.path, t, on);
    if (end.ahead) {
      t = end.ahead->t;
      end.edge.reset();
    }
  }
  end.rim = rim_ahead(rock, phase.on.facet, leg.path, t);
  if (end.rim) {
    end.edge.reset();
    end.ahead.reset();
  }
  end.t = t;
  return end;
}

/// When a leg comes to the next bump of the ground, if before `t`, which is then set to that time.
template <class Surface>
[[nodiscard]] bool bump_ahead(MovingRock<Surface>& rock, FacetId facet, const Parabola& leg, double& t) {
  const double way = rock.way_to_bump(facet);
  if (!std::isfinite(way)) return false;
  const auto at = time_at_length(leg, way, t);
  if (at) t = *at;
  return at.has_value();
}

/// The effect of barriers on a leg. With a guide, the leg does not begin: the rock is driven against a barrier, and the
/// next leg must run along it.
struct LegAtBarriers {
  AtBarrier effect = AtBarrier::unaffected;
  std::optional<Guide> guide;
};

template <class Surface, class Sink>
[[nodiscard]] LegAtBarriers meet_barriers(TrackedRock<Surface, Sink>& rock, FacetId facet, const Leg& leg, double t,
                                          const GroundBeneath& on) {
  while (const auto crossing = next_crossing(rock, leg.path, t)) {
    if (is_driven_onto(rock, *crossing, on)) return {AtBarrier::unaffected, Guide{crossing->normal}};
    const Motion before = rock.motion;
    move_along(rock, leg, crossing->t, crossing->normal);
    if (crossing->above) {  // a barrier whose foot is below the ground here
      pass_above(rock, *crossing, std::exchange(rock.motion, before));
      continue;
    }
    const Motion arrived = rock.motion;
    const AtBarrier effect = meet_barrier(rock, *crossing, rock.motion.time, on.footing.pull, &on);
    if (effect != AtBarrier::unaffected) {
      rock.cover_leg(facet, leg.path, crossing->t, before, arrived);
      return {effect, {}};
    }
    rock.motion = before;
  }
  return {};
}

/// The direction of the line in which a guide meets a rock's support of normal `n`, unit.
[[nodiscard]] inline Vec3 line_along(const Guide& guide, const Vec3& n) { return n.cross(guide.normal).normalized(); }

/// Next to a guide the rock can only move along that line: this part of its velocity and pull is left to it, and its
/// spin. (If it were also pulled across the line, its slip would turn there, where it cannot go, and friction along
/// that slip could drive it.)
template <class Surface>
void keep_along_guide(MovingRock<Surface>& rock, const Vec3& n, const Guide& guide, Footing& footing) {
  const Vec3 e = line_along(guide, n);
  Vec3& velocity = rock.motion.velocity;
  velocity = velocity.dot(e) * e;
  footing.pull = footing.pull.dot(e) * e;
}

/// One leg. Returns the phase after it, or nullopt if the phase has not changed.
template <class Surface, class Sink, class Current>
requires GroundPhase<Current, Surface, Sink>
[[nodiscard]] std::optional<NextPhase> take_leg(TrackedRock<Surface, Sink>& rock, Current& phase) {
  Motion& motion = rock.motion;
  Footing footing = footing_of(rock, phase);
  rock.progress.record(motion, rock.reach, std::min(1.0, rock.laws.timestep / 0.01));
  if (rests(rock, phase, footing) || rock.is_wedged()) return NextPhase{come_to_rest(rock)};
  if (motion.time >= rock.laws.max_time) return NextPhase{Ended{EndReason::maximum_time}};
  const bool stands = motion.velocity.squared_norm() == 0;
  if (stands && !std::exchange(rock.stretch.has_turned, true)) rock.tell(event::Turn{motion});

  if (const Guide* const guide = guide_of(phase)) keep_along_guide(rock, phase.on.normal, *guide, footing);
  Leg leg = next_leg(rock, phase, footing);
  double t = std::min(leg.duration, rock.laws.max_time - motion.time);
  const SupportPlanes on = carrying(rock, phase);
  apply_side_contact(rock, phase, leg, t);
  const bool comes_to_bump = bump_ahead(rock, phase.on.facet, leg.path, t);
  const LegEnd end = end_of_leg(rock, phase, leg, t, on);
  const GroundBeneath beneath = ground_beneath(rock, phase, footing);
  const LegAtBarriers barriers = meet_barriers(rock, phase.on.facet, leg, end.t, beneath);
  if (barriers.effect == AtBarrier::stopped) return NextPhase{Ended{EndReason::stopped_by_barrier}};
  if (barriers.effect == AtBarrier::continues) {
    motion.velocity = beneath.along_ground(motion.velocity);
    rock.leave(rock.state_on(phase.on.normal));
    return NextPhase{phase};  // a new stretch, which counts as a step
  }
  if (barriers.guide) {
    set_guide(phase, *barriers.guide);
    return std::nullopt;
  }
  if (auto next = finish_leg(rock, phase, leg, end)) return next;
  if (!comes_to_bump || end.t < t) return std::nullopt;
  const Feature feature = rock.is_facet(phase.on) ? Feature::facet : Feature::edge;
  rock.remember_contact(phase.on);
  auto next = strike_bump(rock, {0, phase.on.normal, phase.on.facet, feature});
  return next ? std::optional(NextPhase{*std::move(next)}) : std::nullopt;
}

// ---- shared by phases ----

/// Moves the rock to the end of a leg.
template <class Surface, class Sink>
void move_to_end(TrackedRock<Surface, Sink>& rock, FacetId facet, const Leg& leg, const LegEnd& end) {
  const Motion before = rock.motion;
  move_along(rock, leg, end.t, end.edge ? end.edge->inward : Vec3{});
  rock.cover_leg(facet, leg.path, end.t, before, rock.motion);
  rock.update_max_energy();
}

/// Moves a rock back to the surface, from which rounding has shifted it up or down. A sphere may have sunk in by more
/// than rounding: it then pays for the lift with kinetic energy, or stays where it is if it has too little.
template <class Surface>
void correct_position(MovingRock<Surface>& rock, const Vec3& shift) {
  Motion& motion = rock.motion;
  const double work = shift.norm() > contact_slack ? -rock.rock.mass * shift.dot(rock.laws.gravity) : 0;
  if (work > 0) {
    const double energy = rock.kinetic_energy();
    if (energy <= work) return;
    const double kept = std::sqrt(1 - work / energy);
    motion.velocity *= kept;
    motion.spin *= kept;
  }
  motion.position += shift;
}

/// The gap between a rock's surface and a plane [m].
template <class Surface>
[[nodiscard]] double gap_to_plane(const MovingRock<Surface>& rock, const Vec3& n, const Vec3& point) {
  return n.dot(rock.motion.position - point) - rock.reach;
}

/// The first side of a facet that a leg crosses outwards before `t`, which is then set to that time. `from`: the time
/// at which the leg reaches the facet. `valley`: the direction of the rock's valley, if it is in one.
template <class Surface>
[[nodiscard]] std::optional<OutlineEdge> side_crossed(MovingRock<Surface>& rock, FacetId facet, const Parabola& leg,
                                                      double& t, double from = 0, const Vec3* valley = nullptr) {
  const Outline& outline = rock.outline_of(facet);
  std::optional<int> crossed_side;
  for (int k = 0; k < outline.edge_count; ++k) {
    const OutlineEdge& side = outline.edges[static_cast<std::size_t>(k)];
    // The bottom of a valley is a side of both its facets; a rock that moves along it does not cross it.
    if (valley != nullptr && std::abs(side.inward.dot(*valley)) < tolerance::along_valley) continue;
    const double distance = (leg.p - side.point).dot(side.inward);
    const double speed = leg.v.dot(side.inward), acceleration = leg.a.dot(side.inward);
    // Most legs are short and far from all sides.
    const double nearest = distance + std::min(speed, 0.0) * t + 0.5 * std::min(acceleration, 0.0) * t * t;
    if (nearest > 0) continue;
    auto crossed = falling_root(distance, speed, acceleration, 1e300);
    if (crossed && *crossed < from) {  // a curved leg may have crossed the side's line before it reached the facet
      crossed = falling_root(distance + from * (speed + 0.5 * from * acceleration), speed + from * acceleration,
                             acceleration, 1e300);
      if (crossed) *crossed += from;
    }
    if (crossed && *crossed < t) {
      t = *crossed;
      crossed_side = k;
    }
  }
  return crossed_side ? std::optional(outline.edges[static_cast<std::size_t>(*crossed_side)]) : std::nullopt;
}

// ---- of a rock that one support carries: a facet, an edge or a vertex ----

template <class Surface>
[[nodiscard]] RollingPlane rolling_plane(const MovingRock<Surface>& rock, const OnSupport& phase) {
  return {phase.on.normal, rock.rock, phase.friction.sphere};
}

template <class Surface>
[[nodiscard]] GroundBeneath ground_beneath(const MovingRock<Surface>&, const OnSupport& phase, const Footing& footing) {
  return {phase.on.normal, {}, phase.friction.sphere, footing};
}

inline void set_guide(OnSupport& phase, const Guide& guide) { phase.side_contact = guide; }

[[nodiscard]] inline const Guide* guide_of(const OnSupport& phase) { return std::get_if<Guide>(&phase.side_contact); }

/// Applies a side contact to one leg: with a guide, the leg runs along it; next to a facet that the rock has left, it
/// is so short that it ends before it could strike that facet.
template <class Surface>
void apply_side_contact(const MovingRock<Surface>& rock, OnSupport& phase, Leg& leg, double& t) {
  if (const auto* guide = std::get_if<Guide>(&phase.side_contact)) {
    leg = guided(leg, line_along(*guide, phase.on.normal));
  } else if (std::holds_alternative<LeftFacet>(phase.side_contact)) {
    t = std::min(t, time_for_way(tolerance::past_the_end, rock.motion.velocity.norm(), leg.path.a.norm()));
  }
  phase.side_contact = {};
}

[[nodiscard]] inline const Vec3* normal_of(const SideContact& side_contact) {
  if (const auto* left = std::get_if<LeftFacet>(&side_contact)) return &left->normal;
  if (const auto* guide = std::get_if<Guide>(&side_contact)) return &guide->normal;
  return nullptr;
}

}  // namespace talus
