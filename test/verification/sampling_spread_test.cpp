#include "talus/verification/sampling_spread.hpp"
#include "support/places.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "talus/core/random.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/sampling/normal_quantile.hpp"
#include "talus/verification/cases.hpp"
#include "talus/verification/observed.hpp"
#include "talus/verification/printed.hpp"

namespace talus::verification {
namespace {

/// Standard normal numbers.
std::vector<double> normal_numbers(std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t k = 0; k < count; ++k) {
    const double u = uniform_pair(7, k, Stream::spin, 0)[0];
    numbers.push_back(normal_quantile(u, 1 - u));
  }
  return numbers;
}

TEST(SamplingSpread, MeanOfNormalNumbersSpreadsByTheStandardError) {
  const std::vector<double> many = normal_numbers(100'000);
  const SamplingSpread spread(many, 50);
  const Interval interval = *spread.interval(Statistic::mean);
  const double half_width = 2.5758 / std::sqrt(50.0);  // of the central 99 %
  // The quantile at 0.5 % of 4000 samples has a standard error of 1.1e-3 over its density, about 0.011 here.
  EXPECT_NEAR(interval.low, -half_width, 0.04);
  EXPECT_NEAR(interval.high, half_width, 0.04);
  EXPECT_NEAR(*spread.typical(Statistic::mean), 0, 0.02);
}

TEST(SamplingSpread, ContainsTheExpectedShareOfOtherSamples) {
  const std::vector<double> many = normal_numbers(200'000);
  const std::span<const double> all(many);
  const SamplingSpread spread(all.first(100'000), 40);
  for (const Statistic statistic :
       {Statistic::mean, Statistic::standard_deviation, Statistic::median, Statistic::skewness, Statistic::kurtosis}) {
    const Interval interval = *spread.interval(statistic);
    int inside = 0;
    constexpr int samples = 2000;  // of numbers that were not used for the spread
    for (std::size_t k = 0; k < samples; ++k) {
      const Descriptive rows = describe(all.subspan(100'000 + 40 * k, 40));
      inside += interval.contains(*value(rows, statistic)) ? 1 : 0;
    }
    // 99 % of 2000, within four standard errors of both.
    EXPECT_NEAR(inside, 0.99 * samples, 30) << name(statistic);
  }
}

TEST(SamplingSpread, IsReproducible) {
  const std::vector<double> many = normal_numbers(1000);
  const Interval one = *SamplingSpread(many, 20).interval(Statistic::kurtosis);
  const Interval other = *SamplingSpread(many, 20).interval(Statistic::kurtosis);
  EXPECT_EQ(one.low, other.low);
  EXPECT_EQ(one.high, other.high);
}

TEST(SamplingSpread, HasNoKurtosisForSmallSamples) {
  const SamplingSpread spread(normal_numbers(1000), 3);
  EXPECT_TRUE(spread.interval(Statistic::skewness));
  EXPECT_FALSE(spread.interval(Statistic::kurtosis));
}

TEST(BinomialInterval, ContainsTheCentralPart) {
  // 57 of 100 at 0.61; a two-sided interval of 99 % is about 2.58 standard deviations of 4.9 to either side.
  const Interval interval = binomial_interval(100, 0.61);
  EXPECT_TRUE(interval.contains(57));
  EXPECT_NEAR(interval.low, 48, 1);
  EXPECT_NEAR(interval.high, 73, 1);
  EXPECT_FALSE(interval.contains(40));
  EXPECT_FALSE(interval.contains(80));
}

TEST(Statistic, NamesGoBothWays) {
  for (int k = 0; k < statistic_count; ++k) {
    const auto statistic = static_cast<Statistic>(k);
    EXPECT_EQ(statistic_of(name(statistic)), statistic);
  }
  EXPECT_EQ(statistic_of("average"), std::nullopt);
}

// Shows that the test of table 1-3 can fail.

class TutorialSpread : public testing::Test {
 protected:
  static std::vector<double> runouts(std::vector<std::string> settings) {
    const Files files = cases_in(talus::places::in_source("/verification"));
    project::Reading reading = project::read_project_text(
        files.at("1-tutorial-1/scenario-2-2d.toml"), "scenario-2-2d.toml", {std::move(settings), 20'000, std::nullopt});
    return observe(project::build_model(reading.project, reading.warnings), Energies::skip)
        .sample(SampleQuantity::runout_xy_m);
  }
  /// How many of the five statistics of a column of table 1-3, each moved by `shift`, are outside the spread.
  static int outside(const std::vector<double>& many, std::string_view column, double shift = 0) {
    const Files files = cases_in(talus::places::in_source("/verification"));
    const PublishedTable table(files.at("1-tutorial-1/table-1-3.csv"), "table-1-3.csv");
    const SamplingSpread spread(many, 50);
    int count = 0;
    for (const Statistic statistic : {Statistic::mean, Statistic::standard_deviation, Statistic::median,
                                      Statistic::skewness, Statistic::kurtosis}) {
      const double published = table.number(*table.row(name(statistic)), *table.column(column))->value;
      const bool is_place = statistic == Statistic::mean || statistic == Statistic::median;
      count += spread.interval(statistic)->contains(published + (is_place ? shift : 0)) ? 0 : 1;
    }
    return count;
  }
};

TEST_F(TutorialSpread, AcceptsBothPublishedColumns) {
  const std::vector<double> many = runouts({});
  EXPECT_EQ(outside(many, "rocfall3"), 0);
  EXPECT_EQ(outside(many, "rocfall2"), 0);
}

TEST_F(TutorialSpread, RefusesATableThatIsTwoMetresOff) {
  const std::vector<double> many = runouts({});
  EXPECT_GT(outside(many, "rocfall3", 2), 0);
  EXPECT_GT(outside(many, "rocfall3", -2), 0);
  EXPECT_GT(outside(many, "rocfall2", 2), 0);
  EXPECT_GT(outside(many, "rocfall2", -2), 0);
}

TEST_F(TutorialSpread, RefusesAWrongMaterial) {
  const std::vector<double> many = runouts({"material.Type Three.normal_restitution.mean=0.45"});
  EXPECT_GT(outside(many, "rocfall3"), 0);
  EXPECT_GT(outside(many, "rocfall2"), 0);
}

TEST_F(TutorialSpread, RefusesImpactsWithoutRotation) {
  EXPECT_GT(outside(runouts({"analysis.rotation=false"}), "rocfall3"), 0);
}

}  // namespace
}  // namespace talus::verification
