#pragma once
// A rock with a shape on the ground: it rocks, slides on a face, tumbles slowly, or comes to rest. Corners that meet
// the ground faster than the cutoff strike it (striking_body.hpp); the others are held by impulses, step by step.
//
// One step of Moreau's method: half a step with the velocities at its start; there the corners that are on the ground
// or may be by the middle of the next step, and the impulses with which none of them moves further towards it than its
// gap, within friction (impact/rigid_body.hpp, without restitution); half a step with the velocities after them. The
// angular momentum between impulses is constant, exactly. Source: R. Leine et al. (2014),
// doi 10.1007/s11044-013-9393-4, whose steps are these. When a corner that has just left the ground comes down again, a
// step would add at most m (g dt)^2 / 8 of energy: it is taken away from the velocities, and then from the way.

#include "talus/trajectory/tumbling.hpp"

namespace talus {

/// A body in touch with the ground, for one step.
struct BodyStep {
  const Body& body;
  Vec3 gravity;

  [[nodiscard]] double energy(const Vec3& centre, const Vec3& velocity, const Vec3& body_spin) const {
    return 0.5 * body.mass * velocity.squared_norm() + 0.5 * body.inertia.dot(body_spin.times(body_spin)) -
           body.mass * gravity.dot(centre);
  }
  /// The spin with this angular momentum.
  [[nodiscard]] Vec3 spin_with(const Orientation& orientation, const Vec3& momentum) const {
    const Vec3 l = orientation.to_body(momentum);
    return orientation.to_world({l[0] / body.inertia[0], l[1] / body.inertia[1], l[2] / body.inertia[2]});
  }
  [[nodiscard]] Vec3 momentum_with(const Orientation& orientation, const Vec3& spin) const {
    return orientation.to_world(body.inertia.times(orientation.to_body(spin)));
  }
};

template <class Surface>
[[nodiscard]] double timestep_in_touch(const MovingRock<Surface>& rock, const Touching& phase) {
  const double turning = phase.spin.norm(), speed = rock.motion.velocity.norm();
  double step = rock.laws.timestep;
  if (turning > 0) step = std::min(step, tolerance::turn_in_touch / turning);
  if (speed > 0) step = std::min(step, tolerance::way_in_touch / speed);
  return step;
}

/// The arms of the moments that resist a body on the ground. Friction under a contact of the size that resists rolling,
/// mu_r r, resists pivoting: 2/3 mu Pn mu_r r, of a disc that presses evenly.
template <class Surface>
[[nodiscard]] MomentArms moment_arms(const MovingRock<Surface>& rock, const ContactFriction& friction) {
  const double arm = friction.rolling * rock.rock.radius;
  return {arm, 2.0 / 3 * friction.dynamic * arm};
}

/// After so much more way along the ground [m].
template <class Surface>
[[nodiscard]] ContactFriction friction_under(const MovingRock<Surface>& rock, const Touching& phase, double way = 0) {
  ContactFriction friction = phase.friction.sphere;
  friction.dynamic = rock.ground[phase.ground].friction_rise.friction(friction.dynamic, rock.slid + way);
  return friction;
}

/// The impulses of a step are near to those that held the body in the last one: kept in Touching, in proportion to mass
/// and duration.
template <class Surface>
[[nodiscard]] RigidBodyImpact held_by(const MovingRock<Surface>& rock, const ContactSet& contacts, Touching& phase,
                                      double dt, const BodyInertia& inertia, const Vec3& velocity, const Vec3& spin) {
  const double unit = rock.rock.mass * dt;
  ContactImpulses near;
  near.moment = unit * Vec3(phase.moment[0], phase.moment[1], phase.moment[2]);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (const CornerHold& hold : phase.holds) {
      if (hold.corner == contacts[i].corner) near.at[i] = unit * Vec3(hold.pull[0], hold.pull[1], hold.pull[2]);
    }
  }
  const ContactFriction friction = friction_under(rock, phase, 0.5 * dt * rock.motion.velocity.norm());
  const RigidBodyImpact held =
      held_by_contacts(velocity, spin, inertia, contacts, dt, friction.dynamic, moment_arms(rock, friction), near);
  const auto kept = [&](const Vec3& v) {
    return std::array{static_cast<float>(v[0] / unit), static_cast<float>(v[1] / unit),
                      static_cast<float>(v[2] / unit)};
  };
  phase.holds = {};
  for (std::size_t i = 0; i < contacts.size(); ++i) phase.holds[i] = {contacts[i].corner, kept(held.by.at[i])};
  phase.moment = kept(held.by.moment);
  return held;
}

/// Whether friction and the resistance to rolling hold the body where it is, without a motion.
template <class Surface>
[[nodiscard]] bool is_held(const MovingRock<Surface>& rock, const BodyInertia& inertia, const ContactSet& contacts,
                           const ContactFriction& friction) {
  const Vec3 pull = rock.laws.timestep * rock.laws.gravity;
  constexpr double ever = std::numeric_limits<double>::infinity();
  const auto [velocity, spin] =
      held_by_contacts(pull, Vec3{}, inertia, contacts, ever, friction.dynamic, moment_arms(rock, friction), {})
          .rebound;
  return velocity.norm() + spin.norm() * rock.body->reach <= tolerance::held_share * pull.norm();
}

/// How a body whose centre is no longer over the terrain leaves the model.
template <class Surface, class Sink>
[[nodiscard]] std::optional<Phase> leave_model(TrackedRock<Surface, Sink>& rock) {
  if (rock.surface.ground_below(rock.motion.position + rock.body->reach * unit_z)) return std::nullopt;
  const Exit exit = rock.surface.exit({rock.motion.position, rock.motion.velocity, rock.laws.gravity});
  return leave_over_rim(rock, Exit{0, false, exit.in_hole});
}

template <class Surface, class Sink>
[[nodiscard]] Phase take_off(TrackedRock<Surface, Sink>& rock, const Touching& phase) {
  rock.arrive();
  rock.leave(PathState::projectile);
  return Tumbling{phase.orientation, phase.spin, rock.motion.time};
}

/// A step: its centre moves straight, and it turns with one spin in the first half and with another in the second.
struct BodyLeg {
  const Body& body;
  const Parabola& path;
  double duration;  // [s]
  Orientation start, halfway;
  Vec3 spin, later_spin;

  [[nodiscard]] Orientation orientation_at(double t) const {
    const double half = 0.5 * duration;
    return t < half ? Orientation::of_turn(t * spin) * start : Orientation::of_turn((t - half) * later_spin) * halfway;
  }
  [[nodiscard]] Posture at(double t) const { return body.at(path.at(t), orientation_at(t).matrix()); }
  [[nodiscard]] double max_turning() const { return std::max(spin.norm(), later_spin.norm()); }
};

/// Barriers on the way of a step, at the end of which the rock has `after`. nullopt if none changes it.
template <class Surface, class Sink>
[[nodiscard]] std::optional<Phase> meet_barriers_in_touch(TrackedRock<Surface, Sink>& rock, const Touching& phase,
                                                          FacetId facet, const BodyLeg& step, const Motion& after) {
  Motion& motion = rock.motion;
  const Parabola& leg = step.path;
  if (!may_meet(rock.barriers, leg, step.duration, step.body.reach)) return std::nullopt;
  const Vec3 pull = (after.velocity - motion.velocity) / step.duration;  // of gravity and of the ground
  while (const auto crossing = next_body_crossing(rock, step, step.duration)) {
    const Motion before = std::exchange(motion, after);
    motion.position = leg.at(crossing->t);
    motion.time = before.time + crossing->t;
    if (crossing->above) {
      pass_above(rock, *crossing, std::exchange(motion, before));
      continue;
    }
    const Motion arrived = motion;
    Touching next = phase;
    next.orientation = step.orientation_at(crossing->t);
    rock.tell(event::Turned{arrived, step.body, next.orientation, phase.spin});
    const AtBarrier effect = meet_barrier(rock, *crossing, motion.time, pull);
    if (effect == AtBarrier::unaffected) {
      motion = before;
      continue;
    }
    rock.cover_leg(facet, leg, crossing->t, before, arrived);
    if (effect == AtBarrier::stopped) return Ended{EndReason::stopped_by_barrier};
    next.spin = spin_after(rock, phase.spin, arrived.spin);
    motion.spin = spin_of_sphere(rock.rock, *rock.body, next.orientation, next.spin);
    rock.tell(event::Turned{motion, step.body, next.orientation, next.spin});
    rock.leave(PathState::sliding);
    return next;
  }
  return std::nullopt;
}

/// The middle of a step: how the body is turned there, and what touches the ground or may before the next.
struct HalfStep {
  Orientation orientation;
  ContactSet contacts;
};

/// How far from the ground a corner may be in the middle of a step so that it counts [m]: it does not strike, so by the
/// next it comes nearer by no more than this.
template <class Surface>
[[nodiscard]] double reach_in(const MovingRock<Surface>& rock, double dt) {
  return std::max(tolerance::one_touch, dt * rock.leaving_speed);
}

template <class Surface>
[[nodiscard]] HalfStep half_step(const MovingRock<Surface>& rock, const Touching& phase, double dt) {
  const Orientation halfway = Orientation::of_turn(0.5 * dt * phase.spin) * phase.orientation;
  const Posture middle = rock.body->at(rock.motion.position + 0.5 * dt * rock.motion.velocity, halfway.matrix());
  return {halfway, touched_by(rock.surface, middle, reach_in(rock, dt)).contacts()};
}

/// A contact where body and ground will touch. Contacts of a face are then in one plane, whatever their gaps are:
/// closing these does not make some of them slip.
[[nodiscard]] inline ContactPoint on_ground(ContactPoint contact) {
  contact.arm -= contact.gap * contact.normal;
  return contact;
}

/// Contacts that come down faster than the cutoff. Those that do, but are not there yet, do not hold the body: `held`
/// has all others.
struct Strikes {
  ContactSet contacts;  // with their arms at the start of the step
  ContactSet held;
  double until = 0;  // the first of them touches the ground [s]
};

template <class Surface>
[[nodiscard]] Strikes strikes_in(const MovingRock<Surface>& rock, const Touching& phase, const ContactSet& contacts,
                                 double dt) {
  Strikes strikes;
  const Vec3 middle = rock.motion.position + 0.5 * dt * rock.motion.velocity;
  const Posture start = rock.body->at(rock.motion.position, phase.orientation.matrix());
  for (const ContactPoint& contact : contacts) {
    ContactPoint at_start = contact;
    at_start.arm = arm_in(start, contact, middle);
    const double approach = -(rock.motion.velocity + phase.spin.cross(at_start.arm)).dot(contact.normal);
    if (approach <= rock.leaving_speed) {
      strikes.held.add(on_ground(contact));
      continue;
    }
    if (contact.gap > tolerance::one_touch) continue;
    const double until = std::max(0.0, gap_in(rock.surface, start, contact) / approach);
    strikes.until = strikes.contacts.size() == 0 ? until : std::min(strikes.until, until);
    strikes.contacts.add(at_start);
  }
  return strikes;
}

template <class Surface, class Sink>
[[nodiscard]] std::optional<NextPhase> take_step(TrackedRock<Surface, Sink>& rock, Touching& phase) {
  const Body& body = *rock.body;
  const BodyStep step{body, rock.laws.gravity};
  Motion& motion = rock.motion;
  if (motion.time >= rock.laws.max_time) return NextPhase{Ended{EndReason::maximum_time}};
  double dt = std::min(timestep_in_touch(rock, phase), rock.laws.max_time - motion.time);
  rock.progress.record(motion, rock.reach, std::min(1.0, dt / 0.01));
  if (rock.is_wedged()) return NextPhase{come_to_rest(rock)};

  const Motion before = motion;
  const Orientation start = phase.orientation;
  const Vec3 start_spin = phase.spin;
  const double energy = step.energy(motion.position, motion.velocity, start.to_body(phase.spin));
  const Vec3 momentum = step.momentum_with(start, phase.spin);
  HalfStep half = half_step(rock, phase, dt);
  Strikes strikes = strikes_in(rock, phase, half.contacts, dt);
  if (strikes.contacts.size() > 0) {
    // The step ends where the corner comes down, unless that is here.
    if (strikes.until > tolerance::soon_struck * dt) {
      dt = std::min(dt, strikes.until);
      half = half_step(rock, phase, dt);
      strikes = strikes_in(rock, phase, half.contacts, dt);
    }
    if (strikes.contacts.size() > 0) return NextPhase{strike_with(rock, start, phase.spin, strikes.contacts, 0)};
  }
  const Orientation& halfway = half.orientation;
  const ContactSet& contacts = strikes.held;

  Vec3 velocity = motion.velocity + dt * rock.laws.gravity;
  if (phase.friction.drag > 0) velocity *= std::exp(-phase.friction.drag * dt);
  Vec3 spin = step.spin_with(halfway, momentum);
  const BodyInertia inertia = inertia_of(body, halfway);
  bool is_pushed = false;
  if (contacts.size() > 0) {
    const FacetId facet = contacts[0].facet;
    if (rock.material_at(facet) != phase.ground) {
      phase.ground = rock.material_at(facet);
      phase.friction = friction_at(rock, facet);
    }
    const RigidBodyImpact held = held_by(rock, contacts, phase, dt, inertia, velocity, spin);
    is_pushed =
        std::any_of(held.by.at.begin(), held.by.at.end(), [](const Vec3& impulse) { return impulse != Vec3{}; });
    velocity = held.rebound.velocity;
    spin = held.rebound.spin;
  }

  const bool is_still =
      is_pushed && velocity.norm() + spin.norm() * body.reach <= tolerance::still_share * dt * rock.laws.gravity.norm();

  const Vec3 after_push = step.momentum_with(halfway, spin);
  Vec3 way = 0.5 * dt * (motion.velocity + velocity);
  Orientation end = Orientation::of_turn(0.5 * dt * spin) * halfway;
  Vec3 end_spin = step.spin_with(end, after_push);
  const double gained = step.energy(motion.position + way, velocity, end.to_body(end_spin)) - energy;
  if (gained > 0) {
    const double moving = step.energy(Vec3{}, velocity, end.to_body(end_spin));
    const double kept = std::sqrt(std::max(0.0, 1 - gained / moving));
    velocity *= kept;
    end_spin *= kept;
    const double rise = -body.mass * rock.laws.gravity.dot(way);
    if (kept == 0 && rise > 0)
      way *= std::clamp((energy + body.mass * rock.laws.gravity.dot(motion.position)) / rise, 0.0, 1.0);
  }
  phase.orientation = end;
  phase.spin = end_spin;
  const Motion after{motion.position + way, velocity, spin_of_sphere(rock.rock, body, end, end_spin), motion.time + dt};
  const FacetId facet = contacts.size() > 0 ? contacts[0].facet : rock.last_contact.with.facet;
  const Parabola leg{before.position, way / dt, Vec3{}};
  const BodyLeg way_there{body, leg, dt, start, halfway, start_spin, spin};
  if (auto met = meet_barriers_in_touch(rock, phase, facet, way_there, after)) return NextPhase{*std::move(met)};
  if (rock.ground[phase.ground].friction_rise.rise > 0) {
    if (is_pushed) {
      rock.slid += way.norm();
    } else {
      rock.fade_friction(dt);
    }
  }
  motion = after;
  rock.tell(event::Turned{motion, body, end, end_spin});
  rock.cover_leg(facet, leg, dt, before, motion);
  rock.update_max_energy();
  if (contacts.size() > 0) rock.remember_contact({contacts[0].normal, facet});
  if (auto left = leave_model(rock)) return NextPhase{*std::move(left)};

  phase.apart = is_pushed ? 0 : phase.apart + dt;
  if (phase.apart > tolerance::apart_in_flight &&
      nearest_part(rock.surface, body.at(motion.position, end.matrix())).gap > tolerance::clear_in_flight) {
    return NextPhase{take_off(rock, phase)};
  }
  const bool is_slow =
      velocity.norm() < rock.laws.stopped_velocity && end_spin.norm() * body.reach < rock.laws.stopped_velocity;
  if (is_still) return NextPhase{come_to_rest(rock)};
  phase.quiet = is_slow ? phase.quiet + dt : 0;
  if (phase.quiet > tolerance::quiet_at_rest) {
    // Corners that nearly touch will hold it, too: from step to step, some of them hover.
    const auto near =
        touched_by(rock.surface, body.at(motion.position, end.matrix()), tolerance::near_touch).contacts();
    if (near.size() > 0 && is_held(rock, inertia_of(body, end), near, friction_under(rock, phase))) {
      return NextPhase{come_to_rest(rock)};
    }
  }
  return std::nullopt;
}

}  // namespace talus
