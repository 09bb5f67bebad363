// Seeders from polygons, rasters and lines of a GIS: the cells and rocks of the model.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <gdal_utils.h>

#include <map>
#include <numbers>
#include <set>

#include "sampling/goodness_of_fit.hpp"
#include "support/dice.hpp"
#include "support/gis_project.hpp"
#include "talus/campaign/simulate.hpp"

namespace talus::project {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string head = R"(material = [{ name = "Rock", roughness_deg = 2 }]
[terrain]
raster = "dem.tif"

[[seeder]]
name = "Cliffs"
diameter_m = 0.5
)";

class GisSeeders : public GisProject {
 protected:
  GisSeeders() { make("dem.tif", mountain()); }

  static const ReleaseCells& cells_of(const Model& model, std::size_t seeder = 0) {
    return std::get<ReleaseCells>(*model.seeders.at(seeder).where);
  }
  /// Columns and rows of the cells in the file, from the south-west.
  static std::set<std::pair<int, int>> places(const Model& model) {
    const ReleaseCells& cells = cells_of(model);
    std::set<std::pair<int, int>> out;
    for (std::size_t k = 0; k < cells.cells.size(); ++k) {
      const Vec3 centre = model.frame.global_from_local({cells.centre_of(k).x(), cells.centre_of(k).y(), 0});
      out.emplace(static_cast<int>(std::floor((centre.x() - west) / cell)),
                  static_cast<int>(std::floor((centre.y() - south) / cell)));
    }
    return out;
  }
};

// Centres of cells are at 2.5, 7.5, 12.5 ... m.
TEST_F(GisSeeders, APolygonSelectsTheCellsWithTheirCentreInside) {
  layer("cliffs.gpkg", "name", {{box(100, 50, 119, 62.4), ""}});
  const Model built = model(head + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\nrocks_per_cell = 3\n");
  EXPECT_EQ(warnings(), "");
  std::set<std::pair<int, int>> expected;
  for (int column = 20; column <= 23; ++column) {
    for (int row = 10; row <= 11; ++row) expected.emplace(column, row);
  }
  EXPECT_EQ(places(built), expected);
  EXPECT_EQ(built.rocks(), 24U);
  EXPECT_EQ(cells_of(built).dx, 5);
  EXPECT_EQ(built.seeder_report, "seeder \"Cliffs\": 8 cells of 5 x 5 m, 45.7 to 49.6 deg steep; 24 rocks");
  EXPECT_THAT(built.sources, ElementsAre("Cliffs"));
}

// Rocks start in their cells at a height above the surface, with equal numbers per cell.
TEST_F(GisSeeders, RocksStartInTheirCellsOnTheSurface) {
  layer("cliffs.gpkg", "name", {{box(100, 50, 150, 100), ""}});
  const Model built = model(head + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\nrocks = 250\nheight_above_m = 2\n");
  const auto& surface = std::get<RasterSurface>(*built.surface);
  std::map<std::pair<int, int>, int> counts;
  Simulator simulator(built);
  for (std::uint64_t rock = 0; rock < 250; ++rock) {
    static_cast<void>(simulator.simulate(rock, true));
    const Vec3 start = simulator.log().rows.front().motion.position;
    EXPECT_NEAR(start.z(), *surface.elevation(start.x(), start.y()) + 2, 1e-9);
    const Vec3 place = built.frame.global_from_local(start);
    const double x = place.x() - west, y = place.y() - south;
    ASSERT_TRUE(x > 100 && x < 150 && y > 50 && y < 100) << x << ' ' << y;
    ++counts[{static_cast<int>(x / cell), static_cast<int>(y / cell)}];
  }
  EXPECT_EQ(counts.size(), 100U);
  for (const auto& [place, count] : counts) EXPECT_TRUE(count == 2 || count == 3);
}

// In a triangle, 50,000 rocks are distributed along x like its cells: a Kolmogorov test. It detects that one rock in
// five is moved two cells to the east.
TEST_F(GisSeeders, EveryCellHasTheSameProbability) {
  layer("cliffs.gpkg", "name",
        {{fmt::format("POLYGON (({0} {1}, {2} {1}, {0} {3}, {0} {1}))", west + 50, south + 20, west + 250, south + 180),
          ""}});
  const Model built = model(head + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\nrocks = 50000\n");
  const ReleaseCells& cells = cells_of(built);
  EXPECT_GT(cells.cells.size(), 600U);
  std::map<double, double> cells_in_column;  // by the western edge
  for (const std::uint32_t number : cells.cells) ++cells_in_column[cells.corner.x() + 5 * (number % cells.columns)];
  const auto share_to_the_west = [&](double x) {
    double sum = 0;
    for (const auto& [border, count] : cells_in_column) sum += count * std::clamp((x - border) / 5, 0.0, 1.0);
    return sum / static_cast<double>(cells.cells.size());
  };
  std::vector<double> x;
  for (std::uint64_t rock = 0; rock < 50000; ++rock) {
    x.push_back(place_of(built.seeders[0], {1, {}, 0, 50000}, rock).point.x());
  }
  EXPECT_GT(kolmogorov_probability(kolmogorov_distance(x, share_to_the_west), x.size()), 1e-3);
  for (std::size_t k = 0; k < x.size(); k += 5) x[k] += 10;
  EXPECT_LT(kolmogorov_probability(kolmogorov_distance(x, share_to_the_west), x.size()), 1e-3);
}

TEST_F(GisSeeders, PolygonsMayBeInAnotherCoordinateSystem) {
  // The corners of a rectangle in degrees; its edges bend between them by less than a millimetre.
  OGRSpatialReference metres, degrees;
  metres.importFromEPSG(2193);
  degrees.importFromEPSG(4326);
  metres.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> there(OGRCreateCoordinateTransformation(&metres, &degrees));
  double x[4] = {west + 101, west + 149, west + 149, west + 101};
  double y[4] = {south + 51, south + 51, south + 99, south + 99};
  ASSERT_TRUE(there->Transform(4, x, y));
  std::string ring;
  for (int k : {0, 1, 2, 3, 0}) ring += fmt::format("{}[{:.12f}, {:.12f}]", ring.empty() ? "" : ", ", x[k], y[k]);
  write("cliffs.geojson", fmt::format(R"({{"type": "FeatureCollection", "features": [{{"type": "Feature",
      "properties": {{}}, "geometry": {{"type": "Polygon", "coordinates": [[{}]]}}}}]}})",
                                      ring));
  const Model built = model(head + "type = \"polygon\"\npolygons = \"cliffs.geojson\"\n");
  std::set<std::pair<int, int>> expected;
  for (int column = 20; column < 30; ++column) {
    for (int row = 10; row < 20; ++row) expected.emplace(column, row);
  }
  EXPECT_EQ(places(built), expected);
  EXPECT_EQ(warnings(), "");
}

TEST_F(GisSeeders, APolygonMayBeInTheProject) {
  const std::string inline_polygon =
      fmt::format("type = \"polygon\"\npolygon = [[{0}, {1}], [{2}, {1}], [{2}, {3}], [{0}, {3}]]\n", west + 100,
                  south + 50, west + 119, south + 62.4);
  layer("cliffs.gpkg", "name", {{box(100, 50, 119, 62.4), ""}});
  EXPECT_EQ(places(model(head + inline_polygon)),
            places(model(head + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\n")));
}

TEST_F(GisSeeders, EachPolygonMayBeASource) {
  // The second overlaps the first and comes later; the third has no name, the fourth that of the first.
  layer("cliffs.gpkg", "name",
        {{box(100, 50, 120, 70), "north"},
         {box(110, 50, 130, 70), "south"},
         {box(150, 50, 160, 60), ""},
         {box(200, 100, 205, 105), "north"}});
  const Model built = model(head +
                            "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\nsource_attribute = \"name\"\n"
                            "source = \"other\"\nrocks_per_cell = 1\n");
  EXPECT_THAT(built.sources, ElementsAre("north", "south", "other"));
  EXPECT_THAT(built.seeder_report, HasSubstr(", of 3 sources; 29 rocks"));
  std::map<std::string, std::set<std::pair<int, int>>> seen;
  Simulator simulator(built);
  for (std::uint64_t rock = 0; rock < built.rocks(); ++rock) {
    const RockRecord record = simulator.simulate(rock, true);
    const Vec3 place = built.frame.global_from_local(simulator.log().rows.front().motion.position);
    seen[built.sources[record.source.index]].emplace(static_cast<int>((place.x() - west) / cell),
                                                     static_cast<int>((place.y() - south) / cell));
  }
  EXPECT_EQ(seen["north"].size(), 9U);  // two columns of four, and the separate one
  EXPECT_TRUE(seen["north"].contains({40, 20}));
  EXPECT_FALSE(seen["north"].contains({22, 10}));
  EXPECT_EQ(seen["south"].size(), 16U);
  EXPECT_EQ(seen["other"].size(), 4U);
  // There is one seeder, with one name.
  EXPECT_EQ(built.seeders.size(), 1U);
  EXPECT_EQ(built.seeders[0].name, "Cliffs");
}

// The slope at the node x is atan(x / 100): cells of 45 to 60 degrees. Cells on the edge are not used, since a
// neighbour is missing.
TEST_F(GisSeeders, ARasterSeederSelectsTheCellsOfASlope) {
  const Model built = model(head + "type = \"raster\"\nmin_slope_deg = 45\nmax_slope_deg = 60\nrocks_per_cell = 2\n");
  std::set<std::pair<int, int>> expected;
  for (int column = 1; column < columns - 1; ++column) {
    const double slope = std::atan(cell * (column + 0.5) / 100) * 180 / std::numbers::pi;
    if (slope < 45 || slope > 60) continue;
    for (int row = 1; row < rows - 1; ++row) expected.emplace(column, row);
  }
  EXPECT_EQ(places(built), expected);
  EXPECT_EQ(built.rocks(), 2 * expected.size());
  EXPECT_EQ(warnings(), "");
}

// On a rough raster with holes, cell by cell as with `gdaldem slope`.
TEST_F(GisSeeders, SlopesAreThoseOfGdaldem) {
  RasterSpec rough = mountain();
  Dice dice(7);
  for (double& z : rough.cells) z = dice.chance(0.01) ? -9999 : z + dice.between(0, 6);
  make("dem.tif", rough);
  GDALDatasetUniquePtr dem(GDALDataset::Open(path("dem.tif").c_str()));
  GDALDatasetUniquePtr slopes(GDALDataset::FromHandle(
      GDALDEMProcessing(path("slopes.tif").c_str(), dem.get(), "slope", nullptr, nullptr, nullptr)));
  ASSERT_TRUE(slopes);
  std::vector<float> values(columns * rows);
  ASSERT_EQ(slopes->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, GDT_Float32,
                                               0, 0, nullptr),
            CE_None);
  std::set<std::pair<int, int>> expected;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float slope = values[static_cast<std::size_t>(row * columns + column)];
      ASSERT_GT(std::abs(slope - 50), 1e-4);  // no cell is ambiguous
      if (slope >= 50) expected.emplace(column, rows - 1 - row);
    }
  }
  EXPECT_GT(expected.size(), 300U);
  EXPECT_EQ(places(model(head + "type = \"raster\"\nmin_slope_deg = 50\n")), expected);
}

TEST_F(GisSeeders, SlopeAndPolygonCombine) {
  layer("cliffs.gpkg", "name", {{box(50, 50, 200, 70), ""}});
  const Model built = model(head + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\nmin_slope_deg = 60\n");
  for (const auto& [column, row] : places(built)) {
    EXPECT_GE(column, 35);  // 173.2 m and more
    EXPECT_LT(column, 40);
    EXPECT_TRUE(row >= 10 && row < 14);
  }
  EXPECT_EQ(places(built).size(), 20U);
}

TEST_F(GisSeeders, AMaskSelectsCells) {
  RasterSpec mask = mountain();
  mask.type = GDT_Byte;
  mask.no_data = 9;
  for (int k = 0; k < columns * rows; ++k) {
    const int column = k % columns, row = rows - 1 - k / columns;
    mask.cells[static_cast<std::size_t>(k)] = row >= 10 && row < 20 && column >= 10 && column < 30
                                                  ? (column < 20 ? 1 : 2)
                                              : row < 5 ? 9
                                                        : 0;
  }
  make("release.tif", mask);
  const std::string masked = head + "type = \"raster\"\nmask = \"release.tif\"\n";
  EXPECT_EQ(places(model(masked)).size(), 200U);
  const auto ones = places(model(masked + "mask_value = 1\n"));
  EXPECT_EQ(ones.size(), 100U);
  EXPECT_TRUE(ones.contains({10, 10}) && ones.contains({19, 19}));
  EXPECT_EQ(places(model(masked + "mask_value = 0\n")).size(), 58U * 34 - 200);
  EXPECT_EQ(places(model(masked + "min_slope_deg = 50\n")).size(), 60U);  // from column 24 on

  // The same mask on a grid of 2.5 m in another coordinate system, UTM zone 60S, by nearest neighbours.
  GDALDatasetUniquePtr plain(GDALDataset::Open(path("release.tif").c_str()));
  char* options[] = {const_cast<char*>("-t_srs"), const_cast<char*>("EPSG:32760"), const_cast<char*>("-tr"),
                     const_cast<char*>("2.5"),    const_cast<char*>("2.5"),        nullptr};
  GDALWarpAppOptions* warp = GDALWarpAppOptionsNew(options, nullptr);
  GDALDatasetH input = plain.get();
  GDALDatasetUniquePtr warped(
      GDALDataset::FromHandle(GDALWarp(path("utm.tif").c_str(), nullptr, 1, &input, warp, nullptr)));
  GDALWarpAppOptionsFree(warp);
  ASSERT_TRUE(warped);
  warped.reset();
  EXPECT_EQ(places(model(head + "type = \"raster\"\nmask = \"utm.tif\"\n")), places(model(masked)));
}

TEST_F(GisSeeders, WarnsOfAMaskThatSelectsByFillerValues) {
  RasterSpec mask = mountain();
  mask.no_data = {};
  const auto made = [&](GDALDataType type, double outside, double zone = 1) {
    mask.type = type;
    for (int k = 0; k < columns * rows; ++k)
      mask.cells[static_cast<std::size_t>(k)] =
          k % columns >= 10 && k % columns < 30 ? (k % columns < 20 ? 1 : zone) : outside;
    make("release.tif", mask);
    static_cast<void>(model(head + "type = \"raster\"\nmask = \"release.tif\"\n"));
    return warnings();
  };
  EXPECT_EQ(made(GDT_Float32, -9999),
            "slope.toml:5: warning: seeder \"Cliffs\": mask \"release.tif\" selects cells by the value -9999 (every "
            "value but "
            "0 does; of 2204 cells it has -9999 in 1444, 1 in 760). If -9999 means no data, declare it: gdal_translate "
            "-a_nodata -9999; or choose a value: mask_value = 1");
  for (const double value : {255.0, 127.0, 32767.0, -32768.0, 65535.0, 9999.0, -1.0, 2147483647.0})
    EXPECT_THAT(made(GDT_Float64, value), HasSubstr("selects cells by the value ")) << value;
  EXPECT_EQ(made(GDT_Byte, 0, 2), "") << "zones with numbers";
  EXPECT_EQ(made(GDT_Byte, 0, 1), "");
  for (double& cell : mask.cells) cell = cell == 0 ? 0 : 255;
  mask.type = GDT_Byte;
  make("release.tif", mask);
  static_cast<void>(model(head + "type = \"raster\"\nmask = \"release.tif\"\n"));
  EXPECT_EQ(warnings(), "") << "255 alone";
  for (const double value : {3.4028234663852886e38, -3.4028234663852886e38, 1e20}) {
    mask.type = GDT_Float32;
    for (double& cell : mask.cells) cell = cell == 0 ? value : 1;
    make("release.tif", mask);
    EXPECT_THAT(
        refusal(head + "type = \"raster\"\nmask = \"release.tif\"\n"),
        HasSubstr(
            "(it is probably a no-data value that the file does not declare). Declare it: gdal_translate -a_nodata "));
    for (double& cell : mask.cells) cell = cell == 1 ? 1 : 0;
  }
}

TEST_F(GisSeeders, OnAMeshCellsAreSquares) {
  // A plane that rises 1 in 1 to the east, 100 m by 60 m.
  const std::string plane = R"([terrain]
vertices = [[1000, 500, 0], [1100, 500, 100], [1100, 560, 100], [1000, 560, 0]]
triangles = [[0, 1, 2], [0, 2, 3]]
[[material]]
name = "Rock"
[[seeder]]
diameter_m = 0.5
)";
  const Model built = model(plane + "type = \"raster\"\nmin_slope_deg = 44.9\nmax_slope_deg = 45.1\ncell_m = 4\n");
  const ReleaseCells& cells = cells_of(built);
  EXPECT_EQ(cells.cells.size(), 23U * 13);  // 25 by 15 squares, without those on the edge
  std::set<double> x;
  for (std::size_t k = 0; k < cells.cells.size(); ++k) {
    x.insert(built.frame.global_from_local({cells.centre_of(k).x(), 0, 0}).x());
  }
  EXPECT_EQ(*x.begin(), 1006);
  EXPECT_EQ(*x.rbegin(), 1094);
  EXPECT_EQ(refusal(plane + "type = \"raster\"\nmin_slope_deg = 46\ncell_m = 4\n"),
            "slope.toml:6: seeder \"seeder 1\": no cell is as steep as 46 deg (the steepest of 299 cells has 45 deg, "
            "at (1006, 506))");
  EXPECT_EQ(refusal(plane + "type = \"raster\"\nmin_slope_deg = 46\n"),
            "slope.toml:6: seeder 1: cell_m is missing (the terrain is not a raster, so it has no cells of its own). "
            "Give the size of the cells from which rocks start, in metres");
}

TEST_F(GisSeeders, LinesAreOnTheTerrainOrHaveHeights) {
  const auto line = [](double x0, double y0, double x1, double y1, const char* kind = "", const char* z = "") {
    return fmt::format("LINESTRING {5} ({0} {1}{4}, {2} {3}{4})", west + x0, south + y0, west + x1, south + y1, z,
                       kind);
  };
  layer("cliff.gpkg", "name", {{line(100, 50, 110, 50), "a"}, {line(100, 100, 130, 100), "b"}});
  const std::string lines = head + "type = \"line\"\nlines = \"cliff.gpkg\"\nrocks = 2000\n";
  const Model draped = model(lines + "source_attribute = \"name\"\n");
  EXPECT_EQ(draped.seeder_report, "seeder \"Cliffs\": 2 lines, 40 m long");
  EXPECT_THAT(draped.sources, ElementsAre("a", "b"));
  Simulator simulator(draped);
  int on_line_a = 0;
  for (std::uint64_t rock = 0; rock < 2000; ++rock) {
    const RockRecord record = simulator.simulate(rock, true);
    const Vec3 start = simulator.log().rows.front().motion.position;
    const Vec3 place = draped.frame.global_from_local(start);
    const bool on_a = std::abs(place.y() - south - 50) < 1e-6;
    EXPECT_EQ(record.source, SourceId{on_a ? 0U : 1U});
    on_line_a += on_a ? 1 : 0;
    EXPECT_NEAR(start.z(), *std::get<RasterSurface>(*draped.surface).elevation(start.x(), start.y()), 1e-9);
  }
  EXPECT_NEAR(on_line_a, 500, 5 * std::sqrt(2000 * 0.25 * 0.75));  // by length; five standard errors
  layer("cliff.gpkg", "name", {{line(100, 50, 130, 50, "Z", " 300"), "a"}});
  const Model with_heights = model(lines);
  Simulator high(with_heights);
  static_cast<void>(high.simulate(0, true));
  EXPECT_EQ(high.log().rows.front().motion.position.z(), 300);
  layer("cliff.gpkg", "name", {{line(100, 50, 130, 50, "Z", " 300"), "a"}, {line(100, 60, 130, 60), "a"}});
  EXPECT_EQ(refusal(lines),
            "slope.toml:5: seeder \"Cliffs\": feature 2 of lines \"cliff.gpkg\" has no heights (others do). Give "
            "height_above_m to start all rocks at that height above the terrain");
  EXPECT_EQ(model(lines + "height_above_m = 1\n").seeders.size(), 1U);
}

TEST_F(GisSeeders, LinesOffTheTerrainAndOverHolesAreRefused) {
  RasterSpec holed = mountain();
  for (int row = 20; row < 24; ++row) holed.cells[static_cast<std::size_t>(row * columns + 30)] = -9999;
  make("dem.tif", holed);
  layer("cliff.gpkg", "name",
        {{fmt::format("LINESTRING ({} {}, {} {})", west + 100, south + 90, west + 200, south + 90), ""},
         {fmt::format("LINESTRING ({} {}, {} {})", west + 100, south + 50, west + 1000, south + 50), ""}});
  EXPECT_EQ(refusal(head + "type = \"line\"\nlines = \"cliff.gpkg\"\n"),
            "slope.toml:5: seeder \"Cliffs\": feature 1, (1757152.5, 5917090) is off the terrain (the terrain has a "
            "hole there, without data or triangles)\n"
            "slope.toml:5: seeder \"Cliffs\": feature 2, (1758000, 5917050) is off the terrain (on plan the terrain "
            "lies within x = 1757002.5 to 1757297.5, y = 5917002.5 to 5917197.5)");
}

TEST_F(GisSeeders, ErrorsInAFileAreReportedAtTheLineThatNamesIt) {
  layer("cliffs.gpkg", "name", {{box(100, 50, 150, 60), ""}});
  const std::string wrong = "has no layer \"leyer\" (it has \"layer\"). Did you mean \"layer\"?";
  EXPECT_EQ(refusal(head + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\nlayer = \"leyer\"\n"),
            "slope.toml:9: seeder \"Cliffs\": polygons cliffs.gpkg: " + wrong);
  const std::string nameless = head.substr(0, head.find("name = \"Cliffs\"")) + head.substr(head.find("diameter_m"));
  EXPECT_EQ(refusal(nameless + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\nlayer = \"leyer\"\n"),
            "slope.toml:8: seeder 1: polygons cliffs.gpkg: " + wrong);
  EXPECT_EQ(refusal(head + "type = \"polygon\"\npolygons = \"other.gpkg\"\nlayer = \"leyer\"\n",
                    {.settings = {"seeder.0.polygons=\"cliffs.gpkg\""}, .rocks = {}, .seed = {}}),
            "--set seeder.0.polygons=\"cliffs.gpkg\": seeder \"Cliffs\": polygons cliffs.gpkg: " + wrong);
}

TEST_F(GisSeeders, SeedersWithoutCellsAreRefusedWithTheReason) {
  const std::string polygon = head + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\n";
  layer("cliffs.gpkg", "name", {{box(5000, 50, 5010, 60), ""}});
  EXPECT_EQ(refusal(polygon),
            "slope.toml:5: seeder \"Cliffs\": polygons \"cliffs.gpkg\" does not reach the terrain (it lies within x = "
            "1762000 to 1762010, y = 5917050 to 5917060; the terrain within x = 1757002.5 to 1757297.5, y = 5917002.5 "
            "to 5917197.5). Check its extent and coordinate system with ogrinfo");
  layer("cliffs.gpkg", "name", {{box(100, 50, 101, 60), ""}});
  EXPECT_EQ(refusal(polygon),
            "slope.toml:5: seeder \"Cliffs\": polygons \"cliffs.gpkg\" contains no cell (none of the cells of 5 x 5 m "
            "has its centre inside)");
  layer("cliffs.gpkg", "name", {{box(100, 50, 150, 60), ""}});
  EXPECT_EQ(refusal(polygon + "min_slope_deg = 70\n"),
            "slope.toml:5: seeder \"Cliffs\": no cell is as steep as 70 deg (the steepest of 20 cells has 55.86 deg, "
            "at (1757147.5, 5917052.5))");
  EXPECT_EQ(refusal(polygon + "max_slope_deg = 30\n"),
            "slope.toml:5: seeder \"Cliffs\": no cell is as gentle as 30 deg (the gentlest of 20 cells has 45.71 deg, "
            "at (1757102.5, 5917052.5))");
  EXPECT_EQ(refusal(polygon + "min_slope_deg = 50\nmax_slope_deg = 50.1\n"),
            "slope.toml:5: seeder \"Cliffs\": no cell is 50 to 50.1 deg steep (the 20 cells have 45.71 to 55.86 deg)");
  RasterSpec holed = mountain();
  for (int row = 0; row < rows; ++row) {
    for (int column = 15; column < 35; ++column) holed.cells[static_cast<std::size_t>(row * columns + column)] = -9999;
  }
  make("dem.tif", holed);
  EXPECT_EQ(refusal(polygon),
            "slope.toml:5: seeder \"Cliffs\": the terrain has no data there (none of 20 cells of 5 x 5 m in polygons "
            "\"cliffs.gpkg\" has data with its eight neighbours)");
}

TEST_F(GisSeeders, MasksThatSelectNothingAreRefused) {
  RasterSpec mask = mountain();
  mask.type = GDT_Byte;
  mask.cells.assign(columns * rows, 0);
  make("release.tif", mask);
  const std::string masked = head + "type = \"raster\"\nmask = \"release.tif\"\n";
  EXPECT_EQ(refusal(masked),
            "slope.toml:5: seeder \"Cliffs\": mask \"release.tif\" is 0 in all of the cells (of 2204 cells it has 0 in "
            "2204)");
  EXPECT_EQ(refusal(masked + "mask_value = 3\n"),
            "slope.toml:5: seeder \"Cliffs\": mask \"release.tif\" has 3 in none of the cells (of 2204 cells it has 0 "
            "in 2204)");
  mask.geotransform = {west + 10000, cell, 0, south + 200, 0, -cell};
  make("release.tif", mask);
  EXPECT_EQ(
      refusal(masked),
      "slope.toml:5: seeder \"Cliffs\": mask \"release.tif\" does not reach the terrain (the terrain lies within x = "
      "1757002.5 to 1757297.5, y = 5917002.5 to 5917197.5). Check its extent and coordinate system with gdalinfo");
  EXPECT_EQ(refusal(head + "type = \"raster\"\nmask = \"none.tif\"\n"),
            "slope.toml:9: seeder \"Cliffs\": mask is \"none.tif\" (there is no such file). The path is relative "
            "to the project file");
}

TEST_F(GisSeeders, PartsOffTheTerrainAreReportedAndLeftOut) {
  RasterSpec holed = mountain();
  holed.cells[static_cast<std::size_t>((rows - 1 - 12) * columns + 24)] = -9999;
  make("dem.tif", holed);
  layer("cliffs.gpkg", "name", {{box(100, 50, 150, 100), ""}, {box(280, 50, 400, 60), ""}, {box(900, 0, 910, 9), ""}});
  const Model built = model(head + "type = \"polygon\"\npolygons = \"cliffs.gpkg\"\n");
  EXPECT_EQ(warnings(),
            "slope.toml:5: warning: seeder \"Cliffs\": 2 of 3 polygons extend beyond the terrain or lie outside it "
            "(rocks start on the terrain only)\n"
            "slope.toml:5: warning: seeder \"Cliffs\": 11 of 108 cells are left out (they or one of their eight "
            "neighbours have no data, or lie on the edge of the terrain)");
  EXPECT_EQ(places(built).size(), 97U);
}

TEST_F(GisSeeders, TheNumberOfRocksMayBeOverridden) {
  const std::string slope = "type = \"raster\"\nmin_slope_deg = 50\nrocks_per_cell = 3\n";
  Overrides overrides;
  overrides.rocks = 77;
  EXPECT_EQ(model(head + slope, overrides).rocks(), 77U);
  EXPECT_EQ(refusal(head + slope +
                        "[[seeder]]\nname = \"Block\"\nposition = [1757050, 5917050]\nheight_above_m = 1\n"
                        "mass_kg = 100\n",
                    overrides),
            "--rocks 77: cannot be shared among the 2 seeders (seeder 1 has rocks_per_cell, and its cells are not "
            "counted yet). Give it rocks instead, or set the rocks of each seeder: --set seeder.0.rocks=...");
  EXPECT_THAT(refusal(head + "type = \"raster\"\nmin_slope_deg = 50\nrocks_per_cell = 1000000000000\n"),
              HasSubstr("slope.toml:5: seeder \"Cliffs\": 1000000000000 rocks from each of "));
}

}  // namespace
}  // namespace talus::project

#endif
