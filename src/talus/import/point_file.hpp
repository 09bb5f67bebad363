#pragma once
// Points from text files: CSV, XYZ, TXT.
//
// One point a line; numbers stand between commas, semicolons, tabs or blanks, the same in the whole file. A first line
// of words names the columns, in any order and among others; without one the first three are x, y and z. Between
// semicolons and tabs a comma may be the decimal point. Empty lines and those that begin with # or // are passed over,
// a comment before the first point may name the columns. A first line of one whole number is how many points there are.
// Values may stand in quotation marks. No line has more values than the first one, or the one that names the columns:
// what is more may be the rest of a number with a decimal comma.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// Reads the points as they stand in the file, in metres. Throws BadInput with the first ten bad lines and the number
/// of others: too few or too many columns, no numbers, heights that are not ground of the earth; and where the columns
/// are not x, y and z, are in feet, or where there are no points, or not as many as the file says.
[[nodiscard]] std::vector<Vec3> read_point_file(const std::filesystem::path& path);

}  // namespace talus
