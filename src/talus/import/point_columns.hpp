#pragma once
// What the names of columns mean in text files of points.

#include <cstddef>
#include <optional>
#include <string_view>

namespace talus {

struct PointColumn {
  std::size_t axis;  // 0 x, 1 y, 2 z
  bool in_feet;
};

/// The meaning of a column's name, with or without a unit: "x", "Easting (m)", "z_ft", "Höhe" in UTF-8 or Latin-1.
[[nodiscard]] std::optional<PointColumn> meaning_of_point_column(std::string_view name);

/// "distance_m", "Station": where a point of a section is along it.
[[nodiscard]] bool means_distance(std::string_view name);

[[nodiscard]] bool means_degrees(std::string_view name);

}  // namespace talus
