#pragma once
// Points from text files: CSV, XYZ, TXT.
//
// One point per line; numbers are separated by commas, semicolons, tabs or blanks, the same in the whole file. A first
// line of words names the columns, in any order and among others; without one the first three columns are x, y and z.
// With semicolons and tabs, numbers may have decimal commas. Empty lines and comments (# or //) are skipped; a comment
// before the first point may name the columns. A first line of one integer is the number of points. Values may be
// quoted. No line may have more values than the line that names the columns, or else the first one: surplus values may
// come from decimal commas.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// Reads the points [m] in the order of the file. Throws BadInput with the first ten bad lines and the number of
/// others: too few or too many columns, not numbers, impossible heights; also if the columns are not x, y and z or are
/// in feet, if there are no points, or not as many as the file declares.
[[nodiscard]] std::vector<Vec3> read_point_file(const std::filesystem::path& path);

struct SectionPoints {
  std::vector<Vec3> points;  // [m]
  bool has_y = false;        // otherwise x is the distance along the section, and y is 0
};
/// The same for a line of points, which may have no y. Without a line of names two columns are distance and height.
[[nodiscard]] SectionPoints read_section_points(const std::filesystem::path& path);

}  // namespace talus
