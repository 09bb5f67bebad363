#pragma once
// The kinetic energy of a rock.

#include "talus/rocks/motion.hpp"
#include "talus/rocks/rock.hpp"

namespace talus {

/// m v^2 / 2 [J].
[[nodiscard]] inline double translational_energy(const Rock& rock, const Motion& motion) {
  return 0.5 * rock.mass * motion.velocity.squared_norm();
}

/// I w^2 / 2 [J].
[[nodiscard]] inline double rotational_energy(const Rock& rock, const Vec3& spin) {
  return 0.5 * rock.inertia * spin.squared_norm();
}
[[nodiscard]] inline double rotational_energy(const Rock& rock, const Motion& motion) {
  return rotational_energy(rock, motion.spin);
}

/// Translational and rotational [J].
[[nodiscard]] inline double kinetic_energy(const Rock& rock, const Motion& motion) {
  return translational_energy(rock, motion) + rotational_energy(rock, motion);
}

}  // namespace talus
