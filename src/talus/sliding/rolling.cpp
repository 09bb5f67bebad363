#include "talus/sliding/rolling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace talus {

namespace {

using tolerance::no_slip;
using tolerance::standstill;

Leg rolling_without_slip(const Vec3& position, const Vec3& velocity, const Vec3& spin, const Vec3& n, const Vec3& a,
                         const Footing& footing, double radius, double timestep) {
  const double speed = velocity.norm();
  Leg leg{{position, velocity, a}, timestep, velocity + timestep * a, spin};
  if (speed > standstill) {
    const Vec3 heading = velocity / speed;
    const double rate = a.dot(heading);
    if (rate < 0 && -speed / rate <= timestep) {
      leg.duration = -speed / rate;
      leg.end_velocity = halted(velocity + leg.duration * a, footing, heading);
    }
  } else if (a == Vec3{}) {
    leg.end_velocity = Vec3{};
  }
  leg.end_spin = rolling_spin(leg.end_velocity, spin, n, radius);
  return leg;
}

/// How slip u changes during a leg: du/dt = drift - friction u/|u|, with the direction of u at the end of the leg.
/// (With that at its start, a small slip would overshoot across its direction, and the legs until it ends would zigzag:
/// they amplify rounding by a factor of 1e8 within a second.)
struct SlipChange {
  Vec3 slip;        // at the start [m/s]
  Vec3 drift;       // without friction [m/s2]
  double friction;  // [m/s2]

  /// The direction of slip at the end of a leg.
  [[nodiscard]] Vec3 heading(double duration) const { return (slip + duration * drift).normalized(); }

  /// The duration in which slip turns by a right angle: in longer legs friction would drive it.
  [[nodiscard]] double longest() const {
    const double along = slip.dot(drift);
    return along < 0 ? -slip.squared_norm() / along : std::numeric_limits<double>::infinity();
  }

  /// When slip ends: |slip + t drift| = t friction.
  [[nodiscard]] std::optional<double> end() const {
    const double along = slip.dot(drift), squared = slip.squared_norm();
    const double root = along * along + (friction * friction - drift.squared_norm()) * squared;
    if (root < 0 || std::sqrt(root) <= along) return std::nullopt;
    return squared / (std::sqrt(root) - along);
  }
};

}  // namespace

Leg rolling_leg(const Vec3& position, const Vec3& velocity, const Vec3& spin, const Vec3& n, const Footing& footing,
                const Rock& rock, ContactFriction friction, double timestep) {
  const double normal = footing.normal_acceleration, r = rock.radius;
  const double speed = velocity.norm(), pull = footing.pull.norm();
  const Vec3 heading = speed > standstill ? Vec3(velocity / speed) : pull > 0 ? Vec3(footing.pull / pull) : Vec3{};
  const Vec3 slip = slip_velocity(velocity, spin, n, r);
  if (slip.norm() <= no_slip) {
    const double resistance = friction.rolling * normal;
    // Resistance holds a sphere at rest, but does not drive it.
    const double resisting = speed > standstill ? resistance : std::min(resistance, pull);
    const Vec3 a = rolling_share(rock) * (footing.pull - resisting * heading);
    if ((a - footing.pull).norm() <= friction.dynamic * normal) {
      return rolling_without_slip(position, velocity, spin, n, a, footing, r, timestep);
    }
  }

  const double moment = rock.mass * normal * r / rock.inertia;
  const Vec3 tangential_spin = tangential(spin, n);
  const double spin_rate = tangential_spin.norm();
  const bool spins = spin_rate * r > no_slip;
  // Rolling resistance brakes the spin; without spin, it reduces the moment that would start it.
  const Vec3 braking = spins ? -friction.rolling * moment / spin_rate * tangential_spin : Vec3{};
  const double spinning_up = spins ? friction.dynamic : std::max(0.0, friction.dynamic - friction.rolling);
  const SlipChange change{slip, footing.pull + r * n.cross(braking),
                          friction.dynamic * normal + spinning_up * moment * r};

  const bool slips = slip.norm() > no_slip;
  double duration = slips ? std::min(timestep, change.longest()) : timestep;
  // Resistance brakes the spin to zero, and must not reverse it.
  const auto end_before_spin_reverses = [&](const Vec3& against) {
    const double spin_change = (spinning_up * moment * n.cross(against) + braking).dot(tangential_spin) / spin_rate;
    if (spin_change < 0) duration = std::min(duration, -spin_rate / spin_change);
  };
  if (spins && slips) end_before_spin_reverses(slip.normalized());
  if (spins) end_before_spin_reverses(change.heading(duration));
  const std::optional<double> end = slips ? change.end() : std::nullopt;
  const bool slip_ends = end && *end <= duration;
  if (slip_ends) duration = *end;
  const Vec3 against = change.heading(duration);
  const Vec3 a = footing.pull - friction.dynamic * normal * against;
  const Vec3 angular = spinning_up * moment * n.cross(against) + braking;
  Leg leg{{position, velocity, a}, duration, velocity + duration * a, spin + duration * angular};
  if (slip_ends) {
    // Rolling begins: a spin that agrees with the velocity except for rounding is made to agree exactly.
    const Vec3 rolling = rolling_spin(leg.end_velocity, leg.end_spin, n, r);
    if ((rolling - leg.end_spin).norm() * r <= no_slip * (1 + leg.end_velocity.norm())) leg.end_spin = rolling;
  }
  return leg;
}

}  // namespace talus
