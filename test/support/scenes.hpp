#pragma once
// Rocks, grounds and whole runs for tests, with the energies of a path.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "talus/trajectory/rock_path.hpp"

namespace talus::testing_tools {

/// The properties that a test sets; all constant.
struct Soil {
  double rn = 0.5, rt = 0.8;
  double phi = 0.5;                 // friction angle [rad]
  double mu = 0.5, rolling = 0.05;  // rigid sphere
  double roughness = 0;             // standard deviation of the tilt [rad]
  double bump_spacing = 0;          // [m]
};

[[nodiscard]] inline Material material_of(const Soil& soil) {
  Material material;
  material.name = "test";
  material.normal_restitution = Sampler(soil.rn);
  material.tangential_restitution = Sampler(soil.rt);
  material.friction_angle = Sampler(soil.phi);
  if (soil.roughness > 0) {
    Distribution tilt;
    tilt.kind = DistributionKind::normal;
    tilt.std_dev = soil.roughness;
    material.roughness = RoughGround(Sampler(tilt, Bounds{}), soil.bump_spacing);
  }
  material.dynamic_friction = Sampler(soil.mu);
  material.rolling_friction = Sampler(soil.rolling);
  return material;
}

[[nodiscard]] inline Ground ground_of(const Soil& soil) { return Ground(material_of(soil)); }

/// The model with the impact law that a project has for it; `rotates`: of a lumped mass.
inline void set_model(Laws& laws, RockModel model, bool rotates = true) {
  laws.model = model;
  if (model == RockModel::rigid_sphere) {
    laws.impact = RigidSphereImpact{};
  } else if (rotates) {
    laws.impact = CrspLaw{};
  } else {
    laws.impact = PlainImpact{};
  }
}

struct Followed {
  RockOutcome outcome;
  RockLog log{true};
};

template <class Surface>
[[nodiscard]] Followed follow(const Surface& surface, const Ground& ground, const Laws& laws, const Release& release,
                              std::span<const Barrier> barriers = {}, std::uint64_t rock_number = 0) {
  Followed result;
  const Draws draws(SamplingPlan{}, rock_number);
  result.outcome = follow_rock(Scene<Surface>{surface, ground, barriers, laws}, release, draws, result.log);
  return result;
}

[[nodiscard]] inline double kinetic_energy(const Motion& motion, const Rock& rock) {
  return 0.5 * rock.mass * motion.velocity.squared_norm() + 0.5 * rock.inertia * motion.spin.squared_norm();
}

/// Kinetic and potential [J]; the datum is the origin.
[[nodiscard]] inline double total_energy(const Motion& motion, const Rock& rock, const Vec3& gravity) {
  return kinetic_energy(motion, rock) - rock.mass * gravity.dot(motion.position);
}

[[nodiscard]] inline bool is_finite(const Motion& motion) {
  return motion.position.is_finite() && motion.velocity.is_finite() && motion.spin.is_finite() &&
         std::isfinite(motion.time);
}

/// To the last digit, so that a case can be repeated from a test's output.
[[nodiscard]] inline std::string text(const Vec3& v) {
  char line[120];
  std::snprintf(line, sizeof line, "{%.17g, %.17g, %.17g}", v.x(), v.y(), v.z());
  return line;
}

/// The wrong row, and some before it.
[[nodiscard]] inline std::string rows_up_to(const Followed& path, std::size_t last) {
  std::string lines = "\n";
  for (std::size_t k = last < 6 ? 0 : last - 6; k <= std::min(last, path.log.rows.size() - 1); ++k) {
    const PathState state = path.log.rows[k].state;
    const Motion& motion = path.log.rows[k].motion;
    lines += std::to_string(k) + ' ' + name(state) + " t " + std::to_string(motion.time) + " p " +
             text(motion.position) + " v " + text(motion.velocity) + " w " + text(motion.spin) + '\n';
  }
  return lines;
}

/// The pieces of a path, with glides expanded into their steps.
inline std::vector<PathPiece> every_piece(const RockLog& log) {
  std::vector<PathPiece> pieces;
  log.for_each_piece([&](const PathPiece& piece) { pieces.push_back(piece); });
  return pieces;
}

}  // namespace talus::testing_tools
