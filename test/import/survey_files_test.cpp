#include "talus/import/survey_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include "support/las.hpp"
#include "support/rasters.hpp"
#include "support/vectors.hpp"
#include "talus/gdal/raster_crs.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;

const char* const csv = "x,y,z\n400000,300000,1000\n400100,300000,1010\n400000,300100,1020\n400100,300100,1030\n";

class SurveyFilesTest : public RasterFolder {
 protected:
  void lines(const std::vector<WrittenFeature>& features, const std::string& crs = "EPSG:31287",
             const std::string& layer = "contours") const {
    add_layer(path("lines.gpkg"), layer, crs, "elev", features);
  }
  [[nodiscard]] SurveySources sources(const std::string& points, const std::string& lines = "") const {
    SurveySources out;
    if (!points.empty()) out.points = path(points);
    if (!lines.empty()) out.lines = path(lines);
    return out;
  }
  [[nodiscard]] SurveyFiles read(const SurveySources& sources) {
    warnings_ = Problems{};
    return read_survey(sources, warnings_);
  }
  [[nodiscard]] std::string refusal(const SurveySources& sources) {
    return refusal_of([&] { static_cast<void>(read(sources)); });
  }
  [[nodiscard]] std::string name_of_crs(const std::string& wkt) const {
    OGRSpatialReference crs;
    return crs.importFromWkt(wkt.c_str()) == OGRERR_NONE ? name_of(crs) : "none";
  }
};

// ---- coordinate systems ----

TEST_F(SurveyFilesTest, TextTakesTheCoordinateSystemOfTheProject) {
  write("p.csv", csv);
  SurveySources from = sources("p.csv");
  EXPECT_EQ(read(from).crs_wkt, "");
  EXPECT_EQ(warnings(),
            "p.csv: warning: has no coordinate system (its coordinates are assumed to be in metres). Set crs = "
            "\"EPSG:...\", or crs = \"local\"");
  from.project_crs = project_crs("EPSG:31287");
  const SurveyFiles files = read(from);
  EXPECT_EQ(name_of_crs(files.crs_wkt), "EPSG:31287");
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(files.survey.points.size(), 4U);
  EXPECT_EQ(without_folder(files.report), "p.csv: 4 points");
}

TEST_F(SurveyFilesTest, LasWithoutACoordinateSystemTakesThatOfTheProject) {
  LasSpec spec;
  spec.offset = {400000, 300000, 0};
  for (const double x : {0.0, 50.0, 100.0}) spec.points.push_back({{400000 + x, 300000 + x * x / 100, 1000}, 2});
  LasBytes(spec).write(path("p.las"));
  SurveySources from = sources("p.las");
  EXPECT_EQ(read(from).crs_wkt, "");
  EXPECT_THAT(warnings(), HasSubstr("p.las: warning: has no coordinate system that Talus understands"));
  from.project_crs = project_crs("EPSG:31287");
  EXPECT_EQ(name_of_crs(read(from).crs_wkt), "EPSG:31287");
  EXPECT_EQ(warnings(), "");
  from.project_crs = local_crs();
  EXPECT_EQ(read(from).crs_wkt, "");
  EXPECT_EQ(warnings(), "");
}

TEST_F(SurveyFilesTest, TextTakesTheCoordinateSystemOfTheLines) {
  write("p.csv", csv);
  lines({{"LINESTRING Z (400010 300010 1005, 400090 300090 1025)", ""}});
  const SurveyFiles files = read(sources("p.csv", "lines.gpkg"));
  EXPECT_EQ(name_of_crs(files.crs_wkt), "EPSG:31287");
  EXPECT_EQ(
      warnings(),
      "p.csv: warning: has no coordinate system (EPSG:31287, that of lines.gpkg, is assumed). Set crs = \"...\" if so");
  EXPECT_EQ(files.survey.lines.size(), 1U);
}

TEST_F(SurveyFilesTest, LinesAreTransformedToTheCoordinateSystemOfThePoints) {
  LasSpec spec;
  spec.offset = {400000, 352000, 0};
  for (const double x : {0.0, 200.0}) {
    for (const double y : {0.0, 200.0}) spec.points.push_back({{400000 + x, 352000 + y, 1000}, 2});
  }
  spec.geo_keys = {{1024, 1}, {3072, 31287}};
  LasBytes(spec).write(path("p.las"));
  // Just east of the central meridian of Austria Lambert, 13.333 degrees, which is at x = 400000.
  lines({{"LINESTRING Z (13.3335 47.0683 1005, 13.3340 47.0686 1025)", ""}}, "EPSG:4326");
  SurveySources from = sources("p.las", "lines.gpkg");
  const SurveyFiles files = read(from);
  EXPECT_EQ(name_of_crs(files.crs_wkt), "EPSG:31287");
  ASSERT_EQ(files.survey.lines.size(), 1U);
  for (const Vec3& p : files.survey.lines[0]) {
    EXPECT_NEAR(p.x(), 400085, 25);
    EXPECT_NEAR(p.y(), 352095, 25);
  }
}

TEST_F(SurveyFilesTest, RefusesDegrees) {
  lines({{"LINESTRING Z (13.33 47.06 1005, 13.34 47.07 1025)", ""}}, "EPSG:4326");
  EXPECT_EQ(
      refusal(sources("", "lines.gpkg")),
      "lines.gpkg: is in degrees (EPSG:4326 is a geographic coordinate system, and that of the terrain is not known). "
      "Project it: ogr2ogr -t_srs EPSG:XXXX lines_metres.gpkg lines.gpkg");
  write("p.csv", "13.33,47.06,1000\n13.34,47.06,1010\n13.33,47.07,1020\n");
  SurveySources text = sources("p.csv");
  EXPECT_EQ(refusal(text),
            "p.csv: seems to be in degrees (it covers x = 13.33 to 13.34, y = 47.06 to 47.07, and has no coordinate "
            "system). Project it to metres; or, if it is in metres, set crs = \"local\"");
  text.project_crs.is_local = true;
  EXPECT_EQ(read(text).survey.points.size(), 3U);
  EXPECT_EQ(warnings(), "");
  text.project_crs = project_crs("EPSG:4326");
  EXPECT_EQ(
      refusal(text),
      "p.csv: is in degrees (EPSG:4326 is a geographic coordinate system; Talus needs metres on plan). Project it: "
      "gdaltransform -s_srs EPSG:XXXX -t_srs EPSG:32633 < p.csv > p_metres.xyz, on lines of x y z");
  LasSpec spec;
  spec.scale = 1e-7;
  spec.points = {{{13.33, 47.06, 10}, 2}, {{13.34, 47.06, 10}, 2}, {{13.33, 47.07, 10}, 2}};
  spec.geo_keys = {{1024, 2}, {2048, 4326}};
  LasBytes(spec).write(path("p.las"));
  EXPECT_EQ(refusal(sources("p.las")),
            "p.las: is in degrees (EPSG:4326 is a geographic coordinate system; Talus needs metres on plan). Project "
            "it: pdal "
            "translate p.las p_metres.las reprojection --filters.reprojection.out_srs=EPSG:32633");
}

TEST_F(SurveyFilesTest, RefusesHeightsInFeet) {
  // NAVD88 heights in US survey feet, with metres on plan.
  LasSpec spec;
  spec.offset = {500000, 4000000, 0};
  spec.points = {{{500000, 4000000, 10}, 2}, {{500100, 4000000, 10}, 2}, {{500000, 4000100, 10}, 2}};
  spec.geo_keys = {{1024, 1}, {3072, 32610}, {4096, 6360}};
  LasBytes(spec).write(path("p.las"));
  EXPECT_THAT(refusal(sources("p.las")), HasSubstr("p.las: has heights in US survey foot (that is the unit of WGS 84 / "
                                                   "UTM zone 10N + NAVD88 height (ftUS), 0.3048006096 m"));
  spec.geo_keys = {{1024, 1}, {3072, 32610}, {4099, 9003}};
  LasBytes(spec).write(path("p.las"));
  EXPECT_EQ(refusal(sources("p.las")),
            "p.las: has heights that are not in metres (its unit is EPSG:9003, 0.3048006096 m). Transform it to one in "
            "metres: "
            "pdal translate p.las p_metres.las reprojection --filters.reprojection.out_srs=EPSG:XXXX");
  spec.geo_keys = {{1024, 1}, {3072, 2227}, {3076, 9003}};
  LasBytes(spec).write(path("p.las"));
  EXPECT_THAT(refusal(sources("p.las")),
              HasSubstr("p.las: is not in metres on plan (its unit is EPSG:9003, 0.3048006096 m)"));
}

TEST_F(SurveyFilesTest, RefusesFilesInAnotherCoordinateSystemThanTheProject) {
  LasSpec spec;
  spec.offset = {400000, 300000, 0};
  spec.points = {{{400000, 300000, 10}, 2}, {{400100, 300000, 10}, 2}, {{400000, 300100, 10}, 2}};
  spec.geo_keys = {{1024, 1}, {3072, 31287}};
  LasBytes(spec).write(path("p.las"));
  SurveySources from = sources("p.las");
  from.project_crs = project_crs("EPSG:32633");
  EXPECT_EQ(refusal(from), "p.las: is in EPSG:31287 (crs is EPSG:32633). Remove crs, or transform the file to it");
  from.project_crs = project_crs("EPSG:31287");
  EXPECT_EQ(name_of_crs(read(from).crs_wkt), "EPSG:31287");
  from.project_crs = local_crs();
  EXPECT_EQ(refusal(from), "p.las: is in EPSG:31287 (crs is \"local\"). Remove crs");
}

TEST_F(SurveyFilesTest, RefusesFilesThatDoNotOverlap) {
  write("p.csv", csv);
  lines({{"LINESTRING Z (500010 300010 1005, 500090 300090 1025)", ""}});
  EXPECT_EQ(
      refusal(sources("p.csv", "lines.gpkg")),
      "lines.gpkg: does not overlap the points (it covers x = 500010 to 500090, y = 300010 to 300090, p.csv covers x "
      "= 400000 to 400100, y = 300000 to 300100). Are both in the same coordinate system?");
  add_layer(path("area.gpkg"), "area", "EPSG:31287", "a", {{"POLYGON ((0 0, 10 0, 10 10, 0 0))", ""}});
  SurveySources from = sources("p.csv");
  from.boundary = path("area.gpkg");
  EXPECT_EQ(
      refusal(from),
      "area.gpkg: does not overlap the survey (it covers x = 0 to 10, y = 0 to 10, the survey covers x = 400000 to "
      "400100, y = 300000 to 300100). Are both in the same coordinate system?");
}

// ---- lines ----

TEST_F(SurveyFilesTest, ContoursTakeTheirHeightsFromAnAttribute) {
  lines({{"LINESTRING (400000 300000, 400100 300000)", "1000"},
         {"MULTILINESTRING ((400000 300050, 400100 300050), (400000 300060, 400100 300060))", "1012.5"},
         {"POLYGON ((400020 300070, 400030 300070, 400030 300080, 400020 300070))", "1020"}});
  SurveySources from = sources("", "lines.gpkg");
  from.elevation_attribute = "ELEV";
  const SurveyFiles files = read(from);
  ASSERT_EQ(files.survey.lines.size(), 4U);
  EXPECT_EQ(files.survey.lines[0][1], Vec3(400100, 300000, 1000));
  EXPECT_EQ(files.survey.lines[2][0], Vec3(400000, 300060, 1012.5));
  EXPECT_EQ(files.survey.lines[3].size(), 4U);  // closed
  EXPECT_EQ(files.survey.lines[3].back(), files.survey.lines[3].front());
  EXPECT_EQ(without_folder(files.report), "lines.gpkg: 4 lines of 10 vertices, of layer \"contours\"");
}

TEST_F(SurveyFilesTest, RefusesLinesWithoutHeights) {
  lines({{"LINESTRING (0 0, 1 1)", "1000"}, {"LINESTRING (0 0, 1 1)", "high"}, {"LINESTRING (0 0, 1 1)", ""}});
  SurveySources from = sources("", "lines.gpkg");
  EXPECT_EQ(refusal(from),
            "lines.gpkg: feature 1 has no heights (its geometry has only x and y). Name the attribute with the "
            "heights: elevation_attribute = \"...\"\n"
            "lines.gpkg: feature 2 has no heights (its geometry has only x and y). Name the attribute with the "
            "heights: elevation_attribute = \"...\"\n"
            "lines.gpkg: feature 3 has no heights (its geometry has only x and y). Name the attribute with the "
            "heights: elevation_attribute = \"...\"");
  from.elevation_attribute = "elev";
  EXPECT_EQ(refusal(from),
            "lines.gpkg: feature 2 has the elev \"high\" (a height is a number of metres)\n"
            "lines.gpkg: feature 3 has no height (its elev is empty)");
  from.elevation_attribute = "elevation";
  EXPECT_THAT(refusal(from),
              HasSubstr("lines.gpkg: layer \"contours\" has no attribute \"elevation\" (it has \"elev\")"));
}

TEST_F(SurveyFilesTest, RefusesHeightsThatWereNotFilledIn) {
  lines({{"LINESTRING Z (400000 300000 0, 400100 300000 0, 400000 300050 0)", "1000"}});
  EXPECT_EQ(refusal(sources("", "lines.gpkg")),
            "lines.gpkg: has only heights of 0 (every vertex is at 0). If an attribute has the heights, name it: "
            "elevation_attribute = \"...\"");
  write("p.csv", csv);
  EXPECT_EQ(read(sources("p.csv", "lines.gpkg")).survey.lines.size(), 1U);  // the shore of a lake at 0 m
  EXPECT_THAT(warnings(), HasSubstr("lines.gpkg: warning: has only heights of 0"));
}

TEST_F(SurveyFilesTest, RefusesAnEmptyLayerAndImpossibleHeights) {
  lines({});
  EXPECT_EQ(refusal(sources("", "lines.gpkg")), "lines.gpkg: layer \"contours\" is empty (it has no features)");
  lines({{"LINESTRING Z (0 0 5, 1 1 -9999)", ""}}, "EPSG:31287", "other");
  SurveySources from = sources("", "lines.gpkg");
  from.lines_layer = "other";
  EXPECT_EQ(refusal(from),
            "lines.gpkg: feature 1 has the height -9999 at (1, 1) (heights must be between -9000 and 100000 m)");
}

TEST_F(SurveyFilesTest, WarnsOfVerticesWhoseHeightsAreMissing) {
  lines({{"LINESTRING Z (400000 300000 276, 400010 300000 276, 400020 300000 0, 400030 300000 276)", ""},
         {"LINESTRING Z (400000 300010 266, 400010 300010 266, 400020 300010 -999, 400030 300010 266)", ""}});
  static_cast<void>(read(sources("", "lines.gpkg")));
  EXPECT_EQ(
      warnings(),
      "lines.gpkg: warning: feature 1 has the height 0 at (400020, 300000), and 1 more line has such heights (its "
      "other vertices lie at 276 m; the height seems to be missing). Give the vertex its height, or remove it");
  for (const std::string line :
       {"400000 300000 300, 400010 300000 310, 400020 300000 -999, 400030 300000 320",     // a filler value
        "400000 300000 300, 400010 300000 310, 400020 300000 9999, 400030 300000 320",     //
        "400000 300000 300, 400010 300000 310, 400020 300000 320, 400030 300000 -999",     // at the end
        "400000 300000 276, 400010 300000 276, 400020 300000 27.6, 400030 300000 276"}) {  // a spike
    std::filesystem::remove(path("lines.gpkg"));
    lines({{"LINESTRING Z (" + line + ")", ""}, {"LINESTRING Z (400000 300050 280, 400030 300050 290)", ""}});
    static_cast<void>(read(sources("", "lines.gpkg")));
    EXPECT_THAT(warnings(), HasSubstr("; the height seems to be missing")) << line;
  }
}

TEST_F(SurveyFilesTest, SteepLinesAreNotDoubtful) {
  for (const std::string line :
       {"400000 300000 12, 400010 300000 12, 400010.1 300000 0, 400020 300000 0",        // a wall at a datum of 0
        "400000 300000 100, 400010 300000 90, 400011 300000 50, 400030 300000 0",        // down to the sea
        "400000 300000 300, 400010 300000 300, 400010.1 300000 340, 400020 300000 340",  // a step
        "400000 300000 1005, 400010 300000 999, 400020 300000 1001, 400030 300000 998"}) {
    std::filesystem::remove(path("lines.gpkg"));
    lines({{"LINESTRING Z (" + line + ")", ""}, {"LINESTRING Z (400000 300050 280, 400030 300050 290)", ""}});
    static_cast<void>(read(sources("", "lines.gpkg")));
    EXPECT_EQ(warnings(), "") << line;
  }
}

TEST_F(SurveyFilesTest, WarnsOfLinesAndPointsAtFillerValues) {
  lines({{"LINESTRING Z (400000 300000 276, 400010 300000 270)", ""},
         {"LINESTRING Z (400000 300010 -999, 400010 300010 -999)", ""}});
  static_cast<void>(read(sources("", "lines.gpkg")));
  EXPECT_EQ(
      warnings(),
      "lines.gpkg: warning: 1 feature lies at the height -999 (the others lie from 270 to 276 m; feature 2 is the "
      "first). If it stands for a missing height, remove them");
  std::filesystem::remove(path("lines.gpkg"));
  lines({{"LINESTRING Z (400000 300000 100, 400010 300000 100)", ""},
         {"LINESTRING Z (400000 300010 99, 400010 300010 99)", ""}});
  static_cast<void>(read(sources("", "lines.gpkg")));
  EXPECT_EQ(warnings(), "") << "contours of 99 and 100 m";
  write("p.csv",
        "x,y,z\n400000,300000,1000\n400100,300000,9999\n400000,300100,1020\n400100,300100,0\n400000,300200,0\n");
  SurveySources from = sources("p.csv");
  from.project_crs = project_crs("EPSG:31287");
  static_cast<void>(read(from));
  EXPECT_EQ(
      warnings(),
      "p.csv: warning: 2 points lie at the height 0 (the others lie from 1000 to 1020 m; the first is at (400100, "
      "300100)). If it stands for a missing height, remove them\n"
      "p.csv: warning: 1 point lies at the height 9999 (the others lie from 1000 to 1020 m; the first is at (400100, "
      "300000)). If it stands for a missing height, remove them");
}

TEST_F(SurveyFilesTest, LinesWithoutHeightsLieOnThePoints) {
  write("p.csv", csv);
  lines({{"LINESTRING (400010 300010, 400090 300010)", ""},
         {"LINESTRING Z (400000 300050 1015, 400010 300050 1015)", ""}});
  const SurveyFiles files = read(sources("p.csv", "lines.gpkg"));
  EXPECT_EQ(files.survey.lines.size(), 1U);
  ASSERT_EQ(files.soft_lines.size(), 1U);
  EXPECT_EQ(files.soft_lines[0].name, "feature 1");
  EXPECT_EQ(without_folder(files.report),
            "p.csv: 4 points\nlines.gpkg: 2 lines of 4 vertices, of layer \"contours\"; 1 without heights, put on the "
            "points");
}

TEST_F(SurveyFilesTest, HintsAtZonesInFrontOfEastings) {
  const auto points = [](const std::string& x, const std::string& y) {
    return "x,y,z\n" + x + "000," + y + "000,1000\n" + x + "100," + y + "000,1010\n" + x + "000," + y + "100,1020\n";
  };
  write("p.csv", points("32652", "5234"));
  static_cast<void>(read(sources("p.csv")));
  EXPECT_EQ(warnings(),
            "p.csv: warning: has no coordinate system (its coordinates are assumed to be in metres). Set crs = "
            "\"EPSG:...\", or crs = \"local\". Its eastings seem to begin with the number of a zone, 32: assign the "
            "coordinate system that has it, such as EPSG:4647, or subtract 32000000");
  SurveySources from = sources("p.csv");
  from.project_crs = project_crs("EPSG:25832");
  EXPECT_EQ(
      refusal(from),
      "p.csv: is nowhere on the earth (its centre (32652050, 5234050) has no position in EPSG:25832). Its eastings "
      "seem to begin with the number of a zone, 32: assign the coordinate system that has it, such as EPSG:4647, or "
      "subtract 32000000");
  from.project_crs = project_crs("EPSG:4647");
  EXPECT_EQ(refusal(from), "was read");
  write("p.csv", points("3652", "5234"));
  static_cast<void>(read(sources("p.csv")));
  EXPECT_THAT(warnings(),
              HasSubstr("begin with the number of a zone, 3: assign the coordinate system that has it, such as "
                        "EPSG:31467, or subtract 3000000"));
  from.project_crs = project_crs("EPSG:25832");
  EXPECT_THAT(refusal(from), HasSubstr("begin with the number of a zone, 3: "));
  for (const auto& [x, y] : {std::pair("1757", "5917"), std::pair("2600", "1200"), std::pair("1842", "5174")}) {
    write("p.csv", points(x, y));
    static_cast<void>(read(sources("p.csv")));
    EXPECT_EQ(warnings().find("zone"), std::string::npos) << "New Zealand, Switzerland, France";
  }
}

TEST_F(SurveyFilesTest, LocalCoordinateSystemsInMetresAreLocal) {
  const std::string metres = "LOCAL_CS[\"Site\",UNIT[\"metre\",1],AXIS[\"E\",EAST],AXIS[\"N\",NORTH]]";
  const std::string feet = "LOCAL_CS[\"Site\",UNIT[\"foot\",0.3048],AXIS[\"E\",EAST],AXIS[\"N\",NORTH]]";
  const std::vector<WrittenFeature> slope{{"LINESTRING Z (0 0 5, 9 0 6)", ""}, {"LINESTRING Z (0 5 5, 9 5 6)", ""}};
  lines(slope, metres);
  for (const ProjectCrs& crs : {ProjectCrs{}, local_crs()}) {
    SurveySources from = sources("", "lines.gpkg");
    from.project_crs = crs;
    EXPECT_EQ(read(from).crs_wkt, "");
    EXPECT_EQ(warnings(), "") << "neither degrees nor without a coordinate system";
  }
  std::filesystem::remove(path("lines.gpkg"));
  lines(slope, feet);
  EXPECT_EQ(
      refusal(sources("", "lines.gpkg")),
      "lines.gpkg: is not in metres on plan (the unit of Site is foot, 0.3048 m). Multiply its coordinates by that "
      "number, and assign the result no coordinate system");
}

TEST_F(SurveyFilesTest, NamesTheKeyThatChoosesTheLayer) {
  lines({{"LINESTRING Z (400000 300000 5, 400100 300000 5)", ""}});
  lines({{"LINESTRING Z (400000 300000 5, 400100 300000 5)", ""}}, "EPSG:31287", "ridges");
  EXPECT_EQ(refusal(sources("", "lines.gpkg")),
            "lines.gpkg: has 2 layers (\"contours\", \"ridges\"). Choose one: lines_layer = \"contours\"");
}

TEST_F(SurveyFilesTest, ReadsDxf) {
  write("lines.dxf",
        "0\nSECTION\n2\nENTITIES\n"
        "0\nPOLYLINE\n8\nridge\n66\n1\n70\n8\n"
        "0\nVERTEX\n8\nridge\n10\n100\n20\n200\n30\n50\n70\n32\n"
        "0\nVERTEX\n8\nridge\n10\n300\n20\n250\n30\n60.5\n70\n32\n"
        "0\nSEQEND\n8\nridge\n"
        "0\nLWPOLYLINE\n8\ncontour\n90\n2\n70\n0\n38\n75\n10\n120\n20\n210\n10\n130\n20\n220\n"
        "0\nTEXT\n8\nlabel\n10\n1\n20\n1\n30\n0\n40\n2\n1\n75\n"
        "0\nENDSEC\n0\nEOF\n");
  SurveySources from = sources("", "lines.dxf");
  from.project_crs.is_local = true;
  const SurveyFiles files = read(from);
  ASSERT_EQ(files.survey.lines.size(), 2U);
  EXPECT_EQ(files.survey.lines[0], (std::vector<Vec3>{{100, 200, 50}, {300, 250, 60.5}}));
  EXPECT_EQ(files.survey.lines[1], (std::vector<Vec3>{{120, 210, 75}, {130, 220, 75}}));
  EXPECT_THAT(warnings(), HasSubstr("1 shapes are left out"));
}

// ---- points ----

TEST_F(SurveyFilesTest, ReadsPointsOfAVectorFile) {
  add_layer(path("spots.gpkg"), "spots", "EPSG:31287", "h",
            {{"POINT (400000 300000)", "1000.5"}, {"MULTIPOINT ((400100 300000), (400100 300100))", "1001"}});
  SurveySources from = sources("spots.gpkg");
  from.elevation_attribute = "h";
  const SurveyFiles files = read(from);
  EXPECT_EQ(files.survey.points,
            (std::vector<Vec3>{{400000, 300000, 1000.5}, {400100, 300000, 1001}, {400100, 300100, 1001}}));
  EXPECT_EQ(without_folder(files.report), "spots.gpkg: 3 points of layer \"spots\"");
}

TEST_F(SurveyFilesTest, ReportsTheClassesOfALasFile) {
  LasSpec spec;
  spec.offset = {400000, 300000, 0};
  spec.points = {{{400000, 300000, 10}, 2}, {{400100, 300000, 10}, 2}, {{400000, 300100, 10}, 2},
                 {{400050, 300050, 25}, 5}, {{400060, 300050, 25}, 7}, {{400070, 300050, 25}, 2, true}};
  spec.geo_keys = {{1024, 1}, {3072, 31287}};
  LasBytes(spec).write(path("p.las"));
  SurveySources from = sources("p.las");
  EXPECT_EQ(without_folder(read(from).report),
            "p.las: 4 of 6 points are used; it has 3 of class 2, 1 of class 5, 1 of class 7 and 1 withheld");
  EXPECT_EQ(warnings(),
            "p.las: warning: has points of other classes than ground (3 of the 4 points used are classified as "
            "ground). To use the ground only, write point_classes = [2]");
  from.point_classes = {2};
  EXPECT_EQ(read(from).survey.points.size(), 3U);
  EXPECT_EQ(warnings(), "");
}

// ---- polygons ----

TEST_F(SurveyFilesTest, ReadsClosedLinesAndPolygons) {
  add_layer(
      path("faces.gpkg"), "faces", "EPSG:31287", "a",
      {{"POLYGON Z ((0 0 1, 10 0 2, 10 10 3, 0 0 1))", ""}, {"LINESTRING Z (0 0 1, 10 10 3, 0 10 3, 0.0005 0 1)", ""}});
  const PolygonFile file = read_polygon_file(path("faces.gpkg"), "", {}, 0.001, warnings_);
  ASSERT_EQ(file.polygons.size(), 2U);
  EXPECT_EQ(file.polygons[0].name, "feature 1");
  EXPECT_EQ(file.polygons[0].rings.front().size(), 3U);
  EXPECT_EQ(file.polygons[1].rings.front(), (std::vector<Vec3>{{0, 0, 1}, {10, 10, 3}, {0, 10, 3}}));
  EXPECT_EQ(name_of_crs(file.crs_wkt), "EPSG:31287");
  EXPECT_EQ(refusal_of([&] { static_cast<void>(read_polygon_file(path("faces.gpkg"), "", {}, 0, warnings_)); }),
            "faces.gpkg: feature 2 is not closed (its ends are 0.0005 m apart). Repeat its first vertex at its end");
}

// On plan, a vertical polygon doubles back on itself.
TEST_F(SurveyFilesTest, PolygonsMayBeVertical) {
  add_layer(path("faces.gpkg"), "faces", "EPSG:31287", "a",
            {{"POLYGON Z ((0 0 1, 10 10 1, 10 10 9, 0 0 9, 0 0 1), (2 2 3, 4 4 3, 4 4 5, 2 2 3))", ""}});
  const PolygonFile file = read_polygon_file(path("faces.gpkg"), "", {}, 0.001, warnings_);
  ASSERT_EQ(file.polygons.size(), 1U);
  ASSERT_EQ(file.polygons[0].rings.size(), 2U);
  EXPECT_EQ(file.polygons[0].rings[1], (std::vector<Vec3>{{2, 2, 3}, {4, 4, 3}, {4, 4, 5}}));
  std::filesystem::remove(path("faces.gpkg"));
  add_layer(path("faces.gpkg"), "faces", "EPSG:31287", "a", {{"POLYGON Z ((0 0 1, 9 9 1, 9 9 9, 0 0 4))", ""}});
  EXPECT_EQ(refusal_of([&] { static_cast<void>(read_polygon_file(path("faces.gpkg"), "", {}, 0.001, warnings_)); }),
            "faces.gpkg: feature 1 is not closed (its ends are 3 apart). Repeat its first vertex at its end");
}

}  // namespace
}  // namespace talus

#endif
