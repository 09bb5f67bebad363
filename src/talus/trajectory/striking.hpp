#pragma once
// The rock strikes the ground: the impact law, and whether the rock stays on the ground afterwards.

#include "talus/impact/roughness.hpp"
#include "talus/trajectory/edge_contact.hpp"
#include "talus/trajectory/ground_friction.hpp"
#include "talus/trajectory/tracked_rock.hpp"
#include "talus/trajectory/valley_contact.hpp"

namespace talus {

/// The normal of the face that a rock strikes on ground of normal `n`; nullopt if it strikes the facet itself.
template <class Surface>
[[nodiscard]] std::optional<Vec3> struck_face(const MovingRock<Surface>& rock, const Vec3& n, const Material& material,
                                              const GroundDraw& draw, std::uint32_t contact) {
  if (material.roughness.is_smooth()) return std::nullopt;
  const Vec3& v = rock.motion.velocity;
  const Vec3 vt = tangential(v, n);
  const Vec3 down = tangential(rock.laws.gravity, n);
  // A rock that falls straight down on level ground has no heading: any will do.
  const Vec3 across = vt.squared_norm() > 0 ? vt : down.squared_norm() > 0 ? down : tangential(unit_x, n);
  std::optional<FaceTilt> face;
  if (rock.laws.roughness == RoughnessLaw::faces) {
    const double speed = v.norm();
    face = draw.met_face(material, contact, std::max(0.0, -v.dot(n)) / speed, vt.norm() / speed, rock.laws.in_section);
  } else {
    face = draw.tilt_at_impact(material, contact);
    if (rock.laws.in_section) face->aside = 0;
  }
  if (!face) return std::nullopt;
  const Vec3 tilted = tilted_normal(n, across.normalized(), face->ahead, face->aside);
  return v.dot(tilted) < 0 ? std::optional(tilted) : std::nullopt;  // a face that faces away is not struck
}

/// Whether the bottom of the valley between a facet and another that the rock struck just before is on the ground. In a
/// pit a third facet may be above it.
template <class Surface>
[[nodiscard]] bool has_open_bottom(MovingRock<Surface>& rock, const Support& on, const LastContact& before) {
  if (!rock.is_facet(on) || !rock.is_facet(before.with)) return true;
  const Vec3 &n = on.normal, &m = before.with.normal;
  const Vec3 across = tangential(m, n);
  const Vec3 bottom =
      rock.motion.position - m.dot(rock.motion.position - before.position) / across.squared_norm() * across;
  bool is_open = true;
  rock.surface.supports(
      bottom, rock.reach, tolerance::one_contact, [&](const Vec3& away, const Vec3&, double distance, FacetId facet) {
        // A sphere may touch a third facet at its end alone, a point has no direction from a facet.
        const Vec3& third = rock.is_sphere() ? away : rock.surface.normal(facet);
        const double gap = rock.is_sphere() ? distance - rock.reach : third.dot(bottom - rock.surface.point_of(facet));
        const bool is_side = third.dot(n) > 1 - tolerance::facet_normal || third.dot(m) > 1 - tolerance::facet_normal;
        is_open = is_open && (is_side || gap >= -contact_slack);
      });
  return is_open;
}

/// The phase of a rock that stays on the ground after an impact: on a facet or an edge or, if it goes back and forth
/// between two supports, in the valley between them.
template <class Surface, class Sink>
[[nodiscard]] Phase stay_on_ground(TrackedRock<Surface, Sink>& rock, const Contact& contact,
                                   const GroundFriction& friction) {
  const Support on{contact.normal, contact.facet};
  const bool is_on_facet = contact.feature == Feature::facet;
  const LastContact before = rock.last_contact;
  const Vec3& n = on.normal;
  std::optional<InValley> valley;
  SideContact side_contact;
  const bool struck_here =
      (rock.motion.position - before.position).squared_norm() < tolerance::one_contact * tolerance::one_contact;
  if (struck_here && before.with.normal.dot(n) < 1 - tolerance::facet_normal) {
    const bool is_caught =
        is_caught_between(rock.laws.gravity, before.with.normal, n, rock.motion.velocity, rock.leaving_speed);
    if (is_caught && has_open_bottom(rock, on, before)) {
      valley = InValley{on, before.with, friction, is_on_facet};
    } else if (rock.progress.is_stuck(rock.motion, rock.reach)) {
      // Friction or a third contact drives it from one to the other, not gravity. It moves along both.
      side_contact = Guide{before.with.normal};
    }
  }
  rock.remember_contact(on);

  // In the row in which a slide begins, RocFall3 includes the small normal velocity and RocFall2 does not (tables A-2
  // and A-1, row 14). The tangential velocity, with which the slide begins, agrees.
  const Vec3 along = tangential(rock.motion.velocity, n);
  if (!rock.is_sphere() && rock.laws.sliding == SlidingMethod::stepped) {
    rock.leave(PathState::sliding);
    // The ground takes a part of the motion right after the impact.
    const Motion& motion = rock.motion;
    rock.tell(event::Leg{motion, motion, {motion.position, Vec3{}, Vec3{}}, 0, on.facet});
    rock.motion.velocity = along;
  } else {
    rock.motion.velocity = along;
    rock.leave(rock.state_on(n));
  }
  if (valley) {
    valley->friction = shared_friction(rock, friction, *valley);
    keep_along_valley(rock, *valley);
    return *valley;
  }
  if (is_on_facet) return OnFacet{on, friction, side_contact};
  return OnEdge{on, friction, side_contact};
}

/// Whether gravity, less the turn about an edge, presses a rock onto what it touches.
template <class Surface>
[[nodiscard]] bool is_pressed_on(MovingRock<Surface>& rock, const Contact& contact) {
  if (contact.feature == Feature::facet) return rock.laws.gravity.dot(contact.normal) < 0;
  return normal_acceleration_on_edge(rock, {contact.normal, contact.facet}) > 0;
}

/// The rock moves on along ground that it grazes.
template <class Surface, class Sink>
[[nodiscard]] Phase move_on(TrackedRock<Surface, Sink>& rock, const Contact& contact, GroundSoFar ground) {
  if (rock.material_at(contact.facet) != ground.material) {
    ground = {friction_at(rock, contact.facet), rock.material_at(contact.facet)};
  }
  rock.round_bend(contact.normal, ground.friction);
  if (is_pressed_on(rock, contact)) return stay_on_ground(rock, contact, ground.friction);
  rock.remember_contact({contact.normal, contact.facet});
  rock.leave(PathState::projectile);
  return Flying{{}, ground};
}

/// The impact on a face of normal `n` of the ground that the rock touches, and its phase afterwards.
template <class Surface, class Sink>
[[nodiscard]] Phase rebound_from(TrackedRock<Surface, Sink>& rock, const Contact& contact, const Vec3& n,
                                 const Material& material, const GroundDraw& draw) {
  Motion& motion = rock.motion;
  const Motion before = motion;
  double rt = 0;
  const auto draw_restitution = [&] {
    const auto [rn, tangential] = draw.restitution(material);
    rt = tangential;
    return Restitution{rock.laws.restitution_scaling.scaled(rn, motion.velocity.dot(n), rock.rock.mass), rt};
  };
  const auto draw_friction = [&] {
    return ContactFriction{draw.dynamic_friction(material), draw.rolling_friction(material)};
  };
  const ContactSet touched = ContactPoint{-rock.reach * n, n};
  const Approach approach{motion.velocity, motion.spin, touched, rock.rock};
  const Rebound rebound = std::visit(
      [&](const auto& law) { return law.rebound(approach, draw_restitution, draw_friction); }, rock.impact_law);
  motion.velocity = kept_outside(rebound.velocity, contact.normal);
  motion.spin = rebound.spin;
  rock.note_impact(
      {before, motion, contact.normal, n, rock.surface.source(contact.facet), rock.material_at(contact.facet)});
  rock.update_max_energy();

  const bool leaves = motion.velocity.dot(contact.normal) >= rock.leaving_speed;
  if (leaves || !is_pressed_on(rock, contact)) {
    rock.remember_contact({contact.normal, contact.facet});
    rock.leave(PathState::projectile);
    return Flying{};
  }
  return stay_on_ground(rock, contact, friction_of(rock, draw, material, rt));
}

/// The rock meets ground: an impact, unless it moved along the ground before, and grazes this.
template <class Surface, class Sink>
[[nodiscard]] Phase strike(TrackedRock<Surface, Sink>& rock, const Contact& contact,
                           const std::optional<GroundSoFar>& before = {}) {
  rock.arrive();
  if (before && rock.grazes(contact.normal)) return move_on(rock, contact, *before);
  const Material& material = rock.ground[rock.material_at(contact.facet)];
  const std::uint32_t number = rock.contacts;
  const GroundDraw draw = rock.draw_at(contact.facet);
  const Vec3 n = struck_face(rock, contact.normal, material, draw, number).value_or(contact.normal);
  return rebound_from(rock, contact, n, material, draw);
}

/// The rock comes to a bump of the ground that it moves along: an impact on a face that rises against it. nullopt if it
/// strikes none.
template <class Surface, class Sink>
[[nodiscard]] std::optional<Phase> strike_bump(TrackedRock<Surface, Sink>& rock, const Contact& contact) {
  rock.pass_bump();
  const Material& material = rock.ground[rock.material_at(contact.facet)];
  const std::uint32_t number = rock.contacts;
  const GroundDraw draw = rock.draw_at(contact.facet);
  const auto n = struck_face(rock, contact.normal, material, draw, number);
  if (!n) return std::nullopt;
  rock.arrive();
  return rebound_from(rock, contact, *n, material, draw);
}

}  // namespace talus
