#pragma once
// Points of the unit cube that represent a posterior: rounds of adaptive importance sampling.
//
// The first round is a Sobol sequence over the whole cube, which is the prior (each coordinate is the share of a prior
// below a value). Each later round is drawn from normal kernels around the points so far, chosen by their weights, with
// twice their weighted covariance: M. A. Beaumont, J.-M. Cornuet, J.-M. Marin, C. P. Robert, "Adaptive approximate
// Bayesian computation", Biometrika 96 (2009) 983-990. The points of all rounds are kept. Their weights are the
// likelihood over the density of the mixture of all rounds' proposals: J.-M. Cornuet, J.-M. Marin, A. Mira, C. P.
// Robert, "Adaptive multiple importance sampling", Scandinavian Journal of Statistics 39 (2012) 798-812. As the first
// round is part of the mixture, no weight can be much larger than the likelihood. Weights are truncated at the square
// root of their number times their mean: E. L. Ionides, "Truncated importance sampling", Journal of Computational and
// Graphical Statistics 17 (2008) 295-311.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace talus::calibration {

/// A place in the unit cube: one coordinate for each parameter.
using Place = std::vector<double>;

class Sampler {
 public:
  /// Expects 1 to 1000 dimensions. The same seed gives the same places for the same likelihoods.
  Sampler(std::size_t dimensions, std::uint64_t seed);

  /// The places of the next round. Expects that the likelihoods of all earlier ones have been set.
  [[nodiscard]] std::vector<Place> next_round(std::size_t count);
  /// The logarithms of the likelihoods of all places so far; -infinity: impossible.
  void set(std::span<const double> log_likelihoods);

  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  [[nodiscard]] std::size_t rounds() const { return rounds_.size(); }
  /// The weights of all places with these logarithms of likelihoods; they add up to 1. All 0 for the prior.
  [[nodiscard]] std::vector<double> weights(std::span<const double> log_likelihoods) const;
  /// With the likelihoods that were set.
  [[nodiscard]] std::vector<double> weights() const { return weights(log_likelihoods_); }

 private:
  /// A mixture of normal kernels, restricted to the cube.
  struct Kernels {
    std::vector<std::size_t> centres;     // indices of places
    std::vector<double> cumulated;        // weights
    std::vector<double> factor, inverse;  // Cholesky factor of the covariance and its inverse: lower, row by row
    double log_norm = 0;                  // of a kernel's density, and of the share of the mixture inside the cube
    std::size_t count = 0;                // places drawn from it
  };
  [[nodiscard]] Kernels kernels_around(std::span<const double> weights) const;
  [[nodiscard]] double density(const Kernels& kernels, const Place& at) const;
  void update_mixture();

  std::size_t dimensions_;
  std::uint64_t seed_;
  std::vector<Place> places_;
  std::vector<double> log_likelihoods_, mixture_;  // of each place; the mixture's density
  std::vector<Kernels> rounds_;                    // the first has no centres
};

/// With fewer a posterior's quantiles are coarse.
inline constexpr double enough_effective_sets = 40;

/// 1 over the sum of the squares of weights that add up to 1: how many equally weighted points would be as accurate.
[[nodiscard]] double effective_size(std::span<const double> weights);

/// The value below which lies the share `q` of the weight.
[[nodiscard]] double weighted_quantile(std::span<const double> values, std::span<const double> weights, double q);

}  // namespace talus::calibration
