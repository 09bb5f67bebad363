#pragma once
// Angles: degrees in files and settings, radians in computations.

#include <numbers>

namespace talus {

/// Of one degree.
inline constexpr double radians = std::numbers::pi / 180;

}  // namespace talus
