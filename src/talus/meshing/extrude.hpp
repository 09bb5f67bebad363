#pragma once
// Extrudes a section along y: two triangles per segment, so that triangle i belongs to segment i / 2.

#include <span>

#include "talus/meshing/raw_mesh.hpp"

namespace talus {

/// `section` is (x, z) from left to right; the mesh extends from y = 0 to y = `width` [m].
[[nodiscard]] RawMesh extruded(std::span<const Vec2> section, double width);

/// Rotates a mesh about the vertical through `about`, counter-clockwise seen from above [degrees]. Quarter turns are
/// exact.
void turn(RawMesh& mesh, double degrees, const Vec3& about);

}  // namespace talus
