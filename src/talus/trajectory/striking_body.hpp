#pragma once
// A rock with a shape strikes the ground with its corners.

#include "talus/core/orientation.hpp"
#include "talus/impact/rigid_body.hpp"
#include "talus/trajectory/clearance.hpp"
#include "talus/trajectory/striking.hpp"

namespace talus {

/// What resists impulses on a body that is turned like this.
[[nodiscard]] inline BodyInertia inertia_of(const Body& body, const Orientation& orientation) {
  const Vec3& i = body.inertia;
  return {body.mass, in_world(orientation, {1 / i[0], 1 / i[1], 1 / i[2]})};
}

/// The spin of a body as tables, maps and stores know it: that of the sphere of the same volume with the body's
/// rotational energy, about the body's angular momentum. In a flight both are constant, the body's own spin is not.
[[nodiscard]] inline Vec3 spin_of_sphere(const Rock& sphere, const Body& body, const Orientation& orientation,
                                         const Vec3& spin) {
  const Vec3 w = orientation.to_body(spin), momentum = body.inertia.times(w);
  const double norm = momentum.norm();
  if (norm == 0) return {};
  return std::sqrt(momentum.dot(w) / sphere.inertia) / norm * orientation.to_world(momentum);
}

/// The contacts of a rock on a face that is tilted against the ground at the first of them.
[[nodiscard]] inline ContactSet tilted(const ContactSet& contacts, const Vec3& face) {
  const Vec3 tilt = face - contacts[0].normal;
  ContactSet on_face;
  for (const ContactPoint& contact : contacts) {
    ContactPoint point = contact;
    point.normal = (contact.normal + tilt).normalized();
    on_face.add(point);
  }
  return on_face;
}

/// The largest speed at which a contact leaves the ground [m/s]; negative if all approach it.
[[nodiscard]] inline double parting_speed(const ContactSet& contacts, const Vec3& velocity, const Vec3& spin) {
  double most = -std::numeric_limits<double>::infinity();
  for (const ContactPoint& c : contacts) most = std::max(most, (velocity + spin.cross(c.arm)).dot(c.normal));
  return most;
}

[[nodiscard]] inline PathState state_on(const ContactSet& contacts, const Motion& motion, const Vec3& spin) {
  const ContactPoint& c = contacts[0];
  const Vec3 slip = tangential(motion.velocity + spin.cross(c.arm), c.normal);
  return slip.norm() > 0.5 * motion.velocity.norm() ? PathState::sliding : PathState::rolling;
}

/// `contacts`: the corners that come to the ground, with their arms at this moment. `quick`: impacts in a row so far,
/// each right after the last.
template <class Surface, class Sink>
[[nodiscard]] Phase strike_with(TrackedRock<Surface, Sink>& rock, const Orientation& orientation, const Vec3& spin,
                                const ContactSet& contacts, std::uint32_t quick) {
  constexpr std::uint32_t max_quick = 12;
  rock.arrive();
  Motion& motion = rock.motion;
  const Motion before = motion;
  const Body& body = *rock.body;
  const ContactPoint& first = contacts[0];
  const Material& material = rock.ground[rock.material_at(first.facet)];
  const std::uint32_t number = rock.contacts;
  const GroundDraw draw = rock.draw_at(first.facet);
  const auto face = struck_face(rock, first.normal, material, draw, number);

  const ContactSet struck = face ? tilted(contacts, *face) : contacts;
  const double approach = (motion.velocity + spin.cross(first.arm)).dot(struck[0].normal);
  const auto [rn, rt] = draw.restitution(material);
  // Tangential restitution could create energy at eccentric contacts; friction alone acts along the ground.
  const Restitution restitution{rock.laws.restitution_scaling.scaled(rn, approach, body.mass), 0};
  const double friction = material.friction_rise.friction(draw.dynamic_friction(material), rock.slid);
  const BodyInertia inertia = inertia_of(body, orientation);
  const MomentArms arms{
      rolling_resists_in_impacts(rock.laws.impact) ? draw.rolling_friction(material) * rock.rock.radius : 0, 0};
  Rebound rebound = rigid_body_impact(motion.velocity, spin, inertia, struck, restitution, friction, arms).rebound;
  if (face) {  // the rebound must not lead into the ground itself
    rebound = rigid_body_impact(rebound.velocity, rebound.spin, inertia, contacts, {}, friction, arms).rebound;
  }
  const Vec3& leaving = rebound.spin;
  motion.velocity = rebound.velocity;
  motion.spin = spin_of_sphere(rock.rock, body, orientation, leaving);
  rock.note_impact({before, motion, first.normal, face.value_or(first.normal), rock.surface.source(first.facet),
                    rock.material_at(first.facet)});
  rock.update_max_energy();
  rock.remember_contact({first.normal, first.facet});
  rock.tell(event::Turned{motion, body, orientation, leaving});

  if (quick <= max_quick && parting_speed(contacts, motion.velocity, leaving) >= rock.leaving_speed) {
    rock.leave(PathState::projectile);
    return Tumbling{orientation, leaving, motion.time, quick};
  }
  rock.leave(state_on(contacts, motion, leaving));
  return Touching{orientation, leaving, friction_of(rock, draw, material, rt), rock.material_at(first.facet)};
}

}  // namespace talus
