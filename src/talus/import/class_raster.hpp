#pragma once
// Classes (whole numbers, one for each kind of ground) from a raster file, asked for at points of the terrain.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/core/vec.hpp"

namespace talus {

/// Band 1 of a raster file, in any coordinate system, with cells of any size, turned or not.
class ClassRaster {
 public:
  /// `terrain_crs_wkt` is the coordinate system of the points that will be asked for; where it is empty, or where the
  /// file names none, both are taken to be the same. Throws BadInput with all that is wrong with the file; what is only
  /// doubtful is added to `warnings`.
  ClassRaster(const std::filesystem::path& path, const std::string& terrain_crs_wkt, Problems& warnings);
  ClassRaster(ClassRaster&&) noexcept;
  ClassRaster& operator=(ClassRaster&&) noexcept;
  ~ClassRaster();

  /// The classes of the cells that `points` (x, y) lie in; nothing outside the raster and where it has no data. Points
  /// next to each other in the list should be near each other: the file is read piece by piece. With another
  /// coordinate system, points in a row along x are placed to a twentieth of a cell. Throws BadInput where the file
  /// cannot be read or holds what is not a whole number of at most 32 bits.
  [[nodiscard]] std::vector<std::optional<std::int32_t>> at(std::span<const Vec2> points);

  /// How many of the points asked for so far lay within the raster, with data or without.
  [[nodiscard]] std::uint64_t points_within() const;
  /// The coordinate system for people, for example "EPSG:31287"; empty where the file names none.
  [[nodiscard]] const std::string& crs_name() const;

 private:
  class Reader;
  std::unique_ptr<Reader> reader_;
};

}  // namespace talus
