#pragma once
// Impact of a rigid body of any shape, at one or several contacts at once: Newton's restitution along the normals,
// Coulomb friction, one set of impulses that fits all contacts.
//
//   u_i = v + w x r_i            velocity of contact i, of arm r_i and normal n_i; un, ut along the normal and across
//   it G_ij = 1/m - [r_i] J [r_j]   what an impulse at j changes at i, with J the inverse inertia tensor, [r] b = r x b
// Impulses P_i are sought with, for each contact,
//   normal:   Pn >= 0,  un' >= Rn max(-un, 0),  and one of both an equality
//   tangent:  |Pt| <= mu Pn;  it sticks with ut' = Rt ut, or slips with Pt = -mu Pn d,  d along ut' - Rt ut
// and with them a moment impulse M that resists rolling along the ground and pivoting about its normal: |Mt| <= rolling
// arm * sum of Pn, |Mn| <= pivot arm * sum of Pn; each ends its part of the spin, or has that size and is against what
// is left of it. One contact is solved exactly: it separates, sticks or slips, and the direction d of slip is the root
// of one equation. Several, and the moment, are solved together by Newton's method (contact_equations.hpp), from where
// one round has come in which each is solved once, in their order. If that fails, rounds go on (block Gauss-Seidel).
//
// Source: the verification manual, section 7.3, is the law of one contact without friction or with enough of it; that
// of several is Newton's law in the form of R. Leine et al., "Simulation of rockfall trajectories with consideration of
// rock shape", Multibody System Dynamics 32 (2014), doi 10.1007/s11044-013-9393-4. With the arm of a sphere, -r n, this
// is the law of rigid_sphere.hpp. Newton's restitution with friction can create energy at eccentric contacts (T. Kane's
// paradox). If it does, Rn and Rt of that impact are lowered by a common factor to where it does not: with Rn = Rt = 0
// it never does. That is said in `is_limited`. Tested against published and computed impacts, and by conservation:
// test/impact/rigid_body_test.cpp.

#include "talus/core/matrix.hpp"
#include "talus/impact/contact_set.hpp"
#include "talus/impact/restitution.hpp"

namespace talus {

/// What resists an impulse.
struct BodyInertia {
  double mass = 0;       // [kg]
  Mat3 inverse_inertia;  // about the centre of mass, in the frame of the terrain [1/(kg m2)]
};

/// Of the moments that resist rolling and pivoting, over the push of all contacts [m]; 0: none.
struct MomentArms {
  double rolling = 0, pivot = 0;
};

/// On a body.
struct ContactImpulses {
  std::array<Vec3, ContactSet::most> at{};  // in the order of the contacts [N s]
  Vec3 moment;                              // [N m s]
};

struct RigidBodyImpact {
  Rebound rebound;
  ContactImpulses by;
  bool has_settled = false;  // if not, contacts may still approach the ground, for the next impact
  bool is_limited = false;   // its restitution was lowered to keep energy from growing
};

/// `friction`: the coefficient mu of all contacts. `arms`: over the ground of the first contact.
[[nodiscard]] RigidBodyImpact rigid_body_impact(const Vec3& velocity, const Vec3& spin, const BodyInertia& body,
                                                const ContactSet& contacts, Restitution restitution, double friction,
                                                MomentArms arms = {});

/// The same without restitution, for contacts that last. One with a gap is open unless it would close sooner than in
/// `duration` [s]: un' >= -gap / duration. `near`: impulses near to those sought, which are then found sooner.
[[nodiscard]] RigidBodyImpact held_by_contacts(const Vec3& velocity, const Vec3& spin, const BodyInertia& body,
                                               const ContactSet& contacts, double duration, double friction,
                                               MomentArms arms, const ContactImpulses& near);

}  // namespace talus
