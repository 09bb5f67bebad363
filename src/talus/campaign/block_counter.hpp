#pragma once
// Which process throws which rocks, where several do: a counter of rocks that all take their blocks from, and the order
// in which their rows are written.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "talus/campaign/block_size.hpp"
#include "talus/campaign/block_worker.hpp"
#include "talus/campaign/shard.hpp"

namespace talus {

/// Hands out the rocks from the first to the last, in blocks that grow smaller towards the end, so that all come to
/// theirs at about the same time, and that hold no more than a moment's work. Each rank has a few blocks before it at a
/// time: one for each of its threads to work on, and one to begin with while the next is on its way. Of blocks that
/// came back before those that precede them it may have a few more.
class BlockCounter {
 public:
  /// `threads` of each rank.
  BlockCounter(const RockRange& rocks, std::span<const int> threads);

  /// A block for this rank; nothing if it has enough, or none is left.
  [[nodiscard]] std::optional<RockRange> take(std::size_t rank);
  /// With so many rocks done. Expects that the rank was given one that did not come back yet.
  void came_back(std::size_t rank, std::uint64_t rocks);
  /// All blocks before one that came back have come back, too.
  void is_in_order(std::size_t rank);

  /// Rocks that were not handed out.
  [[nodiscard]] std::uint64_t left() const { return left_.count(); }
  /// Every block that was handed out has come back.
  [[nodiscard]] bool is_quiet() const { return under_way_ == 0; }

 private:
  static constexpr std::uint64_t blocks_a_thread = 2;
  static constexpr std::uint64_t blocks_that_wait = 2;  // for others: so many times those of its threads
  static constexpr std::uint64_t least_rocks = 16;

  struct Rank {
    std::uint64_t most = 0, has = 0, waiting = 0;  // blocks
  };
  RockRange left_;
  std::vector<Rank> ranks_;
  std::uint64_t most_under_way_ = 0, under_way_ = 0;
  BlockSize size_;
};

/// A block that came from a rank.
struct BlockOfRank {
  std::size_t rank = 0;
  DoneBlock block;
};

/// Blocks that came before those that precede them.
class BlockOrder {
 public:
  explicit BlockOrder(std::uint64_t first_rock) : next_(first_rock) {}

  void add(BlockOfRank came);
  /// The block that follows the last one given, if it is here. None follows a block that was cut short.
  [[nodiscard]] std::optional<BlockOfRank> next();
  /// All rocks before this one were given.
  [[nodiscard]] std::uint64_t next_rock() const { return next_; }
  /// Held in rows of blocks that wait.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  std::uint64_t next_;
  std::map<std::uint64_t, BlockOfRank> waiting_;
  std::size_t bytes_ = 0;
};

}  // namespace talus
