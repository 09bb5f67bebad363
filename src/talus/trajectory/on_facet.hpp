#pragma once
// A rock on a facet: the lumped mass slides, the rigid sphere rolls or slips, until the plane ends, the ground rises,
// or it rests.

#include "talus/terrain/clear_way.hpp"
#include "talus/trajectory/ground_leg.hpp"

namespace talus {

template <class Surface>
[[nodiscard]] Footing footing_of(const MovingRock<Surface>& rock, const OnFacet& state) {
  return Footing::on_plane(rock.laws.gravity, state.on.normal);
}

template <class Surface>
[[nodiscard]] double longest_leg(const MovingRock<Surface>& rock, const OnFacet&, const Footing&) {
  return rock.laws.timestep;
}

template <class Surface>
[[nodiscard]] RollingPlane rolling_plane(const MovingRock<Surface>& rock, const OnFacet& state) {
  return {state.on.normal, rock.rock, state.friction.sphere};
}

[[nodiscard]] inline GroundBeneath ground_beneath(const OnFacet& state, const Footing& footing) {
  return {state.on.normal, {}, state.friction.sphere, footing};
}

inline void be_guided(OnFacet& state, const Guide& guide) { state.beside = guide; }

template <class Surface>
[[nodiscard]] SupportPlanes carrying(const MovingRock<Surface>&, const OnFacet& state) {
  const Vec3* const beside = normal_of(state.beside);
  return beside ? SupportPlanes{state.on.normal, *beside} : SupportPlanes(state.on.normal);
}

template <class Surface>
void pass_beside(const MovingRock<Surface>& rock, OnFacet& state, Leg& leg, double& t) {
  pass_beside(rock, state.on, state.beside, leg, t);
}

/// On the way the state moves from facet to facet of one plane and one material, as if there were no edges between
/// them.
template <class Surface>
[[nodiscard]] std::optional<OutlineEdge> outline_ahead(MovingRock<Surface>& rock, OnFacet& state, const Parabola& leg,
                                                       double& t) {
  constexpr int most_facets_a_leg = 1000;  // then the leg ends; what turns in circles at a vertex, a little beyond it
  Support& on = state.on;
  const Vec3 plane = on.normal;
  double t_edge = 0;
  for (int facets = 0; facets < most_facets_a_leg; ++facets) {
    const double from = std::exchange(t_edge, t);
    const auto edge = side_crossed(rock, on.facet, leg, t_edge, from);
    if (!edge) return std::nullopt;
    const bool goes_on = edge->beyond && plane.dot(rock.outline_of(*edge->beyond).normal) > 1 - same_plane &&
                         rock.material_at(on.facet) == rock.material_at(*edge->beyond);
    if (!goes_on) {
      t = t_edge;
      return edge;
    }
    on = {rock.outline_of(*edge->beyond).normal, *edge->beyond};
  }
  t = std::min(t, std::max(t_edge, time_for_way(tolerance::look_ahead, leg.v.norm(), leg.a.norm())));
  return std::nullopt;
}

/// Whether there is nothing ahead on the next `way` [m] of a sphere at `centre`, over the plane of its facet. Legs are
/// short, and most facets long: how far it may roll before it can touch anything else is worked out once for many legs.
template <class Surface>
[[nodiscard]] bool is_in_the_clear(MovingRock<Surface>& rock, const Support& on, const Vec3& centre, double way) {
  constexpr double worth = 12, most = 48;  // so many legs must there be room for that it is worked out, or is
  ClearWay& clear = rock.clear;
  const bool is_known = on.normal == clear.normal;
  const double gone = (centre - clear.from).norm();
  if (is_known && gone + way <= clear.way) return true;
  if (is_known && gone < clear.until) return false;
  double room = most * way;
  const Outline& outline = rock.outline_of(on.facet);
  for (std::size_t k = 0; k < static_cast<std::size_t>(outline.edge_count); ++k) {
    room = std::min(room, (centre - outline.edges[k].point).dot(outline.edges[k].inward));
  }
  if (!(room > worth * way)) return false;
  clear = {on.normal, centre, room, worth * way};
  const Surface& surface = rock.surface;
  surface.supports(centre, rock.reach, room, [&](const Vec3&, const Vec3&, double distance, FacetId facet) {
    clear.way = std::min(clear.way, clear_way(on.normal, centre, rock.reach, surface.outline(facet), distance));
  });
  return way <= clear.way;
}

template <class Surface>
[[nodiscard]] std::optional<Contact> ground_ahead(MovingRock<Surface>& rock, const OnFacet& state, const Parabola& leg,
                                                  double t, const SupportPlanes& on) {
  const double way = leg.v.norm() * t + 0.5 * leg.a.norm() * t * t;
  if (on.count == 1 && is_in_the_clear(rock, state.on, leg.p, way)) return std::nullopt;
  return rock.surface.first_contact_on_leg(leg, rock.reach, t, on);
}

/// Rounding must not lift a rock off its facet, or press it in, leg after leg.
template <class Surface>
void stand_on(MovingRock<Surface>& rock, const OnFacet& state) {
  const Vec3& n = state.on.normal;
  lift(rock, -height_over(rock, n, rock.outline_of(state.on.facet).point) * n);
}

/// What the rock flies off. (The normal of an edge is none of a plane.)
[[nodiscard]] inline SupportPlanes left_behind(const OnFacet& state) {
  SupportPlanes left;
  left.add(state.on.normal, state.on.facet);
  return left;
}

/// A facet ahead is level, or only grazed: the rock goes on over it.
template <class Surface>
[[nodiscard]] OnFacet go_on_over(MovingRock<Surface>& rock, const Support& from, const GroundFriction& friction,
                                 const Support& next) {
  OnFacet state{next, friction, {}};
  if (rock.reach > 0) state.beside = LeftFacet{from.normal};
  if (rock.material_at(from.facet) != rock.material_at(next.facet)) state.friction = friction_at(rock, next.facet);
  if (rock.is_level(next.normal)) {
    rock.motion.velocity = tangential(rock.motion.velocity, next.normal);
  } else {
    rock.settle_onto(next.normal, state.friction.mu);
    rock.note_row(PathState::sliding);
  }
  return state;
}

/// Where gravity holds the rock between its facet and the one that it has come to.
template <class Surface>
[[nodiscard]] std::optional<InValley> enter_valley(MovingRock<Surface>& rock, const OnFacet& state,
                                                   const Support& next) {
  const auto caught =
      caught_between(rock.laws.gravity, state.on.normal, next.normal, rock.motion.velocity, rock.leaving_speed);
  if (!caught) return std::nullopt;
  InValley valley{next, true, state.friction, state.on, *caught};
  if (rock.material_at(next.facet) != rock.material_at(state.on.facet)) valley.friction = friction_in(rock, valley);
  keep_along_valley(rock, valley);
  return valley;
}

/// How a rock leaves the model at the end of a facet that has none beyond it. (There the model ends under the rock's
/// centre; whether its skin would still brush the rim is no matter.)
template <class Surface>
[[nodiscard]] std::optional<Exit> exit_at(const MovingRock<Surface>& rock, const OutlineEdge& edge) {
  return edge.beyond ? std::nullopt : rock.exit_from(rock.motion.position, rock.motion.velocity);
}

/// The rock has come to the end of its plane.
template <class Surface>
[[nodiscard]] RockState leave_facet(MovingRock<Surface>& rock, const OnFacet& state, const OutlineEdge& edge) {
  if (const auto exit = exit_at(rock, edge)) return leave_over_rim(rock, *exit);
  if (edge.beyond) {
    const Support next{rock.outline_of(*edge.beyond).normal, *edge.beyond};
    if (rock.is_level(next.normal) || rock.grazes(next.normal)) {
      // The bottom of a valley, reached along it or over a crease too flat to be struck.
      if (next.normal.dot(edge.inward) > 0) {
        if (const auto valley = enter_valley(rock, state, next)) return *valley;
      }
      return go_on_over(rock, state.on, state.friction, next);
    }
    if (rock.motion.velocity.dot(next.normal) < 0) {
      // A lumped mass slides into ground that rises against it; a sphere touches such ground before it gets here,
      // unless it rises by next to nothing.
      rock.remember_contact(state.on);
      return strike(rock, {0, next.normal, next.facet, Feature::facet});
    }
  }
  if (rock.reach > 0 && normal_acceleration_on_edge(rock, state.on) > 0) {
    return OnEdge{state.on, state.friction, {}};  // too slow to fly off, it turns about the edge
  }
  return take_off(rock, left_behind(state));
}

template <class Surface>
[[nodiscard]] std::optional<NextState> finish_leg(MovingRock<Surface>& rock, OnFacet& state, const Leg& leg,
                                                  const LegEnd& end) {
  go_to_end(rock, state.on.facet, leg, end);
  if (end.rim) return NextState{leave_over_rim(rock, *end.rim)};
  stand_on(rock, state);
  if (end.ahead) {
    rock.remember_contact(state.on);
    return NextState{strike(rock, *end.ahead)};
  }
  if (end.edge) {
    rock.note_energy();
    return NextState{leave_facet(rock, state, *end.edge)};
  }
  return std::nullopt;
}

}  // namespace talus
