#pragma once
// What was found in survey data while they were made into a surface, for the user to read.

#include <cstddef>
#include <optional>
#include <string>

#include "talus/meshing/constrained_triangulation.hpp"
#include "talus/meshing/findings.hpp"

namespace talus {

struct SurveyReport {
  // What came in.
  std::size_t points = 0;
  std::size_t lines = 0, line_vertices = 0;
  double grid_step_m = 0;  // to which places on plan were rounded

  // Places that are one.
  std::size_t repeated = 0;  // points and vertices where another lies, on plan
  Findings at_odds;          // places with several heights
  double greatest_odds_m = 0;

  // Single points that stand out from their surroundings.
  std::size_t judged = 0;         // points all round which there are others
  double median_departure_m = 0;  // from the plane through the neighbours
  double greatest_departure_m = 0;
  std::optional<Vec3> greatest_departure_at;
  Findings stand_out;  // that depart far more from that plane than the neighbours do
  Findings removed_spikes;

  ConstraintReport lines_laid;

  // Triangles that were left out.
  std::size_t beyond_boundary = 0;
  std::size_t with_long_sides = 0;
  std::size_t flat_at_rim = 0;

  // The surface.
  std::size_t triangles = 0;
  std::size_t holes = 0;
  double median_side_m = 0, longest_side_m = 0;
  std::optional<Vec3> longest_side_at;  // its middle
  double longest_rim_m = 0;             // of the sides at the rim along which no line runs
  std::optional<Vec3> longest_rim_at;
  Findings slivers;  // triangles with an angle below sliver_angle_deg, on plan
  Findings flat;     // triangles with all three corners on lines at one height
  double flat_area_m2 = 0;

  /// A few lines, without a line feed at the end; those that begin with `warning:` come last.
  [[nodiscard]] std::string text() const;
};

inline constexpr double sliver_angle_deg = 1;

}  // namespace talus
