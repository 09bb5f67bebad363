#pragma once
// One rock on its way, as all states of it see it: the scene, the rock, how it moves, what it has met and what is noted
// of it. What only one state knows stands in that state (states.hpp). Private to trajectory/.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "talus/barriers/crossing.hpp"
#include "talus/core/tolerances.hpp"
#include "talus/impact/law.hpp"
#include "talus/terrain/surface.hpp"
#include "talus/trajectory/kept_outlines.hpp"
#include "talus/trajectory/piece_maxima.hpp"
#include "talus/trajectory/rock_path.hpp"
#include "talus/trajectory/states.hpp"

namespace talus {

/// Whether a rock gets anywhere: where it was for its last contacts and how it spun - friction may yet take that from a
/// sphere that stands -, and how many these were.
class Progress {
 public:
  /// `reach`: a sphere's radius; 0 for a point, whose spin does not count.
  explicit Progress(double reach) : reach_(reach) {}
  /// Noted once a phase, for one contact more, and once a leg, for as many as it lasts hundredths of a second: a small
  /// timestep is no contact.
  void note(const Motion& motion, double contacts = 1) {
    if (!is_same(motion)) {
      place_ = motion.position;
      spin_ = motion.spin;
      contacts_ = 0;
    }
    contacts_ += contacts;
  }
  /// Contact upon contact in the same place.
  [[nodiscard]] bool gets_nowhere(const Motion& motion) const {
    return contacts_ > tolerance::contacts_to_nowhere && is_same(motion);
  }
  /// Caught between what it touches, if it is as good as stopped: every contact has taken of its energy.
  [[nodiscard]] bool is_wedged() const { return contacts_ > tolerance::contacts_to_rest; }

 private:
  [[nodiscard]] bool is_same(const Motion& motion) const {
    return (motion.position - place_).squaredNorm() <= tolerance::same_place * tolerance::same_place &&
           (motion.spin - spin_).norm() * reach_ <= tolerance::same_spin;
  }

  double reach_;
  Vec3 place_ = Vec3::Zero(), spin_ = Vec3::Zero();
  double contacts_ = 0;
};

/// The contact with the ground before the present one.
struct LastContact {
  Vec3 position = Vec3::Constant(std::numeric_limits<double>::infinity());
  Support with{Vec3::Zero(), {}};
};

/// Of the stretch along the ground that lasts until something happens.
struct Stretch {
  bool has_turned = false;  // it stood, and slides back
  double past_edge = 0;     // time spent in a valley that is an edge on one side [s]
};

/// A sphere that rolls on a plane of this normal can go so far from a place, whichever way, and touches nothing but
/// that plane; and until it has gone so far, that is not asked again.
struct ClearWay {
  Vec3 normal = Vec3::Zero(), from = Vec3::Zero();
  double way = 0, until = 0;  // [m]
};

template <TerrainSurface Surface>
class MovingRock {
 public:
  MovingRock(const Scene<Surface>& scene, const Release& release, const Draws& draws, RockLog& rock_log)
      : surface(scene.surface),
        ground(scene.ground),
        barriers(scene.barriers),
        laws(scene.laws),
        impact_law(scene.laws.impact_law()),
        log(rock_log),
        rock(release.rock),
        reach(scene.laws.model == RockModel::rigid_sphere ? release.rock.radius : 0),
        leaving_speed(std::max(laws.normal_velocity_cutoff, std::sqrt(2 * laws.gravity.norm() * contact_slack))),
        has_forest(scene.ground.has_forest()),
        motion(release.motion),
        progress(reach),
        draws_(draws) {}

  // ---- what it is, and where ----
  const Surface& surface;
  const Ground& ground;
  const BarrierList barriers;
  const Laws& laws;
  const ImpactLaw impact_law;
  RockLog& log;
  const Rock rock;
  const double reach;  // from the centre to the contact: the radius of a sphere, 0 for the lumped mass [m]
  // A rock that parts from the ground more slowly stays on it [m/s]: without a cutoff it is one that would not rise by
  // the thickness within which it counts as being on the ground.
  const double leaving_speed;
  const bool has_forest;
  Motion motion;
  RockOutcome outcome;
  RecentCrossings crossed;
  LastContact last_contact;
  Progress progress;
  Stretch stretch;
  ClearWay clear;

  [[nodiscard]] bool is_sphere() const { return laws.model == RockModel::rigid_sphere; }
  [[nodiscard]] double kinetic_energy() const {
    return 0.5 * rock.mass * motion.velocity.squaredNorm() + 0.5 * rock.inertia * motion.spin.squaredNorm();
  }
  /// Whether it is wedged, and as good as stopped.
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
  /// Good until a few others were asked for.
  [[nodiscard]] const Outline& outline_of(FacetId facet) { return outlines_.of(surface, facet); }
  [[nodiscard]] MaterialId material_at(FacetId facet) const { return ground.material_of(surface.source(facet)); }
  /// Whether a support is its facet itself and not one of the facet's edges or vertices.
  [[nodiscard]] bool is_facet(const Support& support) const {
    return surface.normal(support.facet).dot(support.normal) > 1 - tolerance::facet_normal;
  }
  /// The properties of the ground, drawn afresh at every contact.
  [[nodiscard]] GroundDraw draw_at(FacetId facet) {
    return GroundDraw(draws_, laws.material_sampling, material_at(facet), contacts_++);
  }
  [[nodiscard]] std::uint32_t contacts() const { return contacts_; }
  [[nodiscard]] double tangent_of(double friction_angle) {
    if (friction_angle != angle_) {
      angle_ = friction_angle;
      tangent_ = std::tan(friction_angle);
    }
    return tangent_;
  }
  /// Whether it goes on at its velocity over a facet of this normal as if it were the one it is on.
  [[nodiscard]] bool is_level(const Vec3& n) const {
    const Vec3& v = motion.velocity;
    return std::abs(v.dot(n)) <= tolerance::level_bend * v.norm() && laws.gravity.dot(n) < 0;
  }
  /// Whether a rock that slides, or has slid until a moment ago, only grazes a facet, so that it is not struck and
  /// slides on. (CRSP takes a share of the speed along the ground however flat an impact is: over a bend in many facets
  /// a slide would lose all of it. What a sphere loses tends to nothing by its own law.)
  [[nodiscard]] bool grazes(const Vec3& n) const {
    const double into = -motion.velocity.dot(n);
    return !is_sphere() && into >= 0 && into < laws.grazing * motion.velocity.norm() && laws.gravity.dot(n) < 0;
  }
  /// A lumped mass grazes the ground: it keeps nothing of what leads into it, and the impulse of that has its friction.
  void settle_onto(const Vec3& n, double mu) {
    const double into = -motion.velocity.dot(n);
    const Vec3 along = tangential(motion.velocity, n);
    motion.velocity = std::max(0.0, 1 - mu * into / std::max(along.norm(), tolerance::least_speed)) * along;
  }
  [[nodiscard]] PathState state_on(const Vec3& normal) const {
    if (!is_sphere()) return PathState::sliding;
    const Vec3 slip = slip_velocity(motion.velocity, motion.spin, normal, rock.radius);
    return slip.norm() < tolerance::shown_as_rolling ? PathState::rolling : PathState::sliding;
  }
  /// How it leaves the model that goes on in free flight from a place, if it does at once.
  [[nodiscard]] std::optional<Exit> exit_from(const Vec3& position, const Vec3& velocity) const {
    const Exit exit = surface.exit({position, velocity, laws.gravity});
    return exit.t <= tolerance::at_once && !exit.beneath ? std::optional(exit) : std::nullopt;
  }

  // ---- what is noted of it ----
  void note_energy() { outcome.max_kinetic_energy = std::max(outcome.max_kinetic_energy, kinetic_energy()); }
  void note_row(PathState state) { log.row(state, motion); }
  /// An arrival: the moments at which a rock is fastest.
  void arrive(PathState state) {
    ++outcome.events;
    note_energy();
    note_row(state);
  }
  /// A part of a leg that it has gone, coming to `arrived` on a facet, or an edge or a vertex of it.
  void note_leg(FacetId facet, const Parabola& leg, double t, const Motion& before, const Motion& arrived) {
    log.leg(leg, t, before, arrived, facet);
    if (reach == 0) return;
    outcome.max_bounce = max_height_of_leg(surface, outline_of(facet), leg, t, 0, t, outcome.max_bounce);
  }

 private:
  const Draws& draws_;
  std::uint32_t contacts_ = 0;      // how often the ground's properties were drawn
  double angle_ = 0, tangent_ = 0;  // of friction, the last one: often it is the same everywhere
  KeptOutlines outlines_;
};

[[nodiscard]] inline EndReason reason_of(const Exit& exit) {
  return exit.beneath ? EndReason::lost : exit.in_hole ? EndReason::no_data : EndReason::left_model;
}

/// The ground falls away, or ends. The path shows the place: the rock arrives there and leaves in flight.
template <class Surface>
[[nodiscard]] RockState take_off(MovingRock<Surface>& rock, const SupportPlanes& left = {}) {
  rock.arrive(PathState::impact);
  rock.note_row(PathState::projectile);
  return Flying{left};
}

template <class Surface>
[[nodiscard]] RockState come_to_rest(MovingRock<Surface>& rock) {
  rock.motion.velocity.setZero();
  if (rock.is_sphere()) rock.motion.spin.setZero();  // RocFall leaves a lumped mass its spin
  return Ended{EndReason::at_rest};
}

template <class Surface>
[[nodiscard]] RockState leave_over_rim(MovingRock<Surface>& rock, const Exit& exit) {
  rock.arrive(PathState::impact);
  rock.note_row(PathState::projectile);
  return Ended{reason_of(exit)};
}

}  // namespace talus
