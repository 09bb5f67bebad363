#include "talus/io/report_maps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <system_error>

#include "talus/io/map_files.hpp"
#include "talus/io/map_reading.hpp"

namespace talus::io {

namespace {

struct Shown {
  const char* name;
  ColourScale scale;
};

// With the scales of map_list.hpp, so that the report's colours are those of QGIS and of the workbench.
constexpr Shown shown[] = {{"reach_share", ColourScale::logarithmic},
                           {"energy_total_max_J", ColourScale::logarithmic},
                           {"bounce_height_max_m", ColourScale::linear},
                           {"velocity_max_m_s", ColourScale::linear}};

/// Of the values above 0, as map_style.hpp has it.
ColourRange range_of(const std::vector<float>& values, ColourScale scale) {
  std::vector<float> above;
  std::ranges::copy_if(values, std::back_inserter(above), [](float value) { return value > 0; });
  if (above.empty()) return {};
  const auto [least, greatest] = std::ranges::minmax(above);
  ColourRange range{.least = least, .greatest = greatest, .top = greatest};
  if (scale == ColourScale::logarithmic) return range;
  const auto place = static_cast<std::size_t>(percentile_of_top / 100 * static_cast<double>(above.size() - 1));
  const auto top = above.begin() + static_cast<std::ptrdiff_t>(place);
  std::ranges::nth_element(above, top);
  range.top = *top;
  return range;
}

std::uint8_t level_of(double value, ColourScale scale, const ColourRange& range) {
  if (std::isnan(value)) return 0;
  constexpr double most = 254;
  if (!(value > 0) || range.greatest == range.least) return value > 0 ? 255 : 1;
  const double part = scale == ColourScale::linear
                          ? value / range.greatest
                          : std::log(value / range.least) / std::log(range.greatest / range.least);
  return static_cast<std::uint8_t>(1 + std::lround(most * std::clamp(part, 0.0, 1.0)));
}

ReportMap as_levels(const Shown& kind, const MapValues& map) {
  ReportMap out{.name = kind.name,
                .scale = kind.scale,
                .range = range_of(map.values, kind.scale),
                .origin = map.origin,
                .cell = map.cell,
                .columns = map.columns,
                .rows = map.rows};
  out.levels.reserve(map.values.size());
  for (const float value : map.values) out.levels.push_back(level_of(value, kind.scale, out.range));
  return out;
}

}  // namespace

std::vector<ReportMap> read_report_maps(const std::filesystem::path& folder) {
  std::vector<ReportMap> maps;
  if (!can_write_maps()) return maps;
  for (const Shown& kind : shown) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder / "maps" / (std::string(kind.name) + ".tif"), ignored)) continue;
    MapFile file;
    file.name = kind.name;
    maps.push_back(as_levels(kind, read_map(folder, file, most_report_cells)));
  }
  return maps;
}

}  // namespace talus::io
