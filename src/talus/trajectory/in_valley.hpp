#pragma once
// A rock in a valley: gravity holds it between two supports, and it moves along the line in which they meet.

#include "talus/trajectory/on_facet.hpp"

namespace talus {

template <class Surface>
[[nodiscard]] Footing footing_of(const MovingRock<Surface>&, const InValley& state) {
  return state.valley.footing;
}

template <class Surface>
[[nodiscard]] double longest_leg(const MovingRock<Surface>& rock, const InValley& state, const Footing& footing) {
  return state.is_on_facet ? longest_leg_on_planes(rock, state.friction, footing)
                           : longest_leg_on_edge(rock, state.friction, footing);
}

[[nodiscard]] inline GroundBeneath ground_beneath(const InValley& state, const Footing& footing) {
  return {state.on.normal, state.valley.direction, state.friction.sphere, footing};
}

/// Its other side already guides it.
inline void set_guide(const InValley&, const Guide&) {}

[[nodiscard]] inline const Guide* guide_of(const InValley&) { return nullptr; }

template <class Surface>
[[nodiscard]] SupportPlanes carrying(const MovingRock<Surface>&, const InValley& state) {
  return {state.on.normal, state.other.normal};
}

/// Each leg runs along the valley: rounding across it would grow, since friction acts along slip however small.
template <class Surface>
void apply_side_contact(const MovingRock<Surface>& rock, const InValley& state, Leg& leg, double&) {
  leg = guided(leg, state.valley.direction);
  if (rock.is_sphere()) leg.end_spin = spin_in_valley(rock, state, leg.end_spin);
}

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

/// Whether the other side still holds the rock: an edge or a vertex holds a sphere only as long as it touches it.
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

/// The friction after the rock has left one side of a valley and moves on along the other, `kept`.
template <class Surface>
[[nodiscard]] GroundFriction friction_on_one_side(MovingRock<Surface>& rock, const InValley& state,
                                                  const Support& kept) {
  if (rock.material_at(state.on.facet) == rock.material_at(state.other.facet)) return state.friction;
  return friction_at(rock, kept.facet);
}

/// On the ground next to a support that the rock has left, but still touches.
[[nodiscard]] inline RockState on_ground(const Support& on, bool is_on_facet, const GroundFriction& friction,
                                         const Support& left) {
  if (is_on_facet) return OnFacet{on, friction, LeftFacet{left.normal}};
  return OnEdge{on, friction, LeftFacet{left.normal}};
}

/// The rock moves on over its own support alone.
template <class Surface>
[[nodiscard]] RockState leave_other_side(MovingRock<Surface>& rock, const InValley& state) {
  return on_ground(state.on, state.is_on_facet, friction_on_one_side(rock, state, state.on), state.other);
}

/// Puts the rock back on the bottom of its valley, so that rounding does not add up from leg to leg.
template <class Surface>
void remove_drift(MovingRock<Surface>& rock, const InValley& state) {
  if (!state.is_on_facet || !rock.is_facet(state.other)) return;
  const Vec3 &n = state.on.normal, &m = state.other.normal;
  Vec3 shift = -gap_to_plane(rock, n, rock.outline_of(state.on.facet).point) * n;
  // The shortest shift to where the rock touches both planes.
  const Vec3 across = tangential(m, n);  // in the first plane, away from the second
  shift -=
      (gap_to_plane(rock, m, rock.surface.point_of(state.other.facet)) + m.dot(shift)) / across.squared_norm() * across;
  correct_position(rock, shift);
}

/// The facets that the rock takes off from.
template <class Surface>
[[nodiscard]] SupportPlanes planes_left(const MovingRock<Surface>& rock, const InValley& state) {
  SupportPlanes left;
  if (state.is_on_facet) left.add(state.on.normal, state.on.facet);
  if (rock.is_facet(state.other)) left.add(state.other.normal, state.other.facet);
  return left;
}

/// The ground beyond the end of a valley's facets.
struct AheadInValley {
  std::optional<FacetId> on, other;  // facets in the planes of its two sides
  std::optional<FacetId> rising;     // the facet that rises most steeply against the rock
};

template <class Surface>
[[nodiscard]] AheadInValley look_along_valley(MovingRock<Surface>& rock, const InValley& state) {
  const Motion& motion = rock.motion;
  const Vec3 place = motion.position + tolerance::look_ahead * motion.velocity.normalized();
  AheadInValley ahead;
  double on_depth = 0, other_depth = 0, least_parting = std::numeric_limits<double>::infinity();
  rock.surface.supports(place, rock.reach, 0.1 * tolerance::look_ahead,
                        [&](const Vec3& n, const Vec3&, double, FacetId facet) {
                          // Of several facets in one plane the rock moves on over the one whose outline it will be
                          // in.
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

/// The valley continues between the next facets of both its planes.
template <class Surface>
[[nodiscard]] InValley continue_along(MovingRock<Surface>& rock, InValley state, FacetId on, FacetId other) {
  const auto materials = [&] {
    return std::pair(rock.material_at(state.on.facet), rock.material_at(state.other.facet));
  };
  const auto materials_before = materials();
  state.on.facet = on;
  state.other.facet = other;
  state.is_on_facet = rock.is_facet(state.on);
  if (state.is_on_facet && rock.is_facet(state.other)) {
    // The planes are the same but for rounding, which would add up along the valley.
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

/// The state of a rock that has reached the end of its valley's facets. Both planes may continue, or one of them.
template <class Surface>
[[nodiscard]] RockState leave_valley(MovingRock<Surface>& rock, const InValley& state) {
  const AheadInValley ahead = look_along_valley(rock, state);
  if (ahead.on && ahead.other) return continue_along(rock, state, *ahead.on, *ahead.other);
  if (ahead.on || ahead.other) {
    // The other plane ends here. The sphere still touches its end, and must not strike it again at once.
    const Support &kept = ahead.on ? state.on : state.other, &left = ahead.on ? state.other : state.on;
    const Support on{kept.normal, ahead.on ? *ahead.on : *ahead.other};
    GroundFriction friction = friction_on_one_side(rock, state, kept);
    const bool is_on_facet = rock.is_facet(on);
    if (rock.material_at(kept.facet) != rock.material_at(on.facet)) friction = friction_at(rock, on.facet);
    return on_ground(on, is_on_facet, friction, left);
  }
  if (rock.reach == 0 && ahead.rising) {
    // Rounded heights bend a straight valley at every facet. The rock moves on over the facet that rises most steeply;
    // what lies next to it is found when the rock is driven there.
    const Support rising{rock.surface.normal(*ahead.rising), *ahead.rising};
    if (rock.is_level(rising.normal) || rock.grazes(rising.normal)) {
      return continue_over(rock, state.on, friction_on_one_side(rock, state, state.on), rising);
    }
    if (rock.motion.velocity.dot(rising.normal) < 0) {
      rock.remember_contact(state.on);
      return strike(rock, {0, rising.normal, rising.facet, Feature::facet});
    }
  }
  return take_off(rock, state, planes_left(rock, state));
}

template <class Surface>
[[nodiscard]] std::optional<NextState> finish_leg(MovingRock<Surface>& rock, InValley& state, const Leg& leg,
                                                  const LegEnd& end) {
  move_to_end(rock, state.on.facet, leg, end);
  if (end.rim) return NextState{leave_over_rim(rock, *end.rim)};
  remove_drift(rock, state);
  if (end.ahead) return NextState{strike(rock, *end.ahead, ground_so_far(rock, state))};
  if (end.edge) {
    rock.update_max_energy();
    if (const auto exit = exit_at(rock, *end.edge)) return NextState{leave_over_rim(rock, *exit)};
    return NextState{leave_valley(rock, state)};
  }
  if (!state.is_on_facet) {
    // Between an edge and another support: after a short while the rock is in the air again, if barely. (Not after each
    // leg: legs have no duration where slip ends at once, and the rock would take off and land forever.)
    rock.stretch.past_edge += end.t;
    const double short_while =
        std::min(rock.laws.timestep, time_for_way(tolerance::edge_step * rock.reach, rock.motion.velocity.norm(), 0));
    if (rock.stretch.past_edge >= 0.5 * short_while) return NextState{take_off(rock, state)};
  }
  return std::nullopt;
}

}  // namespace talus
