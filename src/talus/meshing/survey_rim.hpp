#pragma once
// Which triangles of a survey's triangulation belong to the surface, and the shape of its rim.

#include <cstdint>
#include <vector>

#include "talus/meshing/survey_places.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus {

/// Whether each triangle is kept (survey_surface.hpp has the rules); counts the others in `report`.
[[nodiscard]] std::vector<std::uint8_t> kept_triangles(const Triangulation& triangulation, const ExactGrid& grid,
                                                       const SurveyOptions& options, SurveyReport& report);

/// Fills in the longest side at the rim in `report`.
void report_rim(const Triangulation& triangulation, const SurveyPlaces& places, const std::vector<std::uint8_t>& kept,
                SurveyReport& report);

/// The number of holes in the kept triangles: closed loops of their rim, less one per connected piece.
[[nodiscard]] std::size_t holes_in(const Triangulation& triangulation, const std::vector<std::uint8_t>& kept);

}  // namespace talus
