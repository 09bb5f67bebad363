#pragma once
// Screening by elementary effects: which of many inputs matter at all, from few runs.
//
// M. D. Morris, "Factorial sampling plans for preliminary computational experiments", Technometrics 33 (1991) 161-174.
// F. Campolongo, J. Cariboni, A. Saltelli, "An effective screening design for sensitivity analysis of large models",
// Environmental Modelling & Software 22 (2007) 1509-1518: mu*, and trajectories chosen to be far apart.
//
// A trajectory visits k + 1 points of a grid in the unit hypercube of the k inputs and changes one input at a time, by
// delta = levels / (2 (levels - 1)). The elementary effect of an input is the change of the result divided by that of
// the input. mu is the mean effect over the trajectories, mu* the mean of its magnitude, and sigma the standard
// deviation of the effects: large if the effect depends on the input itself or on other inputs.
//
// One change: of the candidate trajectories the ones that are kept are added one after the other, each time the one
// that is farthest from those already chosen, because comparing all choices takes too long for more than ten.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/statistics/bootstrap.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus {

struct MorrisPlan {
  std::size_t inputs = 1;         // k, at least 1
  std::size_t trajectories = 20;  // at least 2
  std::size_t levels = 4;         // of the grid, even: 0, 1/(levels - 1), ..., 1
  std::uint64_t seed = 1;
};

/// The elementary effects of one input, in units of the result per whole range of the input.
struct ElementaryEffects {
  double mean = 0;                // mu
  Estimate magnitude;             // mu*, with its bootstrap interval over trajectories
  double standard_deviation = 0;  // sigma; 0 from a single effect
  std::size_t count = 0;          // effects that are defined
};

class MorrisDesign {
 public:
  /// Chooses the trajectories out of ten times as many candidates (at most 500).
  explicit MorrisDesign(const MorrisPlan& plan);

  /// trajectories x (inputs + 1) points of `inputs` coordinates in [0, 1], trajectory after trajectory.
  [[nodiscard]] const std::vector<std::vector<double>>& points() const { return points_; }

  /// By input, from the result at each point. A result may be undefined at some points: effects between such points
  /// are left out, and an input without any effect is empty.
  [[nodiscard]] std::vector<std::optional<ElementaryEffects>> effects(std::span<const std::optional<double>> results,
                                                                      const Bootstrap& bootstrap) const;

 private:
  MorrisPlan plan_;
  std::vector<std::vector<double>> points_;
};

}  // namespace talus
