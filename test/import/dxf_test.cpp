// DXF drawings: which entities are read, and what is refused.

#ifdef TALUS_HAS_GDAL

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/dxf.hpp"
#include "support/rasters.hpp"
#include "support/vectors.hpp"
#include "talus/import/dxf_file.hpp"
#include "talus/import/survey_files.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;

const VectorRequest lines{.layer_key = "lines_layer", .kinds = {ShapeKind::line}};

class DxfTest : public RasterFolder {
 protected:
  void make(const std::string& text) const { std::ofstream(path("plan.dxf"), std::ios::binary) << text; }
  void make(const Drawing& drawing) const { make(drawing.text()); }
  [[nodiscard]] VectorLayer read(const VectorRequest& request) {
    warnings_ = Problems{};
    return read_vector_file(path("plan.dxf"), request, warnings_);
  }
  [[nodiscard]] VectorLayer read_layer(const std::string& name) {
    VectorRequest request = lines;
    request.layer = name;
    return read(request);
  }
  [[nodiscard]] std::string refusal(const VectorRequest& request) {
    return refusal_of([&] { static_cast<void>(read(request)); });
  }
};

// ---- layers ----

TEST_F(DxfTest, LeavesOutEntitiesInLayouts) {
  make(Drawing().line("0", "0 0 5", "9 0 6").line("0", "0 0 0", "297 210 0", "67\n1\n").line("0", "0 9 5", "9 9 6"));
  const VectorLayer layer = read(lines);
  EXPECT_EQ(layer.name, "entities");
  EXPECT_EQ(layer.features.size(), 2U);
  EXPECT_EQ(
      warnings(),
      "plan.dxf: warning: 1 of 3 entities is in a layout (that is paper space, not the model; they are left out)");
}

TEST_F(DxfTest, LeavesOutHiddenLayersUnlessRequested) {
  make(Drawing()
           .layer("ground", 0, 7)
           .layer("old", 0, -7)
           .layer("design", 1, 7)
           .line("ground", "0 0 5", "9 0 6")
           .line("old", "0 1 5", "9 1 6")
           .line("design", "0 2 5", "9 2 6")
           .line("old", "0 3 5", "9 3 6"));
  EXPECT_EQ(read(lines).features.size(), 1U);
  EXPECT_EQ(warnings(),
            "plan.dxf: warning: 3 of 4 entities are on a layer that is switched off or frozen (layers left out: "
            "\"design\", \"old\"). To read such a layer, name it: lines_layer = \"design\"");
  EXPECT_EQ(read_layer("old").features.size(), 2U);
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(read_layer("design").features.size(), 1U);
}

TEST_F(DxfTest, ALayerIsChosenByItsName) {
  make(Drawing().line("contours", "0 0 5", "9 0 6").line("frame", "0 1 0", "9 1 0").point("contours", "1 2 3"));
  const VectorLayer layer = read_layer("frame");
  EXPECT_EQ(layer.name, "frame");
  ASSERT_EQ(layer.features.size(), 1U);
  EXPECT_EQ(layer.features[0].parts[0].lists[0].front(), Vec3(0, 1, 0));
  EXPECT_EQ(warnings(), "") << "entities of other layers are not reported";
  EXPECT_EQ(read_layer("entities").features.size(), 2U) << "GDAL's name for all entities";
  VectorRequest request = lines;
  request.layer = "contour";
  EXPECT_EQ(refusal(request),
            "plan.dxf: has no layer \"contour\" (it has \"contours\", \"frame\"). Did you mean \"contours\"?");
}

TEST_F(DxfTest, RefusesDrawingsWithOnlyLayoutsAndHiddenLayers) {
  make(Drawing().layer("old", 0, -7).line("old", "0 0 5", "9 0 6").line("0", "0 0 0", "9 0 0", "67\n1\n"));
  EXPECT_EQ(refusal(lines), "plan.dxf: layer \"entities\" is empty (all entities are in a layout or on hidden layers)");
}

// ---- units ----

TEST_F(DxfTest, RefusesOtherUnitsThanMetres) {
  Drawing drawing;
  drawing.line("0", "0 0 5", "9 0 6");
  for (const int good : {0, 6}) {
    make(Drawing(drawing).unit(good));
    EXPECT_EQ(read(lines).features.size(), 1U) << good;
  }
  const std::string hint =
      "Scale the drawing to metres and set its unit to metres; if its numbers are metres already, only set the unit";
  make(Drawing(drawing).unit(2));
  EXPECT_EQ(refusal(lines), "plan.dxf: is in feet (its header has $INSUNITS = 2; Talus needs metres). " + hint);
  make(Drawing(drawing).unit(4));
  EXPECT_EQ(refusal(polygons),
            "plan.dxf: is in millimetres (its header has $INSUNITS = 4; Talus needs metres). " + hint);
  make(Drawing(drawing).unit(99));
  EXPECT_THAT(refusal(lines), HasSubstr("is in the unit 99 (its header has $INSUNITS = 99"));
}

TEST_F(DxfTest, ReadsTheUnitOnlyFromTheHeader) {
  EXPECT_EQ(unit_of_dxf(path("not there.dxf")), std::nullopt);
  for (const char* text : {"", "0\nSECTION\n2\nHEADER\n9\n$INSUNITS", "no\nnumber\n9\n$INSUNITS\n70\n2\n",
                           "9\n$INSUNITS\n70\nfeet\n", "9\n$INSUNITS\n40\n2\n", "0\nENDSEC\n9\n$INSUNITS\n70\n2\n"}) {
    make(text);
    EXPECT_EQ(unit_of_dxf(path("plan.dxf")), std::nullopt) << text;
  }
  make("  0\r\nSECTION\r\n  2\r\nHEADER\r\n  9\r\n$INSUNITS\r\n 70\r\n     6\r\n");
  EXPECT_EQ(unit_of_dxf(path("plan.dxf")), 6);
}

// ---- kinds ----

TEST_F(DxfTest, LeavesOutOtherKindsIfSomethingIsRead) {
  Drawing drawing;
  drawing.point("0", "1 2 3");
  make(drawing);
  EXPECT_EQ(refusal(lines), "plan.dxf: feature 0 is a point (expected lines)");
  make(drawing.line("0", "0 0 5", "9 0 6"));
  EXPECT_EQ(read(lines).features.size(), 1U);
  EXPECT_EQ(warnings(), "plan.dxf: warning: 1 shapes are left out (only lines are read; feature 0 is a point)");
}

TEST_F(DxfTest, ReadsClosedLinesAsPolygonsOnRequest) {
  make(Drawing().polyline("0", true, {"0 0", "9 0", "9 9"}).polyline("0", false, {"0 0", "5 0"}));
  const VectorLayer layer = read(polygons);
  ASSERT_EQ(layer.features.size(), 1U);
  EXPECT_EQ(layer.features[0].parts[0].kind, ShapeKind::polygon);
  EXPECT_EQ(layer.features[0].parts[0].lists[0], (std::vector<Vec3>{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}}));
  EXPECT_EQ(warnings(), "plan.dxf: warning: 1 shapes are left out (only polygons are read; feature 1 is a line)");
  EXPECT_EQ(read(lines).features[0].parts[0].kind, ShapeKind::line);
  make(Drawing().polyline("0", false, {"0 0", "5 0", "9 9"}));
  EXPECT_EQ(refusal(polygons), "plan.dxf: feature 0 is a line (expected polygons). A closed line is read as a polygon");
  make(Drawing().polyline("0", true, {"0 0", "9 9", "9 0", "0 9"}));
  EXPECT_THAT(refusal(polygons), HasSubstr("plan.dxf: feature 0 is not a valid polygon (self-intersection"));
}

TEST_F(DxfTest, LeavesOutAndReportsEntitiesThatCannotBeRead) {
  const std::string warning =
      "plan.dxf: warning: has entities that GDAL cannot read (the first is the SPLINE that ends at line 66). "
      "They are left out; if they are part of the ground, convert them to polylines";
  Drawing drawing;
  drawing.line("0", "0 0 5", "9 0 6").fitted_spline("0", "0 1 5", "9 1 5");
  make(drawing);
  EXPECT_EQ(read(lines).features.size(), 1U) << "the last entity";
  EXPECT_EQ(warnings(), warning);
  make(drawing.line("0", "0 2 5", "9 2 6"));
  EXPECT_EQ(read(lines).features.size(), 2U);
  EXPECT_EQ(warnings(), warning);
}

TEST_F(DxfTest, NamesAndCountsKindsThatAreNotRead) {
  Drawing drawing;
  drawing.layer("old", 0, -7)
      .line("0", "0 0 5", "9 0 6")
      .other("MESH", "ground", "10\n0\n20\n0\n30\n0\n")
      .other("AECC_TIN_SURFACE", "ground")
      .other("AECC_TIN_SURFACE", "0")
      .other("ACAD_PROXY_ENTITY", "0")
      .other("POLYLINE", "0", "70\n16\n71\n2\n72\n2\n")
      .other("3DSOLID", "old")
      .other("REGION", "0", "67\n1\n")
      .other("VIEWPORT", "0");
  make(drawing);
  EXPECT_EQ(read(lines).features.size(), 1U);
  const std::string hint =
      "). They are left out; if they are part of the ground, convert them to 3D faces or polylines";
  EXPECT_EQ(
      warnings(),
      "plan.dxf: warning: has entities of kinds that are not read (1 ACAD_PROXY_ENTITY, 2 AECC_TIN_SURFACE, 1 MESH, "
      "1 polygon mesh" +
          hint)
      << "not those in a layout or on a hidden layer";
  EXPECT_EQ(read_layer("0").features.size(), 1U);
  EXPECT_EQ(warnings(),
            "plan.dxf: warning: has entities of kinds that are not read (1 ACAD_PROXY_ENTITY, 1 AECC_TIN_SURFACE, 1 "
            "polygon mesh" +
                hint);
  make(Drawing().other("MESH", "ground"));
  EXPECT_EQ(refusal(lines),
            "plan.dxf: layer \"entities\" is empty (it has only entities of kinds that are not read: 1 MESH)");
}

TEST_F(DxfTest, CountsKindsThatAreNotReadInBlocks) {
  make(Drawing()
           .block("BODY", Drawing().other("3DSOLID", "0").other("MESH", "terrain"))
           .block("NESTED", Drawing().other("INSERT", "0", "2\nBODY\n").other("INSERT", "0", "2\nNESTED\n"))
           .block("UNUSED", Drawing().other("REGION", "0"))
           .line("0", "0 0 5", "9 0 6")
           .other("INSERT", "ground", "2\nNESTED\n10\n0\n20\n0\n"));
  const DxfContents contents = contents_of_dxf(path("plan.dxf"));
  ASSERT_EQ(contents.unread.size(), 2U);
  EXPECT_EQ(contents.unread.at({"ground", "3DSOLID"}).count, 1U) << "on the layer of the INSERT";
  EXPECT_EQ(contents.unread.at({"terrain", "MESH"}).count, 1U);
}

TEST_F(DxfTest, RefusesCurvesWithHeights) {
  VectorRequest heights = lines;
  heights.heights_are_used = true;
  const std::string why = "; GDAL reads such curves without their heights). Convert them to 3D polylines";
  Drawing drawing;
  drawing.spline("CONT", {"0 0 100", "10 0 90", "30 0 80", "60 0 75"});
  make(drawing);
  EXPECT_EQ(refusal(heights),
            "plan.dxf: has 1 SPLINE with heights on layer \"CONT\" (the first begins at line 25" + why);
  make(drawing.spline("CONT", {"0 9 100", "10 9 100", "30 9 100", "60 9 100"}));
  EXPECT_EQ(refusal(heights),
            "plan.dxf: has 2 SPLINEs with heights on layer \"CONT\" (the first begins at line 25" + why);
  EXPECT_EQ(read(lines).features.size(), 2U) << "only the plan is used";
  heights.layer = "ground";
  make(drawing.line("ground", "0 0 5", "9 0 6"));
  EXPECT_EQ(read(heights).features.size(), 1U) << "another layer";
  make(Drawing().block("CURVE", drawing).other("INSERT", "0", "2\nCURVE\n10\n0\n20\n0\n"));
  EXPECT_THAT(refusal(VectorRequest{.kinds = {ShapeKind::line}, .heights_are_used = true}),
              HasSubstr("has 2 SPLINEs with heights on layer \"CONT\""));
}

TEST_F(DxfTest, LeavesOutTextsBesidePoints) {
  const VectorRequest points{.kinds = {ShapeKind::point}};
  Drawing drawing;
  drawing.label("label", "0.7 0.7 0", "12.5").label("label", "9.7 0.7 0", "13.5");
  make(drawing);
  EXPECT_EQ(read(points).features.size(), 2U) << "labels alone may be the points";
  EXPECT_EQ(warnings(), "");
  make(drawing.point("spot", "0 0 12.5").point("spot", "9 0 13.5").point("spot", "9 9 14.5"));
  const VectorLayer layer = read(points);
  ASSERT_EQ(layer.features.size(), 3U);
  EXPECT_EQ(layer.features[0].parts[0].lists[0][0], Vec3(0, 0, 12.5));
  EXPECT_EQ(warnings(),
            "plan.dxf: warning: 2 of 5 entities are texts (their places are those of labels; they are left out)");
  const VectorLayer with_words = read({.attributes = {"Text"}, .kinds = {ShapeKind::point}});
  EXPECT_EQ(with_words.features.size(), 5U) << "their words are wanted";
}

TEST_F(DxfTest, RefusesFilesThatAreCutShort) {
  const std::string text = Drawing().line("0", "0 0 5", "9 0 6").fitted_spline("0", "0 1 5", "9 1 5").text();
  make(text.substr(0, text.find("SPLINE") + 20));
  EXPECT_THAT(refusal(lines), HasSubstr("plan.dxf: cannot be read completely (after 1 features of layer \"entities\""));
}

// ---- in space ----

TEST_F(DxfTest, FacesMayBeVertical) {
  make(Drawing().face("0", {"0 0 0", "9 0 0", "9 0 5", "0 0 5"}).face("0", {"0 0 0", "9 0 0", "9 9 0"}));
  const PolygonFile file = read_polygon_file(path("plan.dxf"), "", local_crs(), 0.001, warnings_);
  ASSERT_EQ(file.polygons.size(), 2U);
  EXPECT_EQ(file.polygons[0].rings[0], (std::vector<Vec3>{{0, 0, 0}, {9, 0, 0}, {9, 0, 5}, {0, 0, 5}}));
  EXPECT_EQ(file.polygons[1].rings[0].size(), 3U);
}

TEST_F(DxfTest, ReadsPolyfaceMeshesFaceByFace) {
  make(Drawing().polyface("0", {"0 0 0", "9 0 0", "9 9 5"}).face("0", {"0 0 0", "9 0 0", "9 9 0"}));
  const PolygonFile file = read_polygon_file(path("plan.dxf"), "", local_crs(), 0.001, warnings_);
  ASSERT_EQ(file.polygons.size(), 2U);
  EXPECT_EQ(file.polygons[0].rings[0], (std::vector<Vec3>{{0, 0, 0}, {9, 0, 0}, {9, 9, 5}}));
}

TEST_F(DxfTest, WarnsOfFeaturesAtZeroFarBelowTheOthers) {
  Drawing drawing;
  drawing.line("ground", "0 0 105", "90 0 106")
      .line("frame", "-5 -5 0", "95 -5 0")
      .line("ground", "0 9 105", "90 9 99");
  make(drawing);
  SurveySources sources;
  sources.lines = path("plan.dxf");
  sources.project_crs.is_local = true;
  static_cast<void>(read_survey(sources, warnings_));
  EXPECT_EQ(
      warnings(),
      "plan.dxf: warning: 1 feature lies at the height 0 (the others lie from 99 to 106 m; feature 1 is the first). "
      "To leave out a frame or plan next to the ground, name the ground's layer: lines_layer = \"...\"");
  warnings_ = Problems{};
  make(drawing.line("ground", "0 18 2", "90 18 -1"));
  static_cast<void>(read_survey(sources, warnings_));
  EXPECT_EQ(warnings(), "") << "other features are at sea level, too";
}

}  // namespace
}  // namespace talus

#endif
