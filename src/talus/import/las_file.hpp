#pragma once
// Points from LAS files: ASPRS LAS Specification 1.4 - R15 (2019) and earlier versions, point formats 0 to 10. The
// compressed form, LAZ, is refused with the command that unpacks it.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/core/vec.hpp"

namespace talus {

/// The coordinate system of a LAS file, as well-known text or GeoTIFF keys.
struct LasCrs {
  std::string wkt;                        // OGC WKT; empty: none
  std::optional<int> projected_epsg;      // GeoTIFF key 3072
  std::optional<int> geographic_epsg;     // key 2048
  std::optional<int> vertical_epsg;       // key 4096
  bool is_geographic = false;             // key 1024: in degrees
  std::optional<int> plan_unit_epsg;      // key 3076; 9001 is the metre
  std::optional<int> vertical_unit_epsg;  // key 4099
};

struct LasFile {
  std::vector<Vec3> points;  // scale and offset applied
  LasCrs crs;
  std::uint64_t declared = 0;             // points in the file
  std::uint64_t withheld = 0;             // marked as deleted, and left out
  std::map<int, std::uint64_t> of_class;  // number of the other points, by class
};

/// Noise classes are left out unless they are requested (ASPRS standard classes 7 and 18).
[[nodiscard]] constexpr bool is_noise(int las_class) { return las_class == 7 || las_class == 18; }

/// Reads the points of some classes, or (if `classes` is empty) of all but noise. Throws BadInput if the file is not
/// LAS, is compressed, cut short or inconsistent, or if no point is of these classes.
[[nodiscard]] LasFile read_las_file(const std::filesystem::path& path, const std::vector<std::int64_t>& classes);

}  // namespace talus
