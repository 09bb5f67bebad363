#pragma once
// A sphere on an edge or a vertex: the line that carries it, and the normal acceleration.

#include "talus/trajectory/ground_friction.hpp"

namespace talus {

/// The direction of the edge that carries a sphere, unit; zero at a vertex. How far the sphere has sunk in does not
/// matter.
template <class Surface>
[[nodiscard]] Vec3 edge_under(MovingRock<Surface>& rock, const Support& on) {
  const Vec3 point = rock.motion.position - rock.reach * on.normal;
  const Outline& outline = rock.outline_of(on.facet);
  Vec3 direction;
  int sides = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(outline.edge_count); ++k) {
    const OutlineEdge& side = outline.edges[k];
    const Vec3 along = side.inward.cross(outline.normal);
    if (std::abs((point - side.point).dot(along.cross(on.normal))) > tolerance::on_edge_line) continue;
    direction = along;
    ++sides;
  }
  return sides == 1 ? direction : Vec3{};
}

/// N = -g.n - v^2/r, with v the speed across the edge: the normal force over the sphere's mass, gravity less the
/// centripetal acceleration of the turn about the edge [m/s2]. Below 0 the sphere takes off.
template <class Surface>
[[nodiscard]] double normal_acceleration_on_edge(MovingRock<Surface>& rock, const Support& on) {
  const Vec3 across = tangential(tangential(rock.motion.velocity, on.normal), edge_under(rock, on));
  return -rock.laws.gravity.dot(on.normal) - across.squared_norm() / rock.reach;
}

/// The duration [s] of a leg in which a sphere turns about an edge by at most `edge_step`.
template <class Surface>
[[nodiscard]] double longest_leg_on_edge(const MovingRock<Surface>& rock, const GroundFriction& friction,
                                         const Footing& footing) {
  const double braking = friction.sphere.dynamic * std::max(footing.normal_acceleration, 0.0);
  return std::min(rock.laws.timestep, time_for_way(tolerance::edge_step * rock.reach, rock.motion.velocity.norm(),
                                                   footing.pull.norm() + braking));
}

}  // namespace talus
