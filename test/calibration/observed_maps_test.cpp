// Observations from maps: places with attributes, and zones as polygons.
#ifdef TALUS_HAS_GDAL

#include <gtest/gtest.h>

#include <string>

#include "support/input_folder.hpp"
#include "support/projects.hpp"
#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {
namespace {

using testing_tools::replaced;

const std::string wide_scree = R"(
[terrain]
section = [[0, 0], [40, -40], [70, -55], [300, -60]]
width_m = 100
[[material]]
name = "Scree"
friction_angle_deg = 30
roughness_deg = 5
[[seeder]]
name = "Left"
type = "point"
position = [1, 80, 3]
mass_kg = 300
rocks = 30
[[seeder]]
name = "Right"
type = "point"
position = [1, 20, 3]
mass_kg = 300
rocks = 30
)";

const std::string map_study = R"(
rocks = 60
draws = 60
[[site]]
project = "slope.toml"
[[observations]]
stops = "seen.geojson"
[[parameter]]
path = "material.Scree.friction_angle_deg"
range = [20, 40]
)";

class ObservedMaps : public testing_tools::InputFolder {
 protected:
  ObservedMaps() {
    write("slope.toml", wide_scree);
    write("study.toml", map_study);
  }
  /// Without a coordinate system of its own.
  void write_map(const std::string& features) const {
    write("seen.geojson", R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name":
        "urn:ogc:def:crs:EPSG::31287"}}, "features": [)" +
                              features + "]}");
  }
  static std::string feature(const std::string& properties, const std::string& geometry) {
    return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": {"type": )" + geometry + "}}";
  }
  PreparedStudy prepared() {
    warnings_ = {};
    return {read_study(path("study.toml")).study, nullptr, warnings_};
  }
};

TEST_F(ObservedMaps, NameReleasesAsAttributes) {
  write_map(feature(R"("release": "Right", "mass_kg": 310)", R"("Point", "coordinates": [80, 25])") + "," +
            feature(R"("release": "Left", "mass_kg": 290)", R"("Point", "coordinates": [85, 70])"));
  const PreparedStudy study = prepared();
  const ObservedGroup& group = study.groups().front();
  EXPECT_EQ(group.releases.names, (std::vector<std::string>{"Right", "Left"}));
  // Lateral positions are from the line through the own release: here 5 m to the left, and 10 m to the right.
  EXPECT_NEAR(group.sample.rows(0, 1) - group.sample.rows(1, 1), 15, 0.5);
  EXPECT_EQ(warnings().find("masses"), std::string::npos) << warnings();
}

TEST_F(ObservedMaps, HaveZonesAsPolygons) {
  write("study.toml", replaced(map_study, "stops = ", "zones = "));
  const std::string near = R"("Polygon", "coordinates": [[[0, 0], [90, 0], [90, 100], [0, 100], [0, 0]]])";
  const std::string far = R"("Polygon", "coordinates": [[[90, 0], [290, 0], [290, 100], [90, 100], [90, 0]]])";
  write_map(feature(R"("zone": "near", "volume_m3": 4.5)", near) + "," +
            feature(R"("zone": "far", "volume_m3": 1.5)", far));
  const PreparedStudy study = prepared();
  const ObservedGroup& group = study.groups().front();
  EXPECT_EQ(group.zones.list[1].name, "far");
  EXPECT_NEAR(zone_shares(group.zones, group.sample)[0], 0.75, 1e-12);
  EXPECT_EQ(group.zones.of({100, 50}), 1U);
  EXPECT_EQ(group.zones.of({20, 50}), 0U);
  write_map(feature(R"("zone": "near")", near));
  EXPECT_NE(refusal_of([&] { static_cast<void>(prepared()); }).find("there is no column volume_m3, count or share"),
            std::string::npos);
}

TEST_F(ObservedMaps, RefusePlacesInAnotherSystem) {
  write_map(feature(R"("release": "Right")", R"("Point", "coordinates": [380080, 5200025])"));
  EXPECT_EQ(refusal_of([&] { static_cast<void>(prepared()); }),
            "seen.geojson: feature 0: (380080, 5200025) is off the terrain (on plan the terrain lies within x = 0 to "
            "300, y = 0 to 100)\n"
            "seen.geojson: 1 of 1 observations is off the terrain (they may be in another coordinate system). Check "
            "the coordinate systems of the file and of the terrain");
}

}  // namespace
}  // namespace talus::calibration

#endif
