#include "talus/gdal/zone_in_easting.hpp"

#include <fmt/format.h>

#include <cmath>

namespace talus {

std::optional<int> zone_in_easting(double easting) {
  const double zone = std::floor(easting / metres_per_zone), within = easting - zone * metres_per_zone;
  constexpr double max_zones = 60, west = 1e5, east = 9e5;  // of zones of 3 and 6 degrees with 500 km at their centre
  if (!(zone >= 1 && zone <= max_zones && within > west && within < east)) return std::nullopt;
  return static_cast<int>(zone);
}

std::string way_out_of_zone(int zone) {
  // EPSG: ETRS89 / UTM zone 31N (N-zE) ..., DHDN / 3-degree Gauss-Kruger zone 2 ...
  const int epsg = zone == 31               ? 5649
                   : zone == 32             ? 4647
                   : zone == 33             ? 5650
                   : zone >= 2 && zone <= 5 ? 31464 + zone
                                            : 0;
  return fmt::format("assign the coordinate system that has it{}, or subtract {}",
                     epsg == 0 ? "" : fmt::format(", such as EPSG:{}", epsg),
                     zone * static_cast<long>(metres_per_zone));
}

}  // namespace talus
