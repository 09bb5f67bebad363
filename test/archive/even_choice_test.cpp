#include "talus/archive/even_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace talus {
namespace {

TEST(EvenChoice, HasTheWantedNumberAndIsEvenlySpread) {
  for (const std::uint64_t rocks : {1, 2, 7, 100, 999, 12345}) {
    for (const std::uint64_t wanted : {0, 1, 3, 50, 998, 999, 20000}) {
      const EvenChoice choice(wanted, rocks);
      EXPECT_EQ(choice.count(), std::min<std::uint64_t>(wanted, rocks));
      std::uint64_t chosen = 0;
      for (std::uint64_t rock = 0; rock < rocks; ++rock) {
        EXPECT_EQ(choice.count_before(rock), chosen);
        chosen += choice.contains(rock) ? 1 : 0;
        // Every leading range has its share to within one rock.
        const double share = static_cast<double>(choice.count()) / static_cast<double>(rocks);
        EXPECT_LT(std::abs(static_cast<double>(chosen) - share * static_cast<double>(rock + 1)), 1);
      }
      EXPECT_EQ(chosen, choice.count()) << wanted << " of " << rocks;
      EXPECT_EQ(choice.count_before(rocks), chosen);
    }
  }
}

TEST(EvenChoice, WorksForVeryManyRocks) {
  // The maximum of a project; and so many that the product of rocks and wanted has 80 bits.
  constexpr std::uint64_t rocks = 1'000'000'000'000, wanted = rocks - 1;
  const EvenChoice choice(wanted, rocks);
  EXPECT_EQ(choice.count_before(rocks), wanted);
  std::uint64_t left_out = 0;
  constexpr std::uint64_t some = 100'000;
  for (std::uint64_t rock = rocks - some; rock < rocks; ++rock) left_out += choice.contains(rock) ? 0 : 1;
  EXPECT_EQ(choice.count_before(rocks) - choice.count_before(rocks - some), some - left_out);
  EXPECT_LE(left_out, 1U);

  constexpr std::uint64_t step = 100'000'000, few = 10'000;
  const EvenChoice of_few(few, few * step);
  for (const std::uint64_t k : {0, 1, 4711, 9999}) {
    EXPECT_EQ(of_few.count_before(k * step), k);
    EXPECT_EQ(of_few.count_before((k + 1) * step), k + 1);
  }
}

// Cells of a grid of 100 columns are released row by row, one rock each, and one in a hundred rocks is chosen: with a
// fixed place in each interval all would come from one column.
TEST(EvenChoice, DoesNotInterfereWithPeriodicReleases) {
  constexpr std::uint64_t columns = 100, wanted = 2000, rocks = wanted * columns;
  const EvenChoice choice(wanted, rocks);
  std::vector<double> of_column(columns);
  for (std::uint64_t rock = 0; rock < rocks; ++rock) of_column[rock % columns] += choice.contains(rock) ? 1 : 0;
  constexpr double expected = static_cast<double>(wanted) / columns;
  double chi_squared = 0;
  for (const double count : of_column) chi_squared += (count - expected) * (count - expected) / expected;
  // 99 degrees of freedom: mean 99, standard deviation sqrt(2 * 99) = 14. The limits are four of these either way; a
  // fixed place gives 198,000, and consecutive columns 0.
  EXPECT_NEAR(chi_squared, 99, 56);
}

}  // namespace
}  // namespace talus
