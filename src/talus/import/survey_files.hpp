#pragma once
// Reads the files of a survey and transforms them to one coordinate system.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/import/survey_crs.hpp"
#include "talus/meshing/polygon_mesh.hpp"
#include "talus/meshing/survey_surface.hpp"

namespace talus {

struct SurveySources {
  std::filesystem::path points;             // .csv .xyz .txt .pts .dat: text; .las; others: a vector file of points
  std::vector<std::int64_t> point_classes;  // classes of a LAS file to read; empty: all but noise
  std::string points_layer;
  std::filesystem::path lines;  // a vector file
  std::string lines_layer;
  std::string elevation_attribute;  // height of points and lines in vector files [m]; empty: that of the geometry
  std::filesystem::path boundary;   // a vector file of polygons
  std::string boundary_layer;
  ProjectCrs project_crs;
};

/// A line without heights, which lies on the surface of the points.
struct SoftLine {
  std::string name;  // for messages: "feature 3"
  std::vector<Vec3> vertices;
};

struct SurveyFiles {
  Survey survey;
  std::vector<SoftLine> soft_lines;
  std::vector<PlanPolygon> boundary;
  std::string crs_wkt;  // of the terrain; empty: not known
  std::string report;   // what was read from each file, one line each
};

/// Throws BadInput for files that cannot be read, have no heights, are in degrees or feet, or seem to be in degrees
/// without a coordinate system; for coordinate systems between which there is no transformation; and for files that do
/// not overlap.
[[nodiscard]] SurveyFiles read_survey(const SurveySources& sources, Problems& warnings);

struct PolygonFile {
  std::vector<SpacePolygon> polygons;
  std::string crs_wkt;  // empty: not known
};

/// Closed lines and polygons with heights, from a vector file. A line is closed if its ends are no further apart than
/// the tolerance. Throws BadInput for features that are not closed or have no heights, and as read_survey does.
[[nodiscard]] PolygonFile read_polygon_file(const std::filesystem::path& path, const std::string& layer,
                                            const ProjectCrs& project_crs, double tolerance_m, Problems& warnings);

}  // namespace talus
