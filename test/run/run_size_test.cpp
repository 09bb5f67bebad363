#include "talus/run/run_size.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "cli/program.hpp"
#include "talus/maps/map_files.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/run/run.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {
namespace {

struct Built {
  explicit Built(const std::string& paths, std::optional<std::int64_t> rocks = 3000)
      : reading(read_project(test::tutorial("3d"), {{"output.paths=" + paths, "output.endpoints=\"none\"",
                                                     "output.report=false", "output.maps=false"},
                                                    rocks,
                                                    {}})),
        model(build_model(reading.project, reading.warnings)) {}
  [[nodiscard]] RunSize expected(const RockRange& rocks) const { return expected_size(reading.project, model, rocks); }
  Reading reading;
  Model model;
};

TEST(RunSize, IsAboutWhatIsWritten) {
  const test::Workplace work;
  for (const char* paths : {"\"all\"", "300"}) {
    const Built built(paths);
    run_into(work / "out", built.reading.project, built.model, built.reading.warnings, {});
    const auto written = [&](const char* table) {
      return static_cast<double>(std::filesystem::file_size(work / "out" / table));
    };
    const RunSize size = built.expected({0, built.model.rocks()});
    EXPECT_GT(size.paths_bytes, 0.7 * written("paths.csv")) << paths;
    EXPECT_LT(size.paths_bytes, 1.4 * written("paths.csv")) << paths;
    // Rows of end points are of similar length; the header is not counted.
    EXPECT_NEAR(size.endpoints_bytes / written("endpoints.csv"), 1, 0.05) << paths;
    EXPECT_GT(size.processor_seconds, 0);
    const RunSize part = built.expected({1500, 2250});
    EXPECT_NEAR(part.paths_bytes / size.paths_bytes, 0.25, 0.1);
    EXPECT_EQ(part.bytes(), built.expected({1500, 2250}).bytes()) << "bytes depend on the rocks alone";
  }
}

TEST(RunSize, OfMapsIsAboutWhatIsWritten) {
  if (!can_write_maps()) GTEST_SKIP() << "built without GDAL";
  const test::Workplace work;
  for (const char* maps : {"true", R"(["bounce_height"])"}) {
    for (const char* cell : {"1", "0.2"}) {
      Reading reading = read_project(test::tutorial("3d"),
                                     {{std::string("output.maps=") + maps, std::string("output.raster_cell_m=") + cell,
                                       "output.paths=\"none\"", "output.endpoints=\"none\"", "output.report=false"},
                                      8000,
                                      {}});
      const Model model = build_model(reading.project, reading.warnings);
      run_into(work / "out", reading.project, model, reading.warnings, {});
      double written = 0;
      for (const auto& entry : std::filesystem::directory_iterator(work / "out/maps")) {
        if (entry.path().extension() == ".tif") written += static_cast<double>(entry.file_size());
      }
      const double expected = expected_size(reading.project, model, {0, 8000}).maps_bytes;
      EXPECT_GT(expected, written / 4) << maps << ' ' << cell;
      EXPECT_LT(expected, written * 4) << maps << ' ' << cell;
    }
  }
}

// Each rock touches `each` of `all` cells at random: n rocks touch all (1 - (1 - each / all)^n), and the number of
// rocks that touch a cell is binomially distributed. The estimate is a lower bound: too small by 2 % if hardly any cell
// was touched twice.
TEST(RunSize, FollowsFromTheCellsTouchedByOneAndByTwoRocks) {
  constexpr double all = 1e6, few = 32;
  for (const double each : {300.0, 3000.0, 30'000.0}) {
    const double p = each / all;
    const double touched = all * -std::expm1(few * std::log1p(-p));
    const double by_one = all * few * p * std::pow(1 - p, few - 1);
    const double by_two = all * few * (few - 1) / 2 * p * p * std::pow(1 - p, few - 2);
    for (const double rocks : {100.0, 2000.0, 1e5}) {
      const double expected = all * -std::expm1(rocks * std::log1p(-p));
      EXPECT_NEAR(expected_touched(few, touched, by_one, by_two, rocks) / expected, 1, 0.03) << each << ' ' << rocks;
    }
    EXPECT_EQ(expected_touched(few, touched, by_one, by_two, few), touched);
  }
  EXPECT_EQ(expected_touched(32, 10, 0, 0, 1e6), 10) << "all rocks take the same way";
  EXPECT_EQ(expected_touched(32, 10, 1, 0, 1e6), 10);
}

TEST(RunSize, IsNotEstimatedForFewRocks) {
  const Built few("\"all\"", 63);
  EXPECT_EQ(few.expected({0, 63}).bytes(), 0);
  EXPECT_FALSE(large_run_text(few.expected({0, 63}), 1));
  const std::atomic<bool> stop{true};
  const Built many("\"all\"");
  EXPECT_EQ(expected_size(many.reading.project, many.model, {0, 3000}, &stop).bytes(), 0);
}

TEST(RunSize, IsStatedBeforeMoreThanAGigabyte) {
  EXPECT_FALSE(large_run_text({.endpoints_bytes = 9.9e8}, 1));
  EXPECT_EQ(large_run_text(
                {.endpoints_bytes = 1.7e8, .barriers_bytes = 1e6, .paths_bytes = 6.1e9, .processor_seconds = 260}, 2),
            "The results will take about 6.3 GB (paths.csv 6.1 GB), the run about 2 min on 2 threads if the disk "
            "keeps up; less with output.paths = 300");
  EXPECT_EQ(
      large_run_text({.endpoints_bytes = 9e8, .barriers_bytes = 4e8, .paths_bytes = 3e8, .processor_seconds = 0.2}, 1),
      "The results will take about 1.6 GB (paths.csv 300 MB, endpoints.csv 900 MB, barriers.csv 400 MB), the run "
      "about 1 s on 1 thread if the disk keeps up; less with output.paths = 300 or output.endpoints = \"none\"");
  EXPECT_EQ(large_run_text({.endpoints_bytes = 1e8, .maps_bytes = 2.4e9, .processor_seconds = 90}, 1),
            "The results will take about 2.5 GB (maps 2.4 GB), the run about 90 s on 1 thread if the disk keeps up; "
            "less with fewer output.maps");
  const RunSize long_one{.barriers_bytes = 2e9, .processor_seconds = 36000};
  EXPECT_EQ(
      large_run_text(long_one, 1),
      "The results will take about 2.0 GB (barriers.csv 2.0 GB), the run about 10 h on 1 thread if the disk keeps up");
  EXPECT_EQ(
      large_run_text(long_one, 2),
      "The results will take about 2.0 GB (barriers.csv 2.0 GB), the run about 5 h on 2 threads if the disk keeps up");
}

}  // namespace
}  // namespace talus::project
