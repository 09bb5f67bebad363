#pragma once
// [terrain] of a project: a struct for each kind of terrain, with the settings that it alone has. A project that was
// read has exactly one kind. Paths are as written in the file, relative to the project file.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace talus::project {

/// `section`: a slope in section, in 2D or extruded.
struct SectionTerrain {
  std::vector<std::array<double, 2>> vertices;  // x, z; those of the file, if there is one
  std::filesystem::path file;                   // key `section` too
  std::string layer;
  std::optional<double> tolerance_m;
  std::vector<std::array<double, 2>> std_dev_m;  // of x and z, one pair per vertex, or empty; 2D only
  std::optional<double> width_m;                 // of the extrusion along y; without it the analysis is 2D

  /// Whether it is given from right to left. (The model has it from left to right.)
  [[nodiscard]] bool runs_leftwards() const { return !vertices.empty() && vertices.front()[0] > vertices.back()[0]; }
};

enum class UpAxis { z, y };

/// `mesh`: files of triangles, which together make the terrain.
struct MeshTerrain {
  std::vector<std::filesystem::path> files;
  UpAxis up = UpAxis::z;
};

/// `vertices` and `triangles`: a mesh in the project file.
struct InlineTerrain {
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<std::int64_t, 3>> triangles;
};

/// `raster`: a file of elevations.
struct RasterTerrain {
  std::filesystem::path file;
};

/// `points`, `lines` or both: files of a survey, which is triangulated.
struct SurveyTerrain {
  std::filesystem::path points;
  std::vector<std::int64_t> point_classes;  // of LAS; empty: all but noise
  std::string points_layer;
  std::filesystem::path lines;
  std::string lines_layer;
  std::string elevation_attribute;
  std::filesystem::path boundary;  // empty: the convex hull
  std::string boundary_layer;
  std::optional<double> max_edge_m;
  std::optional<double> remove_spikes_m;
};

/// `polylines`, or `polygons` (a file): closed lines in space, which are triangulated.
struct PolygonTerrain {
  std::vector<std::vector<std::array<double, 3>>> polylines;  // the last vertex is the first
  std::filesystem::path file;
  std::string layer;
};

/// The kind that a project has, of those in its Terrain.
using TerrainKind =
    std::variant<std::reference_wrapper<const SectionTerrain>, std::reference_wrapper<const MeshTerrain>,
                 std::reference_wrapper<const InlineTerrain>, std::reference_wrapper<const RasterTerrain>,
                 std::reference_wrapper<const SurveyTerrain>, std::reference_wrapper<const PolygonTerrain>>;

/// A place for every setting, so that a file with two kinds is read to its end and refused with all its problems.
struct Terrain {
  SectionTerrain section;
  MeshTerrain mesh;
  InlineTerrain inline_mesh;
  RasterTerrain raster;
  SurveyTerrain survey;
  PolygonTerrain polygons;
  double merge_tolerance_m = 0.001;  // of several meshes and of polygons
  std::string crs;                   // by name; "local": without a map; empty: that of the files
  double rotate_deg = 0;
  std::array<double, 3> rotate_about{0, 0, 0};

  /// What the model is built from. Valid as long as the terrain.
  [[nodiscard]] TerrainKind kind() const;
};

}  // namespace talus::project
