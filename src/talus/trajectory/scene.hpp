#pragma once
// Everything that the path of a rock depends on, besides its number: built once, shared by all rocks, never written to.

#include "talus/barriers/barrier.hpp"
#include "talus/ground/material.hpp"
#include "talus/impact/law.hpp"

namespace talus {

enum class RockModel { lumped_mass, rigid_sphere };
enum class SlidingMethod { stepped, closed_form };
/// Where the friction angle of a sliding lumped mass comes from.
enum class FrictionSource {
  material,
  tangential_restitution,  // phi = arctan((1 - Rt) / Rt)
  zero
};

struct Laws {
  RockModel model = RockModel::lumped_mass;
  bool rotation = true;  // lumped mass: the CRSP impact; otherwise the plain one
  Vec3 gravity{0, 0, -standard_gravity};
  SlidingMethod sliding = SlidingMethod::stepped;
  double timestep = 0.01;                // of stepped motion along the ground [s]
  double normal_velocity_cutoff = 0.1;   // a rock that leaves an impact more slowly stays on the ground [m/s]
  double grazing = 0.00174532836589831;  // sine of the angle at which a slide goes on without an impact; of 0.1 degrees
  double stopped_velocity = 0.1;         // a rock slower than this stops where friction holds it [m/s]
  std::int64_t max_steps = 10000;        // flights, impacts and stretches along the ground
  double max_time = 600;                 // [s]
  FrictionSource friction_source = FrictionSource::material;
  RestitutionScaling restitution_scaling;
  bool tangential_crsp_damping = false;  // rigid sphere
  MaterialSampling material_sampling = MaterialSampling::per_impact;
  bool in_section = false;  // 2D: roughness tilts the ground about y only

  [[nodiscard]] ImpactLaw impact_law() const {
    if (model == RockModel::rigid_sphere) return RigidSphereImpact{tangential_crsp_damping};
    if (rotation) return CrspLaw{};
    return PlainImpact{};
  }
};

template <class Surface>
struct Scene {
  const Surface& surface;
  const Ground& ground;
  BarrierList barriers;
  const Laws& laws;
};

}  // namespace talus
