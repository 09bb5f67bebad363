#pragma once
// The number of rocks handed out at a time.

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace talus {

/// The maximum: large enough that handing out and committing a block cost nothing, small enough that all paths of the
/// blocks in progress fit in memory (about 2 MB per block) and that a short campaign keeps every core busy to the end.
/// Blocks of slow rocks are smaller: a stop discards the rest of a block, and a checkpoint waits for whole blocks.
inline constexpr std::uint64_t max_rocks_per_block = 256;

/// The size of the next block: the rocks that take a quarter of a second, at the speed of those before them.
class BlockSize {
 public:
  /// `threads`: working at the same time.
  explicit BlockSize(int threads) : threads_(threads) {}
  void done(std::uint64_t rocks) { done_ += rocks; }
  /// 1 to max_rocks_per_block.
  [[nodiscard]] std::uint64_t next() const {
    constexpr double duration = 0.25;    // [s]
    constexpr std::uint64_t first = 16;  // before the speed is known
    if (done_ == 0) return first;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const double rocks = duration * static_cast<double>(done_) / std::max(seconds * threads_, 1e-9);
    return static_cast<std::uint64_t>(std::clamp(rocks, 1.0, static_cast<double>(max_rocks_per_block)));
  }

 private:
  int threads_;
  std::uint64_t done_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace talus
