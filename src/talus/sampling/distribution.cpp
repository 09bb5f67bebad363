#include "talus/sampling/distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>

#include "talus/core/check.hpp"
#include "talus/sampling/normal_quantile.hpp"

namespace talus {

namespace {

// In the kernel nothing throws or sets errno: results that Boost cannot evaluate are limited to the range of the draws.
using Quiet = boost::math::policies::policy<
    boost::math::policies::domain_error<boost::math::policies::ignore_error>,
    boost::math::policies::pole_error<boost::math::policies::ignore_error>,
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::underflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::denorm_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>,
    boost::math::policies::rounding_error<boost::math::policies::ignore_error>,
    boost::math::policies::indeterminate_result_error<boost::math::policies::ignore_error>,
    boost::math::policies::promote_double<false>>;
using Beta = boost::math::beta_distribution<double, Quiet>;
using Gamma = boost::math::gamma_distribution<double, Quiet>;

constexpr double no_limit = 1e300;

// The numbers of an Untruncated:
//   normal       mean, standard deviation
//   uniform      start, width
//   triangular   start, mode, end
//   beta         alpha, beta, start, width
//   exponential  start, mean distance from it
//   lognormal    mean and standard deviation of the logarithm
//   gamma        shape, scale
Untruncated untruncated(const Distribution& given) {
  const double m = given.mean;
  const double s = given.std_dev.value_or(0);
  const auto start = [&](double without_limit) { return m - given.rel_min.value_or(without_limit); };
  const auto end = [&](double without_limit) { return m + given.rel_max.value_or(without_limit); };
  switch (given.kind) {
    case DistributionKind::none:
    case DistributionKind::empirical:
      break;
    case DistributionKind::normal:
      return {given.kind, m, s, 0, 0};
    case DistributionKind::uniform: {
      const double half_width = std::sqrt(3.0) * s;
      return {given.kind, start(half_width), end(half_width) - start(half_width), 0, 0};
    }
    case DistributionKind::triangular: {
      const double half_width = std::sqrt(6.0) * s;
      const double a = start(half_width), b = end(half_width);
      return {given.kind, a, std::clamp(3 * m - a - b, a, b), b, 0};  // the mean of a triangle is (a + mode + b) / 3
    }
    case DistributionKind::beta: {
      // By moments: with mean and standard deviation as shares of the width, alpha + beta = mean (1 - mean) / var - 1.
      const double a = start(0), width = end(0) - a;
      const double mean = (m - a) / width, deviation = s / width;
      const double both = mean * (1 - mean) / (deviation * deviation) - 1;
      return {given.kind, mean * both, (1 - mean) * both, a, width};
    }
    case DistributionKind::exponential: {
      const double distance = given.std_dev.value_or(m);
      return {given.kind, m - distance, distance, 0, 0};
    }
    case DistributionKind::lognormal: {
      const double variance = std::log1p((s / m) * (s / m));
      return {given.kind, std::log(m) - variance / 2, std::sqrt(variance), 0, 0};
    }
    case DistributionKind::gamma:
      return {given.kind, (m / s) * (m / s), s * (s / m), 0, 0};
  }
  return {};
}

// The probabilities below and above x, each with full relative precision.
struct Tails {
  double below, above;
};

Tails normal_tails(double z) {
  const double x = z / std::sqrt(2.0);
  return {boost::math::erfc(-x, Quiet()) / 2, boost::math::erfc(x, Quiet()) / 2};
}

Tails tails(const Untruncated& base, double x) {
  switch (base.kind) {
    case DistributionKind::none:
    case DistributionKind::empirical:
      break;
    case DistributionKind::normal:
      return normal_tails((x - base.first) / base.second);
    case DistributionKind::uniform: {
      const double below = std::clamp((x - base.first) / base.second, 0.0, 1.0);
      return {below, 1 - below};
    }
    case DistributionKind::triangular: {
      const double a = base.first, mode = base.second, b = base.third;
      if (x <= a) return {0, 1};
      if (x >= b) return {1, 0};
      if (x <= mode) {
        const double below = (x - a) / (b - a) * ((x - a) / (mode - a));
        return {below, 1 - below};
      }
      const double above = (b - x) / (b - a) * ((b - x) / (b - mode));
      return {1 - above, above};
    }
    case DistributionKind::beta: {
      const double part = std::clamp((x - base.third) / base.fourth, 0.0, 1.0);
      const Beta beta(base.first, base.second);
      return {cdf(beta, part), cdf(complement(beta, part))};
    }
    case DistributionKind::exponential: {
      const double distance = std::max(0.0, (x - base.first) / base.second);
      return {-std::expm1(-distance), std::exp(-distance)};
    }
    case DistributionKind::lognormal:
      if (x <= 0) return {0, 1};
      return normal_tails((std::log(x) - base.first) / base.second);
    case DistributionKind::gamma: {
      if (x <= 0) return {0, 1};
      const Gamma gamma(base.first, base.second);
      return {cdf(gamma, x), cdf(complement(gamma, x))};
    }
  }
  return {0, 1};
}

// The x with these probabilities below and above it; the smaller of the two is used.
double quantile_of(const Untruncated& base, Tails at) {
  const bool is_left = at.below < at.above;
  switch (base.kind) {
    case DistributionKind::none:
    case DistributionKind::empirical:
      break;
    case DistributionKind::normal:
      return base.first + base.second * normal_quantile(at.below, at.above);
    case DistributionKind::uniform:
      return base.first + base.second * at.below;
    case DistributionKind::triangular: {
      const double a = base.first, mode = base.second, b = base.third;
      return at.below * (b - a) <= mode - a ? a + std::sqrt(at.below * (b - a) * (mode - a))
                                            : b - std::sqrt(at.above * (b - a) * (b - mode));
    }
    case DistributionKind::beta: {
      const Beta beta(base.first, base.second);
      return base.third + base.fourth * (is_left ? quantile(beta, at.below) : quantile(complement(beta, at.above)));
    }
    case DistributionKind::exponential:
      return base.first - base.second * (is_left ? std::log1p(-at.below) : std::log(at.above));
    case DistributionKind::lognormal:
      return std::exp(base.first + base.second * normal_quantile(at.below, at.above));
    case DistributionKind::gamma: {
      const Gamma gamma(base.first, base.second);
      return is_left ? quantile(gamma, at.below) : quantile(complement(gamma, at.above));
    }
  }
  return 0;
}

// The range of the draws: the relative limits and the bounds combined.
Bounds limits_of(const Distribution& given, Bounds bounds) {
  return {std::max(given.rel_min ? given.mean - *given.rel_min : -no_limit, bounds.least),
          std::min(given.rel_max ? given.mean + *given.rel_max : no_limit, bounds.most)};
}

}  // namespace

Sampler::Sampler(const Distribution& distribution, Bounds bounds, double scale) : scale_(scale) {
  TALUS_PROMISE(!why_unusable(distribution, bounds), "the distribution has been checked");
  if (distribution.kind == DistributionKind::none) {
    value_ = distribution.mean * scale;
    return;
  }
  if (distribution.kind == DistributionKind::empirical) {
    base_.kind = distribution.kind;
    sample_ = distribution.sample;
    return;
  }
  base_ = untruncated(distribution);
  const Bounds limits = limits_of(distribution, bounds);
  low_ = limits.least;
  high_ = limits.most;
  const Tails at_low = tails(base_, low_);
  const Tails at_high = tails(base_, high_);
  below_low_ = at_low.below;
  above_high_ = at_high.above;
  span_below_ = at_high.below - at_low.below;
  span_above_ = at_low.above - at_high.above;
}

double Sampler::draw_random(double u) const {
  if (sample_) return sample_->quantile(u) * scale_;
  const Tails at{below_low_ + span_below_ * u, above_high_ + span_above_ * (1 - u)};
  const double x = quantile_of(base_, at);
  // In this order a NaN, if Boost ever returns one, becomes the lower limit.
  const double not_below = x > low_ ? x : low_;
  return (not_below < high_ ? not_below : high_) * scale_;
}

std::vector<Density> density_of(const Distribution& distribution, Bounds bounds, std::size_t intervals) {
  const bool has_density =
      distribution.kind != DistributionKind::none && distribution.kind != DistributionKind::empirical;
  if (!has_density || intervals == 0) return {};
  const Untruncated base = untruncated(distribution);
  const Bounds limits = limits_of(distribution, bounds);
  const Sampler sampler(distribution, bounds);
  constexpr double tail = 1e-3;
  constexpr double near = 0.2;  // a limit this near, as a share of the width without tails, is shown
  const double first = sampler.draw(tail), last = sampler.draw(1 - tail), width = last - first;
  const double low = limits.least > first - near * width ? limits.least : first;
  const double high = limits.most < last + near * width ? limits.most : last;

  // The difference of probabilities with more digits: of those below x in the lower half, above x in the upper.
  const auto part = [](const Tails& left, const Tails& right) {
    return left.below < left.above ? right.below - left.below : left.above - right.above;
  };
  const double whole = part(tails(base, limits.least), tails(base, limits.most));
  const double step = (high - low) / static_cast<double>(intervals);
  std::vector<Density> list;
  for (std::size_t k = 0; k < intervals; ++k) {
    const double left = low + static_cast<double>(k) * step, right = low + static_cast<double>(k + 1) * step;
    list.push_back({0.5 * (left + right), part(tails(base, left), tails(base, right)) / (right - left) / whole});
  }
  return list;
}

Truncation truncation_of(const Distribution& distribution, Bounds bounds) {
  const Untruncated base = untruncated(distribution);
  const Bounds limits = limits_of(distribution, bounds);
  const Tails low = tails(base, limits.least), high = tails(base, limits.most);
  const Sampler sampler(distribution, bounds);
  constexpr int parts = 500;  // of equal probability
  Truncation found{.kept = 1 - low.below - high.above,
                   .least = low.below > 0 ? limits.least : sampler.draw(1e-12),
                   .most = high.above > 0 ? limits.most : sampler.draw(1 - 1e-12)};
  // An almost untruncated distribution keeps its mean, which a sum over few parts of a long tail would miss.
  const bool may_shift_mean =
      base.kind == DistributionKind::uniform || base.kind == DistributionKind::triangular || found.kept < 0.999;
  if (!may_shift_mean) {
    found.mean = distribution.mean;
    return found;
  }
  for (int k = 0; k < parts; ++k) found.mean += sampler.draw((k + 0.5) / parts) / parts;
  return found;
}

namespace {

const char* name_of(DistributionKind kind) {
  switch (kind) {
    case DistributionKind::none:
      return "none";
    case DistributionKind::normal:
      return "normal";
    case DistributionKind::uniform:
      return "uniform";
    case DistributionKind::triangular:
      return "triangular";
    case DistributionKind::beta:
      return "beta";
    case DistributionKind::exponential:
      return "exponential";
    case DistributionKind::lognormal:
      return "lognormal";
    case DistributionKind::gamma:
      return "gamma";
    case DistributionKind::empirical:
      return "empirical";
  }
  return "";
}

std::string expected(Bounds bounds) {
  if (bounds.least <= -no_limit) return fmt::format("expected at most {}", bounds.most);
  if (bounds.most >= no_limit) return fmt::format("expected at least {}", bounds.least);
  return fmt::format("expected {} to {}", bounds.least, bounds.most);
}

using Fault = std::optional<std::string>;

Fault fault_in_numbers(const Distribution& given, Bounds bounds) {
  if (!std::isfinite(given.mean)) return fmt::format("mean is {} (expected a finite number)", given.mean);
  if (given.mean < bounds.least || given.mean > bounds.most) {
    return fmt::format("mean is {} ({})", given.mean, expected(bounds));
  }
  if (given.std_dev && !(std::isfinite(*given.std_dev) && *given.std_dev >= 0)) {
    return fmt::format("std_dev is {} (expected a finite number above 0)", *given.std_dev);
  }
  for (const auto& [name, value] : {std::pair{"rel_min", given.rel_min}, std::pair{"rel_max", given.rel_max}}) {
    if (value && !(std::isfinite(*value) && *value >= 0)) {
      return fmt::format(
          "{} is {} (it is a distance from the mean: finite and not negative). For no limit, leave it out", name,
          *value);
    }
  }
  return {};
}

}  // namespace

bool is_given_by_its_limits(const Distribution& given) {
  const bool is_flat_sided = given.kind == DistributionKind::uniform || given.kind == DistributionKind::triangular;
  return is_flat_sided && given.rel_min && given.rel_max;
}

namespace {

Fault missing_parameter(const Distribution& given) {
  const char* kind = name_of(given.kind);
  switch (given.kind) {
    case DistributionKind::none:
    case DistributionKind::empirical:
      return {};
    case DistributionKind::normal:
    case DistributionKind::lognormal:
    case DistributionKind::gamma:
      if (!given.std_dev) return fmt::format("std_dev is missing (the {} distribution needs it)", kind);
      break;
    case DistributionKind::uniform:
    case DistributionKind::triangular:
      if (is_given_by_its_limits(given)) return {};
      if (!given.std_dev) {
        return fmt::format("limits are missing (the {} distribution needs rel_min and rel_max, or std_dev)", kind);
      }
      break;
    case DistributionKind::beta:
      if (!given.std_dev) return "std_dev is missing (the beta distribution needs it)";
      if (!given.rel_min || !given.rel_max)
        return "limits are missing (the beta distribution needs rel_min and rel_max)";
      break;
    case DistributionKind::exponential:
      if (!given.std_dev && given.mean <= 0) {
        return fmt::format(
            "std_dev is missing (the exponential distribution then uses the mean, which is {}, not above 0)",
            given.mean);
      }
      break;
  }
  if (given.std_dev && *given.std_dev == 0) {
    return fmt::format(
        "std_dev is 0 (the {} distribution needs one above 0). For a constant, use distribution = \"none\"", kind);
  }
  return {};
}

// Below the smaller ratio, gamma and beta are practically normal, and Boost's quantiles slow or wrong. A ratio above
// the larger one is considered a mistake.
constexpr double least_deviation = 1e-4;
constexpr double most_deviation_of_mean = 10;
constexpr double most_variance_of_beta = 0.99;
// Boost's quantile of a beta distribution throws if a limit is further away than 1e14 standard deviations.
constexpr double max_width_of_beta = 1e12;
constexpr double least_probability = 1e-6;

Fault fault_in_shape(const Distribution& given) {
  const char* kind = name_of(given.kind);
  if (given.kind == DistributionKind::lognormal || given.kind == DistributionKind::gamma) {
    if (given.mean <= 0) {
      return fmt::format("mean is {} (the {} distribution has positive values only)", given.mean, kind);
    }
    if (*given.std_dev > most_deviation_of_mean * given.mean) {
      return fmt::format("std_dev is {} (the {} distribution expects at most {} times the mean, {:.6g})",
                         *given.std_dev, kind, most_deviation_of_mean, most_deviation_of_mean * given.mean);
    }
    if (*given.std_dev < least_deviation * given.mean) {
      return fmt::format(
          "std_dev is {} (the {} distribution expects at least {} times the mean, {:.6g}). For less, use \"normal\"",
          *given.std_dev, kind, least_deviation, least_deviation * given.mean);
    }
  }
  if (given.kind == DistributionKind::beta) {
    const double left = *given.rel_min, right = *given.rel_max, s = *given.std_dev;
    if (left == 0 || right == 0) {
      return fmt::format("{} is 0 (the mean of a beta distribution is between its limits, not on one)",
                         left == 0 ? "rel_min" : "rel_max");
    }
    const double most = std::sqrt(most_variance_of_beta * left * right);
    if (s > most) {
      return fmt::format("std_dev is {} (a beta distribution with these limits can have at most {:.4g})", s, most);
    }
    const double least = least_deviation * std::min(left, right);
    if (s < least) {
      return fmt::format(
          "std_dev is {} (a beta distribution with these limits expects at least {:.4g}). For less, use "
          "\"normal\"",
          s, least);
    }
    if (std::max(left, right) > max_width_of_beta * s) {
      return fmt::format(
          "{} is {:.4g} (a beta distribution expects at most {:g} times its std_dev, {:.4g}). Without a limit on one side, "
          "use \"gamma\" or \"lognormal\"",
          left > right ? "rel_min" : "rel_max", std::max(left, right), max_width_of_beta, max_width_of_beta * s);
    }
  }
  return {};
}

Fault fault_in_limits(const Distribution& given, Bounds bounds) {
  const Bounds limits = limits_of(given, bounds);
  if (!(limits.least < limits.most)) {
    return fmt::format(
        "rel_min and rel_max allow only the value {} (a random property needs a range). For a constant, use "
        "distribution = "
        "\"none\"",
        limits.most);
  }
  const Untruncated base = untruncated(given);
  // Written so that NaN is also refused.
  if (!(tails(base, limits.most).below - tails(base, limits.least).below >= least_probability)) {
    return fmt::format(
        "the limits {} to {} leave less than a millionth of the {} distribution (its std_dev is {}). Compare the units "
        "of std_dev and of the limits",
        limits.least, limits.most, name_of(given.kind), given.std_dev.value_or(given.mean));
  }
  return {};
}

}  // namespace

std::optional<std::string> why_unusable(const Distribution& distribution, Bounds bounds) {
  if (distribution.kind == DistributionKind::empirical) {
    if (!distribution.sample) return "has no sample (its values are in a file)";
    const EmpiricalSample& sample = *distribution.sample;
    if (sample.least() >= bounds.least && sample.most() <= bounds.most) return {};
    return fmt::format("has values from {} to {} ({})", sample.least(), sample.most(), expected(bounds));
  }
  if (Fault message = fault_in_numbers(distribution, bounds)) return message;
  if (distribution.kind == DistributionKind::none) return {};
  if (Fault message = missing_parameter(distribution)) return message;
  if (Fault message = fault_in_shape(distribution)) return message;
  return fault_in_limits(distribution, bounds);
}

}  // namespace talus
