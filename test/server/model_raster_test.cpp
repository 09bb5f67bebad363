// Raster terrain for the page: tiles, triangles and sections.

#ifdef TALUS_HAS_GDAL

#include "server/served_models.hpp"

#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;

/// An ASCII grid; `height` is a function of column and row, both from the south-west.
template <class Height>
std::string ascii_grid(int columns, int rows, double cell, Height&& height) {
  std::string text = fmt::format(
      "ncols {}\nnrows {}\nxllcorner 5000\nyllcorner 9000\ncellsize {}\nNODATA_value -9999\n", columns, rows, cell);
  for (int row = rows - 1; row >= 0; --row) {
    for (int column = 0; column < columns; ++column) text += fmt::format("{} ", height(column, row));
    text += '\n';
  }
  return text;
}

class ModelOnRaster : public testing_tools::ServedModels {
 protected:
  /// Writes a slope with a hole; returns the text of a project on it.
  std::string raster_project(int columns, int rows) const {
    write("dem.asc", ascii_grid(columns, rows, 10, [&](int column, int row) {
            return column == 3 && row == 2 ? -9999.0 : 500 + column * 7.25 - row * 3.5 + (column * row % 5) * 0.25;
          }));
    return R"(
[terrain]
raster = "dem.asc"
[[material]]
name = "Rock"
[[seeder]]
position = [5020, 9020, "surface"]
mass_kg = 1000
)";
  }
};

TEST_F(ModelOnRaster, HasTiles) {
  const int columns = 300, rows = 70;
  const std::string text = raster_project(columns, rows);
  const Json model = model_of(text);
  EXPECT_EQ(model["kind"], "raster");
  const Model ours = built(text);
  const auto& surface = std::get<RasterSurface>(*ours.surface);
  const RasterGrid& grid = surface.grid();
  const Json tiles = get(at(model, "tiles")).json();
  EXPECT_EQ(tiles["columns"], columns);
  EXPECT_EQ(tiles["rows"], rows);
  EXPECT_EQ(tiles["cell"], (Json{10.0, 10.0}));
  EXPECT_EQ(tiles["levels"], Json::parse(R"([{"stride": 1, "columns": 2, "rows": 1},
                                             {"stride": 2, "columns": 1, "rows": 1}])"));

  const auto node = [&](const ArraysOf& tile, int column, int row) {
    const double x =
        tile.header["origin"][0].get<double>() + column * tile.header["cell"][0].get<double>() - ours.frame.origin.x();
    const double y =
        tile.header["origin"][1].get<double>() + row * tile.header["cell"][1].get<double>() - ours.frame.origin.y();
    return std::pair(std::lround((x - grid.x0) / grid.dx), std::lround((y - grid.y0) / grid.dy));
  };
  std::set<std::pair<long, long>> seen;
  int north_east = 0, south_east = 0;
  for (const std::string which : {"0/0/0", "0/1/0", "1/0/0"}) {
    const Reply reply = get(at(model, "tiles/" + which));
    ASSERT_EQ(reply.status, 200);
    const ArraysOf tile(reply);
    const int wide = tile.header["columns"], high = tile.header["rows"];
    const auto heights = tile.get<float>("heights", "f32");
    ASSERT_EQ(heights.size(), static_cast<std::size_t>(wide * high));
    EXPECT_EQ(tile.get<std::uint8_t>("materials", "u8").size(), static_cast<std::size_t>((wide - 1) * (high - 1)));
    const auto diagonals = tile.get<std::uint8_t>("diagonals", "u8");
    ASSERT_EQ(diagonals.size(), static_cast<std::size_t>((wide - 1) * (high - 1)));
    for (int row = 0; which[0] == '0' && row + 1 < high; ++row) {
      for (int column = 0; column + 1 < wide; ++column) {
        const auto [i, j] = node(tile, column, row);
        const bool is_cut_north_east =
            surface.is_cut_north_east(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        EXPECT_EQ(diagonals[static_cast<std::size_t>(row * (wide - 1) + column)], is_cut_north_east ? 1 : 0);
        (is_cut_north_east ? north_east : south_east) += 1;
      }
    }
    for (int row = 0; row < high; ++row) {
      for (int column = 0; column < wide; ++column) {
        const auto [i, j] = node(tile, column, row);
        const float ground = grid.z[grid.index(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))];
        const float sent = heights[static_cast<std::size_t>(row * wide + column)];
        if (std::isnan(ground)) {
          EXPECT_TRUE(std::isnan(sent));
        } else {
          EXPECT_EQ(sent, ground);
        }
        if (which[0] == '0') seen.emplace(i, j);
      }
    }
    EXPECT_EQ(tile.header["origin"][2], ours.frame.origin.z());
    if (which[0] == '1') {  // the whole raster, up to the last full step
      EXPECT_EQ(node(tile, 0, 0), std::pair(0L, 0L));
      EXPECT_EQ(node(tile, wide - 1, high - 1), std::pair(columns - 2L, rows - 2L));
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(columns * rows));
  EXPECT_GT(north_east, 0);
  EXPECT_GT(south_east, 0);
  const ArraysOf first(get(at(model, "tiles/0/0/0"))), second(get(at(model, "tiles/0/1/0")));
  EXPECT_EQ(first.header["origin"][0].get<double>() + 256 * 10, second.header["origin"][0].get<double>());
  EXPECT_EQ(first.header["columns"], 257);  // neighbours share an edge
  EXPECT_TRUE(std::isnan(first.get<float>("heights", "f32")[2 * 257 + 3]));
  // Beyond a border are the neighbour's nodes, and beyond the raster none.
  const auto around = first.get<float>("around", "f32"), beside = second.get<float>("heights", "f32");
  const auto high = first.header["rows"].get<std::size_t>();
  ASSERT_EQ(around.size(), 2 * (257 + high));
  EXPECT_EQ(around[2 * 257 + high + 1], beside[second.header["columns"].get<std::size_t>() + 1]);
  EXPECT_TRUE(std::isnan(around[0]));
  EXPECT_TRUE(std::isnan(around[2 * 257 + 1]));

  for (const std::string which : {"2/0/0", "0/2/0", "0/0/1", "0/999999999/0"})
    EXPECT_EQ(get(at(model, "tiles/" + which)).status, 404) << which;
  for (const std::string which : {"0/0/-1", "0/0/4294967296", "a/0/0", "0/0"})
    EXPECT_EQ(get(at(model, "tiles/" + which)).status, 404) << which;
}

TEST_F(ModelOnRaster, HasTilesOfAStripNarrowerThanTheStride) {
  const Json model = model_of(raster_project(2000, 3));
  const Json levels = get(at(model, "tiles")).json()["levels"];
  EXPECT_EQ(levels.back(), Json::parse(R"({"stride": 8, "columns": 1, "rows": 1})"));
  const ArraysOf tile(get(at(model, "tiles/3/0/0")));
  EXPECT_EQ(tile.header["rows"], 2);
  EXPECT_EQ(tile.header["cell"], (Json{80.0, 20.0}));
}

TEST_F(ModelOnRaster, LeavesHolesOutOfTrianglesAndSections) {
  const std::string text = raster_project(8, 6);
  const Json model = model_of(text);
  const ArraysOf arrays(get(at(model, "mesh")));
  // Four of 35 cells have the node without data.
  EXPECT_EQ(arrays.get<std::uint32_t>("triangles", "u32").size(), 3 * 2 * (35 - 4U));
  for (const float x : arrays.get<float>("positions", "f32")) EXPECT_FALSE(std::isnan(x));

  const Json section = post(at(model, "section"), {{"line", {{5005, 9027}, {5075, 9027}}}}).json();
  const Model ours = built(text);
  const auto& raster = std::get<RasterSurface>(*ours.surface);
  int holes = 0;
  for (std::size_t k = 0; k < section["x_m"].size(); ++k) {
    const double x = section["x_m"][k];
    if (section["z_m"][k].is_null()) {
      ++holes;
      EXPECT_NEAR(x, 5025, 1e-9);  // from the node before the one without data
    } else if (x > 5005 && x < 5075 && (x < 5024 || x > 5046)) {
      EXPECT_NEAR(section["z_m"][k].get<double>(),
                  *raster.elevation(x - ours.frame.origin.x(), 9027 - ours.frame.origin.y()), 1e-4);
    }
  }
  EXPECT_EQ(holes, 1);
  EXPECT_EQ(get(at(model, "tiles")).json()["levels"].size(), 1U);
}

TEST_F(ModelOnRaster, SendsTilesInsteadOfMillionsOfTriangles) {
  const std::string text = raster_project(600, 600);
  const Json model = model_of(text);
  const Reply mesh = get(at(model, "mesh"));
  EXPECT_EQ(mesh.status, 404);
  EXPECT_EQ(mesh.problem(),
            "mesh: the raster has 358801 cells (only rasters up to 250000 are sent as triangles). Request its tiles");
  // Along this line the ground bends more often than a section may have points.
  Json zigzag = Json::array();
  for (int k = 0; k < 40; ++k) zigzag.push_back({k % 2 == 0 ? 5005 : 10995, 9010 + 100 * k});
  const Json section = post(at(model, "section"), {{"line", zigzag}}).json();
  EXPECT_LE(section["z_m"].size(), 5000U);
  EXPECT_GE(section["z_m"].size(), 4500U);
}

}  // namespace
}  // namespace talus

#endif
