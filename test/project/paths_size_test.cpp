#include "talus/project/paths_size.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "cli/program.hpp"
#include "talus/project/model.hpp"
#include "talus/project/read.hpp"
#include "talus/project/run.hpp"

namespace talus::project {
namespace {

TEST(PathsSize, IsAboutWhatIsWritten) {
  const test::Workplace work;
  for (const char* limit : {"\"all\"", "150"}) {
    Reading reading =
        read_project(test::tutorial("3d"),
                     {{std::string("output.paths=") + limit, "output.report=false", "output.maps=false"}, 600, {}});
    const Model model = build_model(reading.project, reading.warnings);
    run_into(work / "out", reading.project, model, reading.warnings, {});
    const auto written = static_cast<double>(std::filesystem::file_size(work / "out/paths.csv"));
    const double expected = expected_paths_bytes(model, {0, model.rocks()}, reading.project.output.path_limit);
    EXPECT_GT(expected, 0.7 * written) << limit;
    EXPECT_LT(expected, 1.4 * written) << limit;
    EXPECT_NEAR(expected_paths_bytes(model, {300, 450}, reading.project.output.path_limit) / expected, 0.25, 0.1);
  }
}

TEST(PathsSize, OfNoRocksIsNothing) {
  Reading reading = read_project(test::tutorial("2d"), {});
  const Model model = build_model(reading.project, reading.warnings);
  EXPECT_EQ(expected_paths_bytes(model, {7, 7}, std::nullopt), 0);
  EXPECT_EQ(expected_paths_bytes(model, {0, 50}, 0), 0);
}

}  // namespace
}  // namespace talus::project
