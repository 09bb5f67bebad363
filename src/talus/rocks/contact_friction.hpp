#pragma once
// Friction of a rigid sphere's contact with the ground.

namespace talus {

struct ContactFriction {
  double dynamic = 0;  // mu: friction over normal force while the contact slips
  double rolling = 0;  // mu_r: moment against the spin over normal force and radius
};

}  // namespace talus
