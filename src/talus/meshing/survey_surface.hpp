#pragma once
// Builds a surface from the points and lines of a survey.
//
// Every point and every vertex of a line becomes a vertex of the surface, and every piece of a line a side of triangles
// (constrained_triangulation.hpp). Elsewhere the triangulation is Delaunay; where that is not unique, as for points on
// a grid, it follows the heights (survey_diagonals.hpp). Places on plan are rounded to a grid at least as fine as 2^-29
// of the survey's width (triangulation_grid.hpp); heights are kept to the bit.
// - Points at one place are merged and get their mean height, or the mean height of the lines that have a vertex there.
// - Triangles at the rim that are almost a line (an angle above flattest_rim_angle_deg opposite the rim) are left out,
//   unless the rim is a line there. They would be narrow walls where the survey's edge is not quite straight.
// - With a boundary, triangles whose centre is beyond it are left out. With a maximum side length, triangles with a
//   longer side at the rim are left out, from the rim inwards, unless that side is a line.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talus/meshing/plan_polygon.hpp"
#include "talus/meshing/raw_mesh.hpp"
#include "talus/meshing/survey_report.hpp"

namespace talus {

inline constexpr double flattest_rim_angle_deg = 175;

/// A survey must have fewer places: triangles are numbered with 32 bits, and there are about two per place.
inline constexpr std::size_t most_survey_places = std::size_t{1} << 30U;

struct Survey {
  std::vector<Vec3> points;              // global coordinates [m]
  std::vector<std::vector<Vec3>> lines;  // a closed line repeats its first vertex at its end
};

struct SurveyOptions {
  std::string source;                     // the files as the user named them, for messages
  std::vector<PlanPolygon> boundary;      // the surface is within their union; none: the convex hull
  std::optional<double> max_edge_m;       // maximum side length at the rim
  std::optional<double> remove_spikes_m;  // removes points further than this above or below their neighbours' plane
};

struct SurveySurface {
  RawMesh mesh;  // counter-clockwise seen from above
  SurveyReport report;
};

/// Throws BadInput if there is no surface: fewer than three places, all on one line, a survey too wide or too large, or
/// no triangle within the boundary.
[[nodiscard]] SurveySurface surface_of(const Survey& survey, const SurveyOptions& options = {});

}  // namespace talus
