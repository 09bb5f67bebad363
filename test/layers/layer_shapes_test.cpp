#include "talus/layers/layer_shapes.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include "support/rasters.hpp"
#include "support/vectors.hpp"

namespace talus {
namespace {

using namespace testing_tools;

class LayerShapesTest : public InputFolder {
 protected:
  [[nodiscard]] LayerShapes shapes(const std::string& name, const LayerRequest& request = {}) {
    warnings_ = Problems{};
    return shapes_of_layer(path(name), request, terrain_, warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& name) {
    return refusal_of([&] { static_cast<void>(shapes(name)); });
  }

  const TerrainOnPlan terrain_{{{400000, 300000}, {400400, 300300}}, wkt("EPSG:31287")};
};

TEST_F(LayerShapesTest, HaveNamesAndKinds) {
  add_layer(path("map.gpkg"), "map", "EPSG:31287", "Name",
            {{"LINESTRING (400010 300010, 400090 300050)", "Road"},
             {"POLYGON ((400100 300100, 400120 300100, 400110 300120, 400100 300100))", ""},
             {"POINT (400200 300200)", "Hut"},
             {"LINESTRING (500000 300000, 500100 300000)", "Elsewhere"}});
  const LayerShapes found = shapes("map.gpkg");
  ASSERT_EQ(found.shapes.size(), 3U);
  EXPECT_THAT(found.names, ::testing::ElementsAre("", "Road", "Hut"));
  EXPECT_EQ(found.shapes[0].kind, ShapeKind::line);
  EXPECT_EQ(found.shapes[0].name, 1U);
  EXPECT_EQ(found.shapes[1].points.size(), 4U);
  EXPECT_EQ(found.shapes[1].points.front(), found.shapes[1].points.back());
  EXPECT_EQ(found.shapes[2].kind, ShapeKind::point);
}

TEST_F(LayerShapesTest, OfAGeoJsonAreInDegreesAndTransformed) {
  write("road.geojson",
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"name": "Road"}, "geometry":
           {"type": "LineString", "coordinates": [[13.33333, 47.5], [13.335, 47.5]]}}]})");
  const TerrainOnPlan around{{{399000, 399000}, {401000, 401000}}, wkt("EPSG:31287")};
  Problems doubts;
  const LayerShapes found = shapes_of_layer(path("road.geojson"), {}, around, doubts);
  ASSERT_EQ(found.shapes.size(), 1U);
  // The origin of Austria Lambert is at 13 deg 20' E and 47.5 deg N, of another datum: some hundred metres.
  EXPECT_NEAR(found.shapes[0].points[0].x(), 400000, 200);
  EXPECT_NEAR(found.shapes[0].points[0].y(), 400000, 200);
  EXPECT_NEAR((found.shapes[0].points[1] - found.shapes[0].points[0]).norm(), 125.7, 1);
}

TEST_F(LayerShapesTest, ElsewhereAreRefused) {
  add_layer(path("far.gpkg"), "far", "EPSG:31287", "name", {{"LINESTRING (500000 300000, 500100 300050)", ""}});
  EXPECT_EQ(refusal("far.gpkg"),
            "far.gpkg: does not lie over the terrain (it covers x 500000 to 500100, y 300000 to 300050 in "
            "EPSG:31287; the terrain x "
            "400000 to 400400, y 300000 to 300300). Is its coordinate system the right one?");
}

TEST_F(LayerShapesTest, WithTooManyPointsAreSimplified) {
  std::string wave = "LINESTRING (";
  for (int k = 0; k <= 1000; ++k)
    wave += fmt::format("{}{} {:.4f}", k == 0 ? "" : ", ", 400000 + 0.4 * k, 300150 + 0.02 * (k % 2));
  add_layer(path("wave.gpkg"), "wave", "EPSG:31287", "name",
            {{wave + ")", ""}, {"LINESTRING (400000 300000, 400400 300300)", ""}});
  EXPECT_EQ(shapes("wave.gpkg").points(), 1003U);
  EXPECT_EQ(warnings(), "");
  const LayerShapes found = shapes("wave.gpkg", {.most_points = 100});
  EXPECT_LE(found.points(), 100U);
  ASSERT_EQ(found.shapes.size(), 2U);
  for (const Vec2& p : found.shapes[0].points) EXPECT_NEAR(p.y(), 300150, 0.03);
  EXPECT_EQ(
      warnings(),
      "wave.gpkg: warning: has 1003 points over the terrain (at most 100 are drawn: lines are simplified by up to "
      "0.02 m)");
  EXPECT_EQ(shapes("wave.gpkg", {.most_points = 3}).shapes.size(), 1U);
}

TEST_F(LayerShapesTest, AreFoundNearAPlace) {
  add_layer(
      path("map.gpkg"), "map", "EPSG:31287", "name",
      {{"LINESTRING (400010 300010, 400090 300010)", "Road"}, {"LINESTRING (400010 300030, 400090 300030)", "Rail"}});
  const LayerShapes found = shapes("map.gpkg");
  const LayerShape* const near = found.nearest({400050, 300024}, 10);
  ASSERT_NE(near, nullptr);
  EXPECT_EQ(found.names[near->name], "Rail");
  EXPECT_DOUBLE_EQ(near->distance_to({400050, 300024}), 6);
  EXPECT_EQ(found.nearest({400050, 300050}, 10), nullptr);
}

}  // namespace
}  // namespace talus

#endif
