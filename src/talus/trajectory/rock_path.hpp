#pragma once
// The trajectory of one rock from release to rest: the only room in which flight, impact, motion along the ground and
// barriers meet. A trajectory is a pure function of (scene, release, draws).

#include <optional>

#include "talus/ground/material.hpp"
#include "talus/sampling/draws.hpp"
#include "talus/seeding/release.hpp"
#include "talus/trajectory/rock_log.hpp"
#include "talus/trajectory/scene.hpp"

namespace talus {

/// What a trajectory comes to.
struct RockOutcome {
  Motion start, end;
  EndReason reason = EndReason::at_rest;
  std::int64_t events = 0;        // impacts, arrivals at barriers, take-offs where the ground falls away or ends
  double max_kinetic_energy = 0;  // translational and rotational [J]
  double max_bounce = 0;          // maximum bounce height (rocks/heights.hpp) [m]
  /// Of the ground straight below its centre at the end. Empty: it left the model, or there is none.
  std::optional<MaterialId> ground;
};

/// Simulates one rock. Its rows, turns, barrier hits and, on request, the pieces of its path are written to the log.
template <class Surface>
[[nodiscard]] RockOutcome follow_rock(const Scene<Surface>& scene, const Release& release, const Draws& draws,
                                      RockLog& log);

}  // namespace talus
