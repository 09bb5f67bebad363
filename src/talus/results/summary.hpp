#pragma once
// The statistics of a campaign, in memory that does not depend on the number of rocks. All sums are independent of
// order: any split of the rocks merges to the same bits.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "talus/results/record.hpp"
#include "talus/results/runout_frame.hpp"
#include "talus/statistics/descriptive.hpp"
#include "talus/statistics/fixed_sum.hpp"
#include "talus/statistics/histogram.hpp"
#include "talus/statistics/quantile_sketch.hpp"
#include "talus/terrain/local_frame.hpp"

namespace talus {

/// One quantity over all rocks: moments and quantiles.
class Tally {
 public:
  /// Values far from zero and close to each other, such as positions, need an origin near them.
  explicit Tally(std::uint64_t planned, double origin = 0) : sketch_(planned, origin) {}
  void add(double x) {
    add_moments(x);
    sketch_.add(x);
  }
  void merge(const Tally& other);
  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in);
  [[nodiscard]] std::uint64_t count() const { return sketch_.count(); }
  [[nodiscard]] Descriptive describe() const { return moments().describe(sketch_.quantile(0.5)); }
  [[nodiscard]] const QuantileSketch& sketch() const { return sketch_; }
  /// About `bins` bins with round edges over all values; nullopt without values.
  [[nodiscard]] std::optional<Histogram> histogram(std::uint64_t bins) const;

 private:
  static constexpr std::size_t most_first = 32;

  void add_moments(double x) {
    if (moments_.empty() && first_.size() < most_first) {
      first_.push_back(x);
    } else {
      moments_of_first().add(x);
    }
  }
  Moments& moments_of_first();
  [[nodiscard]] Moments moments() const;

  // Moments take 2 kB: the first few values are kept instead. Sums are exact, so the result is the same.
  std::vector<double> first_;
  std::vector<Moments> moments_;  // none, or one; with one first_ is empty
  QuantileSketch sketch_;
};

struct BarrierTally {
  explicit BarrierTally(std::uint64_t planned)
      : translational_energy(planned), total_energy(planned), height(planned), velocity(planned) {}
  void merge(const BarrierTally& other);
  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in);

  Tally translational_energy, total_energy;  // [J]
  Tally height;                              // [m]
  Tally velocity;                            // [m/s]
  std::array<std::uint64_t, barrier_outcome_count> outcomes{};
  std::uint64_t rocks_hit = 0;            // rocks that hit it at least once
  std::uint64_t rocks_passed_above = 0;   // rocks that passed above it at least once
  std::optional<double> least_clearance;  // [m]
};

/// All counts and sums over rocks. Positions are in user coordinates.
struct Summary {
  /// `origin`: a place near the terrain, for the quantiles of positions.
  Summary(std::uint64_t planned_rocks, std::size_t barriers, const Vec3& origin = Vec3{});
  /// Expects a summary of the same barriers, or of none.
  void merge(const Summary& other);
  void save(ByteWriter& out) const;
  /// Adds a saved summary; throws BadBytes on anything else, and on another number of planned rocks or barriers, or
  /// another origin.
  void merge_saved(ByteReader& in);

  [[nodiscard]] std::uint64_t ended(EndReason reason) const { return ends[static_cast<std::size_t>(reason)]; }
  /// Whether it is more than one in a hundred rocks: the limit for warnings and notes.
  [[nodiscard]] bool are_many(std::uint64_t rocks) const { return rocks > done / 100; }

  std::uint64_t planned = 0, done = 0;
  std::array<std::uint64_t, end_reason_count> ends{};
  std::uint64_t lifted = 0;
  std::optional<std::uint64_t> first_lost;  // the lowest number among lost rocks, to replay it
  std::int64_t events = 0;
  Tally end_x, runout_plan, runout_total;  // [m]
  Tally max_kinetic_energy;                // [J]
  Tally max_bounce;                        // [m]
  FixedSum flown, on_ground;               // RockWays of all rocks [m]
  std::vector<BarrierTally> barriers;
};

/// Notes on the results that are no fault of the project: that many rocks left the model, which is intended if it ends
/// behind the protected place.
[[nodiscard]] std::vector<std::string> notes_of(const Summary& summary);

class SummaryObserver : public SummingObserver {
 public:
  /// `runout_frame` in local coordinates.
  SummaryObserver(std::uint64_t planned_rocks, std::size_t barriers, const LocalFrame& frame,
                  RunoutFrame runout_frame = {})
      : frame_(frame), runout_frame_(std::move(runout_frame)), summary_(planned_rocks, barriers, frame.origin) {}
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void save(ByteWriter& out) override { summary_.save(out); }
  void merge_saved(ByteReader& in) override { summary_.merge_saved(in); }
  [[nodiscard]] const Summary& summary() const { return summary_; }

 private:
  LocalFrame frame_;
  RunoutFrame runout_frame_;
  Summary summary_;
};

/// Runout as in the tables [m].
struct Runout {
  double plan;                    // in the frame
  double drop, total;             // z at the release minus z at the end; distance from release to end in space
  std::optional<double> lateral;  // in a frame along a line
};
/// `frame` in local coordinates.
[[nodiscard]] Runout runout(const RockOutcome& outcome, const RunoutFrame& frame = {});

}  // namespace talus
