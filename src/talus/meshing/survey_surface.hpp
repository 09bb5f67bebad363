#pragma once
// From points and lines of a survey to a surface over the plan.
//
// Every point and every vertex of a line becomes a vertex of the surface, every piece of a line a side of triangles
// (constrained_triangulation.hpp); elsewhere the triangles are Delaunay's, and where those are not unique, as between
// points on a grid, follow the heights (survey_diagonals.hpp). Places on plan are rounded to a grid that is at least as
// fine as 2^-29 of the survey's width (triangulation_grid.hpp), heights are kept to the bit.
// - Of points at one place one is kept, with their mean height; where lines pass through it, with that of the lines.
// - Triangles at the rim that are almost a line are left out (an angle above flattest_rim_angle_deg opposite the rim;
//   they would be walls a hand wide where the survey's edge is not quite straight), unless the rim is a line there.
// - With a boundary, triangles whose middle lies beyond it are left out; with a longest side, triangles at the rim
//   whose side there is longer, from the rim inwards, unless it is a line.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talus/meshing/plan_polygon.hpp"
#include "talus/meshing/raw_mesh.hpp"
#include "talus/meshing/survey_report.hpp"

namespace talus {

inline constexpr double flattest_rim_angle_deg = 175;

/// What a surface can be made of, at most: triangles are counted with 32 bits, two for each place.
inline constexpr std::size_t most_survey_places = std::size_t{1} << 30U;

struct Survey {
  std::vector<Vec3> points;              // global coordinates [m]
  std::vector<std::vector<Vec3>> lines;  // a closed one repeats its first vertex at its end
};

struct SurveyOptions {
  std::string source;                     // the files as the user named them, for messages
  std::vector<PlanPolygon> boundary;      // what lies in one of them is within; none: the convex hull
  std::optional<double> max_edge_m;       // of triangles at the rim
  std::optional<double> remove_spikes_m;  // points further than this above or below the plane of their neighbours go
};

struct SurveySurface {
  RawMesh mesh;  // counter-clockwise seen from above
  SurveyReport report;
};

/// Throws BadInput where there is no surface: fewer than three places, all on one line, a survey too wide or too large,
/// or nothing left within the boundary.
[[nodiscard]] SurveySurface surface_of(const Survey& survey, const SurveyOptions& options = {});

}  // namespace talus
