#pragma once
// A rock on a facet: the lumped mass slides, the rigid sphere rolls or slips, until the plane ends, other ground is in
// the way, or the rock stops.

#include "talus/terrain/clear_way.hpp"
#include "talus/trajectory/ground_leg.hpp"

namespace talus {

template <class Surface>
[[nodiscard]] Footing footing_of(const MovingRock<Surface>& rock, const OnFacet& phase) {
  return Footing::on_plane(rock.laws.gravity, phase.on.normal);
}

/// The duration [s] of a leg on one facet or between two.
template <class Surface>
[[nodiscard]] double longest_leg_on_planes(const MovingRock<Surface>& rock, const GroundFriction& friction,
                                           const Footing& footing) {
  if (!rock.is_sphere()) return rock.laws.timestep;
  const double braking = friction.sphere.dynamic * std::max(footing.normal_acceleration, 0.0);
  return std::min(rock.laws.timestep, time_for_way(tolerance::longest_step_in_radii * rock.reach,
                                                   rock.motion.velocity.norm(), footing.pull.norm() + braking));
}

template <class Surface>
[[nodiscard]] double longest_leg(const MovingRock<Surface>& rock, const OnFacet& phase, const Footing& footing) {
  return longest_leg_on_planes(rock, phase.friction, footing);
}

template <class Surface>
[[nodiscard]] SupportPlanes carrying(const MovingRock<Surface>&, const OnFacet& phase) {
  const Vec3* const side_contact = normal_of(phase.side_contact);
  return side_contact ? SupportPlanes{phase.on.normal, *side_contact} : SupportPlanes(phase.on.normal);
}

/// Within one plane and one material the phase moves on from facet to facet, as if there were no edges between them.
template <class Surface>
[[nodiscard]] std::optional<OutlineEdge> outline_ahead(MovingRock<Surface>& rock, OnFacet& phase, const Parabola& leg,
                                                       double& t) {
  constexpr int most_facets_per_leg =
      1000;  // then the leg ends a little further on, as for a rock that circles a vertex
  Support& on = phase.on;
  const Vec3 plane = on.normal;
  double t_edge = 0;
  for (int facets = 0; facets < most_facets_per_leg; ++facets) {
    const double from = std::exchange(t_edge, t);
    const auto edge = side_crossed(rock, on.facet, leg, t_edge, from);
    if (!edge) return std::nullopt;
    const bool continues = edge->beyond && plane.dot(rock.outline_of(*edge->beyond).normal) > 1 - same_plane &&
                           rock.material_at(on.facet) == rock.material_at(*edge->beyond);
    if (!continues) {
      t = t_edge;
      return edge;
    }
    on = {rock.outline_of(*edge->beyond).normal, *edge->beyond};
  }
  t = std::min(t, std::max(t_edge, time_for_way(tolerance::look_ahead, leg.v.norm(), leg.a.norm())));
  return std::nullopt;
}

/// Whether a sphere at `centre` can move by `way` [m] and touch nothing but the plane of its facet. Legs are short and
/// most facets long: how far it may roll is computed once for many legs.
template <class Surface>
[[nodiscard]] bool has_clear_way(MovingRock<Surface>& rock, const Support& on, const Vec3& centre, double way) {
  // The search is made if there may be room for `least_legs` more legs, and covers at most `most_legs`.
  constexpr double least_legs = 12, most_legs = 48;
  ClearWay& clear = rock.clear;
  const bool is_known = on.normal == clear.normal;
  const double moved = (centre - clear.from).norm();
  if (is_known && moved + way <= clear.way) return true;
  if (is_known && moved < clear.until) return false;
  double room = most_legs * way;
  const Outline& outline = rock.outline_of(on.facet);
  for (std::size_t k = 0; k < static_cast<std::size_t>(outline.edge_count); ++k) {
    room = std::min(room, (centre - outline.edges[k].point).dot(outline.edges[k].inward));
  }
  if (!(room > least_legs * way)) return false;
  clear = {on.normal, centre, room, least_legs * way};
  const Surface& surface = rock.surface;
  surface.supports(centre, rock.reach, room, [&](const Vec3&, const Vec3&, double distance, FacetId facet) {
    clear.way = std::min(clear.way, clear_way(on.normal, centre, rock.reach, surface.outline(facet), distance));
  });
  return way <= clear.way;
}

template <class Surface>
[[nodiscard]] std::optional<Contact> ground_ahead(MovingRock<Surface>& rock, const OnFacet& phase, const Parabola& leg,
                                                  double t, const SupportPlanes& on) {
  const double way = leg.v.norm() * t + 0.5 * leg.a.norm() * t * t;
  if (on.count == 1 && has_clear_way(rock, phase.on, leg.p, way)) return std::nullopt;
  return rock.surface.first_contact_on_leg(leg, rock.reach, t, on);
}

/// Puts the rock back on the plane of its facet, so that rounding does not add up from leg to leg.
template <class Surface>
void remove_drift(MovingRock<Surface>& rock, const OnFacet& phase) {
  const Vec3& n = phase.on.normal;
  correct_position(rock, -gap_to_plane(rock, n, rock.outline_of(phase.on.facet).point) * n);
}

/// The next facet continues the rock's own, or is only grazed: the rock moves on over it.
template <class Surface, class Sink>
[[nodiscard]] OnFacet continue_over(TrackedRock<Surface, Sink>& rock, const Support& from,
                                    const GroundFriction& friction, const Support& next) {
  OnFacet phase{next, friction, {}};
  if (rock.reach > 0) phase.side_contact = LeftFacet{from.normal};
  if (rock.material_at(from.facet) != rock.material_at(next.facet)) phase.friction = friction_at(rock, next.facet);
  if (rock.is_level(next.normal)) {
    rock.motion.velocity = tangential(rock.motion.velocity, next.normal);
  } else {
    rock.round_bend(next.normal, phase.friction);
    rock.tell(event::Bend{rock.motion, rock.state_on(next.normal)});
  }
  return phase;
}

/// The valley between the rock's facet and the one that it has reached, if gravity holds it there.
template <class Surface>
[[nodiscard]] std::optional<InValley> enter_valley(MovingRock<Surface>& rock, const OnFacet& phase,
                                                   const Support& next) {
  if (!is_caught_between(rock.laws.gravity, phase.on.normal, next.normal, rock.motion.velocity, rock.leaving_speed)) {
    return std::nullopt;
  }
  InValley valley{next, phase.on, phase.friction, true};
  if (rock.material_at(next.facet) != rock.material_at(phase.on.facet)) valley.friction = friction_in(rock, valley);
  keep_along_valley(rock, valley);
  return valley;
}

/// How a rock leaves the model at the end of a facet with no facet beyond. (The model ends where the rock's centre
/// leaves it, even if its surface would still touch the rim.)
template <class Surface>
[[nodiscard]] std::optional<Exit> exit_at(const MovingRock<Surface>& rock, const OutlineEdge& edge) {
  if (edge.beyond) return std::nullopt;
  const Motion& motion = rock.motion;
  if (const auto exit = rock.exit_from(motion.position, motion.velocity)) return exit;
  // One that is very slow would fall along the rim, within the thickness of its facet.
  return rock.exit_from(motion.position - tolerance::look_ahead * edge.inward, motion.velocity);
}

/// The phase of a rock that has reached the end of its plane.
template <class Surface, class Sink>
[[nodiscard]] Phase leave_facet(TrackedRock<Surface, Sink>& rock, const OnFacet& phase, const OutlineEdge& edge) {
  if (const auto exit = exit_at(rock, edge)) return leave_over_rim(rock, *exit);
  if (edge.beyond) {
    const Support next{rock.outline_of(*edge.beyond).normal, *edge.beyond};
    const bool rises = next.normal.dot(edge.inward) > 0;
    if (rock.is_level(next.normal) || rock.grazes(next.normal)) {
      // The bottom of a valley, reached along it or over a crease too flat for an impact.
      if (rises) {
        if (const auto valley = enter_valley(rock, phase, next)) return *valley;
      }
      return continue_over(rock, phase.on, phase.friction, next);
    }
    if (rock.motion.velocity.dot(next.normal) < 0) {
      // A lumped mass slides into rising ground. A sphere touches such ground before it gets here, unless the bend is
      // tiny.
      rock.remember_contact(phase.on);
      return strike(rock, {0, next.normal, next.facet, Feature::facet});
    }
    if (rises && rock.reach == 0) {
      // At the foot of a wall, and not into it: gravity holds the rock there, or it slides on from it.
      if (const auto valley = enter_valley(rock, phase, next)) return *valley;
      return OnFacet{phase.on, phase.friction, {}};
    }
  }
  if (rock.reach > 0 && normal_acceleration_on_edge(rock, phase.on) > 0) {
    return OnEdge{phase.on, phase.friction, {}};  // too slow to take off, it turns about the edge
  }
  return take_off(rock, phase, {{phase.on.facet}, 1});
}

template <class Surface, class Sink>
[[nodiscard]] std::optional<NextPhase> finish_leg(TrackedRock<Surface, Sink>& rock, OnFacet& phase, const Leg& leg,
                                                  const LegEnd& end) {
  move_to_end(rock, phase.on.facet, leg, end);
  if (end.rim) return NextPhase{leave_over_rim(rock, *end.rim)};
  remove_drift(rock, phase);
  if (end.ahead) {
    rock.remember_contact(phase.on);
    return NextPhase{strike(rock, *end.ahead, ground_so_far(rock, phase))};
  }
  if (end.edge) {
    rock.update_max_energy();
    return NextPhase{leave_facet(rock, phase, *end.edge)};
  }
  return std::nullopt;
}

}  // namespace talus
