// Maps of whole runs.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "program.hpp"
#include "talus/campaign/campaign.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/results/summary.hpp"
#include "talus/run/run.hpp"

namespace talus::test {
namespace {

std::map<std::string, std::string> contents(const Workplace& work, const std::string& folder) {
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(work / folder)) {
    const std::string name = entry.path().filename();
    found[name] = entry.is_directory() ? "a folder" : work.read(folder + "/" + name);
  }
  return found;
}

TEST(RunMaps, AreTheSameBytesOnAnyNumberOfThreads) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  const auto run = [&](const std::string& folder, const std::string& settings, int threads) {
    const Said said = talus_says("run " + tutorial("3d") + " -q --set output.report=false " + settings + " --threads " +
                                 std::to_string(threads) + " -o " + (work / folder).string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
    return contents(work, folder + "/maps");
  };
  for (const std::string settings : {"--rocks 6000 --set output.raster_cell_m=0.25 --set output.means=true",
                                     "--rocks 600 --set analysis.model=rigid_sphere --set output.percentiles=[]"}) {
    const auto one = run("one", settings, 1);
    EXPECT_GE(one.size(), 16U);
    EXPECT_EQ(run("two", settings, 2), one) << settings;
    EXPECT_EQ(run("eight", settings, 8), one) << settings;
    std::filesystem::remove_all(work / "one");
    std::filesystem::remove_all(work / "two");
    std::filesystem::remove_all(work / "eight");
  }
}

/// A slope falling along x, with two cliffs; one of them is the source of two seeders.
const char* const two_cliffs = R"(
[terrain]
vertices = [[0, 0, 60], [200, 0, 0], [200, 100, 0], [0, 100, 60], [260, 0, 0], [260, 100, 0]]
triangles = [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]]
[[material]]
name = "Rock"
normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 0.1 }
friction_angle_deg = 33
roughness_deg = 5
[[seeder]]
source = "Upper/\u00e4"
position = [5, 20, "surface"]
rocks = 300
mass_kg = 1000
horizontal_velocity_m_s = 5
[[seeder]]
source = "Lower"
type = "line"
points = [[60, 20, "surface"], [60, 90, "surface"]]
rocks = 400
mass_kg = 1000
horizontal_velocity_m_s = 5
[[seeder]]
source = "Upper/\u00e4"
position = [5, 70, "surface"]
rocks = 300
mass_kg = 1000
horizontal_velocity_m_s = 5
[output]
raster_cell_m = 2
report = false
geopackage = "none"
)";

TEST(RunMaps, SplittingBySourceDoesNotChangeTheMapsOfAllRocks) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  const std::string project = work.write("cliffs.toml", two_cliffs);
  const auto run = [&](const std::string& folder, const std::string& settings) {
    const Said said = talus_says("run " + project + " -q " + settings + " -o " + (work / folder).string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
  };
  run("whole", "");
  run("split", "--set output.maps_by_source=true --threads 1");
  EXPECT_FALSE(std::filesystem::exists(work / "whole/maps/by_source"));
  auto whole = contents(work, "whole/maps"), split = contents(work, "split/maps");
  EXPECT_EQ(split.size(), whole.size() + 1);
  for (const auto& [name, bytes] : whole) EXPECT_TRUE(split[name] == bytes) << name;

  EXPECT_EQ(work.read("split/maps/by_source/sources.csv"),
            "folder,source,rocks\nUpper_ä,Upper/ä,600\nLower,Lower,400\n");
  const auto upper = contents(work, "split/maps/by_source/Upper_ä"),
             lower = contents(work, "split/maps/by_source/Lower");
  EXPECT_EQ(upper.size(), whole.size());
  EXPECT_EQ(lower.size(), whole.size());
  EXPECT_FALSE(upper == lower);

  run("eight", "--set output.maps_by_source=true --threads 8");
  EXPECT_TRUE(contents(work, "eight/maps/by_source/Upper_ä") == upper);
  EXPECT_TRUE(contents(work, "eight/maps/by_source/Lower") == lower);
  run("split", "--set output.maps_by_source=false");
  EXPECT_FALSE(std::filesystem::exists(work / "split/maps/by_source"));
}

TEST(RunMaps, OfAnEarlierRunAreRemoved) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  const auto run = [&](const std::string& settings) {
    const Said said =
        talus_says("run " + tutorial("3d") + " -q --rocks 50 " + settings + " -o " + (work / "out").string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
  };
  run("--set output.percentiles=[50,97.5]");
  const auto first = contents(work, "out/maps");
  EXPECT_EQ(first.count("velocity_p97.5_m_s.tif"), 1U);
  work.write("out/maps/velocity_mine.tif", "not from Talus");
  run("--set output.percentiles=[90]");
  const auto second = contents(work, "out/maps");
  EXPECT_EQ(second.count("velocity_p97.5_m_s.tif") + second.count("velocity_p50_m_s.qml"), 0U);
  EXPECT_EQ(second.count("velocity_p90_m_s.tif"), 1U);
  run("--set output.maps=false");
  EXPECT_EQ(contents(work, "out/maps").size(), 1U);
  EXPECT_EQ(work.read("out/maps/velocity_mine.tif"), "not from Talus");
}

TEST(RunMaps, AreWrittenOnlyIfTheProjectAsksForThem) {
  const Workplace work;
  EXPECT_EQ(
      talus_says("run " + tutorial("3d") + " --set output.maps=false -o " + (work / "without").string()).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(work / "without/maps"));
  const Said flat = talus_says("run " + tutorial("2d") + " -o " + (work / "2d").string());
  EXPECT_EQ(flat.exit_code, 0);
  EXPECT_EQ(flat.text.find("maps"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(work / "2d/maps"));
}

std::set<std::string> names_in(const Workplace& work, const std::string& folder) {
  std::set<std::string> names;
  for (const auto& [name, bytes] : contents(work, folder)) names.insert(name);
  return names;
}

TEST(RunMaps, ASelectionHasTheSameBytesAsAllMaps) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  const std::string project = work.write("cliffs.toml", two_cliffs);
  const auto run = [&](const std::string& folder, const std::string& settings) {
    const Said said = talus_says("run " + project + " -q " + settings + " -o " + (work / folder).string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
  };
  run("all", "--set output.maps_by_source=true --set output.means=true --set output.percentiles=[50,95,99]");
  run("some", R"(--set output.maps_by_source=true --set 'output.maps=["bounce_height","reach_share"]')");
  for (const std::string folder : {"maps", "maps/by_source/Lower"}) {
    auto all = contents(work, "all/" + folder);
    const auto some = contents(work, "some/" + folder);
    std::set<std::string> expected{"reach_share.tif", "reach_share.qml"};
    if (folder == "maps") expected.insert("by_source");
    for (const char* part : {"max", "p95"}) {
      for (const char* ending : {".tif", ".qml"}) expected.insert(std::string("bounce_height_") + part + "_m" + ending);
    }
    EXPECT_EQ(names_in(work, "some/" + folder), expected);
    for (const auto& [name, bytes] : some) EXPECT_TRUE(all[name] == bytes) << name;
  }
  // Maps of an earlier run with more maps are removed; an empty list means no maps.
  run("all", R"(--set 'output.maps=["impacts"]')");
  EXPECT_EQ(names_in(work, "all/maps"), (std::set<std::string>{"impacts.tif", "impacts.qml"}));
  run("all", "--set output.maps=[]");
  EXPECT_EQ(names_in(work, "all/maps"), std::set<std::string>{});
}

TEST(RunMaps, ASelectionIsMergedAndResumedToTheSameBytes) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  const std::string project = work.write("cliffs.toml", two_cliffs);
  const std::string run = "run " + project + R"( -q --set 'output.maps=["velocity","deposits"]' )";
  const auto into = [&](const std::string& folder) { return " -o " + (work / folder).string(); };
  EXPECT_EQ(talus_says(run + into("whole")).exit_code, 0);
  for (const char* shard : {"1", "2"}) {
    const Said said = talus_says(run + "--shard " + shard + "/2" + into(std::string("part-") + shard));
    EXPECT_EQ(said.exit_code, 0) << said.text;
  }
  const Said merged =
      talus_says("merge " + (work / "part-1").string() + " " + (work / "part-2").string() + into("merged"));
  EXPECT_EQ(merged.exit_code, 0) << merged.text;
  EXPECT_TRUE(contents(work, "merged/maps") == contents(work, "whole/maps"));

  std::filesystem::remove(work / "whole/maps/deposits.tif");
  const Said again = talus_says(run + "--resume" + into("whole"));
  EXPECT_EQ(again.exit_code, 0) << again.text;
  EXPECT_TRUE(contents(work, "merged/maps") == contents(work, "whole/maps"));
  const Said other = talus_says("run " + project + " -q --resume" + into("whole"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(other.text, (work / "whole/summary.json").string() +
                            ": these are the results of another project (output.maps was "
                            "[\"deposits\",\"velocity\"] and is true). Undo the change to resume, or run without "
                            "--resume to start over\n");
}

TEST(RunMaps, SelectTheColumnsOfEnvelopesInSection) {
  const Workplace work;
  const auto run = [&](const std::string& settings) {
    const Said said = talus_says("run " + tutorial("2d") + " -q " + settings + " -o " + (work / "out").string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
    const std::string text = work.read("out/envelopes.csv");
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(run(R"(--set 'output.maps=["velocity","passages"]' --set output.percentiles=[95])"),
            "x_m,passages,velocity_max_m_s,velocity_mean_m_s,velocity_p95_m_s");
  EXPECT_EQ(run("--set output.maps=[]"), "");
  EXPECT_FALSE(std::filesystem::exists(work / "out/envelopes.csv"));
}

TEST(RunMaps, GatherOnlyTheSelectedQuantities) {
  const auto gathered = [](const std::string& maps, const std::string& percentiles, const std::string& means) {
    Problems warnings;
    const std::vector<std::string> settings{"output.maps=" + maps, "output.percentiles=" + percentiles,
                                            "output.means=" + means};
    const auto project = project::read_project(tutorial("3d"), {settings, 5, {}}).project;
    const Model model = project::build_model(project, warnings);
    return project::map_observer(project, model)->maps().contents();
  };
  EXPECT_EQ(gathered("true", "[50]", "true"), MapContents());
  EXPECT_EQ(gathered(R"(["passages"])", "[50]", "true"), MapContents({}, {}));
  EXPECT_EQ(gathered(R"(["velocity","impacts"])", "[50]", "false"),
            MapContents({false, false, true, false}, {false, false, true, false}, false));
  EXPECT_EQ(gathered(R"(["velocity","energy_total"])", "[]", "false"),
            MapContents({true, false, true, false}, {}, false));
}

TEST(RunMaps, AgreeWithTheSummary) {
  for (const char* kind : {"lumped_mass", "rigid_sphere"}) {
    Problems warnings;
    const auto project =
        project::read_project(tutorial("3d"), {{std::string("analysis.model=") + kind}, 500, {}}).project;
    const Model model = project::build_model(project, warnings);
    const auto maps = project::map_observer(project, model);
    ASSERT_TRUE(maps);
    SummaryObserver statistics(model.rocks(), model.barriers.size(), model.frame);
    Observer* const observers[] = {&statistics, maps.get()};
    run_campaign(model, observers, {});

    const Summary& summary = statistics.summary();
    std::uint64_t deposits = 0;
    double energy = 0, height = 0;
    for (const Maps::Tile* tile : maps->maps().tiles()) {
      for (std::int32_t k = 0; k < Maps::tile_side * Maps::tile_side; ++k) {
        const auto tally = tile->find(k % Maps::tile_side, k / Maps::tile_side);
        if (!tally) continue;
        deposits += tally->deposits();
        energy = std::max(energy, tally->maximum(MapQuantity::energy_total));
        height = std::max(height, tally->maximum(MapQuantity::bounce_height));
      }
    }
    EXPECT_EQ(maps->maps().rocks(), summary.done);
    EXPECT_EQ(deposits, summary.ends[static_cast<std::size_t>(EndReason::at_rest)] +
                            summary.ends[static_cast<std::size_t>(EndReason::stopped_by_barrier)]);
    const double expected = *summary.max_kinetic_energy.describe().maximum;
    EXPECT_NEAR(energy, expected, 1e-6 * expected);
    // Heights in maps are samples: never above the maximum, and close to it.
    const double highest = *summary.max_bounce.describe().maximum;
    EXPECT_LE(height, highest * (1 + 1e-6));
    EXPECT_GE(height, highest * 0.95);
  }
}

}  // namespace
}  // namespace talus::test
