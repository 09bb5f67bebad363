#include "talus/io/map_files.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/io/map_list.hpp"
#include "talus/io/output_file.hpp"
#include "talus/statistics/quantile_sketch.hpp"

#ifdef TALUS_HAS_GDAL
#include <ogr_spatialref.h>

#include "talus/io/gdal_raster.hpp"
#include "talus/io/map_overviews.hpp"
#endif

namespace talus::io {

namespace {

/// Whether write_maps() could have given a map this name, with whatever percentile.
bool is_name_of_map(std::string_view name) {
  const std::vector<MapKind> kinds = map_kinds(1, std::array{50.0});
  return std::any_of(kinds.begin(), kinds.end(), [&](const MapKind& kind) {
    if (kind.name == name) return true;
    const std::size_t at = kind.name.find("p50");
    if (at == std::string::npos) return false;
    const std::string_view head(kind.name.data(), at + 1), tail(kind.name.data() + at + 3);
    if (name.size() <= head.size() + tail.size() || !name.starts_with(head) || !name.ends_with(tail)) return false;
    name.remove_prefix(head.size());
    name.remove_suffix(tail.size());
    return name.find_first_not_of("0123456789.") == std::string_view::npos;
  });
}

}  // namespace

bool is_name_of_map_file(const std::filesystem::path& name) {
  const std::string extension = name.extension().string();
  return (extension == ".tif" || extension == ".qml") && is_name_of_map(name.stem().string());
}

void remove_maps(const std::filesystem::path& folder) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::error_code ignored;
    if (is_name_of_map_file(entry.path())) {
      std::filesystem::remove(entry.path(), ignored);
    }
  }
}

#ifdef TALUS_HAS_GDAL

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, std::string why, std::string hint,
                         std::string option = {}) {
  throw BadInput(Problem{.file = file.string(),
                         .what = "cannot write this map",
                         .why = std::move(why),
                         .hint = std::move(hint),
                         .option = std::move(option)});
}
[[noreturn]] void refuse(const std::filesystem::path& file, const GdalMessages& messages) {
  refuse(file, messages.failure(), "Free some space, or choose another folder", "-o");
}

GDALDriver& driver(const char* name, const std::filesystem::path& file) {
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName(name);
  if (found == nullptr) {
    refuse(file, fmt::format("the GDAL library of this machine has no driver {}", name),
           "Install GDAL with its usual drivers, or set maps = false");
  }
  return *found;
}

class Options {
 public:
  Options(std::initializer_list<const char*> options) {
    for (const char* option : options) list_ = CSLAddString(list_, option);
  }
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;
  ~Options() { CSLDestroy(list_); }
  operator char**() const { return list_; }

 private:
  char** list_ = nullptr;
};

/// Sees a map's values, and tells over which of them colours are spread.
class RangeFinder {
 public:
  explicit RangeFinder(ColourScale scale) : scale_(scale) {}
  void see(double value) {
    if (value <= 0) return;
    range_.least = range_.least == 0 ? value : std::min(range_.least, value);
    range_.greatest = std::max(range_.greatest, value);
    if (scale_ == ColourScale::linear) values_.add(value);
  }
  [[nodiscard]] ColourRange range() const {
    ColourRange range = range_;
    range.top = values_.quantile(percentile_of_top / 100).value_or(range.greatest);
    return range;
  }

 private:
  ColourScale scale_;
  ColourRange range_;
  QuantileSketch values_{0};  // of as many as come
};

constexpr double no_rock = -9999;

/// All values of one map, in the order of a picture: from north to south. Nothing where GDAL could not take them.
std::optional<ColourRange> fill(GDALRasterBand& band, const Maps& maps, const MapKind& kind,
                                const Maps::Extent& extent) {
  RangeFinder finder(kind.scale);
  std::vector<double> values;
  for (const Maps::Tile* tile : maps.tiles()) {
    stop_point();
    const MapCell first{std::max(tile->first().column, extent.first.column),
                        std::max(tile->first().row, extent.first.row)};
    const MapCell last{std::min(tile->first().column + Maps::tile_side - 1, extent.last.column),
                       std::min(tile->first().row + Maps::tile_side - 1, extent.last.row)};
    const int columns = last.column - first.column + 1, rows = last.row - first.row + 1;
    values.clear();
    for (std::int32_t row = last.row; row >= first.row; --row) {
      for (std::int32_t column = first.column; column <= last.column; ++column) {
        const MapTally* tally = tile->find(column - tile->first().column, row - tile->first().row);
        values.push_back(tally != nullptr ? kind.value(*tally) : kind.is_count ? 0 : no_rock);
        finder.see(values.back());
      }
    }
    if (band.RasterIO(GF_Write, first.column - extent.first.column, extent.last.row - last.row, columns, rows,
                      values.data(), columns, rows, GDT_Float64, 0, 0, nullptr) != CE_None) {
      return std::nullopt;
    }
  }
  return finder.range();
}

/// The largest count of a map decides how its numbers are kept.
GDALDataType type_of(const MapKind& kind, const Maps& maps) {
  if (!kind.is_count) return GDT_Float32;
  for (const Maps::Tile* tile : maps.tiles()) {
    stop_point();
    for (std::int32_t k = 0; k < Maps::tile_side * Maps::tile_side; ++k) {
      const MapTally* tally = tile->find(k % Maps::tile_side, k / Maps::tile_side);
      if (tally != nullptr && kind.value(*tally) > 4294967295.0) return GDT_Float64;
    }
  }
  return GDT_UInt32;
}

void write_map(const Maps& maps, const MapKind& kind, const Maps::Extent& extent, const std::string& crs_wkt,
               const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / (kind.name + ".tif");
  std::filesystem::path part = file;
  part += ".part";
  GdalMessages messages(GdalFiles::in_folder(folder));

  // A raster in memory that keeps only those of its blocks that are written to.
  const std::string scratch = fmt::format("/vsimem/talus-{}.tif", static_cast<const void*>(&kind));
  struct Unlink {
    const std::string& name;
    ~Unlink() { VSIUnlink(name.c_str()); }
  } const unlink{scratch};
  const Options sparse{"TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256", "SPARSE_OK=TRUE", "BIGTIFF=IF_SAFER"};
  const int columns = extent.last.column - extent.first.column + 1, rows = extent.last.row - extent.first.row + 1;
  GDALDatasetUniquePtr raster(
      driver("GTiff", file).Create(scratch.c_str(), columns, rows, 1, type_of(kind, maps), sparse));
  if (!raster) refuse(file, messages);
  const MapGrid& grid = maps.grid();
  std::array<double, 6> geotransform{grid.origin().x() + extent.first.column * grid.cell().x(),
                                     grid.cell().x(),
                                     0,
                                     grid.origin().y() + (extent.last.row + 1) * grid.cell().y(),
                                     0,
                                     -grid.cell().y()};
  raster->SetGeoTransform(geotransform.data());
  if (!crs_wkt.empty()) {
    OGRSpatialReference crs;
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (crs.importFromWkt(crs_wkt.c_str()) == OGRERR_NONE) raster->SetSpatialRef(&crs);
  }
  GDALRasterBand& band = *raster->GetRasterBand(1);
  band.SetNoDataValue(kind.is_count ? 0 : no_rock);
  band.SetDescription(kind.meaning.c_str());
  band.SetUnitType(kind.unit.c_str());
  const std::optional<ColourRange> range = fill(band, maps, kind, extent);
  if (!range || !build_overviews(*raster, kind.overview)) refuse(file, messages);

  const Options cloud_optimised{"COMPRESS=DEFLATE", "LEVEL=1",       "PREDICTOR=YES",   "OVERVIEWS=FORCE_USE_EXISTING",
                                "SPARSE_OK=TRUE",   "BLOCKSIZE=256", "BIGTIFF=IF_SAFER"};
  // Of a run that was killed: GDAL would look into it, and complain of what it finds.
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  messages.clear();
  const auto goes_on = [](double, const char*, void*) -> int {
    return StopScope::current() == nullptr || !StopScope::current()->is_asked() ? TRUE : FALSE;
  };
  const bool is_made =
      GDALDatasetUniquePtr(
          driver("COG", file).CreateCopy(part.c_str(), raster.get(), FALSE, cloud_optimised, goes_on, nullptr)) !=
      nullptr;
  if (!goes_on(1, "", nullptr)) std::filesystem::remove(part, ignored);
  stop_point();
  if (!is_made || messages.has_failure()) {  // what goes wrong while a file is closed is only said
    std::filesystem::remove(part, ignored);
    refuse(file, messages);
  }
  finish_file(part, file);

  OutputFile style(folder / (kind.name + ".qml"));
  style.write(qgis_style(kind.scale, *range));
  style.commit();
}

/// GDAL 3.6 makes a driver's list of options when it is first asked for, without a lock: not by all threads at once.
void make_lists_of_options() {
  const GdalMessages quiet;
  for (const char* name : {"GTiff", "COG"}) {
    GDALDriver* const found = GetGDALDriverManager()->GetDriverByName(name);
    if (found != nullptr) (void)found->GetMetadataItem(GDAL_DMD_CREATIONOPTIONLIST);
  }
}

}  // namespace

bool can_write_maps() { return true; }

std::vector<std::string> write_maps(const Maps& maps, std::span<const double> percentiles, const std::string& crs_wkt,
                                    const std::filesystem::path& folder) {
  std::vector<std::string> names;
  const auto extent = maps.extent();
  if (!extent) return names;
  make_output_folder(folder);
  const std::vector<MapKind> kinds = map_kinds(maps.rocks(), percentiles);
  for (const MapKind& kind : kinds) names.push_back(kind.name);
  make_lists_of_options();
  const StopScope* const here = StopScope::current();
  tbb::parallel_for_each(kinds, [&](const MapKind& kind) {
    const StopScope there(here);
    stop_point();
    write_map(maps, kind, *extent, crs_wkt, folder);
  });
  return names;
}

#else

bool can_write_maps() { return false; }

std::vector<std::string> write_maps(const Maps&, std::span<const double>, const std::string&,
                                    const std::filesystem::path& folder) {
  throw BadInput(Problem{.file = folder.string(),
                         .what = "cannot write maps",
                         .why = "this program was built without GDAL",
                         .hint = "Build it with GDAL, or set maps = false"});
}

#endif

}  // namespace talus::io
