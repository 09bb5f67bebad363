#pragma once
// Counts for the design of barriers: of every line the first crossing of each rock, at whatever height.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "talus/results/design_plan.hpp"
#include "talus/results/record.hpp"
#include "talus/statistics/quantile_sketch.hpp"

namespace talus {

/// What is known of a rock where it crosses a line.
enum class CrossingQuantity : std::uint32_t {
  energy_translational,
  energy_total,
  velocity,
  height,
  radius
};  // [J] [m/s] [m]
inline constexpr std::size_t crossing_quantity_count = 5;

/// One value a rock of each quantity.
struct SectionTally {
  explicit SectionTally(std::uint64_t planned_rocks);
  void add(const std::array<double, crossing_quantity_count>& values);
  void merge(const SectionTally& other);
  [[nodiscard]] std::uint64_t rocks() const { return sketches.front().count(); }
  [[nodiscard]] const QuantileSketch& of(CrossingQuantity quantity) const {
    return sketches[static_cast<std::size_t>(quantity)];
  }

  std::vector<QuantileSketch> sketches;  // in the order of the quantities
};

/// What rocks ask of a kit, one by one: how many need which of the plan's heights and energies at the least. From this
/// follows, without any error, how many a kit of a height and an energy catches.
class KitDemands {
 public:
  KitDemands(std::size_t heights, std::size_t energies) : columns_(energies + 1), counts_((heights + 1) * columns_) {}
  /// Indices of the least height and energy that suffice; as many as there are where none does.
  void add(std::size_t height, std::size_t energy) { ++counts_[height * columns_ + energy]; }
  [[nodiscard]] std::uint64_t at(std::size_t height, std::size_t energy) const {
    return counts_[height * columns_ + energy];
  }
  [[nodiscard]] std::uint64_t rocks() const;
  /// That a kit of this height and energy catches.
  [[nodiscard]] std::uint64_t caught(std::size_t height, std::size_t energy) const;
  /// That are too high for this height, whatever the energy.
  [[nodiscard]] std::uint64_t above(std::size_t height) const;

  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in);

 private:
  std::size_t columns_;
  std::vector<std::uint64_t> counts_;
};

/// In memory that grows with sections, not with rocks: sketches hold values up to 100,000 rocks of the campaign and
/// counts in bins beyond (statistics/quantile_sketch.hpp), about half a megabyte a section.
struct DesignTally {
  struct Line {
    std::vector<SectionTally> sections;
    KitDemands demands;        // of the rocks that count (DesignPlan::protect)
    std::uint64_t beside = 0;  // rocks that count and never cross this line before they reach what is to be protected
  };

  DesignTally(const DesignPlan& plan, std::uint64_t planned_rocks);
  void save(ByteWriter& out) const;
  void merge_saved(ByteReader& in);

  std::uint64_t rocks = 0;  // all that were seen
  std::vector<Line> lines;
};

/// A rock that crosses a line again, or after it rebounded from it, counts with its first crossing. It counts where it
/// is stopped, too; what it would have done behind a real barrier, nobody knows.
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
