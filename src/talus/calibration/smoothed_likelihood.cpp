#include "talus/calibration/smoothed_likelihood.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "talus/core/stop.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Places from which the process is learned, and from which its smoothness is; others are predicted from them.
constexpr std::size_t most_learned = 800, most_for_smoothness = 250;

/// Lengths over which the process changes, in standard deviations of the places; and variances of the noise over that
/// of the process.
constexpr std::array lengths{0.5, 1.0, 2.0, 4.0};
constexpr std::array noises{1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0};

Index trend_terms(Index dimensions) { return (dimensions + 1) * (dimensions + 2) / 2; }

/// Constant, linear and quadratic terms; places by columns.
MatrixXd trend(const MatrixXd& places) {
  const Index d = places.rows();
  MatrixXd terms(places.cols(), trend_terms(d));
  for (Index k = 0; k < places.cols(); ++k) {
    Index term = 0;
    terms(k, term++) = 1;
    for (Index a = 0; a < d; ++a) {
      terms(k, term++) = places(a, k);
      for (Index b = 0; b <= a; ++b) terms(k, term++) = places(a, k) * places(b, k);
    }
  }
  return terms;
}

/// Matern's correlation that can be differentiated twice (Rasmussen and Williams, equation 4.17).
double correlation(double distance, double length) {
  const double r = std::sqrt(5.0) * distance / length;
  return (1 + r + r * r / 3) * std::exp(-r);
}

MatrixXd correlations(const MatrixXd& a, const MatrixXd& b, double length) {
  MatrixXd all(a.cols(), b.cols());
  for (Index j = 0; j < b.cols(); ++j) {
    for (Index i = 0; i < a.cols(); ++i) all(i, j) = correlation((a.col(i) - b.col(j)).norm(), length);
  }
  return all;
}

/// The process, learned from values at places.
class Process {
 public:
  /// Expects more values than terms of the trend.
  Process(const MatrixXd& places, const VectorXd& values, double length, double noise)
      : places_(places), length_(length), noise_(noise) {
    MatrixXd covariance = correlations(places, places, length);
    covariance.diagonal().array() += noise;
    const Eigen::LLT<MatrixXd> root(covariance);
    const MatrixXd terms = trend(places);
    const MatrixXd whitened = root.matrixL().solve(terms);
    const VectorXd target = root.matrixL().solve(values);
    const Eigen::ColPivHouseholderQR<MatrixXd> fit(whitened);
    coefficients_ = fit.solve(target);
    const auto freedom = static_cast<double>(values.size() - fit.rank());
    variance_ = std::max((target - whitened * coefficients_).squaredNorm() / freedom, 1e-300);
    weights_ = root.solve(values - terms * coefficients_);
    double log_determinant = 0;
    for (Index k = 0; k < values.size(); ++k) log_determinant += 2 * std::log(root.matrixLLT()(k, k));
    for (Index k = 0; k < fit.rank(); ++k) log_determinant += 2 * std::log(std::abs(fit.matrixR()(k, k)));
    log_evidence_ = -0.5 * (freedom * std::log(variance_) + log_determinant);
  }

  /// The restricted log-likelihood of length and noise, without constants.
  [[nodiscard]] double log_evidence() const { return log_evidence_; }
  [[nodiscard]] double noise_variance() const { return variance_ * noise_; }
  [[nodiscard]] VectorXd at(const MatrixXd& places) const {
    return trend(places) * coefficients_ + correlations(places, places_, length_) * weights_;
  }

 private:
  MatrixXd places_;
  double length_, noise_;
  VectorXd coefficients_, weights_;
  double variance_ = 0, log_evidence_ = 0;
};

/// Every so many of the indices that at most so many remain.
std::vector<std::size_t> thinned(const std::vector<std::size_t>& indices, std::size_t most) {
  if (indices.size() <= most) return indices;
  std::vector<std::size_t> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(indices[k * indices.size() / most]);
  return some;
}

/// The places, turned and scaled so that they have the covariance 1 and no mean.
class Scaled {
 public:
  Scaled(std::span<const Place> places, const std::vector<std::size_t>& indices) {
    all_.resize(static_cast<Index>(places.front().size()), static_cast<Index>(places.size()));
    for (std::size_t k = 0; k < places.size(); ++k)
      all_.col(static_cast<Index>(k)) = Eigen::Map<const VectorXd>(places[k].data(), all_.rows());
    MatrixXd some = of(indices);
    const VectorXd mean = some.rowwise().mean();
    some.colwise() -= mean;
    MatrixXd covariance = some * some.transpose() / static_cast<double>(some.cols());
    constexpr double narrowest = 1e-5;  // as a share of the prior
    covariance.diagonal().array() += narrowest * narrowest;
    all_.colwise() -= mean;
    Eigen::LLT<MatrixXd>(covariance).matrixL().solveInPlace(all_);
  }
  [[nodiscard]] MatrixXd of(const std::vector<std::size_t>& indices) const {
    MatrixXd some(all_.rows(), static_cast<Index>(indices.size()));
    for (std::size_t k = 0; k < indices.size(); ++k)
      some.col(static_cast<Index>(k)) = all_.col(static_cast<Index>(indices[k]));
    return some;
  }

 private:
  MatrixXd all_;  // a column each
};

VectorXd part(std::span<const double> values, const std::vector<std::size_t>& indices) {
  VectorXd some(static_cast<Index>(indices.size()));
  for (std::size_t k = 0; k < indices.size(); ++k) some[static_cast<Index>(k)] = values[indices[k]];
  return some;
}

}  // namespace

SmoothedLikelihoods smoothed_likelihoods(std::span<const Place> places, std::span<const double> log_likelihoods) {
  SmoothedLikelihoods smoothed{{log_likelihoods.begin(), log_likelihoods.end()}};
  if (places.empty()) return smoothed;
  const std::size_t dimensions = places.front().size();
  std::vector<std::size_t> order;  // from the greatest down
  for (std::size_t k = 0; k < places.size(); ++k)
    if (std::isfinite(log_likelihoods[k])) order.push_back(k);
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) { return log_likelihoods[k]; });

  // Sets that are further below the greatest than this have no weight, noise included.
  constexpr double noise_allowance = 20, negligible = 1e-3;
  const boost::math::chi_squared law(static_cast<double>(dimensions));
  const double depth = noise_allowance + boost::math::quantile(boost::math::complement(law, negligible)) / 2;
  const auto least = 4 * static_cast<std::size_t>(trend_terms(static_cast<Index>(dimensions)));
  if (order.size() < least) return smoothed;
  const auto near = static_cast<std::size_t>(std::ranges::count_if(
      order, [&](std::size_t k) { return log_likelihoods[k] >= log_likelihoods[order[0]] - depth; }));
  order.resize(std::max(near, least));
  std::ranges::sort(order);

  const Scaled scaled(places, order);
  const std::vector<std::size_t> few = thinned(order, most_for_smoothness);
  const MatrixXd few_places = scaled.of(few);
  const VectorXd few_values = part(log_likelihoods, few);
  double most_evidence = -std::numeric_limits<double>::infinity(), length = 0, noise = 0;
  for (const double each_length : lengths) {
    for (const double each_noise : noises) {
      stop_point();
      const double evidence = Process(few_places, few_values, each_length, each_noise).log_evidence();
      if (evidence <= most_evidence) continue;
      most_evidence = evidence;
      length = each_length;
      noise = each_noise;
    }
  }
  const std::vector<std::size_t> learned = thinned(order, most_learned);
  const Process process(scaled.of(learned), part(log_likelihoods, learned), length, noise);
  const VectorXd values = process.at(scaled.of(order));
  for (std::size_t k = 0; k < order.size(); ++k) smoothed.values[order[k]] = values[static_cast<Index>(k)];
  smoothed.noise = std::sqrt(process.noise_variance());
  return smoothed;
}

}  // namespace talus::calibration
