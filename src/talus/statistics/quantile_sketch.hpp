#pragma once
// Quantiles of many values in bounded memory, whatever the order in which they come.

#include <cstdint>
#include <optional>
#include <vector>

#include "talus/core/bytes.hpp"

namespace talus {

/// Keeps the values themselves while there are at most `most_exact`, and counts in bins beyond that. Which of the two
/// it is depends on how many values were planned and came, never on their order, so that any split over threads and
/// shards that plan the same number merges to the same answer. Quantiles by definition 7 (quantile.hpp): exact in the
/// first case, in the second within 0.05 % of each order statistic's distance from `origin`.
///
/// Positions take an origin near them, because bins as wide as 0.05 % of a coordinate of 2,600,000 m tell nothing.
///
/// A bin holds the values whose distances from the origin agree in sign, exponent and the first ten bits of the
/// fraction: its width is 1/2048 to 1/1024 of the distance, as in G. Tene's HdrHistogram, and its middle at most
/// 1/2048 = 0.049 % off. Distances below 2^-40 (1e-12) are zero; above 2^80 (1e24) they all fall into the last bin. At
/// most 2 MB, usually less than 0.2 MB.
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
  /// Adds a saved sketch; throws BadBytes on what is none, or was planned for another number of values. The origin is
  /// not saved: expects the same.
  void merge_saved(ByteReader& in);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] bool is_exact() const { return is_exact_; }
  [[nodiscard]] double origin() const { return origin_; }

  /// The quantile p in [0, 1]; nothing if there are no values. The minimum and the maximum are always exact.
  [[nodiscard]] std::optional<double> quantile(double p) const;

  /// Values in ascending order with how often each came: the values themselves, or the middles of the bins.
  struct Counted {
    double value;
    std::uint64_t count;
  };
  [[nodiscard]] std::vector<Counted> ascending() const;

 private:
  /// Counts of bins with consecutive numbers, of which the first is `first`; grows at both ends.
  struct Bins {
    std::uint32_t first = 0;
    std::vector<std::uint64_t> counts;
    void add(std::uint32_t bin, std::uint64_t count);
    void save(ByteWriter& out) const;
    /// Into empty bins; gives how many values there are.
    std::uint64_t read(ByteReader& in);
  };

  static constexpr std::size_t most_waiting = 512;  // values that wait for bins, of which the first take 8 kB

  void count_in_bins(double x);
  void fill_bins();
  void put(double x);
  [[nodiscard]] QuantileSketch binned() const;

  std::uint64_t planned_;
  double origin_;
  bool is_exact_;
  bool is_binned_ = false;  // never where it is exact
  std::uint64_t count_ = 0;
  double minimum_ = 0, maximum_ = 0;  // where count is not 0
  std::vector<double> values_;        // as they came, also if few that bins are to count; empty once in bins
  Bins positive_, negative_;          // by distance from the origin
  std::uint64_t zeros_ = 0;
};

}  // namespace talus
