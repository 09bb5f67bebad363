#pragma once
// A raster as a picture over the terrain: warped to the terrain's coordinate system, limited in size.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/layers/terrain_on_plan.hpp"

namespace talus {

struct LayerPicture {
  PlanArea area;                        // of the picture: the common part of raster and terrain
  std::uint32_t columns = 0, rows = 0;  // of pixels; the first row is in the north
  std::string type;                     // "image/jpeg", or "image/png" if parts of it are transparent
  std::string bytes;
  /// Of a single band of measured values: the values of the first and the last colour of `ramp`, #rrggbb each, evenly
  /// spaced. Empty: the picture has its own colours.
  double least = 0, most = 0;
  std::vector<std::string> ramp;
};

/// The largest number of pixels along a side.
inline constexpr std::uint32_t most_pixels = 4096;

/// Checks that a raster can be read and lies over the terrain, without reading its cells. Throws BadInput with all
/// errors; doubts (no coordinate system, a large raster without overviews) are added to `warnings`.
void check_picture(const std::filesystem::path& file, const TerrainOnPlan& terrain, Problems& warnings);

/// Reads a raster through its overviews if it has any. Three or more bands are red, green and blue, as the file names
/// them or else in its order; more than 8 bits are scaled from their least to their greatest value. A band with a
/// colour table has its colours, one of 8 bits is grey, any other one has a ramp of colours from its least to its
/// greatest value over the terrain. Alpha, masks and values without data are transparent. The raster may be in any
/// coordinate system; if it or the terrain has none, both are assumed to be the same.
///
/// Throws BadInput with all errors: not a raster; not georeferenced; degrees or feet if the terrain has no coordinate
/// system; elsewhere than the terrain; cut short. Doubts as above.
[[nodiscard]] LayerPicture picture_of_raster(const std::filesystem::path& file, const TerrainOnPlan& terrain,
                                             Problems& warnings, std::uint32_t most = most_pixels);

}  // namespace talus
