#include "talus/calibration/likelihood.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

#include "talus/core/check.hpp"
#include "talus/core/random.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::uint32_t resamples = 300;
constexpr Index least_for_spread = 2, least_for_shape = 8;
constexpr auto error_of_observation = static_cast<Stream>(1101);

double median_of(VectorXd values) {
  const Index half = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + half, values.end());
  if (values.size() % 2 == 1) return values[half];
  return (values[half] + *std::max_element(values.begin(), values.begin() + half)) / 2;
}

/// The sum of squares and products about the mean.
MatrixXd scatter_of(const MatrixXd& rows) {
  const MatrixXd off = rows.rowwise() - rows.colwise().mean();
  return off.transpose() * off;
}

/// Of a single rock of a release: the density at its place if mean and covariance are known from so many simulated
/// rocks and no better, Student's distribution (A. Gelman et al., "Bayesian data analysis", 3rd ed. (2013),
/// section 3.6; E. Sellentin, A. F. Heavens, "Parameter inference with estimated covariance matrices", MNRAS Letters
/// 456 (2016) L132-L136). The covariance of all releases counts like a few more rocks. The squared distance is the
/// deviance.
LogDensity place_log_density(const VectorXd& observed, const MatrixXd& simulated, const MatrixXd& pooled,
                             const std::vector<Feature>& features) {
  constexpr double pooled_rocks = 5, least_variance = 1e-16;
  const auto n = static_cast<double>(simulated.rows()), d = static_cast<double>(observed.size());
  const double freedom = n - 1 + pooled_rocks - (d - 1);
  MatrixXd scale = (scatter_of(simulated) + pooled_rocks * pooled) / freedom * (1 + 1 / n);
  for (std::size_t f = 0; f < features.size(); ++f) {
    const auto at = static_cast<Index>(f);
    scale(at, at) += features[f].accuracy * features[f].accuracy + least_variance;
  }
  const Eigen::LDLT<MatrixXd> decomposition(scale);
  const VectorXd off = observed - simulated.colwise().mean().transpose();
  LogDensity density;
  density.squared_distance = (freedom + d) * std::log1p(off.dot(decomposition.solve(off)) / freedom);
  double log_determinant = 0;
  for (const double each : decomposition.vectorD()) log_determinant += std::log(std::max(each, least_variance));
  density.value = boost::math::lgamma((freedom + d) / 2) - boost::math::lgamma(freedom / 2) -
                  0.5 * (d * std::log(freedom * std::numbers::pi) + log_determinant + density.squared_distance);
  return density;
}

}  // namespace

VectorXd summaries_of(const MatrixXd& rows, std::optional<Index> as_of) {
  const Index features = rows.cols(), n = as_of.value_or(rows.rows());
  const Index kinds = 1 + (n >= least_for_spread ? 1 : 0) + (n >= least_for_shape ? 2 : 0);
  VectorXd summaries(kinds * features);
  for (Index f = 0; f < features; ++f) {
    const VectorXd column = rows.col(f);
    const double mean = column.mean();
    summaries[f] = mean;
    if (n >= least_for_spread) {
      constexpr double least_variance = 1e-18;
      const double variance =
          (column.array() - mean).square().sum() / static_cast<double>(std::max<Index>(rows.rows() - 1, 1));
      summaries[features + f] = 0.5 * std::log(std::max(variance, least_variance));
    }
    if (n >= least_for_shape) {
      summaries[2 * features + f] = median_of(column) - mean;
      const Eigen::ArrayXd off = column.array() - mean;
      const double root_mean_square = std::sqrt(off.square().mean());
      summaries[3 * features + f] = root_mean_square > 0 ? off.abs().mean() / root_mean_square : 1;
    }
  }
  return summaries;
}

ExpectedSummaries expected_summaries(const Sample& simulated, const Sample& like, const std::vector<Feature>& features,
                                     std::uint64_t seed) {
  const Redraw redraw(simulated, like);
  TALUS_PROMISE(redraw.has_at_least(1), "every observed release is simulated");
  const auto columns = static_cast<Index>(features.size());
  std::vector<VectorXd> all;
  all.reserve(resamples);
  std::vector<Index> rows;
  MatrixXd resample;
  for (std::uint32_t k = 0; k < resamples; ++k) {
    redraw.rows(seed, k, rows);
    const auto n = static_cast<Index>(rows.size());
    resample.resize(n, columns);
    for (Index i = 0; i < n; ++i) {
      const auto item = static_cast<std::uint64_t>(k) << 32U | static_cast<std::uint64_t>(i);
      for (Index f = 0; f < columns; ++f) {
        resample(i, f) = simulated.rows(rows[static_cast<std::size_t>(i)], f);
        const double accuracy = features[static_cast<std::size_t>(f)].accuracy;
        if (accuracy == 0) continue;
        const auto [a, b] = uniform_pair(seed, item, error_of_observation, static_cast<std::uint32_t>(f));
        resample(i, f) += accuracy * std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
      }
    }
    all.push_back(summaries_of(resample, like.rows.rows()));
  }
  ExpectedSummaries expected;
  const Index size = all.front().size();
  expected.mean = VectorXd::Zero(size);
  for (const VectorXd& one : all) expected.mean += one / resamples;
  expected.covariance = MatrixXd::Zero(size, size);
  for (const VectorXd& one : all) {
    expected.covariance += (one - expected.mean) * (one - expected.mean).transpose() / (resamples - 1);
  }
  // The simulated rocks are a sample, too: their summaries differ from those of infinitely many by as much as summaries
  // of so many rocks vary.
  expected.covariance *=
      1 + static_cast<double>(redraw.observed_rocks()) / static_cast<double>(redraw.simulated_rocks());
  return expected;
}

LogDensity log_density(const VectorXd& observed, const ExpectedSummaries& expected) {
  // Rounding and rocks that all stop in one place must not make a covariance singular.
  constexpr double least_share = 1e-8, least_variance = 1e-16;
  MatrixXd covariance = expected.covariance;
  for (Index k = 0; k < covariance.rows(); ++k) covariance(k, k) += least_share * covariance(k, k) + least_variance;
  const Eigen::LDLT<MatrixXd> decomposition(covariance);
  const VectorXd off = observed - expected.mean;
  LogDensity density;
  density.squared_distance = off.dot(decomposition.solve(off));
  double log_determinant = 0;
  for (const double d : decomposition.vectorD()) log_determinant += std::log(std::max(d, least_variance));
  density.value = -0.5 * (density.squared_distance + log_determinant +
                          static_cast<double>(observed.size()) * std::log(2 * std::numbers::pi));
  return density;
}

LogDensity matched_log_density(const Sample& simulated, const Sample& observed, const std::vector<Feature>& features,
                               std::uint64_t seed) {
  const std::uint32_t releases = observed.stratum_count();
  std::vector<Sample> own;
  MatrixXd pooled = MatrixXd::Zero(observed.rows.cols(), observed.rows.cols());
  double freedom = 0;
  for (std::uint32_t release = 0; release < releases; ++release) {
    own.push_back(simulated.stratum(release));
    if (own.back().rows.rows() < 2) continue;
    pooled += scatter_of(own.back().rows);
    freedom += static_cast<double>(own.back().rows.rows() - 1);
  }
  pooled /= std::max(freedom, 1.0);
  LogDensity sum;
  for (std::uint32_t release = 0; release < releases; ++release) {
    Sample here = observed.stratum(release);
    if (here.rows.rows() == 0) continue;
    LogDensity density;
    if (here.rows.rows() == 1) {
      density = place_log_density(here.rows.row(0).transpose(), own[release].rows, pooled, features);
    } else {
      here.strata.clear();
      own[release].strata.clear();
      density = log_density(summaries_of(here.rows), expected_summaries(own[release], here, features, seed));
    }
    sum.value += density.value;
    sum.squared_distance += density.squared_distance;
  }
  return sum;
}

std::size_t matched_summary_count(const Sample& observed) {
  std::size_t count = 0;
  for (std::uint32_t release = 0; release < observed.stratum_count(); ++release) {
    const Sample here = observed.stratum(release);
    if (here.rows.rows() > 0) count += static_cast<std::size_t>(summaries_of(here.rows).size());
  }
  return count;
}

LogDensity share_log_density(const VectorXd& observed, double observed_rocks, const VectorXd& simulated,
                             double simulated_rocks) {
  constexpr double jeffreys = 0.5;
  const auto log_probability = [&](const VectorXd& shares) {
    const double all = simulated_rocks + jeffreys * static_cast<double>(shares.size());
    double sum =
        boost::math::lgamma(all) - boost::math::lgamma(all + observed_rocks) + boost::math::lgamma(observed_rocks + 1);
    for (Index k = 0; k < shares.size(); ++k) {
      const double prior = simulated_rocks * shares[k] + jeffreys, count = observed_rocks * observed[k];
      sum += boost::math::lgamma(prior + count) - boost::math::lgamma(prior) - boost::math::lgamma(count + 1);
    }
    return sum;
  };
  LogDensity density;
  density.value = log_probability(simulated);
  density.squared_distance = std::max(0.0, 2 * (log_probability(observed) - density.value));
  return density;
}

}  // namespace talus::calibration
