// Seeders from points of a GIS: coordinate systems, heights, attributes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include "support/gis_project.hpp"
#include "talus/campaign/simulate.hpp"

namespace talus::project {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string project_head = R"([terrain]
raster = "dem.tif"
[[material]]
name = "Rock"
[[seeder]]
name = "Scars"
type = "table"
)";

class GisReleaseTable : public GisProject {
 protected:
  GisReleaseTable() { make("dem.tif", mountain()); }

  static std::string at(double x, double y) { return fmt::format("POINT ({} {})", west + x, south + y); }

  /// Writes points with numbers as attributes to a file of this driver.
  void write_points(const std::string& file, const char* driver_name, const std::vector<std::string>& attributes,
                    const std::vector<std::pair<std::string, std::vector<double>>>& points) {
    const GdalMessages gdal(GdalFiles::in_folder(folder_));
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
    ASSERT_NE(driver, nullptr);
    const GDALDatasetUniquePtr dataset(driver->Create(path(file).c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    ASSERT_TRUE(dataset);
    OGRSpatialReference crs;
    ASSERT_EQ(crs.importFromEPSG(2193), OGRERR_NONE);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRLayer* made = dataset->CreateLayer("scars", &crs, wkbPoint, nullptr);
    ASSERT_NE(made, nullptr);
    for (const std::string& attribute : attributes) {
      OGRFieldDefn field(attribute.c_str(), OFTReal);
      ASSERT_EQ(made->CreateField(&field), OGRERR_NONE);
    }
    for (const auto& [text, values] : points) {
      const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(made->GetLayerDefn()));
      for (std::size_t k = 0; k < values.size(); ++k) feature->SetField(static_cast<int>(k), values[k]);
      OGRGeometry* geometry = nullptr;
      ASSERT_EQ(OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &geometry), OGRERR_NONE);
      feature->SetGeometryDirectly(geometry);
      ASSERT_EQ(made->CreateFeature(feature.get()), OGRERR_NONE);
    }
  }

  static Motion start(const Model& model, std::uint64_t rock) {
    Simulator simulator(model);
    static_cast<void>(simulator.simulate(rock, true));
    Motion motion = simulator.log().rows.front().motion;
    motion.position = model.frame.global_from_local(motion.position);
    return motion;
  }
};

TEST_F(GisReleaseTable, PointsHaveAttributes) {
  write_points("scars.gpkg", "GPKG", {"mass_kg", "speed_m_s", "azimuth_deg", "aspect"},
               {{at(150, 50), {250, 3, 270, 1}}, {at(200, 60), {500, 4, 0, 2}}});
  const Model built = model(project_head + "table = \"scars.gpkg\"\n");
  EXPECT_EQ(warnings(), "");
  ASSERT_EQ(built.rocks(), 2U);
  EXPECT_EQ(Simulator(built).simulate(1, false).body.mass, 500);
  EXPECT_LT((start(built, 0).velocity - Vec3(-3, 0, 0)).norm(), 1e-12);
  EXPECT_LT((start(built, 1).velocity - Vec3(0, 4, 0)).norm(), 1e-12);
  const Vec3 place = start(built, 0).position;
  EXPECT_NEAR(place.x(), west + 150, 1e-9);
  EXPECT_NEAR(place.z(), 150 * 150 / 200.0, 0.1);  // on the surface
  EXPECT_EQ(built.seeder_report,
            "seeder \"Scars\": 2 rows of \"scars.gpkg\", columns mass_kg, speed_m_s, azimuth_deg (not used: aspect); 2 "
            "rocks");
}

TEST_F(GisReleaseTable, PointsMayBeInAnotherCoordinateSystem) {
  OGRSpatialReference metres, degrees;
  metres.importFromEPSG(2193);
  degrees.importFromEPSG(4326);
  for (auto* crs : {&metres, &degrees}) crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_degrees(OGRCreateCoordinateTransformation(&metres, &degrees));
  double x = west + 150, y = south + 50;
  ASSERT_TRUE(to_degrees->Transform(1, &x, &y));
  layer("scars.gpkg", "name", {{fmt::format("POINT ({:.12f} {:.12f})", x, y), "north scar"}}, "EPSG:4326");
  const Model built = model(project_head + "table = \"scars.gpkg\"\nmass_kg = 100\n");
  const Vec3 place = start(built, 0).position;
  EXPECT_NEAR(place.x(), west + 150, 1e-3);
  EXPECT_NEAR(place.y(), south + 50, 1e-3);
  EXPECT_THAT(std::get<ReleaseTable>(*built.seeders[0].where).names, ElementsAre("north scar"));
}

TEST_F(GisReleaseTable, PointsMayHaveHeights) {
  layer("scars.gpkg", "name", {{fmt::format("POINT Z ({} {} 130)", west + 150, south + 50), "a"}});
  const std::string text = project_head + "table = \"scars.gpkg\"\nmass_kg = 100\n";
  EXPECT_NEAR(start(model(text), 0).position.z(), 130, 1e-9);
  EXPECT_NEAR(start(model(text + "height_above_m = 2\n"), 0).position.z(), 114.5, 0.1);
}

TEST_F(GisReleaseTable, ShapefilesCutNames) {
  write_points("scars.shp", "ESRI Shapefile", {"density_kg", "horizontal", "mass_kg"}, {{at(150, 50), {2500, 6, 10}}});
  const Model built = model(project_head + "table = \"scars.shp\"\n");
  EXPECT_EQ(start(built, 0).velocity, Vec3(6, 0, 0));
  EXPECT_EQ(Simulator(built).simulate(0, false).body.radius, sphere_of_mass(10, 2500).radius);
}

TEST_F(GisReleaseTable, ReportsTheFeaturesWithProblems) {
  write_points("scars.gpkg", "GPKG", {"mass_kg"}, {{at(150, 50), {-1}}, {at(150, 60), {5}}, {at(150, 60), {0}}});
  EXPECT_EQ(refusal(project_head + "table = \"scars.gpkg\"\n"),
            "slope.toml:8: seeder \"Scars\": table scars.gpkg: feature 1: mass_kg is -1 (a rock has mass; expected "
            "1e-9 to 1e12)\n"
            "slope.toml:8: seeder \"Scars\": table scars.gpkg: feature 3: mass_kg is 0 (a rock has mass; expected 1e-9 "
            "to 1e12)");
  layer("cliffs.gpkg", "name", {{box(100, 50, 120, 70), ""}});
  EXPECT_THAT(refusal(project_head + "table = \"cliffs.gpkg\"\nmass_kg = 100\n"),
              HasSubstr("feature 1 is a polygon (expected points)"));
  layer("off.gpkg", "name", {{at(-20, 50), ""}});
  EXPECT_THAT(refusal(project_head + "table = \"off.gpkg\"\nmass_kg = 100\n"),
              HasSubstr("feature 1: (1756980, 5917050) is off the terrain"));
}

}  // namespace
}  // namespace talus::project

#endif
