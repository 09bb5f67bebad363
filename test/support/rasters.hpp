#pragma once
// Small rasters in a folder that goes when the test is done.

#ifdef TALUS_HAS_GDAL

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/gdal/gdal_raster.hpp"

namespace talus::testing_tools {

/// How a GeoTIFF is made; cells in the order of a picture, from the north-west.
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

class RasterFolder : public ::testing::Test {
 protected:
  RasterFolder() {
    const auto* const info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path{::testing::TempDir()} /
              ("talus_raster_" + std::string{info->name()} + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~RasterFolder() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }

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

  /// What the user is told, without the folder, which is another at every run.
  [[nodiscard]] std::string without_folder(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) text.erase(at, prefix.size());
    return text;
  }

  template <class Work>
  [[nodiscard]] std::string refusal_of(Work&& work) const {
    try {
      work();
    } catch (const BadInput& error) {
      return without_folder(error.what());
    }
    return "was read";
  }

  std::filesystem::path folder_;

 private:
  GdalMessages gdal_{GdalFiles::in_folder(::testing::TempDir())};  // for what tests themselves do with GDAL
};

}  // namespace talus::testing_tools

#endif
