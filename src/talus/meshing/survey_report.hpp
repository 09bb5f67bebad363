#pragma once
// What was found while survey data were made into a surface, as text for the user.

#include <cstddef>
#include <optional>
#include <string>

#include "talus/meshing/constrained_triangulation.hpp"
#include "talus/meshing/findings.hpp"

namespace talus {

struct SurveyReport {
  // Input.
  std::size_t points = 0;
  std::size_t lines = 0, line_vertices = 0;
  double grid_step_m = 0;  // places on plan were rounded to this grid

  // Coincident points.
  std::size_t repeated = 0;  // points and vertices at the same place on plan as another
  Findings at_odds;          // places with several heights
  double largest_difference_m = 0;

  // Points that stand out from their surroundings.
  std::size_t interior_points = 0;  // with neighbours on all sides: only these are checked
  double median_departure_m = 0;    // from the plane through the neighbours
  double largest_departure_m = 0;
  std::optional<Vec3> largest_departure_at;
  Findings outliers;  // points that depart far more from that plane than their neighbours do
  Findings removed_spikes;

  ConstraintReport constraints;

  // Triangles that were left out.
  std::size_t beyond_boundary = 0;
  std::size_t with_long_sides = 0;
  std::size_t flat_at_rim = 0;

  // The surface.
  std::size_t triangles = 0;
  std::size_t holes = 0;
  double median_side_m = 0, longest_side_m = 0;
  std::optional<Vec3> longest_side_at;  // its midpoint
  double longest_rim_m = 0;             // longest side at the rim that is not on a line
  std::optional<Vec3> longest_rim_at;
  Findings slivers;  // triangles with an angle below sliver_angle_deg, on plan
  Findings flat;     // triangles with all three corners on lines at one height
  double flat_area_m2 = 0;

  /// A few lines without a final line feed; those that begin with `warning:` come last.
  [[nodiscard]] std::string text() const;
};

inline constexpr double sliver_angle_deg = 1;

}  // namespace talus
