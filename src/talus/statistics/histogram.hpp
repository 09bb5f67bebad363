#pragma once
// Counts of values in bins of equal width.

#include <cstdint>
#include <optional>
#include <vector>

namespace talus {

/// Edges of bins of equal width at round numbers: multiples of 1, 2 or 5 times a power of ten. Kept as integers, so
/// that an edge is the double nearest to its decimal (0.3, not 0.30000000000000004).
struct BinEdges {
  std::int64_t first = 0;  // the lowest edge, in steps
  int step_digit = 1;      // 1, 2 or 5
  int step_exponent = 0;   // power of ten
  std::uint64_t bins = 1;

  /// Edge number i, from 0 to `bins`.
  [[nodiscard]] double edge(std::uint64_t i) const;
  [[nodiscard]] friend bool operator==(const BinEdges&, const BinEdges&) = default;
};

/// The narrowest such bins, at most `most_bins`, from `least` to `most`. Expects finite numbers below 1e100, least <=
/// most, and 2 to 1000 bins. If the two are equal, or too close for distinct edges, the bins reach further.
[[nodiscard]] BinEdges nice_bins(double least, double most, std::uint64_t most_bins);

/// The narrowest bins, at most `most_bins`, that cover both and are made of whole bins of both: two histograms with
/// different bins can be counted again in these, exactly. Expects 2 bins or more.
[[nodiscard]] BinEdges common_bins(const BinEdges& a, const BinEdges& b, std::uint64_t most_bins);

/// Edges that start at `low` and are `width` apart, if nice_bins() could have made them, up to rounding.
[[nodiscard]] std::optional<BinEdges> bins_from(double low, double width, std::uint64_t bins);

/// A bin includes its lower edge but not its upper one; the last includes both. Counts are integers: the order does not
/// matter.
class Histogram {
 public:
  explicit Histogram(const BinEdges& edges) : edges_(edges), counts_(edges.bins) {}

  /// Expects a finite number.
  void add(double x, std::uint64_t count = 1);
  /// Adds to a bin by its zero-based number.
  void add_to(std::uint64_t bin, std::uint64_t count) { counts_[bin] += count; }
  /// Expects the same edges.
  void merge(const Histogram& other);

  /// The same counts in wider bins that are made of whole ones of these, as from common_bins().
  [[nodiscard]] Histogram regrouped(const BinEdges& wider) const;

  [[nodiscard]] const BinEdges& edges() const { return edges_; }
  [[nodiscard]] const std::vector<std::uint64_t>& counts() const { return counts_; }
  [[nodiscard]] std::uint64_t underflow() const { return underflow_; }
  [[nodiscard]] std::uint64_t overflow() const { return overflow_; }
  /// The number of all values, including those outside the bins.
  [[nodiscard]] std::uint64_t total() const;

 private:
  BinEdges edges_;
  std::vector<std::uint64_t> counts_;
  std::uint64_t underflow_ = 0, overflow_ = 0;
};

}  // namespace talus
