#pragma once
// Numbers that are not 0 only because arithmetic rounds.

#include <cmath>

namespace talus {

/// 0 if a number is negligible beside `scale`, the size of those from which it was computed; else the number.
[[nodiscard]] inline double without_rounding(double value, double scale) {
  constexpr double negligible = 1e-9;  // a million times the rounding of one operation
  return std::abs(value) <= negligible * std::abs(scale) ? 0 : value;
}

}  // namespace talus
