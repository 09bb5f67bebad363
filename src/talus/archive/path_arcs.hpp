#pragma once
// The points of a path for drawing: its rows, and enough points between the rows of a flight to draw its arc.

#include <array>
#include <functional>

#include "talus/archive/run_folder.hpp"

namespace talus {

struct PathPoint {
  double time_s = 0;
  std::array<double, 3> position_m{}, velocity_m_s{};
  double ke_total_J = 0;  // translational and rotational
  PathState state = PathState::projectile;
};

/// Calls visit(point) for each row and each point between rows, in the order of the path.
///
/// A flight leads from a row `projectile` to the next one. Between the two, over a time T, is the cubic with the
/// positions and velocities of both rows (Hermite's). With gravity alone it is the parabola itself; its velocity is the
/// derivative, and its kinetic energy that of the velocity. If trees slow the rock at a rate k [1/s], the cubic is off
/// by at most T^4 k^2 a/384 (the remainder of Hermite's interpolation), a being the acceleration at its start, and by
/// T^2 j/60 more if the acceleration jumps by j because a forest begins or ends on the way. The flight is divided into
/// the fewest equal times for which the lines are within `tolerance_m` of it: over a time t a chord is off by a t^2/8.
/// Any other row is followed by a straight line: rocks slide and roll along facets.
void for_points_along(const Path& path, double tolerance_m, const std::function<void(const PathPoint&)>& visit);

/// The largest number of pieces of a flight, however long it takes.
inline constexpr int most_pieces_of_a_flight = 256;

}  // namespace talus
