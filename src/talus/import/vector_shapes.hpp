#pragma once
// Converts OGR's geometries to shapes in the coordinate system of the terrain. Only for files that are built with GDAL.

#include <ogr_geometry.h>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {

/// The command `ogr2ogr options NEW OLD`, where NEW is the file's name with another ending, quoted for a shell.
[[nodiscard]] std::string ogr2ogr(std::string_view options, const std::filesystem::path& file, std::string_view ending);

/// Converts geometries one by one and collects their errors.
class VectorShapes {
 public:
  /// `crs` is that of the file, null if it has none; errors in it are added to `problems`. `is_drawing`: a DXF.
  VectorShapes(const VectorRequest& request, const OGRSpatialReference* crs, bool is_drawing, RasterProblems& problems);

  /// Adds the parts of a geometry to its feature.
  void add(const OGRGeometry& geometry, VectorFeature& feature);
  /// Adds the collected errors to `problems`.
  void report();

 private:
  enum Fault : std::size_t {
    other_kind,
    open_ring,
    invalid,
    not_finite,
    bad_height,
    not_degrees,
    without_place,
    fault_count
  };
  struct Faulty {
    std::uint64_t count = 0;
    std::vector<std::array<std::string, 2>> first;  // the feature, and what it is or has
  };

  void find_transformation(const OGRSpatialReference* crs);
  [[nodiscard]] bool reads(ShapeKind kind) const;
  [[nodiscard]] bool accepts(ShapeKind kind, const VectorFeature& feature);
  [[nodiscard]] bool is_valid(const OGRGeometry& geometry, const VectorFeature& feature);
  void add_line(ShapeKind kind, const OGRLineString& line, VectorFeature& feature);
  void add_polygon(const OGRPolygon& polygon, VectorFeature& feature);
  /// The line in the terrain's coordinates; nullopt, with an error, if a vertex cannot be transformed.
  [[nodiscard]] std::optional<std::vector<Vec3>> placed(const OGRLineString& line, const VectorFeature& feature);
  /// Records a vertex of a line in the terrain's coordinates whose height seems to be missing.
  void note_missing_height(std::span<const Vec3> line, const VectorFeature& feature);
  void note(Fault fault, const VectorFeature& feature, std::string what);

  const VectorRequest& request_;
  RasterProblems& problems_;
  bool is_drawing_;
  std::unique_ptr<OGRCoordinateTransformation> to_terrain_;  // null if the coordinates are the terrain's
  bool is_geographic_ = false;
  std::string crs_name_, terrain_crs_name_;
  std::uint64_t vertices_ = 0;
  bool has_parts_ = false;
  std::array<Faulty, fault_count> faulty_;
  Faulty missing_heights_;                   // warnings; of the first its place and what speaks against it
  std::optional<HeightFault> height_fault_;  // of the coordinate system, if heights are used
  bool has_heights_ = false;                 // whether any feature has
};

}  // namespace talus
