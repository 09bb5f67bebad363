#pragma once
// Points, lines and polygons from a vector file: one layer of a GeoPackage, Shapefile, GeoJSON, DXF or CSV with
// coordinates, transformed to the coordinate system of the terrain.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/core/vec.hpp"

namespace talus {

enum class ShapeKind { point, line, polygon };

struct VectorShape {
  ShapeKind kind = ShapeKind::point;
  /// A point is one list of one vertex, a line one list, a polygon its outer ring and then its holes. A ring does not
  /// repeat its first vertex. x and y are in metres; z is as in the file, or 0 if the feature has none.
  std::vector<std::vector<Vec3>> lists;
};

struct VectorFeature {
  std::int64_t id = 0;  // GDAL's number, which QGIS shows, too
  bool has_z = false;
  std::vector<VectorShape> parts;                  // one or more
  std::vector<std::optional<std::string>> values;  // one for each requested attribute; nullopt if it is null
};

/// What to read.
struct VectorRequest {
  std::string layer;                    // empty: the only one with geometry; of a DXF a CAD layer; empty: all of them
  std::string layer_key = "layer";      // the project's key for it, for hints
  std::vector<std::string> attributes;  // to be read; case-insensitive
  std::vector<ShapeKind> kinds;         // to be read; empty: all
  /// Whether polygons are rings in space, which may be vertical, instead of areas on plan.
  bool polygons_are_in_space = false;
  /// Whether z is used. If the file declares its heights, they must be metres upwards.
  bool heights_are_used = false;
  /// Whether a line all of whose heights are the same counts as one without heights, drawn on plan.
  bool level_lines_are_drawn = false;
  /// The coordinate system of the terrain as WKT; empty: not known. Features are transformed to it vertex by vertex (z
  /// is kept). If it or that of the file is not known, both are assumed to be the same.
  std::string terrain_crs_wkt;
  /// Only features that touch this rectangle, or almost: its lowest and its highest corner, in the coordinates of the
  /// terrain. A file with a spatial index does not even read the others.
  std::optional<std::array<Vec2, 2>> within{};
  /// If given, chooses the attributes to be read from all that the layer has, instead of `attributes`.
  std::function<std::vector<std::string>(const std::vector<std::string>& names)> choose{};
};

struct VectorLayer {
  std::string name;
  std::string crs_wkt;                  // of the file; empty: it has none
  std::string crs_name;                 // for messages, for example "EPSG:31287"
  bool crs_is_local = false;            // it has metres that belong to no map, and nor has the terrain others
  std::vector<VectorFeature> features;  // one or more, in the order of the file
  std::vector<bool> are_numbers;        // for each requested attribute: numbers, written as short as possible
};

/// Curves become chords, collections and surfaces of facets (TIN) several parts. Of a DXF, which mixes kinds, other
/// kinds are left out, closed lines are polygons if only polygons are requested, and only the model is read, not
/// layouts or hidden layers, nor texts beside points. Throws BadInput with all errors: no such file, layer or
/// attribute; an empty layer; degrees or feet, if the terrain's coordinate system is not known; a DXF in another unit
/// than metres; kinds that were not requested; polygons that cross themselves on plan; coordinates that are not finite
/// or cannot be transformed; heights, if they are used, in another unit, of no ground, or of curves in a DXF;
/// coordinate systems that name files; attributes that are not UTF-8; too many features or vertices; and if the program
/// was built without GDAL. Doubts are added to `warnings`.
[[nodiscard]] VectorLayer read_vector_file(const std::filesystem::path& path, const VectorRequest& request,
                                           Problems& warnings);

}  // namespace talus
