// The keys of each type of seeder: the exact text of errors and warnings.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/projects.hpp"

namespace talus::project {
namespace {

using testing_tools::problems_of_reading;

struct SeederCase {
  const char* name;
  const char* keys;      // of the seeder, from line 10 on
  const char* problems;  // without "slope.toml:"
  bool is_2d = false;
};

std::string problems_of_seeder(const SeederCase& c) {
  const std::string text =
      std::string("[terrain]\n") +
      (c.is_2d ? "section = [[0, 0], [10, -10]]\n" : "vertices = [[0, 0, 0], [9, 0, 0], [0, 9, 5]]\n") +
      (c.is_2d ? "\n" : "triangles = [[0, 1, 2]]\n") +
      "[[material]]\nname = \"Rock\"\n\n[[seeder]]\nname = \"Cliff\"\nmass_kg = 10\n" + c.keys;
  return problems_of_reading(text);
}

class SeederKeys : public ::testing::TestWithParam<SeederCase> {};

TEST_P(SeederKeys, HaveTheseProblems) {
  std::string expected, line;
  for (const char* c = GetParam().problems; *c; ++c) {
    if (line.empty()) expected += "slope.toml:";
    line = *c == '\n' ? "" : "x";
    expected += *c;
  }
  EXPECT_EQ(problems_of_seeder(GetParam()), expected);
}

constexpr const char* triangle = "polygon = [[0, 0], [5, 0], [0, 5]]\n";

const std::vector<SeederCase> seeder_cases{
    {"TableForAPoint", "table = \"a.csv\"\n",
     "10: seeder \"Cliff\": a table is given for a point (every row of a table is a place). Write type = \"table\""},
    {"TableMissing", "type = \"table\"\n",
     "7: seeder \"Cliff\": table is missing (a table seeder needs the file of its releases). Write table = "
     "\"releases.csv\""},
    {"KeysOfATableForARaster",
     "type = \"raster\"\ncell_m = 1\nmin_slope_deg = 9\ntable = \"a.csv\"\nname_attribute = \"a\"\nrocks_per_row = 2\n",
     "13: seeder \"Cliff\": table is given for a raster (it belongs to another type of seeder). Leave it out\n"
     "14: seeder \"Cliff\": name_attribute is given for a raster (it belongs to another type of seeder). Leave it out\n"
     "15: warning: seeder \"Cliff\": rocks_per_row has no effect (a raster seeder has no rows)"},
    {"LayerOfAText", "type = \"table\"\ntable = \"a.csv\"\nlayer = \"a\"\n",
     "12: seeder \"Cliff\": layer is given for a text file (it has no layers). Leave it out"},
    {"PointsOfAMapIn2D", "type = \"table\"\ntable = \"a.gpkg\"\n",
     "11: seeder \"Cliff\": table is \"a.gpkg\" in 2D (a section has no position on a map). Name a text file (.csv, "
     ".xyz, "
     ".txt, .pts or .dat) with columns x_m and z_m",
     true},
    {"RocksAndRocksPerRow", "type = \"table\"\ntable = \"a.csv\"\nrocks = 5\nrocks_per_row = 2\n",
     "13: seeder \"Cliff\": rocks and rocks_per_row are given together (they exclude each other)"},
    {"LinesForAPoint", "lines = \"a.gpkg\"\n",
     "10: seeder \"Cliff\": lines are given for a point (they belong to a line). Write type = \"line\""},
    {"PolygonForAPoint", triangle,
     "10: seeder \"Cliff\": a polygon is given for a point (a polygon is an area). Write type = \"polygon\""},
    {"LineWithoutPoints", "type = \"line\"\n",
     "7: seeder \"Cliff\": points is missing (a line seeder needs two or more points). Or name a file: lines = "
     "\"cliff.gpkg\""},
    {"PolygonMissing", "type = \"polygon\"\ncell_m = 1\n",
     "7: seeder \"Cliff\": polygons is missing (a polygon seeder needs polygons or polygon). Write polygons = "
     "\"cliffs.gpkg\", or polygon = [[x, y], ...]"},
    {"PointsForAPolygon", "type = \"polygon\"\ncell_m = 1\npoints = [[0, 0, 1], [1, 1, 1]]\n",
     "7: seeder \"Cliff\": polygons is missing (a polygon seeder needs polygons or polygon). Write polygons = "
     "\"cliffs.gpkg\", or polygon = [[x, y], ...]\n"
     "12: seeder \"Cliff\": points is given for a polygon (it belongs to another type of seeder). Leave it out"},
    {"PolygonForARaster", "type = \"raster\"\ncell_m = 1\npolygons = \"a.gpkg\"\n",
     "12: seeder \"Cliff\": a polygon is given for a raster (slope limits and masks also apply to polygons). Write "
     "type = \"polygon\""},
    {"RasterWithoutSelection", "type = \"raster\"\ncell_m = 1\n",
     "7: seeder \"Cliff\": the cells are not specified (a raster seeder needs a slope or a mask). Write min_slope_deg "
     "= 45, or mask = \"release.tif\""},
    {"RasterWithAPosition", "type = \"raster\"\ncell_m = 1\nmin_slope_deg = 30\nposition = [1, 1, 1]\n",
     "13: seeder \"Cliff\": position is given for a raster (it belongs to another type of seeder). Leave it out"},
    {"CellsIn2D", "type = \"raster\"\nmin_slope_deg = 30\ncell_m = 1\n",
     "10: seeder \"Cliff\": type is \"raster\" in 2D (a section has no area). Use a point or a line, or give "
     "terrain.width_m for 3D",
     true},
    {"LinesIn2D", "type = \"line\"\nlines = \"a.gpkg\"\n",
     "11: seeder \"Cliff\": lines is given in 2D (a section has no position on a map). Use points", true},
    {"LinesAndPoints", "type = \"line\"\nlines = \"a.gpkg\"\npoints = [[0, 0, 1], [1, 1, 1]]\n",
     "11: seeder \"Cliff\": points and lines are given together (they exclude each other)"},
    {"TwoPolygons", "type = \"polygon\"\ncell_m = 1\npolygons = \"a.gpkg\"\npolygon = [[0, 0], [5, 0], [0, 5]]\n",
     "13: seeder \"Cliff\": polygons and polygon are given together (they exclude each other)"},
    {"RocksAndRocksPerCell", "type = \"raster\"\ncell_m = 1\nmin_slope_deg = 9\nrocks = 5\nrocks_per_cell = 2\n",
     "14: seeder \"Cliff\": rocks and rocks_per_cell are given together (they exclude each other)"},
    {"CellMissing", "type = \"raster\"\nmin_slope_deg = 30\n",
     "7: seeder \"Cliff\": cell_m is missing (the terrain is not a raster, so it has no cells of its own). Give the "
     "size of the cells from which rocks start, in metres"},
    {"MaskValueWithoutMask", "type = \"raster\"\ncell_m = 1\nmin_slope_deg = 30\nmask_value = 1\n",
     "13: seeder \"Cliff\": mask_value is given without a mask (it would have no effect)"},
    {"SlopesInTheWrongOrder", "type = \"raster\"\ncell_m = 1\nmin_slope_deg = 50\nmax_slope_deg = 40\n",
     "13: seeder \"Cliff\": max_slope_deg is 40 (min_slope_deg is 50, so no cell can meet both)"},
    {"SlopeOf90", "type = \"raster\"\ncell_m = 1\nmin_slope_deg = 90\n",
     "12: seeder \"Cliff\": min_slope_deg is 90 (expected 0 to less than 90)"},
    {"PolygonOfTwo", "type = \"polygon\"\ncell_m = 1\npolygon = [[0, 0], [5, 0]]\n",
     "12: seeder \"Cliff\": polygon is [[0, 0], [5, 0]] (expected three or more points on plan, [[x, y], [x, y], [x, "
     "y]])"},
    {"PolygonOfTriples", "type = \"polygon\"\ncell_m = 1\npolygon = [[0, 0, 1], [5, 0, 1], [5, 5, 1]]\n",
     "12: seeder \"Cliff\": polygon[0] is [0, 0, 1] (expected a point on plan, [x, y])"},
    {"PolygonWithARepeatedPoint", "type = \"polygon\"\ncell_m = 1\npolygon = [[0, 0], [5, 0], [5, 0], [0, 5]]\n",
     "12: seeder \"Cliff\": polygon[2] is [5, 0] (it repeats the previous point). Leave it out"},
    {"PolygonThatCrossesItself", "type = \"polygon\"\ncell_m = 1\npolygon = [[0, 0], [4, 4], [4, 0], [0, 4]]\n",
     "12: seeder \"Cliff\": polygon crosses or touches itself (at or near (2, 2)). Give its corners in order, once "
     "around"},
    {"KeysWithoutEffectForAPoint",
     "position = [1, 1, 1]\nlayer = \"a\"\nmin_slope_deg = 40\nrocks_per_cell = 2\nplace = \"centre\"\n",
     "11: warning: seeder \"Cliff\": layer has no effect (a point seeder has no file of lines, polygons or rows)\n"
     "12: warning: seeder \"Cliff\": min_slope_deg has no effect (a point seeder has no cells)\n"
     "13: warning: seeder \"Cliff\": rocks_per_cell has no effect (a point seeder has no cells)\n"
     "14: warning: seeder \"Cliff\": place has no effect (a point seeder has no cells)"},
    {"KeysWithoutEffectForAPolygon",
     "type = \"polygon\"\ncell_m = 1\npolygon = [[0, 0], [5, 0], [0, 5]]\nlayer = \"a\"\nsource_attribute = \"b\"\n",
     "13: warning: seeder \"Cliff\": layer has no effect (it belongs to a file of lines, polygons or rows)\n"
     "14: warning: seeder \"Cliff\": source_attribute has no effect (it belongs to a file of lines, polygons or rows)"},
    {"AnAreaWithADirection",
     "type = \"polygon\"\ncell_m = 1\npolygon = [[0, 0], [5, 0], [0, 5]]\nspeed_m_s = 2\ndirection = [0, 1, 0]\n", ""},
    {"AnAreaLaunchedDownItsSlopes",
     "type = \"polygon\"\ncell_m = 1\npolygon = [[0, 0], [5, 0], [0, 5]]\nspeed_m_s = 2\ndirection = \"downslope\"\n",
     ""},
    {"ADefaultIsAccepted", "position = [1, 1, 1]\nplace = \"random\"\n", ""},
    {"AClosedPolygonIsFine", "type = \"polygon\"\ncell_m = 1\npolygon = [[0, 0], [5, 0], [0, 5], [0, 0]]\n", ""},
};

INSTANTIATE_TEST_SUITE_P(All, SeederKeys, ::testing::ValuesIn(seeder_cases),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

TEST(SeederPolygon, IsStoredWithoutTheRepeatedCorner) {
  const Project project = read_project_text(
                              "[terrain]\nraster = \"dem.tif\"\n[[material]]\nname = \"Rock\"\n[[seeder]]\nmass_kg = "
                              "1\ntype = \"polygon\"\npolygon = [[0, 0], [5, 0], [0, 5], [0, 0]]\ncell_m = 3\n",
                              "slope.toml")
                              .project;
  EXPECT_EQ(project.seeders.at(0).in_cells.polygon, (std::vector<std::array<double, 2>>{{0, 0}, {5, 0}, {0, 5}}));
}

TEST(SeederPoints, AreReportedAtMostTenTimes) {
  std::string points = "[0, 0, 1]";
  for (int k = 0; k < 1000; ++k) points += ", [1, 1, \"high\"]";
  const std::string keys = "type = \"line\"\npoints = [" + points + "]\n";
  std::string expected;
  for (int k = 1; k <= 10; ++k) {
    expected += (k > 1 ? "\n" : "") + std::string("slope.toml:11: seeder \"Cliff\": points[") + std::to_string(k) +
                "][2] is \"high\" (expected a number or \"surface\")";
  }
  EXPECT_EQ(problems_of_seeder({"", keys.c_str(), ""}), expected);
}

}  // namespace
}  // namespace talus::project
