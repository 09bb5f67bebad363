#pragma once
// The motion of a rock as plain data, in the model's local frame (SI units, z up).

#include "talus/core/vec.hpp"

namespace talus {

/// Position and velocity of a rock's centre, and its spin. A lumped mass is its centre.
struct Motion {
  Vec3 position;    // [m]
  Vec3 velocity;    // [m/s]
  Vec3 spin;        // angular velocity [rad/s]
  double time = 0;  // since release [s]
};

/// The state in a row of a path. `impact` and `barrier` are arrivals; in the others the rock leaves.
enum class PathState { projectile, impact, sliding, rolling, barrier, ended };

/// Why a trajectory ends.
enum class EndReason {
  at_rest,
  left_model,  // its centre crossed the edge of the terrain
  no_data,     // its centre fell into a hole in the terrain's data
  stopped_by_barrier,
  maximum_steps,
  maximum_time,
  lost,  // it is below the surface: a defect of the program, counted and reported
};
inline constexpr int end_reason_count = 7;

[[nodiscard]] const char* name(PathState state);
[[nodiscard]] const char* name(EndReason reason);

}  // namespace talus
