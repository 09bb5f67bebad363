#pragma once
// The datum of all heights, one for all models. A block is the equivalent sphere (rock.hpp); its lowest point and its
// top are a diameter apart. The place of a rigid sphere is its centre. That of a lumped mass is where its block touches
// the ground, and so its lowest point. That of a rigid body is its centre of mass.
//
// - Bounce height: of the lowest point above the ground straight below it.
// - Height at a line, and what a fence must have: of the top above the foot, along the face.
//
// The impact height on a barrier is that of the contact (barriers/barrier.hpp).
//
// A rock with a shape has its own lowest corner and top at barriers, collectors and in its bounce height. Where only
// the path of its centre is known - maps, envelopes, lines and areas asked for after a run - it is the equivalent
// sphere.

#include <algorithm>

#include "talus/rocks/rock.hpp"

namespace talus {

/// `rigid_body`: rocks have the shapes of their seeders, spheres among them.
enum class RockModel { lumped_mass, rigid_sphere, rigid_body };

/// Whether rocks are more than points.
[[nodiscard]] constexpr bool has_extent(RockModel model) { return model != RockModel::lumped_mass; }

/// From a rock's place down to the lowest point of its block [m].
[[nodiscard]] inline double reach_of(RockModel model, const Rock& rock) { return has_extent(model) ? rock.radius : 0; }

/// The height of the lowest point [m], from that of the rock's place above the same ground, which it cannot be below.
[[nodiscard]] inline double lowest_point(double height, double reach) { return std::max(height - reach, 0.0); }

/// The heights of the block's centre and of its top [m].
[[nodiscard]] inline double centre_over(double lowest, double radius) { return lowest + radius; }
[[nodiscard]] inline double top_over(double lowest, double radius) { return lowest + 2 * radius; }

}  // namespace talus
