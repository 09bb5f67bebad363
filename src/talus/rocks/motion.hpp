#pragma once
// The state of a rock as plain data, in the model's local frame (SI units, z up).

#include "talus/core/vec.hpp"

namespace talus {

/// Where a rock's centre is and how it moves. For the lumped mass the centre is the rock.
struct Motion {
  Vec3 position = Vec3::Zero();  // [m]
  Vec3 velocity = Vec3::Zero();  // [m/s]
  Vec3 spin = Vec3::Zero();      // angular velocity [rad/s]
  double time = 0;               // since release [s]
};

/// What a row of a path says of the rock. `impact` and `barrier` are arrivals; the others, states in which it leaves.
enum class PathState { projectile, impact, sliding, rolling, barrier, ended };

/// Why a rock's path is over.
enum class EndReason {
  at_rest,
  left_model,  // its centre crossed the edge of the terrain
  no_data,     // its centre came over a hole in the terrain, and into it
  stopped_by_barrier,
  maximum_steps,
  maximum_time,
  lost,  // it got beneath the surface: a defect of the program, counted and reported
};
inline constexpr int end_reason_count = 7;

[[nodiscard]] const char* name(PathState state);
[[nodiscard]] const char* name(EndReason reason);

}  // namespace talus
