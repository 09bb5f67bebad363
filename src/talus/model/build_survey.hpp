#pragma once
// Triangles from the survey data and closed polylines of a project.

#include <cstdint>
#include <string>

#include "talus/core/problems.hpp"
#include "talus/import/survey_crs.hpp"
#include "talus/meshing/raw_mesh.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// The triangles of a terrain, not yet rotated and cleaned.
struct GivenMesh {
  RawMesh mesh;
  std::string source;                    // the file or files, for messages
  std::string crs_wkt;                   // empty: unknown
  std::string report;                    // what was read and how it was triangulated
  double weld_tolerance_m = 0;           // 0: only equal vertices are merged
  std::uint32_t triangles_per_part = 1;  // 2 for the segments of an extruded section
  bool is_of_mesh_files = false;         // so that another axis may point up
};

[[nodiscard]] GivenMesh survey_mesh(const SurveyTerrain& survey, const Project& project, Problems& warnings);
[[nodiscard]] GivenMesh polygon_mesh(const PolygonTerrain& polygons, const Project& project, Problems& warnings);

/// Triangles that the project file gives itself, in the coordinate system that it names.
[[nodiscard]] GivenMesh own_mesh(const Project& project, Problems& warnings);

/// The meaning of `crs`. Throws BadInput if the coordinate system is unknown.
[[nodiscard]] ProjectCrs crs_of_project(const Project& project);

/// The coordinate system that `crs` names, as WKT; empty if it names none. Throws BadInput if it is unknown or not in
/// metres.
[[nodiscard]] std::string crs_wkt_of(const Project& project, Problems& warnings);

}  // namespace talus::project
