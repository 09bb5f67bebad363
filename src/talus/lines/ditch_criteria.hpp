#pragma once
// Published criteria for the width of a ditch or bench at the foot of a slope, to be set beside simulated figures.
//
// Only numbers whose source could be read are here; docs/slope-tools.md lists what is left out, and why. Outside of the
// range of the tests behind a criterion there is no number. Checked by test/lines/ditch_criteria_test.cpp.

#include <optional>
#include <string>
#include <vector>

namespace talus {

/// The slope above the toe of a ditch.
struct SlopeAbove {
  double height = 0;  // of the highest release above the ground just past the toe [m]
  double angle = 0;   // of the line from the toe to that release, from the horizontal [rad]
};

struct DitchCriterion {
  const char* name;
  const char* source;
  std::optional<double> width;  // from the toe [m]; nullopt: none for this slope
  std::string text;             // what it says, or why it says nothing
};

/// The tests of Pierson, Gullixson and Chassie (2001): slopes of 40, 60 and 80 ft, vertical to 1H:1V.
[[nodiscard]] bool is_in_tested_range(const SlopeAbove& slope);

/// All criteria, those that say nothing about this slope included.
[[nodiscard]] std::vector<DitchCriterion> ditch_criteria(const SlopeAbove& slope);

}  // namespace talus
