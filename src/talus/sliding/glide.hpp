#pragma once
// Many steps of a stepped slide (stepped.hpp) on one facet, with nothing near that could end them: the same law in the
// facet's own two coordinates. Most of a long slide goes through here, one rock's alone or several rocks' in lanes.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "talus/core/stop.hpp"
#include "talus/core/vec.hpp"
#include "talus/flight/touch.hpp"

namespace talus {

/// What all glides of a run have in common.
struct GlideLaws {
  double timestep;          // [s]
  double stopped_velocity;  // [m/s]
  double max_time;          // of a rock [s]
};

/// One rock's glide. Down is along the pull, aside to its left, seen from outside the ground.
struct Glide {
  double x = 0, y = 0;           // way gone down and aside [m]
  double vx = 0, vy = 0;         // [m/s]
  double speed = 0;              // [m/s]
  double time = 0;               // of the rock [s]
  double gain = 0, braking = 0;  // of speed in a step, by the pull and by friction [m/s]
  double squared_way =
      std::numeric_limits<double>::infinity();  // from the start, within which only the facet's sides are met [m2]
  /// A line on the facet, on whose inner side the rock must stay.
  struct Side {
    double distance = 1, down = 0, aside = 0;  // of the start from it [m], and how that grows with the way gone
  };
  std::array<Side, 3> sides;
};

/// Where a step has brought the rock, and how fast it went during the step.
struct GlideStep {
  double x, y;    // [m]
  double vx, vy;  // [m/s]
};

/// Takes one step, if that stays on the facet and leaves the rock faster than where it may stop. What comes when it
/// does not is the caller's.
[[nodiscard]] inline bool try_step(const GlideLaws& laws, Glide& glide) {
  const double wx = glide.vx + glide.gain, vy = glide.vy, size = std::sqrt(wx * wx + vy * vy);
  const double kept = 1 - glide.braking / size, speed = size - glide.braking, time = glide.time + laws.timestep;
  const double next_vx = kept * wx, next_vy = kept * vy;
  const double x = glide.x + laws.timestep * next_vx, y = glide.y + laws.timestep * next_vy;
  bool stays = glide.speed >= laws.stopped_velocity && time < laws.max_time && speed >= laws.stopped_velocity &&
               wx * glide.vx + vy * vy >= glide.braking * glide.speed && x * x + y * y < glide.squared_way;
  for (const Glide::Side& side : glide.sides) {
    stays = stays && side.distance + x * side.down + y * side.aside > contact_slack;
  }
  if (!stays) return false;
  glide.x = x;
  glide.y = y;
  glide.vx = next_vx;
  glide.vy = next_vy;
  glide.speed = speed;
  glide.time = time;
  return true;
}

/// Several glides side by side: a step is one long chain of operations, and while one rock's waits for a root, others'
/// go on. The same operations in the same order as try_step(), so the same bits.
class GlideLanes {
 public:
  static constexpr std::size_t width = 16;

  explicit GlideLanes(const GlideLaws& laws);

  [[nodiscard]] bool is_empty() const { return occupied_ == 0; }
  [[nodiscard]] bool is_full() const { return occupied_ == all_lanes; }
  /// Expects a free lane. The glide is written to when it has ended; `trace`, if there is one, gets its steps. `name`
  /// is the caller's.
  void add(Glide& glide, std::vector<GlideStep>* trace, std::size_t name);
  /// Until one glide has ended at the least, or until it is to stop; null: nobody asks. Calls ended(name) for each that
  /// has ended. Expects a glide.
  template <class Ended>
  void run(const StopScope* stop, Ended&& ended) {
    for (LaneSet lanes = run_until_one_ends(stop); lanes != 0; lanes &= lanes - 1) {
      ended(take(static_cast<std::size_t>(std::countr_zero(lanes))));
    }
  }

 private:
  using Lanes = std::array<double, width>;
  using LaneSet = std::uint64_t;  // a bit each
  static constexpr LaneSet all_lanes = (LaneSet{1} << width) - 1;

  LaneSet run_until_one_ends(const StopScope* stop);
  LaneSet step_all();
  void note_step(LaneSet lanes);
  std::size_t take(std::size_t lane);

  GlideLaws laws_;
  LaneSet occupied_ = 0, traced_ = 0;  // what a free lane has is what its last glide ended with: it does not stay
  std::array<Glide*, width> glides_{};
  std::array<std::vector<GlideStep>*, width> traces_{};
  std::array<std::size_t, width> names_{};
  alignas(64) Lanes x_, y_, vx_, vy_, speed_, time_, gain_, braking_, squared_way_;
  std::array<Lanes, 3> distance_, down_, aside_;
};

}  // namespace talus
