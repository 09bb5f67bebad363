#pragma once
// A section whose vertices are moved at random for each rock: how far, and which part of it always exists.

#include <string>

#include "talus/project/project.hpp"

namespace talus::project {

/// Maximum shift of a vertex of a varied section, in x and in z, in standard deviations.
inline constexpr double most_deviations_of_vertex = 3;

/// The range of x that the section covers for every rock, however its vertices are moved; in the user's coordinates.
struct CertainStretch {
  double from, to;
};
[[nodiscard]] CertainStretch certain_stretch(const SectionTerrain& section);
/// Why a place outside it is refused, for a problem.
[[nodiscard]] std::string why_uncertain(const CertainStretch& stretch);

}  // namespace talus::project
