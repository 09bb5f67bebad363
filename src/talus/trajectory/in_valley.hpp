#pragma once
// A rock in a valley: the line in which two supports meet, between which gravity holds it.

#include "talus/trajectory/on_facet.hpp"

namespace talus {

template <class Surface>
[[nodiscard]] Footing footing_of(const MovingRock<Surface>&, const InValley& state) {
  return state.valley.footing;
}

template <class Surface>
[[nodiscard]] double longest_leg(const MovingRock<Surface>& rock, const InValley& state, const Footing& footing) {
  return state.is_on_facet ? rock.laws.timestep : longest_leg_on_edge(rock, state.friction, footing);
}

[[nodiscard]] inline GroundBeneath ground_beneath(const InValley& state, const Footing& footing) {
  return {state.on.normal, state.valley.direction, state.friction.sphere, footing};
}

/// It is guided by its other side already.
inline void be_guided(const InValley&, const Guide&) {}

template <class Surface>
[[nodiscard]] SupportPlanes carrying(const MovingRock<Surface>&, const InValley& state) {
  return {state.on.normal, state.other.normal};
}

template <class Surface>
void pass_beside(const MovingRock<Surface>&, const InValley&, const Leg&, double) {}

template <class Surface>
[[nodiscard]] std::optional<OutlineEdge> outline_ahead(MovingRock<Surface>& rock, const InValley& state,
                                                       const Parabola& leg, double& t) {
  if (!state.is_on_facet) return std::nullopt;
  auto side = side_crossed(rock, state.on.facet, leg, t, 0, &state.valley.direction);
  if (rock.is_facet(state.other)) {
    if (auto other = side_crossed(rock, state.other.facet, leg, t, 0, &state.valley.direction)) side = other;
  }
  return side;
}

/// An edge or a vertex holds a sphere against its facet only as long as it touches it.
template <class Surface>
[[nodiscard]] bool is_held(const MovingRock<Surface>& rock, const InValley& state) {
  if (rock.is_facet(state.other)) return true;
  bool is_held = false;
  rock.surface.supports(rock.motion.position, rock.reach, tolerance::still_touching,
                        [&](const Vec3& n, const Vec3&, double, FacetId) {
                          is_held = is_held || n.dot(state.other.normal) > 1 - tolerance::still_touching;
                        });
  return is_held;
}

/// On one side of a valley alone, which is `kept`.
template <class Surface>
[[nodiscard]] GroundFriction friction_on_one_side(MovingRock<Surface>& rock, const InValley& state,
                                                  const Support& kept) {
  if (rock.material_at(state.on.facet) == rock.material_at(state.other.facet)) return state.friction;
  return friction_at(rock, kept.facet);
}

/// On the ground, having left a support that it touches for a moment yet.
[[nodiscard]] inline RockState on_ground(const Support& on, bool is_on_facet, const GroundFriction& friction,
                                         const Support& left) {
  if (is_on_facet) return OnFacet{on, friction, LeftFacet{left.normal}};
  return OnEdge{on, friction, LeftFacet{left.normal}};
}

/// The rock goes on over its own support alone.
template <class Surface>
[[nodiscard]] RockState leave_other_side(MovingRock<Surface>& rock, const InValley& state) {
  return on_ground(state.on, state.is_on_facet, friction_on_one_side(rock, state, state.on), state.other);
}

/// Rounding must not lift a rock off the bottom of its valley, or press it in, leg after leg.
template <class Surface>
void stand_on(MovingRock<Surface>& rock, const InValley& state) {
  if (!state.is_on_facet || !rock.is_facet(state.other)) return;
  const Vec3 &n = state.on.normal, &m = state.other.normal;
  Vec3 shift = -height_over(rock, n, rock.outline_of(state.on.facet).point) * n;
  // To where the rock touches both planes, the shortest way.
  const Vec3 across = tangential(m, n);  // towards the first plane's side of the second one, in the first plane
  shift -=
      (height_over(rock, m, rock.surface.point_of(state.other.facet)) + m.dot(shift)) / across.squaredNorm() * across;
  lift(rock, shift);
}

/// What the rock flies off.
template <class Surface>
[[nodiscard]] SupportPlanes left_behind(const MovingRock<Surface>& rock, const InValley& state) {
  SupportPlanes left;
  if (state.is_on_facet) left.add(state.on.normal, state.on.facet);
  if (rock.is_facet(state.other)) left.add(state.other.normal, state.other.facet);
  return left;
}

/// What goes on at the end of a valley's facets.
struct AheadInValley {
  std::optional<FacetId> on, other;  // of the planes of its two sides
  std::optional<FacetId> rising;     // that which rises most against the rock
};

template <class Surface>
[[nodiscard]] AheadInValley look_along_valley(MovingRock<Surface>& rock, const InValley& state) {
  const Motion& motion = rock.motion;
  const Vec3 place = motion.position + tolerance::look_ahead * motion.velocity.normalized();
  AheadInValley ahead;
  double on_depth = 0, other_depth = 0, least_parting = std::numeric_limits<double>::infinity();
  rock.surface.supports(place, rock.reach, 0.1 * tolerance::look_ahead,
                        [&](const Vec3& n, const Vec3&, double, FacetId facet) {
                          // Several facets of one plane may touch there: the rock goes on over the one in whose outline
                          // it will be.
                          const Outline& outline = rock.outline_of(facet);
                          double depth = std::numeric_limits<double>::infinity();
                          for (int k = 0; k < outline.edge_count; ++k) {
                            const OutlineEdge& side = outline.edges[static_cast<std::size_t>(k)];
                            depth = std::min(depth, (place - side.point).dot(side.inward));
                          }
                          if (depth < -contact_slack) return;
                          const auto choose = [&](std::optional<FacetId>& chosen, double& chosen_depth) {
                            if (chosen && depth <= chosen_depth) return;
                            chosen = facet;
                            chosen_depth = depth;
                          };
                          if (n.dot(state.on.normal) > 1 - same_plane) choose(ahead.on, on_depth);
                          if (n.dot(state.other.normal) > 1 - same_plane) choose(ahead.other, other_depth);
                          if (const double parting = n.dot(motion.velocity); parting < least_parting) {
                            least_parting = parting;
                            ahead.rising = facet;
                          }
                        });
  return ahead;
}

/// The valley goes on between the next facets of both its planes.
template <class Surface>
[[nodiscard]] InValley go_on_along(MovingRock<Surface>& rock, InValley state, FacetId on, FacetId other) {
  const auto materials = [&] {
    return std::pair(rock.material_at(state.on.facet), rock.material_at(state.other.facet));
  };
  const auto materials_before = materials();
  state.on.facet = on;
  state.other.facet = other;
  state.is_on_facet = rock.is_facet(state.on);
  if (state.is_on_facet && rock.is_facet(state.other)) {
    // The same planes but for rounding, which would add up along the valley.
    const Vec3 n = rock.surface.normal(on), m = rock.surface.normal(other);
    const auto caught = caught_between(rock.laws.gravity, m, n, rock.motion.velocity, rock.leaving_speed);
    if (caught) {
      state.valley = *caught;
      state.on.normal = n;
      state.other.normal = m;
      keep_along_valley(rock, state);
    }
  }
  if (materials() != materials_before) state.friction = friction_in(rock, state);
  return state;
}

/// At the end of a valley's facets others may go on, both or one of them.
template <class Surface>
[[nodiscard]] RockState leave_valley(MovingRock<Surface>& rock, const InValley& state) {
  const AheadInValley ahead = look_along_valley(rock, state);
  if (ahead.on && ahead.other) return go_on_along(rock, state, *ahead.on, *ahead.other);
  if (ahead.on || ahead.other) {
    // The other facet ends here. The sphere touches its end for a moment yet, and must not strike it again at once.
    const Support &kept = ahead.on ? state.on : state.other, &left = ahead.on ? state.other : state.on;
    const Support on{kept.normal, ahead.on ? *ahead.on : *ahead.other};
    GroundFriction friction = friction_on_one_side(rock, state, kept);
    const bool is_on_facet = rock.is_facet(on);
    if (rock.material_at(kept.facet) != rock.material_at(on.facet)) friction = friction_at(rock, on.facet);
    return on_ground(on, is_on_facet, friction, left);
  }
  if (rock.reach == 0 && ahead.rising) {
    // Heights that are rounded bend a straight valley at every facet. Whatever lies to the side of the facet that rises
    // most is found when the rock is driven there.
    const Support rising{rock.surface.normal(*ahead.rising), *ahead.rising};
    if (rock.is_level(rising.normal) || rock.grazes(rising.normal)) {
      return go_on_over(rock, state.on, friction_on_one_side(rock, state, state.on), rising);
    }
    if (rock.motion.velocity.dot(rising.normal) < 0) {
      rock.remember_contact(state.on);
      return strike(rock, {0, rising.normal, rising.facet, Feature::facet});
    }
  }
  return take_off(rock, left_behind(rock, state));
}

template <class Surface>
[[nodiscard]] std::optional<NextState> finish_leg(MovingRock<Surface>& rock, InValley& state, const Leg& leg,
                                                  const LegEnd& end) {
  go_to_end(rock, state.on.facet, leg, end);
  if (end.rim) return NextState{leave_over_rim(rock, *end.rim)};
  stand_on(rock, state);
  if (end.ahead) return NextState{strike(rock, *end.ahead)};
  if (end.edge) {
    rock.note_energy();
    if (const auto exit = exit_at(rock, *end.edge)) return NextState{leave_over_rim(rock, *exit)};
    return NextState{leave_valley(rock, state)};
  }
  if (!state.is_on_facet) {
    // Between an edge and something else: after a while it is in the air again, if barely. (Not after a leg: where slip
    // ends at once and rolling begins, that would be for ever.)
    rock.stretch.past_edge += end.t;
    const double a_while =
        std::min(rock.laws.timestep, time_for_way(tolerance::edge_step * rock.reach, rock.motion.velocity.norm(), 0));
    if (rock.stretch.past_edge >= 0.5 * a_while) return NextState{take_off(rock)};
  }
  return std::nullopt;
}

}  // namespace talus
