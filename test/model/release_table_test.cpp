// Seeders from a table in a text file: the model, its rocks, and the exact text of what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <numbers>
#include <numeric>

#include "support/input_folder.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/check_releases.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/model/model.hpp"
#include "talus/model/release_columns.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using testing_tools::InputFolder;

/// A plane of 100 by 100 m at a height of 10 m that falls by 10 m towards +x.
const std::string tilted_plane = R"([terrain]
vertices = [[0, 0, 10], [100, 0, 0], [100, 100, 0], [0, 100, 10]]
triangles = [[0, 1, 2], [0, 2, 3]]
[[material]]
name = "Rock"
[[seeder]]
name = "Runs"
type = "table"
table = "releases.csv"
)";
const std::string section_terrain = R"([terrain]
section = [[0, 10], [100, 0]]
[[material]]
name = "Rock"
[[seeder]]
name = "Runs"
type = "table"
table = "releases.csv"
)";

class ReleaseTableFiles : public InputFolder {
 protected:
  [[nodiscard]] Model model(const std::string& table, const std::string& text, const Overrides& overrides = {}) {
    write("releases.csv", table);
    write("slope.toml", text);
    warnings_ = Problems{};
    Reading reading = read_project(path("slope.toml"), overrides);
    warnings_ = reading.warnings;
    project_ = reading.project;
    return build_model(reading.project, warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& table, const std::string& text = tilted_plane) {
    return refusal_of([&] { static_cast<void>(model(table, text)); });
  }
  /// The rocks in the order of their rows.
  static std::vector<std::uint64_t> rocks_by_row(const Model& model) {
    const ReleaseOrder order = release_order(model.seeders.at(0), model.seed);
    std::vector<std::uint64_t> rocks(model.rocks());
    std::iota(rocks.begin(), rocks.end(), 0U);
    std::ranges::stable_sort(rocks, {},
                             [&](std::uint64_t rock) { return table_of(model).row_at(order.place_of(rock)); });
    return rocks;
  }
  /// Releases of all rocks, in the order of their rows and in the user's coordinates.
  static std::vector<Motion> starts(const Model& model) {
    std::vector<Motion> list;
    Simulator simulator(model);
    for (const std::uint64_t rock : rocks_by_row(model)) {
      static_cast<void>(simulator.simulate(rock, true));
      list.push_back(simulator.log().rows.front().motion);
      list.back().position = model.frame.global_from_local(list.back().position);
    }
    return list;
  }
  static const ReleaseTable& table_of(const Model& model) { return std::get<ReleaseTable>(*model.seeders.at(0).where); }

  Project project_;
};

TEST_F(ReleaseTableFiles, ReleaseARockFromEachRow) {
  const Model built = model(
      "run,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,mass_kg,radius_m\n"
      "v1,10,20,15,1,2,3,4,5,6,69,0.18\n"
      "v2,30,40,12.5,-1,0,0.5,0,0,0,79,0.2\n",
      tilted_plane + "name_attribute = \"run\"\n");
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(built.rocks(), 2U);
  const std::vector<Motion> rocks = starts(built);
  EXPECT_LT((rocks[0].position - Vec3(10, 20, 15)).norm(), 1e-12);
  EXPECT_LT((rocks[1].position - Vec3(30, 40, 12.5)).norm(), 1e-12);
  EXPECT_EQ(rocks[0].velocity, Vec3(1, 2, 3));
  EXPECT_EQ(rocks[1].velocity, Vec3(-1, 0, 0.5));
  EXPECT_EQ(rocks[0].spin, Vec3(4, 5, 6));
  EXPECT_EQ(rocks[1].spin, Vec3(0, 0, 0));
  const RockRecord record = Simulator(built).simulate(rocks_by_row(built)[1], false);
  EXPECT_EQ(record.body.mass, 79);
  EXPECT_NEAR(record.body.radius, 0.2, 1e-15);
  EXPECT_THAT(table_of(built).names, ElementsAre("v1", "v2"));
  EXPECT_EQ(built.seeder_report,
            "seeder \"Runs\": 2 rows of \"releases.csv\", columns run, x_m, y_m, z_m, vx_m_s, vy_m_s, vz_m_s, "
            "wx_rad_s, wy_rad_s, wz_rad_s, mass_kg, radius_m; 2 rocks");
}

TEST_F(ReleaseTableFiles, LeaveWhatTheyDoNotGiveToTheSeeder) {
  const Model built = model("X [m];Y [m];Mass (kg);comment\n10,5;20;;dry\n30;40;55,5;\n",
                            tilted_plane + "mass_kg = 10\nhorizontal_velocity_m_s = 2\nheight_above_m = 1\n");
  EXPECT_EQ(warnings(), "");
  const std::vector<Motion> rocks = starts(built);
  EXPECT_LT((rocks[0].position - Vec3(10.5, 20, 9.95)).norm(), 1e-12);
  EXPECT_LT((rocks[1].position - Vec3(30, 40, 8)).norm(), 1e-12);
  EXPECT_EQ(rocks[0].velocity, Vec3(2, 0, 0));
  EXPECT_EQ(Simulator(built).simulate(rocks_by_row(built)[0], false).body.mass, 10);
  EXPECT_EQ(Simulator(built).simulate(rocks_by_row(built)[1], false).body.mass, 55.5);
  EXPECT_EQ(
      built.seeder_report,
      "seeder \"Runs\": 2 rows of \"releases.csv\", columns X [m], Y [m], Mass (kg) (not used: comment); 2 rocks");
}

TEST_F(ReleaseTableFiles, HaveHeightsAboveTheGround) {
  const Model built =
      model("x_m,y_m,z_m,height_above_m\n50,50,,2\n50,50,9,\n50,50,,\n50,50,1,\n", tilted_plane + "mass_kg = 100\n");
  const std::vector<Motion> rocks = starts(built);
  EXPECT_NEAR(rocks[0].position.z(), 7, 1e-12);
  EXPECT_NEAR(rocks[1].position.z(), 9, 1e-12);
  EXPECT_NEAR(rocks[2].position.z(), 5, 1e-12);
  EXPECT_NEAR(rocks[3].position.z(), 5, 1e-12);  // lifted out of the ground
  EXPECT_TRUE(Simulator(built).simulate(rocks_by_row(built)[3], false).was_lifted);
  EXPECT_FALSE(Simulator(built).simulate(rocks_by_row(built)[2], false).was_lifted);
}

TEST_F(ReleaseTableFiles, SayWhichRowsAreInTheGround) {
  const auto warning = [&](const std::string& rows) {
    const Model built = model(rows, tilted_plane + "mass_kg = 100\n");
    Problems found;
    warn_of_buried_releases(built, found);
    return found.text();
  };
  const std::string why =
      " (a run lifts them onto the surface, or lowers them from a ceiling). Compare z_m with the "
      "terrain; leave it empty to start on the ground, or give height_above_m instead";
  EXPECT_EQ(warning("x_m,y_m,z_m\n50,50,9\n50,50,5\n"), "");
  EXPECT_EQ(warning("x_m,y_m,z_m\n50,50,9\n50,50,1\n"),
            "warning: seeder \"Runs\": 1 of 2 rocks starts in the ground, from row 2" + why);
  EXPECT_EQ(warning("x_m,y_m,z_m,name\n50,50,1,B7\n50,50,9,B8\n50,50,1,\n"),
            "warning: seeder \"Runs\": 2 of 3 rocks start in the ground, from rows \"B7\", 3" + why);
  std::string many = "x_m,y_m,z_m\n";
  for (int k = 0; k < 8; ++k) many += "50,50,1\n";
  EXPECT_EQ(warning(many),
            "warning: seeder \"Runs\": 8 of 8 rocks start in the ground, from rows 1, 2, 3, 4, 5 and 3 more" + why);
  static_cast<void>(model("x_m,y_m,z_m,name\n50,50,9,A\n50,50,3000,B\n", tilted_plane + "mass_kg = 100\n"));
  EXPECT_EQ(warnings(),
            "warning: seeder \"Runs\": a rock of row \"B\" starts 2995 m above the ground (z is an elevation in "
            "the coordinate system of the terrain). Compare z_m with the terrain; leave it empty to start on "
            "the ground, or give height_above_m instead");
}

TEST_F(ReleaseTableFiles, HaveDirections) {
  const Model built =
      model("x_m,y_m,z_m,speed_m_s,azimuth_deg,plunge_deg\n50,50,20,10,90,30\n50,50,20,10,180,\n50,50,20,4,,\n",
            tilted_plane + "mass_kg = 100\ndirection = [0, 0, -1]\n");
  const std::vector<Motion> rocks = starts(built);
  const double root = std::sqrt(3.0);
  EXPECT_LT((rocks[0].velocity - Vec3(5 * root, 0, -5)).norm(), 1e-12);
  EXPECT_LT((rocks[1].velocity - Vec3(0, -10, 0)).norm(), 1e-12);
  EXPECT_LT((rocks[2].velocity - Vec3(0, 0, -4)).norm(), 1e-12);
}

TEST_F(ReleaseTableFiles, ReleaseSeveralRocksFromARow) {
  const std::string three = "x_m,y_m\n10,50\n20,50\n30,50\n";
  EXPECT_EQ(model(three, tilted_plane + "mass_kg = 100\nrocks_per_row = 4\n").rocks(), 12U);
  const Model shared = model(three, tilted_plane + "mass_kg = 100\nrocks = 5\n");
  ASSERT_EQ(shared.rocks(), 5U);
  std::map<double, int> at;
  for (const Motion& rock : starts(shared)) ++at[std::round(rock.position.x())];
  EXPECT_THAT(at, ElementsAre(Pair(10, AnyOf(1, 2)), Pair(20, AnyOf(1, 2)), Pair(30, AnyOf(1, 2))));
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(model(three, tilted_plane + "mass_kg = 100\n", {.rocks = 2}).rocks(), 2U);
  EXPECT_THAT(
      warnings(),
      HasSubstr("seeder \"Runs\": 1 of 3 rows release no rock (the seeder has 2 rocks). Leave out rocks, or give "
                "rocks_per_row"));
}

TEST_F(ReleaseTableFiles, AreReadInSections) {
  const Model built = model("x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,wy_rad_s,mass_kg\n10,0,12,3,0,-1,7,5\n", section_terrain);
  const Motion rock = starts(built).front();
  EXPECT_LT((rock.position - Vec3(10, 0, 12)).norm(), 1e-12);
  EXPECT_EQ(rock.velocity, Vec3(3, 0, -1));
  EXPECT_EQ(rock.spin, Vec3(0, 7, 0));
  EXPECT_EQ(refusal("x_m,y_m,z_m,vy_m_s,wx_rad_s,mass_kg\n10,2,12,3,1,5\n", section_terrain),
            "slope.toml:8: seeder \"Runs\": table releases.csv:2: y_m is 2 (a section has y = 0)\n"
            "slope.toml:8: seeder \"Runs\": table releases.csv:2: vy_m_s is 3 (in a section it is 0)\n"
            "slope.toml:8: seeder \"Runs\": table releases.csv:2: wx_rad_s is 1 (in a section it is 0)");
  EXPECT_THAT(refusal("x_m,speed_m_s,azimuth_deg,mass_kg\n10,2,90,5\n", section_terrain),
              HasSubstr("column azimuth_deg is given in 2D (a section has no plan). Give vx_m_s and vz_m_s"));
  EXPECT_THAT(refusal("x_m\n120\n", section_terrain + "mass_kg = 100\n"),
              HasSubstr("seeder \"Runs\": line 2: x = 120 is off the terrain (the section extends from x = 0 to 100)"));
}

// A run ends; its end points are the releases of the next.
TEST_F(ReleaseTableFiles, MayBeTheEndPointsOfARun) {
  const Model built = model(
      "rock,seeder,x_m,y_m,z_m,runout_xy_m,runout_z_m,runout_total_m,time_s,events,end_reason,mass_kg,radius_m,max_ke_"
      "J,"
      "max_bounce_m\n"
      "0,\"Cliff, north\",10,20,9.5,1,2,3,4,5,at rest,100,0.21,7,8\n",
      tilted_plane + "source_attribute = \"seeder\"\n");
  EXPECT_EQ(warnings(), "");
  EXPECT_LT((starts(built).front().position - Vec3(10, 20, 9.5)).norm(), 1e-12);
  EXPECT_THAT(built.sources, ElementsAre("Cliff, north"));
}

TEST_F(ReleaseTableFiles, HaveSourcesWhoseRocksFollowEachOther) {
  const Model built = model("x_m,y_m,where\n10,1,north\n20,1,south\n30,1,\n40,1,north\n50,1,south\n",
                            tilted_plane + "mass_kg = 100\nsource_attribute = \"where\"\nrocks_per_row = 2\n");
  EXPECT_THAT(built.sources, ElementsAre("north", "south", "Runs"));
  const ReleaseTable& table = table_of(built);
  std::vector<std::uint32_t> numbers;
  for (std::size_t row = 0; row < table.count(); ++row) numbers.push_back(table.number(row));
  EXPECT_THAT(numbers, ElementsAre(1, 4, 2, 5, 3));
  const auto runs = source_runs(built.seeders[0], 1);
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[1].first_place, 2U);
  EXPECT_EQ(runs[2].first_place, 4U);
}

TEST_F(ReleaseTableFiles, ReportAllProblemsOfTheirRows) {
  EXPECT_EQ(
      refusal("x_m,y_m,z_m,mass_kg,vx_m_s,vy_m_s,diameter_m\n"
              "1,2,3,4,,,\n"
              "a,2,3,nan,,,\n"
              "1,,3,-4,,,\n"
              "1,2,3,4,1,,0.01\n"
              "1,2\n"
              "1,2,inf,,,,\n"),
      "slope.toml:9: seeder \"Runs\": table releases.csv:3: x_m is \"a\" (expected a number)\n"
      "slope.toml:9: seeder \"Runs\": table releases.csv:3: mass_kg is \"nan\" (expected a number)\n"
      "slope.toml:9: seeder \"Runs\": table releases.csv:4: mass_kg is -4 (a rock has mass; expected 1e-9 to 1e12)\n"
      "slope.toml:9: seeder \"Runs\": table releases.csv:5: vy_m_s is empty (other components of the velocity are "
      "given)\n"
      "slope.toml:9: seeder \"Runs\": table releases.csv:5: its mass and size make a density of 7.639e+06 kg/m3 "
      "(expected 100 to 20000). Compare their units\n"
      "slope.toml:9: seeder \"Runs\": table releases.csv:6: the row has 2 values (the first line names 7 columns)\n"
      "slope.toml:9: seeder \"Runs\": table releases.csv:7: z_m is \"inf\" (expected a number)");
}

TEST_F(ReleaseTableFiles, RefuseColumnsThatAreNotClear) {
  EXPECT_THAT(refusal("x_m,y_ft,mass,density_g_cm3\n1,2,3,4\n"),
              HasSubstr("column \"y_ft\" is in another unit (expected m). Convert it to m and name it y_m"));
  EXPECT_THAT(
      refusal("x_m,y_m,mass\n1,2,3\n"),
      HasSubstr("column \"mass\" has no unit (units are in the names of columns). Name it mass_kg if it is in kg"));
  EXPECT_THAT(refusal("lat,lon,mass_kg\n1,2,3\n"),
              HasSubstr("has no column x_m (it has \"lat\", \"lon\", \"mass_kg\"). Degrees are read from points of a "
                        "GeoPackage, Shapefile or GeoJSON"));
  EXPECT_THAT(
      refusal("x,x_m,y_m,mass_kg\n1,1,2,3\n"),
      HasSubstr("columns \"x\" and \"x_m\" mean the same (it is not clear which one to read). Rename one of them"));
  EXPECT_THAT(refusal("x_m,y_m,mass_kg,vx_m_s,speed_m_s\n1,1,2,3,4\n"),
              HasSubstr("columns vx_m_s and speed_m_s are given together (they exclude each other)"));
  EXPECT_THAT(refusal("x_m,y_m,mass_kg,diameter_m,density_kg_m3\n1,1,2,3,4\n"),
              HasSubstr("columns density_kg_m3 and diameter_m are given together"));
  EXPECT_THAT(refusal("x_m,y_m,mass_kg,speed_m_s,plunge_deg\n1,1,2,3,4\n"),
              HasSubstr("column plunge_deg is given without azimuth_deg (the direction on plan is missing)"));
  EXPECT_THAT(refusal("x_m,y_m,mass_kg\n1,1,2\n", tilted_plane + "name_attribute = \"nme\"\n"),
              HasSubstr("has no column \"nme\" (name_attribute names it; it has \"x_m\", \"y_m\", \"mass_kg\")"));
}

TEST_F(ReleaseTableFiles, RefuseRowsThatAreNoRelease) {
  EXPECT_THAT(refusal("x_m,y_m,mass_kg\n"), HasSubstr("table releases.csv: has no rows (a row is a release)"));
  EXPECT_THAT(
      refusal("x_m,y_m\n1,1\n"),
      HasSubstr("table releases.csv:2: the row gives no mass or size (neither does the seeder). Give mass_kg in "
                "the project or the table"));
  EXPECT_THAT(refusal("x_m,y_m,z_m,height_above_m,mass_kg\n1,1,9,9,1\n"),
              HasSubstr("z_m and height_above_m are given together (they exclude each other). Leave one empty"));
  EXPECT_THAT(
      refusal("x_m,y_m,mass_kg\n150,50,1\n50,50,1\n50,-1,1\n"),
      HasSubstr("seeder \"Runs\": line 2: (150, 50) is off the terrain (on plan the terrain lies within x = 0 to "
                "100, y = 0 to 100)"));
}

TEST_F(ReleaseTableFiles, RefuseMistypedNames) {
  EXPECT_THAT(
      refusal("x_m,y_m,mass_kg,densty_kg_m3\n50,50,10,2500\n"),
      HasSubstr("table releases.csv: column \"densty_kg_m3\" is not known (it would not be read, and there is no "
                "column density_kg_m3). Name it density_kg_m3, or otherwise if it is something else"));
  // Other words and numbers mean something else: a warning.
  static_cast<void>(model("x_m,y_m,mass_kg,diameter_a_m,remrk\n50,50,10,1,2\n", tilted_plane));
  EXPECT_THAT(warnings(), HasSubstr("columns are not used: diameter_a_m (diameter_m) (the names in brackets"));
}

TEST_F(ReleaseTableFiles, WarnOfDoubtfulNumbersAndNames) {
  static_cast<void>(model("x_m,y_m,mass_kg,v_m_s\n50,50,1e8,2500\n50,50,2e8,2500\n", tilted_plane));
  EXPECT_THAT(warnings(), HasSubstr("columns are not used: v_m_s (vx_m_s)"));
  EXPECT_THAT(warnings(), HasSubstr("mass_kg is 100000000 (line 2, and 1 other row)"));
}

TEST_F(ReleaseTableFiles, AreBesideTheProject) {
  EXPECT_THAT(refusal_of([&] {
                write("slope.toml", tilted_plane + "mass_kg = 100\n");
                static_cast<void>(read_project(path("slope.toml")));
              }),
              HasSubstr("slope.toml:9: seeder \"Runs\": table is \"releases.csv\" (there is no such file)"));
  std::filesystem::create_symlink("/etc/passwd", path("releases.csv"));
  EXPECT_THAT(refusal_of([&] { static_cast<void>(read_project(path("slope.toml"))); }),
              HasSubstr("it is a link to outside the project's folder; name /etc/passwd itself"));
}

TEST_F(ReleaseTableFiles, AreKnownByTheFingerprintAndTheEcho) {
  const auto print_of = [&](const std::string& table) {
    const Model built = model(table, tilted_plane);
    return fingerprint_of(echo(project_), built);
  };
  const std::string one = "x_m,y_m,z_m,mass_kg,vx_m_s\n1,1,20,5,0\n2,2,20,5,0\n";
  EXPECT_EQ(print_of(one), print_of(one));
  EXPECT_NE(print_of(one), print_of("x_m,y_m,z_m,mass_kg,vx_m_s\n1,1,20,5,0\n2,2,20,5,0.1\n"));
  EXPECT_NE(print_of(one), print_of("x_m,y_m,z_m,mass_kg,vx_m_s\n1,1,20,5,0\n2,2,20.5,5,0\n"));
  const auto seeder = echo(project_)["seeder"][0];
  EXPECT_EQ(seeder["type"], "table");
  EXPECT_EQ(seeder["table"], "releases.csv");
  EXPECT_EQ(seeder["rocks_per_row"], 1);
  EXPECT_FALSE(seeder.contains("rocks"));
}

TEST_F(ReleaseTableFiles, MayHaveManyRows) {
  std::string text = "x_m,y_m,z_m,mass_kg,vx_m_s,vy_m_s,vz_m_s\n";
  constexpr int rows = 200'000;
  for (int k = 0; k < rows; ++k) text += "10.5,20.25,15.125,69.5,0.1,0.2,-0.3\n";
  const Model built = model(text, tilted_plane);
  EXPECT_EQ(built.rocks(), static_cast<std::uint64_t>(rows));
  EXPECT_LT(table_of(built).bytes(), 70U * rows);
}

TEST(ReleaseColumns, AreInTheOrderOfTheirNumbers) {
  for (std::size_t k = 0; k < release_columns().size(); ++k)
    EXPECT_EQ(static_cast<std::size_t>(release_columns()[k].column), k);
}

}  // namespace
}  // namespace talus::project
