// Sets of cells, against a plain set; their runs as bytes, and back.

#include "talus/store/cell_set.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/dice.hpp"

namespace talus {
namespace {

TEST(CellSet, HasWhatWasAddedAndItsRunsReadBack) {
  testing_tools::Dice dice(8);
  constexpr std::uint32_t count = 300;
  CellSet cells(count);
  for (int trial = 0; trial < 500; ++trial) {
    cells.clear();
    std::set<std::uint32_t> expected;
    for (std::size_t n = dice.below(6); n > 0; --n) {
      const auto first = static_cast<std::uint32_t>(dice.below(count));
      const auto last = static_cast<std::uint32_t>(first + dice.below(count - first));
      cells.add(first, dice.chance(0.5) ? last : first);
      for (std::uint32_t cell = first; cell <= last; ++cell) {
        if (cells.has(cell)) expected.insert(cell);
      }
      EXPECT_TRUE(cells.has(first));
    }
    std::set<std::uint32_t> found;
    std::string bytes;
    put_runs(cells, bytes);
    ByteReader in(bytes);
    read_runs(in, count, [&](std::uint32_t first, std::uint32_t last) {
      EXPECT_TRUE(cells.has_any(first, last));
      for (std::uint32_t cell = first; cell <= last; ++cell) EXPECT_TRUE(found.insert(cell).second);
    });
    in.expect_end();
    EXPECT_EQ(found, expected);
    for (std::uint32_t cell = 0; cell < count; ++cell) EXPECT_EQ(cells.has(cell), expected.contains(cell));
  }
}

TEST(CellSet, RunsBeyondTheGridAreRefused) {
  CellSet cells(100);
  cells.add(90, 99);
  std::string bytes;
  put_runs(cells, bytes);
  ByteReader in(bytes);
  EXPECT_THROW(read_runs(in, 99, [](std::uint32_t, std::uint32_t) {}), BadBytes);
}

}  // namespace
}  // namespace talus
