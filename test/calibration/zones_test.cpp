// Deposits by zone: files, what is refused of them, and recovery of known parameters.

#include "talus/calibration/zones.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "calibration/slope.hpp"
#include "support/browser.hpp"
#include "support/input_folder.hpp"
#include "support/projects.hpp"
#include "talus/calibration/result_files.hpp"

namespace talus::calibration {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using testing_tools::replaced;

const std::string zone_slope =
    scree_slope + replaced(replaced(cliff_release, "mass_kg = 300",
                                    "mass_kg = { mean = 300, distribution = \"lognormal\", std_dev = 150 }"),
                           "rocks = 40", "rocks = 200");

const std::string wide_slope = R"(
[terrain]
section = [[0, 0], [40, -40], [70, -55], [300, -60]]
width_m = 100
[[material]]
name = "Scree"
friction_angle_deg = 30
[[seeder]]
type = "line"
points = [[1, 20, 3], [1, 80, 3]]
mass_kg = 300
rocks = 60
)";

const std::string zone_study = R"(
rocks = 150
draws = 240
[[site]]
project = "slope.toml"
[[observations]]
zones = "zones.csv"
[[parameter]]
path = "material.Scree.tangential_restitution"
range = [0.6, 0.9]
)";

class Zones : public testing_tools::InputFolder {
 protected:
  Zones() {
    write("slope.toml", zone_slope);
    write("study.toml", zone_study);
  }

  PreparedStudy prepared() {
    warnings_ = {};
    return {read_study(path("study.toml")).study, nullptr, warnings_};
  }
  std::string problems_of(const std::string& zones, const std::string& keys = "") {
    write("zones.csv", zones);
    write("study.toml", replaced(zone_study, "zones = \"zones.csv\"", "zones = \"zones.csv\"\n" + keys));
    return refusal_of([&] { static_cast<void>(prepared()); });
  }

  /// Deposits of simulated rocks in three zones, by volume.
  std::string deposits(double tangential, int rocks, std::uint64_t seed) {
    project::Reading reading = project::read_project_text(
        zone_slope, "slope.toml",
        {{"material.Scree.tangential_restitution.mean=" + std::to_string(tangential)}, rocks, seed});
    const study::PreparedSite site(std::move(reading.project), warnings_);
    ObservedZones zones;
    zones.has_elsewhere = true;
    zones.list = {{.name = "slope", .from = 0, .to = 70},
                  {.name = "foot", .from = 70, .to = 90},
                  {.name = "meadow", .from = 90, .to = 300}};
    const Sample sample = zone_sample(zones, site.run({}, {}).ends);
    Eigen::VectorXd volumes = zone_shares(zones, sample) * sample.rows.col(1).sum();
    return "zone,from_m,to_m,volume_m3\nslope,0,70," + std::to_string(volumes[0]) + "\nfoot,70,90," +
           std::to_string(volumes[1]) + "\nmeadow,90,300," + std::to_string(volumes[2]) + "\n";
  }
};

TEST_F(Zones, RecoverAKnownParameter) {
  write("zones.csv", deposits(0.75, 80, 11));
  write("study.toml", replaced(zone_study, "zones = \"zones.csv\"", "zones = \"zones.csv\"\nrelative_accuracy = 0"));
  const PreparedStudy study = prepared();
  const ObservedGroup& group = study.groups().front();
  // 80 rocks whose volumes vary by a half: as many as 80 / 1.25 alike, within what eighty lognormal rocks vary.
  EXPECT_NEAR(static_cast<double>(group.count()), 64, 16);
  const CalibrationResult result = calibrate_into(path("out"), study, {});
  std::vector<double> values, weights;
  for (const SetResult& set : result.sets) {
    values.push_back(set.values[0]);
    weights.push_back(set.weight);
  }
  const double low = weighted_quantile(values, weights, 0.05), high = weighted_quantile(values, weights, 0.95);
  EXPECT_LT(low, 0.75);
  EXPECT_GT(high, 0.75);
  EXPECT_LT(high - low, 0.16);  // of 0.27; 0.154, since Rn falls with speed, which hides a part of what Rt does
  EXPECT_TRUE(agrees(result.sets[result.best]));
  EXPECT_EQ(result.misfit, 1);
  const auto observed = nlohmann::json::parse(std::ifstream(path("out/summary.json"))).at("observations").at(0);
  EXPECT_EQ(observed.at("deposits").at("unit"), "m3");
  EXPECT_EQ(observed.at("deposits").at("independent_rocks"), effective_rocks(group.zones, group.sample));
  double shares = 0;
  for (const auto& zone : observed.at("zones")) {
    shares += zone.at("observed_share").get<double>();
    EXPECT_LT(zone.at("prior_share").at("p05"), zone.at("prior_share").at("p95")) << zone;
  }
  EXPECT_NEAR(shares, 1, 1e-12);
  if (!testing_tools::has_browser()) GTEST_SKIP() << "there is no chromium";
  EXPECT_THAT(testing_tools::said_in_page(path("out/report.html"), R"(
    const main = document.getElementById('main');
    const figure = [...main.querySelectorAll('figure')].at(-1);
    const zones = [...figure.querySelectorAll('title')].map((each) => each.textContent).join(', ');
    return [zones, figure.querySelectorAll('rect.bar').length, main.textContent].join('; ');
  )"),
              AllOf(StartsWith("slope, foot, meadow; 4; "), HasSubstr("The observation counts as "),
                    Not(HasSubstr("NaN")), Not(HasSubstr("undefined"))));
}

TEST_F(Zones, CountAsFewerRocksWithErrors) {
  ObservedZones zones;
  zones.list.resize(2);
  Sample sample;
  sample.rows.resize(20, 2);
  for (int k = 0; k < 20; ++k) sample.rows.row(k) = Eigen::RowVector2d(k % 2, 0.3);
  EXPECT_NEAR(effective_rocks(sample), 20, 1e-9);
  EXPECT_NEAR(effective_rocks(zones, sample), 20, 1e-9);
  // Two equal amounts with independent errors of 20 %: each share has the variance 0.2^2 / 8.
  zones.relative_accuracy = 0.2;
  EXPECT_NEAR(effective_rocks(zones, sample), 0.5 / (0.5 / 20 + 2 * 0.04 / 8), 1e-9);
  sample.rows(0, 1) = 3000;  // a single boulder
  EXPECT_LT(effective_rocks(sample), 1.01);
}

TEST_F(Zones, CompareWhatWasReleased) {
  EXPECT_EQ(
      problems_of("zone,from_m,to_m,count\na,0,70,5\nb,70,120,15\n", "released = 18"),
      "study.toml:6: observations \"zones\": the zones hold 20 rocks, but released is 18 (no more can come to rest "
      "than was released). Check the units of both");
  EXPECT_EQ(problems_of("zone,from_m,to_m,count\na,0,70,5\nb,70,120,15\n", "released = 30"), "was read");
  const PreparedStudy study = prepared();
  const ObservedGroup& group = study.groups().front();
  EXPECT_EQ(group.count(), 30U);
  EXPECT_NEAR(zone_shares(group.zones, group.sample)[2], 1.0 / 3, 1e-12);
}

TEST_F(Zones, RefuseWhatCannotBeCompared) {
  EXPECT_EQ(problems_of("zone,from_m,to_m\na,0,70\n"),
            "zones.csv:1: there is no column volume_m3, count or share. Say how much came to rest in each zone: "
            "volume_m3 (its volume), count (its rocks) or share (of all that was released)");
  EXPECT_EQ(problems_of("zone,from_m,to_m,volume_l\na,0,70,3\n"),
            "zones.csv:1: column \"volume_l\" has another unit (the unit is in the name; expected volume_m3). Convert "
            "it, and name it volume_m3");
  EXPECT_EQ(
      problems_of("zone,from_m,to_m,volume_m3\na,0,70,3\nb,60,90,4\n"),
      "zones.csv:3: zones \"a\" and \"b\" overlap (a rock lies in one zone). Draw zones that have only borders in "
      "common");
  EXPECT_EQ(problems_of("zone,from_m,to_m,volume_m3\na,70,0,3\nb,400,500,4\n"),
            "zones.csv:2: zone \"a\" extends from 70 to 0 m (expected from_m below to_m). Exchange the two\n"
            "zones.csv:3: zone \"b\" is off the terrain (the section extends from x = 0 to 300). It may be in another "
            "coordinate system, or the terrain must be extended");
  EXPECT_EQ(problems_of("zone,from_m,to_m,volume_m3\na,0,70,\nb,70,90,-4\n"),
            "zones.csv:2: zone \"a\" has no amount (expected 0 or more). Write 0 where nothing came to rest\n"
            "zones.csv:3: zone \"b\" has the amount -4 (expected 0 or more). Write 0 where nothing came to rest");
  EXPECT_EQ(problems_of("zone,from_m,to_m,share\na,0,70,30\nb,70,90,60\n", "blocks = 20"),
            "zones.csv: the shares add up to 90 (they are shares of all that was released). Divide percentages by 100");
  EXPECT_EQ(problems_of("zone,from_m,to_m,share\na,0,70,0.3\nb,70,90,0.6\n"),
            "study.toml:6: observations \"zones\": blocks is missing (a share says nothing of how many rocks it was "
            "counted from). Write blocks = the number of rocks that were released");
  EXPECT_EQ(problems_of("zone,from_m,to_m,volume_m3\na,0,70,3\n"),
            "zones.csv: there is one zone (its share of what the zones hold is 1 whatever the parameters). Write "
            "released = the volume or count of all rocks, or add zones");
  EXPECT_NE(problems_of("zone,from_m,to_m,volume_m3\na,0,70,0.001\nb,70,90,0.002\n").find("as much as 0.0"),
            std::string::npos);
}

TEST_F(Zones, AreReadAsOutlinesInSpace) {
  write("slope.toml", wide_slope);
  const std::string outlines =
      "zone,x_m,y_m,count\nnear,0,0,12\nnear,100,0,\nnear,100,100,\nnear,0,100,\nfar,100,0,3\nfar,290,0,\nfar,290,100,"
      "\n";
  EXPECT_EQ(problems_of(outlines), "was read");
  const PreparedStudy study = prepared();
  const ObservedZones& zones = study.groups().front().zones;
  EXPECT_EQ(zones.of({50, 50}), 0U);
  EXPECT_EQ(zones.of({280, 50}), 1U);
  EXPECT_EQ(zones.of({120, 90}), 2U);  // beyond the diagonal
  EXPECT_EQ(problems_of(replaced(outlines, "far,290,0,", "far,90,50,")),
            "zones.csv:6: zones \"near\" and \"far\" overlap (a rock lies in one zone). Draw zones that have only "
            "borders in common");
  EXPECT_EQ(problems_of("zone,x_m,y_m,count\na,0,0,2\na,9,9,\na,9,0,\na,0,9,\n").substr(0, 58),
            "zones.csv:2: the outline of zone \"a\" crosses itself (at (4");
}

TEST_F(Zones, SayWhatTheyLeaveOut) {
  write("zones.csv", "zone,from_m,to_m,count\na,70,74,5\nb,74,77,4\n");
  const CalibrationResult result = calibrate(prepared());
  EXPECT_NE(result.warnings.text().find("of what comes to rest with the best set (the rest is not compared"),
            std::string::npos)
      << result.warnings.text();
}

}  // namespace
}  // namespace talus::calibration
