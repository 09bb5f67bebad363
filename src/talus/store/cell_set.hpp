#pragma once
// Cells of a grid by their numbers: a bit for each, and runs of neighbours as bytes.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "talus/core/bytes.hpp"
#include "talus/store/varint.hpp"

namespace talus {

class CellSet {
 public:
  explicit CellSet(std::uint32_t count) : words_((count + 63) / 64) {}

  /// The cells from `first` to `last`.
  void add(std::uint32_t first, std::uint32_t last) {
    low_ = std::min(low_, first / 64);
    high_ = std::max(high_, last / 64);
    for (std::uint32_t word = first / 64; word <= last / 64; ++word) {
      const std::uint32_t from = word == first / 64 ? first % 64 : 0, to = word == last / 64 ? last % 64 : 63;
      words_[word] |= (~std::uint64_t{0} >> (63 - to + from)) << from;
    }
  }
  [[nodiscard]] bool has(std::uint32_t cell) const { return (words_[cell / 64] >> (cell % 64) & 1U) != 0; }
  [[nodiscard]] bool has_any(std::uint32_t first, std::uint32_t last) const {
    while (first <= last && !has(first)) ++first;
    return first <= last;
  }
  void clear() {
    for (std::uint32_t word = low_; word <= high_ && word < words_.size(); ++word) words_[word] = 0;
    low_ = ~std::uint32_t{0};
    high_ = 0;
  }

  /// Calls visit(first, last) for each run of neighbours, ascending.
  template <class Visit>
  void for_runs(const Visit& visit) const {
    const std::uint32_t end = static_cast<std::uint32_t>(words_.size()) * 64;
    for (std::uint32_t cell = std::min(low_, end / 64) * 64; (cell = next(cell, end, 0)) < end;) {
      const std::uint32_t beyond = next(cell, end, ~std::uint64_t{0});
      visit(cell, beyond - 1);
      cell = beyond;
    }
  }

 private:
  /// The first cell from `cell` on whose bit is set; or, with all bits flipped, is not.
  [[nodiscard]] std::uint32_t next(std::uint32_t cell, std::uint32_t end, std::uint64_t flipped) const {
    while (cell < end) {
      const std::uint64_t rest = (words_[cell / 64] ^ flipped) >> (cell % 64);
      if (rest != 0) return cell + static_cast<std::uint32_t>(std::countr_zero(rest));
      cell = (cell / 64 + 1) * 64;
    }
    return end;
  }

  std::vector<std::uint64_t> words_;
  std::uint32_t low_ = ~std::uint32_t{0}, high_ = 0;  // words that may have bits
};

/// Appends the runs: their number, and of each the cells between it and the one before, and its length.
inline void put_runs(const CellSet& cells, std::string& out) {
  std::uint64_t runs = 0;
  cells.for_runs([&](std::uint32_t, std::uint32_t) { ++runs; });
  put_varint(out, runs);
  std::uint32_t next = 0;
  cells.for_runs([&](std::uint32_t first, std::uint32_t last) {
    put_varint(out, first - next);
    put_varint(out, last - first + 1);
    next = last + 1;
  });
}

/// Calls visit(first, last) for each run of what put_runs() wrote of a grid with `count` cells. Throws BadBytes.
template <class Visit>
void read_runs(ByteReader& in, std::uint32_t count, const Visit& visit) {
  std::uint64_t next = 0;
  for (std::uint64_t left = get_varint(in); left > 0; --left) {
    const std::uint64_t gap = get_varint(in), length = get_varint(in);
    expect_bytes(gap <= count && length >= 1 && length <= count && next + gap + length <= count,
                 "the index has cells that the grid does not have");
    visit(static_cast<std::uint32_t>(next + gap), static_cast<std::uint32_t>(next + gap + length - 1));
    next += gap + length;
  }
}

}  // namespace talus
