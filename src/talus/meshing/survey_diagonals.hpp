#pragma once
// Which way a square of points is cut in two, where their places leave it open.

#include "talus/meshing/survey_places.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus {

/// Four points are on one circle when the fourth lies off that through the others by at most this share of its radius.
inline constexpr double cocircular_share = 0.01;

/// Where the corners of two neighbouring triangles lie on one circle, as those of a survey on a grid do, both cuts are
/// Delaunay, and rounding would choose. Takes the one whose ends differ less in height (after Dyn, Levin and Rippa
/// 1990), which is what a raster has (raster_surface.hpp). Leaves alone what is fixed and where a line has a vertex:
/// between contours it would make level triangles. Returns how many sides it turned.
std::size_t turn_diagonals(Triangulation& triangulation, const SurveyPlaces& places);

}  // namespace talus
