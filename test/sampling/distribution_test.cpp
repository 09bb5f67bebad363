#include "talus/sampling/distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/exponential.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/distributions/uniform.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "sampling/goodness_of_fit.hpp"
#include "talus/sampling/draws.hpp"
#include "talus/sampling/normal_quantile.hpp"

namespace talus::distribution_test {
namespace {

using testing_tools::chi_square_probability;
using testing_tools::kolmogorov_distance;
using testing_tools::kolmogorov_probability;
using enum DistributionKind;
using Function = std::function<double(double)>;

constexpr std::size_t draw_count = 40'000;
constexpr double smallest_u = 0x1p-53;
constexpr double largest_u = 1 - 0x1p-53;

std::vector<double> draws_of(const Sampler& sampler, std::uint64_t seed = 1) {
  const SamplingPlan plan{.seed = seed, .method = SamplingMethod::monte_carlo, .first = 0, .count = draw_count};
  std::vector<double> draws;
  for (std::uint64_t rock = 0; rock < draw_count; ++rock) {
    draws.push_back(sampler.draw(Draws(plan, rock).one(Stream::restitution)));
  }
  return draws;
}

template <class Law>
Function distribution_function(Law law) {
  return [law](double x) { return cdf(law, x); };
}

// A gamma or an exponential distribution has no values below its start, where Boost refuses to evaluate it.
template <class Law>
Function starting_at(double start, Law law) {
  return [=](double x) { return x <= start ? 0.0 : cdf(law, x - start); };
}

Function truncated(Function F, double a, double b) {
  return [=, Fa = F(a), Fb = F(b)](double x) { return (F(x) - Fa) / (Fb - Fa); };
}

struct Fit {
  std::string name;
  Distribution given;
  Bounds bounds;
  Function F;         // written with the literal parameters, not with Talus's own
  Distribution near;  // a slightly wrong one, which the same test must refuse
};

void PrintTo(const Fit& fit, std::ostream* out) { *out << fit.name; }

std::vector<Fit> fits() {
  using namespace boost::math;
  const Bounds any;
  const auto with = [](double m, DistributionKind kind, std::optional<double> s, std::optional<double> rel_min,
                       std::optional<double> rel_max) {
    return Distribution{m, kind, s, rel_min, rel_max};
  };
  // Mean 2 and standard deviation 1: variance of the logarithm ln(5/4), gamma of shape 4 and scale 1/2.
  const double log_variance = std::log(1.25);
  const lognormal_distribution<> log_law(std::log(2.0) - log_variance / 2, std::sqrt(log_variance));
  // Mean 0.4 and standard deviation 0.2 in [0, 1]: alpha + beta = 0.4 x 0.6 / 0.04 - 1 = 5.
  const beta_distribution<> beta_law(2, 3);
  const Function unit_beta = [=](double x) { return cdf(beta_law, std::clamp((x - 10) / 2, 0.0, 1.0)); };
  return {
      {"normal", with(0.5, normal, 0.03, {}, {}), any, distribution_function(normal_distribution<>(0.5, 0.03)),
       with(0.5, normal, 0.0315, {}, {})},
      {"normal_of_the_tutorial",
       with(0.5, normal, 0.03, 0.09, 0.09),
       {0, 1},
       truncated(distribution_function(normal_distribution<>(0.5, 0.03)), 0.41, 0.59),
       with(0.501, normal, 0.03, 0.09, 0.09)},
      {"normal_cut_by_its_bounds",
       with(0.95, normal, 0.1, {}, {}),
       {0, 1},
       truncated(distribution_function(normal_distribution<>(0.95, 0.1)), 0, 1),
       with(0.945, normal, 0.1, {}, {})},
      {"normal_upper_half", with(3, normal, 2, 0, {}), any,
       [](double x) { return 2 * cdf(normal_distribution<>(3, 2), x) - 1; }, with(3, normal, 2.06, 0, {})},
      {"normal_one_sided", with(3, normal, 2, 5, 0.5), any,
       truncated(distribution_function(normal_distribution<>(3, 2)), -2, 3.5), with(3, normal, 2.05, 5, 0.5)},
      {"uniform_by_deviation", with(7, uniform, 2, {}, {}), any,
       distribution_function(uniform_distribution<>(7 - 2 * std::sqrt(3.0), 7 + 2 * std::sqrt(3.0))),
       with(7.1, uniform, 2, {}, {})},
      {"uniform_by_limits", with(0, uniform, {}, 0, 360), any, distribution_function(uniform_distribution<>(0, 360)),
       with(0, uniform, {}, 0, 356)},
      {"uniform_cut_by_its_bounds",
       with(0.8, uniform, {}, 0.2, 0.4),
       {0, 1},
       distribution_function(uniform_distribution<>(0.6, 1)),
       with(0.8, uniform, {}, 0.205, 0.4)},
      {"triangular_by_deviation", with(5, triangular, 1, {}, {}), any,
       distribution_function(triangular_distribution<>(5 - std::sqrt(6.0), 5, 5 + std::sqrt(6.0))),
       with(5.03, triangular, 1, {}, {})},
      {"triangular_lopsided", with(5, triangular, {}, 2, 3), any,
       distribution_function(triangular_distribution<>(3, 4, 8)), with(5.02, triangular, {}, 2.02, 2.98)},
      {"triangular_mode_at_its_limit", with(5, triangular, {}, 1, 4), any,
       distribution_function(triangular_distribution<>(4, 4, 9)), with(5, triangular, {}, 1.05, 4)},
      {"triangular_cut_by_its_bounds",
       with(5, triangular, {}, 2, 3),
       {3.5, 6},
       truncated(distribution_function(triangular_distribution<>(3, 4, 8)), 3.5, 6),
       with(5.03, triangular, {}, 2.03, 2.97)},
      {"beta", with(10.8, beta, 0.4, 0.8, 1.2), any, unit_beta, with(10.81, beta, 0.4, 0.81, 1.19)},
      {"beta_cut_by_its_bounds",
       with(10.8, beta, 0.4, 0.8, 1.2),
       {10.5, 11.5},
       truncated(unit_beta, 10.5, 11.5),
       with(10.8, beta, 0.45, 0.8, 1.2)},
      {"exponential", with(4, exponential, {}, {}, {}), any, starting_at(0, exponential_distribution<>(0.25)),
       with(4.12, exponential, {}, {}, {})},
      {"exponential_shifted", with(4, exponential, 0.5, {}, {}), any, starting_at(3.5, exponential_distribution<>(2)),
       with(4, exponential, 0.52, {}, {})},
      {"exponential_truncated", with(4, exponential, {}, 3, 6), any,
       truncated(starting_at(0, exponential_distribution<>(0.25)), 1, 10), with(4, exponential, 4.2, 3, 6)},
      {"lognormal", with(2, lognormal, 1, {}, {}), any, starting_at(0, log_law), with(2.02, lognormal, 1, {}, {})},
      {"lognormal_truncated", with(2, lognormal, 1, 0.5, 3), any, truncated(starting_at(0, log_law), 1.5, 5),
       with(2, lognormal, 1.1, 0.5, 3)},
      {"gamma", with(2, gamma, 1, {}, {}), any, starting_at(0, gamma_distribution<>(4, 0.5)),
       with(2.02, gamma, 1, {}, {})},
      {"gamma_truncated", with(2, gamma, 1, 1.5, 0.5), any,
       truncated(starting_at(0, gamma_distribution<>(4, 0.5)), 0.5, 2.5), with(2, gamma, 1.05, 1.5, 0.5)},
  };
}

class DistributionFit : public testing::TestWithParam<Fit> {};

TEST_P(DistributionFit, AgreesWithTheClosedForm) {
  const Fit& fit = GetParam();
  ASSERT_EQ(why_unusable(fit.given, fit.bounds), std::nullopt);
  const std::vector<double> draws = draws_of(Sampler(fit.given, fit.bounds));
  EXPECT_GT(kolmogorov_probability(kolmogorov_distance(draws, fit.F), draws.size()), 0.01);
  EXPECT_GT(chi_square_probability(draws, fit.F, 100), 0.01);
}

TEST_P(DistributionFit, FailsForASlightlyWrongSampler) {
  const Fit& fit = GetParam();
  ASSERT_EQ(why_unusable(fit.near, fit.bounds), std::nullopt);
  const std::vector<double> draws = draws_of(Sampler(fit.near, fit.bounds));
  EXPECT_LT(std::min(kolmogorov_probability(kolmogorov_distance(draws, fit.F), draws.size()),
                     chi_square_probability(draws, fit.F, 100)),
            0.001);
}

// More precise than any sample: the quantile is the inverse of the closed form.
TEST_P(DistributionFit, IsTheInverseOfTheClosedForm) {
  const Fit& fit = GetParam();
  const Sampler sampler(fit.given, fit.bounds);
  for (int i = 1; i < 1000; ++i) {
    const double u = i / 1000.0;
    ASSERT_NEAR(fit.F(sampler.draw(u)), u, 1e-12);
  }
}

TEST_P(DistributionFit, StaysInsideItsLimitsAndIncreasesWithU) {
  const Fit& fit = GetParam();
  const Sampler sampler(fit.given, fit.bounds);
  const double least = std::max(fit.bounds.least, fit.given.mean - fit.given.rel_min.value_or(1e300));
  const double most = std::min(fit.bounds.most, fit.given.mean + fit.given.rel_max.value_or(1e300));
  std::vector<double> us{smallest_u, 1e-12, 1e-6, 1e-3};
  for (int i = 1; i < 100; ++i) us.push_back(i / 100.0);
  us.insert(us.end(), {1 - 1e-3, 1 - 1e-6, 1 - 1e-12, largest_u});
  double last = -std::numeric_limits<double>::infinity();
  for (const double u : us) {
    const double x = sampler.draw(u);
    ASSERT_TRUE(std::isfinite(x)) << u;
    ASSERT_GE(x, least);
    ASSERT_LE(x, most);
    ASSERT_GE(x, last) << u;
    last = x;
  }
  EXPECT_FALSE(sampler.is_constant());
}

TEST_P(DistributionFit, IsMultipliedByItsScale) {
  const Fit& fit = GetParam();
  const double to_radians = std::numbers::pi / 180;
  const Sampler degrees(fit.given, fit.bounds), radians(fit.given, fit.bounds, to_radians);
  for (const double u : {smallest_u, 0.2, 0.5, 0.9, largest_u})
    EXPECT_EQ(radians.draw(u), degrees.draw(u) * to_radians);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, DistributionFit, testing::ValuesIn(fits()),
                         [](const testing::TestParamInfo<Fit>& fit) { return fit.param.name; });

// Mean and standard deviation of the draws by the midpoint rule over u.
struct MeanAndDeviation {
  double mean, deviation;
};

MeanAndDeviation integrated(const Sampler& sampler) {
  constexpr int steps = 200'000;
  double sum = 0, squares = 0;
  const double centre = sampler.draw(0.5);
  for (int i = 0; i < steps; ++i) {
    const double d = sampler.draw((i + 0.5) / steps) - centre;
    sum += d;
    squares += d * d;
  }
  const double mean = sum / steps;
  return {centre + mean, std::sqrt(squares / steps - mean * mean)};
}

TEST(DistributionMoments, UntruncatedKindsHaveTheGivenMeanAndStandardDeviation) {
  for (const DistributionKind kind : {normal, uniform, triangular, exponential, lognormal, gamma}) {
    const auto [mean, deviation] = integrated(Sampler(Distribution{12, kind, 3.0, {}, {}}, Bounds{}));
    EXPECT_NEAR(mean, 12, 2e-4) << static_cast<int>(kind);
    EXPECT_NEAR(deviation, 3, 2e-3) << static_cast<int>(kind);
  }
  const auto [mean, deviation] = integrated(Sampler(Distribution{12, beta, 3.0, 8.0, 6.0}, Bounds{}));
  EXPECT_NEAR(mean, 12, 1e-5);
  EXPECT_NEAR(deviation, 3, 1e-5);
}

TEST(DistributionMoments, ATriangleKeepsItsMeanIfTheModeFitsBetweenTheLimits) {
  const auto [mean, deviation] = integrated(Sampler(Distribution{5, triangular, {}, 2.0, 3.0}, Bounds{}));
  EXPECT_NEAR(mean, 5, 1e-6);
  // (a2 + b2 + c2 - ab - ac - bc) / 18 with a, c, b = 3, 4, 8
  EXPECT_NEAR(deviation, std::sqrt((9 + 16 + 64 - 12 - 24 - 32) / 18.0), 1e-5);
}

// N. L. Johnson, S. Kotz and N. Balakrishnan, "Continuous univariate distributions" vol. 1 (1994), section 13.10.1.
TEST(DistributionMoments, OfATruncatedNormalAreTheClosedForms) {
  const boost::math::normal_distribution<> standard;
  for (const auto& [rel_min, rel_max] : {std::pair{0.09, 0.09}, {0.01, 0.09}, {0.0, 0.05}, {0.002, 0.001}}) {
    const double alpha = -rel_min / 0.03, beta = rel_max / 0.03;
    const double z = cdf(standard, beta) - cdf(standard, alpha);
    const double shift = (pdf(standard, alpha) - pdf(standard, beta)) / z;
    const double variance = 1 + (alpha * pdf(standard, alpha) - beta * pdf(standard, beta)) / z - shift * shift;
    const auto [mean, deviation] = integrated(Sampler(Distribution{0.5, normal, 0.03, rel_min, rel_max}, Bounds{0, 1}));
    EXPECT_NEAR(mean, 0.5 + 0.03 * shift, 1e-9) << rel_min;
    EXPECT_NEAR(deviation, 0.03 * std::sqrt(variance), 1e-8) << rel_min;
  }
}

TEST(DistributionMoments, TheMeanOfATruncatedExponentialIsTheClosedForm) {
  // Of mean 4 on [1, 10]: 4 + (1 e^(-1/4) - 10 e^(-10/4)) / (e^(-1/4) - e^(-10/4)).
  const double lower = std::exp(-0.25), upper = std::exp(-2.5);
  const auto [mean, deviation] = integrated(Sampler(Distribution{4, exponential, {}, 3.0, 6.0}, Bounds{}));
  EXPECT_NEAR(mean, 4 + (lower - 10 * upper) / (lower - upper), 1e-8);
  EXPECT_LT(deviation, 4);
}

TEST(DistributionTails, TheUpperIsAsAccurateAsTheLower) {
  const Sampler whole(Distribution{0, normal, 1.0, {}, {}}, Bounds{});
  EXPECT_NEAR(whole.draw(smallest_u), -8.2095361516013875, 1e-14);
  EXPECT_EQ(whole.draw(largest_u), -whole.draw(smallest_u));
  // The last 2^-53 of the upper half [0, inf): the point with 2^-54 of the whole above it. Without the complement u
  // becomes 1 and the draw is infinite.
  const Sampler half(Distribution{0, normal, 1.0, 0.0, {}}, Bounds{});
  const double expected = quantile(complement(boost::math::normal_distribution<>(), 0x1p-54));
  EXPECT_NEAR(half.draw(largest_u), expected, 1e-13);
  const Sampler mirrored(Distribution{0, normal, 1.0, {}, 0.0}, Bounds{});
  EXPECT_EQ(mirrored.draw(smallest_u), -half.draw(largest_u));
}

TEST(DistributionTails, OfEveryUsableDistributionAreFiniteAndMonotone) {
  int usable = 0;
  for (const DistributionKind kind : {normal, uniform, triangular, beta, exponential, lognormal, gamma}) {
    for (const double mean : {1e-9, 0.05, 0.5, 0.999, 1.0, 40.0, 3e7}) {
      for (const double ratio : {1e-6, 1e-4, 1e-3, 0.03, 0.3, 0.99, 1.0, 3.0, 10.0, 1e3}) {
        for (const double left : {0.0, 1e-9, 1e-3, 0.5, 1.0, 30.0}) {
          for (const double right : {0.0, 1e-9, 1e-3, 0.5, 1.0, 30.0, 1e13}) {
            for (const Bounds bounds : {Bounds{}, Bounds{0, 1}, Bounds{0, 1e300}}) {
              const Distribution given{mean, kind, mean * ratio, mean * left, mean * right};
              if (why_unusable(given, bounds)) continue;
              ++usable;
              const Sampler sampler(given, bounds);
              double last = -std::numeric_limits<double>::infinity();
              for (const double u : {smallest_u, 1e-9, 0.01, 0.3, 0.5, 0.7, 0.99, 1 - 1e-9, largest_u}) {
                const double x = sampler.draw(u);
                ASSERT_TRUE(x >= std::max(bounds.least, mean - mean * left) &&
                            x <= std::min(bounds.most, mean + mean * right))
                    << static_cast<int>(kind) << " mean " << mean << " ratio " << ratio << " left " << left << " right "
                    << right << " u " << u << " x " << x;
                ASSERT_GE(x, last) << static_cast<int>(kind) << " mean " << mean << " ratio " << ratio << " left "
                                   << left << " right " << right << " u " << u;
                last = x;
              }
            }
          }
        }
      }
    }
  }
  EXPECT_GT(usable, 3000) << "the sweep should find much to test";
}

TEST(NormalQuantile, AgreesWithBoostInBothTailsAndTheMiddle) {
  const boost::math::normal_distribution<long double> standard;
  for (int i = 1; i < 3000; ++i) {
    for (const double p : {i / 6000.0, std::pow(10.0, -i / 10.0)}) {
      if (p < 1e-300) continue;
      const auto expected = static_cast<double>(quantile(standard, static_cast<long double>(p)));
      EXPECT_NEAR(normal_quantile(p, 1 - p), expected, 1e-15 * std::abs(expected)) << p;
      EXPECT_EQ(normal_quantile(1 - p, p), -normal_quantile(p, 1 - p)) << p;
    }
  }
  EXPECT_EQ(normal_quantile(0.5, 0.5), 0);
  EXPECT_EQ(normal_quantile(0, 1), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(normal_quantile(1, 0), std::numeric_limits<double>::infinity());
}

TEST(DistributionNone, IsTheMeanForAnyU) {
  const Sampler sampler(Distribution{.mean = 30, .kind = none, .std_dev = 5.0, .rel_min = 1.0, .rel_max = 1.0},
                        Bounds{0, 90}, 2.0);
  EXPECT_TRUE(sampler.is_constant());
  for (const double u : {smallest_u, 0.3, largest_u}) EXPECT_EQ(sampler.draw(u), 60);
  EXPECT_EQ(Sampler(0.25).draw(0.9), 0.25);
  EXPECT_TRUE(Sampler(0.25).is_constant());
  EXPECT_EQ(Sampler().draw(0.1), 0);
}

struct Refusal {
  Distribution given;
  Bounds bounds;
  std::string message;
};

TEST(DistributionWhyUnusable, NamesTheFaultWithTheKeysOfTheProjectFile) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Bounds any, restitution{0, 1}, not_negative{0, 1e300}, at_most_nine{-1e300, 9};
  const std::vector<Refusal> refusals{
      {{nan, none, {}, {}, {}}, any, "mean is nan (expected a finite number)"},
      {{infinity, normal, 1.0, {}, {}}, any, "mean is inf (expected a finite number)"},
      {{1.3, none, {}, {}, {}}, restitution, "mean is 1.3 (expected 0 to 1)"},
      {{1.3, normal, 0.1, {}, {}}, restitution, "mean is 1.3 (expected 0 to 1)"},
      {{-0.5, none, {}, {}, {}}, not_negative, "mean is -0.5 (expected at least 0)"},
      {{10, none, {}, {}, {}}, at_most_nine, "mean is 10 (expected at most 9)"},
      {{0.5, normal, -0.1, {}, {}}, restitution, "std_dev is -0.1 (expected a finite number above 0)"},
      {{0.5, normal, nan, {}, {}}, restitution, "std_dev is nan (expected a finite number above 0)"},
      {{0.5, uniform, {}, -0.1, 0.1},
       restitution,
       "rel_min is -0.1 (it is a distance from the mean: finite and not negative). For no limit, leave it out"},
      {{0.5, normal, 0.1, 0.1, infinity},
       restitution,
       "rel_max is inf (it is a distance from the mean: finite and not negative). For no limit, leave it out"},
      {{0.5, normal, {}, 0.1, 0.1}, restitution, "std_dev is missing (the normal distribution needs it)"},
      {{0.5, lognormal, {}, 0.1, 0.1}, restitution, "std_dev is missing (the lognormal distribution needs it)"},
      {{0.5, gamma, {}, 0.1, 0.1}, restitution, "std_dev is missing (the gamma distribution needs it)"},
      {{0.5, beta, {}, 0.1, 0.1}, restitution, "std_dev is missing (the beta distribution needs it)"},
      {{0.5, beta, 0.1, {}, 0.1}, restitution, "limits are missing (the beta distribution needs rel_min and rel_max)"},
      {{0.5, uniform, {}, 0.1, {}},
       restitution,
       "limits are missing (the uniform distribution needs rel_min and rel_max, or std_dev)"},
      {{0.5, triangular, {}, {}, {}},
       restitution,
       "limits are missing (the triangular distribution needs rel_min and rel_max, or std_dev)"},
      {{-2, exponential, {}, {}, {}},
       any,
       "std_dev is missing (the exponential distribution then uses the mean, which is -2, not above 0)"},
      {{0.5, normal, 0.0, {}, {}},
       restitution,
       "std_dev is 0 (the normal distribution needs one above 0). For a constant, use distribution = \"none\""},
      {{0.5, uniform, 0.0, {}, {}},
       restitution,
       "std_dev is 0 (the uniform distribution needs one above 0). For a constant, use distribution = \"none\""},
      {{0, lognormal, 1.0, {}, {}}, any, "mean is 0 (the lognormal distribution has positive values only)"},
      {{-1, gamma, 1.0, {}, {}}, any, "mean is -1 (the gamma distribution has positive values only)"},
      {{2, gamma, 30.0, {}, {}}, any, "std_dev is 30 (the gamma distribution expects at most 10 times the mean, 20)"},
      {{2, lognormal, 1e-5, {}, {}},
       any,
       "std_dev is 1e-05 (the lognormal distribution expects at least 0.0001 times the mean, 0.0002). For less, use "
       "\"normal\""},
      {{0.5, beta, 0.1, 0.0, 0.3},
       restitution,
       "rel_min is 0 (the mean of a beta distribution is between its limits, not on one)"},
      {{0.5, beta, 0.1, 0.3, 0.0},
       restitution,
       "rel_max is 0 (the mean of a beta distribution is between its limits, not on one)"},
      {{0.5, beta, 0.25, 0.2, 0.2},
       restitution,
       "std_dev is 0.25 (a beta distribution with these limits can have at most 0.199)"},
      {{0.5, beta, 1e-6, 0.2, 0.2},
       restitution,
       "std_dev is 1e-06 (a beta distribution with these limits expects at least 2e-05). For less, use \"normal\""},
      {{0.4, beta, 0.04, 0.1, 9e15},
       restitution,
       "rel_max is 9e+15 (a beta distribution expects at most 1e+12 times its std_dev, 4e+10). Without a limit on one "
       "side, use \"gamma\" or \"lognormal\""},
      {{0.5, normal, 0.1, 0.0, 0.0},
       restitution,
       "rel_min and rel_max allow only the value 0.5 (a random property needs a range). For a constant, use "
       "distribution = \"none\""},
      {{1, uniform, {}, 0.0, 0.2},
       restitution,
       "rel_min and rel_max allow only the value 1 (a random property needs a range). For a constant, use distribution "
       "= \"none\""},
      {{0.5, normal, 3e6, 0.25, 0.25},
       restitution,
       "the limits 0.25 to 0.75 leave less than a millionth of the normal distribution (its std_dev is 3000000). "
       "Compare the units of std_dev and of the limits"},
  };
  for (const Refusal& refusal : refusals) {
    EXPECT_EQ(why_unusable(refusal.given, refusal.bounds).value_or("usable"), refusal.message);
  }
}

TEST(DistributionWhyUnusable, AcceptsAConstantOnItsBound) {
  EXPECT_EQ(why_unusable(Distribution{.mean = 0}, Bounds{0, 1}), std::nullopt);
  EXPECT_EQ(why_unusable(Distribution{.mean = 1}, Bounds{0, 1}), std::nullopt);
  EXPECT_EQ(why_unusable(Distribution{1, normal, 0.1, {}, {}}, Bounds{0, 1}), std::nullopt);
}

}  // namespace
}  // namespace talus::distribution_test
