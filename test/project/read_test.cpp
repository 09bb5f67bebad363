#include "talus/project/read.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "support/projects.hpp"
#include "talus/project/starter.hpp"

namespace talus::project {
namespace {

/// An example with most keys.
constexpr const char* example = R"(
name = "Tutorial 1"

[analysis]
model = "lumped_mass"              # or "rigid_sphere"
rotation = true                    # lumped mass: consider rotational velocity
gravity_m_s2 = 9.80665
sliding = "stepped"                # or "closed_form"
max_timestep_s = 0.01
normal_velocity_cutoff_m_s = 0.1
stopped_velocity_m_s = 0.1
max_steps = 10000
max_time_s = 600
energy_datum_m = -25.0             # default: lowest point of the terrain

[sampling]
seed = 1
method = "monte_carlo"             # or "latin_hypercube"
materials = "per_impact"           # or "per_rock"

[terrain]                          # exactly one of section, mesh, triangles, raster
section = [[0,0],[3.1,-12.2],[6.7,-12.2],[9.8,-24.4],[13.4,-25],[26,-22.5]]   # x, z; extruded along y
width_m = 50                       # of the extrusion, from y = 0; without it the analysis is 2D
rotate_deg = 0                     # about z through rotate_about
rotate_about = [0, 25, 0]

[[material]]
name = "Type One"
normal_restitution     = { mean = 0.5, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
tangential_restitution = { mean = 0.9, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
friction_angle_deg     = 30        # a plain number is { mean = 30, distribution = "none" }
roughness_deg          = 0
dynamic_friction       = 0.47      # rigid sphere
rolling_friction       = 0.1       # rigid sphere

[[material]]
name = "Type Two"

[[material]]
name = "Type Three"

[ground]                           # which part of the terrain has which material
default  = "Type One"
segments = ["Type One", "Type Two", "Type One", "Type Three", "Type Three"]   # section: one per segment

[[seeder]]
type = "point"                     # point, line, polygon, raster (cells above a slope angle or a mask)
position = [0.5, 0, 0]             # 2D: [x, z]; line: points = [[x,y,z],...]
rocks = 50
mass_kg = 1000                     # or volume_m3, or diameter_m; a number or a distribution
density_kg_m3 = 2700
horizontal_velocity_m_s = { mean = 1.5, distribution = "normal", std_dev = 0.15, rel_min = 0.45, rel_max = 0.45 }
vertical_velocity_m_s = 0
rotational_velocity_deg_s = 0
direction = [1, 0, 0]              # of the horizontal velocity; or speed_m_s with a full 3D direction

[[barrier]]
name = "Fence"
line = [[15, 0], [15, 50]]         # plan; 2D: x = 15
height_m = 3.5
inclination_deg = 0
capacity_kJ = inf

[output]
paths = "all"                      # none, all, or a number of rocks
maps = true
raster_cell_m = 1.0                # maps; percentiles = [50, 95, 99]
report = true
)";

constexpr const char* smallest = R"(
[terrain]
section = [[0, 0], [10, -10]]
[[material]]
name = "Rock"
[[seeder]]
position = [1, 5]
mass_kg = 1000
)";

Project read(const std::string& text, const Overrides& overrides = {}) {
  Reading reading = read_project_text(text, "folder/slope.toml", overrides);
  // Some tests have many rocks without random properties.
  for (const Problem& warning : reading.warnings.list())
    EXPECT_THAT(warning.text(), ::testing::HasSubstr("are identical"));
  return std::move(reading.project);
}

Project read_with(const std::string& text, std::vector<std::string> settings) {
  return read(text, {.settings = std::move(settings), .rocks = {}, .seed = {}});
}

/// A project with these numbers of rocks in its seeders.
std::string with_seeders(const std::vector<std::int64_t>& rocks) {
  std::string text = "[terrain]\nsection = [[0, 0], [10, -10]]\n[[material]]\nname = \"Rock\"\n";
  for (const std::int64_t count : rocks) {
    text += "[[seeder]]\nposition = [1, 5]\nmass_kg = 1000\nrocks = " + std::to_string(count) + '\n';
  }
  return text;
}

std::vector<std::int64_t> shared(const std::vector<std::int64_t>& rocks, std::int64_t total) {
  const Project project = read(with_seeders(rocks), {.settings = {}, .rocks = total, .seed = {}});
  std::vector<std::int64_t> shares;
  for (const Seeder& seeder : project.seeders) shares.push_back(seeder.rocks);
  return shares;
}

TEST(ReadProject, ReadsTheExample) {
  const Project project = read(example);
  EXPECT_EQ(project.name, "Tutorial 1");
  EXPECT_FALSE(project.is_2d());
  EXPECT_EQ(project.analysis.model, RockModel::lumped_mass);
  EXPECT_EQ(project.analysis.energy_datum_m, -25.0);
  EXPECT_EQ(project.terrain.section.vertices.size(), 6u);
  EXPECT_EQ(project.terrain.section.vertices[1], (std::array<double, 2>{3.1, -12.2}));
  EXPECT_EQ(project.terrain.section.width_m, 50.0);
  EXPECT_EQ(project.terrain.rotate_about, (std::array<double, 3>{0, 25, 0}));
  ASSERT_EQ(project.materials.size(), 3u);
  const Material& one = project.materials[0];
  EXPECT_EQ(one.name, "Type One");
  EXPECT_EQ(one.normal_restitution.mean, 0.5);
  EXPECT_EQ(one.normal_restitution.kind, DistributionKind::normal);
  EXPECT_EQ(one.normal_restitution.std_dev, 0.03);
  EXPECT_EQ(one.normal_restitution.rel_min, 0.09);
  EXPECT_EQ(one.normal_restitution.rel_max, 0.09);
  EXPECT_EQ(one.friction_angle_deg.mean, 30);
  EXPECT_EQ(one.friction_angle_deg.kind, DistributionKind::none);
  EXPECT_EQ(one.dynamic_friction.mean, 0.47);
  EXPECT_EQ(project.ground.default_material, "Type One");
  EXPECT_EQ(project.ground.segments[3], "Type Three");
  ASSERT_EQ(project.seeders.size(), 1u);
  const Seeder& seeder = project.seeders[0];
  EXPECT_EQ(seeder.at_points.points, (std::vector<std::array<double, 3>>{{0.5, 0, 0}}));
  EXPECT_EQ(seeder.rocks, 50);
  EXPECT_EQ(seeder.horizontal_velocity_m_s.std_dev, 0.15);
  ASSERT_EQ(project.barriers.size(), 1u);
  EXPECT_EQ(project.barriers[0].line, (std::vector<std::array<double, 2>>{{15, 0}, {15, 50}}));
  EXPECT_EQ(project.barriers[0].height_m, 3.5);
  EXPECT_TRUE(std::isinf(project.barriers[0].capacity_kJ));
  EXPECT_EQ(project.output.path_limit, std::nullopt);
}

TEST(ReadProject, ReadsTheStarterWithoutWarnings) {
  const Project project = read(starter());
  EXPECT_TRUE(project.is_2d());
  EXPECT_EQ(project.materials.size(), 3u);
  EXPECT_EQ(project.seeders[0].rocks, 50);
}

TEST(ReadProject, FillsInDefaults) {
  const Project project = read(smallest);
  const Project blank;
  EXPECT_EQ(project.name, "slope");
  EXPECT_EQ(project.file, "folder/slope.toml");
  EXPECT_TRUE(project.is_2d());
  EXPECT_EQ(project.analysis.gravity_m_s2, blank.analysis.gravity_m_s2);
  EXPECT_EQ(project.analysis.energy_datum_m, std::nullopt);
  EXPECT_EQ(project.sampling.seed, 1u);
  EXPECT_EQ(project.ground.default_material, "Rock");
  EXPECT_EQ(project.materials[0].normal_restitution.mean, Material{}.normal_restitution.mean);
  EXPECT_EQ(project.seeders[0].name, "seeder 1");
  EXPECT_EQ(project.seeders[0].rocks, 1);
  EXPECT_EQ(project.seeders[0].line, 6);
  EXPECT_EQ(project.seeders[0].at_points.points, (std::vector<std::array<double, 3>>{{1, 0, 5}}));
  EXPECT_EQ(project.output.endpoint_limit, std::nullopt);
  EXPECT_EQ(project.output.path_limit, 300);
}

TEST(ReadProject, NamesUnnamedBarriersAndCollectors) {
  const Project project = read(std::string(smallest) +
                               "[[collector]]\nline = 3\nheight_m = 9\n"
                               "[[barrier]]\nline = 4\nheight_m = 2\n"
                               "[[barrier]]\nline = [5]\nheight_m = 2\ncapacity_kJ = 500\n");
  ASSERT_EQ(project.barriers.size(), 3u);
  EXPECT_EQ(project.barriers[0].name, "barrier 1");
  EXPECT_EQ(project.barriers[1].name, "barrier 2");
  EXPECT_EQ(project.barriers[1].line, (std::vector<std::array<double, 2>>{{5, 0}}));
  EXPECT_EQ(project.barriers[1].capacity_kJ, 500);
  EXPECT_EQ(project.barriers[1].source_line, 15);
  EXPECT_EQ(project.barriers[2].name, "collector 1");
  EXPECT_TRUE(project.barriers[2].is_collector);
}

TEST(ReadProject, AcceptsABarrierOnPlanIn2D) {
  const Project project = read(std::string(smallest) + "[[barrier]]\nline = [[4, 0], [4, 50]]\nheight_m = 2\n");
  EXPECT_EQ(project.barriers[0].line, (std::vector<std::array<double, 2>>{{4, 0}}));
}

TEST(ReadProject, ReadsPositionsOnTheSurface) {
  const Project project = read_with(smallest, {"seeder.0.position=[1, \"surface\"]"});
  EXPECT_TRUE(project.seeders[0].at_points.z_is_surface);
  EXPECT_EQ(project.seeders[0].at_points.points[0], (std::array<double, 3>{1, 0, 0}));
}

TEST(ReadProject, ReadsPositionsAboveTheSurface) {
  for (const char* position : {"[1]", "[1, \"surface\"]"}) {
    const Project project =
        read_with(smallest, {std::string("seeder.0.position=") + position, "seeder.0.height_above_m=2"});
    EXPECT_FALSE(project.seeders[0].at_points.z_is_surface) << position;
    EXPECT_EQ(project.seeders[0].height_above_m, 2.0) << position;
    EXPECT_EQ(project.seeders[0].at_points.points[0], (std::array<double, 3>{1, 0, 0})) << position;
  }
}

TEST(ReadProject, ReadsALineSeederIn3D) {
  const Project project = read(R"(
[terrain]
vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 2]]
[[material]]
name = "Rock"
[ground]
triangles = [0]
[[seeder]]
type = "line"
points = [[1, 1], [1, 2], [2, 2]]
height_above_m = 0.5
diameter_m = { mean = 1, distribution = "uniform", rel_min = 0.5, rel_max = 0.5 }
speed_m_s = 3
direction = [0, 1, -1]
)");
  EXPECT_FALSE(project.is_2d());
  const Seeder& seeder = project.seeders[0];
  EXPECT_EQ(seeder.type, SeederType::line);
  EXPECT_EQ(seeder.at_points.points, (std::vector<std::array<double, 3>>{{1, 1, 0}, {1, 2, 0}, {2, 2, 0}}));
  EXPECT_EQ(seeder.size->of, SizeOf::diameter);
  EXPECT_EQ(seeder.size->distribution.kind, DistributionKind::uniform);
  EXPECT_EQ(seeder.speed_m_s->mean, 3);
  EXPECT_EQ(seeder.direction, (std::array<double, 3>{0, 1, -1}));
  EXPECT_EQ(project.terrain.inline_mesh.triangles, (std::vector<std::array<std::int64_t, 3>>{{0, 1, 2}}));
  EXPECT_EQ(project.ground.triangles, (std::vector<std::int64_t>{0}));
}

TEST(ReadProject, AcceptsADirectionOfTwoIn2D) {
  EXPECT_EQ(read_with(smallest, {"seeder.0.direction=[-1, 0]"}).seeders[0].direction,
            (std::array<double, 3>{-1, 0, 0}));
  EXPECT_EQ(read_with(smallest, {"seeder.0.direction=[-2, 1]", "seeder.0.speed_m_s=3"}).seeders[0].direction,
            (std::array<double, 3>{-2, 0, 1}));
}

TEST(ReadProject, AcceptsDownslopeAsADirection) {
  EXPECT_EQ(read_with(smallest, {"seeder.0.direction=downslope"}).seeders[0].direction, std::nullopt);
}

TEST(ReadProject, ReleasesRocksOfAnAreaDownslopeUnlessItSaysOtherwise) {
  const auto direction_of = [](const std::string& seeder) {
    return read(R"(
[terrain]
vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 2]]
[[material]]
name = "Rock"
[[seeder]]
mass_kg = 1000
horizontal_velocity_m_s = 2
)" + seeder)
        .seeders[0]
        .direction;
  };
  const std::array<double, 3> east{1, 0, 0}, north{0, 1, 0};
  const std::string polygon = "type = \"polygon\"\npolygon = [[0, 0], [5, 0], [0, 5]]\ncell_m = 1\n";
  EXPECT_EQ(direction_of(polygon), std::nullopt);
  EXPECT_EQ(direction_of("type = \"raster\"\nmin_slope_deg = 9\ncell_m = 1\n"), std::nullopt);
  EXPECT_EQ(direction_of(polygon + "direction = [0, 1, 0]\n"), north);
  EXPECT_EQ(direction_of("position = [1, 1, 1]\n"), east);
}

TEST(ReadProject, AcceptsSegmentsWithoutADefault) {
  const Project project = read(R"(
[terrain]
section = [[0, 0], [10, -10]]
[[material]]
name = "Rock"
[[material]]
name = "Talus"
[ground]
segments = ["Talus"]
[[seeder]]
position = [1, 5]
mass_kg = 1000
)");
  EXPECT_EQ(project.ground.segments, (std::vector<std::string>{"Talus"}));
  EXPECT_EQ(project.ground.default_material, "Rock");
}

TEST(ReadProject, ADistributionOfKindNoneKeepsItsOtherKeys) {
  const Project project =
      read_with(smallest, {"material.0.normal_restitution={ mean = 0.4, distribution = \"none\", std_dev = 0.03 }"});
  EXPECT_EQ(project.materials[0].normal_restitution.kind, DistributionKind::none);
  EXPECT_EQ(project.materials[0].normal_restitution.std_dev, 0.03);
}

TEST(ReadProject, ReadsTheNumberOfPaths) {
  EXPECT_EQ(read_with(smallest, {"output.paths=all"}).output.path_limit, std::nullopt);
  EXPECT_EQ(read_with(smallest, {"output.paths=none"}).output.path_limit, 0);
  EXPECT_EQ(read_with(smallest, {"output.paths=25"}).output.path_limit, 25);
  EXPECT_EQ(read_with(smallest, {"output.endpoints=none"}).output.endpoint_limit, 0);
  EXPECT_EQ(read_with(smallest, {"output.endpoints=7"}).output.endpoint_limit, 7);
}

TEST(ReadProject, AcceptsOutputsThatAreSwitchedOff) {
  EXPECT_FALSE(read_with(smallest, {"output.maps=false", "output.report=false"}).output.report);
}

TEST(ReadProject, OverridesPartsByNumberAndByName) {
  const Project project = read_with(
      smallest, {"analysis.gravity_m_s2=9.81", "material.Rock.normal_restitution.mean=0.4", "seeder.0.rocks=7",
                 "terrain.section.1.0=12", "sampling.method=latin_hypercube", "name=Two"});
  EXPECT_EQ(project.analysis.gravity_m_s2, 9.81);
  EXPECT_EQ(project.materials[0].normal_restitution.mean, 0.4);
  EXPECT_EQ(project.seeders[0].rocks, 7);
  EXPECT_EQ(project.terrain.section.vertices[1], (std::array<double, 2>{12, -10}));
  EXPECT_EQ(project.sampling.method, SamplingMethod::latin_hypercube);
  EXPECT_EQ(project.name, "Two");
}

TEST(ReadProject, OverridesEntriesWithADotInTheirName) {
  const Project project =
      read_with(smallest, {"material.0.name=\"Type 1.5\"", "material.\"Type 1.5\".roughness_deg=3"});
  EXPECT_EQ(project.materials[0].roughness_deg.mean, 3);
}

TEST(ReadProject, OverridesTurnAPlainNumberIntoADistribution) {
  const std::string text = std::string(smallest) + "horizontal_velocity_m_s = 1.5\n";
  const Project project = read_with(
      text, {"seeder.0.horizontal_velocity_m_s.std_dev=0.15", "seeder.0.horizontal_velocity_m_s.distribution=normal"});
  EXPECT_EQ(project.seeders[0].horizontal_velocity_m_s.mean, 1.5);
  EXPECT_EQ(project.seeders[0].horizontal_velocity_m_s.std_dev, 0.15);
  EXPECT_EQ(project.seeders[0].horizontal_velocity_m_s.kind, DistributionKind::normal);
}

TEST(ReadProject, OverridesThatAreNotTomlAreStrings) {
  for (const std::string text : {"Slope", "../p1/x.tif", "/abs/x.tif", "5m.tif", "EPSG:31287", "tiles/x 1.tif", "-x",
                                 "2024-13-45", "1.5 m", "C:\\tiles\\x.tif", "say \"x\"", "~/x.tif", "a,b", "truely",
                                 "../../../../../../../../../x.tif", "x # no comment", "Gr\u00fcn.tif"}) {
    EXPECT_EQ(read_with(smallest, {"seeder.0.source=" + text}).seeders[0].source, text);
  }
  EXPECT_EQ(read_with(smallest, {"seeder.0.source= ../x.tif "}).seeders[0].source, "../x.tif");
  EXPECT_EQ(read_with(smallest, {"seeder.0.source=\"5\""}).seeders[0].source, "5");
}

TEST(ReadProject, WholeNumbersBeyondDoublePrecisionAreRounded) {
  const std::string text = std::string(smallest) + "[[barrier]]\nline = 5\nheight_m = 3\ncapacity_kJ = ";
  EXPECT_EQ(read(text + "9999999999999999\n").barriers[0].capacity_kJ, 1e16);
  EXPECT_EQ(read(text + "9007199254740993\n").barriers[0].capacity_kJ, 9007199254740992.0);
  EXPECT_EQ(read(text + "9223372036854775807\n").barriers[0].capacity_kJ, 9223372036854775808.0);
}

TEST(ReadProject, RefusesASeedBeyondTheRangeOfToml) {
  constexpr std::uint64_t largest = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(read(smallest, {.settings = {}, .rocks = {}, .seed = largest}).sampling.seed, largest);
  EXPECT_EQ(read_with(smallest, {"sampling.seed=9223372036854775807"}).sampling.seed, largest);
  EXPECT_EQ(testing_tools::refusal_of_reading(smallest, {.settings = {}, .rocks = {}, .seed = largest + 1}),
            "--seed 9223372036854775808: this is not a seed (expected 0 to 9223372036854775807)");
}

TEST(ReadProject, GivesAllRocksToASingleSeeder) { EXPECT_EQ(shared({50}, 1000), (std::vector<std::int64_t>{1000})); }

TEST(ReadProject, SharesRocksByLargestRemainders) {
  EXPECT_EQ(shared({10, 20, 30}, 600), (std::vector<std::int64_t>{100, 200, 300}));
  EXPECT_EQ(shared({1, 1, 1}, 10), (std::vector<std::int64_t>{4, 3, 3}));
  EXPECT_EQ(shared({1, 2, 4}, 10), (std::vector<std::int64_t>{1, 3, 6}));  // 1.43, 2.86, 5.71
  EXPECT_EQ(shared({1000, 1}, 10), (std::vector<std::int64_t>{10, 0}));
}

TEST(ReadProject, SharesAddUpToTheTotal) {
  for (const std::int64_t total : {1, 7, 999, 1'000'000'007}) {
    const auto shares = shared({3, 7, 11, 999'999'937, 1}, total);
    EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), std::int64_t{0}), total);
    for (const std::int64_t share : shares) EXPECT_GE(share, 0);
  }
  const auto most = shared({500'000'000'000, 499'999'999'999}, 1'000'000'000'000);
  EXPECT_EQ(most[0] + most[1], 1'000'000'000'000);
}

}  // namespace
}  // namespace talus::project
