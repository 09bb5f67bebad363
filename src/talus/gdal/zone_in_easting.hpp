#pragma once
// Eastings that begin with the number of a zone, as in Germany and Russia: 32652000 for 652000 in zone 32.

#include <optional>
#include <string>

namespace talus {

inline constexpr double metres_per_zone = 1e6;

/// The number of a zone with which an easting begins, if it does: 32 of 32652000, 3 of 3652000. Some national grids
/// have such eastings without zones.
[[nodiscard]] std::optional<int> zone_in_easting(double easting);
/// "assign the coordinate system that has it, such as EPSG:4647, or subtract 32000000".
[[nodiscard]] std::string way_out_of_zone(int zone);

}  // namespace talus
