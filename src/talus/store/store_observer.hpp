#pragma once
// Keeps the trajectories of a run as bytes in memory, as many as a budget allows.

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "talus/results/record.hpp"
#include "talus/store/byte_blocks.hpp"
#include "talus/store/store_facts.hpp"
#include "talus/store/store_file.hpp"

namespace talus {

/// What a store may have at most.
struct StoreBudget {
  static constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t bytes = no_limit, rocks = no_limit;  // bytes: of the file, about
};

/// The rocks that are kept are the first in the order of place_in_choice() that fit into the budget together. That
/// depends on the rocks alone, not on the order in which they come, or how they are divided among processes.
class StoreObserver : public SummingObserver {
 public:
  static constexpr std::uint64_t no_limit = StoreBudget::no_limit;

  /// To observe the rocks of a model.
  StoreObserver(const StoreBudget& budget, const Model& model);
  /// To merge saved content, without observing rocks.
  explicit StoreObserver(const StoreBudget& budget) : budget_(budget) {}

  [[nodiscard]] bool wants_rows(std::uint64_t rock) const override { return is_wanted(rock); }
  [[nodiscard]] bool wants_pieces() const override { return true; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void save(ByteWriter& out) override;
  void merge_saved(ByteReader& in) override;

  /// Writes the file of these trajectories. `done`: the rocks of the run so far. Throws BadInput if that fails.
  StoreExtent write(const std::filesystem::path& file, std::uint64_t done);

 private:
  class Part;

  [[nodiscard]] std::uint64_t place_of(std::uint64_t rock) const;
  [[nodiscard]] bool is_wanted(std::uint64_t rock) const;
  void add(const StoredRock& rock);
  /// Removes rocks from this place on.
  void drop_from(std::uint64_t place);
  /// Whether the rocks exceed the budget by more than a share of it.
  [[nodiscard]] bool exceeds_budget(double share) const;
  /// Brings the rocks within the budget.
  void settle();
  [[nodiscard]] std::vector<StoredRock> in_order() const;

  StoreBudget budget_;
  std::optional<StoreFacts> facts_;
  std::vector<StoredRock> rocks_;  // in the order in which they came
  ByteBlocks bytes_;               // theirs
  std::uint64_t cost_ = 0;
  // Rocks from this place on do not fit; other threads read it while they simulate.
  std::atomic<std::uint64_t> limit_ = no_limit;
};

}  // namespace talus
