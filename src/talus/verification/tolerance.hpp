#pragma once
// The permitted difference between a computed and a printed number.

#include <algorithm>
#include <cmath>
#include <string>

#include "talus/verification/printed.hpp"

namespace talus::verification {

/// Each part that is not zero is a limit, and the widest one applies: "1 unit of the last printed digit or 0.01 %".
struct Tolerance {
  double units = 0;     // of the last printed digit
  double relative = 0;  // of the printed number
  double absolute = 0;  // in the unit of the number
  double of_scale = 0;  // of the largest number of the same kind (all velocities, for example) in the table

  [[nodiscard]] double allowed(const Printed& published, double scale) const {
    return std::max({units * published.unit, relative * std::abs(published.value), absolute, of_scale * scale});
  }
  /// `1 unit of the last digit or 0.01 %`
  [[nodiscard]] std::string text() const;
};

}  // namespace talus::verification
