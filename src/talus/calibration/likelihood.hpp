#pragma once
// How probable observations are under a set of parameters, from simulated rocks alone: the synthetic likelihood.
//
// S. N. Wood, "Statistical inference for noisy nonlinear ecological dynamic systems", Nature 466 (2010) 1102-1104: the
// observations are reduced to summaries (means, spreads, medians), whose distribution for as many rocks as were
// observed is taken as normal, with the mean and covariance of simulated data. Here those are of resamples, of as many
// rocks as were observed, of the simulated rocks of the set. This is why the posterior's width follows from the number
// of observations, and not from a threshold.

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Dense>

namespace talus::calibration {

/// A quantity that is observed and simulated.
struct Feature {
  std::string name;     // for tables: "runout"
  std::string unit;     // "m"
  double accuracy = 0;  // standard deviation of the errors of its observation
};

/// Rocks by row, features by column.
struct Sample {
  Eigen::MatrixXd rows;
  std::vector<std::uint32_t> strata{};  // of each row; empty: all the same
};

/// Means of all features, then logarithms of their standard deviations (two rows or more), then distances of their
/// medians from their means (eight or more).
[[nodiscard]] Eigen::VectorXd summaries_of(const Eigen::MatrixXd& rows);

/// The distribution of summaries.
struct ExpectedSummaries {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

/// Of `count` rows drawn with replacement from the simulated ones, with errors of observation; with strata, row i is
/// drawn from the simulated rows of stratum `strata[i]`, which must not be empty, and count is their number. The same
/// `seed` draws the same numbers for every sample. Includes the variance of the simulation itself, which has so many
/// rows and no more.
[[nodiscard]] ExpectedSummaries expected_summaries(const Sample& simulated, std::size_t count,
                                                   const std::vector<std::uint32_t>& strata,
                                                   const std::vector<Feature>& features, std::uint64_t seed);

/// Of these summaries, normally distributed: the density's logarithm, and the squared distance from the mean in
/// standard deviations, which has the distribution chi-square if the parameters are right.
struct LogDensity {
  double value = 0;
  double squared_distance = 0;
};
[[nodiscard]] LogDensity log_density(const Eigen::VectorXd& observed, const ExpectedSummaries& expected);

}  // namespace talus::calibration
