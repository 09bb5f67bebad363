#pragma once
// How far the points of a survey are above or below their surroundings: finds birds, branches and typing errors.

#include <cstdint>
#include <optional>
#include <vector>

#include "talus/meshing/survey_places.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus {

struct Departure {
  double height_m = 0;  // of a vertex above the plane through its neighbours
  double spread_m = 0;  // standard deviation of the neighbours from that plane; infinite if there are only three
};

/// The plane is a least-squares fit in which each neighbour is weighted by the inverse of its squared distance. nullopt
/// for a vertex at the rim.
[[nodiscard]] std::optional<Departure> departure(const Triangulation& triangulation, const std::vector<double>& heights,
                                                 Triangulation::Vertex vertex);

/// Points that are spikes: they depart by more than the limit [m] and by more than any neighbour, since a spike makes
/// its neighbours depart, too. Vertices of lines are not checked. Ascending.
[[nodiscard]] std::vector<std::uint32_t> spikes(const Triangulation& triangulation, const SurveyPlaces& places,
                                                double limit_m);

/// Fills in the departures in `report`.
void report_departures(const Triangulation& triangulation, const SurveyPlaces& places, SurveyReport& report);

}  // namespace talus
