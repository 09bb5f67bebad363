#pragma once
// The part of RockRun that most of a long slide goes through: many steps on one facet, with nothing near that could
// end them. Included by rock_run.hpp only.

#include "talus/trajectory/rock_run.hpp"

namespace talus {

/// Steps of a stepped slide (sliding/stepped.hpp, the same law in the facet's own two coordinates), as long as each of
/// them stays on the facet and leaves the rock faster than where it may stop. What comes then is the caller's.
template <class Surface>
void RockRun<Surface>::glide(const OnGround& phase, const Footing& footing) {
  const bool is_plain = laws_.model == RockModel::lumped_mass && laws_.sliding == SlidingMethod::stepped &&
                        phase.on_facet && !phase.valley && phase.drag == 0;
  const double pull = footing.pull.norm();
  if (!is_plain || pull == 0) return;
  const Vec3 down = footing.pull / pull, aside = phase.normal.cross(down);
  const Vec3 start = motion_.position;
  struct Side {
    double distance, down, aside;  // of the start from it, and how that grows with the two coordinates
  };
  std::array<Side, 3> sides;
  const Outline& outline = outline_of(phase.facet);
  const auto side_count = static_cast<std::size_t>(outline.edge_count);
  for (std::size_t k = 0; k < side_count; ++k) {
    const OutlineEdge& edge = outline.edges[k];
    sides[k] = {edge.inward.dot(start - edge.point), edge.inward.dot(down), edge.inward.dot(aside)};
  }

  const double dt = laws_.timestep, braking = dt * phase.mu * footing.pressure, gain = dt * pull;
  // Barriers are the caller's, too.
  const double way = free_way(barriers_, start, reach_), squared_way = way * way;
  double x = 0, y = 0;  // way gone down and aside
  double vx = motion_.velocity.dot(down), vy = motion_.velocity.dot(aside);
  double speed = std::sqrt(vx * vx + vy * vy);
  while (speed >= laws_.stopped_velocity && motion_.time + dt < laws_.max_time) {
    const double wx = vx + gain, size = std::sqrt(wx * wx + vy * vy);
    if (wx * vx + vy * vy < braking * speed || size - braking < laws_.stopped_velocity) break;
    const double kept = 1 - braking / size;
    const double next_vx = kept * wx, next_vy = kept * vy, next_x = x + dt * next_vx, next_y = y + dt * next_vy;
    bool stays = true;
    for (std::size_t k = 0; k < side_count; ++k) {
      stays = stays && sides[k].distance + next_x * sides[k].down + next_y * sides[k].aside > contact_slack;
    }
    if (!stays || next_x * next_x + next_y * next_y >= squared_way) break;
    log_.leg({start + x * down + y * aside, next_vx * down + next_vy * aside, Vec3::Zero()}, dt, motion_);
    x = next_x;
    y = next_y;
    vx = next_vx;
    vy = next_vy;
    speed = size - braking;
    motion_.time += dt;
  }
  if (x == 0 && y == 0) return;
  motion_.position = start + x * down + y * aside;
  motion_.velocity = vx * down + vy * aside;
}

}  // namespace talus
