#pragma once
// The files of a survey, read together and brought to one coordinate system.

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
  std::filesystem::path points;             // .csv .xyz .txt .pts .dat: text; .las; any other: a vector file of points
  std::vector<std::int64_t> point_classes;  // of LAS; empty: all but noise
  std::string points_layer;
  std::filesystem::path lines;  // a vector file
  std::string lines_layer;
  std::string
      elevation_attribute;         // of points and lines in vector files: their height [m]; empty: that of the geometry
  std::filesystem::path boundary;  // a vector file of polygons
  std::string boundary_layer;
  ProjectCrs said;
};

struct SurveyFiles {
  Survey survey;
  std::vector<PlanPolygon> boundary;
  std::string crs_wkt;  // of the terrain; empty: not known
  std::string report;   // what each file holds, a line each
};

/// Throws BadInput with what is wrong: files that cannot be read, without heights, in degrees or feet, or that look
/// like degrees and do not say; that are in different coordinate systems which cannot be brought together; that do not
/// lie over each other.
[[nodiscard]] SurveyFiles read_survey(const SurveySources& sources, Problems& warnings);

struct PolygonFile {
  std::vector<SpacePolygon> polygons;
  std::string crs_wkt;  // empty: not known
};

/// Closed lines and polygons with heights, from a vector file. A line is closed where its ends are no further apart
/// than the tolerance. Throws BadInput for features without heights or that are not closed, and as above.
[[nodiscard]] PolygonFile read_polygon_file(const std::filesystem::path& path, const std::string& layer,
                                            const ProjectCrs& said, double tolerance_m, Problems& warnings);

}  // namespace talus
