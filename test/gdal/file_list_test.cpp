// The files that belong to an input.

#include "talus/gdal/file_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/rasters.hpp"
#include "support/vectors.hpp"

namespace talus {
namespace {

#ifdef TALUS_HAS_GDAL

class FileList : public testing_tools::RasterFolder {
 protected:
  [[nodiscard]] std::vector<std::string> names(const std::string& file) const {
    std::vector<std::string> found;
    for (const auto& each : files_read_with(path(file))) found.push_back(without_folder(each.string()));
    return found;
  }
};

using Names = std::vector<std::string>;

TEST_F(FileList, OfARasterHasItsPositionAndCoordinateSystem) {
  write("dem.asc", testing_tools::ascii_header(2, 2, 0, 0, 1) + "1 2\n3 4\n");
  write("dem.prj", "LOCAL_CS[\"quarry\",UNIT[\"metre\",1]]");
  write("dem.txt", "not part of it");
  EXPECT_EQ(names("dem.asc"), (Names{"dem.asc", "dem.prj"}));
}

TEST_F(FileList, OfAMosaicHasItsSources) {
  std::filesystem::create_directories(path("tiles"));
  make("tiles/a.tif");
  write("dem.vrt", testing_tools::Vrt{}.band(testing_tools::vrt_source("tiles/a.tif")).text());
  EXPECT_EQ(names("dem.vrt"), (Names{"dem.vrt", "tiles/a.tif"}));
}

TEST_F(FileList, OfAShapefileHasItsParts) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("ESRI Shapefile");
  if (driver == nullptr) GTEST_SKIP() << "no driver for Shapefiles";
  {
    const GdalMessages gdal(GdalFiles::in_folder(path("")));
    GDALDatasetUniquePtr made(driver->Create(path("lines.shp").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!made) GTEST_SKIP() << "Shapefiles cannot be written";
    OGRLayer* layer = made->CreateLayer("lines", nullptr, wkbLineString, nullptr);
    OGRFieldDefn field("name", OFTString);
    ASSERT_EQ(layer->CreateField(&field), OGRERR_NONE);
  }
  Names found = names("lines.shp");
  std::ranges::sort(found);
  EXPECT_EQ(found, (Names{"lines.dbf", "lines.shp", "lines.shx"}));
}

TEST_F(FileList, OfOtherFilesIsTheFile) {
  write("slope.obj", "v 0 0 0\n");
  write("slope.mtl", "");
  write("broken.tif", "no raster");
  EXPECT_EQ(names("slope.obj"), Names{"slope.obj"});
  EXPECT_EQ(names("broken.tif"), Names{"broken.tif"});
  EXPECT_EQ(names("not-there.tif"), Names{"not-there.tif"});
}

TEST_F(FileList, OfAFolderIsWhatIsInIt) {
  std::filesystem::create_directories(path("grid/below"));
  write("grid/b.adf", "");
  write("grid/a.adf", "");
  EXPECT_EQ(names("grid"), (Names{"grid/a.adf", "grid/b.adf"}));
}

#endif

}  // namespace
}  // namespace talus
