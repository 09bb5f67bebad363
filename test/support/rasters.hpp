#pragma once
// Small rasters in a temporary folder.

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "support/input_folder.hpp"
#include "talus/gdal/gdal_raster.hpp"
#include "talus/import/survey_crs.hpp"

namespace talus::testing_tools {

/// A GeoTIFF; cells in rows from the north-west.
struct RasterSpec {
  int columns = 4, rows = 3;
  std::vector<double> cells{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  std::optional<std::array<double, 6>> geotransform = std::array<double, 6>{400000, 10, 0, 300030, 0, -10};
  std::string crs = "EPSG:31287";  // empty: none
  GDALDataType type = GDT_Float32;
  std::optional<double> no_data;
  std::string unit;
  std::optional<double> scale, offset;
  std::optional<GDALColorInterp> colour;
};

/// The header of an Esri ASCII grid, from its south-western corner.
[[nodiscard]] inline std::string ascii_header(int columns, int rows, double west, double south, double cell) {
  return fmt::format("ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\n", columns, rows, west, south, cell);
}

/// A virtual raster (VRT), as large and at the place of a default RasterSpec unless set otherwise.
struct Vrt {
  int columns = 4, rows = 3;
  std::string place = "<SRS>EPSG:31287</SRS><GeoTransform>400000,10,0,300030,0,-10</GeoTransform>";
  std::string bands{};
  int band_count = 0;

  /// Adds a band with these elements. `attributes` are further ones of the band: ` subClass="..."`.
  Vrt& band(const std::string& elements, const std::string& type = "Float32", const std::string& attributes = "") {
    bands += fmt::format("<VRTRasterBand dataType=\"{}\" band=\"{}\"{}>{}</VRTRasterBand>", type, ++band_count,
                         attributes, elements);
    return *this;
  }
  [[nodiscard]] std::string text() const {
    return fmt::format("<VRTDataset rasterXSize=\"{}\" rasterYSize=\"{}\">{}{}</VRTDataset>", columns, rows, place,
                       bands);
  }
};

/// The first band of a file as the source of a VRT's band; `more` are further elements of the source.
[[nodiscard]] inline std::string vrt_source(const std::string& file, bool is_relative = true,
                                            const std::string& more = "") {
  return fmt::format(
      "<SimpleSource><SourceFilename relativeToVRT=\"{}\">{}</SourceFilename><SourceBand>1</SourceBand>{}"
      "</SimpleSource>",
      is_relative ? 1 : 0, file, more);
}

/// A project's crs = "NAME".
[[nodiscard]] inline ProjectCrs project_crs(const std::string& name) {
  return {.crs = crs_in_words(name).value(), .is_local = false};
}
/// A project's crs = "local".
[[nodiscard]] inline ProjectCrs local_crs() { return {.crs = {}, .is_local = true}; }

/// A coordinate system as WKT.
[[nodiscard]] inline std::string wkt(const std::string& name) { return crs_in_words(name).value().wkt; }

class RasterFolder : public InputFolder {
 protected:
  void make(const std::string& name, const RasterSpec& spec = {}) const {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    ASSERT_NE(driver, nullptr);
    GDALDatasetUniquePtr file(driver->Create(path(name).c_str(), spec.columns, spec.rows, 1, spec.type, nullptr));
    ASSERT_TRUE(file);
    if (spec.geotransform) {
      std::array<double, 6> t = *spec.geotransform;
      file->SetGeoTransform(t.data());
    }
    if (!spec.crs.empty()) {
      OGRSpatialReference crs;
      ASSERT_EQ(crs.SetFromUserInput(spec.crs.c_str()), OGRERR_NONE);
      file->SetSpatialRef(&crs);
    }
    GDALRasterBand& band = *file->GetRasterBand(1);
    if (spec.no_data) band.SetNoDataValue(*spec.no_data);
    if (!spec.unit.empty()) band.SetUnitType(spec.unit.c_str());
    if (spec.scale) band.SetScale(*spec.scale);
    if (spec.offset) band.SetOffset(*spec.offset);
    if (spec.colour) band.SetColorInterpretation(*spec.colour);
    std::vector<double> cells = spec.cells;
    ASSERT_EQ(cells.size(), static_cast<std::size_t>(spec.columns) * static_cast<std::size_t>(spec.rows));
    ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, spec.columns, spec.rows, cells.data(), spec.columns, spec.rows, GDT_Float64,
                            0, 0, nullptr),
              CE_None);
  }

 private:
  GdalMessages gdal_{GdalFiles::in_folder(::testing::TempDir())};  // for what tests themselves do with GDAL
};

}  // namespace talus::testing_tools

#endif
