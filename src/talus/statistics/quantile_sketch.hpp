#pragma once
// Quantiles of many values in bounded memory, independent of their order.

#include <cstdint>
#include <optional>
#include <vector>

#include "talus/core/bytes.hpp"

namespace talus {

/// Keeps the values themselves up to `most_exact` of them, and counts in bins beyond that. The choice depends on the
/// planned and actual number of values, never on their order: any split over threads and shards that plan the same
/// number merges to the same result. Quantiles by definition 7 (quantile.hpp): exact in the first case, in the second
/// within 0.05 % of each order statistic's distance from `origin`.
///
/// Positions need an origin near them, because bins of 0.05 % of a coordinate of 2,600,000 m are too wide.
///
/// A bin has the values whose distances from the origin agree in sign, exponent and the first ten bits of the fraction.
/// Its width is 1/2048 to 1/1024 of the distance, as in G. Tene's HdrHistogram, and its middle at most 1/2048 = 0.049 %
/// off. Distances below 2^-40 (1e-12) are zero; those above 2^80 (1e24) are all in the last bin. Takes at most 2 MB,
/// usually less than 0.2 MB.
class QuantileSketch {
 public:
  static constexpr std::uint64_t most_exact = 100'000;

  explicit QuantileSketch(std::uint64_t planned_count, double origin = 0)
      : planned_(planned_count), origin_(origin), is_exact_(planned_count <= most_exact) {}

  /// Expects a finite number.
  void add(double x);
  /// Expects a sketch that was planned for the same number of values and has the same origin.
  void merge(const QuantileSketch& other);

  void save(ByteWriter& out) const;
  /// Adds a saved sketch; throws BadBytes on anything else and on a sketch planned for another number of values. The
  /// origin is not saved: it must be the same.
  void merge_saved(ByteReader& in);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] bool is_exact() const { return is_exact_; }
  [[nodiscard]] double origin() const { return origin_; }

  /// The quantile p in [0, 1]; nullopt if there are no values. The minimum and the maximum are always exact.
  [[nodiscard]] std::optional<double> quantile(double p) const;

  /// Values in ascending order with their counts: the values themselves, or the middles of the bins.
  struct Counted {
    double value;
    std::uint64_t count;
  };
  [[nodiscard]] std::vector<Counted> ascending() const;

 private:
  /// Counts of bins with consecutive numbers from `first` on; grows at both ends.
  struct Bins {
    std::uint32_t first = 0;
    std::vector<std::uint64_t> counts;
    void add(std::uint32_t bin, std::uint64_t count);
    void save(ByteWriter& out) const;
    /// Reads into empty bins; returns the number of values.
    std::uint64_t read(ByteReader& in);
  };

  static constexpr std::size_t most_waiting = 512;  // values kept before bins are used, the first of which take 8 kB

  void count_in_bins(double x);
  void fill_bins();
  void put(double x);
  [[nodiscard]] QuantileSketch binned() const;

  std::uint64_t planned_;
  double origin_;
  bool is_exact_;
  bool is_binned_ = false;  // never if it is exact
  std::uint64_t count_ = 0;
  double minimum_ = 0, maximum_ = 0;  // valid if count is not 0
  std::vector<double> values_;        // as added, also the first few that will be counted in bins; empty once they are
  Bins positive_, negative_;          // by distance from the origin
  std::uint64_t zeros_ = 0;
};

}  // namespace talus
