#pragma once
// Logarithms of likelihoods without the noise of their simulation.
//
// The likelihood of a set is estimated from so many simulated rocks and no more. Where an observed rock is compared
// with the few simulated rocks of its own release, and there are many releases, its logarithm is off by several units,
// and the sets with the highest values have them by chance: the posterior collapses onto a few of them. But the true
// logarithm changes smoothly with the parameters, so neighbouring sets tell what is noise. It is estimated by a
// Gaussian process with a quadratic trend and noise: R. D. Wilkinson, "Accelerating ABC methods using Gaussian
// processes", Artificial Intelligence and Statistics (2014) 1015-1023; M. Jarvenpaa, M. U. Gutmann, A. Vehtari, P.
// Marttinen, "Parallel Gaussian process surrogate Bayesian inference with noisy likelihood evaluations", Bayesian
// Analysis 16 (2021) 147-178. How smooth and how noisy is found by restricted maximum likelihood (C. E. Rasmussen, C.
// K. I. Williams, "Gaussian Processes for Machine Learning" (2006), section 2.7 and chapter 5), so that values without
// noise stay as they are.

#include <span>
#include <vector>

#include "talus/calibration/sampler.hpp"

namespace talus::calibration {

struct SmoothedLikelihoods {
  std::vector<double> values;  // of each place
  double noise = 0;            // standard deviation of the noise that was found near the greatest
};

/// Values that cannot matter, because they are far below the greatest, and infinite ones stay as they are; so do all if
/// they are too few for a trend. Expects one value for each place.
[[nodiscard]] SmoothedLikelihoods smoothed_likelihoods(std::span<const Place> places,
                                                       std::span<const double> log_likelihoods);

}  // namespace talus::calibration
