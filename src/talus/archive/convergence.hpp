#pragma once
// How the figures of a run develop with the number of rocks, from its tables: each figure of ever larger random choices
// of its rocks, and the number of rocks that would make it as precise as wanted.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/results/run_figures.hpp"

namespace talus {

/// A figure of some of the rocks.
struct ConvergenceStep {
  std::uint64_t rocks = 0;           // of the choice
  std::optional<Estimate> estimate;  // nullopt if none of them has the quantity
};

struct FigureConvergence {
  RunFigure figure;
  std::string line;                           // name of the barrier or collector; empty: of the whole run
  std::vector<ConvergenceStep> steps;         // ascending; the last is all rocks
  std::optional<std::uint64_t> rocks_needed;  // see rocks_needed() in results/run_figures.hpp
};

struct Convergence {
  static constexpr double confidence = 0.95, tolerance = 0.1;
  static constexpr std::size_t most_lines = 10;  // those with the most hits
  std::vector<FigureConvergence> figures;        // none: the run is a part, or has too few rocks
};

/// Collects the rows of a run's tables. The choices are nested: all rocks, half of them, a quarter ..., down to about
/// fifty. Which rocks are in a choice depends on their numbers alone: those whose place in a random permutation is
/// below the size of the choice, because rocks are numbered seeder after seeder.
class ConvergenceCount {
 public:
  /// Of a whole run of this many rocks.
  ConvergenceCount(std::uint64_t rocks, std::vector<std::string> lines);

  void add_end(std::uint64_t rock, const RockValues& values);
  /// Rows come in the order of rocks. Lines of other names, and later arrivals of a rock at the same line, do not
  /// count.
  void add_arrival(std::uint64_t rock, std::string_view line, const ArrivalValues& values);

  [[nodiscard]] Convergence result() const;

 private:
  static constexpr std::uint64_t fewest = 50;
  static constexpr std::size_t most_steps = 8;

  /// Calls visit(tally) for each choice that the rock belongs to.
  template <class Visit>
  void for_choices(std::uint64_t rock, const Visit& visit);

  std::uint64_t rocks_;
  std::vector<std::string> lines_;
  std::map<std::string, std::size_t, std::less<>> line_of_;
  std::vector<std::optional<std::uint64_t>> last_rock_;  // by line
  std::vector<std::uint64_t> sizes_;                     // descending
  std::vector<FigureTally> choices_;
};

}  // namespace talus
