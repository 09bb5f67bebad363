#pragma once
// The part of RockRun that most of a long slide goes through: many steps on one facet, with nothing near that could
// end them. Between prepare_glide() and end_glide() whoever drives the run takes the steps, alone or with other rocks'.
// Included by rock_run.hpp only.

#include "talus/trajectory/rock_run.hpp"

namespace talus {

/// Whether there are steps to be taken that way.
template <class Surface>
bool RockRun<Surface>::prepare_glide(const OnGround& phase) {
  const bool is_plain = laws_.model == RockModel::lumped_mass && laws_.sliding == SlidingMethod::stepped &&
                        phase.on_facet && !phase.valley && phase.drag == 0;
  if (!is_plain) return false;
  const Footing footing = this->footing(phase);
  const double pull = footing.pull.norm();
  if (pull == 0) return false;
  down_ = footing.pull / pull;
  aside_ = phase.normal.cross(down_);
  const Vec3& start = motion_.position;

  glide_ = {};
  glide_.vx = motion_.velocity.dot(down_);
  glide_.vy = motion_.velocity.dot(aside_);
  glide_.speed = std::sqrt(glide_.vx * glide_.vx + glide_.vy * glide_.vy);
  glide_.time = motion_.time;
  glide_.gain = laws_.timestep * pull;
  glide_.braking = laws_.timestep * phase.mu * footing.pressure;
  const double way = free_way(barriers_, start, reach_);  // barriers are the caller's, too
  glide_.squared_way = way * way;
  const Outline& outline = outline_of(phase.facet);
  for (std::size_t k = 0; k < static_cast<std::size_t>(outline.edge_count); ++k) {
    const OutlineEdge& edge = outline.edges[k];
    glide_.sides[k] = {edge.inward.dot(start - edge.point), edge.inward.dot(down_), edge.inward.dot(aside_)};
  }
  first_step_ = log_.glide_steps.size();
  return true;
}

template <class Surface>
void RockRun<Surface>::end_glide() {
  log_.glide(motion_, first_step_, laws_.timestep, down_, aside_);
  if (glide_.x == 0 && glide_.y == 0) return;
  motion_.position += glide_.x * down_ + glide_.y * aside_;
  motion_.velocity = glide_.vx * down_ + glide_.vy * aside_;
  motion_.time = glide_.time;
  note_energy();
}

}  // namespace talus
