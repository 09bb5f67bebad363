// A run that is stopped while it writes its results keeps all rocks, and resumes to the same bytes.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <stop_token>
#include <thread>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "talus/core/stop.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/run/run.hpp"

namespace talus::project {
namespace {

namespace fs = std::filesystem;
using test::differences;
using test::files_of;
using test::Workplace;

class StoppedWriting : public testing::Test {
 protected:
  void SetUp() override {
    Reading reading = read_project(
        test::write_slope_with_barrier(work),
        {{"output.percentiles=[95]", "output.raster_cell_m=4", "output.paths=50", "output.vtk=true"}, 10'000, {}});
    project = std::move(reading.project);
    warnings = std::move(reading.warnings);
    model = build_model(project, warnings);
  }
  RunResult run(const char* folder, const RunOptions& options) {
    return run_into(work / folder, project, model, warnings, options);
  }
  /// A run that was never stopped.
  std::map<std::string, std::string> whole() {
    EXPECT_TRUE(run("whole", {}).has_results);
    return files_of(work / "whole");
  }
  void expect_whole_when_resumed(std::uint64_t done_before) {
    RunOptions options;
    options.resume = true;
    const RunResult result = run("stopped", options);
    EXPECT_TRUE(result.has_results);
    EXPECT_FALSE(result.outcome.interrupted);
    EXPECT_EQ(result.done_before, done_before);
    EXPECT_EQ(differences(whole(), files_of(work / "stopped")), "");
  }

  const Workplace work;
  Project project;
  Problems warnings;
  Model model;
};

TEST_F(StoppedWriting, AfterTheLastRockKeepsAllRocks) {
  std::atomic<bool> stop{false};
  RunOptions options;
  options.campaign.stop = &stop;
  options.campaign.progress = [&](std::uint64_t done) { stop = done == 10'000; };
  options.closing_seconds = 0;
  options.checkpoint_every = 0;  // no checkpoints, but the rocks done are kept anyway
  const RunResult result = run("stopped", options);
  EXPECT_FALSE(result.has_results);
  EXPECT_FALSE(result.outcome.interrupted);
  EXPECT_EQ(result.summary.done, 10'000U);
  EXPECT_TRUE(fs::exists(work / "stopped/run.state"));
  EXPECT_FALSE(fs::exists(work / "stopped/summary.json"));
  EXPECT_FALSE(fs::exists(work / "stopped/report.html"));
  expect_whole_when_resumed(10'000);
}

TEST_F(StoppedWriting, BetweenRocksKeepsTheRocksDone) {
  std::atomic<bool> stop{false};
  RunOptions options;
  options.campaign.stop = &stop;
  options.campaign.progress = [&](std::uint64_t done) { stop = stop || done >= 200; };
  options.closing_seconds = 0;
  const RunResult result = run("stopped", options);
  EXPECT_FALSE(result.has_results);
  EXPECT_TRUE(result.outcome.interrupted);
  const std::uint64_t done = result.summary.done;
  EXPECT_GE(done, 200U);
  EXPECT_LT(done, 10'000U);

  // Only the results so far are written.
  RunOptions writing;
  writing.resume = true;
  writing.only_results = true;
  const RunResult written = run("stopped", writing);
  EXPECT_TRUE(written.has_results);
  EXPECT_TRUE(written.outcome.interrupted);
  EXPECT_EQ(written.summary.done, done);
  EXPECT_TRUE(fs::exists(work / "stopped/maps/passages.tif"));
  EXPECT_TRUE(fs::exists(work / "stopped/report.html"));
  expect_whole_when_resumed(done);
}

TEST_F(StoppedWriting, TakesEffectBeforeTheFirstRock) {
  const std::atomic<bool> stop{true};
  RunOptions options;
  options.campaign.stop = &stop;
  EXPECT_THROW((void)run("stopped", options), Stopped);
}

TEST_F(StoppedWriting, TakesEffectWhileMapsAreWritten) {
  std::atomic<bool> stop{false};
  RunOptions options;
  options.campaign.stop = &stop;
  // From another thread, as soon as the first map is there.
  std::jthread other([&](const std::stop_token& over) {
    while (!over.stop_requested() && !fs::exists(work / "stopped/maps")) std::this_thread::yield();
    stop = true;
  });
  const RunResult result = run("stopped", options);
  EXPECT_EQ(result.summary.done, 10'000U);
  if (!result.has_results) {
    expect_whole_when_resumed(10'000);
  } else {
    EXPECT_EQ(differences(whole(), files_of(work / "stopped")), "");  // the stop came too late
  }
}

}  // namespace
}  // namespace talus::project
