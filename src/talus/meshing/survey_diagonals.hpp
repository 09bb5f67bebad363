#pragma once
// Chooses the diagonals of squares of points, where the plan positions do not determine them.

#include "talus/meshing/survey_places.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus {

/// Four points are on one circle if the fourth is off the circle through the others by at most this share of its
/// radius.
inline constexpr double cocircular_share = 0.01;

/// Where the corners of two neighbouring triangles lie on one circle, as in a survey on a grid, both diagonals are
/// Delaunay and rounding would decide. Takes the one that a raster with these nodes has (cell_diagonal.hpp); the nodes
/// beside a square are the corners of the next ones, if they continue its sides. Leaves fixed sides, and squares with a
/// vertex of a line: between contours this would make level triangles. Returns the number of flipped sides.
std::size_t choose_diagonals(Triangulation& triangulation, const SurveyPlaces& places);

}  // namespace talus
