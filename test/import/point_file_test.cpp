#include "talus/import/point_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "support/input_folder.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;

class PointFileTest : public InputFolder {
 protected:
  [[nodiscard]] std::vector<Vec3> read(const std::string& text) const {
    write("p.csv", text);
    return read_point_file(path("p.csv"));
  }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    return refusal_of([&] { static_cast<void>(read(text)); });
  }
};

const std::vector<Vec3> three{{1.5, 2, 3}, {4, 5, -6.25}, {7e3, 8, 9}};

TEST_F(PointFileTest, ReadsNumbersWithAnySeparator) {
  EXPECT_EQ(read("1.5,2,3\n4,5,-6.25\n7e3,8,9\n"), three);
  EXPECT_EQ(read("1.5 2 3\n  4   5 -6.25  \n7e3 8 9"), three);
  EXPECT_EQ(read("1.5\t2\t3\n4\t5\t-6.25\n7e3\t8\t9\n"), three);
  EXPECT_EQ(read("1.5;2;3\r\n4;5;-6.25\r\n7e3;8;9\r\n"), three);
  EXPECT_EQ(read(" 1.5 , 2 , 3 \n \"4\" , +5 , -6.25\n7e3, 8, 9 \n"), three);
}

TEST_F(PointFileTest, ReadsDecimalCommasWithSemicolonsAndTabs) {
  EXPECT_EQ(read("x;y;z\n1,5;2;3\n4;5;-6,25\n7e3;8;9\n"), three);
  EXPECT_EQ(read("1,5\t2,0\t3\n4\t5\t-6,25\n7e3\t8\t9,0\n"), three);
}

TEST_F(PointFileTest, AFirstLineMayNameTheColumns) {
  EXPECT_EQ(read("id,northing,easting,code,elevation\na,2,1.5,x,3\nb,5,4,y,-6.25\nc,8,7e3,z,9\n"), three);
  EXPECT_EQ(read("\"X\" \"Y\" \"Z\"\n1.5 2 3\n4 5 -6.25\n7e3 8 9\n"), three);
  EXPECT_EQ(read("Rechtswert;Hochwert;H\n1,5;2;3\n4;5;-6,25\n7e3;8;9\n"), three);
  EXPECT_EQ(read("X_m,Y_m,Height (m)\n1.5,2,3\n4,5,-6.25\n7e3,8,9\n"), three);
  EXPECT_EQ(read("\xEF\xBB\xBFx,y,z\n1.5,2,3\n4,5,-6.25\n7e3,8,9\n"), three);
  EXPECT_EQ(read("//X Y Z Intensity\n1.5 2 3 0\n4 5 -6.25 1\n7e3 8 9 7\n"), three);
  EXPECT_EQ(read("# y, x, z\n2,1.5,3\n5,4,-6.25\n8,7e3,9\n"), three);
}

TEST_F(PointFileTest, NamesOfColumnsMayHaveUmlauts) {
  EXPECT_EQ(read("Rechtswert;Hochwert;Höhe\n1,5;2;3\n4;5;-6,25\n7e3;8;9\n"), three);
  EXPECT_EQ(read("RECHTSWERT;HOCHWERT;HÖHE [m]\n1,5;2;3\n4;5;-6,25\n7e3;8;9\n"), three);
  EXPECT_EQ(read("x;y;H\xF6he\n1,5;2;3\n4;5;-6,25\n7e3;8;9\n"), three) << "Latin-1";
  const std::string refused =
      "p.csv:1: no column is named z (the columns are \"x\", \"y\", \"Größe\"). Name the columns x, y and z, or "
      "easting, "
      "northing and elevation";
  EXPECT_EQ(refusal("x,y,Größe\n1,2,3\n"), refused);
  EXPECT_EQ(refusal("x,y,Gr\xF6\xDF"
                    "e\n1,2,3\n"),
            refused)
      << "Latin-1";
}

TEST_F(PointFileTest, RefusesSeparatorsOfThousands) {
  const auto message = [](const std::string& first, const std::string& whole, const std::string& plain) {
    return first + "\" seems to be " + whole + " (other numbers of the column, such as " + plain +
           ", have no comma: commas seem to separate thousands). Write numbers without separators of thousands";
  };
  EXPECT_EQ(refusal("x\ty\tz\n0\t0\t998\n0\t10\t1,004\n10\t0\t989\n"), "p.csv:3: \"" + message("1,004", "1004", "998"));
  EXPECT_EQ(refusal("0;0;12,500\n0;10;-1,250\n10;0;750\n"), "p.csv:1: \"" + message("12,500", "12500", "750"));
  EXPECT_EQ(refusal("x;y;z\n0;950;10\n0;1,000;10\n10;0;10\n"), "p.csv:3: \"" + message("1,000", "1000", "950"));
  EXPECT_EQ(
      refusal("x;y;z\n0;0;1.004\n0;10;998\n10;0;989\n"),
      "p.csv:2: \"1.004\" seems to be 1004 (other numbers of the column, such as 998, have no point: points seem to "
      "separate thousands). Write numbers without separators of thousands");
}

TEST_F(PointFileTest, ThreeDecimalsAreNoThousands) {
  EXPECT_EQ(read("0;0;100,125\n0;10;99,875\n10;0;100\n").size(), 3U);
  EXPECT_EQ(read("0;0;1,004\n0;10;1,5\n10;0;998\n").size(), 3U) << "another number of decimals";
  EXPECT_EQ(read("0;0;0,950\n0;10;1,004\n10;0;998\n").size(), 3U) << "thousands do not begin with 0";
  EXPECT_EQ(read("0;0;1,004\n0;10;2,500\n10;0;1,750\n").size(), 3U) << "all alike";
  EXPECT_EQ(read("x,y,z\n0,0,1.004\n0,10,998\n10,0,989\n").size(), 3U) << "commas separate the columns";
}

TEST_F(PointFileTest, RefusesDecimalCommasSeparatedByBlanks) {
  const std::string why =
      "seems to have decimal commas (its numbers have commas, and blanks separate its columns). Write decimal points, "
      "or "
      "separate the columns by semicolons";
  EXPECT_EQ(refusal("X Y Z\n2000,00 5000,00 300,00\n"), "p.csv:2: " + why);
  EXPECT_EQ(refusal("2000,00   5000,00  300\n"), "p.csv:1: " + why);
  EXPECT_EQ(refusal("# survey\n17 -2000,5 5000,25 300,125 rock\n"), "p.csv:2: " + why);
  EXPECT_EQ(read("1.5, 2, 3\n4, 5, -6.25\n7e3 ,8 ,9\n"), three);
}

TEST_F(PointFileTest, RefusesNumberedPointsWithGaps) {
  const auto why = [](const std::string& number) {
    return "p.csv: seems to number its points in the first column (no line names the columns, and the first number " +
           number + "). Name the columns in the first line, for example: id x y z";
  };
  EXPECT_EQ(refusal("103,5000.00,2000.00,300.00,GND\n104,5010.00,2000.00,300.00,GND\n107,5020.00,2000.00,301.00,GND\n"),
            why("is whole, and different in each line"));
  EXPECT_EQ(refusal("7 5000.1 2000.2 300.3\n3 5010.1 2000.2 300.3\n12 5020.1 2000.2 300.3\n"),
            why("is whole, and different in each line"));
  std::string whole;
  for (int k = 0; k < 12; ++k) whole += std::to_string(100 + 10 * k) + " " + std::to_string(5000 - k) + " 2000 300\n";
  EXPECT_EQ(refusal(whole), why("is whole and increases from line to line"));
}

TEST_F(PointFileTest, WholeCoordinatesAreNoNumbers) {
  EXPECT_EQ(read("10 0.5 300.25 1\n10 9.5 301.25 1\n20 0.5 299.75 1\n").size(), 3U) << "two with the same x";
  EXPECT_EQ(read("12 40 300.25 1\n17 31 301.25 1\n11 55 299.75 1\n").size(), 3U) << "whole on plan";
  EXPECT_EQ(read("12.0 40.5 300.25 1\n17.0 31.5 301.25 1\n11.0 55.5 299.75 1\n").size(), 3U) << "with a point";
  EXPECT_EQ(read("12 40.5 300.25\n17 31.5 301.25\n11 55.5 299.75\n").size(), 3U) << "three columns";
}

TEST_F(PointFileTest, SkipsCommentsAndEmptyLines) {
  EXPECT_EQ(read("# measured on Monday\n\n1.5,2,3\n\n// a break\n4,5,-6.25\n# x,y,z\n7e3,8,9\n\n"), three);
}

TEST_F(PointFileTest, AFirstLineMayBeTheNumberOfPoints) {
  EXPECT_EQ(read("3\n1.5 2 3\n4 5 -6.25\n7e3 8 9\n"), three);
  EXPECT_EQ(read("\xEF\xBB\xBF 3\r\n1.5 2 3 -812 90 91 92\r\n4 5 -6.25 1 2 3 4\r\n7e3 8 9 1 2 3 4\r\n"), three);
  EXPECT_EQ(refusal("4\n1.5 2 3\n4 5 -6.25\n7e3 8 9\n"),
            "p.csv: has 3 points (its first line declares 4). Copy it again from its source, or remove that line");
  EXPECT_THAT(refusal("1.5 2 3\n3\n4 5 6\n"), HasSubstr("p.csv:2: has 1 of 3 columns"));
}

TEST_F(PointFileTest, IgnoresFurtherColumns) {
  EXPECT_EQ(read("1.5 2 3 255 0 0\n4 5 -6.25 0 255 0\n7e3 8 9 0 0 255\n"), three);
}

TEST_F(PointFileTest, RefusesLinesWithSurplusValues) {
  EXPECT_EQ(refusal("x,y,z\n100,956,100,948,100,057\n1,2,3\n1,2,3,red\n"),
            "p.csv:2: has 6 columns (line 1 names 3). If its commas are decimal commas, write points, or separate the "
            "columns by semicolons\n"
            "p.csv:4: has 4 columns (line 1 names 3). Name all columns in the first line");
  EXPECT_EQ(refusal("1 2 3\n4 5 6 7\n"), "p.csv:2: has 4 columns (line 1 has 3). Name all columns in the first line");
  EXPECT_EQ(read("x,y,z,\n1.5,2,3\n4,5,-6.25,\n7e3,8,9\n"), three);
  EXPECT_EQ(read("x,y,z\n1.5,2,3,\n4,5,-6.25\n7e3,8,9\n"), three);
  EXPECT_EQ(read("\"1.5\",\"2\",\"3\"\n\"4\",\"5\",\"-6.25\"\n\"7e3\",\"8\",\"9\"\n"), three);
  EXPECT_EQ(read("x,y,z,what\n1.5,2,3,\"a, b, c\"\n4,5,-6.25,\n7e3,8,9,d\n"), three);
}

TEST_F(PointFileTest, RefusesDecimalCommasSeparatedByCommas) {
  const std::string refused =
      "p.csv: seems to have decimal commas (its lines have six or more integers between commas, and no line names the "
      "columns). Write decimal points, or separate the columns by semicolons; if they are integers, name the columns "
      "in the first line, for example: x,y,z,red,green,blue";
  EXPECT_EQ(refusal("100,956,100,948,100,057\n100,085,110,835,100,736\n100,085,110,100,736\n"), refused);
  EXPECT_EQ(read("x,y,z,red,green,blue\n1,2,3,4,5,6\n").size(), 1U);
  EXPECT_EQ(read("1,2,3,4,5,6\n1.5,2,3,4,5,6\n").size(), 2U);
}

TEST_F(PointFileTest, ReportsBadLinesByTheirNumbers) {
  EXPECT_EQ(refusal("x,y,z\n1,2,3\n1,two,3\n4,5\n6,7,nan\n8,9,-9999\n"),
            "p.csv:3: \"two\" is not a number (expected y in metres)\n"
            "p.csv:4: has 2 of 3 columns (a point needs a height)\n"
            "p.csv:5: \"nan\" is not a number (expected z in metres)\n"
            "p.csv:6: z is -9999 (heights must be between -9000 and 100000 m). If it means no data, remove the line");
}

TEST_F(PointFileTest, ReportsTenBadLinesAndCountsTheOthers) {
  std::string text = "x,y,z\n";
  for (int k = 0; k < 25; ++k) text += "1,2,?\n";
  const std::string message = refusal(text);
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 10);
  EXPECT_THAT(message, HasSubstr("p.csv:11: \"?\" is not a number"));
  EXPECT_THAT(message, HasSubstr("p.csv: 15 more lines have problems"));
}

TEST_F(PointFileTest, RefusesColumnsThatAreNotMetres) {
  EXPECT_EQ(refusal("x,y,z_ft\n1,2,3\n"),
            "p.csv:1: column \"z_ft\" is in feet (Talus needs coordinates and heights in metres). Convert it to "
            "metres: a foot "
            "is 0.3048 m, a US survey foot 1200/3937 m");
  EXPECT_EQ(refusal("id,lat,lon,z\n1,2,3,4\n"),
            "p.csv:1: column \"lat\" is in degrees (Talus needs metres on plan). Project the points, for example with "
            "gdaltransform -s_srs EPSG:4326 -t_srs EPSG:XXXX");
}

TEST_F(PointFileTest, RefusesAmbiguousColumns) {
  EXPECT_EQ(refusal("x,y\n1,2\n"),
            "p.csv:1: no column is named z (the columns are \"x\", \"y\"). Name the columns x, y and z, or easting, "
            "northing and elevation");
  EXPECT_EQ(refusal("x,y,z,height\n1,2,3,4\n"),
            "p.csv:1: columns \"z\" and \"height\" have the same meaning (expected one x, one y and one z). Rename the "
            "one that is not to be used");
  EXPECT_EQ(refusal("1 2.5 3.5 4\n2 3.5 4.5 5\n3 1 1 1\n"),
            "p.csv: seems to number its points in the first column (no line names the columns, and the first number "
            "increases by 1 from line to line). Name the columns in the first line, for example: id x y z");
  EXPECT_EQ(read("x y z i\n1 2.5 3.5 4\n2 3.5 4.5 5\n3 1 1 1\n").size(), 3U);
}

TEST_F(PointFileTest, RefusesFilesWithoutPoints) {
  EXPECT_EQ(refusal(""), "p.csv: has no points (no line has three numbers)");
  EXPECT_EQ(refusal("x,y,z\n"), "p.csv: has no points (no line has three numbers)");
  EXPECT_EQ(refusal("1,2\n3,4\n"),
            "p.csv:1: has 2 of 3 columns (a point needs a height)\n"
            "p.csv:2: has 2 of 3 columns (a point needs a height)");
  EXPECT_EQ(refusal("1\n"), "p.csv: has no points (its first line is a count, but no point follows)");
  EXPECT_EQ(refusal(std::string(200'000, '7')),
            "p.csv: is not a text file of points (line 1 has more than 100000 bytes)");
  EXPECT_THROW(static_cast<void>(read_point_file("/nowhere/p.csv")), BadInput);
  EXPECT_THROW(static_cast<void>(read_point_file("/")), BadInput);
}

TEST_F(PointFileTest, RefusesCoordinatesTooFarFromTheOrigin) {
  EXPECT_EQ(refusal("x,y,z\n0,0,1\n1e300,0,1\n0,-2e9,1\n"),
            "p.csv:3: x is 1e+300 (coordinates must be smaller than 1e+09 m)\n"
            "p.csv:4: y is -2000000000 (coordinates must be smaller than 1e+09 m)");
}

}  // namespace
}  // namespace talus
