#pragma once
// The coordinate system of a file, and whether its units are metres on the ground. Only for files that are built with
// GDAL.

#include <ogr_spatialref.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "talus/core/vec.hpp"
#include "talus/gdal/gdal_raster.hpp"

namespace talus {

/// How much lengths on plan may differ from those on the ground, as a share: above the first there is a warning, above
/// the second an error. UTM stays within 0.001 in its zone; Web Mercator has 0.48 at 47.5 degrees.
inline constexpr double doubtful_scale = 0.01;
inline constexpr double refused_scale = 0.05;

/// An error if PROJ cannot look up coordinate systems, or nullopt: without its database every file would seem to have
/// none.
[[nodiscard]] std::optional<Problem> fault_of_proj(GdalMessages& messages);

/// Whether it is a local (engineering) coordinate system, which belongs to no map. In metres it says no more than
/// crs = "local" in a project.
[[nodiscard]] bool is_local(const OGRSpatialReference& crs);

/// The part of a coordinate system, or of a user's words for one, that names a file: "+nadgrids=../grid.gsb". Names of
/// PROJ's own files, without a folder, are nothing to object to. nullopt if there is none.
[[nodiscard]] std::optional<std::string> file_named_in(const OGRSpatialReference& crs);
[[nodiscard]] std::optional<std::string> file_named_in(std::string_view words);

/// Adds an error and returns true if the coordinate system names a file: nothing may be transformed with it.
bool refuse_files_in_crs(const OGRSpatialReference& crs, RasterProblems& problems, const std::string& hint);

/// Its horizontal part, as an option of commands that transform on plan: " -s_srs EPSG:4326"; with it they keep heights
/// as they are. Empty if the coordinate system has no vertical part.
[[nodiscard]] std::string option_to_keep_heights(const OGRSpatialReference& crs);

/// As WKT 2 (ISO 19162:2019).
[[nodiscard]] std::string wkt_of(const OGRSpatialReference& crs);
/// The coordinate system of such a text, for a file, with easting first; nullopt if it is none. If it is one of EPSG's,
/// its parts have EPSG's numbers, which the text leaves out: without them, GDAL searches for the name of the datum.
[[nodiscard]] std::optional<OGRSpatialReference> crs_for_file(const std::string& wkt);

/// Its common name: "EPSG:31287", or its own name if it has no code.
[[nodiscard]] std::string name_of(const OGRSpatialReference& crs);

struct LengthUnit {
  std::string name;
  double metres = 1;  // in one unit
};

/// The unit of height; nullopt if the coordinate system has no heights.
[[nodiscard]] std::optional<LengthUnit> unit_of_height(const OGRSpatialReference& crs);

/// Why the heights of a file in this coordinate system cannot be used, in words; nullopt if they are metres upwards, or
/// if it has none.
struct HeightFault {
  std::string what, why;
};
[[nodiscard]] std::optional<HeightFault> fault_of_heights(const OGRSpatialReference& crs);

/// Whether the third axis of the coordinate system points down: its numbers are depths.
[[nodiscard]] bool has_depths(const OGRSpatialReference& crs);

/// Refuses coordinate systems that name a file, that are not in metres on plan, or not in metres on the ground at
/// `centre` (x and y as in the file; nullopt if it is not georeferenced).
void check_terrain_crs(const OGRSpatialReference& crs, const std::optional<Vec2>& centre, RasterProblems& problems);

/// The commands that repair a file of another kind than a raster.
struct CrsCommands {
  std::function<std::string(const std::string& target)> project;  // to one such as "EPSG:32633"; must keep heights
  std::string name;                                               // assigns the right one to the file
};

/// Overload for such a file.
void check_terrain_crs(const OGRSpatialReference& crs, const std::optional<Vec2>& centre, RasterProblems& problems,
                       const CrsCommands& commands);

/// "gdal_translate ... -scale 0 1 0 FACTOR": converts heights in another unit to metres, and drops a unit of height
/// from the coordinate system (null: the file has none).
[[nodiscard]] std::string command_to_metres_of_height(double metres_per_unit, const OGRSpatialReference* crs,
                                                      const RasterProblems& problems);

}  // namespace talus
