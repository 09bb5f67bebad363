#include "talus/import/vector_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <sqlite3.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include "support/rasters.hpp"
#include "support/vectors.hpp"
#include "talus/core/stop.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Value = std::optional<std::string>;

class VectorFileTest : public RasterFolder {
 protected:
  /// A GeoPackage with one layer.
  void make(const std::vector<WrittenFeature>& features, const std::string& crs = "EPSG:31287",
            const std::string& layer = "ground") {
    std::filesystem::remove(path("ground.gpkg"));
    add_layer(path("ground.gpkg"), layer, crs, "material", features);
  }
  [[nodiscard]] VectorLayer read(const VectorRequest& request = {}, const std::string& file = "ground.gpkg") {
    warnings_ = Problems{};
    return read_vector_file(path(file), request, warnings_);
  }
  [[nodiscard]] std::string refusal(const VectorRequest& request = {}, const std::string& file = "ground.gpkg") {
    return refusal_of([&] { static_cast<void>(read(request, file)); });
  }
};

TEST_F(VectorFileTest, ReadsPointsLinesAndPolygonsWithTheirValues) {
  make({{"POINT Z (1 2 3)", "a"},
        {"LINESTRING (0 0, 5 0, 5 5)", ""},
        {"POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (2 2, 2 4, 4 4, 2 2))", "b"}});
  const VectorLayer layer = read({.attributes = {"MATERIAL"}});
  EXPECT_EQ(layer.name, "ground");
  EXPECT_EQ(layer.crs_name, "EPSG:31287");
  ASSERT_EQ(layer.features.size(), 3U);
  const VectorFeature &point = layer.features[0], &line = layer.features[1], &polygon = layer.features[2];
  EXPECT_EQ(point.id, 1);
  EXPECT_TRUE(point.has_z);
  ASSERT_EQ(point.parts.size(), 1U);
  EXPECT_EQ(point.parts[0].kind, ShapeKind::point);
  EXPECT_THAT(point.parts[0].lists, ElementsAre(ElementsAre(Vec3(1, 2, 3))));
  EXPECT_THAT(point.values, ElementsAre(Value("a")));
  EXPECT_FALSE(line.has_z);
  EXPECT_EQ(line.parts.at(0).kind, ShapeKind::line);
  EXPECT_THAT(line.parts[0].lists, ElementsAre(ElementsAre(Vec3(0, 0, 0), Vec3(5, 0, 0), Vec3(5, 5, 0))));
  EXPECT_THAT(line.values, ElementsAre(Value()));
  EXPECT_EQ(polygon.parts.at(0).kind, ShapeKind::polygon);
  EXPECT_THAT(polygon.parts[0].lists,
              ElementsAre(ElementsAre(Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 10, 0), Vec3(0, 10, 0)),
                          ElementsAre(Vec3(2, 2, 0), Vec3(2, 4, 0), Vec3(4, 4, 0))));
  EXPECT_EQ(warnings(), "");
}

TEST_F(VectorFileTest, CollectionsBecomePartsAndCurvesChords) {
  make({{"MULTIPOLYGON (((0 0, 1 0, 1 1, 0 0)), ((5 5, 6 5, 6 6, 5 5)))", "a"},
        {"GEOMETRYCOLLECTION (POINT (1 1), MULTILINESTRING ((0 0, 1 0), (2 0, 3 0)))", "b"},
        {"CIRCULARSTRING (0 0, 1 1, 2 0)", "c"}});
  const VectorLayer layer = read();
  ASSERT_EQ(layer.features.size(), 3U);
  EXPECT_EQ(layer.features[0].parts.size(), 2U);
  ASSERT_EQ(layer.features[1].parts.size(), 3U);
  EXPECT_EQ(layer.features[1].parts[0].kind, ShapeKind::point);
  EXPECT_EQ(layer.features[1].parts[2].kind, ShapeKind::line);
  // A half circle of radius 1 about (1, 0); no chord is further than a hundredth inside it.
  const auto& arc = layer.features[2].parts.at(0).lists.at(0);
  ASSERT_GT(arc.size(), 20U);
  for (std::size_t i = 0; i < arc.size(); ++i) {
    EXPECT_NEAR((arc[i] - Vec3(1, 0, 0)).norm(), 1, 1e-9);
    if (i > 0) {
      EXPECT_GT((0.5 * (arc[i] + arc[i - 1]) - Vec3(1, 0, 0)).norm(), 0.99);
    }
  }
}

// A terrain in New Zealand in metres (NZTM), and a file in degrees; compared with PROJ's transformation.
TEST_F(VectorFileTest, TransformsFeaturesToTheCoordinateSystemOfTheTerrain) {
  write("cliffs.geojson", R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {},
      "geometry": {"type": "Point", "coordinates": [174.7645, -36.8785, 190]}}]})");
  const VectorLayer layer = read({.terrain_crs_wkt = wkt("EPSG:2193")}, "cliffs.geojson");
  EXPECT_EQ(layer.crs_name, "EPSG:4979");  // GDAL's choice for a GeoJSON with a third coordinate
  const Vec3 place = layer.features.at(0).parts.at(0).lists.at(0).at(0);
  OGRSpatialReference degrees, metres;
  degrees.importFromEPSG(4326);
  metres.importFromEPSG(2193);
  // In the definitions' own order of axes: latitude first, and northing first.
  const std::unique_ptr<OGRCoordinateTransformation> there(OGRCreateCoordinateTransformation(&degrees, &metres));
  double a = -36.8785, b = 174.7645;
  ASSERT_TRUE(there->Transform(1, &a, &b));
  EXPECT_NEAR(place.x(), b, 1e-6);
  EXPECT_NEAR(place.y(), a, 1e-6);
  EXPECT_NEAR(place.x(), 1757354, 2000);
  EXPECT_NEAR(place.y(), 5917254, 2000);
  EXPECT_EQ(place.z(), 190);
  EXPECT_EQ(warnings(), "");
}

TEST_F(VectorFileTest, WithoutACoordinateSystemThatOfTheTerrainIsAssumed) {
  write("points.csv", "x,y,z,name\n1,2,3,a\n4,5,6,b\n");
  const VectorLayer layer = read({.attributes = {"name"}, .terrain_crs_wkt = wkt("EPSG:31287")}, "points.csv");
  ASSERT_EQ(layer.features.size(), 2U);
  EXPECT_EQ(layer.features[1].parts.at(0).lists.at(0).at(0), Vec3(4, 5, 6));
  EXPECT_TRUE(layer.features[1].has_z);
  EXPECT_THAT(layer.features[1].values, ElementsAre(Value("b")));
  EXPECT_EQ(warnings(),
            "points.csv: warning: has no coordinate system (that of the terrain is assumed). Assign it: ogr2ogr "
            "-a_srs EPSG:XXXX points_placed.gpkg points.csv");
  EXPECT_EQ(read({}, "points.csv").features.size(), 2U);
  EXPECT_EQ(warnings(), "");
}

TEST_F(VectorFileTest, WarnsOfAnUnknownCoordinateSystem) {
  const auto write_with = [&](const std::string& crs) {
    std::ofstream(path("a.geojson"))
        << R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": ")" << crs
        << R"("}}, "features": [{"type": "Feature", "properties": {}, "geometry": )"
        << R"({"type": "Point", "coordinates": [11, 47]}}]})";
  };
  const VectorRequest in_tyrol{.kinds = {ShapeKind::point}, .terrain_crs_wkt = wkt("EPSG:31287")};
  write_with("EPSG:999999");
  EXPECT_EQ(read(in_tyrol, "a.geojson").features.size(), 1U);
  EXPECT_EQ(warnings(),
            "a.geojson: warning: has an unknown coordinate system (EPSG:4326 is assumed). Assign the right one: "
            "ogr2ogr -a_srs EPSG:XXXX a_placed.gpkg a.geojson");
  write_with("EPSG:4326");
  EXPECT_EQ(read(in_tyrol, "a.geojson").features.size(), 1U);
  EXPECT_EQ(warnings(), "");
}

TEST_F(VectorFileTest, FindsLayersAndAttributesOrSuggestsThem) {
  make({{"POINT (1 2)", "a"}}, "EPSG:31287", "rocks");
  add_layer(path("ground.gpkg"), "scree", "EPSG:31287", "kind", {{"POINT (3 4)", "b"}});
  EXPECT_EQ(refusal(), R"(ground.gpkg: has 2 layers ("rocks", "scree"). Choose one: layer = "rocks")");
  EXPECT_EQ(read({.layer = "scree"}).features.at(0).parts[0].lists[0][0], Vec3(3, 4, 0));
  EXPECT_EQ(refusal({.layer = "scre"}),
            R"(ground.gpkg: has no layer "scre" (it has "rocks", "scree"). Did you mean "scree"?)");
  EXPECT_EQ(refusal({.layer = "scree", .attributes = {"kinds"}}),
            R"(ground.gpkg: layer "scree" has no attribute "kinds" (it has "kind"). Did you mean "kind"?)");
  write("table.csv", "a,b\n1,2\n");
  EXPECT_EQ(refusal({}, "table.csv"),
            "table.csv: has no points, lines or polygons (it has only tables: \"table\"). A CSV needs columns x and y, "
            "or one named WKT");
}

TEST_F(VectorFileTest, RefusesFilesWithoutFeatures) {
  EXPECT_EQ(refusal({}, "none.gpkg"),
            "none.gpkg: cannot be read (there is no such file). Paths are relative to the project file");
  write("not.geojson", "hello");
  EXPECT_THAT(refusal({}, "not.geojson"), StartsWith("not.geojson: is not a vector file that Talus reads (GDAL: "));
  make({});
  EXPECT_EQ(refusal(), "ground.gpkg: layer \"ground\" is empty (it has no features)");
  make({{"", "a"}, {"", "b"}});
  EXPECT_EQ(refusal(), "ground.gpkg: layer \"ground\" is empty (none of its 2 features has a geometry)");
  make({{"", "a"}, {"POINT (1 2)", "b"}});
  EXPECT_EQ(read().features.size(), 1U);
  EXPECT_EQ(warnings(),
            "ground.gpkg: warning: 1 of 2 features of layer \"ground\" have no geometry (they are left out)");
}

TEST_F(VectorFileTest, RefusesDegreesAndFeetWithoutATerrainToTransformTo) {
  make({{"POINT (15 47)", "a"}}, "EPSG:4326");
  EXPECT_EQ(refusal(),
            "ground.gpkg: is in degrees (EPSG:4326 is a geographic coordinate system, and that of the terrain is not "
            "known). Project it: ogr2ogr -t_srs EPSG:XXXX ground_metres.gpkg ground.gpkg");
  make({{"POINT (15 47)", "a"}}, "EPSG:2274");
  EXPECT_EQ(refusal(),
            "ground.gpkg: is not in metres (the unit of EPSG:2274 is US survey foot, and the coordinate system of the "
            "terrain is not known). Project it: ogr2ogr -t_srs EPSG:XXXX ground_metres.gpkg ground.gpkg");
  make({{"POINT (1757000 5920000)", "a"}, {"POINT (1757000 5920001)", "a"}}, "EPSG:4326");
  EXPECT_EQ(refusal({.terrain_crs_wkt = wkt("EPSG:2193")}),
            "ground.gpkg: feature 1 is at (1757000, 5920000) (EPSG:4326 is in degrees). Assign the right one: ogr2ogr "
            "-a_srs EPSG:XXXX ground_placed.gpkg ground.gpkg\n"
            "ground.gpkg: feature 2 is at (1757000, 5920001) (EPSG:4326 is in degrees). Assign the right one: ogr2ogr "
            "-a_srs EPSG:XXXX ground_placed.gpkg ground.gpkg");
  make({{"POINT (15 47)", "a"}}, "LOCAL_CS[\"site grid\",UNIT[\"metre\",1]]");
  EXPECT_EQ(refusal({.terrain_crs_wkt = wkt("EPSG:2193")}),
            "ground.gpkg: is in site grid (there is no transformation from it to EPSG:2193, that of the terrain). "
            "Assign the right one: ogr2ogr -a_srs EPSG:XXXX ground_placed.gpkg ground.gpkg");
}

TEST_F(VectorFileTest, SurfacesOfFacetsAreTheirFacets) {
  make({{"TIN Z (((0 0 5, 9 0 6, 9 9 7, 0 0 5)), ((0 0 5, 9 9 7, 0 9 8, 0 0 5)))", "a"},
        {"POLYHEDRALSURFACE Z (((0 0 5, 9 0 6, 9 9 7, 0 0 5)), ((9 0 0, 9 9 0, 9 9 5, 9 0 5, 9 0 0)))", "b"},
        {"TRIANGLE Z ((0 0 5, 9 0 6, 9 9 7, 0 0 5))", "c"},
        {"MULTISURFACE (((0 0, 1 0, 1 1, 0 0)))", "d"}});
  const VectorLayer layer = read({.kinds = {ShapeKind::polygon}, .polygons_are_in_space = true});
  ASSERT_EQ(layer.features.size(), 4U);
  ASSERT_EQ(layer.features[0].parts.size(), 2U);
  EXPECT_THAT(layer.features[0].parts[1].lists, ElementsAre(ElementsAre(Vec3(0, 0, 5), Vec3(9, 9, 7), Vec3(0, 9, 8))));
  EXPECT_EQ(layer.features[1].parts.size(), 2U);
  EXPECT_EQ(layer.features[2].parts.size(), 1U);
  EXPECT_EQ(layer.features[3].parts.size(), 1U);
}

TEST_F(VectorFileTest, HeightsThatAreNotUsedNeedNotExist) {
  // GDAL writes no NaN into a GeoPackage: the bytes of a height of 1234.5 are changed in the file.
  const auto with_nan = [&](const std::string& geometry) {
    make({{geometry, "a"}});
    const auto bytes_of_number = [](double x) { return std::string(reinterpret_cast<const char*>(&x), sizeof x); };
    const std::string height = bytes_of_number(1234.5), nan = bytes_of_number(std::nan(""));
    std::ifstream in(path("ground.gpkg"), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::size_t changed = 0;
    for (auto at = bytes.find(height); at != std::string::npos; at = bytes.find(height, at), ++changed)
      bytes.replace(at, height.size(), nan);
    ASSERT_GT(changed, 0U);
    std::ofstream(path("ground.gpkg"), std::ios::binary) << bytes;
  };
  with_nan("POLYGON Z ((0 0 5, 9 0 1234.5, 9 9 5, 0 0 5))");
  EXPECT_THAT(read(polygons).features.at(0).parts.at(0).lists,
              ElementsAre(ElementsAre(Vec3(0, 0, 5), Vec3(9, 0, 0), Vec3(9, 9, 5))));
  with_nan("LINESTRING Z (0 0 5, 9 0 1234.5, 9 9 5)");
  EXPECT_EQ(read().features.size(), 1U);
  EXPECT_EQ(refusal({.heights_are_used = true}),
            "ground.gpkg: feature 1 has the coordinates (9, 0, nan) (coordinates must be finite)");
  make({{"LINESTRING Z (0 0 5, 9 0 -1.7976931348623157e308, 9 9 5)", "a"}});
  EXPECT_EQ(read().features.size(), 1U);
  EXPECT_EQ(
      refusal({.heights_are_used = true}),
      "ground.gpkg: feature 1 has the height -1.797693135e+308 at (9, 0) (heights must be between -9000 and 100000 m)");
}

TEST_F(VectorFileTest, NumbersAreAsShortAsPossible) {
  {
    const GdalMessages gdal(GdalFiles::in_folder(path("")));
    const GDALDatasetUniquePtr file(GetGDALDriverManager()
                                        ->GetDriverByName("ESRI Shapefile")
                                        ->Create(path("areas.shp").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    ASSERT_TRUE(file);
    OGRLayer& layer = *file->CreateLayer("areas", nullptr, wkbPoint, nullptr);
    OGRFieldDefn real("class", OFTReal), text("code", OFTString);
    real.SetWidth(10);
    real.SetPrecision(3);
    ASSERT_EQ(layer.CreateField(&real), OGRERR_NONE);
    ASSERT_EQ(layer.CreateField(&text), OGRERR_NONE);
    for (const double value : {2.0, 2.5}) {
      const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer.GetLayerDefn()));
      feature->SetField("class", value);
      feature->SetField("code", "2.000");
      OGRPoint place(1, 2);
      feature->SetGeometry(&place);
      ASSERT_EQ(layer.CreateFeature(feature.get()), OGRERR_NONE);
    }
  }
  const VectorLayer layer = read({.attributes = {"class", "code"}}, "areas.shp");
  EXPECT_THAT(layer.features.at(0).values, ElementsAre(Value("2"), Value("2.000")));
  EXPECT_THAT(layer.features.at(1).values, ElementsAre(Value("2.5"), Value("2.000")));
  EXPECT_THAT(layer.are_numbers, ElementsAre(true, false));
}

TEST_F(VectorFileTest, TheProjectionOfCompoundSystemsKeepsHeights) {
  make({{"POINT Z (15 47 300)", "a"}}, "EPSG:4326+5773");
  EXPECT_THAT(refusal(),
              HasSubstr("Project it: ogr2ogr -s_srs EPSG:4326 -t_srs EPSG:XXXX ground_metres.gpkg ground.gpkg"));
}

TEST_F(VectorFileTest, RefusesPolygonsThatCrossThemselvesWithTheirPlace) {
  make({{"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))", "a"}, {"POLYGON ((0 0, 10 10, 10 0, 0 10, 0 0))", "b"}});
  EXPECT_EQ(
      refusal(polygons),
      "ground.gpkg: feature 2 is not a valid polygon (self-intersection at or near point 5 5). Repair it: ogr2ogr "
      "-makevalid ground_valid.gpkg ground.gpkg");
  make({{"MULTIPOLYGON (((0 0, 9 0, 9 9, 0 0)), ((1 0, 9 0, 9 9, 1 0)))", "a"},
        {"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0), (5 5, 6 5, 6 6, 5 5))", "b"}});
  EXPECT_THAT(refusal(polygons),
              HasSubstr("ground.gpkg: feature 2 is not a valid polygon (hole lies outside shell at"));
}

TEST_F(VectorFileTest, RefusesOtherKinds) {
  make({{"POINT (1 2)", "a"}, {"LINESTRING (0 0, 1 1)", "b"}, {"POLYGON ((0 0, 1 0, 1 1, 0 0))", "c"}});
  EXPECT_EQ(refusal(polygons),
            "ground.gpkg: feature 1 is a point (expected polygons)\n"
            "ground.gpkg: feature 2 is a line (expected polygons)");
  make(std::vector<WrittenFeature>(9, {"POINT (1 2)", "a"}));
  EXPECT_THAT(refusal(polygons), HasSubstr("feature 5 is a point (expected polygons)\n"
                                           "ground.gpkg: 4 more shapes have this problem"));
}

TEST_F(VectorFileTest, RefusesFilesThatAreCutShort) {
  make(std::vector<WrittenFeature>(3000, {"LINESTRING (0 0, 1 1, 2 2, 3 3, 4 4, 5 5, 6 6)", "a"}));
  std::filesystem::resize_file(path("ground.gpkg"), std::filesystem::file_size(path("ground.gpkg")) / 2);
  EXPECT_THAT(refusal(), AnyOf(StartsWith("ground.gpkg: is not a vector file that Talus reads (GDAL: "),
                               StartsWith("ground.gpkg: cannot be read completely (after ")));
}

TEST_F(VectorFileTest, RefusesHugeDeclaredSizesBeforeReading) {
  make({{"POINT (1 2)", "a"}});
  {
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("ground.gpkg").c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    file->ExecuteSQL("UPDATE gpkg_ogr_contents SET feature_count = 9000000000", nullptr, nullptr);
  }
  EXPECT_EQ(refusal(),
            "ground.gpkg: layer \"ground\" declares 9000000000 features (Talus reads at most 50000000). Cut it to the "
            "slope: ogr2ogr -spat WEST SOUTH EAST NORTH ground_slope.gpkg ground.gpkg");
}

TEST_F(VectorFileTest, RefusesCoordinatesThatAreNotFinite) {
  make({{"LINESTRING (0 0, 5 1e999)", "a"}, {"POINT Z (1 2 1e999)", "b"}});
  EXPECT_EQ(refusal({.heights_are_used = true}),
            "ground.gpkg: feature 1 has the coordinates (5, inf, 0) (coordinates must be finite)\n"
            "ground.gpkg: feature 2 has the coordinates (1, 2, inf) (coordinates must be finite)");
}

// A view can be an endless query, of which GDAL never returns a first feature.
TEST_F(VectorFileTest, StopsReadingAnEndlessView) {
  const std::filesystem::path file = path("endless.gpkg");
  add_layer(file, "places", "EPSG:31287", "name", {{"POINT (1 2)", "a"}});
  const auto run = [&](const std::string& sql) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
    sqlite3_close(database);
  };
  run("CREATE VIEW v AS WITH RECURSIVE c(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM c) "
      "SELECT i AS fid, i AS name, (SELECT geom FROM places) AS geom FROM c WHERE i < 0;"
      "INSERT INTO gpkg_contents (table_name, identifier, data_type, srs_id) VALUES ('v', 'v', 'features', 31287);"
      "INSERT INTO gpkg_geometry_columns VALUES ('v', 'geom', 'POINT', 31287, 0, 0);");
  std::atomic<bool> stop{false};
  const auto begin = std::chrono::steady_clock::now();
  const std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop = true;
  });
  const StopScope scope(&stop);
  Problems warnings;
  EXPECT_THROW(
      (void)read_vector_file(file, {.layer = "v", .attributes = {}, .kinds = {}, .terrain_crs_wkt = {}}, warnings),
      Stopped);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::minutes(1));
}

TEST_F(VectorFileTest, RefusesViewsThatDoNotEnd) {
  const std::string counting = "WITH RECURSIVE c(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM c) ";
  for (const std::string& view :
       {counting + "SELECT i AS fid, i AS name, (SELECT geom FROM places) AS geom FROM c WHERE i < 0",  // no row
        counting + "SELECT i AS fid, i AS name, (SELECT geom FROM places) AS geom FROM c"}) {           // endless rows
    const std::string file = path("views.gpkg").string();
    std::filesystem::remove(file);
    add_layer(file, "places", "EPSG:31287", "name", {{"POINT (1 2)", "a"}});
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
    const std::string sql =
        "CREATE VIEW v AS " + view +
        ";INSERT INTO gpkg_contents (table_name, identifier, data_type, srs_id) VALUES ('v', 'v', 'features', 31287);"
        "INSERT INTO gpkg_geometry_columns VALUES ('v', 'geom', 'POINT', 31287, 0, 0);";
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
    sqlite3_close(database);
    const std::string refused =
        "views.gpkg: has a view that does not end (its query took more steps than a file of this size can need). Copy "
        "the "
        "features that you need to a table of their own";
    EXPECT_EQ(refusal({.layer = "v"}, "views.gpkg"), refused);
    EXPECT_EQ(refusal({.layer = "v", .within = std::array{Vec2(0, 0), Vec2(5, 5)}}, "views.gpkg"), refused);
  }
}

}  // namespace
}  // namespace talus

#else

namespace talus {
namespace {

TEST(VectorFile, IsRefusedWithoutGdal) {
  Problems warnings;
  try {
    static_cast<void>(read_vector_file("ground.gpkg", {}, warnings));
    FAIL() << "was read";
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(),
                 "ground.gpkg: cannot be read (this build of Talus has no GDAL). Build it with GDAL: cmake --preset "
                 "release -DTALUS_GDAL=ON");
  }
}

}  // namespace
}  // namespace talus

#endif
