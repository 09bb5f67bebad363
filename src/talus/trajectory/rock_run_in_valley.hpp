#pragma once
// The part of RockRun in which the rock goes along a valley: the line in which two facets meet, between which gravity
// holds it. Included by rock_run.hpp only.

#include "talus/trajectory/rock_run.hpp"

namespace talus {

/// Where gravity holds the rock between its facet and the one that it has come to.
template <class Surface>
bool RockRun<Surface>::enter_valley(OnGround& phase, FacetId facet, const Vec3& n) {
  const auto valley = caught_between(laws_.gravity, phase.normal, n, motion_.velocity, leaving_speed_);
  if (!valley) return false;
  phase.valley = valley;
  phase.other_normal = std::exchange(phase.normal, n);
  phase.other_facet = std::exchange(phase.facet, facet);
  if (material_at(phase.facet) != material_at(phase.other_facet)) redraw_friction(phase);
  go_along_valley(phase);
  return true;
}

/// What a valley leaves of the rock's motion: the part along it, and of a sphere's spin the part about the axis across
/// it. Slip between them is left to friction.
template <class Surface>
void RockRun<Surface>::go_along_valley(const OnGround& phase) {
  const Vec3& e = phase.valley->direction;
  motion_.velocity = motion_.velocity.dot(e) * e;
  if (laws_.model == RockModel::rigid_sphere) {
    const Vec3 axis = rolling_plane(phase).normal.cross(e);
    motion_.spin = motion_.spin.dot(axis) * axis;
  }
}

/// Of two materials each brakes the rock by what its side carries of it.
template <class Surface>
void RockRun<Surface>::share_friction(OnGround& phase) {
  const MaterialId there = material_at(phase.other_facet);
  if (there == material_at(phase.facet)) return;
  OnGround other;
  const GroundDraw draw = draw_at(phase.other_facet);
  draw_friction(other, draw, ground_[there], draw.restitution(ground_[there])[1]);
  const double share = phase.valley->first_share;
  const auto take = [share](double& own, double others) { own += share * (others - own); };
  take(phase.mu, other.mu);
  take(phase.drag, other.drag);
  take(phase.friction.dynamic, other.friction.dynamic);
  take(phase.friction.rolling, other.friction.rolling);
}

/// The plane on which a sphere rolls or slips. Along a valley it does on both sides at once: as on a plane across the
/// middle of the normals, with the distance of the contacts from the axis as its radius.
template <class Surface>
auto RockRun<Surface>::rolling_plane(const OnGround& phase) const -> RollingPlane {
  if (!phase.valley) return {phase.normal, rock_, phase.friction};
  const Vec3 middle = (phase.normal + *phase.other_normal).normalized();
  const double share = middle.dot(phase.normal);
  Rock rock = rock_;
  rock.radius *= share;
  return {middle, rock, {phase.friction.dynamic, phase.friction.rolling / share}};
}

/// An edge or a vertex holds a sphere against its facet only as long as it touches it.
template <class Surface>
bool RockRun<Surface>::is_held_in_valley(const OnGround& phase) const {
  if (carries(phase.other_facet, *phase.other_normal)) return true;
  constexpr double same = 1e-6;  // cosines less than this below 1, and distances [m]
  bool is_held = false;
  surface_.supports(motion_.position, reach_, same, [&](const Vec3& n, const Vec3&, double, FacetId) {
    is_held = is_held || n.dot(*phase.other_normal) > 1 - same;
  });
  return is_held;
}

/// The rock goes on over its facet alone.
template <class Surface>
void RockRun<Surface>::end_valley(OnGround& phase) {
  phase.valley.reset();
  if (material_at(phase.facet) != material_at(phase.other_facet)) redraw_friction(phase);
}

/// At the end of a valley's facets others may go on, both or one of them.
template <class Surface>
auto RockRun<Surface>::leave_valley(OnGround& phase) -> Phase {
  constexpr double step = 1e-6;  // how far to look ahead [m]
  const Vec3 ahead = motion_.position + step * motion_.velocity.normalized();
  std::optional<FacetId> first, second, rising;
  double first_depth = 0, second_depth = 0, least_parting = std::numeric_limits<double>::infinity();
  surface_.supports(ahead, reach_, 0.1 * step, [&](const Vec3& n, const Vec3&, double, FacetId facet) {
    // Several facets of one plane may touch there: the rock goes on over the one in whose outline it will be.
    const Outline& outline = outline_of(facet);
    double depth = std::numeric_limits<double>::infinity();
    for (int k = 0; k < outline.edge_count; ++k) {
      const OutlineEdge& side = outline.edges[static_cast<std::size_t>(k)];
      depth = std::min(depth, (ahead - side.point).dot(side.inward));
    }
    if (depth < -contact_slack) return;
    const auto choose = [&](std::optional<FacetId>& chosen, double& chosen_depth) {
      if (chosen && depth <= chosen_depth) return;
      chosen = facet;
      chosen_depth = depth;
    };
    if (n.dot(phase.normal) > 1 - same_plane) choose(first, first_depth);
    if (n.dot(*phase.other_normal) > 1 - same_plane) choose(second, second_depth);
    if (const double parting = n.dot(motion_.velocity); parting < least_parting) {
      least_parting = parting;
      rising = facet;
    }
  });
  const auto materials = [&] { return std::pair(material_at(phase.facet), material_at(phase.other_facet)); };
  const auto materials_before = materials();
  if (first && second) {
    phase.facet = *first;
    phase.other_facet = *second;
    phase.on_facet = carries(phase.facet, phase.normal);
    if (phase.on_facet && carries(phase.other_facet, *phase.other_normal)) {
      // The same planes but for rounding, which would add up along the valley.
      const Vec3 n = surface_.normal(*first), m = surface_.normal(*second);
      const auto valley = caught_between(laws_.gravity, m, n, motion_.velocity, leaving_speed_);
      if (valley) {
        phase.valley = valley;
        phase.normal = n;
        phase.other_normal = m;
        go_along_valley(phase);
      }
    }
    if (materials() != materials_before) redraw_friction(phase);
    return Phase::on_ground;
  }
  if (first || second) {
    // The other facet ends here. The sphere touches its end for a moment yet, and must not strike it again at once.
    if (!first) {
      std::swap(phase.normal, *phase.other_normal);
      std::swap(phase.facet, phase.other_facet);
    }
    end_valley(phase);
    const bool is_other_ground = material_at(phase.facet) != material_at(first ? *first : *second);
    phase.facet = first ? *first : *second;
    phase.on_facet = carries(phase.facet, phase.normal);
    if (is_other_ground) redraw_friction(phase);
    return Phase::on_ground;
  }
  if (reach_ == 0 && rising) {
    // Heights that are rounded bend a straight valley at every facet. Whatever lies to the side of the facet that rises
    // most is found when the rock is driven there.
    const Vec3 n = surface_.normal(*rising);
    if (is_level(n, motion_.velocity) || grazes(n, motion_.velocity)) {
      end_valley(phase);
      phase.other_normal.reset();
      go_on_over(phase, *rising, n);
      return Phase::on_ground;
    }
    if (motion_.velocity.dot(n) < 0) {
      remember_strike(phase.normal, phase.facet);
      return strike({0, n, *rising, Feature::facet});
    }
  }
  return take_off(left_behind(phase));
}

}  // namespace talus
