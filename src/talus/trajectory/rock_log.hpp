#pragma once
// What a rock's path leaves behind while it is computed. One log serves one rock after the other without allocating,
// once its lists have grown.

#include <vector>

#include "talus/barriers/barrier.hpp"
#include "talus/motion/motion.hpp"

namespace talus {

struct PathRow {
  PathState state;
  Motion motion;
};

/// A rock passed above a barrier.
struct PassedAbove {
  BarrierId barrier;
  double clearance;  // of the rock's underside above the top [m]
};

class RockLog {
 public:
  explicit RockLog(bool keep_rows) : keep_rows_(keep_rows) {}

  void keep_rows(bool keep) { keep_rows_ = keep; }
  void clear() {
    rows.clear();
    turns.clear();
    hits.clear();
    passed_above.clear();
  }
  void row(PathState state, const Motion& motion) {
    if (keep_rows_) rows.push_back({state, motion});
  }
  /// A rock that slid uphill stands still before it slides back: not a row of the path, but worth showing.
  void turn(const Motion& motion) {
    if (keep_rows_) turns.push_back(motion);
  }

  std::vector<PathRow> rows;
  std::vector<Motion> turns;
  std::vector<BarrierHit> hits;
  std::vector<PassedAbove> passed_above;

 private:
  bool keep_rows_;
};

}  // namespace talus
