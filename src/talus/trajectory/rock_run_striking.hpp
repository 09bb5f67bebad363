#pragma once
// The part of RockRun in which the rock strikes the ground. Included by rock_run.hpp only.

#include "talus/trajectory/rock_run.hpp"

namespace talus {

/// The rock meets the ground: the impact law, and whether the rock stays on the ground after it.
template <class Surface>
auto RockRun<Surface>::strike(const Contact& contact) -> Phase {
  arrive(PathState::impact);
  log_.impact(motion_.position);
  const Material& material = ground_[material_at(contact.facet)];
  const std::uint32_t number = contacts_;
  const GroundDraw draw = draw_at(contact.facet);
  if (hops_ && grazes(contact.normal, motion_.velocity)) {
    const double rt = draw.restitution(material)[1];
    draw_friction(on_ground_, draw, material, rt);
    settle_onto(contact.normal, on_ground_.mu);
    return enter_ground(contact, draw, material, rt);
  }

  Vec3 n = contact.normal;
  if (material.is_rough()) {
    const Vec3 vt = tangential(motion_.velocity, n);
    const Vec3 down = tangential(laws_.gravity, n);
    // Straight down on level ground it comes from anywhere.
    const Vec3 across = vt.squaredNorm() > 0 ? vt : down.squaredNorm() > 0 ? down : tangential(Vec3::UnitX(), n);
    auto [ahead, aside] = draw.roughness(material, number);
    if (laws_.in_section) aside = 0;
    const Vec3 tilted = tilted_normal(n, across.normalized(), ahead, aside);
    if (motion_.velocity.dot(tilted) < 0) n = tilted;  // otherwise the bump is turned away from the rock
  }

  const bool is_crsp = laws_.model == RockModel::lumped_mass && laws_.rotation;
  CrspImpact impact;  // before the draws, which take as long as it does and do not wait for it
  if (is_crsp) impact = crsp_impact(motion_.velocity, motion_.spin, n, rock_.radius);
  const auto [rn_drawn, rt] = draw.restitution(material);
  const double vn = motion_.velocity.dot(n);
  const Restitution restitution{laws_.restitution_scaling.scaled(rn_drawn, vn, rock_.mass), rt};
  Rebound rebound;
  if (laws_.model == RockModel::rigid_sphere) {
    Restitution damped = restitution;
    if (laws_.tangential_crsp_damping) {
      damped.tangential = crsp_damped_tangential_restitution(motion_.velocity, motion_.spin, n, rock_, restitution);
    }
    rebound = rigid_sphere_rebound(motion_.velocity, motion_.spin, n, rock_, damped, draw.dynamic_friction(material));
  } else if (is_crsp) {
    rebound = crsp_rebound(impact, rock_, restitution);
  } else {
    rebound = plain_rebound(motion_.velocity, motion_.spin, n, restitution);
  }
  motion_.velocity = kept_outside(rebound.velocity, contact.normal);
  motion_.spin = rebound.spin;
  note_energy();

  const bool leaves = motion_.velocity.dot(contact.normal) >= leaving_speed_;
  const bool carried = contact.feature == Feature::facet ? laws_.gravity.dot(contact.normal) < 0
                                                         : pressure_on_edge(contact.facet, contact.normal) > 0;
  if (leaves || !carried) {
    remember_strike(contact.normal, contact.facet);
    log_.row(PathState::projectile, motion_);
    return fly_off();
  }
  return enter_ground(contact, draw, material, rt);
}

}  // namespace talus
