#include "talus/sliding/bend.hpp"

namespace talus {

Turned rolled_round_bend(const Vec3& velocity, const Vec3& spin, const Vec3& n, double angle, const Rock& rock,
                         ContactFriction friction) {
  // The motion along the ground during a unit of time, with the impulse over the mass as normal acceleration. Slip may
  // end, and a spin be braked to zero, before it is over.
  constexpr int most_parts = 8;
  Turned turned{velocity, spin};
  const Footing footing{Vec3{}, angle * velocity.norm()};
  double left = 1;
  for (int part = 0; part < most_parts && left > 0; ++part) {
    const Leg leg = rolling_leg(Vec3{}, turned.velocity, turned.spin, n, footing, rock, friction, left);
    turned = {leg.end_velocity, leg.end_spin};
    left -= leg.duration;
  }
  return turned;
}

}  // namespace talus
