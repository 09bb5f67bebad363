#pragma once
// All of a rock that its next flight or leg depends on, besides the scene, the rock and its draws: plain data. A copy
// of the bytes goes on as the rock itself does (test/trajectory/rock_state_test.cpp), except beside barriers, where it
// also matters which ones it has just met (RecentCrossings).

#include <cstdint>
#include <limits>
#include <type_traits>

#include "talus/core/tolerances.hpp"
#include "talus/trajectory/bumps.hpp"
#include "talus/trajectory/phases.hpp"

namespace talus {

/// Detects a rock that makes no progress: counts its contacts in the same place and with the same spin. (Spin counts
/// because friction may still turn it into motion, even if a sphere stands.) `reach`: a sphere's radius; 0 for a point,
/// whose spin does not count.
class Progress {
 public:
  /// Called once per flight or stretch, for one contact, and once per leg, for its share of 0.01 s: legs with a small
  /// timestep count for less than a contact.
  void record(const Motion& motion, double reach, double contacts = 1) {
    if (!is_same(motion, reach)) {
      place_ = motion.position;
      spin_ = motion.spin;
      contacts_ = 0;
    }
    contacts_ += contacts;
  }
  /// Whether contact follows contact in the same place.
  [[nodiscard]] bool is_stuck(const Motion& motion, double reach) const {
    return contacts_ > tolerance::contacts_to_stuck && is_same(motion, reach);
  }
  /// Whether a slow rock is caught between what it touches: every contact has taken some of its energy.
  [[nodiscard]] bool is_wedged() const { return contacts_ > tolerance::contacts_to_rest; }

 private:
  [[nodiscard]] bool is_same(const Motion& motion, double reach) const {
    return (motion.position - place_).squared_norm() <= tolerance::same_place * tolerance::same_place &&
           (motion.spin - spin_).norm() * reach <= tolerance::same_spin;
  }

  Vec3 place_, spin_;
  double contacts_ = 0;
};

/// The previous contact with the ground.
struct LastContact {
  Vec3 position = Vec3::all(std::numeric_limits<double>::infinity());
  Support with{};
};

/// The present stretch along the ground: its legs up to the next event.
struct Stretch {
  bool has_turned = false;  // the rock stood still and slides back
  double past_edge = 0;     // time in a valley that has an edge or a vertex on one side [s]
};

struct RockState {
  Motion motion;
  Phase phase = Flying{};
  LastContact last_contact;
  Progress progress;
  Stretch stretch;
  Bumps bumps;
  std::uint32_t contacts = 0;    // for which the ground's properties were drawn
  std::uint32_t short_legs = 0;  // since the last that counted as a step
  std::int64_t steps = 0;        // flights and stretches so far, and one for every hundred short legs
  double slid = 0;               // s of FrictionRise, of a rock with a shape [m]
};
static_assert(std::is_trivially_copyable_v<RockState> && sizeof(RockState) == 448);

}  // namespace talus
