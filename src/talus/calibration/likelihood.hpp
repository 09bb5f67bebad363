#pragma once
// How probable observations are under a set of parameters, from simulated rocks alone: the synthetic likelihood.
//
// S. N. Wood, "Statistical inference for noisy nonlinear ecological dynamic systems", Nature 466 (2010) 1102-1104: the
// observations are reduced to summaries (means, spreads, shapes), whose distribution for as many rocks as were
// observed is taken as normal, with the mean and covariance of simulated data. Here those are of resamples, of as many
// rocks as were observed, of the simulated rocks of the set. This is why the posterior's width follows from the number
// of observations, and not from a threshold.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "talus/calibration/redraw.hpp"

namespace talus::calibration {

/// A quantity that is observed and simulated.
struct Feature {
  std::string name;     // for tables: "runout"
  std::string unit;     // "m"
  double accuracy = 0;  // standard deviation of the errors of its observation
};

/// Means of all features, then logarithms of their standard deviations (two rows or more), then of eight rows or more
/// distances of their medians from their means, and ratios of their mean to their root mean square deviations: 0.8 for
/// a normal distribution, less for a few rocks far from the others (R. C. Geary, "The ratio of the mean deviation to
/// the standard deviation as a test of normality", Biometrika 27 (1935) 310-332). `as_of`: those that as many rows
/// would have.
[[nodiscard]] Eigen::VectorXd summaries_of(const Eigen::MatrixXd& rows, std::optional<Eigen::Index> as_of = {});

/// The distribution of summaries.
struct ExpectedSummaries {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

/// Of simulated rocks that are observed as `like` (redraw.hpp), with errors of observation. Expects at least one
/// simulated rock of each release. The same `seed` draws the same numbers for every sample. Includes the variance of
/// the simulation itself, which has so many rocks and no more.
[[nodiscard]] ExpectedSummaries expected_summaries(const Sample& simulated, const Sample& like,
                                                   const std::vector<Feature>& features, std::uint64_t seed);

/// Of these summaries, normally distributed: the density's logarithm, and the squared distance from the mean in
/// standard deviations, which has the distribution chi-square if the parameters are right.
struct LogDensity {
  double value = 0;
  double squared_distance = 0;
};
[[nodiscard]] LogDensity log_density(const Eigen::VectorXd& observed, const ExpectedSummaries& expected);

/// Of observed rocks, each in the distribution of its own release: the sum over releases, which are independent of each
/// other. The summaries of a release are those of its observed rocks; of a single one, its place itself, with Student's
/// distribution, since its mean and covariance are known from few simulated rocks. Expects two simulated rocks or more
/// of each release.
[[nodiscard]] LogDensity matched_log_density(const Sample& simulated, const Sample& observed,
                                             const std::vector<Feature>& features, std::uint64_t seed);
/// How many summaries it has.
[[nodiscard]] std::size_t matched_summary_count(const Sample& observed);

/// Of observed shares of categories, of so many independent rocks, if the shares of `simulated_rocks` independent ones
/// are `simulated`: the Dirichlet-multinomial distribution with Jeffreys' prior, that is, counts whose probabilities
/// are known from the simulation and no better. Numbers of rocks need not be whole. The squared distance is the
/// deviance: twice by what the logarithm is below that of a simulation with the observed shares.
[[nodiscard]] LogDensity share_log_density(const Eigen::VectorXd& observed, double observed_rocks,
                                           const Eigen::VectorXd& simulated, double simulated_rocks);

}  // namespace talus::calibration
