#include "talus/archive/report_maps.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <system_error>

#include "talus/maps/map_files.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/maps/map_reading.hpp"

namespace talus {

namespace {

struct Shown {
  const char* name;
  bool is_logarithmic;  // whether levels are logarithmic
};

constexpr Shown shown_maps[] = {{"reach_share", true},
                                {"reach_share_low", true},
                                {"reach_share_high", true},
                                {"reach_share_parameter_part", false},
                                {"energy_total_max_kJ", true},
                                {"energy_total_max_low_kJ", true},
                                {"energy_total_max_high_kJ", true},
                                {"bounce_height_max_m", false},
                                {"bounce_height_max_low_m", false},
                                {"bounce_height_max_high_m", false},
                                {"velocity_max_m_s", false},
                                {"velocity_max_low_m_s", false},
                                {"velocity_max_high_m_s", false}};

/// The range of the values above 0.
ValueRange range_of(const std::vector<float>& values) {
  ValueRange range;
  for (const float value : values) {
    if (!(value > 0)) continue;
    range.least = range.least == 0 ? value : std::min<double>(range.least, value);
    range.greatest = std::max<double>(range.greatest, value);
  }
  return range;
}

std::uint8_t level_of(double value, bool is_logarithmic, const ValueRange& range) {
  if (std::isnan(value)) return 0;
  constexpr double most = 254;
  if (!(value > 0) || range.greatest == range.least) return value > 0 ? 255 : 1;
  const double part =
      is_logarithmic ? std::log(value / range.least) / std::log(range.greatest / range.least) : value / range.greatest;
  return static_cast<std::uint8_t>(1 + std::lround(most * std::clamp(part, 0.0, 1.0)));
}

ReportMap as_levels(const Shown& kind, const ClassLimits& limits, const MapValues& map) {
  ReportMap out{.name = kind.name,
                .is_logarithmic = kind.is_logarithmic,
                .range = range_of(map.values),
                .limits = limits,
                .origin = map.origin,
                .cell = map.cell,
                .columns = map.columns,
                .rows = map.rows};
  out.levels.reserve(map.values.size());
  for (const float value : map.values) out.levels.push_back(level_of(value, kind.is_logarithmic, out.range));
  return out;
}

}  // namespace

std::vector<ReportMap> read_report_maps(const std::filesystem::path& folder) {
  std::vector<ReportMap> maps;
  if (!can_write_maps()) return maps;
  const std::vector<MapKind> kinds = map_kinds({.bands = banded_map_subjects});
  for (const Shown& kind : shown_maps) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder / "maps" / (std::string(kind.name) + ".tif"), ignored)) continue;
    MapFile file;
    file.name = kind.name;
    const auto known = std::ranges::find(kinds, kind.name, &MapKind::name);
    maps.push_back(as_levels(kind, known->limits, read_map(folder, file, most_report_cells)));
  }
  return maps;
}

}  // namespace talus
