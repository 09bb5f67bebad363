#pragma once
// How many rocks are handed out at a time.

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace talus {

/// At most: large enough that handing out and committing a block cost nothing, small enough that all paths of the
/// blocks under way fit in memory (about 2 MB a block) and that a short campaign keeps every core busy to the end.
/// Blocks of rocks that take long are smaller: what comes after a rock that is left on its way is lost with it, and a
/// checkpoint waits for whole blocks.
inline constexpr std::uint64_t max_rocks_per_block = 256;

/// How many rocks a block gets: as many as are done in a quarter of a second, by what those before them took.
class BlockSize {
 public:
  /// `threads`: that work at the same time.
  explicit BlockSize(int threads) : threads_(threads) {}
  void done(std::uint64_t rocks) { done_ += rocks; }
  /// 1 to max_rocks_per_block.
  [[nodiscard]] std::uint64_t next() const {
    constexpr double wanted = 0.25;      // [s]
    constexpr std::uint64_t first = 16;  // as long as nothing is known of the rocks
    if (done_ == 0) return first;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const double rocks = wanted * static_cast<double>(done_) / std::max(seconds * threads_, 1e-9);
    return static_cast<std::uint64_t>(std::clamp(rocks, 1.0, static_cast<double>(max_rocks_per_block)));
  }

 private:
  int threads_;
  std::uint64_t done_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace talus
