#pragma once
// Distributes the rocks of a campaign among several processes: a counter from which all take their blocks, and the
// order in which their rows are written.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "talus/campaign/block_size.hpp"
#include "talus/campaign/block_worker.hpp"
#include "talus/campaign/shard.hpp"

namespace talus {

/// Hands out the rocks from the first to the last. Blocks take a fraction of a second, and become smaller towards the
/// end so that all ranks finish at about the same time. A rank has at most two blocks per thread: one to work on, and
/// one to start while the next is sent. It gets no new ones while too many of its finished blocks wait for blocks
/// before them.
class BlockCounter {
 public:
  /// `threads`: of each rank.
  BlockCounter(const RockRange& rocks, std::span<const int> threads);

  /// A block for this rank; nullopt if it has enough, or no rocks remain.
  [[nodiscard]] std::optional<RockRange> take(std::size_t rank);
  /// A rank has returned a block, with this many rocks done. Expects that it has one.
  void came_back(std::size_t rank, std::uint64_t rocks);
  /// All blocks before one that this rank has returned have also been returned.
  void is_in_order(std::size_t rank);

  /// Rocks that have not been handed out.
  [[nodiscard]] std::uint64_t left() const { return left_.count(); }
  /// Whether every block that was handed out has been returned.
  [[nodiscard]] bool is_quiet() const { return under_way_ == 0; }

 private:
  static constexpr std::uint64_t blocks_per_thread = 2;
  static constexpr std::uint64_t most_waiting = 2;  // finished blocks that wait, as a multiple of `most`
  static constexpr std::uint64_t least_rocks = 16;

  struct Rank {
    std::uint64_t most = 0, has = 0, waiting = 0;  // blocks
  };
  RockRange left_;
  std::vector<Rank> ranks_;
  std::uint64_t most_under_way_ = 0, under_way_ = 0;
  BlockSize size_;
};

/// A finished block, and the rank that returned it.
struct BlockOfRank {
  std::size_t rank = 0;
  DoneBlock block;
};

/// Puts finished blocks back into the order of the rocks.
class BlockOrder {
 public:
  explicit BlockOrder(std::uint64_t first_rock) : next_(first_rock) {}

  void add(BlockOfRank came);
  /// The block after the last one returned here, if it has arrived. There is none after a block that was cut short.
  [[nodiscard]] std::optional<BlockOfRank> next();
  /// All rocks before this one have been returned by next().
  [[nodiscard]] std::uint64_t next_rock() const { return next_; }
  /// Of the rows of waiting blocks.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  std::uint64_t next_;
  std::map<std::uint64_t, BlockOfRank> waiting_;
  std::size_t bytes_ = 0;
};

}  // namespace talus
