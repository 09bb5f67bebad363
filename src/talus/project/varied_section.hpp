#pragma once
// A section whose vertices are moved at random, from rock to rock: how far, and what of it is certain.

#include <string>

#include "talus/project/project.hpp"

namespace talus::project {

/// How many standard deviations a vertex of a varied section is moved at most, in x and in z.
inline constexpr double most_deviations_of_vertex = 3;

/// What of a section there is ground over for every rock, however its vertices are moved; x in the user's coordinates.
struct CertainStretch {
  double from, to;
};
[[nodiscard]] CertainStretch certain_stretch(const Terrain& terrain);
/// Why a place beyond it is none to stand on, for a problem.
[[nodiscard]] std::string why_uncertain(const CertainStretch& stretch);

}  // namespace talus::project
