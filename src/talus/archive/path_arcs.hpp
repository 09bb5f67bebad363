#pragma once
// The points of a path for drawing: its rows, and between two rows of a flight as many as make its arc look like one.

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

/// Calls visit(point) for each row and each point between, in the order of the path.
///
/// A flight leads from a row `projectile` to the next one. Between the two, over a time T, lies the cubic that has both
/// rows' places and velocities (Hermite's): where nothing but gravity acts that is the parabola itself, its velocity
/// the derivative and its kinetic energy that of the velocity. Where trees brake it at a rate k [1/s] it is off by
/// T^4 k^2 a/384 at most (the remainder of Hermite's interpolation), a being the acceleration at its start, and by
/// T^2 j/60 more where the acceleration jumps by j because a forest begins or ends on the way. The flight is cut into
/// equal times, so few that the lines depart from it by `tolerance_m` at most: a chord over the time t departs by
/// a t^2/8. A row that is not a flight is followed by a straight line: rocks slide and roll along facets.
void for_points_along(const Path& path, double tolerance_m, const std::function<void(const PathPoint&)>& visit);

/// Into no more pieces than this is a flight cut, however long it takes.
inline constexpr int most_pieces_of_a_flight = 256;

}  // namespace talus
