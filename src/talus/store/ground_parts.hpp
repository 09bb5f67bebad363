#pragma once
// Motion along the ground in few parts. A slide in steps, or a sphere that rolls over a raster, has a leg every
// hundredth of a second; a part of constant acceleration replaces as many of them as it can within a tolerance.

#include <cstddef>
#include <vector>

#include "talus/rocks/motion.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

/// How far a part may be from the motion that it replaces, at the ends of the legs or steps. (Within a step of a slide
/// the run moves a rock straight on with the velocity of the step's end, and changes its velocity evenly: the part's
/// place differs by up to an eighth of the acceleration times the square of the timestep, 0.1 mm at 0.01 s.)
struct StoreTolerance {
  static constexpr double position = 1e-3;  // [m]
  static constexpr double velocity = 1e-4;  // of the largest velocity of the part; and as much of its largest spin
};

/// Times, places, velocities and spins of parts are whole multiples of these (powers of two).
struct StoreStep {
  static constexpr double time = 0x1p-20;      // [s]
  static constexpr double place = 0x1p-20;     // [m]
  static constexpr double velocity = 0x1p-20;  // [m/s]; of spins: of the surface of the sphere of the rock's volume
};

/// A part of constant acceleration between two motions: positions by the parabola that has the right ends and the
/// change of velocity; velocity and spin linear in time.
[[nodiscard]] PathPiece ground_part(const Motion& from, const Motion& to);

/// Motions at the ends of consecutive legs, the first of them the start of the first leg. Appends the places in the
/// list at which parts end, ascending; the last is the last motion. Expects at least two motions, in the order of time.
void divide_into_parts(const std::vector<Motion>& motions, std::vector<std::size_t>& ends);

}  // namespace talus
