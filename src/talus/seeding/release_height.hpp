#pragma once
// The usual height of releases above the ground.

namespace talus {

/// A release higher above the ground than this [m] is probably an elevation entered as a height.
inline constexpr double highest_release_m = 300;

}  // namespace talus
