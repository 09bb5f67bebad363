#pragma once
// The coordinate system of a raster, and whether its numbers are metres on the ground. For files that are built
// with GDAL only.

#include <ogr_spatialref.h>

#include <functional>
#include <optional>
#include <string>

#include "talus/core/vec.hpp"
#include "talus/gdal/gdal_raster.hpp"

namespace talus {

/// The largest share by which lengths on plan may be longer or shorter than on the ground: beyond the first there is a
/// warning, beyond the second a refusal. UTM stays within 0.001 in its zone; Web Mercator has 0.48 at 47.5 degrees.
inline constexpr double doubtful_scale = 0.01;
inline constexpr double refused_scale = 0.05;

/// What is wrong where PROJ cannot look up coordinate systems: without its database it knows none, and every file would
/// seem to have none. Nothing where it can.
[[nodiscard]] std::optional<Problem> fault_of_proj(GdalMessages& messages);

/// As WKT 2 (ISO 19162:2019).
[[nodiscard]] std::string wkt_of(const OGRSpatialReference& crs);

/// What people call it: "EPSG:31287", or its name where it has no number.
[[nodiscard]] std::string name_of(const OGRSpatialReference& crs);

struct LengthUnit {
  std::string name;
  double metres = 1;  // of one
};

/// The unit of height, where the coordinate system has heights.
[[nodiscard]] std::optional<LengthUnit> unit_of_height(const OGRSpatialReference& crs);

/// What is wrong with the heights of a file in this coordinate system, in words: what, and why. Nothing where they are
/// metres upwards, as far as it says.
struct HeightFault {
  std::string what, why;
};
[[nodiscard]] std::optional<HeightFault> fault_of_heights(const OGRSpatialReference& crs);

/// Whether the third axis of the coordinate system points down: its numbers are depths.
[[nodiscard]] bool has_depths(const OGRSpatialReference& crs);

/// Refuses coordinate systems whose plan is not in metres, or not in metres of the ground, at `centre` (x and y as in
/// the file; absent where the file does not say where it lies).
void check_terrain_crs(const OGRSpatialReference& crs, const std::optional<Vec2>& centre, RasterProblems& problems);

/// The commands that mend a file of another kind than a raster.
struct CrsCommands {
  std::function<std::string(const std::string& target)> project;  // to a coordinate system such as "EPSG:32633"
  std::string name;                                               // gives the file the true one
};

/// The same for such a file.
void check_terrain_crs(const OGRSpatialReference& crs, const std::optional<Vec2>& centre, RasterProblems& problems,
                       const CrsCommands& commands);

/// "gdal_translate ... -scale 0 1 0 FACTOR": makes metres of heights in a unit of so many metres, and leaves a
/// coordinate system (null: the file names none) that does not say otherwise.
[[nodiscard]] std::string command_to_metres_of_height(double metres_per_unit, const OGRSpatialReference* crs,
                                                      const RasterProblems& problems);

}  // namespace talus
