#include "talus/statistics/sobol.hpp"

#include <algorithm>
#include <boost/random/sobol.hpp>

#include "talus/core/check.hpp"
#include "talus/statistics/counted_draws.hpp"

namespace talus {

namespace {

constexpr std::size_t least_rows = 4;

/// Coordinates of a shifted Sobol point from its 64-bit ones: the middle of one of 2^52 cells, never 0 or 1.
double coordinate(std::uint64_t bits, std::uint64_t shift) {
  return (static_cast<double>((bits ^ shift) >> 12) + 0.5) * 0x1p-52;
}

/// f(A), f(B), f(A_1), ..., f(A_k) of the rows that are defined, about their mean.
struct CompleteRows {
  std::size_t inputs, width, count = 0;
  double mean = 0;
  std::vector<double> values;

  CompleteRows(std::span<const std::optional<double>> results, std::size_t k) : inputs(k), width(k + 2) {
    for (std::size_t begin = 0; begin + width <= results.size(); begin += width) {
      const auto row = results.subspan(begin, width);
      if (!std::ranges::all_of(row, [](const auto& value) { return value.has_value(); })) continue;
      for (const auto& value : row) values.push_back(*value);
      ++count;
    }
    // A and B alone are independent points.
    for (std::size_t i = 0; i < count; ++i) mean += a(i) + b(i);
    mean /= 2 * static_cast<double>(std::max<std::size_t>(count, 1));
    for (double& value : values) value -= mean;
  }
  [[nodiscard]] double a(std::size_t row) const { return values[row * width]; }
  [[nodiscard]] double b(std::size_t row) const { return values[row * width + 1]; }
  [[nodiscard]] double with(std::size_t row, std::size_t input) const { return values[row * width + 2 + input]; }

  /// Exactly 0 if A and B have one value in all of these rows.
  [[nodiscard]] double variance(std::span<const std::size_t> rows) const {
    const double origin = a(rows.front());
    double sum = 0, squares = 0;
    for (const std::size_t row : rows) {
      for (const double value : {a(row) - origin, b(row) - origin}) {
        sum += value;
        squares += value * value;
      }
    }
    const double n = 2 * static_cast<double>(rows.size());
    return squares / n - (sum / n) * (sum / n);
  }

  /// First-order indices of all inputs, then total ones; none if these rows do not vary.
  [[nodiscard]] std::vector<double> indices(std::span<const std::size_t> rows) const {
    const double v = variance(rows);
    if (!(v > 0)) return {};
    std::vector<double> first(inputs, 0.0), total(inputs, 0.0);
    for (const std::size_t row : rows) {
      for (std::size_t i = 0; i < inputs; ++i) {
        const double change = with(row, i) - a(row);
        first[i] += b(row) * change;
        total[i] += change * change / 2;
      }
    }
    first.insert(first.end(), total.begin(), total.end());
    for (double& each : first) each /= v * static_cast<double>(rows.size());
    return first;
  }
};

}  // namespace

SobolDesign::SobolDesign(const SobolPlan& plan) : plan_(plan) {
  TALUS_PROMISE(plan.inputs > 0 && plan.rows >= least_rows, "indices need inputs and rows");
  const std::size_t k = plan.inputs;
  boost::random::sobol sequence(2 * k);
  const CountedDraws draws(plan.seed, CountedDraws::Purpose::shift);
  std::vector<double> row(2 * k);
  for (std::size_t number = 0; number < plan.rows; ++number) {
    // The generator leaves out the sequence's first point, the origin, with which 2^m points are the most even.
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = coordinate(number == 0 ? 0 : sequence(), draws.bits(i, 0));
    const std::vector<double> a(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(k)),
        b(row.begin() + static_cast<std::ptrdiff_t>(k), row.end());
    points_.push_back(a);
    points_.push_back(b);
    for (std::size_t i = 0; i < k; ++i) points_.emplace_back(a)[i] = b[i];
  }
}

std::optional<SobolIndices> SobolDesign::indices(std::span<const std::optional<double>> results,
                                                 const Bootstrap& bootstrap) const {
  TALUS_PROMISE(results.size() == points_.size(), "one result a point");
  const CompleteRows rows(results, plan_.inputs);
  if (rows.count < least_rows) return std::nullopt;
  const auto estimates = bootstrap_estimates(
      rows.count, [&](std::span<const std::size_t> chosen) { return rows.indices(chosen); }, bootstrap);
  SobolIndices all{.mean = rows.mean, .variance = 0, .rows = rows.count, .inputs = {}};
  if (estimates.empty()) return all;
  std::vector<std::size_t> every(rows.count);
  for (std::size_t i = 0; i < rows.count; ++i) every[i] = i;
  all.variance = rows.variance(every);
  for (std::size_t i = 0; i < plan_.inputs; ++i)
    all.inputs.push_back({.first = estimates[i], .total = estimates[plan_.inputs + i]});
  return all;
}

}  // namespace talus
