#include "talus/statistics/paired_differences.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "talus/core/check.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

/// One quantity of some of the rows.
class RankedRows {
 public:
  void add(std::uint32_t row, double value) { descending_.push_back({value, row}); }
  void sort() {
    std::ranges::sort(descending_, [](const Ranked& a, const Ranked& b) {
      return a.value != b.value ? a.value > b.value : a.row < b.row;
    });
  }
  [[nodiscard]] std::uint64_t count(std::span<const std::uint32_t> weights) const {
    std::uint64_t sum = 0;
    for (const Ranked& each : descending_) sum += weights[each.row];
    return sum;
  }
  /// Definition 7 where each value counts as often as its row; `count` in all, at least one.
  [[nodiscard]] double quantile(std::span<const std::uint32_t> weights, std::uint64_t count, double p) const {
    const QuantilePlace place = quantile_place(p, count);
    // From the largest on: the quantiles of interest are near the end.
    const std::uint64_t upper = count - 1 - std::min<std::uint64_t>(place.rank + 1, count - 1);
    const std::uint64_t lower = count - 1 - place.rank;
    std::uint64_t passed = 0;
    std::optional<double> high;
    for (const Ranked& each : descending_) {
      passed += weights[each.row];
      if (!high && passed > upper) high = each.value;
      if (passed > lower) return between(each.value, *high, place.fraction);
    }
    TALUS_PROMISE(false, "there are `count` values");
    return *high;
  }

 private:
  struct Ranked {
    double value;
    std::uint32_t row;
  };
  std::vector<Ranked> descending_;
};

using Quantities = std::array<RankedRows, MemberValues::quantities>;

bool has_interval(std::uint64_t count, double p, double confidence) {
  const RankBounds bounds = quantile_rank_bounds(p, count, confidence);
  return bounds.low && bounds.high;
}

}  // namespace

Estimate paired_share_difference(std::uint64_t gained, std::uint64_t lost, std::uint64_t members, double confidence) {
  const auto n = static_cast<double>(members), b = static_cast<double>(gained), c = static_cast<double>(lost);
  const double more = (b + 1) / (n + 2), less = (c + 1) / (n + 2), difference = more - less;
  const double z = quantile(boost::math::normal(), (1 + confidence) / 2);
  const double half = z * std::sqrt((more + less - difference * difference) / (n + 2));
  return {.value = (b - c) / n, .low = std::max(difference - half, -1.0), .high = std::min(difference + half, 1.0)};
}

std::optional<std::array<Estimate, MemberValues::quantities>> paired_quantile_differences(
    std::span<const MemberValues> without, std::span<const MemberValues> with, double p, const Bootstrap& bootstrap) {
  if (without.empty() || with.empty()) return std::nullopt;
  Quantities before, after;
  std::uint32_t rows = 0;
  const auto add = [&](Quantities& to, const MemberValues& member) {
    for (std::size_t q = 0; q < to.size(); ++q) to[q].add(rows, member.values[q]);
  };
  for (std::size_t i = 0, k = 0; i < without.size() || k < with.size(); ++rows) {
    const bool in_without = i < without.size() && (k == with.size() || without[i].member <= with[k].member);
    const bool in_with = k < with.size() && (i == without.size() || with[k].member <= without[i].member);
    if (in_without) add(before, without[i++]);
    if (in_with) add(after, with[k++]);
  }
  for (std::size_t q = 0; q < before.size(); ++q) {
    before[q].sort();
    after[q].sort();
  }
  std::vector<std::uint32_t> weights(rows);
  const auto differences = [&](std::span<const std::size_t> chosen) -> std::vector<double> {
    std::ranges::fill(weights, 0);
    for (const std::size_t row : chosen) ++weights[row];
    const std::uint64_t of_before = before.front().count(weights), of_after = after.front().count(weights);
    if (of_before == 0 || of_after == 0) return {};
    std::vector<double> found;
    for (std::size_t q = 0; q < before.size(); ++q)
      found.push_back(after[q].quantile(weights, of_after, p) - before[q].quantile(weights, of_before, p));
    return found;
  };
  Bootstrap how = bootstrap;
  const bool is_enough =
      has_interval(without.size(), p, bootstrap.confidence) && has_interval(with.size(), p, bootstrap.confidence);
  if (!is_enough) how.replicas = 0;
  const std::vector<Estimate> estimates = bootstrap_estimates(rows, differences, how);
  std::array<Estimate, MemberValues::quantities> all;
  for (std::size_t q = 0; q < all.size(); ++q) all[q] = estimates[q];
  return all;
}

}  // namespace talus
