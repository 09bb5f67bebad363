#pragma once
// A rock in its scene: its state (rock_state.hpp), what it moves through, and what it has computed once for many legs.
// Private to trajectory/.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "talus/barriers/crossing.hpp"
#include "talus/core/tolerances.hpp"
#include "talus/impact/law.hpp"
#include "talus/rocks/arc_length.hpp"
#include "talus/rocks/energy.hpp"
#include "talus/rocks/shape.hpp"
#include "talus/sliding/bend.hpp"
#include "talus/sliding/supports.hpp"
#include "talus/terrain/surface.hpp"
#include "talus/trajectory/kept_outlines.hpp"
#include "talus/trajectory/piece_maxima.hpp"
#include "talus/trajectory/rock_path.hpp"
#include "talus/trajectory/rock_state.hpp"

namespace talus {

/// A sphere that rolls on a plane of this normal can move by `way` from `from`, in any direction, and touch nothing but
/// the plane. If that is not enough, the search is repeated after it has moved by `until`.
struct ClearWay {
  Vec3 normal, from;
  double way = 0, until = 0;  // [m]
};

/// The last valley that a rock was in: the same for many legs.
class KeptValley {
 public:
  /// The reference is valid until another valley is requested.
  [[nodiscard]] const Valley& between(const Vec3& gravity, const Vec3& first, const Vec3& second) {
    if (first != first_ || second != second_) {
      first_ = first;
      second_ = second;
      valley_ = valley_between(gravity, first, second);
    }
    return valley_;
  }

 private:
  Vec3 first_, second_;
  Valley valley_{};
};

template <TerrainSurface Surface>
class MovingRock : public RockState {
 public:
  MovingRock(const Scene<Surface>& scene, const Release& release, const Draws& draws)
      : surface(scene.surface),
        ground(scene.ground),
        barriers(scene.barriers),
        laws(scene.laws),
        impact_law(scene.laws.impact),
        rock(release.rock),
        body(release.shape != nullptr ? std::optional(body_of(*release.shape, release.rock)) : std::nullopt),
        reach(reach_of(scene.laws.model, release.rock)),
        leaving_speed(std::max(laws.normal_velocity_cutoff, std::sqrt(2 * laws.gravity.norm() * contact_slack))),
        has_forest(scene.ground.has_forest()),
        has_bumps(scene.laws.roughness == RoughnessLaw::faces && scene.ground.is_rough()),
        max_height(body ? 0 : reach),
        draws_(draws) {
    motion = release.motion;
  }

  // ---- the scene and the rock ----
  const Surface& surface;
  const Ground& ground;
  const BarrierList barriers;
  const Laws& laws;
  const ImpactLaw impact_law;
  const Rock rock;
  const std::optional<Body> body;  // of a rock with a shape
  const double reach;              // from the centre to the contact: the radius of a sphere, 0 for the lumped mass [m]
  // A rock that leaves an impact with a smaller normal velocity stays on the ground [m/s]. Without a cutoff in the
  // settings, that is a rock that would not rise above the thickness of a facet (contact_slack).
  const double leaving_speed;
  const bool has_forest, has_bumps;
  RockOutcome outcome;
  // So far, of its place above the ground below it; with a shape, of its lowest corner above the ground below that [m].
  double max_height;
  RecentCrossings crossed;
  ClearWay clear;

  /// From the centre to the farthest point of the rock [m].
  [[nodiscard]] double extent() const { return body ? body->reach : reach; }
  [[nodiscard]] bool is_sphere() const { return has_extent(laws.model); }
  [[nodiscard]] double kinetic_energy() const { return talus::kinetic_energy(rock, motion); }
  /// Whether it is caught, and slower than a rock that may stop.
  [[nodiscard]] bool is_wedged() const {
    return progress.is_wedged() && motion.velocity.norm() < laws.stopped_velocity;
  }
  void remember_contact(const Support& with) { last_contact = {motion.position, with}; }
  void advance(const Parabola& path, const LinearDrag& drag, double t) {
    motion.position = path.at(t);
    motion.velocity = drag.velocity(path, t);
    motion.time += drag.time(t);
  }

  // ---- the ground ----
  /// The reference is valid until KeptOutlines::count other outlines have been requested.
  [[nodiscard]] const Outline& outline_of(FacetId facet) { return outlines_.of(surface, facet); }
  [[nodiscard]] MaterialId material_at(FacetId facet) const { return ground.material_of(surface.source(facet)); }
  /// Whether a support is the facet itself, not one of its edges or vertices.
  [[nodiscard]] bool is_facet(const Support& support) const {
    return surface.normal(support.facet).dot(support.normal) > 1 - tolerance::facet_normal;
  }
  /// The reference is valid until another valley is requested.
  [[nodiscard]] const Valley& valley_of(const InValley& sides) {
    return valley_.between(laws.gravity, sides.other.normal, sides.on.normal);
  }
  /// The planes of the facets that a flight begins from.
  [[nodiscard]] SupportPlanes planes_of(const LeftFacets& left) const {
    SupportPlanes planes;
    for (std::uint32_t i = 0; i < left.count; ++i) planes.add(surface.normal(left.facet[i]), left.facet[i]);
    return planes;
  }
  /// Draws the ground's properties for a new contact.
  [[nodiscard]] GroundDraw draw_at(FacetId facet) {
    const MaterialId material = material_at(facet);
    return GroundDraw(draws_, laws.material_sampling, ground[material].ground_of(material), contacts++);
  }
  /// The way along the ground to the next bump, if it stays as it is on this facet [m]; infinite on smooth ground.
  [[nodiscard]] double way_to_bump(FacetId facet) {
    if (!has_bumps) return std::numeric_limits<double>::infinity();
    const double spacing = bump_spacing(facet);
    return std::isfinite(spacing) ? bumps.way(draws_, spacing) : spacing;
  }
  /// The rock has moved this far along the ground of a facet [m].
  void cover(FacetId facet, double way) {
    if (has_bumps) bumps.cover(way, bump_spacing(facet));
  }
  void pass_bump() { bumps.pass(); }
  [[nodiscard]] double tangent_of(double friction_angle) {
    if (friction_angle != angle_) {
      angle_ = friction_angle;
      tangent_ = std::tan(friction_angle);
    }
    return tangent_;
  }
  /// Whether a facet of this normal continues the one that the rock moves along, but for rounding.
  [[nodiscard]] bool is_level(const Vec3& n) const {
    const Vec3& v = motion.velocity;
    return std::abs(v.dot(n)) <= tolerance::level_bend * v.norm() && laws.gravity.dot(n) < 0;
  }
  /// Whether a rock that moves along the ground, or has done so until it took off, meets the next ground at so small an
  /// angle that it moves on along it without an impact.
  [[nodiscard]] bool grazes(const Vec3& n) const {
    const double into = -motion.velocity.dot(n);
    return into >= 0 && into < laws.grazing * motion.velocity.norm() && laws.gravity.dot(n) < 0;
  }
  /// It moves on along ground that it grazes.
  void round_bend(const Vec3& n, const GroundFriction& friction) {
    const Vec3 along = turned_onto(motion.velocity, n);
    const double angle = bend_angle(motion.velocity, n);
    if (is_sphere()) {
      const Turned turned = rolled_round_bend(along, motion.spin, n, angle, rock, friction.sphere);
      motion.velocity = turned.velocity;
      motion.spin = turned.spin;
    } else {
      motion.velocity = std::exp(-friction.mu * angle) * along;
    }
  }
  [[nodiscard]] PathState state_on(const Vec3& normal) const {
    if (!is_sphere()) return PathState::sliding;
    const Vec3 slip = slip_velocity(motion.velocity, motion.spin, normal, rock.radius);
    return slip.norm() < tolerance::shown_as_rolling ? PathState::rolling : PathState::sliding;
  }
  /// How a flight without contact leaves the model. The centre of a block that tips over a rim may come under the
  /// ground there: it has fallen through only if all of it is beneath.
  [[nodiscard]] Exit exit_of(Parabola path) const {
    if (body) path.p += body->reach * unit_z;
    return surface.exit(path);
  }
  /// How a rock in free flight from a place leaves the model, if it does so at once.
  [[nodiscard]] std::optional<Exit> exit_from(const Vec3& position, const Vec3& velocity) const {
    const Exit exit = surface.exit({position, velocity, laws.gravity});
    return exit.t <= tolerance::at_once && !exit.beneath ? std::optional(exit) : std::nullopt;
  }

  /// The friction of the ground that it has left fades for a time in the air [s]: FrictionRise.
  void fade_friction(double time) {
    if (slid > 0) slid *= std::exp(-ground[material_at(last_contact.with.facet)].friction_rise.decay * time);
  }

  // ---- its maxima ----
  void update_max_energy() { outcome.max_kinetic_energy = std::max(outcome.max_kinetic_energy, kinetic_energy()); }
  /// In the first `t` of a leg on a facet or one of its edges or vertices.
  void update_max_height(FacetId facet, const Parabola& leg, double t) {
    if (reach == 0 || body) return;  // the lowest corner of a body on the ground is on it
    max_height = max_height_of_leg(surface, outline_of(facet), leg, t, 0, t, max_height);
  }

 private:
  [[nodiscard]] double bump_spacing(FacetId facet) const { return ground[material_at(facet)].roughness.bump_spacing(); }

  const Draws& draws_;
  double angle_ = 0, tangent_ = 0;  // the last friction angle, which often does not change
  KeptOutlines outlines_;
  KeptValley valley_;
};

[[nodiscard]] inline EndReason reason_of(const Exit& exit) {
  return exit.beneath ? EndReason::lost : exit.in_hole ? EndReason::no_data : EndReason::left_model;
}

/// `phase`: one on the ground.
template <class Surface, class Current>
[[nodiscard]] GroundSoFar ground_so_far(const MovingRock<Surface>& rock, const Current& phase) {
  return {phase.friction, rock.material_at(phase.on.facet)};
}

template <class Surface>
[[nodiscard]] Phase come_to_rest(MovingRock<Surface>& rock) {
  rock.motion.velocity = {};
  if (rock.is_sphere()) rock.motion.spin = {};  // a lumped mass keeps its spin, as in RocFall
  return Ended{EndReason::at_rest};
}

}  // namespace talus
