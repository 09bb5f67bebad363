#include "talus/import/section_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/dxf.hpp"
#ifdef TALUS_HAS_GDAL
#include "support/rasters.hpp"
#include "support/vectors.hpp"
#endif
#include "support/input_folder.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Place = std::array<double, 2>;

class SectionFile : public InputFolder {
 protected:
  [[nodiscard]] std::vector<Place> read(const std::string& name, const std::string& layer = "", double tolerance = 0) {
    return read_section_file({path(name), layer, tolerance}, warnings_);
  }
  [[nodiscard]] std::vector<Place> read_text(const std::string& text, double tolerance = 0) {
    write("profile.csv", text);
    return read("profile.csv", "", tolerance);
  }
  [[nodiscard]] std::string refusal(const std::string& name, const std::string& layer = "") {
    return refusal_of([&] { static_cast<void>(read(name, layer)); });
  }
  [[nodiscard]] std::string refusal_of_text(const std::string& text) {
    return refusal_of([&] { static_cast<void>(read_text(text)); });
  }
};

TEST_F(SectionFile, TextHasDistanceAndHeight) {
  const auto slope = ElementsAre(Place{0, 10}, Place{5.5, 2}, Place{9, 0});
  EXPECT_THAT(read_text("distance_m,z_m\n0,10\n5.5,2\n9,0\n"), slope);
  EXPECT_THAT(read_text("0,10\n5.5,2\n9,0\n"), slope);
  EXPECT_THAT(read_text("x;z\n0;10\n5,5;2\n9;0\n"), slope);
  EXPECT_THAT(read_text("name\televation\tchainage\na\t10\t0\nb\t2\t5.5\nc\t0\t9\n"), slope);
  // Where the distance is given, coordinates on plan do not matter.
  EXPECT_THAT(read_text("distance_m,z_m,x_m,y_m\n0,10,100,200\n5.5,2,101,200\n9,0,102,200\n"), slope);
}

TEST_F(SectionFile, PointsInSpaceGiveTheSectionAlongThem) {
  EXPECT_THAT(read_text("x,y,z\n100,200,10\n103,204,7\n103,209,7.5\n"),
              ElementsAre(Place{0, 10}, Place{5, 7}, Place{10, 7.5}));
  EXPECT_THAT(read_text("100 200 10\n103 204 7\n103 209 7.5\n"),
              ElementsAre(Place{0, 10}, Place{5, 7}, Place{10, 7.5}));
}

TEST_F(SectionFile, LeavesOutRepeatedVerticesAndThoseWithinTheTolerance) {
  const std::string text = "x,z\n0,10\n0,10\n1,9.01\n2,8\n3,8.2\n4,8\n";
  EXPECT_EQ(read_text(text).size(), 5U);
  EXPECT_THAT(read_text(text, 0.1), ElementsAre(Place{0, 10}, Place{2, 8}, Place{3, 8.2}, Place{4, 8}));
  EXPECT_THAT(read_text(text, 0.3), ElementsAre(Place{0, 10}, Place{2, 8}, Place{4, 8}));
}

TEST_F(SectionFile, KeepsTheOrderOfTheFile) {
  EXPECT_THAT(read_text("x,z\n9,0\n5,2\n0,10\n"), ElementsAre(Place{9, 0}, Place{5, 2}, Place{0, 10}));
}

TEST_F(SectionFile, RefusesTextThatIsNoSection) {
  EXPECT_THAT(refusal_of_text("x,z\n0,10\n1,high\n"), HasSubstr("profile.csv:3: \"high\" is not a number"));
  EXPECT_THAT(refusal_of_text("x_ft,z_ft\n0,10\n"), HasSubstr("is in feet"));
  EXPECT_THAT(refusal_of_text("x,y\n0,10\n"), HasSubstr("no column is named z"));
  EXPECT_THAT(refusal_of_text("x,z\n0,10\n1\n"), HasSubstr("has 1 of 2 columns"));
  EXPECT_THAT(refusal_of_text("x,z\n"), HasSubstr("has no points"));
  EXPECT_THAT(refusal_of_text("x,z\n0,nan\n"), HasSubstr("is not a number"));
  EXPECT_THAT(refusal("profile.csv", "slope"), HasSubstr("has no layers"));
  EXPECT_THAT(refusal("nothing.csv"), HasSubstr("cannot be read"));
}

#ifdef TALUS_HAS_GDAL

TEST_F(SectionFile, ADrawnLineIsASection) {
  write("slope.dxf", Drawing().unit(6).polyline("GROUND", false, {"0 30", "10 12", "40 5"}).text());
  EXPECT_THAT(read("slope.dxf"), ElementsAre(Place{0, 30}, Place{10, 12}, Place{40, 5}));
}

TEST_F(SectionFile, ACurveWithHeightsIsRefused) {
  Drawing drawing;
  drawing.unit(6).spline("CONT", {"0 0 100", "10 0 90", "30 0 80", "60 0 75"});
  write("slope.dxf", drawing.text());
  EXPECT_EQ(
      refusal("slope.dxf"),
      "slope.dxf: has 1 SPLINE with heights on layer \"CONT\" (the first begins at line 29; GDAL reads such curves "
      "without their heights). Convert them to 3D polylines");
}

TEST_F(SectionFile, ADrawnCurveIsASection) {
  for (const char* z : {"0", "7"}) {  // drawn on plan, at any height
    const std::string at = std::string(" ") + z;
    const std::string a = "0 30" + at, b = "10 20" + at, c = "30 10" + at, d = "60 5" + at;
    Drawing drawing;
    drawing.unit(6).spline("CONT", {a.c_str(), b.c_str(), c.c_str(), d.c_str()});
    write("slope.dxf", drawing.text());
    const auto section = read("slope.dxf");
    EXPECT_EQ(section.front(), (Place{0, 30}));
    EXPECT_NEAR(section.back()[0], 60, 1e-9);
    EXPECT_NEAR(section.back()[1], 5, 1e-9);
  }
}

TEST_F(SectionFile, ADrawingInAnotherUnitIsRefused) {
  write("slope.dxf", Drawing().unit(2).polyline("GROUND", false, {"0 30", "10 12"}).text());
  EXPECT_THAT(refusal("slope.dxf"), HasSubstr("feet"));
}

TEST_F(SectionFile, OneOfSeveralLinesIsChosenByItsLayer) {
  Drawing drawing;
  drawing.unit(6).polyline("GROUND", false, {"0 30", "10 12"}).polyline("ROCK", false, {"0 25", "10 8"});
  write("slope.dxf", drawing.text());
  EXPECT_THAT(refusal("slope.dxf"), HasSubstr("has 2 lines (a section is one line)"));
  EXPECT_THAT(read("slope.dxf", "ROCK"), ElementsAre(Place{0, 25}, Place{10, 8}));
}

TEST_F(SectionFile, ALineInSpaceGivesTheSectionAlongItself) {
  add_layer(path("line.gpkg"), "line", "EPSG:31287", "name",
            {{"LINESTRING Z (400000 300000 50, 400030 300040 20, 400030 300100 21)", ""}});
  EXPECT_THAT(read("line.gpkg"), ElementsAre(Place{0, 50}, Place{50, 20}, Place{110, 21}));
}

TEST_F(SectionFile, ALineOnPlanIsRefused) {
  add_layer(path("line.gpkg"), "line", "EPSG:31287", "name", {{"LINESTRING (400000 300000, 400030 300040)", ""}});
  EXPECT_THAT(refusal("line.gpkg"), HasSubstr("has a line without heights"));
}

#endif

}  // namespace
}  // namespace talus
