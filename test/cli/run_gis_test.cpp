// A whole run on raster terrain with a coordinate system: the results as a geographic information system reads them.

#ifdef TALUS_HAS_GDAL

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <ogrsf_frmts.h>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/rasters.hpp"

namespace talus::test {
namespace {

using testing_tools::RasterFolder;
using testing_tools::RasterSpec;

class RunGis : public RasterFolder {
 protected:
  RunGis() {
    RasterSpec spec;
    spec.columns = 60;
    spec.rows = 40;
    spec.cells.clear();
    for (int j = 0; j < spec.rows; ++j) {
      for (int i = 0; i < spec.columns; ++i) {
        spec.cells.push_back(500 + 6.0 * std::max(0, 45 - i) + 2 * std::sin(0.9 * i) * std::cos(0.7 * j));
      }
    }
    spec.geotransform =
        std::array<double, 6>{400'003, 10, 0, 300'407, 0, -8};  // cells not square, origin not a multiple of them
    make("slope.tif", spec);
    write("slope.toml", R"(
[terrain]
raster = "slope.tif"
[[material]]
name = "Rock"
normal_restitution = { mean = 0.45, distribution = "normal", std_dev = 0.1 }
friction_angle_deg = 25
roughness_deg = 6
[[seeder]]
name = "upper"
type = "line"
points = [[400030, 300200, "surface"], [400040, 300340, "surface"]]
height_above_m = 3
rocks = 400
mass_kg = { mean = 900, distribution = "exponential", rel_min = 800, rel_max = 5000 }
horizontal_velocity_m_s = 4
[[seeder]]
name = "lower"
position = [400150, 300250, "surface"]
height_above_m = 3
rocks = 200
mass_kg = 500
horizontal_velocity_m_s = 4
[[barrier]]
name = "Net"
line = [[400200, 300110], [400220, 300390]]
height_m = 4
inclination_deg = 5
[output]
raster_cell_m = "terrain"
paths = 100
report = false
vtk = true
)");
  }

  void run(const std::string& folder, const std::string& settings = "") const {
    const Said said =
        talus_says("run " + path("slope.toml").string() + " -q " + settings + " -o " + path(folder).string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
  }
  [[nodiscard]] std::string bytes(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
  }
};

TEST_F(RunGis, MapsLieOnTheCellsOfTheTerrain) {
  run("out");
  const GDALDatasetUniquePtr map(GDALDataset::Open(path("out/maps/passages.tif").c_str()));
  ASSERT_TRUE(map);
  std::array<double, 6> t{};
  map->GetGeoTransform(t.data());
  EXPECT_EQ(t[1], 10);
  EXPECT_EQ(t[5], -8);
  EXPECT_EQ(std::remainder(t[0] - 400'003, 10), 0);
  EXPECT_EQ(std::remainder(t[3] - 300'407, 8), 0);
  EXPECT_GE(t[0], 400'003);
  EXPECT_LE(t[0] + t[1] * map->GetRasterXSize(), 400'003 + 600);
  EXPECT_STREQ(map->GetSpatialRef()->GetAuthorityCode(nullptr), "31287");
  // With any other cell size the borders are at multiples of it.
  run("multiples", "--set output.raster_cell_m=10");
  const GDALDatasetUniquePtr other(GDALDataset::Open(path("multiples/maps/passages.tif").c_str()));
  other->GetGeoTransform(t.data());
  EXPECT_EQ(std::remainder(t[0], 10), 0);
}

// Each rock of a seeder with several polygons or lines has the source of the one in which it starts.
TEST_F(RunGis, RocksHaveTheSourceOfTheirReleasePlace) {
  const auto feature = [](const char* name, const char* type, const char* places) {
    return fmt::format(
        R"({{"type":"Feature","properties":{{"name":"{}"}},"geometry":{{"type":"{}","coordinates":{}}}}})", name, type,
        places);
  };
  const auto collection = [](const std::string& first, const std::string& second) {
    return fmt::format(R"({{"type":"FeatureCollection","crs":{{"type":"name","properties":{{"name":"EPSG:31287"}}}},)"
                       R"("features":[{},{}]}})",
                       first, second);
  };
  write("polygons.geojson", collection(feature("south", "Polygon",
                                               "[[[400030,300120],[400060,300120],[400060,300160],[400030,300160],"
                                               "[400030,300120]]]"),
                                       feature("north", "Polygon",
                                               "[[[400030,300250],[400060,300250],[400060,300380],[400030,300380],"
                                               "[400030,300250]]]")));
  write("lines.geojson", collection(feature("south", "LineString", "[[400040,300120],[400040,300160]]"),
                                    feature("north", "LineString", "[[400040,300250],[400040,300380]]")));
  for (const std::string kind : {"polygon", "line"}) {
    write("slope.toml", "[terrain]\nraster = \"slope.tif\"\n[[material]]\nname = \"Rock\"\n[[seeder]]\ntype = \"" +
                            kind + "\"\n" + kind + "s = \"" + kind +
                            "s.geojson\"\nsource_attribute = \"name\"\nheight_above_m = 3\nrocks = 300\n"
                            "mass_kg = 500\n[output]\nreport = false\nmaps = false\n");
    run(kind);
    const GDALDatasetUniquePtr file(GDALDataset::Open(path(kind + "/results.gpkg").c_str(), GDAL_OF_VECTOR));
    ASSERT_TRUE(file);
    int south = 0, rocks = 0;
    for (const auto& release : *file->GetLayerByName("releases")) {
      const bool is_south = release->GetGeometryRef()->toPoint()->getY() < 300'200;
      EXPECT_STREQ(release->GetFieldAsString("source"), is_south ? "south" : "north");
      south += is_south ? 1 : 0;
      ++rocks;
    }
    EXPECT_EQ(rocks, 300);
    EXPECT_GT(south, 30);
    EXPECT_LT(south, 150);
  }
}

TEST_F(RunGis, TheGeoPackageAgreesWithTheTables) {
  run("out");
  const GDALDatasetUniquePtr file(GDALDataset::Open(path("out/results.gpkg").c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(file);
  OGRLayer &endpoints = *file->GetLayerByName("endpoints"), &paths = *file->GetLayerByName("paths"),
           &barriers = *file->GetLayerByName("barriers"), &releases = *file->GetLayerByName("releases");
  EXPECT_EQ(endpoints.GetFeatureCount(), 600);
  EXPECT_EQ(paths.GetFeatureCount(), 100);
  EXPECT_EQ(releases.GetFeatureCount(), 100);
  EXPECT_STREQ(paths.GetSpatialRef()->GetAuthorityCode(nullptr), "31287");

  // A path begins at the release and ends at the end point.
  std::map<std::int64_t, std::pair<OGRPoint, double>> ends;
  for (const auto& feature : endpoints) {
    ends.emplace(feature->GetFieldAsInteger64("rock"),
                 std::pair(*feature->GetGeometryRef()->toPoint(), feature->GetFieldAsDouble("max_ke_J")));
    EXPECT_STREQ(feature->GetFieldAsString("source"), feature->GetFieldAsInteger64("rock") < 400 ? "upper" : "lower");
  }
  for (const auto& feature : paths) {
    const OGRLineString& line = *feature->GetGeometryRef()->toLineString();
    const auto& [end, max_ke] = ends.at(feature->GetFieldAsInteger64("rock"));
    const int last = line.getNumPoints() - 1;
    EXPECT_EQ(line.getX(last), end.getX());
    EXPECT_EQ(line.getZ(last), end.getZ());
    EXPECT_EQ(feature->GetFieldAsDouble("max_ke_J"), max_ke);
    EXPECT_LE(line.getX(0), 400'150);
  }

  const auto summary = nlohmann::json::parse(bytes("out/summary.json"));
  const auto& net = summary["barriers"][0];
  const OGRFeatureUniquePtr barrier(barriers.GetNextFeature());
  EXPECT_GT(net["hits"].get<int>(), 50);
  EXPECT_EQ(barrier->GetFieldAsInteger64("hits"), net["hits"].get<std::int64_t>());
  EXPECT_EQ(barrier->GetFieldAsDouble("ke_total_p95_J"), net["statistics"]["ke_total_J"]["percentiles"]["95"]);
  EXPECT_EQ(barrier->GetFieldAsDouble("impact_height_max_m"), net["statistics"]["impact_height_m"]["maximum"]);
  EXPECT_EQ(barrier->GetFieldAsDouble("inclination_deg"), 5);
  EXPECT_FALSE(barrier->IsFieldSetAndNotNull(barrier->GetFieldIndex("capacity_kJ")));  // unlimited
  // The foot follows the ground: it has a point on each facet border that it crosses.
  const OGRLineString& foot = *barrier->GetGeometryRef()->toLineString();
  EXPECT_GT(foot.getNumPoints(), 35);
  EXPECT_EQ(foot.getX(0), 400'200);
  EXPECT_EQ(foot.getY(foot.getNumPoints() - 1), 300'390);
  EXPECT_EQ(static_cast<std::size_t>(foot.getNumPoints()), net["line_xyz"].size());
  EXPECT_EQ(summary["sources"], nlohmann::json::parse(R"([{"name": "upper", "rocks": 400},
                                                          {"name": "lower", "rocks": 200}])"));
}

TEST_F(RunGis, AllFilesHaveTheSameBytesOnAnyNumberOfThreads) {
  run("one", "--threads 1");
  const std::string geopackage = bytes("one/results.gpkg"), vtk = bytes("one/paths.vtp");
  EXPECT_GT(geopackage.size(), 100'000U);
  EXPECT_GT(vtk.size(), 50'000U);
  for (const char* threads : {"2", "8"}) {
    run(threads, std::string("--threads ") + threads);
    EXPECT_TRUE(bytes(std::string(threads) + "/results.gpkg") == geopackage) << threads;
    EXPECT_TRUE(bytes(std::string(threads) + "/paths.vtp") == vtk) << threads;
  }
  run("another", "--seed 77");
  EXPECT_FALSE(bytes("another/results.gpkg") == geopackage);
}

TEST_F(RunGis, MergedShardsGiveTheSameFiles) {
  const std::string settings = "--set output.maps_by_source=true";
  run("whole", settings);
  std::string shards;
  for (const char* shard : {"3", "1", "2"}) {
    run(std::string("shard") + shard, settings + " --shard " + shard + "/3");
    shards += " " + path(std::string("shard") + shard).string();
    EXPECT_FALSE(std::filesystem::exists(path(std::string("shard") + shard) / "results.gpkg"));
  }
  const Said said = talus_says("merge" + shards + " -o " + path("merged").string());
  EXPECT_EQ(said.exit_code, 0) << said.text;
  for (const char* file : {"results.gpkg", "paths.vtp", "maps/passages.tif", "maps/by_source/sources.csv",
                           "maps/by_source/upper/passages.tif", "maps/by_source/lower/energy_total_p95_kJ.tif"}) {
    const std::string whole = bytes(std::string("whole/") + file);
    EXPECT_FALSE(whole.empty()) << file;
    EXPECT_TRUE(bytes(std::string("merged/") + file) == whole) << file;
  }
}

}  // namespace
}  // namespace talus::test

#endif
