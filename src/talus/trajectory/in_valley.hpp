#pragma once
// A rock in a valley: gravity holds it between two supports, and it moves along the line in which they meet.

#include "talus/trajectory/on_facet.hpp"

namespace talus {

template <class Surface>
[[nodiscard]] Footing footing_of(MovingRock<Surface>& rock, const InValley& phase) {
  return rock.valley_of(phase).footing;
}

template <class Surface>
[[nodiscard]] double longest_leg(const MovingRock<Surface>& rock, const InValley& phase, const Footing& footing) {
  return phase.is_on_facet ? longest_leg_on_planes(rock, phase.friction, footing)
                           : longest_leg_on_edge(rock, phase.friction, footing);
}

template <class Surface>
[[nodiscard]] GroundBeneath ground_beneath(MovingRock<Surface>& rock, const InValley& phase, const Footing& footing) {
  return {phase.on.normal, rock.valley_of(phase).direction, phase.friction.sphere, footing};
}

/// Its other side already guides it.
inline void set_guide(const InValley&, const Guide&) {}

[[nodiscard]] inline const Guide* guide_of(const InValley&) { return nullptr; }

template <class Surface>
[[nodiscard]] SupportPlanes carrying(const MovingRock<Surface>&, const InValley& phase) {
  return {phase.on.normal, phase.other.normal};
}

/// Each leg runs along the valley: rounding across it would grow, since friction acts along slip however small.
template <class Surface>
void apply_side_contact(MovingRock<Surface>& rock, const InValley& phase, Leg& leg, double&) {
  leg = guided(leg, rock.valley_of(phase).direction);
  if (rock.is_sphere()) leg.end_spin = spin_in_valley(rock, phase, leg.end_spin);
}

template <class Surface>
[[nodiscard]] std::optional<OutlineEdge> outline_ahead(MovingRock<Surface>& rock, const InValley& phase,
                                                       const Parabola& leg, double& t) {
  if (!phase.is_on_facet) return std::nullopt;
  const Vec3& along = rock.valley_of(phase).direction;
  auto side = side_crossed(rock, phase.on.facet, leg, t, 0, &along);
  if (rock.is_facet(phase.other)) {
    if (auto other = side_crossed(rock, phase.other.facet, leg, t, 0, &along)) side = other;
  }
  return side;
}

/// Whether the other side still holds the rock: an edge or a vertex holds a sphere only as long as it touches it.
template <class Surface>
[[nodiscard]] bool is_held(const MovingRock<Surface>& rock, const InValley& phase) {
  if (rock.is_facet(phase.other)) return true;
  bool is_held = false;
  rock.surface.supports(rock.motion.position, rock.reach, tolerance::still_touching,
                        [&](const Vec3& n, const Vec3&, double, FacetId) {
                          is_held = is_held || n.dot(phase.other.normal) > 1 - tolerance::still_touching;
                        });
  return is_held;
}

/// The friction after the rock has left one side of a valley and moves on along the other, `kept`.
template <class Surface>
[[nodiscard]] GroundFriction friction_on_one_side(MovingRock<Surface>& rock, const InValley& phase,
                                                  const Support& kept) {
  if (rock.material_at(phase.on.facet) == rock.material_at(phase.other.facet)) return phase.friction;
  return friction_at(rock, kept.facet);
}

/// On the ground next to a support that the rock has left, but still touches.
[[nodiscard]] inline Phase on_ground(const Support& on, bool is_on_facet, const GroundFriction& friction,
                                     const Support& left) {
  if (is_on_facet) return OnFacet{on, friction, LeftFacet{left.normal}};
  return OnEdge{on, friction, LeftFacet{left.normal}};
}

/// The rock moves on over its own support alone.
template <class Surface>
[[nodiscard]] Phase leave_other_side(MovingRock<Surface>& rock, const InValley& phase) {
  return on_ground(phase.on, phase.is_on_facet, friction_on_one_side(rock, phase, phase.on), phase.other);
}

/// Puts the rock back on the bottom of its valley, so that rounding does not add up from leg to leg.
template <class Surface>
void remove_drift(MovingRock<Surface>& rock, const InValley& phase) {
  if (!phase.is_on_facet || !rock.is_facet(phase.other)) return;
  const Vec3 &n = phase.on.normal, &m = phase.other.normal;
  Vec3 shift = -gap_to_plane(rock, n, rock.outline_of(phase.on.facet).point) * n;
  // The shortest shift to where the rock touches both planes.
  const Vec3 across = tangential(m, n);  // in the first plane, away from the second
  shift -=
      (gap_to_plane(rock, m, rock.surface.point_of(phase.other.facet)) + m.dot(shift)) / across.squared_norm() * across;
  correct_position(rock, shift);
}

/// The facets that the rock takes off from.
template <class Surface>
[[nodiscard]] LeftFacets facets_left(const MovingRock<Surface>& rock, const InValley& phase) {
  LeftFacets left;
  if (phase.is_on_facet) left.add(phase.on.facet);
  if (rock.is_facet(phase.other)) left.add(phase.other.facet);
  return left;
}

/// The ground beyond the end of a valley's facets.
struct AheadInValley {
  std::optional<FacetId> on, other;  // facets in the planes of its two sides
  std::optional<FacetId> rising;     // the facet that rises most steeply against the rock
};

template <class Surface>
[[nodiscard]] AheadInValley look_along_valley(MovingRock<Surface>& rock, const InValley& phase) {
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
                          if (n.dot(phase.on.normal) > 1 - same_plane) choose(ahead.on, on_depth);
                          if (n.dot(phase.other.normal) > 1 - same_plane) choose(ahead.other, other_depth);
                          if (const double parting = n.dot(motion.velocity); parting < least_parting) {
                            least_parting = parting;
                            ahead.rising = facet;
                          }
                        });
  return ahead;
}

/// The valley continues between the next facets of both its planes.
template <class Surface>
[[nodiscard]] InValley continue_along(MovingRock<Surface>& rock, InValley phase, FacetId on, FacetId other) {
  const auto materials = [&] {
    return std::pair(rock.material_at(phase.on.facet), rock.material_at(phase.other.facet));
  };
  const auto materials_before = materials();
  phase.on.facet = on;
  phase.other.facet = other;
  phase.is_on_facet = rock.is_facet(phase.on);
  if (phase.is_on_facet && rock.is_facet(phase.other)) {
    // The planes are the same but for rounding, which would add up along the valley.
    const Vec3 n = rock.surface.normal(on), m = rock.surface.normal(other);
    if (is_caught_between(rock.laws.gravity, m, n, rock.motion.velocity, rock.leaving_speed)) {
      phase.on.normal = n;
      phase.other.normal = m;
      keep_along_valley(rock, phase);
    }
  }
  if (materials() != materials_before) phase.friction = friction_in(rock, phase);
  return phase;
}

/// The phase of a rock that has reached the end of its valley's facets. Both planes may continue, or one of them.
template <class Surface, class Sink>
[[nodiscard]] Phase leave_valley(TrackedRock<Surface, Sink>& rock, const InValley& phase) {
  const AheadInValley ahead = look_along_valley(rock, phase);
  if (ahead.on && ahead.other) return continue_along(rock, phase, *ahead.on, *ahead.other);
  if (ahead.on || ahead.other) {
    // The other plane ends here. The sphere still touches its end, and must not strike it again at once.
    const Support &kept = ahead.on ? phase.on : phase.other, &left = ahead.on ? phase.other : phase.on;
    const Support on{kept.normal, ahead.on ? *ahead.on : *ahead.other};
    GroundFriction friction = friction_on_one_side(rock, phase, kept);
    const bool is_on_facet = rock.is_facet(on);
    if (rock.material_at(kept.facet) != rock.material_at(on.facet)) friction = friction_at(rock, on.facet);
    return on_ground(on, is_on_facet, friction, left);
  }
  if (rock.reach == 0 && ahead.rising) {
    // Rounded heights bend a straight valley at every facet. The rock moves on over the facet that rises most steeply;
    // what lies next to it is found when the rock is driven there.
    const Support rising{rock.surface.normal(*ahead.rising), *ahead.rising};
    if (rock.is_level(rising.normal) || rock.grazes(rising.normal)) {
      return continue_over(rock, phase.on, friction_on_one_side(rock, phase, phase.on), rising);
    }
    if (rock.motion.velocity.dot(rising.normal) < 0) {
      rock.remember_contact(phase.on);
      return strike(rock, {0, rising.normal, rising.facet, Feature::facet});
    }
  }
  return take_off(rock, phase, facets_left(rock, phase));
}

template <class Surface, class Sink>
[[nodiscard]] std::optional<NextPhase> finish_leg(TrackedRock<Surface, Sink>& rock, InValley& phase, const Leg& leg,
                                                  const LegEnd& end) {
  move_to_end(rock, phase.on.facet, leg, end);
  if (end.rim) return NextPhase{leave_over_rim(rock, *end.rim)};
  remove_drift(rock, phase);
  if (end.ahead) return NextPhase{strike(rock, *end.ahead, ground_so_far(rock, phase))};
  if (end.edge) {
    rock.update_max_energy();
    if (const auto exit = exit_at(rock, *end.edge)) return NextPhase{leave_over_rim(rock, *exit)};
    return NextPhase{leave_valley(rock, phase)};
  }
  if (!phase.is_on_facet) {
    // Between an edge and another support: after a short while the rock is in the air again, if barely. (Not after each
    // leg: legs have no duration where slip ends at once, and the rock would take off and land forever.)
    rock.stretch.past_edge += end.t;
    const double short_while =
        std::min(rock.laws.timestep, time_for_way(tolerance::edge_step * rock.reach, rock.motion.velocity.norm(), 0));
    if (rock.stretch.past_edge >= 0.5 * short_while) return NextPhase{take_off(rock, phase)};
  }
  return std::nullopt;
}

}  // namespace talus
