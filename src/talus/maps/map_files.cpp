#include "talus/maps/map_files.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/output_file.hpp"
#include "talus/maps/map_list.hpp"

#ifdef TALUS_HAS_GDAL
#include "talus/gdal/gdal_raster.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/maps/map_overviews.hpp"
#endif

namespace talus {

namespace {

/// Whether a map from write_maps() can have this name, with any percentile.
bool is_name_of_map(std::string_view name) {
  const std::vector<MapKind> kinds = map_kinds({.percentiles = {50}, .bands = banded_map_subjects});
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

/// ZSTD takes half the time of DEFLATE for files of the same size. Values of a rock's motion have too many digits for a
/// predictor to help either of them. Some builds of GDAL have no ZSTD.
struct Compression {
  const char *scheme, *level;  // options of the driver GTiff
};
const Compression& compression() {
  static const bool has_zstd = [] {
    GDALDriver* const tiff = GetGDALDriverManager()->GetDriverByName("GTiff");
    const char* const options = tiff != nullptr ? tiff->GetMetadataItem(GDAL_DMD_CREATIONOPTIONLIST) : nullptr;
    return options != nullptr && std::string_view(options).find("ZSTD") != std::string_view::npos;
  }();
  static const Compression chosen =
      has_zstd ? Compression{"COMPRESS=ZSTD", "ZSTD_LEVEL=1"} : Compression{"COMPRESS=DEFLATE", "ZLEVEL=1"};
  return chosen;
}

constexpr double no_rock = -9999;
double value_without_rock(const MapKind& kind) { return kind.is_count ? 0 : no_rock; }

/// A map while it is written. A small one goes straight to its file. A large one has overviews, which come before the
/// cells in a cloud-optimised file: it is gathered in memory first, with only the blocks that have data.
class MapRaster {
 public:
  static constexpr int block = 256;  // cells a side

  MapRaster(const MapKind& kind, bool has_large_counts, int columns, int rows, const std::array<double, 2>& corner,
            const std::array<double, 2>& cell, const std::string& crs_wkt, std::filesystem::path file)
      : kind_(kind), file_(std::move(file)), part_(OutputFile::part_of(file_)) {
    has_overviews_ = wants_overviews(columns, rows);
    name_ = has_overviews_ ? fmt::format("/vsimem/talus-{}.tif", static_cast<const void*>(this)) : part_.string();
    // A part that a killed run left: GDAL would open it and report errors in it.
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
    const GdalMessages messages(GdalFiles::in_folder(file_.parent_path()));
    const Options options{"TILED=YES",        "BLOCKXSIZE=256",
                          "BLOCKYSIZE=256",   "SPARSE_OK=TRUE",
                          "BIGTIFF=IF_SAFER", has_overviews_ ? "COMPRESS=NONE" : compression().scheme,
                          compression().level};
    const GDALDataType type = !kind.is_count ? GDT_Float32 : has_large_counts ? GDT_Float64 : GDT_UInt32;
    raster_.reset(driver("GTiff", file_).Create(name_.c_str(), columns, rows, 1, type, options));
    if (!raster_) refuse(file_, messages);
    std::array<double, 6> geotransform{corner[0], cell[0], 0, corner[1], 0, -cell[1]};
    raster_->SetGeoTransform(geotransform.data());
    if (const auto crs = crs_for_file(crs_wkt)) raster_->SetSpatialRef(&*crs);
    GDALRasterBand& band = *raster_->GetRasterBand(1);
    band.SetNoDataValue(value_without_rock(kind));
    band.SetDescription(kind.meaning.c_str());
    band.SetUnitType(kind.unit.c_str());
  }
  MapRaster(const MapRaster&) = delete;
  MapRaster& operator=(const MapRaster&) = delete;
  ~MapRaster() {
    raster_.reset();
    if (has_overviews_) VSIUnlink(name_.c_str());
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
  }

  /// Writes the values of a block of cells, from north to south; its first cell is at (x, y) of the picture.
  void write(int x, int y, int columns, int rows, std::vector<double>& values) {
    for (const double value : values) {
      if (value <= 0) continue;
      range_.least = range_.least == 0 ? value : std::min(range_.least, value);
      range_.greatest = std::max(range_.greatest, value);
    }
    const GdalMessages messages(GdalFiles::in_folder(file_.parent_path()));
    if (raster_->GetRasterBand(1)->RasterIO(GF_Write, x, y, columns, rows, values.data(), columns, rows, GDT_Float64, 0,
                                            0, nullptr) != CE_None) {
      refuse(file_, messages);
    }
  }

  void finish() {
    GdalMessages messages(GdalFiles::in_folder(file_.parent_path()));
    if (has_overviews_) {
      copy_with_overviews(messages);
    } else {
      raster_.reset();
    }
    stop_point();
    if (messages.has_failure()) refuse(file_, messages);  // errors while a file is closed are only messages
    finish_file(part_, file_);

    OutputFile style(std::filesystem::path(file_).replace_extension(".qml"));
    style.write(qgis_style(kind_.limits, kind_.is_share() ? MapUnit{"%", 0.01} : MapUnit{kind_.unit}, range_));
    style.commit();
  }

 private:
  void copy_with_overviews(GdalMessages& messages) {
    if (!build_overviews(*raster_, kind_.overview)) refuse(file_, messages);
    const Options cloud_optimised{compression().scheme, "LEVEL=1",       "OVERVIEWS=FORCE_USE_EXISTING",
                                  "SPARSE_OK=TRUE",     "BLOCKSIZE=256", "BIGTIFF=IF_SAFER"};
    messages.clear();
    const auto continues = [](double, const char*, void*) -> int {
      return StopScope::current() == nullptr || !StopScope::current()->is_requested() ? TRUE : FALSE;
    };
    const GDALDatasetUniquePtr copy(
        driver("COG", file_).CreateCopy(part_.c_str(), raster_.get(), FALSE, cloud_optimised, continues, nullptr));
    stop_point();
    if (!copy) refuse(file_, messages);
  }

  const MapKind& kind_;
  std::filesystem::path file_, part_;
  bool has_overviews_;
  std::string name_;  // of the raster: `part_`, or a file in memory
  GDALDatasetUniquePtr raster_;
  ValueRange range_;
};

/// The tiles that are in the same block of a picture, which goes from north to south.
using Blocks = std::map<std::pair<int, int>, std::vector<const Maps::Tile*>>;

Blocks blocks_of(const Maps& maps, const Maps::Extent& extent) {
  Blocks blocks;
  const auto among = [](std::int32_t cell, std::int32_t most) { return std::clamp(cell, 0, most) / MapRaster::block; };
  const std::int32_t columns = extent.last.column - extent.first.column, rows = extent.last.row - extent.first.row;
  for (const Maps::Tile* tile : maps.tiles()) {
    const std::int32_t west = tile->first().column - extent.first.column, east = west + Maps::tile_side - 1;
    const std::int32_t south = extent.last.row - tile->first().row, north = south - Maps::tile_side + 1;
    for (std::int32_t y = among(north, rows); y <= among(south, rows); ++y) {
      for (std::int32_t x = among(west, columns); x <= among(east, columns); ++x) blocks[{y, x}].push_back(tile);
    }
  }
  return blocks;
}

/// The maps of a group: each cell is read once.
void write_group(const MapsOfRun& maps, const MapGroup& group, const Maps::Extent& extent, const Blocks& blocks,
                 bool is_large, const std::string& crs_wkt, const std::filesystem::path& folder) {
  std::vector<std::unique_ptr<MapRaster>> files;
  const MapGrid& grid = maps.all.grid();
  const std::array<double, 2> corner{grid.origin().x() + extent.first.column * grid.cell().x(),
                                     grid.origin().y() + (extent.last.row + 1) * grid.cell().y()};
  for (const MapKind& kind : group.kinds) {
    files.push_back(std::make_unique<MapRaster>(
        kind, is_large, extent.last.column - extent.first.column + 1, extent.last.row - extent.first.row + 1, corner,
        std::array{grid.cell().x(), grid.cell().y()}, crs_wkt, folder / (kind.name + ".tif")));
  }
  std::vector<std::vector<double>> values(files.size());
  std::vector<double> of_cell(files.size());
  MapCells cells(maps, group.needs_ensembles);
  for (const auto& [place, tiles] : blocks) {
    stop_point();
    const int x = place.second * MapRaster::block, y = place.first * MapRaster::block;
    const int columns = std::min(MapRaster::block, extent.last.column - extent.first.column + 1 - x);
    const int rows = std::min(MapRaster::block, extent.last.row - extent.first.row + 1 - y);
    for (std::size_t k = 0; k < files.size(); ++k) {
      values[k].assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                       value_without_rock(group.kinds[k]));
    }
    const std::int32_t west = extent.first.column + x, north = extent.last.row - y;
    for (const Maps::Tile* tile : tiles) {
      cells.enter(*tile);
      const std::int32_t first_column = std::max(tile->first().column, west);
      const std::int32_t last_column = std::min(tile->first().column + Maps::tile_side, west + columns) - 1;
      const std::int32_t first_row = std::max(tile->first().row, north - rows + 1);
      const std::int32_t last_row = std::min(tile->first().row + Maps::tile_side - 1, north);
      for (std::int32_t row = first_row; row <= last_row; ++row) {
        for (std::int32_t column = first_column; column <= last_column; ++column) {
          const auto cell = cells.find(column - tile->first().column, row - tile->first().row);
          if (!cell) continue;
          group.values(*cell, of_cell);
          const auto at = static_cast<std::size_t>((north - row) * columns + column - west);
          for (std::size_t k = 0; k < files.size(); ++k) {
            if (!std::isnan(of_cell[k])) values[k][at] = of_cell[k];
          }
        }
      }
    }
    for (std::size_t k = 0; k < files.size(); ++k) files[k]->write(x, y, columns, rows, values[k]);
  }
  // Isolated: a thread that waits for the last file must not start another group meanwhile, which would need memory,
  // too.
  const StopScope* const here = StopScope::current();
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for_each(files, [&](std::unique_ptr<MapRaster>& file) {
      const StopScope there(here);
      stop_point();
      file->finish();
      file.reset();
    });
  });
}

/// Whether a count needs more than 32 bits.
bool has_large_counts(const Maps& maps) {
  for (const Maps::Tile* tile : maps.tiles()) {
    stop_point();
    for (std::int32_t k = 0; k < Maps::tile_side * Maps::tile_side; ++k) {
      const auto tally = tile->find(k % Maps::tile_side, k / Maps::tile_side);
      if (tally && std::max(tally->impacts(), tally->passages()) > 4294967295U) return true;
    }
  }
  return false;
}

/// GDAL 3.6 makes a driver's list of options on first use, without a lock. So this is done once before threads start.
void make_lists_of_options() {
  const GdalMessages quiet;
  for (const char* name : {"GTiff", "COG"}) {
    GDALDriver* const found = GetGDALDriverManager()->GetDriverByName(name);
    if (found != nullptr) (void)found->GetMetadataItem(GDAL_DMD_CREATIONOPTIONLIST);
  }
}

}  // namespace

bool can_write_maps() { return true; }

std::vector<std::string> write_maps(const MapsOfRun& maps, const MapSelection& selection, const std::string& crs_wkt,
                                    const std::filesystem::path& folder) {
  std::vector<std::string> names;
  const auto extent = maps.all.extent();
  if (!extent) return names;
  make_output_folder(folder);
  const std::vector<MapGroup> groups = map_groups(selection);
  for (const MapGroup& group : groups) {
    for (const MapKind& kind : group.kinds) names.push_back(kind.name);
  }
  make_lists_of_options();
  const Blocks blocks = blocks_of(maps.all, *extent);
  const bool is_large = has_large_counts(maps.all);
  const StopScope* const here = StopScope::current();
  tbb::parallel_for_each(groups, [&](const MapGroup& group) {
    const StopScope there(here);
    write_group(maps, group, *extent, blocks, is_large, crs_wkt, folder);
  });
  return names;
}

void write_map(const MapKind& kind, const MapPicture& picture, const std::string& crs_wkt,
               const std::filesystem::path& file) {
  make_lists_of_options();
  const bool is_large = std::ranges::any_of(picture.values, [](double value) { return value > 4294967295.0; });
  MapRaster raster(kind, is_large, picture.columns, picture.rows, picture.corner, picture.cell, crs_wkt, file);
  std::vector<double> values = picture.values;
  std::ranges::replace_if(
      values, [](double value) { return std::isnan(value); }, value_without_rock(kind));
  raster.write(0, 0, picture.columns, picture.rows, values);
  raster.finish();
}

#else

bool can_write_maps() { return false; }

void write_map(const MapKind&, const MapPicture&, const std::string&, const std::filesystem::path& file) {
  throw BadInput(
      Problem{.file = file.string(), .what = "cannot write this map", .why = "this program was built without GDAL"});
}

std::vector<std::string> write_maps(const MapsOfRun&, const MapSelection&, const std::string&,
                                    const std::filesystem::path& folder) {
  throw BadInput(Problem{.file = folder.string(),
                         .what = "cannot write maps",
                         .why = "this program was built without GDAL",
                         .hint = "Build it with GDAL, or set maps = false"});
}

#endif

}  // namespace talus
