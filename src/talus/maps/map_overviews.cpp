#ifdef TALUS_HAS_GDAL

#include "talus/maps/map_overviews.hpp"

#include <cpl_conv.h>

#include <algorithm>
#include <vector>

#include "talus/core/stop.hpp"
#include "talus/maps/halved_cells.hpp"

namespace talus {

namespace {

constexpr int largest_side = 256;  // of the last overview, and of the blocks that are processed
constexpr int largest_without =
    8 * largest_side;  // of a map without overviews: 64 blocks at most are read for any view

bool has_data(GDALRasterBand& band, int x, int y, int columns, int rows) {
  return (band.GetDataCoverageStatus(x, y, columns, rows, 0, nullptr) & GDAL_DATA_COVERAGE_STATUS_DATA) != 0;
}

bool halve(GDALRasterBand& from, GDALRasterBand& to, MapOverview what) {
  const double no_data = from.GetNoDataValue();
  std::vector<double> fine, coarse;
  for (int y = 0; y < to.GetYSize(); y += largest_side) {
    stop_point();
    for (int x = 0; x < to.GetXSize(); x += largest_side) {
      const int columns = std::min(largest_side, to.GetXSize() - x), rows = std::min(largest_side, to.GetYSize() - y);
      const int fine_columns = std::min(2 * columns, from.GetXSize() - 2 * x);
      const int fine_rows = std::min(2 * rows, from.GetYSize() - 2 * y);
      if (!has_data(from, 2 * x, 2 * y, fine_columns, fine_rows)) continue;
      fine.resize(static_cast<std::size_t>(fine_columns) * static_cast<std::size_t>(fine_rows));
      if (from.RasterIO(GF_Read, 2 * x, 2 * y, fine_columns, fine_rows, fine.data(), fine_columns, fine_rows,
                        GDT_Float64, 0, 0, nullptr) != CE_None) {
        return false;
      }
      coarse = halved_cells(std::span<const double>(fine), fine_columns, what, no_data);
      if (to.RasterIO(GF_Write, x, y, columns, rows, coarse.data(), columns, rows, GDT_Float64, 0, 0, nullptr) !=
          CE_None) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

bool wants_overviews(int columns, int rows) { return std::max(columns, rows) > largest_without; }

bool build_overviews(GDALDataset& raster, MapOverview what) {
  std::vector<int> factors;
  for (int longest = std::max(raster.GetRasterXSize(), raster.GetRasterYSize()), factor = 1; longest > largest_side;) {
    longest = (longest + 1) / 2;
    factors.push_back(factor *= 2);
  }
  // Makes the bands of the overviews without values, which are computed here.
  const CPLConfigOptionSetter sparse("SPARSE_OK_OVERVIEW", "TRUE", false);
  if (raster.BuildOverviews("NONE", static_cast<int>(factors.size()), factors.data(), 0, nullptr, nullptr, nullptr) !=
      CE_None) {
    return false;
  }
  GDALRasterBand* from = raster.GetRasterBand(1);
  for (int k = 0; k < static_cast<int>(factors.size()); ++k) {
    GDALRasterBand* to = raster.GetRasterBand(1)->GetOverview(k);
    if (to == nullptr || !halve(*from, *to, what)) return false;
    from = to;
  }
  return true;
}

}  // namespace talus

#endif
