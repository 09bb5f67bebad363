#pragma once
// One rock's run, phase by phase; private to trajectory/. It flies until it meets the ground, a barrier or the model's
// edge (fly), strikes the ground (strike) and flies again or stays on it (move_along), to rest or where ground falls
// away.

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "talus/barriers/crossing.hpp"
#include "talus/core/stop.hpp"
#include "talus/flight/touch.hpp"
#include "talus/impact/crsp.hpp"
#include "talus/impact/plain.hpp"
#include "talus/impact/rigid_sphere.hpp"
#include "talus/impact/roughness.hpp"
#include "talus/sliding/closed_form.hpp"
#include "talus/sliding/drag.hpp"
#include "talus/sliding/glide.hpp"
#include "talus/sliding/rolling.hpp"
#include "talus/sliding/stepped.hpp"
#include "talus/sliding/supports.hpp"
#include "talus/terrain/contact.hpp"
#include "talus/trajectory/kept_outlines.hpp"
#include "talus/trajectory/piece_maxima.hpp"
#include "talus/trajectory/rock_path.hpp"

namespace talus {

class Profile;
class RasterSurface;
class TriangleMesh;

/// One rock on its way. It can be left where it glides and taken up again: glides of several rocks are done together.
template <class Surface>
class RockRun {
 public:
  RockRun(const Scene<Surface>& scene, const Release& release, const Draws& draws, RockLog& log)
      : surface_(scene.surface),
        ground_(scene.ground),
        barriers_(scene.barriers),
        laws_(scene.laws),
        draws_(draws),
        log_(log),
        rock_(release.rock),
        motion_(release.motion),
        reach_(scene.laws.model == RockModel::rigid_sphere ? release.rock.radius : 0),
        leaving_speed_(std::max(laws_.normal_velocity_cutoff, std::sqrt(2 * laws_.gravity.norm() * contact_slack))),
        has_forest_(scene.ground.has_forest()),
        has_room_(release.has_room) {}

  /// What a run has come to.
  enum class Pause {
    glides,  // along a facet; to go on, the steps of glide() are to be taken
    ended,
    stopped  // on request, on its way: it has no end, and is not to be gone on with
  };
  /// Follows the rock until it glides or ends, or until it is to stop; null: nobody asks for that.
  Pause go_on(const StopScope* stop = nullptr);
  [[nodiscard]] Glide& glide() { return glide_; }
  /// Takes one of its steps; whether there was one to take.
  bool step_alone() {
    if (!try_step(glide_laws(laws_), glide_)) return false;
    if (log_.keeps_pieces()) log_.glide_steps.push_back({glide_.x, glide_.y, glide_.vx, glide_.vy});
    return true;
  }
  /// Where the steps of the glide are wanted, the list for them.
  [[nodiscard]] std::vector<GlideStep>* glide_trace() { return log_.keeps_pieces() ? &log_.glide_steps : nullptr; }
  [[nodiscard]] static GlideLaws glide_laws(const Laws& laws) {
    return {laws.timestep, laws.stopped_velocity, laws.max_time};
  }
  /// From release to rest, alone.
  RockOutcome follow();
  /// Of a rock that has come to its end.
  [[nodiscard]] const RockOutcome& outcome() const { return outcome_; }

 private:
  /// What the rock is doing; `left_` or `on_ground_` belongs to it.
  enum class Phase { flies, on_ground, ended };
  /// What comes after a phase, or that the rock goes on in the one that it is in.
  using Next = std::optional<Phase>;
  /// In contact with the ground, the lumped mass sliding, the rigid sphere rolling or slipping.
  struct OnGround {
    Vec3 normal;               // out of the ground, or of the edge or vertex that carries a sphere
    FacetId facet;             // the facet it is on, or one of those at the edge or vertex
    bool on_facet = true;      // otherwise on an edge or a vertex
    double mu = 0;             // tan(phi), lumped mass
    ContactFriction friction;  // rigid sphere
    double drag = 0;           // of soft ground and of trees, over mass and velocity [1/s]
    // In a valley of the second support; otherwise of a facet that the rock touches yet but has left.
    std::optional<Vec3> other_normal;
    bool is_guided = false;  // the next leg goes along both facets
    FacetId other_facet;
    std::optional<Valley> valley;
  };
  /// How a flight ends: on the ground, at the edge of the model, or - where it has neither - only in time.
  struct FlightEnd {
    double t;  // [s]
    std::optional<Contact> contact;
    std::optional<Exit> exit;
    // How high above the ground the rock has been when it ends, in this flight or before [m]; known only where the
    // search for the contact came by it.
    std::optional<double> greatest_height = {};
  };

  Phase fly();
  [[nodiscard]] FlightEnd end_of_flight(const Parabola& path, double t_max, const LeftPlanes& left) const;
  [[nodiscard]] FlightEnd first_contact(const Parabola& path, double t_max, const LeftPlanes& left) const;
  Next fly_along(const Parabola& path, const LinearDrag& drag, const FlightEnd& flight_end);
  Phase fly_where_forests_are();
  Next fly_to_the_trees();
  Next fly_among_trees(double rate);
  [[nodiscard]] double forest_drag_at(const Vec3& place) const;
  [[nodiscard]] double forest_step_time(const Vec3& velocity) const;
  [[nodiscard]] double forest_border_between(const Parabola& path, double from, double to, double rate) const;
  Phase strike(const Contact& contact);
  void begin(Phase phase);
  void take_leg();
  [[nodiscard]] Phase end(EndReason reason) {
    outcome_.reason = reason;
    return Phase::ended;
  }
  [[nodiscard]] Phase fly_off(const LeftPlanes& left = {}) {
    left_ = left;
    hops_ = left.count > 0;
    return Phase::flies;
  }
  [[nodiscard]] Phase come_to_rest() {
    motion_.velocity.setZero();
    if (laws_.model == RockModel::rigid_sphere) motion_.spin.setZero();  // RocFall leaves a lumped mass its spin
    return end(EndReason::at_rest);
  }
  Next move_along(OnGround& phase);
  bool prepare_glide(const OnGround& phase);
  void end_glide();
  Phase enter_ground(const Contact& contact, const GroundDraw& draw, const Material& material, double rt);
  /// How a rock goes on from a barrier.
  enum class AtBarrier { untouched, held, goes_on };
  [[nodiscard]] std::optional<Crossing> next_crossing(const Parabola& path, double t_max);
  /// `pull` is what draws the rock along its way [m/s2]; `phase` is given where it moves along the ground.
  AtBarrier meet_barrier(const Crossing& crossing, double noted_time, const Vec3& pull,
                         const OnGround* phase = nullptr);
  [[nodiscard]] std::optional<Vec3> thrown_back(const Crossing& crossing, const Vec3& velocity, const Vec3& pull,
                                                const OnGround* phase) const;
  /// Where it goes on at `velocity`.
  void note_passage(const Crossing& crossing, double time, const Vec3& velocity) {
    constexpr double none = 1e-3;  // [m/s]
    crossed_.note_passage(crossing, time, time + 4 * reach_ / std::max(velocity.norm(), none));
  }
  void take_back_passage(BarrierId barrier);
  void pass_above(const Crossing& crossing, const Motion& there);

  [[nodiscard]] Leg next_leg(const OnGround& phase, const Footing& footing) const;
  [[nodiscard]] Leg undragged_leg(const OnGround& phase, const Footing& footing, double timestep) const;
  [[nodiscard]] bool rests(const OnGround& phase, const Footing& footing) const;
  [[nodiscard]] Footing footing(const OnGround& phase);
  [[nodiscard]] static bool is_on_edge(const OnGround& phase) { return !phase.on_facet && !phase.valley; }
  [[nodiscard]] Vec3 edge_under(FacetId facet, const Vec3& normal);
  [[nodiscard]] double pressure_on_edge(FacetId facet, const Vec3& normal);
  [[nodiscard]] double longest_leg(const OnGround& phase, const Footing& footing) const;
  bool settle_over_edge(OnGround& phase);
  /// How long it takes at the least to go a way [m] at a speed that grows by no more than `acceleration` [s].
  [[nodiscard]] static double time_for_way(double way, double speed, double acceleration) {
    return 2 * way / (speed + std::sqrt(speed * speed + 2 * acceleration * way));
  }
  [[nodiscard]] LeftPlanes carrying(const OnGround& phase);
  [[nodiscard]] LeftPlanes left_behind(const OnGround& phase) const;
  struct RollingPlane {
    Vec3 normal;
    Rock rock;
    ContactFriction friction;
  };
  [[nodiscard]] RollingPlane rolling_plane(const OnGround& phase) const;
  /// What the ground leaves of a velocity, while it carries the rock.
  [[nodiscard]] Vec3 kept_on_ground(const OnGround& phase, const Vec3& velocity) const {
    return phase.valley ? Vec3(velocity.dot(phase.valley->direction) * phase.valley->direction)
                        : tangential(velocity, phase.normal);
  }
  bool enter_valley(OnGround& phase, FacetId facet, const Vec3& n);
  void go_along_valley(const OnGround& phase);
  [[nodiscard]] bool is_held_in_valley(const OnGround& phase) const;
  void end_valley(OnGround& phase);
  struct Rim {
    double t;
    Exit exit;
  };
  [[nodiscard]] std::optional<Rim> rim_ahead(const Parabola& leg, double t) const;
  [[nodiscard]] std::optional<Exit> exit_here(const Vec3& position, const Vec3& velocity) const;
  Phase leave_over_rim(const Exit& exit);
  Phase leave_facet(OnGround& phase, const OutlineEdge& edge);
  void go_on_over(OnGround& phase, FacetId facet, const Vec3& n);
  [[nodiscard]] bool is_where_it_was() const {
    constexpr double nowhere = 1e-3;  // [m]
    return (motion_.position - wedge_).squaredNorm() <= nowhere * nowhere;
  }
  /// Notes where the rock is; asked once a phase, for one contact more, and once a leg, for as many as it lasts
  /// hundredths of a second: a small timestep is no contact.
  void note_progress(double contacts = 1) {
    if (!is_where_it_was()) {
      wedge_ = motion_.position;
      contacts_in_wedge_ = 0;
    }
    contacts_in_wedge_ += contacts;
  }
  /// Contact upon contact in the same place. (Forty: a bouncing rock has moved on by then, restitution of 0.9 leaves it
  /// a hundredth of its speed; and the usual limit of steps has forty 250 times.)
  [[nodiscard]] bool gets_nowhere() const { return contacts_in_wedge_ > 40 && is_where_it_was(); }
  /// The rock is caught between what it touches and as good as stopped: every contact has taken of its energy, and five
  /// times forty of them have let it go nowhere.
  [[nodiscard]] bool is_wedged() const {
    return contacts_in_wedge_ > 200 && motion_.velocity.norm() < laws_.stopped_velocity;
  }
  void remember_strike(const Vec3& normal, FacetId facet) {
    last_strike_ = motion_.position;
    last_normal_ = normal;
    last_facet_ = facet;
  }
  std::optional<OutlineEdge> side_crossed(const OnGround& phase, FacetId facet, const Parabola& leg, double& t,
                                          double from = 0);
  [[nodiscard]] const Outline& outline_of(FacetId facet) { return outlines_.of(surface_, facet); }
  std::optional<OutlineEdge> edge_ahead(OnGround& phase, const Parabola& leg, double& t);
  [[nodiscard]] bool is_level(const Vec3& n, const Vec3& velocity) const;
  [[nodiscard]] bool grazes(const Vec3& n, const Vec3& velocity) const;
  void settle_onto(const Vec3& n, double mu);
  /// Whether a support of this normal is the facet itself and not one of its edges or vertices.
  [[nodiscard]] bool carries(FacetId facet, const Vec3& normal) const {
    return surface_.normal(facet).dot(normal) > 1 - 1e-9;
  }
  [[nodiscard]] MaterialId material_at(FacetId facet) const { return ground_.material_of(surface_.source(facet)); }
  void advance_along(const Leg& leg, double t);
  Phase leave_valley(OnGround& phase);
  Phase take_off(const LeftPlanes& left = {});
  void stand_on(const OnGround& phase);
  void draw_friction(OnGround& phase, const GroundDraw& draw, const Material& material, double rt);
  void redraw_friction(OnGround& phase);
  void share_friction(OnGround& phase);

  [[nodiscard]] GroundDraw draw_at(FacetId facet) {
    return GroundDraw(draws_, laws_.material_sampling, material_at(facet), contacts_++);
  }
  [[nodiscard]] PathState contact_state(const Vec3& normal) const;
  [[nodiscard]] static EndReason reason_of(const Exit& exit) {
    return exit.beneath ? EndReason::lost : exit.in_hole ? EndReason::no_data : EndReason::left_model;
  }
  [[nodiscard]] double kinetic_energy() const {
    return 0.5 * rock_.mass * motion_.velocity.squaredNorm() + 0.5 * rock_.inertia * motion_.spin.squaredNorm();
  }
  void advance(const Parabola& path, const LinearDrag& drag, double t) {
    motion_.position = path.at(t);
    motion_.velocity = drag.velocity(path, t);
    motion_.time += drag.time(t);
  }
  /// Notes an arrival: the moments at which a rock is fastest.
  void arrive(PathState state) {
    ++outcome_.events;
    note_energy();
    log_.row(state, motion_);
  }
  void note_energy() { outcome_.max_kinetic_energy = std::max(outcome_.max_kinetic_energy, kinetic_energy()); }
  /// A part of a leg that it has gone, coming to `arrived`.
  void note_leg(const Parabola& leg, double t, const Motion& before, const Motion& arrived) {
    log_.leg(leg, t, before, arrived);
    if (reach_ > 0) outcome_.max_bounce = greatest_height_of_leg(surface_, leg, t, 0, t, outcome_.max_bounce);
  }

  const Surface& surface_;
  const Ground& ground_;
  BarrierList barriers_;
  const Laws& laws_;
  const Draws& draws_;
  RockLog& log_;
  const Rock rock_;
  Motion motion_;
  const double reach_;  // from the centre to the contact: the radius of a sphere, 0 for the lumped mass
  // A rock that parts from the ground more slowly stays on it [m/s]: without a cutoff it is one that would not rise by
  // the thickness within which it counts as being on the ground.
  const double leaving_speed_;
  const bool has_forest_, has_room_;

  RockOutcome outcome_;
  Phase phase_ = Phase::flies;
  LeftPlanes left_;     // where it flies: what it has just slid off
  OnGround on_ground_;  // where it is
  bool hops_ = false;   // it slid until it flew
  bool has_begun_ = false;
  std::int64_t steps_ = 0;       // phases so far, and a part of the legs
  std::int64_t short_legs_ = 0;  // so far
  // Of the stretch along the ground that lasts as long as the phase.
  struct Stretch {
    bool has_turned = false;
    double past_edge = 0;  // time spent in a valley that is an edge on one side [s]
  };
  Stretch stretch_;
  // A glide under way, from where the motion is.
  bool is_gliding_ = false;
  Glide glide_;
  Vec3 down_, aside_;
  std::size_t first_step_ = 0;  // in the log

  double angle_ = 0, tangent_ = 0;  // of friction, the last one drawn: often it is the same everywhere
  std::uint32_t contacts_ = 0;      // how often the ground's properties were drawn
  RecentCrossings crossed_;
  Vec3 last_strike_ = Vec3::Constant(std::numeric_limits<double>::infinity());  // where it struck the ground last
  Vec3 last_normal_ = Vec3::Zero();
  FacetId last_facet_;
  Vec3 wedge_ = Vec3::Zero();  // where it has been for the last contacts
  double contacts_in_wedge_ = 0;
  KeptOutlines outlines_;
};

template <class Surface>
RockOutcome RockRun<Surface>::follow() {
  while (go_on() == Pause::glides) {
    while (step_alone()) {
    }
  }
  return outcome_;
}

/// What a phase is checked for before anything happens in it.
template <class Surface>
void RockRun<Surface>::begin(Phase phase) {
  phase_ = phase;
  stretch_ = {};
  if (phase_ == Phase::ended) return;
  if (steps_++ >= laws_.max_steps) {
    phase_ = end(EndReason::maximum_steps);
  } else if (note_progress(); is_wedged()) {
    phase_ = come_to_rest();
  }
}

/// One leg. Legs that last as long as their timestep are limited by the time that a rock may take; of shorter ones a
/// hundred count as a step, so that what takes no time has an end as well.
template <class Surface>
void RockRun<Surface>::take_leg() {
  constexpr std::int64_t legs_a_step = 100;
  const double start = motion_.time;
  const Next next = move_along(on_ground_);
  if (next) {
    begin(*next);
  } else if (motion_.time - start < 0.5 * laws_.timestep && ++short_legs_ % legs_a_step == 0 &&
             steps_++ >= laws_.max_steps) {
    phase_ = end(EndReason::maximum_steps);
  }
}

template <class Surface>
auto RockRun<Surface>::go_on(const StopScope* stop) -> Pause {
  if (!std::exchange(has_begun_, true)) {
    outcome_.start = motion_;
    outcome_.max_kinetic_energy = kinetic_energy();
    log_.row(PathState::projectile, motion_);
    begin(has_room_ ? Phase::flies : end(EndReason::at_rest));
  } else if (std::exchange(is_gliding_, false)) {
    end_glide();
    take_leg();
  }
  constexpr unsigned often = 64;  // legs and flights between two looks: well below a millisecond
  for (unsigned passages = 1; phase_ != Phase::ended; ++passages) {
    if (passages % often == 0 && stop != nullptr && stop->is_asked()) return Pause::stopped;
    if (phase_ == Phase::flies) {
      begin(fly());
    } else if (prepare_glide(on_ground_)) {
      is_gliding_ = true;
      return Pause::glides;
    } else {
      take_leg();
    }
  }
  note_energy();
  outcome_.end = motion_;
  log_.row(PathState::ended, motion_);
  return Pause::ended;
}

template <class Surface>
auto RockRun<Surface>::fly() -> Phase {
  if (has_forest_) return fly_where_forests_are();
  const Parabola path{motion_.position, motion_.velocity, laws_.gravity};
  const Next next = fly_along(path, {}, end_of_flight(path, laws_.max_time - motion_.time, left_));
  return next ? *next : end(EndReason::maximum_time);
}

/// With a contact, or as long as asked.
template <class Surface>
auto RockRun<Surface>::first_contact(const Parabola& path, double t_max, const LeftPlanes& left) const -> FlightEnd {
  if constexpr (std::is_same_v<Surface, RasterSurface>) {
    const auto [contact, greatest_height] = surface_.flight(path, reach_, t_max, left, outcome_.max_bounce);
    if (contact) return {contact->t, contact, {}, greatest_height};
    return {t_max, {}, {}};
  }
  const auto contact = surface_.first_contact(path, reach_, t_max, left);
  return {contact ? contact->t : t_max, contact, {}};
}

template <class Surface>
auto RockRun<Surface>::end_of_flight(const Parabola& path, double t_max, const LeftPlanes& left) const -> FlightEnd {
  const FlightEnd end = first_contact(path, t_max, left);
  if (end.contact) {
    // A sphere may touch the rim once more when its centre has left already.
    const Vec3 there = path.at(end.t);
    if (reach_ == 0 || surface_.elevation(there.x(), there.y(), there.z())) return end;
    const Exit before = surface_.exit(path);
    return before.t < end.t && !before.beneath ? FlightEnd{before.t, {}, before} : end;
  }
  const Exit edge = surface_.exit(path);
  return edge.t < t_max ? FlightEnd{edge.t, {}, edge} : end;
}

/// Flies to the end, or to what a barrier makes of it before; nothing where the rock is still flying then.
template <class Surface>
auto RockRun<Surface>::fly_along(const Parabola& path, const LinearDrag& drag, const FlightEnd& flight_end) -> Next {
  const double start = motion_.time;
  // Barriers know the parabola's own clock.
  const auto retime = [&] {
    if (drag.rate > 0) crossed_.retime(start, [&](double t) { return drag.time(t); });
  };
  while (const auto crossing = next_crossing(path, flight_end.t)) {
    const Motion before = motion_;
    advance(path, drag, crossing->t);
    if (crossing->above) {
      pass_above(*crossing, std::exchange(motion_, before));
      continue;
    }
    const AtBarrier then = meet_barrier(*crossing, start + crossing->t, laws_.gravity);
    if (then == AtBarrier::untouched) {
      motion_ = before;
      continue;
    }
    retime();
    log_.flight(path, crossing->t, before, drag);
    outcome_.max_bounce = greatest_height_of_flight(surface_, path, 0, crossing->t, outcome_.max_bounce);
    if (then == AtBarrier::held) return end(EndReason::stopped_by_barrier);
    log_.row(PathState::projectile, motion_);
    return fly_off();
  }

  retime();
  outcome_.max_bounce = flight_end.greatest_height
                            ? *flight_end.greatest_height
                            : greatest_height_of_flight(surface_, path, 0, flight_end.t, outcome_.max_bounce);
  log_.flight(path, flight_end.t, motion_, drag);
  advance(path, drag, flight_end.t);
  if (flight_end.contact) return strike(*flight_end.contact);
  if (flight_end.exit) return end(reason_of(*flight_end.exit));
  return std::nullopt;
}

}  // namespace talus

#include "talus/trajectory/rock_run_at_barriers.hpp"
#include "talus/trajectory/rock_run_gliding.hpp"
#include "talus/trajectory/rock_run_in_forest.hpp"
#include "talus/trajectory/rock_run_in_valley.hpp"
#include "talus/trajectory/rock_run_on_edge.hpp"
#include "talus/trajectory/rock_run_on_ground.hpp"
#include "talus/trajectory/rock_run_striking.hpp"

namespace talus {

extern template class RockRun<Profile>;
extern template class RockRun<TriangleMesh>;
extern template class RockRun<RasterSurface>;

}  // namespace talus
