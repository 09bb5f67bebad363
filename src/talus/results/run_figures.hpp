#pragma once
// The figures of a run by which protection is designed: runouts, energies, heights and shares of rocks, each with its
// confidence interval. From any set of rocks: all, some, or those of an ensemble.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/statistics/order_statistics.hpp"
#include "talus/statistics/quantile_sketch.hpp"

namespace talus {

/// What a figure is about: of each rock, or of each rock that reaches a line (a barrier or collector).
enum class FigureOf : std::uint32_t { runout, max_energy, max_bounce, share, energy, velocity, height };

/// How a quantity is named and shown.
struct FigureQuantity {
  FigureOf of;
  std::string_view word;     // in files: "runout"
  std::string_view unit;     // of the values below
  std::string_view meaning;  // "runout on plan"
  bool is_at_line;
};
inline constexpr std::array<FigureQuantity, 7> figure_quantities{
    {{FigureOf::runout, "runout", "m", "runout on plan", false},
     {FigureOf::max_energy, "max_energy", "J", "maximum total kinetic energy", false},
     {FigureOf::max_bounce, "max_bounce", "m", "maximum bounce height", false},
     {FigureOf::share, "share", "", "share of rocks that reach the line", true},
     {FigureOf::energy, "energy", "J", "total kinetic energy at the line", true},
     {FigureOf::velocity, "velocity", "m/s", "velocity at the line", true},
     {FigureOf::height, "height", "m", "height of the block's top at the line", true}}};
[[nodiscard]] constexpr const FigureQuantity& quantity_of(FigureOf of) {
  return figure_quantities[static_cast<std::size_t>(of)];
}

/// A percentile of a quantity, or a share of rocks.
struct RunFigure {
  FigureOf of = FigureOf::runout;
  double percentile = 95;  // [%]; not of a share
  std::size_t line = 0;    // of figures at a line

  [[nodiscard]] bool is_at_line() const { return quantity_of(of).is_at_line; }
  /// "95th percentile of the runout on plan", "share of rocks that reach the line".
  [[nodiscard]] std::string text() const;
  friend bool operator==(const RunFigure&, const RunFigure&) = default;
};

/// The figures that a report shows: median and 95th percentile of the runout, 95th percentiles of energy and bounce
/// height; and at each line the share of rocks and the 95th percentiles of energy, velocity and height.
[[nodiscard]] std::vector<RunFigure> usual_figures(std::size_t lines);

struct RockValues {
  double runout = 0;      // on plan [m]
  double max_energy = 0;  // total kinetic [J]
  double max_bounce = 0;  // rocks/heights.hpp [m]
};

/// A rock's first arrival at a line.
struct ArrivalValues {
  double energy = 0;    // total kinetic [J]
  double velocity = 0;  // [m/s]
  double height = 0;    // of the top of the block above the foot, along the face [m]
};

/// The values of a set of rocks, in any order.
class FigureTally {
 public:
  FigureTally(std::size_t lines, std::uint64_t planned_rocks);
  void add(const RockValues& rock);
  /// Each rock once for each line.
  void add(std::size_t line, const ArrivalValues& arrival);

  /// Nullopt if no rock has the quantity. `rocks` is the number of rocks of which a share is: by default of those
  /// added.
  [[nodiscard]] std::optional<Estimate> estimate(const RunFigure& figure, double confidence,
                                                 std::optional<std::uint64_t> rocks = {}) const;
  /// The estimate alone.
  [[nodiscard]] std::optional<double> value(const RunFigure& figure) const;
  /// The variance of the estimate as another sample of as many rocks would give it; nullopt from fewer than two values.
  /// Of percentiles by J. S. Maritz and R. G. Jarrett, "A note on estimating the variance of the sample median",
  /// Journal of the American Statistical Association 73 (1978) 194-196; of shares, p (1 - p) / (n - 1).
  [[nodiscard]] std::optional<double> sampling_variance(const RunFigure& figure) const;
  /// Values of which the figure is a percentile, or rocks of which it is a share.
  [[nodiscard]] std::uint64_t count(const RunFigure& figure) const;
  [[nodiscard]] std::uint64_t rocks() const { return of_rocks_.front().count(); }

 private:
  [[nodiscard]] const QuantileSketch& sketch(const RunFigure& figure) const;

  std::array<QuantileSketch, 3> of_rocks_;
  std::vector<std::array<QuantileSketch, 3>> at_lines_;
};

/// The number of rocks with which a figure's interval would reach no further than `tolerance` times the figure to
/// either side, if its width falls with the square root of the number of rocks. Where an end is missing for too few
/// values: the number that gives both ends, if that is more. Nullopt if the figure is zero or has no values.
[[nodiscard]] std::optional<std::uint64_t> rocks_needed(const RunFigure& figure, const Estimate& estimate,
                                                        std::uint64_t rocks, std::uint64_t values, double confidence,
                                                        double tolerance);

}  // namespace talus
