#include "talus/archive/report_maps.hpp"

#include <fmt/format.h>

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
  const char* name;       // with {} for the part of a quantity: its 95th percentile, or its maximum without one
  bool is_logarithmic{};  // whether levels are logarithmic
};

constexpr Shown shown_maps[] = {{"bounce_height_{}_m", false},
                                {"bounce_height_{}_low_m", false},
                                {"bounce_height_{}_high_m", false},
                                {"energy_total_{}_kJ", true},
                                {"energy_total_{}_low_kJ", true},
                                {"energy_total_{}_high_kJ", true},
                                {"velocity_{}_m_s", false},
                                {"velocity_{}_low_m_s", false},
                                {"velocity_{}_high_m_s", false},
                                {"reach_share", true},
                                {"reach_share_low", true},
                                {"reach_share_high", true},
                                {"reach_share_parameter_part", false}};

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

ReportMap as_levels(const std::string& name, bool is_logarithmic, const ClassLimits& limits, const MapValues& map) {
  ReportMap out{.name = name,
                .is_logarithmic = is_logarithmic,
                .range = range_of(map.values),
                .limits = limits,
                .origin = map.origin,
                .cell = map.cell,
                .columns = map.columns,
                .rows = map.rows};
  out.levels.reserve(map.values.size());
  for (const float value : map.values) out.levels.push_back(level_of(value, is_logarithmic, out.range));
  return out;
}

}  // namespace

std::vector<ReportMap> read_report_maps(const std::filesystem::path& folder) {
  std::vector<ReportMap> maps;
  if (!can_write_maps()) return maps;
  const std::vector<MapKind> kinds = map_kinds({.percentiles = {95}, .bands = banded_map_subjects});
  for (const Shown& shown : shown_maps) {
    for (const char* part : {"p95", "max"}) {
      MapFile file;
      file.name = fmt::format(fmt::runtime(shown.name), part);
      std::error_code ignored;
      if (!std::filesystem::exists(folder / "maps" / (file.name + ".tif"), ignored)) continue;
      const auto known = std::ranges::find(kinds, file.name, &MapKind::name);
      maps.push_back(
          as_levels(file.name, shown.is_logarithmic, known->limits, read_map(folder, file, most_report_cells)));
      break;
    }
  }
  return maps;
}

}  // namespace talus
