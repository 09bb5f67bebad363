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
[[nodiscard]] inline double rotational_energy(const Rock& rock, const Motion& motion) {
  return 0.5 * rock.inertia * motion.spin.squared_norm();
}

}  // namespace talus
