#pragma once
// Where the rocks of a model start, without following them.

#include <cstdint>

#include "talus/campaign/model.hpp"

namespace talus {

/// Of some rocks, spread evenly over all. A section whose vertices vary is taken as it is given.
struct ReleaseSurvey {
  std::uint64_t rocks = 0;
  std::uint64_t in_ground = 0;  // were to start in the ground: they are lifted, lowered from a ceiling or caught
  double highest_m = 0;         // the greatest height of a centre above the ground straight below it
  SeederId highest_seeder;      // whose rock that is
};

/// Looks at `most` rocks, or at all where there are fewer.
[[nodiscard]] ReleaseSurvey survey_releases(const Model& model, std::uint64_t most);

}  // namespace talus
