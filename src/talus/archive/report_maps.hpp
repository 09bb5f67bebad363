#pragma once
// The maps of a run as the report draws them: a few of all kinds, coarse, their values in 255 levels.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "talus/maps/map_style.hpp"

namespace talus {

/// A map whose cells have levels instead of values: 0 where no rock was, else k from 1 to 255, which stands for
/// least (greatest / least)^((k - 1) / 254) where they are logarithmic and for greatest (k - 1) / 254 where they are
/// not.
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

/// Most cells a side: more could not be told apart on a page.
inline constexpr int most_report_cells = 400;

/// Reach, energy, height and velocity, as far as a run has left them in FOLDER/maps; none where the program was built
/// without GDAL. Throws BadInput on a map that cannot be read.
[[nodiscard]] std::vector<ReportMap> read_report_maps(const std::filesystem::path& folder);

}  // namespace talus
