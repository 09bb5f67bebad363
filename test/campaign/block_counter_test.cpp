#include "talus/campaign/block_counter.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <thread>
#include <vector>

#include "support/dice.hpp"

namespace talus::block_counter_test {
namespace {

using testing_tools::Dice;

TEST(BlockCounter, HandsOutEveryRockOnceInOrder) {
  Dice dice(5);
  for (const std::uint64_t last : {100ULL, 117ULL, 5000ULL, 100000ULL}) {
    const int threads[] = {1, 4, 2};
    BlockCounter counter({100, last}, threads);
    std::uint64_t next = 100;
    std::vector<std::size_t> under_way;
    while (counter.left() > 0 || !counter.is_quiet()) {
      const std::size_t rank = dice.below(3);
      if (const auto block = counter.take(rank)) {
        EXPECT_EQ(block->first, next);
        EXPECT_GT(block->count(), 0U);
        EXPECT_LE(block->count(), max_rocks_per_block);
        next = block->last;
        under_way.push_back(rank);
      } else if (!under_way.empty()) {
        const std::size_t which = dice.below(under_way.size());
        counter.came_back(under_way[which], 20);
        counter.is_in_order(under_way[which]);
        under_way.erase(under_way.begin() + static_cast<std::ptrdiff_t>(which));
      }
      EXPECT_EQ(counter.is_quiet(), under_way.empty());
    }
    EXPECT_EQ(next, last);
  }
}

TEST(BlockCounter, LimitsTheBlocksOfARank) {
  const int threads[] = {1, 3};
  BlockCounter counter({0, 1'000'000}, threads);
  int first = 0, second = 0;
  while (counter.take(0)) ++first;
  while (counter.take(1)) ++second;
  EXPECT_EQ(first, 2);
  EXPECT_EQ(second, 6);
  counter.came_back(1, 16);
  EXPECT_FALSE(counter.take(0));
  EXPECT_TRUE(counter.take(1));
}

// A rank's finished blocks are kept in memory while another rank works on a block before them: their number is limited.
TEST(BlockCounter, LetsARankBeAheadOfTheOthersByAFewBlocks) {
  const int threads[] = {1, 1};
  BlockCounter counter({0, 1'000'000}, threads);
  ASSERT_TRUE(counter.take(0));
  int ahead = 0;
  for (; counter.take(1); ++ahead) counter.came_back(1, 16);
  EXPECT_EQ(ahead, 4);
  EXPECT_FALSE(counter.is_quiet());
  counter.is_in_order(1);
  EXPECT_TRUE(counter.take(1));
}

TEST(BlockCounter, GivesSmallBlocksOfSlowRocks) {
  const int threads[] = {1, 1};
  BlockCounter counter({0, 1'000'000}, threads);
  EXPECT_EQ(counter.take(0)->count(), 16U);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  counter.came_back(0, 2);  // at most 5 rocks per second and thread: one in a quarter of a second
  EXPECT_EQ(counter.take(0)->count(), 1U);
}

// The last blocks are small, so that no rank waits long for another.
TEST(BlockCounter, GivesSmallBlocksTowardsTheEnd) {
  const int threads[] = {2, 2};
  BlockCounter counter({0, 10000}, threads);
  std::vector<std::uint64_t> sizes;
  for (std::size_t rank = 0; counter.left() > 0; rank = 1 - rank) {
    const auto block = counter.take(rank);
    ASSERT_TRUE(block);
    sizes.push_back(block->count());
    counter.came_back(rank, 1'000'000'000);  // fast rocks, so that these are no reason for small blocks
    counter.is_in_order(rank);
  }
  EXPECT_EQ(sizes.front(), 16U);  // the speed is not known yet
  EXPECT_EQ(sizes[1], max_rocks_per_block);
  EXPECT_LE(sizes.back(), 16U);
  for (std::size_t k = 2; k < sizes.size(); ++k) EXPECT_LE(sizes[k], sizes[k - 1]);
  EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0}), 10000U);
}

BlockOfRank block(std::uint64_t first, std::uint64_t last) {
  return {first, {{first, last}, {std::to_string(first) + "\n", ""}}};
}

TEST(BlockOrder, ReturnsBlocksInTheOrderOfTheirRocks) {
  BlockOrder order(10);
  EXPECT_FALSE(order.next());
  order.add(block(30, 35));
  order.add(block(20, 30));
  EXPECT_FALSE(order.next());
  EXPECT_EQ(order.bytes(), 6U);
  EXPECT_EQ(order.next_rock(), 10U);
  order.add(block(10, 20));
  std::string text;
  while (const auto next = order.next()) {
    EXPECT_EQ(next->rank, next->block.rocks.first);
    text += next->block.texts[0];
  }
  EXPECT_EQ(text, "10\n20\n30\n");
  EXPECT_EQ(order.next_rock(), 35U);
  EXPECT_EQ(order.bytes(), 0U);
}

TEST(BlockOrder, EndsAtABlockThatWasCutShort) {
  BlockOrder order(0);
  order.add(block(20, 30));
  order.add(block(0, 7));  // of 20 rocks
  EXPECT_TRUE(order.next());
  EXPECT_FALSE(order.next());
  EXPECT_EQ(order.next_rock(), 7U);
}

}  // namespace
}  // namespace talus::block_counter_test
