#pragma once
// Classes (integers, one for each kind of ground) from a raster file, sampled at points of the terrain.

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

/// Band 1 of a raster file, in any coordinate system, with cells of any size and orientation.
class ClassRaster {
 public:
  /// `terrain_crs_wkt` is the coordinate system of the points that will be queried; if it is empty, or if the file has
  /// none, both are assumed to be the same. Throws BadInput with all errors in the file; doubts are added to
  /// `warnings`.
  ClassRaster(const std::filesystem::path& path, const std::string& terrain_crs_wkt, Problems& warnings);
  ClassRaster(ClassRaster&&) noexcept;
  ClassRaster& operator=(ClassRaster&&) noexcept;
  ~ClassRaster();

  /// The classes of the cells that contain `points` (x, y); nullopt outside the raster and where it has no data.
  /// Successive points should be close together, because the file is read in windows. If the coordinate systems differ,
  /// points in a row along x are placed to a twentieth of a cell. Throws BadInput if the file cannot be read or a value
  /// is not an integer of at most 32 bits.
  [[nodiscard]] std::vector<std::optional<std::int32_t>> at(std::span<const Vec2> points);

  /// How many of the points queried so far are within the raster, with or without data.
  [[nodiscard]] std::uint64_t points_within() const;
  /// The name of the coordinate system for messages, for example "EPSG:31287"; empty if the file has none.
  [[nodiscard]] const std::string& crs_name() const;

 private:
  class Reader;
  std::unique_ptr<Reader> reader_;
};

}  // namespace talus
