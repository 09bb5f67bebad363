// Whole runs of ensembles with parameters of their own: maps of the range between them, the column `ensemble`, and the
// same bytes however the rocks are divided.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "run/loaded_run.hpp"
#include "support/thread_ranks.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/files/csv_table.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/maps/map_reading.hpp"
#include "talus/model/model.hpp"
#include "talus/project/parameter.hpp"
#include "talus/project/read.hpp"
#include "talus/run/merge.hpp"
#include "talus/run/run.hpp"
#include "talus/run/run_on_ranks.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {
namespace {

namespace fs = std::filesystem;
using test::differences;
using test::files_of;
using test::Workplace;

constexpr int ensembles = 7;
constexpr std::uint64_t rocks = 1200;

/// The tutorial's slope in 3D with a barrier, a collector and two sources; a set of parameters for each ensemble.
LoadedRun loaded_run(const Workplace& work, std::vector<std::string> settings = {}) {
  const std::string file = test::write_slope_with_barrier(work);
  std::string sample = "material.0.normal_restitution.mean,material.*.tangential_restitution.mean\n";
  for (int k = 0; k < ensembles; ++k)
    sample += std::to_string(0.2 + 0.06 * k) + "," + std::to_string(0.95 - 0.05 * k) + "\n";
  (void)work.write("posterior.csv", sample);
  for (const char* setting : {"sampling.parameters=\"posterior.csv\"", "sampling.ensembles=7",
                              "output.percentiles=[50,95]", "output.raster_cell_m=2", "output.report=false"})
    settings.insert(settings.begin(), setting);
  Reading reading = read_project(file, {settings, static_cast<std::int64_t>(rocks), {}});
  LoadedRun loaded{std::move(reading.project), std::move(reading.warnings), {}};
  loaded.model = build_model(loaded.project, loaded.warnings);
  return loaded;
}

RunResult run_with_ensembles(const LoadedRun& loaded, const fs::path& folder,
                             const RunOptions& options = {.campaign = {.threads = 2}}) {
  return run_into(folder, loaded.project, loaded.model, loaded.warnings, options);
}

/// The maps of one ensemble's rocks, simulated rock by rock on a model with its parameters and no ensembles.
void write_maps_of(const LoadedRun& loaded, std::uint64_t ensemble, const fs::path& folder) {
  Project alone = loaded.project;
  alone.sampling.parameters.clear();
  Problems none;
  const auto& set = loaded.model.drawn_parameters[ensemble];
  for (std::size_t k = 0; k < set.size(); ++k) {
    const auto number = SettingNumber::find(alone, loaded.model.uncertain[k], {}, none);
    ASSERT_TRUE(number);
    ASSERT_FALSE(number->set(alone, set[k]));
  }
  Model model = build_model(alone, none);
  ASSERT_TRUE(model.ensembles.empty());
  model.seeders = loaded.model.seeders;  // ensembles have the same places
  set_properties(alone, model);
  const auto maps = map_observer(alone, model);
  const auto part = maps->new_part();
  Simulator simulator(model);
  for (std::uint64_t rock = ensemble; rock < model.rocks(); rock += ensembles) {
    const RockRecord record = simulator.simulate(rock, false, true);
    part->see(record, simulator.log());
  }
  maps->commit(*part);
  (void)write_maps(maps->maps(), map_selection(alone, model), "", folder / "maps");
}

/// A map by the south-western corner of its cells, in cells; NaN where it has no data or ends.
class MapByPlace {
 public:
  MapByPlace(const fs::path& folder, const std::string& name) {
    MapFile file;
    file.name = name;
    map_ = read_map(folder, file, 4096);
  }
  [[nodiscard]] const MapValues& map() const { return map_; }
  [[nodiscard]] double at(double x, double y) const {
    const int column = static_cast<int>(std::lround((x - map_.origin[0]) / map_.cell[0]));
    const int row = static_cast<int>(std::lround((y - map_.origin[1]) / map_.cell[1]));
    if (column < 0 || row < 0 || column >= map_.columns || row >= map_.rows) return std::nan("");
    return map_.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.columns) +
                       static_cast<std::size_t>(column)];
  }

 private:
  MapValues map_;
};

/// By the definition of spreadsheets.
double percentile(std::vector<double> values, double p) {
  std::ranges::sort(values);
  const double place = p * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const double high = values[std::min(low + 1, values.size() - 1)];
  return values[low] + (place - static_cast<double>(low)) * (high - values[low]);
}

TEST(EnsembleMaps, AreThePercentilesOfTheMapsOfEachEnsembleAlone) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  const LoadedRun loaded = loaded_run(work, {"output.bands=true", "output.means=true", "output.percentiles=[50,95]"});
  run_with_ensembles(loaded, work / "out");
  for (int k = 0; k < ensembles; ++k) write_maps_of(loaded, static_cast<std::uint64_t>(k), work / std::to_string(k));
  for (const auto& [before, unit] : {std::pair{"reach_share", ""},
                                     {"energy_total_max", "_kJ"},
                                     {"energy_translational_mean", "_kJ"},
                                     {"velocity_p95", "_m_s"},
                                     {"bounce_height_p50", "_m"},
                                     {"bounce_height_max", "_m"}}) {
    const std::string name = before;
    std::vector<MapByPlace> alone;
    for (int k = 0; k < ensembles; ++k) alone.emplace_back(work / std::to_string(k), name + unit);
    const MapByPlace whole(work / "out", name + unit);
    for (const auto& [end, p] : {std::pair{"_low", 0.05}, {"_high", 0.95}}) {
      const MapByPlace band(work / "out", name + end + unit);
      const MapValues& map = whole.map();
      int cells = 0, some = 0;
      for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
          const double x = map.origin[0] + column * map.cell[0], y = map.origin[1] + row * map.cell[1];
          if (std::isnan(whole.at(x, y))) {
            EXPECT_TRUE(std::isnan(band.at(x, y)));
            continue;
          }
          std::vector<double> values;
          for (const MapByPlace& each : alone) values.push_back(std::isnan(each.at(x, y)) ? 0 : each.at(x, y));
          const auto without =
              std::ranges::count_if(alone, [&](const MapByPlace& each) { return std::isnan(each.at(x, y)); });
          const double expected = percentile(values, p), found = band.at(x, y);
          // The higher of the two ensembles that it lies between.
          const bool is_among_those_without = static_cast<double>(without) > std::ceil(p * (ensembles - 1));
          EXPECT_EQ(std::isnan(found), is_among_those_without) << name << end << " at " << x << " " << y;
          if (std::isnan(found)) continue;
          EXPECT_NEAR(found, expected, 1e-6 * std::max(1.0, expected)) << name << end << " at " << x << " " << y;
          ++cells;
          some += without > 0 ? 1 : 0;
        }
      }
      EXPECT_GT(cells, 50) << name << end;
      EXPECT_GT(some, 0) << name << end;
    }
  }
}

TEST(EnsembleMaps, ShowThePartOfTheParameters) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  run_with_ensembles(loaded_run(work), work / "out");
  MapFile part;
  part.name = "reach_share_parameter_part";
  int cells = 0;
  for (const float value : read_map(work / "out", part, 4096).values) {
    if (std::isnan(value)) continue;
    EXPECT_GE(value, 0);
    EXPECT_LE(value, 1);
    cells += value > 0 ? 1 : 0;
  }
  EXPECT_GT(cells, 20);
}

TEST(EnsembleMaps, AreThoseOfTheBandsAlone) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const Workplace work;
  run_with_ensembles(loaded_run(work), work / "out");
  EXPECT_TRUE(fs::exists(work / "out/maps/reach_share_low.tif"));
  EXPECT_FALSE(fs::exists(work / "out/maps/energy_total_max_low_kJ.tif"));
  EXPECT_NE(test::bytes_of(work / "out/files.json").find("maps/reach_share_high.tif"), std::string::npos);
  std::vector<std::string> names;
  for (const MapFile& map : maps_of_run(work / "out")) names.push_back(map.name);
  EXPECT_THAT(names, ::testing::Contains("reach_share_low"));
  run_with_ensembles(loaded_run(work, {"output.bands=[\"velocity\"]", "output.maps=[\"velocity\"]",
                                       "output.percentiles=[]", "output.means=true"}),
                     work / "out");
  names.clear();
  for (const MapFile& map : maps_of_run(work / "out")) names.push_back(map.name);
  EXPECT_THAT(names,
              ::testing::ElementsAre("velocity_max_m_s", "velocity_mean_m_s", "velocity_max_low_m_s",
                                     "velocity_max_high_m_s", "velocity_mean_low_m_s", "velocity_mean_high_m_s"));
  EXPECT_FALSE(fs::exists(work / "out/maps/reach_share_low.tif")) << "of an earlier run";
}

TEST(EnsembleMaps, TakeMemoryThatIsLimited) {
  const Workplace work;
  const auto bytes = [&](const std::vector<std::string>& settings) {
    const LoadedRun loaded = loaded_run(work, settings);
    const auto maps = map_observer(loaded.project, loaded.model);
    Observer* const observers[] = {maps.get()};
    (void)run_campaign(loaded.model, observers, {.threads = 2});
    (void)maps->maps();
    return maps->memory_taken();
  };
  const std::size_t none = bytes({"output.bands=false"}), reach = bytes({}), all = bytes({"output.bands=true"});
  EXPECT_GT(reach, none + 7 * 2000);
  EXPECT_GT(all, reach);
  const LoadedRun loaded = loaded_run(work, {"output.bands=true"});
  EXPECT_THROW(run_with_ensembles(loaded, work / "out", {.campaign = {.threads = 2}, .maps_memory = (none + all) / 2}),
               OutOfMemory);
}

TEST(EnsembleRuns, NameTheEnsembleOfEachRock) {
  const Workplace work;
  run_with_ensembles(loaded_run(work), work / "out");
  int ends = 0, hits = 0;
  for (TableReader<EndpointRow> row(work / "out/endpoints.csv"); row.next(); ++ends)
    EXPECT_EQ(row.get<&EndpointRow::ensemble>(), row.get<&EndpointRow::rock>() % ensembles);
  for (TableReader<HitRow> row(work / "out/barriers.csv"); row.next(); ++hits)
    EXPECT_EQ(row.get<&HitRow::ensemble>(), row.get<&HitRow::rock>() % ensembles);
  EXPECT_GT(ends, 1000);
  EXPECT_GT(hits, 100);
  EXPECT_THAT(test::bytes_of(work / "out/uncertainty.csv"), ::testing::HasSubstr("\nenergy,95,Fence,J,7,"));
  Reading plain = read_project(work / "slope.toml", {{"output.report=false", "output.maps=false"}, 100, {}});
  LoadedRun alone{std::move(plain.project), std::move(plain.warnings), {}};
  alone.model = build_model(alone.project, alone.warnings);
  run_with_ensembles(alone, work / "alone");
  EXPECT_FALSE(fs::exists(work / "alone/uncertainty.csv"));
  for (TableReader<EndpointRow> row(work / "alone/endpoints.csv"); row.next();)
    EXPECT_FALSE(row.get<&EndpointRow::ensemble>());
}

TEST(EnsembleRuns, GiveTheSameBytesHoweverTheRocksAreDivided) {
  const Workplace work;
  const LoadedRun loaded = loaded_run(work, {"output.bands=[\"reach_share\",\"energy_total\"]",
                                             "output.maps_by_source=true", "output.report=true", "output.paths=100"});
  run_with_ensembles(loaded, work / "whole", {.campaign = {.threads = 1}});
  const auto whole = files_of(work / "whole");
  ASSERT_GT(whole.size(), 8U);
  run_with_ensembles(loaded, work / "threads", {.campaign = {.threads = 4}});
  EXPECT_EQ(differences(whole, files_of(work / "threads")), "");

  MergeOptions merge{.folders = {}, .output = work / "merged"};
  for (const std::uint64_t number : {3, 1, 2}) {
    merge.folders.push_back(work / std::to_string(number));
    run_with_ensembles(loaded, merge.folders.back(), {.campaign = {.threads = 2}, .shard = Shard{number, 3}});
  }
  merge_runs(merge);
  EXPECT_EQ(differences(whole, files_of(work / "merged")), "");

  bool is_interrupted = true;
  int times = 0;
  for (; is_interrupted; ++times) {
    ASSERT_LT(times, 100);
    std::atomic<bool> stop{false};
    RunOptions options{.campaign = {.threads = 2, .stop = &stop}, .resume = true, .checkpoint_every = 1e-6};
    std::uint64_t begin = 0;
    options.campaign.progress = [&](std::uint64_t now) {
      if (begin == 0) begin = std::max<std::uint64_t>(now, 1);
      if (times == 0 || now > begin + 300) stop = true;
    };
    is_interrupted = run_with_ensembles(loaded, work / "resumed", options).outcome.interrupted;
  }
  EXPECT_GT(times, 1);
  EXPECT_EQ(differences(whole, files_of(work / "resumed")), "");

  RunOptions options{.campaign = {.threads = 1}};
  testing_tools::with_ranks(
      3,
      [&](Ranks& mine) {
        options.ranks = &mine;
        run_with_ensembles(loaded, work / "ranks", options);
        dismiss_ranks(mine, 0);
      },
      [&](Ranks& mine) { EXPECT_EQ(help_run(mine, loaded.project, loaded.model, loaded.warnings, {}), 0); });
  EXPECT_EQ(differences(whole, files_of(work / "ranks")), "");
}

// A section has envelopes instead of maps.
TEST(EnsembleRuns, HaveBandsAlongASection) {
  const Workplace work;
  (void)work.write("posterior.csv", "material.0.normal_restitution.mean\n0.2\n0.5\n0.7\n");
  Reading reading = read_project(
      test::tutorial("2d"),
      {{"sampling.parameters=\"" + (work / "posterior.csv").string() + "\"", "sampling.ensembles=3"}, 300, {}});
  LoadedRun loaded{std::move(reading.project), std::move(reading.warnings), {}};
  loaded.model = build_model(loaded.project, loaded.warnings);
  run_with_ensembles(loaded, work / "out");
  const std::string table = test::bytes_of(work / "out/envelopes.csv");
  EXPECT_THAT(table.substr(0, table.find('\n')),
              ::testing::HasSubstr(
                  "reach_share,deposits,impacts,reach_share_low,reach_share_high,reach_share_parameter_part,"));
  EXPECT_NE(test::bytes_of(work / "out/report.html").find("reach_share_low"), std::string::npos);
}

}  // namespace
}  // namespace talus::project
