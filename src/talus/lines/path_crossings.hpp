#pragma once
// Where the path of a rock that has been simulated meets barriers, and lines that were not there when it was: from the
// pieces of the path, with the search and the rules of a rock in motion (barriers/crossing.hpp,
// trajectory/at_barriers.hpp).
//
// A collector touches no rock, so a line that is asked after the run is a collector. In flight it gives the same bits
// as a collector that was in the model. Along the ground the velocity is that of the piece, linear between its ends: a
// leg of the run that was cut short, or one of many steps, differs by rounding. Barriers that were in the model end the
// pieces at which they act; they are followed as well, because a sphere that a barrier holds counts at a line that it
// touches. What they did is read off the next piece.
//
// A path that was kept with few digits along the ground may end just before the barrier that stopped the rock; it is
// continued for a millimetre.
//
// Left out: a rock that a barrier was driven against by its spin alone may count as one more arrival at that barrier.
// Checked by test/lines/path_crossings_test.cpp.

#include <optional>

#include "talus/barriers/crossing.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

class PathCrossings {
 public:
  /// `barriers` must outlive it.
  explicit PathCrossings(const BarrierList& barriers) : barriers_(barriers) {}

  /// Another rock. `reach`: from its centre to the contact, the radius of a sphere or 0 [m].
  void begin(double reach);
  /// The next piece of its path, in their order; not a glide.
  void add(const PathPiece& piece);
  /// The path has ended. `at_barrier`: a barrier stopped the rock.
  void end(bool at_barrier);

  /// Of the rock so far: `hits` and `passed_above`.
  [[nodiscard]] const RockLog& found() const { return found_; }
  /// Whether the first crossing of a barrier is known, and no later piece can change it: a rock that is over a barrier
  /// may still come down on it.
  [[nodiscard]] bool is_settled(BarrierId barrier, double time) const;

 private:
  /// The rock has met a barrier that was in the model, at the end of a piece.
  struct Met {
    Crossing crossing;
    double time;  // since release [s]
  };
  void pass_above(const PathPiece& piece, const Crossing& crossing);
  void arrive(const PathPiece& piece, const Crossing& crossing, BarrierOutcome outcome);
  void leave(const Vec3& velocity);

  const BarrierList barriers_;
  double reach_ = 0;
  RecentCrossings recent_;
  std::optional<Met> met_;
  std::optional<PathPiece> last_;
  RockLog found_{false};
};

}  // namespace talus
