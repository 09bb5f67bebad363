#pragma once
// Whether zones of deposits lie on the terrain, and apart from each other.

#include <vector>

#include "talus/calibration/zones.hpp"
#include "talus/core/problems.hpp"

namespace talus::calibration {

/// `places`: of each zone in its file. Zones off the terrain and zones that overlap (by more than about a hundredth of
/// their common extent) are problems; zones partly off the terrain are warnings.
void check_zone_places(const std::vector<ObservedZone>& zones, const std::vector<Problem>& places,
                       const study::PreparedSite& site, Problems& problems, Problems& warnings);

}  // namespace talus::calibration
