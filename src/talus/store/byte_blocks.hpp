#pragma once
// Keeps pieces of bytes in large blocks of memory.

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

namespace talus {

/// Many pieces of their own, made by one thread and freed by another, would take twice the room.
class ByteBlocks {
 public:
  static constexpr std::size_t block_size = std::size_t{1} << 20;  // [bytes]

  /// Copies a piece, and returns where it is from now on.
  const char* add(const char* bytes, std::size_t size) {
    while (current_ < blocks_.size() && blocks_[current_].size - used_ < size) {
      ++current_;
      used_ = 0;
    }
    if (current_ == blocks_.size()) {
      const std::size_t room = std::max(size, block_size);
      blocks_.push_back({std::make_unique_for_overwrite<char[]>(room), room});
    }
    char* const place = blocks_[current_].bytes.get() + used_;
    if (size > 0) std::memmove(place, bytes, size);
    used_ += size;
    return place;
  }

  /// Begins at the start of the memory again. The pieces, or some of them, can be added again in the order in which
  /// they were: each is read before something is written over it, since it never moves back.
  void rewind() { current_ = used_ = 0; }

 private:
  struct Block {
    std::unique_ptr<char[]> bytes;
    std::size_t size;
  };
  std::vector<Block> blocks_;
  std::size_t current_ = 0, used_ = 0;  // block and bytes of it, where the next piece goes
};

}  // namespace talus
