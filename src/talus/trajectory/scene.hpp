#pragma once
// Everything that a trajectory depends on except the rock's number: built once, constant, shared by all rocks.

#include "talus/barriers/barrier.hpp"
#include "talus/ground/material.hpp"
#include "talus/impact/law.hpp"
#include "talus/rocks/heights.hpp"

namespace talus {

enum class SlidingMethod { stepped, closed_form };
/// Where the friction angle of a sliding lumped mass comes from.
enum class FrictionSource {
  material,
  tangential_restitution,  // phi = arctan((1 - Rt) / Rt)
  zero
};

/// How rough ground acts.
enum class RoughnessLaw {
  faces,  // in impacts and along the ground: a rock meets faces by the area that they show it (ground/rough_ground.hpp)
  tilts   // in impacts only: the ground is tilted, however the rock comes in; RocFall
};

struct Laws {
  RockModel model = RockModel::lumped_mass;
  ImpactLaw impact = CrspLaw{};  // must fit `model`
  Vec3 gravity{0, 0, -standard_gravity};
  SlidingMethod sliding = SlidingMethod::stepped;
  double timestep = 0.01;               // of stepped motion along the ground [s]
  double normal_velocity_cutoff = 0.1;  // a rock with less of it after an impact stays on the ground [m/s]
  // Sine of the angle to the ground below which a rock that moves along it moves on without an impact; 15 deg.
  double grazing = 0.25881904510252074;
  double stopped_velocity = 0.1;   // a slower rock stops where friction can hold it [m/s]
  std::int64_t max_steps = 10000;  // flights, impacts and stretches along the ground
  double max_time = 600;           // [s]
  FrictionSource friction_source = FrictionSource::material;
  RoughnessLaw roughness = RoughnessLaw::faces;
  RestitutionScaling restitution_scaling;
  MaterialSampling material_sampling = MaterialSampling::per_impact;
  bool in_section = false;  // 2D: roughness tilts the ground only about y
};

template <class Surface>
struct Scene {
  const Surface& surface;
  const Ground& ground;
  BarrierList barriers;
  const Laws& laws;
};

}  // namespace talus
