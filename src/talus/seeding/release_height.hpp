#pragma once
// How high above the ground rocks are released.

namespace talus {

/// Higher above the ground no rock is released, unless an elevation was taken for a height [m].
inline constexpr double highest_release_m = 300;

}  // namespace talus
