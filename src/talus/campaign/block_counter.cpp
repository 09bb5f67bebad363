#include "talus/campaign/block_counter.hpp"

#include <algorithm>
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

BlockCounter::BlockCounter(const RockRange& rocks, std::span<const int> threads) : left_(rocks) {
  for (const int each : threads) {
    ranks_.push_back({blocks_a_thread * static_cast<std::uint64_t>(std::max(1, each)), 0});
    most_under_way_ += ranks_.back().most;
  }
}

std::optional<RockRange> BlockCounter::take(std::size_t rank) {
  Rank& asking = ranks_[rank];
  if (asking.has == asking.most || left_.count() == 0) return std::nullopt;
  // Of what is left, a half is divided among all blocks that may be under way.
  const std::uint64_t share = left_.count() / (2 * most_under_way_);
  const std::uint64_t count = std::min(left_.count(), std::clamp(share, least_rocks, rocks_a_block));
  const RockRange block{left_.first, left_.first + count};
  left_.first = block.last;
  ++asking.has;
  ++under_way_;
  return block;
}

void BlockCounter::came_back(std::size_t rank) {
  TALUS_PROMISE(ranks_[rank].has > 0, "a block comes back that was not handed out");
  --ranks_[rank].has;
  --under_way_;
}

void BlockOrder::add(DoneBlock block) {
  TALUS_PROMISE(block.rocks.first >= next_, "a block comes that was given before");
  bytes_ += bytes_of(block);
  const std::uint64_t first = block.rocks.first;
  waiting_.emplace(first, std::move(block));
}

std::optional<DoneBlock> BlockOrder::next() {
  const auto found = waiting_.find(next_);
  if (found == waiting_.end()) return std::nullopt;
  DoneBlock block = std::move(found->second);
  waiting_.erase(found);
  bytes_ -= bytes_of(block);
  next_ = block.rocks.last;
  return block;
}

}  // namespace talus
