#include "talus/calibration/likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "talus/core/check.hpp"
#include "talus/core/random.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int resamples = 300;
constexpr Index least_for_spread = 2, least_for_median = 8;
enum class ResampleDraw : std::uint32_t { choice = 1100, error = 1101 };

double median_of(VectorXd values) {
  const Index half = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + half, values.end());
  if (values.size() % 2 == 1) return values[half];
  return (values[half] + *std::max_element(values.begin(), values.begin() + half)) / 2;
}

}  // namespace

VectorXd summaries_of(const MatrixXd& rows) {
  const Index n = rows.rows(), features = rows.cols();
  const Index kinds = 1 + (n >= least_for_spread ? 1 : 0) + (n >= least_for_median ? 1 : 0);
  VectorXd summaries(kinds * features);
  for (Index f = 0; f < features; ++f) {
    const VectorXd column = rows.col(f);
    const double mean = column.mean();
    summaries[f] = mean;
    if (n >= least_for_spread) {
      constexpr double least_variance = 1e-18;
      const double variance = (column.array() - mean).square().sum() / static_cast<double>(n - 1);
      summaries[features + f] = 0.5 * std::log(std::max(variance, least_variance));
    }
    if (n >= least_for_median) summaries[2 * features + f] = median_of(column) - mean;
  }
  return summaries;
}

ExpectedSummaries expected_summaries(const Sample& simulated, std::size_t count,
                                     const std::vector<std::uint32_t>& strata, const std::vector<Feature>& features,
                                     std::uint64_t seed) {
  const auto n = static_cast<Index>(count);
  const auto columns = static_cast<Index>(features.size());
  std::vector<std::vector<Index>> of_stratum;
  if (!strata.empty()) {
    of_stratum.resize(*std::max_element(strata.begin(), strata.end()) + 1);
    for (Index row = 0; row < simulated.rows.rows(); ++row) {
      const std::uint32_t stratum = simulated.strata[static_cast<std::size_t>(row)];
      if (stratum < of_stratum.size()) of_stratum[stratum].push_back(row);
    }
  }
  std::vector<VectorXd> all;
  all.reserve(resamples);
  MatrixXd resample(n, columns);
  for (int k = 0; k < resamples; ++k) {
    for (Index i = 0; i < n; ++i) {
      const auto item = static_cast<std::uint64_t>(k) << 32U | static_cast<std::uint64_t>(i);
      const double choice = uniform_pair(seed, item, static_cast<Stream>(ResampleDraw::choice), 0)[0];
      const auto pick = [&](std::size_t size) {
        return std::min(static_cast<std::size_t>(choice * static_cast<double>(size)), size - 1);
      };
      Index row = 0;
      if (strata.empty()) {
        row = static_cast<Index>(pick(static_cast<std::size_t>(simulated.rows.rows())));
      } else {
        const auto& rows = of_stratum[strata[static_cast<std::size_t>(i)]];
        TALUS_PROMISE(!rows.empty(), "every observed release is simulated");
        row = rows[pick(rows.size())];
      }
      for (Index f = 0; f < columns; ++f) {
        resample(i, f) = simulated.rows(row, f);
        const double accuracy = features[static_cast<std::size_t>(f)].accuracy;
        if (accuracy == 0) continue;
        const auto [a, b] =
            uniform_pair(seed, item, static_cast<Stream>(ResampleDraw::error), static_cast<std::uint32_t>(f));
        resample(i, f) += accuracy * std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
      }
    }
    all.push_back(summaries_of(resample));
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
  expected.covariance *= 1 + static_cast<double>(count) / static_cast<double>(simulated.rows.rows());
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

}  // namespace talus::calibration
