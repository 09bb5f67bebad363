#pragma once
// Counts for the design of barriers: the first crossing of every line by each rock, at any height.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "talus/results/line_crossing.hpp"
#include "talus/results/record.hpp"
#include "talus/statistics/quantile_sketch.hpp"

namespace talus {

/// One value of each quantity per rock.
struct SectionTally {
  explicit SectionTally(std::uint64_t planned_rocks);
  void add(const LineCrossing& crossing);
  void merge(const SectionTally& other);
  [[nodiscard]] std::uint64_t rocks() const { return sketches.front().count(); }
  [[nodiscard]] const QuantileSketch& of(CrossingQuantity quantity) const {
    return sketches[static_cast<std::size_t>(quantity)];
  }

  std::vector<QuantileSketch> sketches;  // in the order of the quantities
  double largest_block = 0;              // diameter of the largest rock [m]
};

/// The kits that the rocks need: how many rocks need which of the plan's heights and energies as a minimum. The number
/// of rocks that a kit of a given height and energy catches follows exactly.
class KitDemands {
 public:
  KitDemands(std::size_t heights, std::size_t energies) : columns_(energies + 1), counts_((heights + 1) * columns_) {}
  /// The number of a class of kits, of kit_classes() of the plan.
  [[nodiscard]] std::size_t number(std::size_t height, std::size_t energy) const { return height * columns_ + energy; }
  /// Indices of the lowest height and energy that suffice; the number of heights or energies if none does.
  void add(std::size_t height, std::size_t energy) { ++counts_[height * columns_ + energy]; }
  [[nodiscard]] std::uint64_t at(std::size_t height, std::size_t energy) const {
    return counts_[height * columns_ + energy];
  }
  [[nodiscard]] std::uint64_t rocks() const;
  /// Rocks that a kit of this height and energy catches.
  [[nodiscard]] std::uint64_t caught(std::size_t height, std::size_t energy) const;
  /// Rocks that are too high for this height, whatever the energy.
  [[nodiscard]] std::uint64_t above(std::size_t height) const;

  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in);

 private:
  std::size_t columns_;
  std::vector<std::uint64_t> counts_;
};

/// The kits that rocks need on two lines: how many rocks need which class on the one and which on the other. A class is
/// that of the lowest sufficient height and energy, or `none` if the line never meets the rock in time.
class PairCounts {
 public:
  explicit PairCounts(std::size_t classes) : side_(classes + 1), counts_(side_ * side_) {}
  [[nodiscard]] std::size_t none() const { return side_ - 1; }
  void add(std::size_t one, std::size_t other) { ++counts_[one * side_ + other]; }
  [[nodiscard]] std::uint64_t at(std::size_t one, std::size_t other) const { return counts_[one * side_ + other]; }
  [[nodiscard]] std::uint64_t rocks() const;

  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in);

  std::uint64_t one_first = 0, other_first = 0;  // rocks that cross both lines, by the line that they cross first

 private:
  std::size_t side_;
  std::vector<std::uint64_t> counts_;
};

/// Its memory grows with sections, not with rocks: sketches keep values up to 100,000 rocks of the campaign and counts
/// in bins beyond (statistics/quantile_sketch.hpp), about half a megabyte a section.
struct DesignTally {
  struct Line {
    std::vector<SectionTally> sections;
    KitDemands demands;  // of the rocks that count (DesignPlan::protect)
    /// Rocks that count and do not cross this line, but for its free ends, before they reach the protected one.
    std::uint64_t beside = 0;
  };

  DesignTally(const DesignPlan& plan, std::uint64_t planned_rocks);
  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in);

  std::uint64_t rocks = 0;  // all rocks observed
  std::vector<Line> lines;
  std::vector<PairCounts> pairs;  // in the order of the plan
};

/// Only the first crossing of a line by a rock counts, not a later one, nor one after a rebound from it. It also counts
/// if the rock is stopped there. Rocks are not followed behind the kits of the design.
class DesignObserver : public SummingObserver {
 public:
  DesignObserver(DesignPlan plan, std::uint64_t planned_rocks);
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void save(ByteWriter& out) override { tally_.save(out); }
  void merge_saved(ByteReader& in) override { tally_.merge_saved(in); }
  [[nodiscard]] const DesignPlan& plan() const { return plan_; }
  [[nodiscard]] const DesignTally& tally() const { return tally_; }

 private:
  class Part;

  DesignPlan plan_;
  DesignTally tally_;
};

}  // namespace talus
