#pragma once
// Sobol indices: which share of a result's variance each input causes.
//
// The first-order index of an input is the share of the variance that would vanish, in the mean, if that input were
// known; the total index is the share that would remain if all others were known. Their difference is the part of
// interactions. I. M. Sobol', "Global sensitivity indices for nonlinear mathematical models and their Monte Carlo
// estimates", Mathematics and Computers in Simulation 55 (2001) 271-280.
//
// Design and estimators: A. Saltelli et al., "Variance based sensitivity analysis of model output. Design and estimator
// for the total sensitivity index", Computer Physics Communications 181 (2010) 259-270. With rows A and B of
// independent inputs, and A_i equal to A but for input i, which is from B:
//   first order: mean of f(B) (f(A_i) - f(A)) over the variance (their table 2, b);
//   total:       mean of (f(A) - f(A_i))^2 / 2 over the variance (table 2, f; M. J. W. Jansen, "Analysis of variance
//                designs for model output", Computer Physics Communications 117 (1999) 35-43).
// Results are taken about their mean, which changes no expectation and lessens the noise of the first estimator. Rows
// are points of a Sobol sequence in 2k dimensions with a random digital shift (C. Lemieux, Monte Carlo and Quasi-Monte
// Carlo Sampling (2009), section 6.2.2), so that another seed gives other points of the same evenness.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/statistics/bootstrap.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus {

struct SobolPlan {
  std::size_t inputs = 1;  // k, from 1 to 1000
  std::size_t rows = 256;  // at least 4; a power of two is the most even
  std::uint64_t seed = 1;
};

/// Estimates can be slightly below 0 or above 1.
struct SobolIndex {
  Estimate first, total;  // with bootstrap intervals over rows
};

struct SobolIndices {
  double mean = 0, variance = 0;   // of the result over the inputs' distributions
  std::size_t rows = 0;            // for which the result is defined at all of their points
  std::vector<SobolIndex> inputs;  // empty if the result does not vary
};

class SobolDesign {
 public:
  explicit SobolDesign(const SobolPlan& plan);

  /// rows x (inputs + 2) points of `inputs` coordinates in (0, 1), row after row: A, B, A_1, ..., A_k. A design with
  /// more rows begins with the same points.
  [[nodiscard]] const std::vector<std::vector<double>>& points() const { return points_; }

  /// From the result at each point. Rows in which it is undefined anywhere are left out; empty if fewer than four
  /// remain.
  [[nodiscard]] std::optional<SobolIndices> indices(std::span<const std::optional<double>> results,
                                                    const Bootstrap& bootstrap) const;

 private:
  SobolPlan plan_;
  std::vector<std::vector<double>> points_;
};

}  // namespace talus
