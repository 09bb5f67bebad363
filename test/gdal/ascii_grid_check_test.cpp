#include "talus/gdal/ascii_grid_check.hpp"

#ifdef TALUS_HAS_GDAL

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "support/raster_reading.hpp"

namespace talus {
namespace {

using namespace testing_tools;

const std::string header = ascii_header(3, 2, 5000, 9000, 5);

class AsciiGrid : public RasterReading {
 protected:
  RasterFile read(const std::string& text) {
    write("dem.asc", text);
    return RasterReading::read("dem.asc", local_crs());
  }
  [[nodiscard]] std::string refusal(const std::string& text) {
    return refusal_of([&] { static_cast<void>(read(text)); });
  }
  [[nodiscard]] std::string refusal_as_classes(const std::string& text) {
    write("dem.asc", text);
    return RasterReading::refusal_as_classes("dem.asc");
  }
};

using Heights = std::vector<float>;

// ---- valid grids ----

TEST_F(AsciiGrid, ReadsEveryLegalForm) {
  const Heights heights{4, 5, 6, 1, 2, 3};
  for (const std::string cells :
       {"1 2 3\n4 5 6\n", " 1 2 3 \n 4 5 6 \n\n\n", "1\t2\t3\r\n4\t5\t6\r\n", "1 2\n3 4\n5\n6", "1 2 3 4 5 6",
        "1.0 2. +3\n4e0 0.5E+1 600e-2\n", "1,0 2,0 3,0\n4,0 5,0 6,0\n", "1 2 3\n4 5 6\n\x1a", "\n1 2 3\n4 5 6\n"}) {
    SCOPED_TRACE(cells);
    EXPECT_EQ(read(header + cells).grid.z, heights);
  }
  EXPECT_EQ(read("NCOLS 3.00\r\nNROWS 2\r\nXLLCENTER 1e3\r\nYLLCENTER 2e3\r\nDX 5\r\nDY 4\r\nnodata_VALUE -9999\r\n"
                 "1 2 3\r\n4 5 6\r\n")
                .grid.z,
            heights);
  EXPECT_EQ(read(header + "ZUNITS METERS\n1 2 3\n4 5 6\n").grid.z, heights);
}

TEST_F(AsciiGrid, NanIsNoDataInAGridOfRealNumbers) {
  const std::string more = "4 5 6\n7 8 9\n";
  const std::string start = ascii_header(3, 4, 0, 0, 5);
  EXPECT_EQ(read(start + "NODATA_value -9999\n1.5 nan NaN\n-nan NAN -9999\n" + more).without_data, 5U);
  EXPECT_EQ(read(start + "NODATA_value nan\n1.5 nan 3\n1 2 3\n" + more).without_data, 1U);
  EXPECT_EQ(read(start + "NODATA_value null\n1.5 null 3\n1 2 3\n" + more).without_data, 1U);
}

TEST_F(AsciiGrid, ReadsNumbersAcrossTheBordersOfChunks) {
  constexpr int side = 1000;  // about 9 MB
  std::string text = ascii_header(side, side, 0, 0, 1);
  for (int i = 0; i < side * side; ++i) text += fmt::format("{}{}", 100 + 0.0001 * (i % 10007), i % 7 ? ' ' : '\n');
  EXPECT_EQ(refusal(text), "was read");
  const std::string wrong = text + "\n1x";
  EXPECT_EQ(refusal(wrong), fmt::format("dem.asc:{0}: \"1x\" is not a number (it is in row 1001, column 1)\n"
                                        "dem.asc:{0}: has 1000001 cells (ncols 1000 and nrows 1000 make 1000000). Its "
                                        "first line of cells has 1: is ncols wrong?",
                                        std::count(wrong.begin(), wrong.end(), '\n') + 1));
}

// ---- refusals ----

TEST_F(AsciiGrid, RefusesWhatIsNotANumberWithItsPlace) {
  EXPECT_EQ(refusal(header + "1 1O0 3\n4 abc 6,5,5\n"),
            "dem.asc:6: \"1O0\" is not a number (it is in row 1, column 2)\n"
            "dem.asc:7: \"abc\" is not a number (it is in row 2, column 2)\n"
            "dem.asc:7: \"6,5,5\" is not a number (it is in row 2, column 3)");
  for (const std::string bad :
       {"1.0D+03", "1.234,5", "1,234.5", "--1", "+-1", "-", "+", ".", ",", "inf", "0x10", "1e", "1.5.", "#"}) {
    EXPECT_EQ(refusal(header + "1 2 3\n4 5 " + bad + "\n"),
              fmt::format("dem.asc:7: \"{}\" is not a number (it is in row 2, column 3)", bad));
  }
  EXPECT_EQ(refusal(header + "1 2 3\n4 5 1" + std::string(600, '0') + "\n").substr(0, 23), "dem.asc:7: \"10000000000");
}

TEST_F(AsciiGrid, ReportsTheFirstTenOfManyBadNumbers) {
  std::string text = ascii_header(20, 2, 0, 0, 5) + "1 ";
  for (int i = 1; i < 40; ++i) text += "x ";
  const std::string message = refusal(text);
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 10);
  EXPECT_EQ(message.substr(message.rfind('\n') + 1), "dem.asc: 29 more cells are not numbers");
}

TEST_F(AsciiGrid, RefusesNanInAGridOfIntegers) {
  const std::string why =
      "it is in row 1, column 2; in a grid of integers it would be read as 0). Write no-data cells as a number, for "
      "example -9999, and declare it: NODATA_value -9999";
  EXPECT_EQ(refusal(header + "1 nan 3\n4 5 6\n"), "dem.asc:6: \"nan\" is not a number (" + why);
  EXPECT_EQ(refusal_as_classes(header + "1 null 3\n4 5 6\n"), "dem.asc:6: \"null\" is not a number (" + why);
  EXPECT_EQ(refusal(header + "1 3000000000 3\n4 5 6\n"),
            "dem.asc:6: \"3000000000\" is not a number (it is in row 1, column 2; integers have 32 bits). Write it "
            "with a decimal point");
}

TEST_F(AsciiGrid, RefusesARowThatBeginsWithALetter) {
  EXPECT_EQ(refusal(header + "nan 2.5 3\n4 5 6\n"),
            "dem.asc:6: the first row begins with \"nan\" (a line that begins with a letter counts as part of the "
            "header). Write no-data cells as a number, for example -9999, and declare it: NODATA_value -9999");
  EXPECT_EQ(refusal(header + "abc 2.5 3\n4 5 6\n"),
            "dem.asc:8: has 3 cells (ncols 3 and nrows 2 make 6). Line 6 begins with a letter and so counts as part of "
            "the header: does it contain cells?");
}

TEST_F(AsciiGrid, RefusesTooFewAndTooManyCells) {
  EXPECT_EQ(refusal(header + "1 2 3\n4 5\n"),
            "dem.asc:8: has 5 cells (ncols 3 and nrows 2 make 6). Copy it again from its source");
  EXPECT_EQ(refusal(header + "1 2 3 4\n5 6 7 8\n"),
            "dem.asc:7: has 8 cells (ncols 3 and nrows 2 make 6). Its first line of cells has 4: is ncols wrong?");
  EXPECT_EQ(refusal(header + "1 2 3\n4 5 6\n7 8 9\n"),
            "dem.asc:8: has 9 cells (ncols 3 and nrows 2 make 6). That makes 3 rows: is nrows wrong?");
  EXPECT_EQ(refusal_as_classes(header + "1 2 3\n4 5 6\n7\n"),
            "dem.asc:8: has 7 cells (ncols 3 and nrows 2 make 6). Copy it again from its source");
}

TEST_F(AsciiGrid, RefusesBadKeysOfTheHeader) {
  EXPECT_EQ(refusal("ncols 3x\nnrows 2.5\nxllcorner west\nyllcorner\ncellsize 0\nNODATA_value none\n1 2 3\n4 5 6\n"),
            "dem.asc:1: ncols is \"3x\" (expected a whole number, 1 or more)\n"
            "dem.asc:2: nrows is \"2.5\" (expected a whole number, 1 or more)\n"
            "dem.asc:3: xllcorner is \"west\" (expected a number)\n"
            "dem.asc:4: yllcorner has no value (expected a number)\n"
            "dem.asc:5: cellsize is \"0\" (expected a number, more than 0)\n"
            "dem.asc:6: NODATA_value is \"none\" (expected a number)");
  EXPECT_EQ(refusal("ncols 3\nncols 4\nnrows 2\nxllcorner 0\nyllcenter 0\ndx 5\n1 2 3\n4 5 6\n"),
            "dem.asc:2: ncols is given twice (one of them is wrong)\n"
            "dem.asc: has no cellsize (the header needs it, or dx and dy)\n"
            "dem.asc: is not georeferenced (the header needs xllcorner and yllcorner, or xllcenter and yllcenter)");
  EXPECT_EQ(refusal("ncols 3\n nrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n1 2 3\n4 5 6\n"),
            "dem.asc: has no nrows (the header needs it)\n"
            "dem.asc: has no cellsize (the header needs it, or dx and dy)\n"
            "dem.asc: is not georeferenced (the header needs xllcorner and yllcorner, or xllcenter and yllcenter)");
}

TEST_F(AsciiGrid, OtherFilesAreNotGrids) {
  make("dem.tif");
  EXPECT_FALSE(is_ascii_grid(path("dem.tif")));
  EXPECT_FALSE(is_ascii_grid(path("no.asc")));
  EXPECT_FALSE(is_ascii_grid(path("")));
  write("dx.txt", "dx is the distance in metres, in a text that has nothing else in common with a grid\n");
  EXPECT_FALSE(is_ascii_grid(path("dx.txt")));
  write("dem.txt", header + "1 2 3\n4 5 6\n");
  EXPECT_TRUE(is_ascii_grid(path("dem.txt")));
}

}  // namespace
}  // namespace talus

#endif
