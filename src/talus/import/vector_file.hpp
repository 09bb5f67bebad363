#pragma once
// Points, lines and polygons from a vector file: one layer of a GeoPackage, Shapefile, GeoJSON, DXF or CSV with
// coordinates, brought to the coordinate system of the terrain.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/core/vec.hpp"

namespace talus {

enum class ShapeKind { point, line, polygon };

struct VectorShape {
  ShapeKind kind = ShapeKind::point;
  /// A point is one list of one vertex, a line is one list, a polygon is its outer ring and then its holes. A ring does
  /// not repeat its first vertex at its end. x and y [m]; z as in the file, and 0 where the feature has none.
  std::vector<std::vector<Vec3>> lists;
};

struct VectorFeature {
  std::int64_t id = 0;  // as GDAL numbers it, and QGIS shows it
  bool has_z = false;
  std::vector<VectorShape> parts;                  // one or more
  std::vector<std::optional<std::string>> values;  // one for each attribute asked for; nothing where it is null
};

/// What to read.
struct VectorRequest {
  std::string layer;                    // empty: the only one with geometry; in a DXF a CAD layer, or all of them
  std::string layer_key = "layer";      // the project's key that names it, for hints
  std::vector<std::string> attributes;  // whose values are wanted; capitals do not matter
  std::vector<ShapeKind> kinds;         // which are wanted; empty: all
  /// Whether polygons are rings in space, which may stand upright, instead of areas on plan.
  bool polygons_are_in_space = false;
  /// Whether the features' z are used: then they must be metres upwards, as far as the file says.
  bool heights_are_used = false;
  /// The coordinate system of the terrain as WKT; empty: not known. Features are brought to it vertex by vertex (z
  /// stays as it is). Where it or that of the file is not known, both are taken to be the same.
  std::string terrain_crs_wkt;
};

struct VectorLayer {
  std::string name;
  std::string crs_wkt;                  // of the file; empty: it names none
  std::string crs_name;                 // for people, for example "EPSG:31287"
  std::vector<VectorFeature> features;  // one or more, in the order of the file
};

/// Curves become chords, collections several parts. A DXF mixes kinds: those that are not wanted are left out, closed
/// lines are polygons where polygons alone are wanted, and only the model is read, not its layouts or hidden layers.
/// Throws BadInput with all that is wrong: no such file, layer or attribute, an empty layer, degrees or feet without a
/// terrain to bring them to, a DXF that names another unit than metres, other kinds than those wanted, polygons on plan
/// that cross themselves, coordinates that are not numbers or have no place in the terrain's coordinate system, heights
/// in another unit, attributes that are not UTF-8, more than Talus takes; and where the program was built without GDAL.
/// What is only doubtful is added to `warnings`.
[[nodiscard]] VectorLayer read_vector_file(const std::filesystem::path& path, const VectorRequest& request,
                                           Problems& warnings);

}  // namespace talus
