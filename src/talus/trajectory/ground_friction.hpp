#pragma once
// Friction and drag of the ground: drawn from its material, or shared by the two sides of a valley.

#include "talus/trajectory/moving_rock.hpp"

namespace talus {

/// `rt`: the tangential restitution of the same draw.
template <class Surface>
[[nodiscard]] GroundFriction friction_of(MovingRock<Surface>& rock, const GroundDraw& draw, const Material& material,
                                         double rt) {
  GroundFriction friction;
  friction.drag = material.ground_drag;
  if (material.has_forest() && rock.reach < material.forest_height) {
    friction.drag += material.forest_drag / rock.rock.mass;
  }
  if (rock.is_sphere()) {
    friction.sphere = {draw.dynamic_friction(material), draw.rolling_friction(material)};
    return friction;
  }
  switch (rock.laws.friction_source) {
    case FrictionSource::material:
      friction.mu = rock.tangent_of(draw.friction_angle(material));
      break;
    case FrictionSource::tangential_restitution:
      friction.mu = rt > 0 ? (1 - rt) / rt : 1e300;
      break;
    case FrictionSource::zero:
      break;
  }
  return friction;
}

/// On a facet that the rock comes to.
template <class Surface>
[[nodiscard]] GroundFriction friction_at(MovingRock<Surface>& rock, FacetId facet) {
  const Material& material = rock.ground[rock.material_at(facet)];
  const GroundDraw draw = rock.draw_at(facet);
  return friction_of(rock, draw, material, draw.restitution(material)[1]);
}

/// In a valley between two materials each brakes the rock in proportion to the normal force of its side. `own`: that of
/// the rock's facet.
template <class Surface>
[[nodiscard]] GroundFriction shared_friction(MovingRock<Surface>& rock, GroundFriction own, const InValley& phase) {
  if (rock.material_at(phase.other.facet) == rock.material_at(phase.on.facet)) return own;
  const GroundFriction other = friction_at(rock, phase.other.facet);
  const auto mix = [share = rock.valley_of(phase).first_share](double& mine, double others) {
    mine += share * (others - mine);
  };
  mix(own.mu, other.mu);
  mix(own.drag, other.drag);
  mix(own.sphere.dynamic, other.sphere.dynamic);
  mix(own.sphere.rolling, other.sphere.rolling);
  return own;
}

/// Drawn for both sides of a valley.
template <class Surface>
[[nodiscard]] GroundFriction friction_in(MovingRock<Surface>& rock, const InValley& phase) {
  const GroundFriction own = friction_at(rock, phase.on.facet);
  return shared_friction(rock, own, phase);
}

/// The least time [s] in which a rock moves by `way` [m], from `speed`, with at most this acceleration.
[[nodiscard]] inline double time_for_way(double way, double speed, double acceleration) {
  return 2 * way / (speed + std::sqrt(speed * speed + 2 * acceleration * way));
}

}  // namespace talus
