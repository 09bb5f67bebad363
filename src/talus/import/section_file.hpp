#pragma once
// A slope in section from a file: points in a text file, or a line in a drawing or a vector file.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"

namespace talus {

struct SectionSource {
  std::filesystem::path file;
  std::string layer;       // of a vector file, or of a DXF; empty: the only one, or all
  double tolerance_m = 0;  // vertices that lie within this distance of the line through the others are left out
};

/// The vertices [x, z] of the section [m], in the order of the file.
///
/// - Text: the columns distance (or x) and z in the order along the slope; with y as well, the points are a line in
///   space.
/// - A vector file or drawing: its only line. A line in space, with heights, gives the section along itself: x is the
///   distance on plan from its first vertex. A line without heights in a file without a coordinate system is a drawn
///   section: its x and y are x and z.
///
/// Vertices that repeat the one before are left out. Simplified by Douglas and Peucker's method.
/// Throws BadInput as read_section_points() and read_vector_file() do; and for more than one line, and lines on a map
/// without heights.
[[nodiscard]] std::vector<std::array<double, 2>> read_section_file(const SectionSource& source, Problems& warnings);

}  // namespace talus
