#include "talus/io/even_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace talus::io {
namespace {

TEST(EvenChoice, IsOfAsManyAsAreWantedAndEvenlySpread) {
  for (const std::uint64_t rocks : {1, 2, 7, 100, 999, 12345}) {
    for (const std::uint64_t wanted : {0, 1, 3, 50, 998, 999, 20000}) {
      const EvenChoice choice(wanted, rocks);
      EXPECT_EQ(choice.count(), std::min<std::uint64_t>(wanted, rocks));
      std::uint64_t chosen = 0;
      for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        EXPECT_EQ(choice.count_before(rock), chosen);
        chosen += choice.contains(rock) ? 1 : 0;
        // Of every beginning of the row its share, to less than one rock.
        const double share = static_cast<double>(choice.count()) / static_cast<double>(rocks);
        EXPECT_LT(std::abs(static_cast<double>(chosen) - share * static_cast<double>(rock + 1)), 1);
      }
      EXPECT_EQ(chosen, choice.count()) << wanted << " of " << rocks;
    }
  }
}

TEST(EvenChoice, HoldsForVeryManyRocks) {
  constexpr std::uint64_t step = 100'000'000, wanted = 10'000, rocks = wanted * step;
  const EvenChoice choice(wanted, rocks);
  for (const std::uint64_t k : {0, 1, 4711, 9999}) {
    EXPECT_EQ(choice.count_before(k * step), k);
    EXPECT_EQ(choice.count_before(k * step + step - 1), k);
    EXPECT_TRUE(choice.contains(k * step + step - 1));
    EXPECT_FALSE(choice.contains(k * step));
    EXPECT_FALSE(choice.contains(k * step + step / 2));
  }
}

}  // namespace
}  // namespace talus::io
