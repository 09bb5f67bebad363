#pragma once
// What the rocks of a finished run do in a ditch, or on a bench, of a section: where they first strike it, how far they
// get, and which get beyond it.
//
// The ditch is the stretch from its toe, at the foot of the slope, to its far edge. Rocks count that are released on
// the side of the toe. All distances are horizontal, from the toe to the centre of the rock. A barrier on the stretch
// hides what the ditch alone would do to the rocks that it meets. Checked by test/lines/ditch_answer_test.cpp.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/lines/ditch_criteria.hpp"
#include "talus/lines/rock_paths.hpp"

namespace talus {

/// Places on the section; local.
struct Ditch {
  double toe = 0, far_edge = 0;
  [[nodiscard]] double width() const;
  /// The distance of a place from the toe, towards the far edge [m].
  [[nodiscard]] double distance(double x) const { return far_edge > toe ? x - toe : toe - x; }
};

/// The ditch between two places in the user's coordinates. Throws BadInput with all problems, which `where` names.
[[nodiscard]] Ditch ditch_between(const Model& model, double toe, double far_edge, std::string_view where);

/// A rock that gets past the toe.
struct RockInDitch {
  std::uint64_t rock = 0;
  /// Where it first touches the ground past the toe; 0 if it slides or rolls past it. Nullopt: it touches none, or a
  /// barrier first.
  std::optional<double> first_impact;  // [m]
  /// Where a barrier between toe and far edge first stops it, turns it back or slows it; nullopt: none does.
  std::optional<double> at_barrier;  // [m]
  double farthest = 0;               // of its path [m]
  bool gets_beyond = false;          // the far edge, also if it comes back
  bool ends_inside = false;          // at rest, held by a barrier or at the limit of time

  /// Whether only the barrier is known to keep it from the far edge.
  [[nodiscard]] bool is_held() const { return at_barrier && !gets_beyond; }
};

struct DitchAnswer {
  std::uint64_t rocks = 0;            // asked: those whose paths are kept and which are released before the toe
  std::uint64_t released_beyond = 0;  // of the kept ones, the others
  std::vector<RockInDitch> arriving;  // in the order of the rocks
  std::optional<SlopeAbove> slope;    // nullopt: no rock is released above the toe
};
[[nodiscard]] DitchAnswer ask_ditch(const Model& model, const RockPaths& paths, const Ditch& ditch);

}  // namespace talus
