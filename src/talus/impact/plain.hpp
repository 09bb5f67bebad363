#pragma once
// Impact of a lumped mass without rotation: vn' = -Rn vn, vt' = Rt vt, spin unchanged.
// Source: RocFall's lumped mass with "consider rotational velocity" off.

#include "talus/impact/restitution.hpp"

namespace talus {

[[nodiscard]] inline Rebound plain_rebound(const Vec3& velocity, const Vec3& spin, const Vec3& n,
                                           Restitution restitution) {
  const Vec3 vn = velocity.dot(n) * n;
  return {-restitution.normal * vn + restitution.tangential * (velocity - vn), spin};
}

/// The impact law (law.hpp) of a lumped mass without rotation.
struct PlainImpact {
  template <class DrawRestitution, class DrawFriction>
  [[nodiscard]] Rebound rebound(const Approach& a, DrawRestitution&& restitution, DrawFriction&&) const {
    return plain_rebound(a.velocity, a.spin, a.normal(), restitution());
  }
};

}  // namespace talus
