#pragma once
// A sphere on an edge or a vertex: it turns about the point that carries it, in steps of a small angle.
//
// The contact point stays where it is while the normal turns, so that the laws of rolling and slipping apply as on a
// plane, with the normal acceleration of edge_contact.hpp. A step runs along the tangent plane, outside the circle
// about the contact. At its end the sphere is lowered onto the nearest ground, at constant energy; if that is a facet,
// it rolls on there. If nothing presses it on any more, it takes off. Left out: the difference in time between tangent
// and circle, second order in the angle of a step.

#include "talus/trajectory/on_facet.hpp"

namespace talus {

template <class Surface>
[[nodiscard]] Footing footing_of(MovingRock<Surface>& rock, const OnEdge& phase) {
  Footing footing = Footing::on_plane(rock.laws.gravity, phase.on.normal);
  footing.normal_acceleration = std::max(0.0, normal_acceleration_on_edge(rock, phase.on));
  return footing;
}

template <class Surface>
[[nodiscard]] double longest_leg(const MovingRock<Surface>& rock, const OnEdge& phase, const Footing& footing) {
  return longest_leg_on_edge(rock, phase.friction, footing);
}

template <class Surface>
[[nodiscard]] SupportPlanes carrying(MovingRock<Surface>& rock, const OnEdge& phase) {
  SupportPlanes on;
  if (const Vec3* const side_contact = normal_of(phase.side_contact)) on = {phase.on.normal, *side_contact};
  on.turn_about(rock.motion.position - rock.reach * phase.on.normal, edge_under(rock, phase.on));
  return on;
}

/// It is already at the end of a facet.
template <class Surface>
[[nodiscard]] std::optional<OutlineEdge> outline_ahead(const MovingRock<Surface>&, const OnEdge&, const Parabola&,
                                                       double&) {
  return std::nullopt;
}

/// Where a sphere is after a leg over its edge.
enum class OverEdge { on_facet, on_edge, in_air };

/// Lowers the sphere onto the nearest ground, at constant energy.
template <class Surface>
[[nodiscard]] OverEdge settle_over_edge(MovingRock<Surface>& rock, OnEdge& phase) {
  Motion& motion = rock.motion;
  Support& on = phase.on;
  // At equal distance, but for rounding, its own facet has priority.
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Support on{Vec3{}, {}};
  } nearest, same;
  rock.surface.supports(motion.position, rock.reach, tolerance::edge_step * rock.reach,
                        [&](const Vec3& n, const Vec3&, double distance, FacetId facet) {
                          if (distance < nearest.distance) nearest = {distance, {n, facet}};
                          if (facet == on.facet) same = {distance, {n, facet}};
                        });
  if (!std::isfinite(nearest.distance)) return OverEdge::in_air;
  if (same.distance <= nearest.distance + contact_slack) nearest = same;

  const Vec3& next = nearest.on.normal;
  const double energy = rock.kinetic_energy();
  const Vec3 shift = (rock.reach - nearest.distance) * next;
  const double kept = energy + rock.rock.mass * rock.laws.gravity.dot(shift);
  const bool rolls = rock.state_on(on.normal) == PathState::rolling;
  const Vec3 between = on.normal + next;
  const bool is_other_ground = rock.material_at(on.facet) != rock.material_at(nearest.on.facet);
  on.facet = nearest.on.facet;
  if (kept > 0) {
    // The velocity turns with the tangent plane, and with it the spin of a sphere that rolls.
    motion.position += shift;
    const Vec3 along = tangential(motion.velocity, on.normal);
    motion.velocity = along - next.dot(along) / (1 + on.normal.dot(next)) * between;
    if (rolls) motion.spin = rolling_spin(motion.velocity, motion.spin, next, rock.rock.radius);
    const double share = std::sqrt(kept / std::max(rock.kinetic_energy(), tolerance::least_speed));
    if (energy > 0) {
      motion.velocity *= share;
      motion.spin *= share;
    }
    on.normal = next;
  }
  const Outline& outline = rock.outline_of(on.facet);
  const Vec3 point = motion.position - rock.reach * on.normal;
  double inside = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < static_cast<std::size_t>(outline.edge_count); ++k) {
    inside = std::min(inside, (point - outline.edges[k].point).dot(outline.edges[k].inward));
  }
  const bool is_on_facet = inside > contact_slack && rock.is_facet(on);
  if (is_on_facet) {
    on.normal = outline.normal;
    motion.velocity = tangential(motion.velocity, on.normal);
  }
  if (is_other_ground) phase.friction = friction_at(rock, on.facet);
  if (is_on_facet) return OverEdge::on_facet;
  return normal_acceleration_on_edge(rock, on) >= 0 ? OverEdge::on_edge : OverEdge::in_air;
}

template <class Surface, class Sink>
[[nodiscard]] std::optional<NextPhase> finish_leg(TrackedRock<Surface, Sink>& rock, OnEdge& phase, Leg leg,
                                                  const LegEnd& end) {
  const double t = end.t;
  if (end.rim || end.ahead) {
    move_to_end(rock, phase.on.facet, leg, end);
    if (end.rim) return NextPhase{leave_over_rim(rock, *end.rim)};
    rock.remember_contact(phase.on);
    return NextPhase{strike(rock, *end.ahead, ground_so_far(rock, phase))};
  }
  const Motion before = rock.motion;
  move_along(rock, leg, t, Vec3{});
  const OverEdge place = settle_over_edge(rock, phase);
  // The path is bent so that it ends where the sphere is.
  if (t > 0) leg.path.a = 2 / (t * t) * (rock.motion.position - leg.path.p - t * leg.path.v);
  rock.cover_leg(phase.on.facet, leg.path, t, before, rock.motion);
  rock.update_max_energy();
  if (place == OverEdge::in_air) return NextPhase{take_off(rock, phase)};
  if (place == OverEdge::on_edge) return std::nullopt;
  const OnFacet facet{phase.on, phase.friction, {}};
  remove_drift(rock, facet);
  return within_stretch(facet);
}

}  // namespace talus
