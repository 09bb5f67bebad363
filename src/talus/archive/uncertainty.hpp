#pragma once
// The figures of a run whose rocks belong to ensembles with different parameters: how uncertain they are, and which
// part of that is due to the parameters.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/results/run_figures.hpp"

namespace talus {

/// A figure's interval between ensembles, and its two parts. By the law of total variance, the variance of a figure
/// between ensembles of n rocks is that of its value for exactly known parameters, which a sample of n rocks has (the
/// part of the rocks: the mean of the ensembles' sampling variances), and that of the value over the parameters (the
/// part of the parameters: the rest).
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

struct Uncertainty {
  static constexpr double confidence = 0.9;
  static constexpr std::size_t fewest = 5;  // ensembles with a value
  std::uint64_t ensembles = 0;              // 0: the run has none
  std::vector<FigureUncertainty> figures;
};

/// Collects the rows of a run's tables. Rock n belongs to the ensemble n modulo their number.
class UncertaintyCount {
 public:
  UncertaintyCount(std::uint64_t rocks, std::uint64_t ensembles, std::vector<std::string> lines);

  void add_end(std::uint64_t rock, const RockValues& values);
  /// Rows come in the order of rocks. Lines of other names, and later arrivals of a rock at the same line, do not
  /// count.
  void add_arrival(std::uint64_t rock, std::string_view line, const ArrivalValues& values);

  [[nodiscard]] Uncertainty result() const;

 private:
  [[nodiscard]] std::optional<FigureUncertainty> of(const RunFigure& figure) const;

  std::vector<std::string> lines_;
  std::map<std::string, std::size_t, std::less<>> line_of_;
  std::vector<std::optional<std::uint64_t>> last_rock_;  // by line
  FigureTally all_;
  std::vector<FigureTally> of_ensemble_;
};

}  // namespace talus
