#pragma once
// The path of a block for pictures, which move it straight and turn it evenly from each of a few poses to the next.

#include <cstddef>
#include <span>
#include <vector>

#include "talus/rocks/attitude.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

/// Where a block is at a time, and how it is turned.
struct Pose {
  double time = 0;  // since release [s]
  Vec3 position;    // of its centre [m]
  Orientation orientation;
};

/// How far the block of a picture may be from its path between two poses.
struct PoseTolerance {
  double distance = 0.02;  // of the centre [m]
  double angle = 0.05;     // [rad]
};

/// Where a picture shows the block at a share of the time between two poses. Of the two ways to turn from one
/// orientation to the other it takes the shorter.
[[nodiscard]] Pose between(const Pose& from, const Pose& to, double share);

/// The poses of a block from its release to its end, within the tolerance. If they are more than `max_poses`, at least
/// 2, the tolerance is doubled until they are not. `pieces`: without glides, at least one; `attitudes`: at least one;
/// `inertia`: principal moments [kg m2].
[[nodiscard]] std::vector<Pose> poses_along(std::span<const PathPiece> pieces, std::span<const Attitude> attitudes,
                                            const Vec3& inertia, PoseTolerance tolerance, std::size_t max_poses);

}  // namespace talus
