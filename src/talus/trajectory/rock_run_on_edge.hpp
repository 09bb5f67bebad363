#pragma once
// The part of RockRun in which a sphere rolls over an edge or a vertex: about the point that carries it, in steps of a
// small angle. Included by rock_run.hpp only.
//
// The contact stays where it is while the normal turns, so that the laws of rolling and slipping hold as on a plane,
// with the normal force less what the turn takes: N = -g.n - v^2/r, v being the speed across the edge. A step goes
// along the tangent plane, which is outside of the circle about the contact; at its end the sphere is let down onto
// what is nearest to it, and keeps the energy. That may be a facet, and it rolls on there. Where N comes to nothing it
// flies. Left out: what the way along the tangent differs from the circle in time, second order in the angle of a step.

#include "talus/trajectory/rock_run.hpp"

namespace talus {

/// By how much a sphere turns about an edge in one step [rad].
inline constexpr double edge_step = 0.01;

/// The direction of the edge that carries a sphere, of these facet and normal; zero at a vertex.
template <class Surface>
Vec3 RockRun<Surface>::edge_under(FacetId facet, const Vec3& normal) {
  constexpr double on_it = 1e-7;  // [m]
  const Vec3 point = motion_.position - reach_ * normal;
  const Outline& outline = outline_of(facet);
  Vec3 direction = Vec3::Zero();
  int sides = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(outline.edge_count); ++k) {
    const OutlineEdge& side = outline.edges[k];
    if (std::abs((point - side.point).dot(side.inward)) > on_it) continue;
    direction = side.inward.cross(outline.normal);
    ++sides;
  }
  return sides == 1 ? direction : Vec3(Vec3::Zero());
}

/// What presses a sphere against an edge or a vertex, over its mass [m/s2]; below 0 it flies off.
template <class Surface>
double RockRun<Surface>::pressure_on_edge(FacetId facet, const Vec3& normal) {
  const Vec3 across = tangential(tangential(motion_.velocity, normal), edge_under(facet, normal));
  return -laws_.gravity.dot(normal) - across.squaredNorm() / reach_;
}

/// How long a leg may be [s].
template <class Surface>
double RockRun<Surface>::longest_leg(const OnGround& phase, const Footing& footing) const {
  if (phase.on_facet) return laws_.timestep;
  const double friction = phase.friction.dynamic * std::max(footing.pressure, 0.0);
  return std::min(laws_.timestep,
                  time_for_way(edge_step * reach_, motion_.velocity.norm(), footing.pull.norm() + friction));
}

/// The sphere went along a leg over its edge. Lets it down onto what is nearest to it; whether it stays on the ground.
template <class Surface>
bool RockRun<Surface>::settle_over_edge(OnGround& phase) {
  // What is as near as the nearest, but for rounding, is the facet that it had, if that is among them.
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Vec3 normal;
    FacetId facet;
  } nearest, same;
  surface_.supports(motion_.position, reach_, edge_step * reach_,
                    [&](const Vec3& n, const Vec3&, double distance, FacetId facet) {
                      if (distance < nearest.distance) nearest = {distance, n, facet};
                      if (facet == phase.facet) same = {distance, n, facet};
                    });
  if (!std::isfinite(nearest.distance)) return false;
  if (same.distance <= nearest.distance + contact_slack) nearest = same;

  const double energy = kinetic_energy();
  const Vec3 shift = (reach_ - nearest.distance) * nearest.normal;
  const double kept = energy + rock_.mass * laws_.gravity.dot(shift);
  const bool rolls = contact_state(phase.normal) == PathState::rolling;
  const Vec3 between = phase.normal + nearest.normal;
  const bool is_other_ground = material_at(phase.facet) != material_at(nearest.facet);
  phase.facet = nearest.facet;
  if (kept > 0) {
    // The velocity turns with the tangent plane, and with it the spin of what rolls.
    motion_.position += shift;
    const Vec3 along = tangential(motion_.velocity, phase.normal);
    motion_.velocity = along - nearest.normal.dot(along) / (1 + phase.normal.dot(nearest.normal)) * between;
    if (rolls) motion_.spin = rolling_spin(motion_.velocity, motion_.spin, nearest.normal, rock_.radius);
    const double share = std::sqrt(kept / std::max(kinetic_energy(), 1e-300));
    if (energy > 0) {
      motion_.velocity *= share;
      motion_.spin *= share;
    }
    phase.normal = nearest.normal;
  }
  const Outline& outline = outline_of(phase.facet);
  const Vec3 point = motion_.position - reach_ * phase.normal;
  double inside = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < static_cast<std::size_t>(outline.edge_count); ++k) {
    inside = std::min(inside, (point - outline.edges[k].point).dot(outline.edges[k].inward));
  }
  phase.on_facet = inside > contact_slack && carries(phase.facet, phase.normal);
  if (phase.on_facet) {
    phase.normal = outline.normal;
    motion_.velocity = tangential(motion_.velocity, phase.normal);
  }
  if (is_other_ground) redraw_friction(phase);
  return phase.on_facet || pressure_on_edge(phase.facet, phase.normal) >= 0;
}

}  // namespace talus
