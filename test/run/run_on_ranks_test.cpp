// Runs on several ranks without MPI: the ranks are threads. With MPI: test/cli/ranks_test.cpp.

#include "talus/run/run_on_ranks.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "run/loaded_run.hpp"
#include "support/endless_slope.hpp"
#include "support/thread_ranks.hpp"
#include "talus/archive/run_state.hpp"
#include "talus/core/stop.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/run/rank_messages.hpp"

namespace talus::project {
namespace {

namespace fs = std::filesystem;
using test::differences;
using test::files_of;
using test::Workplace;
using testing_tools::with_ranks;

/// In 3D with a barrier, maps by source and all paths.
LoadedRun load_run(const Workplace& work, const std::string& seed = "1") {
  const std::string file = test::write_slope_with_barrier(work);
  Reading reading =
      read_project(file, {{"output.maps_by_source=true", "output.percentiles=[95]", "output.raster_cell_m=4",
                           "output.report=false", "output.paths=\"all\"", "sampling.seed=" + seed},
                          2000,
                          {}});
  LoadedRun loaded{std::move(reading.project), std::move(reading.warnings), {}};
  loaded.model = build_model(loaded.project, loaded.warnings);
  return loaded;
}

RunResult run_alone(const LoadedRun& loaded, const fs::path& folder, const RunOptions& options) {
  return run_into(folder, loaded.project, loaded.model, loaded.warnings, options);
}

/// Runs on several ranks; returns the exit codes of the helpers.
RunResult run_on(int ranks, const LoadedRun& loaded, const fs::path& folder, RunOptions options) {
  std::optional<RunResult> result;
  std::atomic<int> let_go{0};
  with_ranks(
      ranks,
      [&](Ranks& mine) {
        options.ranks = &mine;
        result.emplace(run_alone(loaded, folder, options));
        dismiss_ranks(mine, 0);
      },
      [&](Ranks& mine) {
        RunOptions own;
        own.shard = options.shard;
        let_go += help_run(mine, loaded.project, loaded.model, loaded.warnings, own) == 0 ? 1 : 0;
      });
  EXPECT_EQ(let_go, ranks - 1);
  return std::move(*result);
}

TEST(RunOnRanks, GivesTheBytesOfOneProcess) {
  const Workplace work;
  const LoadedRun loaded = load_run(work);
  RunOptions options{.campaign = {.threads = 1}};
  run_alone(loaded, work / "whole", options);
  const auto whole = files_of(work / "whole");
  ASSERT_GT(whole.size(), 8U);
  for (const int ranks : {2, 3, 8}) {
    for (const double every : {0.0, 1e-6}) {  // seconds between checkpoints: none, and as often as possible
      options.checkpoint_every = every;
      const RunResult result = run_on(ranks, loaded, work / "ranks", options);
      EXPECT_EQ(result.outcome.ranks, ranks);
      EXPECT_EQ(result.outcome.threads, ranks);
      EXPECT_FALSE(result.outcome.interrupted);
      EXPECT_EQ(differences(whole, files_of(work / "ranks")), "") << ranks << " ranks, every " << every;
      fs::remove_all(work / "ranks");
    }
  }
}

TEST(RunOnRanks, ResumesWithAnyNumberOfRanks) {
  const Workplace work;
  const LoadedRun loaded = load_run(work);
  run_alone(loaded, work / "whole", {.campaign = {.threads = 2}});
  const auto whole = files_of(work / "whole");
  std::uint64_t done = 0;
  std::vector<int> sizes{3, 1, 2, 4};
  bool is_interrupted = true;
  for (std::size_t k = 0; is_interrupted; ++k) {
    ASSERT_LT(k, 100U);
    std::atomic<bool> stop{false};
    RunOptions options{.campaign = {.threads = 1, .stop = &stop}, .resume = true, .checkpoint_every = 1e-6};
    std::uint64_t begin = 0;
    options.campaign.progress = [&](std::uint64_t now) {
      if (begin == 0) begin = std::max<std::uint64_t>(now, 1);
      if (now > begin + 600) stop = true;
    };
    const int size = sizes[k % sizes.size()];
    const RunResult result =
        size == 1 ? run_alone(loaded, work / "stopped", options) : run_on(size, loaded, work / "stopped", options);
    is_interrupted = result.outcome.interrupted;
    EXPECT_EQ(result.done_before, done);
    EXPECT_GT(result.summary.done, done);
    done = result.summary.done;
    EXPECT_EQ(fs::exists(work / "stopped/run.state"), is_interrupted);
  }
  EXPECT_EQ(differences(whole, files_of(work / "stopped")), "");
}

TEST(RunOnRanks, MayBeAShard) {
  const Workplace work;
  const LoadedRun loaded = load_run(work);
  RunOptions options{.campaign = {.threads = 1}, .shard = Shard{2, 3}};
  run_alone(loaded, work / "whole", options);
  run_on(3, loaded, work / "ranks", options);
  auto expected = files_of(work / "whole"), found = files_of(work / "ranks");
  for (auto* files : {&expected, &found}) {
    ASSERT_EQ(files->erase("run.state"), 1U);  // it holds timings
  }
  EXPECT_EQ(differences(expected, found), "");
  // With more shards than rocks some have none.
  options.shard = Shard{1, 5000};
  EXPECT_EQ(run_on(3, loaded, work / "empty", options).summary.done, 0U);
}

/// What rank 0 reports; the others end with its exit code.
std::string message(int ranks, const LoadedRun& loaded, const fs::path& folder,
                    const std::function<int(Ranks&)>& other) {
  std::string said = "nothing";
  with_ranks(
      ranks,
      [&](Ranks& mine) {
        RunOptions options{.campaign = {.threads = 1}};
        options.ranks = &mine;
        int code = 0;
        try {
          run_alone(loaded, folder, options);
        } catch (const BadInput& bad) {
          said = bad.problems().text();
          code = 2;
        } catch (const std::runtime_error& error) {
          said = error.what();
          code = 4;
        }
        dismiss_ranks(mine, code);
      },
      [&](Ranks& mine) { EXPECT_NE(other(mine), 0); });
  return said;
}

TEST(RunOnRanks, RefusesRanksWithAnotherProject) {
  const Workplace work;
  const LoadedRun loaded = load_run(work), other = load_run(work, "7");
  work.write("kept", "");
  fs::create_directory(work / "out");
  work.write("out/run.state", "of an earlier run");
  const auto help = [&](Ranks& mine) {
    const LoadedRun& own = mine.rank() == 2 ? other : loaded;
    return help_run(mine, own.project, own.model, own.warnings, {});
  };
  EXPECT_EQ(message(4, loaded, work / "out", help),
            "rank 2 on machine 2: this rank would not compute the same results as the others (sampling.seed was 1 and "
            "is 7). Give "
            "all ranks the same command, the same files and the same program, on machines of one kind; or run each "
            "alone (--alone)");
  EXPECT_EQ(work.read("out/run.state"), "of an earlier run");
  EXPECT_FALSE(fs::exists(work / "out/endpoints.csv.part"));
}

TEST(RunOnRanks, RefusesAnotherVersion) {
  const Workplace work;
  const LoadedRun loaded = load_run(work);
  const auto help = [&](Ranks& mine) {
    mine.send(0, message_of(Hello{"0.0.7", mine.machine(), 1, {}}));
    return cannot_help(mine, "", 4);
  };
  EXPECT_THAT(message(2, loaded, work / "out", help),
              testing::HasSubstr("(talus 0.0.7 runs there, and " TALUS_VERSION " here)"));
}

TEST(RunOnRanks, ReportsAllErrorsOfOtherRanks) {
  const Workplace work;
  const LoadedRun loaded = load_run(work);
  const auto help = [&](Ranks& mine) {
    if (mine.rank() == 2) return help_run(mine, loaded.project, loaded.model, loaded.warnings, {});
    return cannot_help(mine, "a.toml:3: no file\na.toml:4: no number " + std::to_string(mine.rank()), 2);
  };
  EXPECT_EQ(message(4, loaded, work / "out", help),
            "rank 1 on machine 1: a.toml:3: no file\nrank 1 on machine 1: a.toml:4: no number 1\n"
            "rank 3 on machine 3: a.toml:3: no file\nrank 3 on machine 3: a.toml:4: no number 3");
}

TEST(RunOnRanks, EndsIfOneFailsDuringTheRun) {
  const Workplace work;
  const LoadedRun loaded = load_run(work);
  const auto help = [&](Ranks& mine) {
    if (mine.rank() != 1) return help_run(mine, loaded.project, loaded.model, loaded.warnings, {});
    mine.send(0, message_of(Hello{TALUS_VERSION, mine.machine(), 1,
                                  describe_run(loaded.project, loaded.model, loaded.warnings, {})}));
    return cannot_help(mine, "out of memory", 4);
  };
  EXPECT_EQ(message(3, loaded, work / "out", help), "rank 1 on machine 1: out of memory");
}

TEST(RunOnRanks, AnySignalledRankStopsAll) {
  const Workplace work;
  const LoadedRun loaded = load_run(work);
  std::atomic<bool> stop{false};
  with_ranks(
      3,
      [&](Ranks& mine) {
        RunOptions options{.campaign = {.threads = 1}};
        options.ranks = &mine;
        options.campaign.progress = [&](std::uint64_t done) { stop = stop || done > 100; };
        const RunResult result = run_alone(loaded, work / "out", options);
        dismiss_ranks(mine, 3);
        EXPECT_EQ(result.outcome.interrupted, result.summary.done < loaded.model.rocks());
        EXPECT_EQ(result.summary.done, result.outcome.done);
      },
      [&](Ranks& mine) {
        RunOptions own{.campaign = {.stop = mine.rank() == 2 ? &stop : nullptr}};
        EXPECT_EQ(help_run(mine, loaded.project, loaded.model, loaded.warnings, own), 3);
      });
}

// Blocks after the first abandoned rock are discarded, as in one process.
TEST(RunOnRanks, StopsDuringLongRocks) {
  const Workplace work;
  // None of the sample rocks at the beginning of a run is a long one.
  const std::string file = work.write("endless.toml", testing_tools::endless_slope(650, 3, 947));
  Reading reading = read_project(file, {{"output.paths=\"all\"", "output.report=false"}, {}, {}});
  LoadedRun loaded{std::move(reading.project), std::move(reading.warnings), {}};
  loaded.model = build_model(loaded.project, loaded.warnings);
  const auto files_when_stopped = [&](int ranks) {
    const std::string folder = std::to_string(ranks);
    std::atomic<bool> stop{false};
    std::chrono::steady_clock::time_point asked;
    const std::jthread stopper([&] {
      std::this_thread::sleep_for(std::chrono::seconds(3));
      asked = std::chrono::steady_clock::now();
      stop = true;
    });
    RunOptions options{.campaign = {.threads = 1, .stop = &stop}};
    const RunResult result =
        ranks == 1 ? run_alone(loaded, work / folder, options) : run_on(ranks, loaded, work / folder, options);
    EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::minutes(1));  // each of the rocks takes minutes
    EXPECT_TRUE(result.outcome.interrupted);
    EXPECT_EQ(result.outcome.done, 650U);
    auto files = files_of(work / folder);
    EXPECT_EQ(files.erase("run.state"), 1U);  // it holds timings
    return files;
  };
  const auto alone = files_when_stopped(1);
  EXPECT_EQ(differences(alone, files_when_stopped(3)), "");
}

TEST(RunOnRanks, AnyRankStopsAllBeforeTheFirstRock) {
  const Workplace work;
  const LoadedRun loaded = load_run(work);
  const std::atomic<bool> stop{true};
  with_ranks(
      3,
      [&](Ranks& mine) {
        RunOptions options{.campaign = {.threads = 1}};
        options.ranks = &mine;
        EXPECT_THROW(run_alone(loaded, work / "out", options), Stopped);
        dismiss_ranks(mine, 3);
      },
      [&](Ranks& mine) {
        RunOptions own{.campaign = {.stop = mine.rank() == 2 ? &stop : nullptr}};
        EXPECT_EQ(help_run(mine, loaded.project, loaded.model, loaded.warnings, own), 3);
      });
  EXPECT_FALSE(fs::exists(work / "out/endpoints.csv.part"));
}

TEST(RankMessages, AreReadAsTheyWereWritten) {
  const auto received = [](std::string bytes) { return Ranks::Message{3, std::move(bytes)}; };
  const auto block = received(message_of(DoneBlock{{7, 9}, {"rows\n", "", "more\n"}}));
  EXPECT_EQ(kind_of(block), MessageKind::block);
  const DoneBlock found = block_from(content_of(block));
  EXPECT_EQ(found.rocks, (RockRange{7, 9}));
  EXPECT_EQ(found.texts, (std::vector<std::string>{"rows\n", "", "more\n"}));
  EXPECT_EQ(rocks_from(content_of(received(message_of(RockRange{5, 6})))), (RockRange{5, 6}));
  EXPECT_EQ(next_rock_from(content_of(received(done_message(77)))), 77U);
  EXPECT_EQ(exit_code_from(content_of(received(leave_message(3)))), 3);
  const auto cannot = received(message_of(Cannot{"node", "no", 2}));
  EXPECT_EQ(cannot_from(content_of(cannot)).text, "no");
  EXPECT_THROW((void)kind_of(received("")), BadBytes);
  EXPECT_THROW((void)kind_of(received("\x7f")), BadBytes);
  EXPECT_THROW((void)block_from(content_of(block).substr(0, 20)), BadBytes);
}

}  // namespace
}  // namespace talus::project
