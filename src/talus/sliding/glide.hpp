#pragma once
// A glide: many steps of a slide (stepped.hpp) on one facet, with nothing near that could end them. The same law, in
// two coordinates on the facet. Most steps of a long slide are taken here, for one rock or for several in lanes.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "talus/core/stop.hpp"
#include "talus/core/vec.hpp"
#include "talus/rocks/touch.hpp"

namespace talus {

/// The settings that all glides of a run share.
struct GlideLaws {
  double stopped_velocity;  // [m/s]
  double max_time;          // of a rock [s]
};

/// What a step changes. `x` is down, along the pull; `y` is aside, to its left seen from outside the ground.
struct GlideMotion {
  double x = 0, y = 0;                                           // displacement from the start [m]
  double vx = 0, vy = 0;                                         // [m/s]
  double speed = 0;                                              // [m/s]
  double time = 0;                                               // since release [s]
  double way_to_bump = std::numeric_limits<double>::infinity();  // left along the path [m]
};

/// A side of the facet, within which the rock must stay.
struct GlideSide {
  double distance = 1, down = 0, aside = 0;  // of the start from it [m], and its growth with x and y
};

/// One rock's glide. It starts above the velocity at which the rock may stop.
struct Glide : GlideMotion {
  double timestep = 0;           // [s]
  double gain = 0, braking = 0;  // change of speed per step, by the pull and by friction [m/s]
  double kept = 1;               // the share of the velocity that drag leaves in a step
  // The square of the distance from the start within which there is no barrier [m2].
  double squared_way = std::numeric_limits<double>::infinity();
  std::array<GlideSide, 3> sides;
};

/// The displacement after a step, and the velocity during it.
struct GlideStep {
  double x, y;    // [m]
  double vx, vy;  // [m/s]
};

/// The motion after a step, and whether the rock then stays on the facet and above the velocity at which it may stop.
/// Without branches, so that it can be computed for several rocks at once.
[[nodiscard, gnu::always_inline]] inline std::pair<GlideMotion, bool> after_step(const GlideLaws& laws,
                                                                                 const Glide& glide) {
  const double wx = glide.kept * glide.vx + glide.gain, wy = glide.kept * glide.vy, size = std::sqrt(wx * wx + wy * wy);
  const double kept = 1 - glide.braking / size;
  GlideMotion then;
  then.vx = kept * wx;
  then.vy = kept * wy;
  then.speed = size - glide.braking;
  then.time = glide.time + glide.timestep;
  then.x = glide.x + glide.timestep * then.vx;
  then.y = glide.y + glide.timestep * then.vy;
  then.way_to_bump = glide.way_to_bump - glide.timestep * then.speed;
  bool stays = (then.time < laws.max_time) & (then.speed >= laws.stopped_velocity) &
               (wx * glide.vx + wy * glide.vy >= glide.braking * glide.speed) &
               (then.x * then.x + then.y * then.y < glide.squared_way) & (then.way_to_bump > 0);
  for (const GlideSide& side : glide.sides)
    stays &= side.distance + then.x * side.down + then.y * side.aside > contact_slack;
  return {then, stays};
}

/// Takes one step, if the rock stays on the facet and above the velocity at which it may stop. If not, returns false
/// and changes nothing.
[[nodiscard]] inline bool try_step(const GlideLaws& laws, Glide& glide) {
  const auto [then, stays] = after_step(laws, glide);
  if (stays) static_cast<GlideMotion&>(glide) = then;
  return stays;
}

/// Several glides at the same time. A step is one long chain of operations; while one rock waits for a square root, the
/// others proceed. Each takes the step of try_step().
class GlideLanes {
 public:
  static constexpr std::size_t width = 16;

  explicit GlideLanes(const GlideLaws& laws);

  [[nodiscard]] bool is_empty() const { return occupied_ == 0; }
  [[nodiscard]] bool is_full() const { return occupied_ == all_lanes; }
  /// Expects a free lane. The result is written to `glide` when it has ended; `trace`, unless null, receives its steps.
  /// `name` identifies the glide in run().
  void add(Glide& glide, std::vector<GlideStep>* trace, std::size_t name);
  /// Runs until at least one glide has ended, or a stop is requested (null: never). Calls ended(name) for each that has
  /// ended. Expects at least one glide.
  template <class Ended>
  void run(const StopScope* stop, Ended&& ended) {
    for (LaneSet lanes = run_until_one_ends(stop); lanes != 0; lanes &= lanes - 1) {
      ended(take(static_cast<std::size_t>(std::countr_zero(lanes))));
    }
  }

 private:
  using Lanes = std::array<double, width>;
  using LaneSet = std::uint64_t;  // a bit per lane
  static constexpr LaneSet all_lanes = (LaneSet{1} << width) - 1;

  LaneSet run_until_one_ends(const StopScope* stop);
  LaneSet step_all();
  void note_step(LaneSet lanes);
  std::size_t take(std::size_t lane);

  GlideLaws laws_;
  LaneSet occupied_ = 0, traced_ = 0;  // a free lane keeps the data of its last glide, which takes no further step
  std::array<Glide*, width> glides_{};
  std::array<std::vector<GlideStep>*, width> traces_{};
  std::array<std::size_t, width> names_{};
  alignas(64) Lanes x_, y_, vx_, vy_, speed_, time_, timestep_, gain_, braking_, kept_, squared_way_, way_to_bump_;
  std::array<Lanes, 3> distance_, down_, aside_;
};

}  // namespace talus
