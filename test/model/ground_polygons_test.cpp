// Grounds from polygons with an attribute, on rasters and meshes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include "support/dice.hpp"
#include "support/gis_project.hpp"
#include "talus/model/build_ground.hpp"

namespace talus::project {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;

const std::string terrain_and_ground = R"([terrain]
raster = "dem.tif"
[[material]]
name = "Rock"
[[material]]
name = "Scree"
[[material]]
name = "Meadow"
[[seeder]]
position = [1757050, 5917050]
height_above_m = 1
mass_kg = 1000
[ground]
default = "Meadow"
polygons = "ground.gpkg"
attribute = "kind"
)";

class GroundPolygons : public GisProject {
 protected:
  GroundPolygons() { make("dem.tif", mountain()); }
  /// The material at the centre of a cell, between four nodes, in metres from the corner of the raster.
  static std::uint32_t material_at(const Model& model, double x, double y) {
    const auto& surface = std::get<RasterSurface>(*model.surface);
    const Vec2 local = Vec2(west + x, south + y) - Vec2(model.frame.origin.xy());
    const auto column = static_cast<std::uint32_t>((local.x() - surface.grid().x0) / cell);
    const auto row = static_cast<std::uint32_t>((local.y() - surface.grid().y0) / cell);
    return model.ground.material_of(row * (columns - 1) + column).index;
  }
};

TEST_F(GroundPolygons, ACellHasTheMaterialAtItsCentre) {
  // The centres of the cells are at 5, 10, 15 ... m.
  layer("ground.gpkg", "kind", {{box(0, 0, 100.1, 200), "Rock"}, {box(100.1, 0, 300, 200), "Scree"}});
  const Model built = model(terrain_and_ground);
  EXPECT_EQ(warnings(), "");
  for (double x = 5; x < 297; x += 5) {
    for (double y = 5; y < 197; y += 5) EXPECT_EQ(material_at(built, x, y), x < 100.1 ? 0U : 1U) << x << ' ' << y;
  }
}

TEST_F(GroundPolygons, NumbersAreComparedAsNumbers) {
  {
    const GDALDatasetUniquePtr file(GetGDALDriverManager()
                                        ->GetDriverByName("ESRI Shapefile")
                                        ->Create(path("ground.shp").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    OGRSpatialReference crs;
    crs.importFromEPSG(2193);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer& made = *file->CreateLayer("ground", &crs, wkbPolygon, nullptr);
    OGRFieldDefn kind("kind", OFTReal);
    kind.SetWidth(10);
    kind.SetPrecision(3);
    ASSERT_EQ(made.CreateField(&kind), OGRERR_NONE);
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(made.GetLayerDefn()));
    feature->SetField("kind", 2.0);
    OGRGeometry* geometry = nullptr;
    ASSERT_EQ(OGRGeometryFactory::createFromWkt(box(0, 0, 300, 200).c_str(), nullptr, &geometry), OGRERR_NONE);
    feature->SetGeometryDirectly(geometry);
    ASSERT_EQ(made.CreateFeature(feature.get()), OGRERR_NONE);
  }
  std::string text = terrain_and_ground;
  text.replace(text.find("ground.gpkg"), 11, "ground.shp");
  for (const char* value : {"2", "2.0", "2.000"}) {
    const Model built = model(text + "values = { \"" + value + "\" = \"Scree\" }\n");
    EXPECT_EQ(material_at(built, 50, 50), 1U) << value;
  }
}

TEST_F(GroundPolygons, TextsAreNotComparedAsNumbers) {
  layer("ground.gpkg", "kind", {{box(0, 0, 300, 200), "1.10"}});
  EXPECT_THAT(refusal(terrain_and_ground + "values = { \"1.1\" = \"Scree\" }\n"), HasSubstr("that are not in values"));
}

TEST_F(GroundPolygons, ValuesMayBeMappedToMaterials) {
  layer("ground.gpkg", "kind", {{box(0, 0, 100, 200), "Fels"}, {box(100, 0, 300, 200), "Schutt, grob"}});
  const Model built =
      model(terrain_and_ground + "values = { Fels = \"Rock\", \"Schutt, grob\" = \"Scree\", Fles = \"Rock\" }\n");
  EXPECT_EQ(material_at(built, 50, 50), 0U);
  EXPECT_EQ(material_at(built, 150, 50), 1U);
  EXPECT_EQ(warnings(),
            "slope.toml: warning: [ground]: values has \"Fles\", which no polygon has (in kind of layer \"layer\")");
}

TEST_F(GroundPolygons, OverlapsAndGapsAreReportedAndTheLaterPolygonApplies) {
  layer("ground.gpkg", "kind",
        {{box(0, 0, 150, 200), "Rock"}, {box(0, 0, 20, 20), "Rock"}, {box(101, 0, 250, 100), "Scree"}});
  const Model built = model(terrain_and_ground);
  EXPECT_EQ(material_at(built, 100, 50), 0U);
  EXPECT_EQ(material_at(built, 105, 50), 1U);
  EXPECT_EQ(material_at(built, 105, 150), 0U);
  EXPECT_EQ(material_at(built, 280, 50), 2U);
  // 59 by 39 cells of 25 m2. Both contain x = 105 to 145 and y = 5 to 95, 9 by 19 cells. Neither contains x = 150 to
  // 295 above y = 100, 30 by 20 cells, and x = 250 to 295 below, 10 by 19 cells.
  EXPECT_EQ(warnings(),
            "slope.toml: warning: [ground]: polygons of different materials overlap on 171 cells of the terrain (4275 "
            "m2, 7.4 % of it; at (1757105, 5917005) features 1 and 3). The later one in the file applies\n"
            "slope.toml: warning: [ground]: 790 cells of the terrain are in no polygon (19750 m2, 34 % of it). They "
            "are given the default material, \"Meadow\"");
}

TEST_F(GroundPolygons, PolygonsMayHaveHolesAndPartsAndBeInDegrees) {
  OGRSpatialReference metres, degrees;
  metres.importFromEPSG(2193);
  degrees.importFromEPSG(4326);
  metres.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  OGRGeometry* read = nullptr;
  const std::string text = fmt::format(
      "MULTIPOLYGON ((({0} {1}, {2} {1}, {2} {3}, {0} {3}, {0} {1}), ({4} {5}, {6} {5}, {6} {7}, {4} {7}, {4} {5})), "
      "(({8} {1}, {9} {1}, {9} {3}, {8} {3}, {8} {1})))",
      west + 21, south + 21, west + 99, south + 179, west + 41, south + 41, west + 79, south + 159, west + 121,
      west + 159);
  ASSERT_EQ(OGRGeometryFactory::createFromWkt(text.c_str(), &metres, &read), OGRERR_NONE);
  const std::unique_ptr<OGRGeometry> geometry(read);
  ASSERT_EQ(geometry->transformTo(&degrees), OGRERR_NONE);
  char* in_degrees = nullptr;
  geometry->exportToWkt(&in_degrees);
  layer("ground.gpkg", "kind", {{in_degrees, "Rock"}}, "EPSG:4326");
  CPLFree(in_degrees);
  const Model built = model(terrain_and_ground);
  for (double x = 5; x < 297; x += 5) {
    for (double y = 5; y < 197; y += 5) {
      const bool outer = x > 21 && x < 99 && y > 21 && y<179, hole = x> 41 && x < 79 && y > 41 && y < 159;
      const bool other = x > 121 && x < 159 && y > 21 && y < 179;
      EXPECT_EQ(material_at(built, x, y), (outer && !hole) || other ? 0U : 2U) << x << ' ' << y;
    }
  }
  EXPECT_THAT(warnings(), HasSubstr("\"Scree\" is not used (no polygon has this material, and it is not the default)"));
}

// On a mesh, each triangle has the material at its centre, as found one by one.
TEST_F(GroundPolygons, ATriangleHasTheMaterialAtItsCentre) {
  Dice dice(3);
  std::string vertices, triangles;
  constexpr int n = 12;
  std::vector<Vec2> place;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      place.emplace_back(west + 10 * i + dice.between(-3, 3), south + 10 * j + dice.between(-3, 3));
      vertices += fmt::format("[{:.6f}, {:.6f}, {:.3f}],", place.back().x(), place.back().y(), dice.between(0, 20));
    }
  }
  std::vector<Vec2> centres;
  double area = 0;
  std::size_t rocky = 0;
  double rocky_area = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      for (const auto& t : {std::array{a, a + 1, a + n + 2}, std::array{a, a + n + 2, a + n + 1}}) {
        triangles += fmt::format("[{}, {}, {}],", t[0], t[1], t[2]);
        const auto at = [&](int k) { return place[static_cast<std::size_t>(k)]; };
        const Vec2 centre = (at(t[0]) + at(t[1]) + at(t[2])) / 3, e = at(t[1]) - at(t[0]), f = at(t[2]) - at(t[0]);
        centres.push_back(centre);
        const double size = 0.5 * std::abs(e.x() * f.y() - e.y() * f.x());
        area += size;
        const Vec2 from = centre - Vec2(west, south);
        if (from.x() + from.y() < 101.2345) {
          ++rocky;
          rocky_area += size;
        }
      }
    }
  }
  layer("ground.gpkg", "kind",
        {{fmt::format("POLYGON (({0} {1}, {2} {1}, {0} {3}, {0} {1}))", west - 500, south - 500, west + 601.2345,
                      south + 601.2345),
          "Rock"}});
  std::string text = terrain_and_ground;
  text.replace(text.find("raster = \"dem.tif\""), 18, "vertices = [" + vertices + "]\ntriangles = [" + triangles + "]");
  const Model built = model(text);
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const Vec2 from = centres[k] - Vec2(west, south);
    EXPECT_EQ(built.ground.material_of(static_cast<std::uint32_t>(k)).index, from.x() + from.y() < 101.2345 ? 0U : 2U);
  }
  EXPECT_THAT(warnings(),
              HasSubstr(fmt::format("{} triangles of the terrain are in no polygon ({:.6g} m2, {:.2g} % of it)",
                                    centres.size() - rocky, area - rocky_area, 100 * (1 - rocky_area / area))));
}

TEST_F(GroundPolygons, HolesOfTheTerrainAreNeitherGapsNorOverlaps) {
  RasterSpec holed = mountain();
  for (int row = 0; row < rows; ++row) {
    for (int column = 30; column < columns; ++column)
      holed.cells[static_cast<std::size_t>(row * columns + column)] = -9999;
  }
  make("dem.tif", holed);
  layer("ground.gpkg", "kind", {{box(0, 0, 200, 200), "Rock"}, {box(150, 0, 200, 200), "Scree"}});
  static_cast<void>(model(terrain_and_ground));
  EXPECT_EQ(warnings(), "");
}

TEST_F(GroundPolygons, ValuesWithoutAMaterialAreRefused) {
  layer("ground.gpkg", "kind",
        {{box(0, 0, 50, 50), "Rocks"},
         {box(50, 0, 90, 50), "Rocks"},
         {box(0, 50, 50, 90), "Bog"},
         {box(9, 90, 50, 99), ""}});
  EXPECT_EQ(refusal(terrain_and_ground),
            "slope.toml:15: [ground]: 1 of 4 polygons have no kind (feature 4 of polygons \"ground.gpkg\"). Give each "
            "a value, or remove it from the file\n"
            "slope.toml:15: [ground]: polygons \"ground.gpkg\" has values of kind that are not materials (\"Bog\" in "
            "1, \"Rocks\" in 2 of 4 polygons). Assign a material: values = { \"Bog\" = \"Rock\" }");
  layer("ground.gpkg", "kind", {{box(0, 0, 50, 50), "Rocks"}});
  EXPECT_EQ(refusal(terrain_and_ground),
            "slope.toml:15: [ground]: polygons \"ground.gpkg\" has values of kind that are not materials (\"Rocks\" in "
            "1 of 1 polygons). Did you mean \"Rock\" instead of \"Rocks\"?");
  EXPECT_EQ(refusal(terrain_and_ground + "values = { Moor = \"Meadow\" }\n"),
            "slope.toml:15: [ground]: polygons \"ground.gpkg\" has values of kind that are not in values (\"Rocks\" in "
            "1 of 1 polygons). Add \"Rocks\" = \"...\" to values");
}

TEST_F(GroundPolygons, UnsuitableFilesAreRefused) {
  layer("ground.gpkg", "kind", {{box(9000, 0, 9050, 50), "Rock"}});
  EXPECT_EQ(refusal(terrain_and_ground),
            "slope.toml:15: [ground]: polygons \"ground.gpkg\" do not reach the terrain (they lie within x = 1766000 "
            "to 1766050, y = 5917000 to 5917050; the terrain within x = 1757002.5 to 1757297.5, y = 5917002.5 to "
            "5917197.5). Check their extent and coordinate system with ogrinfo");
  layer("ground.gpkg", "kind", {{box(0, 0, 50, 50), "Rock"}, {box(9000, 0, 9050, 50), "Rock"}});
  static_cast<void>(model(terrain_and_ground));
  EXPECT_THAT(warnings(),
              HasSubstr("slope.toml:15: warning: [ground]: 1 of 2 polygons do not reach the terrain (polygons "
                        "\"ground.gpkg\" covers more than is needed, or some polygons are misplaced)"));
  layer("ground.gpkg", "sort", {{box(0, 0, 50, 50), "Rock"}});
  EXPECT_EQ(
      refusal(terrain_and_ground),
      "slope.toml:15: [ground]: polygons ground.gpkg: layer \"layer\" has no attribute \"kind\" (it has \"sort\")");
  EXPECT_EQ(refusal(terrain_and_ground + "layer = \"leyer\"\n"),
            "slope.toml:15: [ground]: polygons ground.gpkg: has no layer \"leyer\" (it has \"layer\"). Did you mean "
            "\"layer\"?");
  layer("ground.gpkg", "kind", {{"LINESTRING (0 0, 1 1)", "Rock"}});
  EXPECT_EQ(refusal(terrain_and_ground),
            "slope.toml:15: [ground]: polygons ground.gpkg: feature 1 is a line (expected polygons)");
  std::filesystem::remove(path("ground.gpkg"));
  EXPECT_EQ(refusal(terrain_and_ground),
            "slope.toml:15: [ground]: polygons is \"ground.gpkg\" (there is no such file). The path is relative to the "
            "project file");
  std::string without = terrain_and_ground;
  without.erase(without.find("attribute"));
  layer("ground.gpkg", "kind", {{box(0, 0, 50, 50), "Rock"}});
  EXPECT_EQ(refusal(without),
            "slope.toml:15: [ground]: attribute is missing (the materials of the polygons are not given). Write "
            "attribute = \"...\"; ogrinfo -so lists the attributes");
  EXPECT_EQ(refusal(terrain_and_ground + "values = { Fels = \"Rok\" }\n"),
            "slope.toml:17: [ground]: values.Fels is \"Rok\" (no material has this name; the project has \"Rock\", "
            "\"Scree\", \"Meadow\"). Did you mean \"Rock\"?");
}

// As many polygons and triangles as on a map sheet.
TEST_F(GroundPolygons, TenThousandPolygonsAndHalfAMillionTriangles) {
  constexpr int n = 500, sheets = 100;
  BuiltTerrain terrain;
  std::vector<Vec3> corners{{0, 0, 0}, {n, 0, 0}, {n, n, 0}, {0, n, 0}};
  const std::vector<TriangleMesh::Corners> both{{0, 1, 2}, {0, 2, 3}};
  const std::vector<TriangleMesh::Corners> beyond(
      2, {TriangleMesh::no_neighbour, TriangleMesh::no_neighbour, TriangleMesh::no_neighbour});
  terrain.surface = TriangleMesh(corners, both, beyond);
  Dice dice(1);
  for (int k = 0; k < 2 * n * n; ++k) {
    terrain.facet_centres.emplace_back(dice.between(0, n), dice.between(0, n));
    terrain.facet_areas.push_back(0.5);
  }
  std::vector<WrittenFeature> squares;
  constexpr double side = double(n) / sheets;
  for (int j = 0; j < sheets; ++j) {
    for (int i = 0; i < sheets; ++i) {
      squares.emplace_back(fmt::format("POLYGON (({0} {1}, {2} {1}, {2} {3}, {0} {3}, {0} {1}))", i * side, j * side,
                                       (i + 1) * side, (j + 1) * side),
                           (i + j) % 2 == 0 ? "Rock" : "Scree");
    }
  }
  layer("ground.gpkg", "kind", squares, "");
  Project project;
  project.file = path("slope.toml");
  project.materials.resize(2);
  project.materials[0].name = "Rock";
  project.materials[1].name = "Scree";
  project.ground.default_material = "Rock";
  project.ground.polygons = "ground.gpkg";
  project.ground.attribute = "kind";
  Problems problems, warnings;
  const talus::Ground ground = build_ground(project, terrain, problems, warnings);
  EXPECT_EQ(problems.text(), "");
  EXPECT_EQ(warnings.text(), "");
  for (std::uint32_t k = 0; k < terrain.facet_centres.size(); ++k) {
    const Vec2& p = terrain.facet_centres[k];
    ASSERT_EQ(ground.material_of(k).index, static_cast<std::uint32_t>(int(p.x() / side) + int(p.y() / side)) % 2);
  }
}

}  // namespace
}  // namespace talus::project

#endif
