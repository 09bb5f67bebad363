#pragma once
// The list of impact laws. A model chooses one when it is built; every impact of its rocks uses it.
//
// A law is a type with
//   rebound(approach, restitution, friction) -> Rebound
// where restitution() draws the ground's coefficients, Rn already lowered by Laws::restitution_scaling, and friction()
// those of a sphere's contact, each called at most once: what a law does not need is not drawn. To add a law: a file
// here with its equations and its type, and its name in the list.

#include <variant>

#include "talus/impact/crsp.hpp"
#include "talus/impact/plain.hpp"
#include "talus/impact/rigid_sphere.hpp"

namespace talus {

using ImpactLaw = std::variant<CrspLaw, PlainImpact, RigidSphereImpact>;

/// Whether rolling friction acts on the impulse of an impact, of a sphere or of a block (rigid_body.hpp).
[[nodiscard]] inline bool rolling_resists_in_impacts(const ImpactLaw& law) {
  const auto* const rigid = std::get_if<RigidSphereImpact>(&law);
  return rigid != nullptr && rigid->has_rolling_resistance;
}

}  // namespace talus
