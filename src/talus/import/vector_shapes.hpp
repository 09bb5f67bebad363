#pragma once
// From OGR's geometries to shapes in the coordinate system of the terrain. For files that are built with GDAL
// only.

#include <ogr_geometry.h>

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {

/// `ogr2ogr options NEW OLD`, NEW being the file's name with another ending, in a form that a shell reads.
[[nodiscard]] std::string ogr2ogr(std::string_view options, const std::filesystem::path& file, std::string_view ending);

/// Takes geometries one by one and remembers what is wrong with them.
class VectorShapes {
 public:
  /// `crs` is that of the file, null where it names none. What is wrong with it is added to `problems`. A drawing is a
  /// DXF.
  VectorShapes(const VectorRequest& request, const OGRSpatialReference* crs, bool is_drawing, RasterProblems& problems);

  /// Adds the parts of a geometry to the feature that has it.
  void add(const OGRGeometry& geometry, VectorFeature& feature);
  /// Adds what was wrong with all of them to `problems`.
  void report();

 private:
  enum Fault : std::size_t { other_kind, open_ring, invalid, not_finite, not_degrees, without_place, fault_count };
  struct Faulty {
    std::uint64_t count = 0;
    std::vector<std::array<std::string, 2>> first;  // which feature, and what it is or has
  };

  void find_transformation(const OGRSpatialReference* crs);
  [[nodiscard]] bool reads(ShapeKind kind) const;
  [[nodiscard]] bool wants(ShapeKind kind, const VectorFeature& feature);
  [[nodiscard]] bool is_valid(const OGRGeometry& geometry, const VectorFeature& feature);
  void add_line(ShapeKind kind, const OGRLineString& line, VectorFeature& feature);
  void add_polygon(const OGRPolygon& polygon, VectorFeature& feature);
  /// Nothing where a vertex has no place, which is then noted.
  [[nodiscard]] std::optional<std::vector<Vec3>> placed(const OGRLineString& line, const VectorFeature& feature);
  void note(Fault fault, const VectorFeature& feature, std::string what);

  const VectorRequest& request_;
  RasterProblems& problems_;
  bool is_drawing_;
  std::unique_ptr<OGRCoordinateTransformation> to_terrain_;  // null where the coordinates are the terrain's own
  bool is_geographic_ = false;
  std::string crs_name_, terrain_crs_name_;
  std::uint64_t vertices_ = 0;
  bool has_parts_ = false;
  std::array<Faulty, fault_count> faulty_;
  std::optional<HeightFault> height_fault_;  // of the coordinate system, if it matters
  bool has_heights_ = false;                 // some feature
};

}  // namespace talus
