#pragma once
// Triangles from the survey data and closed polylines of a project.

#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/import/survey_crs.hpp"
#include "talus/meshing/raw_mesh.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct SurveyedMesh {
  RawMesh mesh;
  std::string source;   // the file or files, for messages
  std::string crs_wkt;  // empty: unknown
  std::string report;   // what was read and how it was triangulated
};

/// From `points` and `lines`.
[[nodiscard]] SurveyedMesh survey_mesh(const Project& project, Problems& warnings);

/// From `polylines` or `polygons`; not yet merged.
[[nodiscard]] SurveyedMesh polygon_mesh(const Project& project, Problems& warnings);

/// The meaning of `crs`. Throws BadInput if the coordinate system is unknown.
[[nodiscard]] ProjectCrs crs_of_project(const Project& project);

/// The coordinate system that `crs` names, as WKT; empty if it names none. Throws BadInput if it is unknown or not in
/// metres.
[[nodiscard]] std::string crs_wkt_of(const Project& project, Problems& warnings);

}  // namespace talus::project
