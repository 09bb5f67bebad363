#pragma once
// Grids of text as Esri writes them (.asc): GDAL takes what is not a number for 0, or for the number that it begins
// with, and stops where it has enough. So such a file is read here first, from end to end, and only held against its
// own header.

#include <filesystem>

namespace talus {

/// Whether GDAL would take a file for such a grid: by how it begins, whatever its name.
[[nodiscard]] bool is_ascii_grid(const std::filesystem::path& file);

/// How GDAL reads the cells of a grid: as whole numbers of 32 bits where no number has a point or an exponent.
enum class GridNumbers { whole, real };

/// Throws BadInput with the first things that are wrong: keys of the header, what is not a number, too few or too many
/// cells.
void check_ascii_grid(const std::filesystem::path& file, GridNumbers numbers);

}  // namespace talus
