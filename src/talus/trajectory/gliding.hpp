#pragma once
// Most of a long slide is a glide: many steps on one facet, with nothing near that could end them. The caller of the
// run takes these steps between prepare_glide() and end_glide(), for one rock or for several together.

#include "talus/sliding/glide.hpp"
#include "talus/trajectory/on_facet.hpp"

namespace talus {

/// A glide that starts at the rock's present motion.
struct GlideOnFacet {
  Glide glide;
  Vec3 down, aside;  // unit, on the facet
  FacetId facet;
  double way_to_bump = 0;  // at its start [m]
};

/// The glide from the rock's present motion; nullopt if it cannot glide.
template <class Surface>
[[nodiscard]] std::optional<GlideOnFacet> prepare_glide(MovingRock<Surface>& rock, const OnFacet& phase) {
  const Laws& laws = rock.laws;
  // In a share of the timestep. Legs become longer near the terminal velocity; the steps of a glide stay as they are.
  constexpr double shortest_step = 0.01;
  if (rock.is_sphere() || laws.sliding != SlidingMethod::stepped) return std::nullopt;
  const Footing footing = footing_of(rock, phase);
  const double pull = footing.pull.norm();
  if (pull == 0) return std::nullopt;
  GlideOnFacet on;
  on.down = footing.pull / pull;
  on.aside = phase.on.normal.cross(on.down);
  const Motion& motion = rock.motion;
  const Vec3& start = motion.position;

  Glide& glide = on.glide;
  glide.vx = motion.velocity.dot(on.down);
  glide.vy = motion.velocity.dot(on.aside);
  glide.speed = std::sqrt(glide.vx * glide.vx + glide.vy * glide.vy);
  if (!(glide.speed >= laws.stopped_velocity)) return std::nullopt;
  glide.time = motion.time;
  const double rate = phase.friction.drag, mu = phase.friction.mu;
  glide.timestep = laws.timestep;
  double share = 1;  // of the pull and of friction
  if (rate > 0) {
    const Vec3 net = net_pull(footing, mu * footing.normal_acceleration, motion.velocity);
    glide.timestep = dragged_timestep(rate, laws.timestep, net, motion.velocity);
    if (glide.timestep < shortest_step * laws.timestep) return std::nullopt;
    share = share_with_drag(rate * glide.timestep);
    glide.kept = 1 - share * rate * glide.timestep;
  }
  glide.gain = share * glide.timestep * pull;
  glide.braking = share * glide.timestep * mu * footing.normal_acceleration;
  const double way = free_way(rock.barriers, start, rock.reach);
  glide.squared_way = way * way;
  on.way_to_bump = glide.way_to_bump = rock.way_to_bump(phase.on.facet);
  const Outline& outline = rock.outline_of(phase.on.facet);
  for (std::size_t k = 0; k < static_cast<std::size_t>(outline.edge_count); ++k) {
    const OutlineEdge& edge = outline.edges[k];
    glide.sides[k] = {edge.inward.dot(start - edge.point), edge.inward.dot(on.down), edge.inward.dot(on.aside)};
  }
  on.facet = phase.on.facet;
  return on;
}

template <class Surface, class Sink>
void end_glide(TrackedRock<Surface, Sink>& rock, const GlideOnFacet& on) {
  Motion& motion = rock.motion;
  const Glide& glide = on.glide;
  const Motion before = motion;
  const bool moves = glide.x != 0 || glide.y != 0;
  if (moves) {
    if (std::isfinite(on.way_to_bump)) rock.cover(on.facet, on.way_to_bump - glide.way_to_bump);
    motion.position += glide.x * on.down + glide.y * on.aside;
    motion.velocity = glide.vx * on.down + glide.vy * on.aside;
    motion.time = glide.time;
  }
  const double way = std::sqrt(glide.x * glide.x + glide.y * glide.y);
  rock.tell(event::Glide{before, motion, way, glide.timestep, on.down, on.aside, on.facet});
  if (moves) rock.update_max_energy();
}

}  // namespace talus
