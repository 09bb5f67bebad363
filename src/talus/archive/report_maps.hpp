#pragma once
// The maps of a run for the report: some of them, coarse, with values in 255 levels.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "talus/maps/map_style.hpp"

namespace talus {

/// A map whose cells have levels instead of values: 0 without a rock; k from 1 to 255 stands for least (greatest /
/// least)^((k - 1) / 254) if levels are logarithmic, and for greatest (k - 1) / 254 if they are linear.
struct ReportMap {
  std::string name;  // of its file: maps/NAME.tif
  bool is_logarithmic = false;
  ValueRange range;  // of the cells below
  ClassLimits limits{};
  std::array<double, 2> origin{};  // the south-western corner [m]
  std::array<double, 2> cell{};    // [m]
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> levels{};  // row by row from the south
};

/// Maximum number of cells a side: more could not be distinguished on a page.
inline constexpr int most_report_cells = 400;

/// Reach, energy, height and velocity, as far as they are in FOLDER/maps; none if the program was built without GDAL.
/// Throws BadInput on a map that cannot be read.
[[nodiscard]] std::vector<ReportMap> read_report_maps(const std::filesystem::path& folder);

}  // namespace talus
