#pragma once
// Which triangles of a survey's triangulation belong to the surface, and the shape of what is left.

#include <cstdint>
#include <vector>

#include "talus/meshing/survey_places.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus {

/// For each triangle whether it stays (survey_surface.hpp says which do); fills what `report` says of others.
[[nodiscard]] std::vector<std::uint8_t> kept_triangles(const Triangulation& triangulation, const ExactGrid& grid,
                                                       const SurveyOptions& options, SurveyReport& report);

/// Fills what `report` says of the longest side at the rim.
void report_rim(const Triangulation& triangulation, const SurveyPlaces& places, const std::vector<std::uint8_t>& kept,
                SurveyReport& report);

/// How many holes the kept triangles have: closed ways along their rim, less one for each piece of the surface.
[[nodiscard]] std::size_t holes_in(const Triangulation& triangulation, const std::vector<std::uint8_t>& kept);

}  // namespace talus
