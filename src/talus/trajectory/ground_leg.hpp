#pragma once
// One leg along the ground, the same for every state that is on it: where the rock rests, which law moves it, and what
// cuts the leg short. What differs from state to state is asked of the state by the functions that the concept names.

#include <concepts>

#include "talus/sliding/closed_form.hpp"
#include "talus/sliding/drag.hpp"
#include "talus/sliding/stepped.hpp"
#include "talus/sliding/supports.hpp"
#include "talus/trajectory/at_barriers.hpp"
#include "talus/trajectory/striking.hpp"

namespace talus {

/// What ends a leg before its law does.
struct LegEnd {
  double t;                         // when [s]
  std::optional<OutlineEdge> edge;  // the end of the facet's plane
  std::optional<Contact> ahead;     // other ground, of a sphere
  std::optional<Exit> rim;          // the model's end under a sphere's centre
};

/// A state of a rock on the ground.
template <class State, class Surface>
concept GroundState = requires(MovingRock<Surface>& rock, State& state, Leg& leg, double& t, const LegEnd& end,
                               const Footing& footing) {
  { footing_of(rock, state) } -> std::same_as<Footing>;
  /// How long a leg may be at the most [s].
  { longest_leg(rock, state, footing) } -> std::same_as<double>;
  { rolling_plane(rock, state) } -> std::same_as<RollingPlane>;
  { ground_beneath(state, footing) } -> std::same_as<GroundBeneath>;
  /// What carries the rock is not ahead of it.
  { carrying(rock, state) } -> std::same_as<SupportPlanes>;
  /// The next leg goes along something else, too.
  { be_guided(state, Guide{}) } -> std::same_as<void>;
  /// What the rock touches for this leg only.
  { pass_beside(rock, state, leg, t) } -> std::same_as<void>;
  /// The end of the plane, if the leg comes to it before `t`, which becomes the time.
  { outline_ahead(rock, state, leg.path, t) } -> std::same_as<std::optional<OutlineEdge>>;
  /// Goes along the leg to its end, and says what comes then.
  { finish_leg(rock, state, leg, end) } -> std::same_as<std::optional<NextState>>;
};

template <class Surface, class State>
[[nodiscard]] Leg undragged_leg(const MovingRock<Surface>& rock, const State& state, const Footing& footing,
                                double timestep) {
  const auto& [position, velocity, spin, time] = rock.motion;
  if (!rock.is_sphere()) {
    const auto law = rock.laws.sliding == SlidingMethod::stepped ? stepped_leg : closed_form_leg;
    return law(position, velocity, spin, footing, state.friction.mu, timestep);
  }
  const auto [n, round, friction] = rolling_plane(rock, state);
  return rolling_leg(position, velocity, spin, n, footing, round, friction, timestep);
}

template <class Surface, class State>
[[nodiscard]] Leg next_leg(const MovingRock<Surface>& rock, const State& state, const Footing& footing) {
  const double longest = longest_leg(rock, state, footing), drag = state.friction.drag;
  if (drag == 0) return undragged_leg(rock, state, footing, longest);
  const Vec3& velocity = rock.motion.velocity;
  const bool rolls = rock.is_sphere() && rock.state_on(state.on.normal) == PathState::rolling;
  const RollingPlane plane = rolling_plane(rock, state);
  const double friction = footing.normal_acceleration * (rolls              ? plane.friction.rolling
                                                         : rock.is_sphere() ? plane.friction.dynamic
                                                                            : state.friction.mu);
  const Vec3 net = footing.pull - friction / std::max(velocity.norm(), tolerance::least_speed) * velocity;
  const double timestep = dragged_timestep(drag, longest, net, velocity);
  const double share = rolls ? rolling_share(plane.rock) : 1;
  return cut_short(undragged_leg(rock, state, dragged(footing, velocity, drag, timestep, share), timestep), timestep);
}

/// Whether the rock has come to its end here.
template <class Surface, class State>
[[nodiscard]] bool rests(const MovingRock<Surface>& rock, const State& state, const Footing& footing) {
  const Motion& motion = rock.motion;
  const double speed = motion.velocity.norm();
  const bool to_the_end = !rock.is_sphere() && rock.laws.sliding == SlidingMethod::closed_form;
  if (speed > rock.laws.stopped_velocity) return false;
  if (rock.is_sphere() && state.friction.sphere.dynamic > 0) {
    // Friction drives a sphere that stands and spins.
    const Vec3 slip = slip_velocity(motion.velocity, motion.spin, state.on.normal, rock.rock.radius);
    if (slip.norm() > rock.laws.stopped_velocity) return false;
  }
  const auto is_held = [&](Footing f) {
    // What drag would keep slower than where a rock may stop, does not move.
    const double crawl = state.friction.drag * rock.laws.stopped_velocity, pull = f.pull.norm();
    if (crawl > 0) f.pull *= std::max(0.0, 1 - crawl / std::max(pull, tolerance::least_speed));
    return rock.is_sphere() ? holds(f, rolling_plane(rock, state).friction) : holds(f, state.friction.mu);
  };
  if (is_held(footing)) return !to_the_end || speed < tolerance::standstill;  // the closed form slides until it stands
  // In a corner of several facets it may be held where one of them alone would not.
  Supports supports;
  supports.add(state.on.normal);
  rock.surface.supports(motion.position, rock.reach, tolerance::support_reach,
                        [&](const Vec3& n, const Vec3& middle, double, FacetId) {
                          // A point on a ridge touches both its sides and is caught between neither: only what rises
                          // from here counts.
                          const bool rises = (middle - motion.position).dot(state.on.normal) > 0;
                          if (rock.reach > 0 || rises) supports.add(n);
                        });
  return supports.count() > 1 && is_held(footing_on(rock.laws.gravity, supports));
}

/// Along a leg until `t`, where the rock crosses something: `back` points to where it comes from across that, and is
/// zero where there is nothing to cross.
template <class Surface>
void go_along(MovingRock<Surface>& rock, const Leg& leg, double t, const Vec3& back) {
  Motion& motion = rock.motion;
  motion.position = leg.path.at(t);
  motion.time += t;
  if (t >= leg.duration) {
    motion.velocity = leg.end_velocity;
    motion.spin = leg.end_spin;
    return;
  }
  if (!std::isfinite(leg.duration)) {  // a closed form; spin does not change
    motion.velocity = leg.path.velocity(t);
    return;
  }
  // A step that is cut short changes the velocity by its share only: it must neither gain speed nor turn for ground not
  // covered.
  const double share = t / leg.duration;
  motion.velocity += share * (leg.end_velocity - motion.velocity);
  motion.spin += share * (leg.end_spin - motion.spin);
  // A step of a slide moves along its last velocity, and so may cross what the velocity leads away from yet: it goes
  // along that then.
  motion.velocity -= std::max(0.0, motion.velocity.dot(back)) * back;
}

/// Where a sphere leaves the model that goes along a leg until `t`, its centre being beside the terrain before its
/// facet ends.
template <class Surface>
[[nodiscard]] std::optional<Exit> rim_ahead(const MovingRock<Surface>& rock, FacetId facet, const Parabola& leg,
                                            double& t) {
  const auto is_beside = [&](double at) { return !rock.surface.has_ground_below(leg.at(at), facet); };
  if (rock.reach == 0 || !is_beside(t)) return std::nullopt;
  double inside = 0, beside = t;
  for (double middle = 0.5 * beside; middle > inside && middle < beside; middle = 0.5 * (inside + beside)) {
    (is_beside(middle) ? beside : inside) = middle;
  }
  // Seen from the last place that has ground below it: of what is beside the terrain, the surface cannot tell whether
  // it is in the open or under ground.
  const auto exit = rock.exit_from(leg.at(inside), leg.velocity(inside));
  if (exit) t = beside;
  return exit;
}

/// Other ground ahead of a sphere, on a leg until `t`.
template <class Surface, class State>
[[nodiscard]] std::optional<Contact> ground_ahead(const MovingRock<Surface>& rock, const State&, const Parabola& leg,
                                                  double t, const SupportPlanes& on) {
  return rock.surface.first_contact_on_leg(leg, rock.reach, t, on);
}

/// What cuts a leg short: the facet's outline, other ground ahead of a sphere, the model's rim; in this order at ties.
template <class Surface, class State>
[[nodiscard]] LegEnd end_of_leg(MovingRock<Surface>& rock, State& state, const Leg& leg, double t,
                                const SupportPlanes& on) {
  LegEnd end{t, outline_ahead(rock, state, leg.path, t), {}, {}};
  if (rock.reach > 0) {
    end.ahead = ground_ahead(rock, state, leg.path, t, on);
    if (end.ahead) {
      t = end.ahead->t;
      end.edge.reset();
    }
  }
  end.rim = rim_ahead(rock, state.on.facet, leg.path, t);
  if (end.rim) {
    end.edge.reset();
    end.ahead.reset();
  }
  end.t = t;
  return end;
}

/// What barriers make of a leg: untouched if there is none in its way, or the rock is held by one, or goes on from it;
/// or it does not begin, because the rock is driven onto one along which it is to go.
struct LegAtBarriers {
  AtBarrier then = AtBarrier::untouched;
  std::optional<Guide> guide;
};

template <class Surface>
[[nodiscard]] LegAtBarriers meet_barriers(MovingRock<Surface>& rock, FacetId facet, const Leg& leg, double t,
                                          const GroundBeneath& on) {
  while (const auto crossing = next_crossing(rock, leg.path, t)) {
    if (is_driven_onto(rock, *crossing, on)) return {AtBarrier::untouched, Guide{crossing->normal}};
    const Motion before = rock.motion;
    go_along(rock, leg, crossing->t, crossing->normal);
    if (crossing->above) {  // whose foot lies under the ground here
      pass_above(rock, *crossing, std::exchange(rock.motion, before));
      continue;
    }
    const Motion arrived = rock.motion;
    const AtBarrier then = meet_barrier(rock, *crossing, rock.motion.time, on.footing.pull, &on);
    if (then != AtBarrier::untouched) {
      rock.note_leg(facet, leg.path, crossing->t, before, arrived);
      return {then, {}};
    }
    rock.motion = before;
  }
  return {};
}

/// One leg; gives what comes after it, or nothing where the rock goes on as before.
template <class Surface, class State>
requires GroundState<State, Surface>
[[nodiscard]] std::optional<NextState> take_leg(MovingRock<Surface>& rock, State& state) {
  Motion& motion = rock.motion;
  const Footing footing = footing_of(rock, state);
  rock.progress.note(motion, std::min(1.0, rock.laws.timestep / 0.01));
  if (rests(rock, state, footing) || rock.is_wedged()) return NextState{come_to_rest(rock)};
  if (motion.time >= rock.laws.max_time) return NextState{Ended{EndReason::maximum_time}};
  const bool still = motion.velocity.squaredNorm() == 0;
  if (still && !std::exchange(rock.stretch.has_turned, true)) rock.log.turn(motion);

  Leg leg = next_leg(rock, state, footing);
  double t = std::min(leg.duration, rock.laws.max_time - motion.time);
  const SupportPlanes on = carrying(rock, state);
  pass_beside(rock, state, leg, t);
  const LegEnd end = end_of_leg(rock, state, leg, t, on);
  const GroundBeneath beneath = ground_beneath(state, footing);
  const LegAtBarriers barriers = meet_barriers(rock, state.on.facet, leg, end.t, beneath);
  if (barriers.then == AtBarrier::held) return NextState{Ended{EndReason::stopped_by_barrier}};
  if (barriers.then == AtBarrier::goes_on) {
    motion.velocity = beneath.kept(motion.velocity);
    rock.note_row(rock.state_on(state.on.normal));
    return NextState{state};  // a stretch of its own, which counts
  }
  if (barriers.guide) {
    be_guided(state, *barriers.guide);
    return std::nullopt;
  }
  return finish_leg(rock, state, leg, end);
}

// ---- shared by states ----

/// Goes along a leg to its end on the ground.
template <class Surface>
void go_to_end(MovingRock<Surface>& rock, FacetId facet, const Leg& leg, const LegEnd& end) {
  const Motion before = rock.motion;
  go_along(rock, leg, end.t, end.edge ? end.edge->inward : Vec3(Vec3::Zero()));
  rock.note_leg(facet, leg.path, end.t, before, rock.motion);
  rock.note_energy();
}

/// Lifts a rock by what rounding has pressed it into the ground, or it off. A sphere may have sunk in by more than
/// rounding: what lifting it costs, it pays, and without the means it stays.
template <class Surface>
void lift(MovingRock<Surface>& rock, const Vec3& shift) {
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

/// How high a rock's skin is over a plane [m].
template <class Surface>
[[nodiscard]] double height_over(const MovingRock<Surface>& rock, const Vec3& n, const Vec3& point) {
  return n.dot(rock.motion.position - point) - rock.reach;
}

/// The first side of a facet that a leg crosses outwards before `t`, which becomes the time; the leg comes to the facet
/// at the time `from`. `valley`: the direction of the valley along which it goes, if it does.
template <class Surface>
[[nodiscard]] std::optional<OutlineEdge> side_crossed(MovingRock<Surface>& rock, FacetId facet, const Parabola& leg,
                                                      double& t, double from = 0, const Vec3* valley = nullptr) {
  const Outline& outline = rock.outline_of(facet);
  std::optional<int> crossed_side;
  for (int k = 0; k < outline.edge_count; ++k) {
    const OutlineEdge& side = outline.edges[static_cast<std::size_t>(k)];
    // The bottom of a valley is a side of both its facets; along it there is no crossing it.
    if (valley != nullptr && std::abs(side.inward.dot(*valley)) < tolerance::along_valley) continue;
    const double distance = (leg.p - side.point).dot(side.inward);
    const double speed = leg.v.dot(side.inward), acceleration = leg.a.dot(side.inward);
    // Most legs are short and stay far from all sides.
    const double nearest = distance + std::min(speed, 0.0) * t + 0.5 * std::min(acceleration, 0.0) * t * t;
    if (nearest > 0) continue;
    auto crossed = falling_root(distance, speed, acceleration, 1e300);
    if (crossed && *crossed < from) {  // a bent way may have crossed the line of the side before it came here
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

/// What a rock touches for one leg: along a guide it goes where that leads; a facet that it has left is not ahead for
/// the next bit of way.
template <class Surface>
void pass_beside(const MovingRock<Surface>& rock, const Support& on, Beside& beside, Leg& leg, double& t) {
  if (const auto* guide = std::get_if<Guide>(&beside)) {
    leg = guided(leg, on.normal.cross(guide->normal).normalized());
  } else if (std::holds_alternative<LeftFacet>(beside)) {
    t = std::min(t, time_for_way(tolerance::past_the_end, rock.motion.velocity.norm(), leg.path.a.norm()));
  }
  beside = {};
}

[[nodiscard]] inline const Vec3* normal_of(const Beside& beside) {
  if (const auto* left = std::get_if<LeftFacet>(&beside)) return &left->normal;
  if (const auto* guide = std::get_if<Guide>(&beside)) return &guide->normal;
  return nullptr;
}

}  // namespace talus
