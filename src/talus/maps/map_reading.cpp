#include "talus/maps/map_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/maps/halved_cells.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/maps/source_maps.hpp"

#ifdef TALUS_HAS_GDAL
#include "talus/gdal/gdal_raster.hpp"
#endif

namespace talus {

namespace {

namespace fs = std::filesystem;

constexpr const char* by_source = "by_source/";  // in the folder of maps

fs::path file_of(const fs::path& folder, const std::string& name) { return folder / "maps" / (name + ".tif"); }

/// A map's name with any percentile replaced by 50.
std::string kind_of(const std::string& name) {
  const std::size_t at = name.find("_p");
  if (at == std::string::npos) return name;
  const std::size_t end = name.find_first_not_of("0123456789.", at + 2);
  return end == at + 2 || end == std::string::npos ? name : name.substr(0, at + 2) + "50" + name.substr(end);
}

struct Known {
  std::size_t place;
  ClassLimits limits;
  bool is_share;
  MapOverview overview;
};

/// The kind of map of a file name; nullopt if it is not a map of a run.
std::optional<Known> known(const std::string& stem) {
  static const std::vector<MapKind> kinds = map_kinds({.percentiles = {50}, .bands = banded_map_subjects});
  const auto found = std::ranges::find(kinds, kind_of(stem), &MapKind::name);
  if (found == kinds.end()) return std::nullopt;
  return Known{static_cast<std::size_t>(found - kinds.begin()), found->limits, found->is_share(), found->overview};
}

double percentile_in(const std::string& stem) {
  const std::size_t at = stem.find("_p");
  return at == std::string::npos ? 0 : std::atof(stem.c_str() + at + 2);
}

}  // namespace

#ifdef TALUS_HAS_GDAL

namespace {

/// The number in quotes after an attribute's name.
std::optional<double> attribute(const std::string& text, const char* name) {
  const std::size_t at = text.find(std::string(name) + "=\"");
  if (at == std::string::npos) return std::nullopt;
  double value = 0;
  const char* const begin = text.data() + at + std::string_view(name).size() + 2;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  return value;
}

/// The beginning of a map's style file, which has its range; empty if it cannot be read.
std::string style_of(const fs::path& map) {
  constexpr std::size_t most = std::size_t{1} << 20;  // bytes; ours have a few thousand
  const fs::path style = fs::path(map).replace_extension(".qml");
  if (not_an_ordinary_file(style)) return {};
  std::ifstream stream(style, std::ios::binary);
  std::string text(most, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

void read_head(const fs::path& folder, MapFile& map) {
  const fs::path file = file_of(folder, map.name);
  GdalMessages messages;
  RasterProblems problems(file);
  const GDALDatasetUniquePtr raster = open_raster(messages, problems);
  GDALRasterBand& band = *raster->GetRasterBand(1);
  map.meaning = band.GetDescription();
  map.unit = band.GetUnitType();
  const std::string text = style_of(file);
  map.range.least = attribute(text, "leastValue").value_or(0);
  map.range.greatest = attribute(text, "greatestValue").value_or(0);
}

/// Adds the maps in one folder: `maps/` and the prefix of their names.
void add_maps(const fs::path& folder, const std::string& prefix, const std::string& source,
              std::vector<MapFile>& maps) {
  std::vector<std::string> stems;
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder / "maps" / prefix, error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    const std::string stem = entry->path().stem().string();
    if (entry->path().extension() == ".tif" && entry->is_regular_file(ignored) && known(stem)) stems.push_back(stem);
  }
  std::sort(stems.begin(), stems.end(), [](const std::string& a, const std::string& b) {
    const std::size_t left = known(a)->place, right = known(b)->place;
    return left != right ? left < right : percentile_in(a) < percentile_in(b);
  });
  for (const std::string& stem : stems) {
    MapFile& map = maps.emplace_back();
    map.name = prefix + stem;
    map.limits = known(stem)->limits;
    map.is_share = known(stem)->is_share;
    map.source = source;
    read_head(folder, map);
  }
}

/// A map, or one of its overviews, as stored: from north to south.
GDALRasterBand& level_of(GDALRasterBand& whole, int pixels) {
  const auto fits = [&](GDALRasterBand& band) { return std::max(band.GetXSize(), band.GetYSize()) <= pixels; };
  GDALRasterBand* best = &whole;
  for (int k = 0; k < whole.GetOverviewCount() && !fits(*best); ++k) {
    GDALRasterBand* const overview = whole.GetOverview(k);
    if (overview->GetXSize() < best->GetXSize() || overview->GetYSize() < best->GetYSize()) best = overview;
  }
  return *best;
}

}  // namespace

std::vector<MapFile> maps_of_run(const fs::path& folder) {
  std::vector<MapFile> maps;
  add_maps(folder, "", "", maps);
  const fs::path list = folder / "maps" / by_source / SourceRow::file_name;
  std::error_code ignored;
  if (!fs::exists(list, ignored)) return maps;
  TableReader<SourceRow> row(list);
  while (row.next()) {
    const std::string name(row.get<&SourceRow::folder>());
    if (fs::path(name).filename() != name || name.starts_with('.'))
      row.csv().refuse("folder", fmt::format("\"{}\" is not a name of a folder", name), "each source has its own");
    add_maps(folder, by_source + name + "/", std::string(row.get<&SourceRow::source>()), maps);
  }
  return maps;
}

MapValues read_map(const fs::path& folder, const MapFile& map, int pixels) {
  GdalMessages messages;
  RasterProblems problems(file_of(folder, map.name));
  const GDALDatasetUniquePtr raster = open_raster(messages, problems);
  GDALRasterBand& whole = *raster->GetRasterBand(1);
  double place[6] = {};
  if (!read_geotransform(*raster, place, problems)) problems.throw_if_any();
  GDALRasterBand& band = level_of(whole, pixels);
  MapValues found;
  found.columns = band.GetXSize();
  found.rows = band.GetYSize();
  // Every overview is half the size of the one before, and reaches beyond the map at the eastern and southern edge.
  double stride = 1;
  while (std::ceil(whole.GetXSize() / stride) > found.columns || std::ceil(whole.GetYSize() / stride) > found.rows)
    stride *= 2;
  found.values.resize(static_cast<std::size_t>(found.columns) * static_cast<std::size_t>(found.rows));
  if (band.RasterIO(GF_Read, 0, 0, found.columns, found.rows, found.values.data(), found.columns, found.rows,
                    GDT_Float32, 0, 0, nullptr) != CE_None)
    problems.stop("cannot be read", messages.failure());
  const auto no_data = static_cast<float>(whole.GetNoDataValue());
  // A small map has no overviews.
  const auto kind = known(fs::path(map.name).filename().string());
  for (; std::max(found.columns, found.rows) > pixels; stride *= 2) {
    found.values = halved_cells(std::span<const float>(found.values), found.columns,
                                kind ? kind->overview : MapOverview::maximum, no_data);
    found.columns = (found.columns + 1) / 2;
    found.rows = (found.rows + 1) / 2;
  }
  found.cell = {place[1] * stride, -place[5] * stride};
  found.origin = {place[0], place[3] - found.rows * found.cell[1]};
  const auto line = static_cast<std::ptrdiff_t>(found.columns);
  for (auto north = found.values.begin(), south = found.values.end() - line; north < south;
       north += line, south -= line)
    std::swap_ranges(north, north + line, south);  // from south to north
  std::replace(found.values.begin(), found.values.end(), no_data, std::numeric_limits<float>::quiet_NaN());
  return found;
}

#else

std::vector<MapFile> maps_of_run(const fs::path&) { return {}; }

MapValues read_map(const fs::path& folder, const MapFile& map, int) {
  throw BadInput(Problem{.file = file_of(folder, map.name).string(),
                         .what = "cannot be read",
                         .why = "this program was built without GDAL"});
}

#endif

}  // namespace talus
