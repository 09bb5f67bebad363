#pragma once
// Which rocks depend on which parameter: those whose end, velocity or arrivals change with it.

#include <string>
#include <vector>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

/// Rocks that depend on a parameter, counted at one set of values.
struct Dependence {
  std::size_t rocks = 0, all = 0;  // simulated ones
  /// Those that come nearest to the observed rocks: the nearest end or mark of each observed place (of its own release,
  /// if it is known), all rocks at an observed line or in zones with deposits.
  std::size_t near = 0, all_near = 0;
};

/// For each parameter: the others have the values of `set`, it has both ends of its prior.
[[nodiscard]] std::vector<Dependence> dependence(const PreparedStudy& study, const study::ParameterSet& set);

/// `the ground "Scree"` of material.Scree.roughness_deg; empty for a parameter of no single material.
[[nodiscard]] std::string ground_of(const std::string& parameter);

}  // namespace talus::calibration
