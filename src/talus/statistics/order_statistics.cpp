#include "talus/statistics/order_statistics.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>

#include "talus/core/check.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

/// P(B <= k) and P(B > k), B binomial (n, p). Each is computed directly, because 1 minus the other would lose digits.
double at_most(std::uint64_t k, std::uint64_t n, double p) {
  if (k >= n) return 1;
  if (p <= 0 || p >= 1) return p <= 0 ? 1 : 0;
  return boost::math::ibetac(static_cast<double>(k) + 1, static_cast<double>(n - k), p);
}
double more_than(std::uint64_t k, std::uint64_t n, double p) {
  if (k >= n) return 0;
  if (p <= 0 || p >= 1) return p <= 0 ? 0 : 1;
  return boost::math::ibeta(static_cast<double>(k) + 1, static_cast<double>(n - k), p);
}

/// The first k in [0, n) at which a monotone condition is true; n if there is none.
template <class Condition>
std::uint64_t first(std::uint64_t n, Condition&& is_true) {
  std::uint64_t low = 0, high = n;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (is_true(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

}  // namespace

RankBounds quantile_rank_bounds(double p, std::uint64_t count, double confidence) {
  TALUS_PROMISE(p >= 0 && p <= 1 && confidence > 0 && confidence < 1, "p and the confidence must be probabilities");
  const double tail = 0.5 * (1 - confidence);
  RankBounds bounds;
  const std::uint64_t too_high = first(count, [&](std::uint64_t k) { return at_most(k, count, p) > tail; });
  if (too_high > 0) bounds.low = too_high - 1;
  const std::uint64_t high = first(count, [&](std::uint64_t k) { return more_than(k, count, p) <= tail; });
  if (high < count) bounds.high = high;
  return bounds;
}

ShareBounds share_bounds(std::uint64_t hits, std::uint64_t trials, double confidence) {
  TALUS_PROMISE(hits <= trials && trials > 0 && confidence > 0 && confidence < 1,
                "a share needs trials and a confidence in (0, 1)");
  const double tail = 0.5 * (1 - confidence);
  const auto k = static_cast<double>(hits), others = static_cast<double>(trials - hits);
  return {hits == 0 ? 0 : boost::math::ibeta_inv(k, others + 1, tail),
          hits == trials ? 1 : boost::math::ibetac_inv(k + 1, others, tail)};
}

RankedValues::RankedValues(const QuantileSketch& sketch)
    : count_(sketch.count()), minimum_(*sketch.quantile(0)), maximum_(*sketch.quantile(1)), up_to_(sketch.ascending()) {
  std::uint64_t sum = 0;
  for (QuantileSketch::Counted& each : up_to_) each.count = sum += each.count;
}

double RankedValues::at(std::uint64_t rank) const {
  TALUS_PROMISE(rank < count_, "the rank must be below the number of values");
  if (rank == 0) return minimum_;  // exact, unlike a bin
  if (rank + 1 == count_) return maximum_;
  return std::ranges::upper_bound(up_to_, rank, {}, &QuantileSketch::Counted::count)->value;
}

double RankedValues::quantile(double p) const {
  const auto [rank, fraction] = quantile_place(p, count_);
  const double low = at(rank);
  return fraction > 0 ? between(low, at(rank + 1), fraction) : low;
}

Estimate RankedValues::estimate(double p, double confidence) const {
  Estimate estimate{quantile(p), {}, {}};
  const RankBounds ranks = quantile_rank_bounds(p, count_, confidence);
  if (ranks.low) estimate.low = at(*ranks.low);
  if (ranks.high) estimate.high = at(*ranks.high);
  if (estimate.low) estimate.value = std::max(estimate.value, *estimate.low);
  if (estimate.high) estimate.value = std::min(estimate.value, *estimate.high);
  return estimate;
}

}  // namespace talus
