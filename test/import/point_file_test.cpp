#include "talus/import/point_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "talus/core/problems.hpp"

namespace talus {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PointFileTest : public ::testing::Test {
 protected:
  PointFileTest() {
    const auto* const info = ::testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path{::testing::TempDir()} /
            ("talus_points_" + std::string{info->name()} + "_" + std::to_string(::getpid()) + ".csv");
  }
  ~PointFileTest() override {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }

  [[nodiscard]] std::vector<Vec3> read(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return read_point_file(file_);
  }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    try {
      static_cast<void>(read(text));
    } catch (const BadInput& bad) {
      std::string said = bad.what();
      for (auto at = said.find(file_.string()); at != std::string::npos; at = said.find(file_.string())) {
        said.replace(at, file_.string().size(), "p.csv");
      }
      return said;
    }
    return "was read";
  }

  std::filesystem::path file_;
};

const std::vector<Vec3> three{{1.5, 2, 3}, {4, 5, -6.25}, {7e3, 8, 9}};

TEST_F(PointFileTest, NumbersBetweenAnySeparator) {
  EXPECT_EQ(read("1.5,2,3\n4,5,-6.25\n7e3,8,9\n"), three);
  EXPECT_EQ(read("1.5 2 3\n  4   5 -6.25  \n7e3 8 9"), three);
  EXPECT_EQ(read("1.5\t2\t3\n4\t5\t-6.25\n7e3\t8\t9\n"), three);
  EXPECT_EQ(read("1.5;2;3\r\n4;5;-6.25\r\n7e3;8;9\r\n"), three);
  EXPECT_EQ(read(" 1.5 , 2 , 3 \n \"4\" , +5 , -6.25\n7e3, 8, 9 \n"), three);
}

TEST_F(PointFileTest, ACommaIsADecimalPointBetweenSemicolonsAndTabs) {
  EXPECT_EQ(read("x;y;z\n1,5;2;3\n4;5;-6,25\n7e3;8;9\n"), three);
  EXPECT_EQ(read("1,5\t2,0\t3\n4\t5\t-6,25\n7e3\t8\t9,0\n"), three);
}

TEST_F(PointFileTest, AFirstLineNamesTheColumns) {
  EXPECT_EQ(read("id,northing,easting,code,elevation\na,2,1.5,x,3\nb,5,4,y,-6.25\nc,8,7e3,z,9\n"), three);
  EXPECT_EQ(read("\"X\" \"Y\" \"Z\"\n1.5 2 3\n4 5 -6.25\n7e3 8 9\n"), three);
  EXPECT_EQ(read("Rechtswert;Hochwert;H\n1,5;2;3\n4;5;-6,25\n7e3;8;9\n"), three);
  EXPECT_EQ(read("X_m,Y_m,Height (m)\n1.5,2,3\n4,5,-6.25\n7e3,8,9\n"), three);
  EXPECT_EQ(read("\xEF\xBB\xBFx,y,z\n1.5,2,3\n4,5,-6.25\n7e3,8,9\n"), three);
  EXPECT_EQ(read("//X Y Z Intensity\n1.5 2 3 0\n4 5 -6.25 1\n7e3 8 9 7\n"), three);
  EXPECT_EQ(read("# y, x, z\n2,1.5,3\n5,4,-6.25\n8,7e3,9\n"), three);
}

TEST_F(PointFileTest, CommentsAndEmptyLinesArePassedOver) {
  EXPECT_EQ(read("# by hand, of Monday\n\n1.5,2,3\n\n// a rest\n4,5,-6.25\n# x,y,z\n7e3,8,9\n\n"), three);
}

TEST_F(PointFileTest, AFirstLineMayCountThePoints) {
  EXPECT_EQ(read("3\n1.5 2 3\n4 5 -6.25\n7e3 8 9\n"), three);
  EXPECT_EQ(read("\xEF\xBB\xBF 3\r\n1.5 2 3 -812 90 91 92\r\n4 5 -6.25 1 2 3 4\r\n7e3 8 9 1 2 3 4\r\n"), three);
  EXPECT_EQ(
      refusal("4\n1.5 2 3\n4 5 -6.25\n7e3 8 9\n"),
      "p.csv: has 3 points (its first line says 4). Copy it again from where it comes from, or take that line out");
  EXPECT_THAT(refusal("1.5 2 3\n3\n4 5 6\n"), HasSubstr("p.csv:2: has 1 of 3 columns"));
}

TEST_F(PointFileTest, FurtherColumnsAreLeftAlone) {
  EXPECT_EQ(read("1.5 2 3 255 0 0\n4 5 -6.25 0 255 0\n7e3 8 9 0 0 255\n"), three);
}

TEST_F(PointFileTest, ValuesThatBelongToNoColumnAreRefused) {
  EXPECT_EQ(refusal("x,y,z\n100,956,100,948,100,057\n1,2,3\n1,2,3,red\n"),
            "p.csv:2: has 6 columns (line 1 names 3). If its commas stand for decimal points, write points, or put ; "
            "between the columns\n"
            "p.csv:4: has 4 columns (line 1 names 3). Name all columns in the first line");
  EXPECT_EQ(refusal("1 2 3\n4 5 6 7\n"), "p.csv:2: has 4 columns (line 1 has 3). Name all columns in the first line");
  EXPECT_EQ(read("x,y,z,\n1.5,2,3\n4,5,-6.25,\n7e3,8,9\n"), three);
  EXPECT_EQ(read("x,y,z\n1.5,2,3,\n4,5,-6.25\n7e3,8,9\n"), three);
  EXPECT_EQ(read("\"1.5\",\"2\",\"3\"\n\"4\",\"5\",\"-6.25\"\n\"7e3\",\"8\",\"9\"\n"), three);
  EXPECT_EQ(read("x,y,z,what\n1.5,2,3,\"a, b, c\"\n4,5,-6.25,\n7e3,8,9,d\n"), three);
}

TEST_F(PointFileTest, DecimalCommasBetweenCommasAreRefused) {
  const std::string refused =
      "p.csv: seems to have decimal commas (its lines have six and more whole numbers between commas, and none that "
      "names the columns). Write decimal points, or put ; between the columns; if they are whole numbers, name them in "
      "the first line, for example: x,y,z,red,green,blue";
  EXPECT_EQ(refusal("100,956,100,948,100,057\n100,085,110,835,100,736\n100,085,110,100,736\n"), refused);
  EXPECT_EQ(read("x,y,z,red,green,blue\n1,2,3,4,5,6\n").size(), 1U);
  EXPECT_EQ(read("1,2,3,4,5,6\n1.5,2,3,4,5,6\n").size(), 2U);
}

TEST_F(PointFileTest, BadLinesAreToldOfByTheirNumbers) {
  EXPECT_EQ(
      refusal("x,y,z\n1,2,3\n1,two,3\n4,5\n6,7,nan\n8,9,-9999\n"),
      "p.csv:3: \"two\" is not a number (expected y in metres)\n"
      "p.csv:4: has 2 of 3 columns (a point has a height)\n"
      "p.csv:5: \"nan\" is not a number (expected z in metres)\n"
      "p.csv:6: z is -9999 (heights lie between -9000 and 100000 m). If it stands for no data, leave the line out");
}

TEST_F(PointFileTest, AfterTenBadLinesTheOthersAreCounted) {
  std::string text = "x,y,z\n";
  for (int k = 0; k < 25; ++k) text += "1,2,?\n";
  const std::string said = refusal(text);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 10);
  EXPECT_THAT(said, HasSubstr("p.csv:11: \"?\" is not a number"));
  EXPECT_THAT(said, HasSubstr("p.csv: 15 more lines are like this"));
}

TEST_F(PointFileTest, RefusesColumnsThatAreNotMetres) {
  EXPECT_EQ(
      refusal("x,y,z_ft\n1,2,3\n"),
      "p.csv:1: column \"z_ft\" is in feet (Talus needs metres on plan and in height). Convert it to metres: a foot "
      "is 0.3048 m, a US survey foot 1200/3937 m");
  EXPECT_EQ(refusal("id,lat,lon,z\n1,2,3,4\n"),
            "p.csv:1: column \"lat\" is in degrees (Talus needs metres on plan). Project the points, for example with "
            "gdaltransform -s_srs EPSG:4326 -t_srs EPSG:XXXX");
}

TEST_F(PointFileTest, RefusesColumnsThatNobodyCanTellApart) {
  EXPECT_EQ(
      refusal("x,y\n1,2\n"),
      "p.csv:1: no column is called z (there are \"x\", \"y\"). Columns are called x, y and z, or easting, northing "
      "and elevation");
  EXPECT_EQ(
      refusal("x,y,z,height\n1,2,3,4\n"),
      "p.csv:1: columns \"z\" and \"height\" mean the same (there is one x, one y and one z). Rename the one that is "
      "not meant");
  EXPECT_EQ(
      refusal("1 2.5 3.5 4\n2 3.5 4.5 5\n3 1 1 1\n"),
      "p.csv: seems to count its points in the first column (it has no line that names the columns, and the first "
      "number grows by 1 from line to line). Name them in the first line, for example: id x y z");
  EXPECT_EQ(read("x y z i\n1 2.5 3.5 4\n2 3.5 4.5 5\n3 1 1 1\n").size(), 3U);
}

TEST_F(PointFileTest, RefusesWhatHoldsNoPoints) {
  EXPECT_EQ(refusal(""), "p.csv: has no points (no line has three numbers)");
  EXPECT_EQ(refusal("x,y,z\n"), "p.csv: has no points (no line has three numbers)");
  EXPECT_EQ(refusal("1,2\n3,4\n"),
            "p.csv:1: has 2 of 3 columns (a point has a height)\n"
            "p.csv:2: has 2 of 3 columns (a point has a height)");
  EXPECT_EQ(refusal("1\n"), "p.csv: has no points (its first line is a count, and none follows)");
  EXPECT_EQ(refusal(std::string(200'000, '7')),
            "p.csv: is not a text file of points (line 1 has more than 100000 bytes)");
  EXPECT_THROW(static_cast<void>(read_point_file("/nowhere/p.csv")), BadInput);
  EXPECT_THROW(static_cast<void>(read_point_file("/")), BadInput);
}

TEST_F(PointFileTest, CoordinatesThatNoMapHasAreRefused) {
  EXPECT_EQ(refusal("x,y,z\n0,0,1\n1e300,0,1\n0,-2e9,1\n"),
            "p.csv:3: x is 1e+300 (coordinates lie within 1e+09 m)\n"
            "p.csv:4: y is -2000000000 (coordinates lie within 1e+09 m)");
}

}  // namespace
}  // namespace talus
