#include "talus/campaign/block_counter.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "talus/core/check.hpp"

namespace talus {

namespace {

std::size_t bytes_of(const DoneBlock& block) {
  std::size_t bytes = 0;
  for (const std::string& text : block.texts) bytes += text.size();
  return bytes;
}

}  // namespace

BlockCounter::BlockCounter(const RockRange& rocks, std::span<const int> threads)
    : left_(rocks), size_(std::accumulate(threads.begin(), threads.end(), 0)) {
  for (const int each : threads) {
    ranks_.push_back({blocks_per_thread * static_cast<std::uint64_t>(std::max(1, each)), 0, 0});
    most_under_way_ += ranks_.back().most;
  }
}

std::optional<RockRange> BlockCounter::take(std::size_t rank) {
  Rank& asking = ranks_[rank];
  if (asking.has == asking.most || left_.count() == 0) return std::nullopt;
  if (asking.waiting >= most_waiting * asking.most) return std::nullopt;
  // Half of the remaining rocks are divided among all blocks that may be handed out at a time.
  const std::uint64_t share = left_.count() / (2 * most_under_way_);
  const std::uint64_t count =
      std::min({left_.count(), std::clamp(share, least_rocks, max_rocks_per_block), size_.next()});
  const RockRange block{left_.first, left_.first + count};
  left_.first = block.last;
  ++asking.has;
  ++under_way_;
  return block;
}

void BlockCounter::came_back(std::size_t rank, std::uint64_t rocks) {
  TALUS_PROMISE(ranks_[rank].has > 0, "only a block that was handed out comes back");
  --ranks_[rank].has;
  ++ranks_[rank].waiting;
  --under_way_;
  size_.done(rocks);
}

void BlockCounter::is_in_order(std::size_t rank) {
  TALUS_PROMISE(ranks_[rank].waiting > 0, "only a block that came back is in order");
  --ranks_[rank].waiting;
}

void BlockOrder::add(BlockOfRank came) {
  TALUS_PROMISE(came.block.rocks.first >= next_, "a block comes back once");
  bytes_ += bytes_of(came.block);
  const std::uint64_t first = came.block.rocks.first;
  waiting_.emplace(first, std::move(came));
}

std::optional<BlockOfRank> BlockOrder::next() {
  const auto found = waiting_.find(next_);
  if (found == waiting_.end()) return std::nullopt;
  BlockOfRank came = std::move(found->second);
  waiting_.erase(found);
  bytes_ -= bytes_of(came.block);
  next_ = came.block.rocks.last;
  return came;
}

}  // namespace talus
