#pragma once
// Checks the releases of a model without simulating its rocks.

#include <cstdint>
#include <vector>

#include "talus/campaign/model.hpp"

namespace talus {

/// Of some rocks, evenly spaced among all. A section whose vertices vary is taken as given.
struct ReleaseSurvey {
  std::uint64_t rocks = 0;
  /// The numbers of those placed in the ground: lifted, lowered from a ceiling, or left there without room.
  std::vector<std::uint64_t> in_ground;
  double highest_m = 0;                        // maximum height of a centre above the ground straight below it
  std::uint64_t highest = 0;                   // the number of that rock
  std::vector<std::vector<double>> diameters;  // of equivalent spheres, by seeder [m]
};

/// Checks `most` rocks, or all if there are fewer.
[[nodiscard]] ReleaseSurvey survey_releases(const Model& model, std::uint64_t most);

}  // namespace talus
