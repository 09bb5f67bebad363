#pragma once
// The shape of a rock from a scan of a block.

#include <string>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"
#include "talus/rocks/shape.hpp"

namespace talus::project {

/// The hull of a scan, thinned to the corners that the shape allows. Throws BadInput if the file cannot be read, has no
/// volume, or is a surface that bends far inwards. Warns of a mesh that is open, inside out or not convex. `report`: a
/// line with volume, convexity, axes and moments is added.
[[nodiscard]] RockShape scanned_block(const Project& project, const Shape& shape, std::string& report,
                                      Problems& warnings);

}  // namespace talus::project
