#pragma once
// The path of one rock from release to rest: the only place where flight, impact, motion along the ground and barriers
// meet. A path is a pure function of (scene, release, draws).

#include "talus/sampling/draws.hpp"
#include "talus/seeding/release.hpp"
#include "talus/trajectory/rock_log.hpp"
#include "talus/trajectory/scene.hpp"

namespace talus {

/// How a rock's path came out.
struct RockOutcome {
  Motion start, end;
  EndReason reason = EndReason::at_rest;
  std::int64_t events = 0;        // impacts, arrivals at barriers
  double max_kinetic_energy = 0;  // translational and rotational [J]
  double max_bounce = 0;          // greatest height of the centre above the ground below it [m]
};

/// Follows one rock; rows, turns and barrier hits go to the log.
template <class Surface>
[[nodiscard]] RockOutcome follow_rock(const Scene<Surface>& scene, const Release& release, const Draws& draws,
                                      RockLog& log);

}  // namespace talus
