// The maps of a whole run.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "program.hpp"
#include "talus/campaign/campaign.hpp"
#include "talus/io/map_files.hpp"
#include "talus/project/model.hpp"
#include "talus/project/read.hpp"
#include "talus/project/run.hpp"
#include "talus/results/map_observer.hpp"
#include "talus/results/summary.hpp"

namespace talus::test {
namespace {

std::map<std::string, std::string> contents(const Workplace& work, const std::string& folder) {
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(work / folder)) {
    const std::string name = entry.path().filename();
    found[name] = work.read(folder + "/" + name);
  }
  return found;
}

TEST(RunMaps, AreTheSameBytesOnAnyNumberOfThreads) {
  if (!io::can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  const auto run = [&](const std::string& folder, const std::string& settings, int threads) {
    const Said said = talus_says("run " + tutorial("3d") + " -q --set output.report=false " + settings + " --threads " +
                                 std::to_string(threads) + " -o " + (work / folder).string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
    return contents(work, folder + "/maps");
  };
  for (const std::string settings : {"--rocks 6000 --set output.raster_cell_m=0.25",
                                     "--rocks 600 --set analysis.model=rigid_sphere --set output.percentiles=[]"}) {
    const auto one = run("one", settings, 1);
    EXPECT_GE(one.size(), 24U);
    EXPECT_EQ(run("two", settings, 2), one) << settings;
    EXPECT_EQ(run("eight", settings, 8), one) << settings;
    std::filesystem::remove_all(work / "one");
    std::filesystem::remove_all(work / "two");
    std::filesystem::remove_all(work / "eight");
  }
}

TEST(RunMaps, OfAnEarlierRunDoNotStay) {
  if (!io::can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  const auto run = [&](const std::string& settings) {
    const Said said =
        talus_says("run " + tutorial("3d") + " -q --rocks 50 " + settings + " -o " + (work / "out").string());
    EXPECT_EQ(said.exit_code, 0) << said.text;
  };
  run("--set output.percentiles=[50,97.5]");
  const auto first = contents(work, "out/maps");
  EXPECT_EQ(first.count("velocity_p97.5_m_s.tif"), 1U);
  work.write("out/maps/velocity_mine.tif", "somebody else's");
  run("--set output.percentiles=[90]");
  const auto second = contents(work, "out/maps");
  EXPECT_EQ(second.count("velocity_p97.5_m_s.tif") + second.count("velocity_p50_m_s.qml"), 0U);
  EXPECT_EQ(second.count("velocity_p90_m_s.tif"), 1U);
  run("--set output.maps=false");
  EXPECT_EQ(contents(work, "out/maps").size(), 1U);
  EXPECT_EQ(work.read("out/maps/velocity_mine.tif"), "somebody else's");
}

TEST(RunMaps, AreWrittenOnlyWhereTheProjectWantsThem) {
  const Workplace work;
  EXPECT_EQ(
      talus_says("run " + tutorial("3d") + " --set output.maps=false -o " + (work / "without").string()).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(work / "without/maps"));
  const Said flat = talus_says("run " + tutorial("2d") + " -o " + (work / "2d").string());
  EXPECT_EQ(flat.exit_code, 0);
  EXPECT_EQ(flat.text.find("maps"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(work / "2d/maps"));
}

// What the maps say of all rocks is what the summary says of them.
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
        const MapTally* tally = tile->find(k % Maps::tile_side, k / Maps::tile_side);
        if (tally == nullptr) continue;
        deposits += tally->deposits();
        energy = std::max(energy, tally->maximum(MapQuantity::energy_total));
        height = std::max(height, tally->maximum(MapQuantity::bounce_height));
      }
    }
    EXPECT_EQ(maps->maps().rocks(), summary.done);
    EXPECT_EQ(deposits, summary.ends[static_cast<std::size_t>(EndReason::at_rest)] +
                            summary.ends[static_cast<std::size_t>(EndReason::stopped_by_barrier)]);
    const double greatest = *summary.max_kinetic_energy.describe().maximum;
    EXPECT_NEAR(energy, greatest, 1e-6 * greatest);
    // Samples: never above the greatest height, and close to it.
    const double highest = *summary.max_bounce.describe().maximum;
    EXPECT_LE(height, highest * (1 + 1e-6));
    EXPECT_GE(height, highest * 0.95);
  }
}

}  // namespace
}  // namespace talus::test
