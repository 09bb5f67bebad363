#pragma once
// Checks Esri ASCII grids (.asc) before GDAL reads them. GDAL reads a token that is not a number as 0, or as the number
// that it begins with, and stops when it has enough cells. So the whole file is first compared with its header here.

#include <filesystem>

namespace talus {

/// Whether GDAL would read a file as such a grid: decided by how it begins, whatever its name.
[[nodiscard]] bool is_ascii_grid(const std::filesystem::path& file);

/// How GDAL reads the cells of a grid: as 32-bit integers (`whole`) if no number has a point or an exponent.
enum class GridNumbers { whole, real };

/// Throws BadInput with the first errors: bad or missing keys in the header, cells that are not numbers, too few or too
/// many cells.
void check_ascii_grid(const std::filesystem::path& file, GridNumbers numbers);

}  // namespace talus
