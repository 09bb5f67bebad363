#pragma once
// How far the points of a survey stand above or below their surroundings: a bird, a branch or a slip of the pen does.

#include <cstdint>
#include <optional>
#include <vector>

#include "talus/meshing/survey_places.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus {

struct Departure {
  double height_m = 0;  // of a vertex above the plane through its neighbours
  double spread_m = 0;  // standard deviation of the neighbours from that plane; infinite where three make it
};

/// The plane is that of the least squares, each neighbour weighted by the inverse of its squared distance. Nothing for
/// a vertex at the rim.
[[nodiscard]] std::optional<Departure> departure(const Triangulation& triangulation, const std::vector<double>& heights,
                                                 Triangulation::Vertex vertex);

/// Which points are spikes: those that depart by more than the limit [m] and by more than any of their neighbours does,
/// which a spike draws with it. Vertices of lines are not judged. Ascending.
[[nodiscard]] std::vector<std::uint32_t> spikes(const Triangulation& triangulation, const SurveyPlaces& places,
                                                double limit_m);

/// Fills what `report` says of departures.
void report_departures(const Triangulation& triangulation, const SurveyPlaces& places, SurveyReport& report);

}  // namespace talus
