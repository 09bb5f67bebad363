#pragma once
// The figures of a run whose rocks belong to ensembles with different parameters: how uncertain they are, and which
// part of that is due to the parameters.

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/results/run_figures.hpp"

namespace talus {

/// A figure's interval between ensembles, and its two parts. By the law of total variance, the variance of a figure
/// between ensembles of n rocks from the same places is that of its value for exactly known parameters and places (the
/// part of the rocks), and that of the value over the parameters (the part of the parameters: the rest). The part of
/// the rocks is the mean of the ensembles' sampling variances, less the share of it that rocks from the same place have
/// in common: in a table of places and ensembles, with what each rock adds to the figure of its ensemble, the variance
/// that is of neither rows nor columns (H. Scheffe, The Analysis of Variance, 1959, chapter 4).
struct FigureUncertainty {
  RunFigure figure;
  std::string line;             // name of the barrier or collector; empty: of the whole run
  std::uint64_t ensembles = 0;  // that have a value
  /// The figure of all rocks, and the range of those of the ensembles: it contains both parts.
  Estimate total;
  /// The range if only one part varied. That of the parameters is the ensembles' range, narrowed by the part of the
  /// rocks; that of the rocks is of a normal distribution,
  /// cut where the figure cannot be.
  Estimate parameters, rocks;
  double parameter_share = 0;  // of the variance, 0 to 1
};

/// The central range of values that has this confidence. Expects at least one.
[[nodiscard]] Estimate range_of(std::vector<double> values, double value, double confidence);

struct Uncertainty {
  static constexpr double confidence = 0.9;
  static constexpr std::size_t fewest = 5;  // ensembles with a value
  std::uint64_t ensembles = 0;              // 0: the run has none
  std::vector<FigureUncertainty> figures;
};

/// How the rocks of a run are divided: rock n belongs to the ensemble n modulo their number, and as many consecutive
/// rocks of a seeder start from the same place.
struct EnsembleRocks {
  std::uint64_t rocks = 0, ensembles = 0;
  std::uint64_t parameter_sets = 2;                // different ones; with one, nothing is due to the parameters
  std::vector<std::uint64_t> seeders_begin = {0};  // at these rocks
};

/// Collects the rows of a run's tables.
class UncertaintyCount {
 public:
  UncertaintyCount(EnsembleRocks run, std::vector<std::string> lines);

  void add_end(std::uint64_t rock, const RockValues& values);
  /// Rows come in the order of rocks. Lines of other names, and later arrivals of a rock at the same line, do not
  /// count.
  void add_arrival(std::uint64_t rock, std::string_view line, const ArrivalValues& values);

  [[nodiscard]] Uncertainty result() const;

 private:
  [[nodiscard]] std::optional<FigureUncertainty> of(const RunFigure& figure) const;
  /// The number of a rock's place, all seeders together.
  [[nodiscard]] std::uint64_t place_of(std::uint64_t rock) const;
  void keep(std::uint64_t rock, std::size_t quantity, std::initializer_list<double> values);
  /// The part of the sampling variance that rocks from the same place do not have in common.
  [[nodiscard]] double own_share(const RunFigure& figure) const;

  EnsembleRocks run_;
  std::vector<std::uint64_t> first_places_;  // by seeder
  std::uint64_t places_ = 0, step_ = 1;      // every step_-th place is kept
  /// By quantity, place and ensemble; NaN: no such rock, or it does not reach the line.
  std::vector<std::vector<double>> kept_;
  std::vector<std::string> lines_;
  std::map<std::string, std::size_t, std::less<>> line_of_;
  std::vector<std::optional<std::uint64_t>> last_rock_;  // by line
  FigureTally all_;
  std::vector<FigureTally> of_ensemble_;
};

}  // namespace talus
