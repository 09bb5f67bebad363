// Files that refer to others, on the network or elsewhere on disk: these are not opened, and no connection is made.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <fstream>

#include "support/listener.hpp"
#include "support/raster_reading.hpp"
#include "support/vectors.hpp"
#include "talus/gdal/gdal_open.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
namespace fs = std::filesystem;

class DataElsewhere : public RasterReading {
 protected:
  DataElsewhere() {
    fs::create_directories(path("project/tiles"));
    make("secret.tif");
    make("project/tiles/a.tif");
  }
  ~DataElsewhere() override { EXPECT_FALSE(listener_.was_contacted()); }

  [[nodiscard]] std::string raster(const std::string& name) {
    return refusal(name.starts_with("/vsi") ? name : "project/" + name);
  }
  [[nodiscard]] std::string vectors(const std::string& name) const {
    return refusal_of([&] {
      Problems warnings;
      (void)read_vector_file(path("project/" + name), {}, warnings);
    });
  }
  /// A mosaic of one raster.
  [[nodiscard]] static std::string mosaic(const std::string& source, bool is_relative = true) {
    return Vrt{}.band(vrt_source(source, is_relative)).text();
  }

  Listener listener_;
};

TEST_F(DataElsewhere, DescriptionsOfServicesAreNotRasters) {
  const std::string read =
      "Talus reads GeoTIFF, Esri ASCII grid (.asc), Esri float grid (.flt, .bil), Erdas Imagine (.img) and VRT";
  write("project/dem.tif", "<GDAL_WMS><Service name=\"WMS\"><ServerUrl>" + listener_.address() +
                               "/?</ServerUrl><Layers>a</Layers></Service><DataWindow><SizeX>10</SizeX><SizeY>10"
                               "</SizeY></DataWindow></GDAL_WMS>");
  EXPECT_EQ(raster("dem.tif"),
            "project/dem.tif: is not a raster that Talus reads (it begins with <GDAL_WMS>). " + read);
  write("project/dem.tif", "<?xml version=\"1.0\"?>\n<WCS_GDAL><ServiceURL>" + listener_.address() +
                               "/?</ServiceURL><CoverageName>a</CoverageName></WCS_GDAL>");
  EXPECT_THAT(raster("dem.tif"), HasSubstr("it begins with <WCS_GDAL>"));
  write("project/dem.tif", "<WMTS><GetCapabilitiesUrl>" + listener_.address() + "</GetCapabilitiesUrl></WMTS>");
  EXPECT_THAT(raster("dem.tif"), HasSubstr("it begins with <WMTS>"));
}

TEST_F(DataElsewhere, OnlyArchivesOnDiskAreReadAsFileSystems) {
  for (const std::string system : {"/vsicurl/", "/vsicurl?url=", "/vsicurl_streaming/", "/vsizip//vsicurl/",
                                   "/vsigzip//vsicurl/", "/vsisubfile/0_100,/vsicurl/", "/vsicached?file=/vsicurl/"}) {
    const std::string name = system + listener_.address() + "/dem.tif";
    EXPECT_EQ(raster(name), name +
                                ": cannot be read (of GDAL's virtual file systems Talus reads only /vsizip/ and "
                                "/vsigzip/ of files on disk). Copy it to disk and use that file");
  }
  for (const std::string name : {"/vsistdin/", "/vsimem/dem.tif", "/vsisparse/dem.xml", "/vsitar/a.tar/dem.tif"}) {
    EXPECT_THAT(raster(name), HasSubstr("of GDAL's virtual file systems Talus reads"));
  }
  EXPECT_THAT(raster("/vsizip/vsicurl/" + listener_.address() + "/a.zip/dem.tif"), HasSubstr("there is no such file"));
}

TEST_F(DataElsewhere, NamesThatLookLikeFormatsAreFileNames) {
  // With a folder of such a name, each is the name of a file.
  for (const std::string before : {"GTIFF_DIR:1:", "GTIFF_RAW:", "HDF5:", "vrt:"}) {
    fs::create_directories(path("project/" + before));
    fs::copy_file(path("project/tiles/a.tif"), path("project/" + before + "/a.tif"));
    const fs::path old = fs::current_path();
    fs::current_path(path("project"));
    Problems warnings;
    EXPECT_EQ(read_raster_file(before + "/a.tif", warnings).grid.columns, 4U);
    fs::current_path(old);
  }
  for (const std::string& name : {"PG:host=127.0.0.1 port=" + listener_.host().substr(10), "WMS:" + listener_.address(),
                                  listener_.address() + "/dem.tif", "vrt://" + listener_.address()}) {
    EXPECT_THAT(raster(name), HasSubstr("cannot be read (there is no such file)")) << name;
    EXPECT_THAT(vectors(name), HasSubstr("cannot be read (there is no such file)")) << name;
  }
}

TEST_F(DataElsewhere, AMosaicRefersToRastersNextToIt) {
  write("project/dem.vrt", mosaic("tiles/a.tif"));
  EXPECT_EQ(raster("dem.vrt"), "was read");
  write("project/dem.tif", mosaic("dem.vrt"));
  EXPECT_EQ(raster("dem.tif"), "was read");
  write("project/dem.vrt", mosaic(path("project/tiles/a.tif").string(), false));
  EXPECT_EQ(raster("dem.vrt"), "was read");
  Problems warnings;
  ClassRaster classes(path("project/dem.vrt"), "", warnings);
  const std::vector<Vec2> places{Vec2(400005, 300025)};
  EXPECT_EQ(classes.at(places).at(0), 1);  // the tile is opened when its first cell is read
}

TEST_F(DataElsewhere, AMosaicMustNotReferToAnythingElse) {
  const std::string hint =
      ". Put its rasters next to it. If you trust it: gdal_translate project/dem.vrt project/dem.tif";
  const std::string elsewhere = "(a VRT may refer only to rasters in its own folder or below it)";
  fs::create_symlink(path("secret.tif"), path("project/link.tif"));
  fs::create_symlink("/vsicurl/" + listener_.address() + "/a.tif", path("project/broken.tif"));
  for (const std::string& source :
       {std::string("../secret.tif"), path("secret.tif").string(), "/vsicurl/" + listener_.address() + "/a.tif",
        std::string("link.tif"), std::string("tiles/../../secret.tif"), std::string("/vsizip/a.zip/a.tif")}) {
    write("project/dem.vrt", mosaic(source));
    EXPECT_EQ(raster("dem.vrt"), without_folder("project/dem.vrt: refers to \"" + source + "\" " + elsewhere + hint));
  }
  for (const std::string& source : {listener_.address() + "/a.tif", "WMS:" + listener_.address(),
                                    std::string("&lt;VRTDataset/&gt;"), std::string("none.tif")}) {
    write("project/dem.vrt", mosaic(source));
    EXPECT_THAT(raster("dem.vrt"), HasSubstr("(there is no such file)")) << source;
  }
  write("project/dem.vrt", mosaic("broken.tif"));
  EXPECT_THAT(raster("dem.vrt"), HasSubstr("refers to \"broken.tif\" (there is no such file)"));
  write("project/notes.txt", "not for you");
  write("project/dem.vrt", mosaic("notes.txt"));
  EXPECT_EQ(raster("dem.vrt"),
            "project/dem.vrt: refers to \"notes.txt\" (that is not a raster that Talus reads)" + hint);
  write("project/inner.tif", mosaic("../secret.tif"));
  write("project/dem.vrt", mosaic("inner.tif"));
  EXPECT_EQ(raster("dem.vrt"),
            "project/dem.vrt: refers to \"inner.tif\", which refers to \"../secret.tif\" " + elsewhere + hint);
  write("project/dem.vrt", mosaic("dem.vrt"));
  EXPECT_NE(raster("dem.vrt"), "was read");
}

TEST_F(DataElsewhere, AVirtualRasterMustBeAMosaic) {
  write("project/notes.txt", "not for you");
  const Vrt row{.columns = 4, .rows = 1, .place = ""};
  write("project/dem.vrt", Vrt(row)
                               .band("<SourceFilename relativeToVRT=\"1\">notes.txt</SourceFilename>", "Byte",
                                     " subClass=\"VRTRawRasterBand\"")
                               .text());
  EXPECT_EQ(raster("dem.vrt"),
            "project/dem.vrt: is a virtual raster of the type VRTRawRasterBand (Talus reads mosaics of rasters, as "
            "made by gdalbuildvrt). Put its rasters next to it. If you trust it: gdal_translate project/dem.vrt "
            "project/dem.tif");
  write("project/dem.vrt", "<VRTDataset rasterXSize=\"4\" rasterYSize=\"1\" subClass=\"VRTWarpedDataset\"/>");
  EXPECT_THAT(raster("dem.vrt"), HasSubstr("is a virtual raster of the type VRTWarpedDataset"));
  write("project/dem.vrt",
        Vrt(row)
            .band("<PixelFunctionLanguage>Python</PixelFunctionLanguage>", "Byte", " subClass=\"VRTDerivedRasterBand\"")
            .text());
  EXPECT_THAT(raster("dem.vrt"), HasSubstr("is a virtual raster of the type VRTDerivedRasterBand"));
}

TEST_F(DataElsewhere, SidecarFilesMustNotReferToOthers) {
  for (const std::string& other : {"/vsicurl/" + listener_.address() + "/a.tif", std::string("../secret.tif"),
                                   std::string(":::BASE:::/../../secret.tif"), path("secret.tif").string()}) {
    make("project/dem.tif");
    write("project/dem.tif.aux.xml", "<PAMDataset><SRS>" + listener_.address() +
                                         "/crs</SRS><Metadata domain=\"OVERVIEWS\"><MDI "
                                         "key=\"OVERVIEW_FILE\">" +
                                         other + "</MDI></Metadata></PAMDataset>");
    GdalMessages messages;
    RasterProblems problems(path("project/dem.tif"));
    const auto dataset = open_raster(messages, problems);
    EXPECT_EQ(dataset->GetRasterBand(1)->GetOverviewCount(), 0) << other;
  }
  EXPECT_EQ(raster("dem.tif"), "was read");
}

TEST_F(DataElsewhere, VirtualLayersAreNotVectorFiles) {
  write("passwords.csv", "x,y,word\n1,2,secret\n");
  const fs::path cache = path("cache.sqlite");
  write("project/contours.gpkg",
        "<OGRVRTDataSource><OGRVRTLayer name=\"a\"><SrcDataSource>" + path("passwords.csv").string() +
            "</SrcDataSource><SrcSQL dialect=\"sqlite\">SELECT ogr_geocode(word, 'geometry', 'query_template=" +
            listener_.address() + "/%s', 'cache_file=" + cache.string() +
            "') FROM passwords</SrcSQL></OGRVRTLayer></OGRVRTDataSource>");
  EXPECT_EQ(vectors("contours.gpkg"),
            "project/contours.gpkg: is not a vector file that Talus reads (it begins with <OGRVRTDataSource>). Talus "
            "reads GeoPackage, Shapefile, GeoJSON, DXF and CSV");
  EXPECT_FALSE(fs::exists(cache));
  write("project/contours.gpkg", "<OGRWFSDataSource><URL>" + listener_.address() + "</URL></OGRWFSDataSource>");
  EXPECT_THAT(vectors("contours.gpkg"), HasSubstr("it begins with <OGRWFSDataSource>"));
  write("project/a.gml", "<gml:FeatureCollection xmlns:gml=\"http://www.opengis.net/gml\" xsi:schemaLocation=\"a " +
                             listener_.address() + "/a.xsd\"/>");
  EXPECT_THAT(vectors("a.gml"), HasSubstr("it begins with <gml:FeatureCollection>"));
  write("project/a.kml", "<kml><NetworkLink><Link><href>" + listener_.address() + "</href></Link></NetworkLink></kml>");
  EXPECT_THAT(vectors("a.kml"), HasSubstr("it begins with <kml>"));
}

TEST_F(DataElsewhere, CoordinateSystemsAreNotFetched) {
  write("project/a.geojson", R"({"type":"FeatureCollection","crs":{"type":"link","properties":{"href":")" +
                                 listener_.address() +
                                 R"(/crs","type":"proj4"}},"features":[{"type":"Feature","properties":{},)"
                                 R"("geometry":{"type":"Point","coordinates":[1,2]}}]})");
  (void)vectors("a.geojson");
  EXPECT_EQ(crs_in_words(listener_.address() + "/crs"), std::nullopt);
  EXPECT_FALSE(listener_.was_contacted());
}

/// A GeoPackage with one layer, whose table is replaced.
class GeoPackageElsewhere : public DataElsewhere {
 protected:
  void replace_table(const std::string& sql) const {
    const fs::path file = path("project/a.gpkg");
    fs::remove(file);
    add_layer(file, "a", "EPSG:31287", "name", {{"POINT (1 2)", "x"}});
    const GDALDatasetUniquePtr opened(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    for (const std::string& each :
         {std::string("PRAGMA writable_schema = ON"), std::string("DELETE FROM sqlite_master WHERE type = 'trigger'"),
          "UPDATE sqlite_master SET " + sql + ", rootpage = 0 WHERE name = 'a'"}) {
      opened->ReleaseResultSet(opened->ExecuteSQL(each.c_str(), nullptr, nullptr));
    }
  }
};

TEST_F(GeoPackageElsewhere, VirtualTablesDoNotReadOtherFiles) {
  write("secret.txt", "geom:fid\nsecret:1\n");
  replace_table("sql = 'CREATE VIRTUAL TABLE a USING VirtualText(''" + path("secret.txt").string() +
                "'', ''UTF-8'', 1, COLON)'");
  EXPECT_THAT(vectors("a.gpkg"), AllOf(StartsWith("project/a.gpkg: "), HasSubstr("GDAL: "), Not(HasSubstr("secret"))));
}

TEST_F(GeoPackageElsewhere, ViewsMakeNoConnections) {
  const fs::path cache = path("cache.sqlite");
  replace_table(
      "type = 'view', sql = 'CREATE VIEW a AS SELECT 1 AS fid, ogr_geocode(''x'', ''geometry'', "
      "''query_template=" +
      listener_.address() + "/%s'', ''cache_file=" + cache.string() + "'') AS geom'");
  EXPECT_NE(vectors("a.gpkg"), "was read");
  EXPECT_FALSE(fs::exists(cache));
  replace_table("type = 'view', sql = 'CREATE VIEW a AS SELECT 1 AS fid, ST_MinX(NULL) AS geom, ''x'' AS name'");
  EXPECT_NE(vectors("a.gpkg"), "was read") << "an untrusted function";
}

TEST_F(DataElsewhere, GdalOpensOnlyTheFilesInReach) {
  const GdalMessages none;
  EXPECT_FALSE(GDALDatasetUniquePtr(GDALDataset::Open(path("secret.tif").c_str())));
  const GdalMessages one(GdalFiles(path("project/tiles/a.tif")));
  EXPECT_TRUE(GDALDatasetUniquePtr(GDALDataset::Open(path("project/tiles/a.tif").c_str())));
  EXPECT_FALSE(GDALDatasetUniquePtr(GDALDataset::Open(path("secret.tif").c_str())));
  VSILFILE* const written = VSIFOpenL(path("project/tiles/a.tif").c_str(), "r+b");
  EXPECT_EQ(written, nullptr) << "input files must not be opened for writing";
}

}  // namespace
}  // namespace talus

#endif
