#include "talus/calibration/sampler.hpp"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <Eigen/Dense>

#include "talus/core/check.hpp"
#include "talus/core/random.hpp"
#include "talus/core/stop.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::calibration {

namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The random numbers of the sampler: a Philox stream per purpose, apart from those of rocks.
enum class SamplerDraw : std::uint32_t { shift = 1000, centre = 1001, step = 1002 };

std::array<double, 2> uniform(std::uint64_t seed, std::uint64_t item, SamplerDraw purpose, std::uint32_t index) {
  return uniform_pair(seed, item, static_cast<Stream>(purpose), index);
}

/// The least number of equally good points from which a covariance of this many dimensions is estimated.
double least_effective_size(std::size_t dimensions) {
  return std::max(enough_effective_sets, 10.0 * static_cast<double>(dimensions));
}

constexpr double narrowest = 1e-4;  // standard deviation of a kernel, as a share of the prior

}  // namespace

double effective_size(std::span<const double> weights) {
  double squares = 0;
  for (const double weight : weights) squares += weight * weight;
  return squares > 0 ? 1 / squares : 0;
}

double weighted_quantile(std::span<const double> values, std::span<const double> weights, double q) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  double below = 0;
  for (const std::size_t k : order) {
    below += weights[k];
    if (below >= q * all && weights[k] > 0) return values[k];
  }
  return values[order.back()];
}

Sampler::Sampler(std::size_t dimensions, std::uint64_t seed) : dimensions_(dimensions), seed_(seed) {}

std::vector<Place> Sampler::next_round(std::size_t count) {
  TALUS_PROMISE(log_likelihoods_.size() == places_.size(), "the likelihoods of earlier rounds are known");
  std::vector<Place> round;
  round.reserve(count);
  if (rounds_.empty()) {
    // Sobol points, all shifted by one random vector modulo 1 (R. Cranley, T. N. L. Patterson, SIAM Journal on
    // Numerical Analysis 13 (1976) 904-914), so that different seeds have different points. The first point is left
    // out.
    boost::random::sobol sequence(dimensions_);
    const double range = static_cast<double>(boost::random::sobol::max()) + 1;
    sequence.discard(dimensions_);
    for (std::size_t k = 0; k < count; ++k) {
      Place place(dimensions_);
      for (std::size_t d = 0; d < dimensions_; ++d) {
        const double shifted = (static_cast<double>(sequence()) + 0.5) / range +
                               uniform(seed_, 0, SamplerDraw::shift, static_cast<std::uint32_t>(d))[0];
        place[d] = std::clamp(shifted - std::floor(shifted), 1e-12, 1 - 1e-12);
      }
      round.push_back(std::move(place));
    }
    rounds_.push_back({});
  } else {
    Kernels kernels = kernels_around(weights());
    std::uint64_t tries = 0;
    const std::uint64_t first = (rounds_.size() + 1) << 40U;  // other numbers in each round
    while (round.size() < count) {
      stop_point(tries);
      const std::uint64_t item = first + tries++;
      const double pick = uniform(seed_, item, SamplerDraw::centre, 0)[0];
      const auto chosen = static_cast<std::size_t>(
          std::lower_bound(kernels.cumulated.begin(), kernels.cumulated.end() - 1, pick) - kernels.cumulated.begin());
      std::vector<double> normal(dimensions_);
      for (std::size_t d = 0; d < dimensions_; d += 2) {  // Box and Muller
        const auto [a, b] = uniform(seed_, item, SamplerDraw::step, static_cast<std::uint32_t>(d));
        const double size = std::sqrt(-2 * std::log(a));
        normal[d] = size * std::cos(2 * std::numbers::pi * b);
        if (d + 1 < dimensions_) normal[d + 1] = size * std::sin(2 * std::numbers::pi * b);
      }
      Place place = places_[kernels.centres[chosen]];
      bool is_inside = true;
      for (std::size_t d = 0; d < dimensions_; ++d) {
        for (std::size_t e = 0; e <= d; ++e) place[d] += kernels.factor[d * dimensions_ + e] * normal[e];
        is_inside = is_inside && place[d] > 0 && place[d] < 1;
      }
      if (is_inside) round.push_back(std::move(place));
    }
    kernels.log_norm -= std::log(static_cast<double>(count) / static_cast<double>(tries));
    rounds_.push_back(std::move(kernels));
  }
  rounds_.back().count = count;
  places_.insert(places_.end(), round.begin(), round.end());
  return round;
}

void Sampler::set(std::span<const double> log_likelihoods) {
  TALUS_PROMISE(log_likelihoods.size() == places_.size(), "there is a likelihood for each place");
  log_likelihoods_.assign(log_likelihoods.begin(), log_likelihoods.end());
  update_mixture();
}

Sampler::Kernels Sampler::kernels_around(std::span<const double> posterior) const {
  // Where few places carry nearly all weight, the likelihood is flattened until enough do.
  std::vector<double> weights(posterior.begin(), posterior.end());
  const double wanted = std::min(least_effective_size(dimensions_), 0.5 * static_cast<double>(places_.size()));
  double low = 0, high = 1;
  if (effective_size(weights) < wanted) {
    std::vector<double> flattened(log_likelihoods_.size());
    for (int step = 0; step < 40; ++step) {
      const double power = (low + high) / 2;
      std::transform(log_likelihoods_.begin(), log_likelihoods_.end(), flattened.begin(),
                     [power](double value) { return std::isfinite(value) ? power * value : value; });
      weights = this->weights(flattened);
      (effective_size(weights) < wanted ? high : low) = power;
    }
  }
  const auto size = static_cast<Eigen::Index>(dimensions_);
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(size);
  Matrix covariance = Matrix::Zero(size, size);
  const auto at = [&](std::size_t k) { return Eigen::Map<const Eigen::VectorXd>(places_[k].data(), size); };
  for (std::size_t k = 0; k < weights.size(); ++k) mean += weights[k] * at(k);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Eigen::VectorXd off = at(k) - mean;
    covariance += weights[k] * off * off.transpose();
  }
  covariance = 2 * covariance + narrowest * narrowest * Matrix::Identity(size, size);
  const Eigen::LLT<Matrix> decomposition(covariance);
  const Matrix factor = decomposition.matrixL();
  const Matrix inverse = factor.triangularView<Eigen::Lower>().solve(Matrix::Identity(size, size));
  Kernels kernels;
  kernels.factor.assign(factor.data(), factor.data() + factor.size());
  kernels.inverse.assign(inverse.data(), inverse.data() + inverse.size());
  kernels.log_norm = -0.5 * static_cast<double>(size) * std::log(2 * std::numbers::pi);
  for (Eigen::Index d = 0; d < size; ++d) kernels.log_norm -= std::log(factor(d, d));
  double sum = 0;
  constexpr double negligible = 1e-6;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (weights[k] < negligible) continue;
    kernels.centres.push_back(k);
    kernels.cumulated.push_back(sum += weights[k]);
  }
  for (double& each : kernels.cumulated) each /= sum;
  return kernels;
}

double Sampler::density(const Kernels& kernels, const Place& at) const {
  double density = 0, before = 0;
  std::vector<double> off(dimensions_);
  for (std::size_t k = 0; k < kernels.centres.size(); ++k) {
    const Place& centre = places_[kernels.centres[k]];
    for (std::size_t d = 0; d < dimensions_; ++d) off[d] = at[d] - centre[d];
    double squares = 0;
    for (std::size_t d = 0; d < dimensions_; ++d) {
      double z = 0;
      for (std::size_t e = 0; e <= d; ++e) z += kernels.inverse[d * dimensions_ + e] * off[e];
      squares += z * z;
    }
    density += (kernels.cumulated[k] - before) * std::exp(kernels.log_norm - 0.5 * squares);
    before = kernels.cumulated[k];
  }
  return density;
}

void Sampler::update_mixture() {
  mixture_.assign(places_.size(), 0);
  for (std::size_t k = 0; k < places_.size(); ++k) {
    stop_point();
    for (const Kernels& round : rounds_) {
      const double share = static_cast<double>(round.count) / static_cast<double>(places_.size());
      mixture_[k] += share * (round.centres.empty() ? 1 : density(round, places_[k]));
    }
  }
}

std::vector<double> Sampler::weights(std::span<const double> log_likelihoods) const {
  std::vector<double> weights(places_.size(), 0);
  const double most = *std::max_element(log_likelihoods.begin(), log_likelihoods.end());
  if (!std::isfinite(most)) return weights;
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    weights[k] = std::exp(log_likelihoods[k] - most) / mixture_[k];
    sum += weights[k];
  }
  // Truncated, so that a place far from the others whose simulated likelihood came out high by chance does not count
  // for more than many places.
  const double largest = sum / std::sqrt(static_cast<double>(weights.size()));
  double truncated = 0;
  for (double& weight : weights) truncated += weight = std::min(weight, largest);
  for (double& weight : weights) weight /= truncated;
  return weights;
}

}  // namespace talus::calibration
