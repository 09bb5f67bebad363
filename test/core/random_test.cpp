#include "talus/core/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "sampling/goodness_of_fit.hpp"

namespace talus::random_test {
namespace {

using testing_tools::chi_square_probability;
using testing_tools::kolmogorov_distance;
using testing_tools::kolmogorov_probability;

double identity(double u) { return u; }

// The known-answer vectors that Random123 publishes for philox4x32 with ten rounds (tests/kat_vectors).
TEST(RandomPhilox, GivesTheKnownAnswers) {
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox(0, 0, 0, 0), (Words{0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u}));
  const std::uint64_t ones = ~std::uint64_t{0};
  EXPECT_EQ(philox(ones, ones, 0xffffffffu, 0xffffffffu), (Words{0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu}));
  EXPECT_EQ(philox(0x299f31d0'a4093822u, 0x85a308d3'243f6a88u, 0x13198a2eu, 0x03707344u),
            (Words{0xd16cfe09u, 0x94fdccebu, 0x5001e420u, 0x24126ea1u}));
}

// The upper 52 of the bits 6627e8d5'e169c58d and bc57ac4c'9b00dbd8, each in the middle of its cell.
TEST(RandomUniform, IsMadeOfTheKnownAnswer) {
  const auto u = uniform_pair(0, 0, Stream::release_position, 0);
  EXPECT_EQ(u[0], (static_cast<double>(0x6627e8d5e169cu) + 0.5) * 0x1p-52);
  EXPECT_EQ(u[1], (static_cast<double>(0xbc57ac4c9b00du) + 0.5) * 0x1p-52);
}

// counter = (rock low, rock high, stream, index), key = (seed low, seed high): the results of a seed must not change.
TEST(RandomUniform, UsesRockStreamAndIndexAsCounterAndTheSeedAsKey) {
  const auto u =
      uniform_pair(0x299f31d0'a4093822u, 0x85a308d3'243f6a88u, static_cast<Stream>(0x13198a2eu), 0x03707344u);
  EXPECT_EQ(u[0], (static_cast<double>(0xd16cfe0994fdcu) + 0.5) * 0x1p-52);
  EXPECT_EQ(u[1], (static_cast<double>(0x5001e42024126u) + 0.5) * 0x1p-52);
}

TEST(RandomUniform, FillsTheIntervalEvenly) {
  std::vector<double> first, second;
  for (std::uint64_t rock = 0; rock < 100'000; ++rock) {
    const auto u = uniform_pair(1, rock, Stream::restitution, 0);
    first.push_back(u[0]);
    second.push_back(u[1]);
  }
  for (const auto& draws : {first, second}) {
    EXPECT_GT(kolmogorov_probability(kolmogorov_distance(draws, identity), draws.size()), 0.01);
    EXPECT_GT(chi_square_probability(draws, identity, 1000), 0.01);
  }
  for (double& u : first) u = std::pow(u, 1.02);
  EXPECT_LT(kolmogorov_probability(kolmogorov_distance(first, identity), first.size()), 1e-3)
      << "the test must be able to fail";
}

TEST(RandomUniform, IsNeverZeroOrOne) {
  for (std::uint64_t rock = 0; rock < 100'000; ++rock) {
    for (const double u : uniform_pair(7, rock, Stream::spin, 3)) {
      ASSERT_GE(u, 0x1p-53);
      ASSERT_LE(u, 1 - 0x1p-53);
    }
  }
}

// Two sequences as coordinates in a 30 x 30 chequerboard: independent ones fill it evenly.
double chequerboard_probability(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr int cells = 30;
  std::vector<double> square;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double row = std::floor(a[i] * cells), column = std::floor(b[i] * cells);
    square.push_back((row * cells + column + 0.5) / (cells * cells));
  }
  return chi_square_probability(square, identity, cells * cells);
}

TEST(RandomUniform, StreamsIndicesSeedsRocksAndBothNumbersOfAPairAreIndependent) {
  std::vector<double> base, partner, stream, index, seed, high_seed, rock, high_rock;
  for (std::uint64_t i = 0; i < 90'000; ++i) {
    const auto u = uniform_pair(1, i, Stream::friction, 0);
    base.push_back(u[0]);
    partner.push_back(u[1]);
    stream.push_back(uniform_pair(1, i, Stream::rolling_friction, 0)[0]);
    index.push_back(uniform_pair(1, i, Stream::friction, 1)[0]);
    seed.push_back(uniform_pair(2, i, Stream::friction, 0)[0]);
    high_seed.push_back(uniform_pair(1 + (std::uint64_t{1} << 32), i, Stream::friction, 0)[0]);
    rock.push_back(uniform_pair(1, i + 1, Stream::friction, 0)[0]);
    high_rock.push_back(uniform_pair(1, i + (std::uint64_t{1} << 32), Stream::friction, 0)[0]);
  }
  EXPECT_GT(chequerboard_probability(base, partner), 0.005);
  EXPECT_GT(chequerboard_probability(base, stream), 0.005);
  EXPECT_GT(chequerboard_probability(base, index), 0.005);
  EXPECT_GT(chequerboard_probability(base, seed), 0.005);
  EXPECT_GT(chequerboard_probability(base, high_seed), 0.005);
  EXPECT_GT(chequerboard_probability(base, rock), 0.005);
  EXPECT_GT(chequerboard_probability(base, high_rock), 0.005);

  std::vector<double> dependent = partner;
  for (std::size_t i = 0; i < base.size(); i += 20) dependent[i] = base[i];
  EXPECT_LT(chequerboard_probability(base, dependent), 1e-6) << "one copied value in twenty must be detected";
}

TEST(RandomPermutation, IsABijectionForEveryCount) {
  for (const std::uint64_t count :
       {1u,  2u,   3u,   4u,   5u,   7u,   8u,   9u,   15u,   16u,   17u,   31u,   33u,   50u,    63u,   64u,
        65u, 100u, 127u, 128u, 129u, 255u, 256u, 257u, 1000u, 1023u, 1024u, 1025u, 4097u, 20000u, 65537u}) {
    for (const std::uint32_t key : {0u, 1u, 0xDEADBEEFu}) {
      std::vector<bool> is_taken(count);
      for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t place = permuted(i, count, {key, 5});
        ASSERT_LT(place, count);
        ASSERT_FALSE(is_taken[place]) << count << " places, key " << key << ": " << place << " is taken twice";
        is_taken[place] = true;
      }
    }
  }
}

TEST(RandomPermutation, StaysInRangeForHugeCounts) {
  for (const std::uint64_t count : {(std::uint64_t{1} << 40) + 1, std::uint64_t{1} << 62, ~std::uint64_t{0}}) {
    std::set<std::uint64_t> places;
    for (std::uint64_t i = 0; i < 1000; ++i) {
      const std::uint64_t place = permuted(i, count, {1, 2});
      ASSERT_LT(place, count);
      places.insert(place);
    }
    EXPECT_EQ(places.size(), 1000u) << count;
  }
}

TEST(RandomPermutation, DependsOnItsKeyAndUsesAllPlacesEqually) {
  // The place of element 17 of 100 with 10,000 keys.
  std::vector<double> places;
  for (std::uint32_t key = 0; key < 10'000; ++key) {
    places.push_back((static_cast<double>(permuted(17, 100, {key, 0})) + 0.5) / 100);
  }
  EXPECT_GT(chi_square_probability(places, identity, 100), 0.01);
  int agreements = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) agreements += permuted(i, 1000, {0, 1}) == permuted(i, 1000, {0, 2});
  EXPECT_LT(agreements, 10) << "two permutations agree in one place on average";
}

}  // namespace
}  // namespace talus::random_test
