#include "talus/campaign/shard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace talus::shard_test {
namespace {

TEST(Shard, AllShardsHaveEveryRockOnce) {
  for (const std::uint64_t total : {0U, 1U, 2U, 49U, 50U, 51U, 1000U, 4'000'000'000U}) {
    for (const std::uint64_t of : {1U, 2U, 3U, 7U, 64U, 1000U}) {
      std::uint64_t next = 0, least = total, most = 0;
      for (std::uint64_t number = 1; number <= of; ++number) {
        const RockRange rocks = rocks_of({number, of}, total);
        ASSERT_EQ(rocks.first, next);
        ASSERT_LE(rocks.first, rocks.last);
        least = std::min(least, rocks.count());
        most = std::max(most, rocks.count());
        next = rocks.last;
      }
      EXPECT_EQ(next, total);
      EXPECT_LE(most - least, 1U) << total << " over " << of;
    }
  }
}

TEST(Shard, RangesAreThoseOfTheFormula) {
  EXPECT_EQ(rocks_of({1, 3}, 10), (RockRange{0, 3}));
  EXPECT_EQ(rocks_of({2, 3}, 10), (RockRange{3, 6}));
  EXPECT_EQ(rocks_of({3, 3}, 10), (RockRange{6, 10}));
}

TEST(Shard, ProductsOfLargeNumbersDoNotOverflow) {
  constexpr std::uint64_t total = std::numeric_limits<std::uint64_t>::max(), of = 1'000'000'000;
  EXPECT_EQ(rocks_of({of, of}, total).last, total);
  EXPECT_EQ(rocks_of({of / 2, of}, total).last, total / 2);
}

TEST(Shard, IsReadFromText) {
  EXPECT_EQ(shard_from("2/7"), (Shard{2, 7}));
  EXPECT_EQ(shard_from("1/1"), (Shard{1, 1}));
  for (const char* text : {"", "/", "1", "1/", "/1", "0/1", "2/1", "1/0", "1/-1", "-1/1", "1/2/3", " 1/2", "1/2 ",
                           "1.0/2", "1/1000000001", "99999999999999999999/2"}) {
    EXPECT_FALSE(shard_from(text)) << text;
  }
}

}  // namespace
}  // namespace talus::shard_test
