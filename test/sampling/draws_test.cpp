#include "talus/sampling/draws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sampling/goodness_of_fit.hpp"

namespace talus::draws_test {
namespace {

double identity(double u) { return u; }

TEST(DrawsMonteCarlo, AreTheUniformNumbersOfTheRock) {
  const SamplingPlan plan{.seed = 42, .method = SamplingMethod::monte_carlo, .first = 0, .count = 10};
  const Draws draws(plan, 3);
  EXPECT_EQ(draws.rock(), 3u);
  EXPECT_EQ(draws.pair(Stream::size, 2), uniform_pair(42, 3, Stream::size, 2));
  EXPECT_EQ(draws.one(Stream::size, 2), uniform_pair(42, 3, Stream::size, 2)[0]);
}

TEST(DrawsLatinHypercube, HitEachCellExactlyOnce) {
  for (const std::uint64_t count : {1u, 2u, 7u, 50u, 64u, 1000u}) {
    const SamplingPlan plan{.seed = 9, .method = SamplingMethod::latin_hypercube, .first = 0, .count = count};
    for (const Stream stream : {Stream::release_position, Stream::restitution, Stream::slope_vertex}) {
      for (const std::uint32_t index : {0u, 1u, 37u}) {
        for (const std::size_t part : {0u, 1u}) {
          std::vector<int> hits(count);
          for (std::uint64_t rock = 0; rock < count; ++rock) {
            const double u = Draws(plan, rock).pair(stream, index)[part];
            ASSERT_GT(u, 0);
            ASSERT_LT(u, 1);
            ++hits[static_cast<std::size_t>(u * static_cast<double>(count))];
          }
          for (std::uint64_t cell = 0; cell < count; ++cell) {
            ASSERT_EQ(hits[cell], 1) << "cell " << cell << " of " << count << ", index " << index << ", part " << part;
          }
        }
      }
    }
  }
}

TEST(DrawsLatinHypercube, StratifiesTheRocksOfASeederWithAPermutationPerSeeder) {
  const SamplingPlan first{.seed = 9, .method = SamplingMethod::latin_hypercube, .first = 0, .count = 100};
  const SamplingPlan second{.seed = 9, .method = SamplingMethod::latin_hypercube, .first = 100, .count = 100};
  std::vector<int> hits(100);
  int agreements = 0;
  for (std::uint64_t rock = 0; rock < 100; ++rock) {
    const auto cell = static_cast<std::size_t>(100 * Draws(second, 100 + rock).one(Stream::size));
    ++hits[cell];
    agreements += cell == static_cast<std::size_t>(100 * Draws(first, rock).one(Stream::size));
  }
  EXPECT_EQ(hits, std::vector<int>(100, 1));
  EXPECT_LT(agreements, 10) << "two permutations agree in one place on average";
}

// The reason to stratify: the standard error of the mean of u is 1 / sqrt(12 n^3) instead of 1 / sqrt(12 n).
TEST(DrawsLatinHypercube, HasAMuchSmallerErrorOfTheMeanThanMonteCarlo) {
  constexpr std::uint64_t count = 1000;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SamplingPlan plan{.seed = seed, .method = SamplingMethod::latin_hypercube, .first = 0, .count = count};
    double sum = 0;
    for (std::uint64_t rock = 0; rock < count; ++rock) sum += Draws(plan, rock).one(Stream::friction);
    EXPECT_NEAR(sum / count, 0.5, 5 / std::sqrt(12.0 * count * count * count)) << "seed " << seed;
  }
}

// A rock's cells in different streams must be independent, or the hypercube is a diagonal.
TEST(DrawsLatinHypercube, CombinesTheCellsOfDifferentNumbersAtRandom) {
  constexpr std::uint64_t count = 40'000;
  const SamplingPlan plan{.seed = 3, .method = SamplingMethod::latin_hypercube, .first = 0, .count = count};
  std::vector<double> with_partner, with_stream, with_index;
  for (std::uint64_t rock = 0; rock < count; ++rock) {
    const Draws draws(plan, rock);
    const auto [u, v] = draws.pair(Stream::restitution);
    const double row = std::floor(u * 20);
    const auto square = [&](double other) { return (row * 20 + std::floor(other * 20) + 0.5) / 400; };
    with_partner.push_back(square(v));
    with_stream.push_back(square(draws.one(Stream::friction)));
    with_index.push_back(square(draws.one(Stream::restitution, 1)));
  }
  for (const auto& squares : {with_partner, with_stream, with_index}) {
    EXPECT_GT(testing_tools::chi_square_probability(squares, identity, 400), 0.01);
  }
}

}  // namespace
}  // namespace talus::draws_test
