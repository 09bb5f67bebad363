// Pipes, devices and links to them where files are expected: to GDAL and PROJ they do not exist.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <sys/stat.h>

#include <filesystem>

#include "support/raster_reading.hpp"
#include "support/vectors.hpp"
#include "talus/gdal/file_list.hpp"
#include "talus/gdal/raster_crs.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Each test would wait for ever.
class SpecialFiles : public RasterReading {
 protected:
  void pipe(const std::string& name) const { ASSERT_EQ(mkfifo(path(name).c_str(), 0600), 0) << name; }
  [[nodiscard]] std::string vectors(const std::string& name) {
    return refusal_of([&] { static_cast<void>(read_vector_file(path(name), {}, warnings_)); });
  }
};

TEST_F(SpecialFiles, AreNoSideFilesOfRasters) {
  make("dem.tif");
  for (const char* side : {"dem.tif.aux.xml", "dem.aux.xml", "dem.tif.ovr", "dem.tif.msk", "dem.tfw", "dem.tifw",
                           "dem.wld", "dem.prj", "dem.aux", "dem.rrd", "dem.IMD", "dem.RPB"})
    pipe(side);
  EXPECT_EQ(read("dem.tif").grid.z, from_the_south);
  EXPECT_EQ(files_read_with(path("dem.tif")), std::vector{path("dem.tif")});
  write("grid.asc", ascii_header(2, 2, 400000, 300000, 10) + "1 2\n3 4\n");
  for (const char* side : {"grid.prj", "grid.PRJ", "grid.asc.aux.xml", "grid.asc.ovr"}) pipe(side);
  EXPECT_EQ(read("grid.asc").grid.columns, 2U);
}

TEST_F(SpecialFiles, AreNoSideFilesAlsoByLinks) {
  make("dem.tif");
  pipe("pipe");
  fs::create_symlink(path("pipe"), path("dem.tif.aux.xml"));
  fs::create_symlink("/dev/zero", path("dem.tfw"));
  fs::create_symlink("/dev/stdin", path("dem.prj"));
  fs::create_symlink(path("dem.tif.ovr"), path("dem.tif.ovr"));  // to itself
  EXPECT_EQ(read("dem.tif").grid.z, from_the_south);
}

TEST_F(SpecialFiles, AreNoSideFilesOfShapefiles) {
  {
    const GDALDatasetUniquePtr file(GetGDALDriverManager()
                                        ->GetDriverByName("ESRI Shapefile")
                                        ->Create(path("a.shp").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    ASSERT_TRUE(file);
    OGRLayer& layer = *file->CreateLayer("a", nullptr, wkbPoint, nullptr);
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
    OGRPoint place(1, 2);
    feature->SetGeometry(&place);
    ASSERT_EQ(layer.CreateFeature(feature.get()), OGRERR_NONE);
  }
  for (const char* side : {"a.dbf", "a.prj", "a.cpg", "a.qix", "a.sbn", "a.idm", "a.shp.xml"}) {
    fs::remove(path(side));
    pipe(side);
  }
  EXPECT_EQ(vectors("a.shp"), "was read");
}

TEST_F(SpecialFiles, BesideADatabaseAreRefused) {
  for (const char* side : {"a.gpkg-journal", "a.gpkg-wal", "a.gpkg-shm"}) {
    fs::remove(path("a.gpkg"));
    add_layer(path("a.gpkg"), "a", "EPSG:31287", "name", {{"POINT (1 2)", "a"}});
    pipe(side);
    EXPECT_EQ(vectors("a.gpkg"),
              "a.gpkg: cannot be read (\"" + std::string(side) + "\" belongs to it, but it is a pipe). Remove it");
    fs::remove(path(side));
    EXPECT_EQ(vectors("a.gpkg"), "was read");
  }
}

TEST_F(SpecialFiles, AreNoSourcesOfMosaics) {
  pipe("a.tif");
  write("dem.vrt", Vrt{}.band(vrt_source("a.tif")).text());
  EXPECT_THAT(refusal("dem.vrt"), HasSubstr("it is a pipe"));
}

// ---- coordinate systems ----

TEST_F(SpecialFiles, CoordinateSystemsMustNotNameFiles) {
  pipe("grid.gsb");
  const std::string grid = path("grid.gsb").string();
  const std::string geometry =
      "\"features\":[{\"type\":\"Feature\",\"properties\":{},\"geometry\":{\"type\":\"Point\",\"coordinates\":[1,2]}}]"
      "}";
  const auto geojson = [&](const std::string& crs) {
    write("f.geojson", "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"" + crs +
                           "\"}}," + geometry);
    return refusal_of([&] {
      static_cast<void>(read_vector_file(path("f.geojson"), {.terrain_crs_wkt = wkt("EPSG:31287")}, warnings_));
    });
  };
  const std::string tmerc = "+proj=tmerc +lat_0=0 +lon_0=13 +ellps=bessel +units=m +no_defs ";
  const std::string hint = ". Assign one without it: ogr2ogr -a_srs EPSG:XXXX f_placed.gpkg f.geojson";
  EXPECT_EQ(geojson(tmerc + "+nadgrids=../outside.gsb"),
            "f.geojson: has a coordinate system that names a file (+nadgrids=../outside.gsb; Talus reads no files that "
            "others name)" +
                hint);
  EXPECT_THAT(geojson(tmerc + "+nadgrids=" + grid), HasSubstr("names a file"));
  EXPECT_THAT(geojson(tmerc + "+nadgrids=@" + grid), HasSubstr("names a file"));
  EXPECT_THAT(geojson(tmerc + "+nadgrids=@null,./grid.gsb"), HasSubstr("names a file"));
  EXPECT_THAT(geojson(tmerc + "+geoidgrids=" + grid), HasSubstr("names a file"));
  EXPECT_EQ(geojson(tmerc + "+nadgrids=@null"), "was read");
  EXPECT_EQ(geojson(tmerc + "+towgs84=577.326,90.129,463.919,5.137,1.474,5.297,2.4232"), "was read");
  EXPECT_EQ(geojson("urn:ogc:def:crs:EPSG::31287"), "was read");
  static_cast<void>(geojson("+init=" + grid + ":1"));  // unknown, and not opened
}

TEST_F(SpecialFiles, WordsOfCoordinateSystemsAreChecked) {
  EXPECT_EQ(file_in_crs_words("+proj=tmerc +nadgrids=../a.gsb +units=m"), "+nadgrids=../a.gsb");
  EXPECT_EQ(file_in_crs_words("+proj=utm +zone=32 +geoidgrids=@/tmp/a.gtx"), "+geoidgrids=@/tmp/a.gtx");
  EXPECT_EQ(file_in_crs_words("+proj=pipeline +step +proj=hgridshift +grids=~/a.tif"), "+grids=~/a.tif");
  EXPECT_EQ(file_in_crs_words("+proj=utm +zone=32 +nadgrids=\"/tmp/a b.gsb\""), "+nadgrids=/tmp/a");
  EXPECT_EQ(file_in_crs_words("+init=./mine:31287"), "+init=./mine:31287");
  EXPECT_EQ(file_in_crs_words("+init=mine:31287"), "+init=mine:31287");
  EXPECT_EQ(file_in_crs_words("PROJCS[\"a\",EXTENSION[\"PROJ4\",\"+proj=tmerc +nadgrids=/a.gsb +no_defs\"]]"),
            "+nadgrids=/a.gsb");
  EXPECT_EQ(file_in_crs_words("BOUNDCRS[...,PARAMETERFILE[\"Latitude and longitude difference file\",\"../a.gsb\"]]"),
            "../a.gsb");
  for (const char* good : {"EPSG:31287", "EPSG:25832+5783", "+init=epsg:31287", "+proj=utm +zone=33 +datum=WGS84",
                           "+proj=tmerc +nadgrids=BETA2007.gsb,@null +ellps=bessel", "IGNF:LAMB93",
                           "BOUNDCRS[...,PARAMETERFILE[\"Latitude and longitude difference file\",\"BETA2007.gsb\"]]"})
    EXPECT_EQ(file_in_crs_words(good), std::nullopt) << good;
}

}  // namespace
}  // namespace talus

#endif
