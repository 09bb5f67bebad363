// --resume of runs that were killed, stopped or failed: nothing is lost, and nothing differs.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/child.hpp"
#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/dice.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;
using testing_tools::Dice;
using Clock = std::chrono::steady_clock;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The arguments of a run of the tutorial in 3D, with a barrier, some maps and some paths.
std::vector<std::string> run_3d(const Workplace& work, const std::string& rocks, const std::string& folder) {
  return {"run",
          write_slope_with_barrier(work),
          "--set",
          "output.percentiles=[]",
          "--set",
          "output.paths=300",
          "--set",
          "output.raster_cell_m=4",
          "--set",
          "output.geopackage=\"none\"",
          "--set",
          "output.report=false",
          "--rocks",
          rocks,
          "--checkpoint-every",
          "0.002",
          "-o",
          (work / folder).string()};
}

std::vector<std::string> resuming(std::vector<std::string> arguments) {
  arguments.emplace_back("--resume");
  return arguments;
}

TEST(Resume, AfterKillsAtTwentyRandomMomentsGivesTheSameBytes) {
  Dice dice(static_cast<std::uint64_t>(Clock::now().time_since_epoch().count()));  // differs between runs of the test
  const Workplace work;
  const auto arguments = [&](const char* folder) { return run_3d(work, "25000", folder); };
  const auto begin = Clock::now();
  ASSERT_EQ(Child(arguments("whole"), work / "said").wait(), 0) << work.read("said");
  const double duration = std::chrono::duration<double>(Clock::now() - begin).count();
  const auto whole = files_of(work / "whole");

  int killed = 0, continued = 0;
  for (int round = 0; killed < 20; ++round) {
    if (round % 5 == 0) fs::remove_all(work / "killed");  // restart, so that the kill does not come too late
    Child child(resuming(arguments("killed")), work / "said");
    std::this_thread::sleep_for(std::chrono::duration<double>(duration * dice.between(0, 0.7)));
    child.signal(SIGKILL);
    const int code = child.wait();
    ASSERT_TRUE(code == 0 || code == 128 + SIGKILL) << work.read("said");
    killed += code != 0 ? 1 : 0;
    continued += contains(work.read("said"), "resuming after") ? 1 : 0;
    ASSERT_LT(round, 100) << "it is never killed in time";
    if (round % 5 == 4) {  // to the end
      ASSERT_EQ(Child(resuming(arguments("killed")), work / "said").wait(), 0) << work.read("said");
      EXPECT_EQ(differences(whole, files_of(work / "killed")), "");
    }
  }
  EXPECT_GT(continued, 0) << "no run continued from a checkpoint";
  ASSERT_EQ(Child(resuming(arguments("killed")), work / "said").wait(), 0) << work.read("said");
  EXPECT_EQ(differences(whole, files_of(work / "killed")), "");
}

TEST(Resume, OfAKilledShardGivesTheSameBytes) {
  const Workplace work;
  auto whole = run_3d(work, "40000", "whole"), killed = run_3d(work, "40000", "killed");
  for (auto* arguments : {&whole, &killed}) arguments->insert(arguments->end(), {"--shard", "2/3", "--threads", "2"});
  ASSERT_EQ(Child(whole, work / "said").wait(), 0) << work.read("said");
  Child child(killed, work / "said");
  ASSERT_TRUE(appears(work / "killed/run.state")) << work.read("said");
  child.signal(SIGKILL);
  child.wait();
  ASSERT_EQ(Child(resuming(killed), work / "said").wait(), 0) << work.read("said");
  auto expected = files_of(work / "whole"), found = files_of(work / "killed");
  for (auto* files : {&expected, &found}) files->erase("run.state");  // it holds timings
  EXPECT_EQ(differences(expected, found), "");
}

class StoppedRun : public testing::Test {
 protected:
  void SetUp() override {
    Child child(run("stopped"), work / "said");
    ASSERT_TRUE(appears(work / "stopped/run.state")) << work.read("said");
    child.signal(SIGINT);
    ASSERT_EQ(child.wait(), 3) << work.read("said");
  }
  [[nodiscard]] std::vector<std::string> run(const char* folder) const { return run_3d(work, "40000", folder); }
  /// The files of an uninterrupted run.
  [[nodiscard]] std::map<std::string, std::string> whole() const {
    EXPECT_EQ(Child(run("whole"), work / "said").wait(), 0) << work.read("said");
    return files_of(work / "whole");
  }
  Said resumed(const std::vector<std::string>& more = {}) const {
    auto arguments = resuming(run("stopped"));
    arguments.insert(arguments.end(), more.begin(), more.end());
    Said said;
    said.exit_code = Child(arguments, work / "said").wait();
    said.text = work.read("said");
    return said;
  }
  [[nodiscard]] std::string state_file() const { return (work / "stopped/run.state").string(); }
  const Workplace work;
};

TEST_F(StoppedRun, IsWholeAfterBeingResumed) {
  // All results so far have their final names.
  EXPECT_TRUE(contains(work.read("said"), ", and --resume continues from there"));
  for (const char* file : {"endpoints.csv", "barriers.csv", "paths.csv", "summary.json", "run.state"}) {
    EXPECT_TRUE(fs::exists(work / "stopped" / file)) << file;
  }
  EXPECT_FALSE(fs::exists(work / "stopped/endpoints.csv.part"));
  const auto summary = nlohmann::json::parse(work.read("stopped/summary.json"));
  EXPECT_EQ(summary["interrupted"], true);

  const Said said = resumed();
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_TRUE(
      contains(said.text, "resuming after " + std::to_string(summary["rocks"]["done"].get<int>()) + " of 40000 rocks"))
      << said.text;
  EXPECT_TRUE(contains(said.text, "  40000 rocks including the earlier ones\n")) << said.text;
  EXPECT_EQ(differences(whole(), files_of(work / "stopped")), "");

  const Said again = resumed();
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_TRUE(contains(again.text, "Tutorial 1, extruded is already complete in ")) << again.text;
}

TEST_F(StoppedRun, CanBeMergedPartially) {
  const auto expected = files_of(work / "stopped");
  EXPECT_EQ(talus_says("merge -q " + (work / "stopped").string() + " -o " + (work / "merged").string()).exit_code, 2);
  const Said said =
      talus_says("merge -q --partial " + (work / "stopped").string() + " -o " + (work / "merged").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_EQ(work.read("merged/endpoints.csv"), expected.at("endpoints.csv"));
  EXPECT_EQ(work.read("merged/maps/passages.tif"), expected.at("maps/passages.tif"));
}

TEST_F(StoppedRun, IsRefusedIfTheProjectHasChanged) {
  const Said said = resumed({"--seed", "7"});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_TRUE(contains(said.text, state_file() +
                                      ": the project is not the one that this run began with (sampling.seed was 1 and "
                                      "is 7). Undo the change to resume, or run without --resume to start over\n"))
      << said.text;
}

TEST_F(StoppedRun, IsRefusedIfOtherRocksAreAskedFor) {
  const Said said = resumed({"--shard", "1/2"});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_TRUE(contains(said.text, state_file() +
                                      ": this is the state of rocks 0 to 39999 (expected shard 1/2 with rocks 0 to "
                                      "19999). Undo the change to resume, or run without --resume to start over\n"))
      << said.text;
}

TEST_F(StoppedRun, IsRefusedIfItsTablesHaveChanged) {
  const std::string endpoints = work.read("stopped/endpoints.csv");
  work.write("stopped/endpoints.csv", endpoints.substr(0, endpoints.size() / 2));
  const Said said = resumed();
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_TRUE(contains(said.text, (work / "stopped/endpoints.csv").string() + ": this table is too short (it has "))
      << said.text;
  EXPECT_EQ(work.read("stopped/endpoints.csv"), endpoints.substr(0, endpoints.size() / 2)) << "it was changed";
}

TEST_F(StoppedRun, BeginsAnewWithoutBeingResumed) {
  ASSERT_EQ(Child(run("stopped"), work / "said").wait(), 0) << work.read("said");
  EXPECT_FALSE(contains(work.read("said"), "going on"));
  EXPECT_EQ(differences(whole(), files_of(work / "stopped")), "");
}

// The state is truncated, or single bits are flipped.
TEST_F(StoppedRun, IsRefusedIfItsStateIsDamaged) {
  Dice dice(17);
  const std::string state = work.read("stopped/run.state");
  const auto expect_refused = [&](const std::string& bytes, std::size_t place) {
    work.write("stopped/run.state", bytes);
    const Said said = resumed();
    EXPECT_EQ(said.exit_code, 2) << place << " of " << state.size() << ": " << said.text;
    EXPECT_TRUE(contains(said.text, state_file() + ": cannot use this state of a run (")) << said.text;
    EXPECT_TRUE(contains(said.text, "). Remove it, and run these rocks again without --resume\n")) << said.text;
  };
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{7}, std::size_t{20}, std::size_t{400}, state.size() / 2, state.size() - 1}) {
    expect_refused(state.substr(0, size), size);
  }
  for (int k = 0; k < 10; ++k) {
    std::string changed = state;
    const std::size_t place = k < 4 ? dice.below(60) : dice.below(state.size());
    changed[place] = static_cast<char>(changed[place] ^ (1 << dice.below(8)));
    expect_refused(changed, place);
  }
}

TEST(Resume, WithoutACheckpointBeginsAnew) {
  const Workplace work;
  const Said said = talus_says("run " + tutorial("2d") + " --resume -o " + (work / "out").string());
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_TRUE(contains(said.text, "there is no checkpoint in " + (work / "out").string() + ": the run starts over\n"));
  EXPECT_FALSE(fs::exists(work / "out/run.state"));
}

TEST(Resume, OfAFinishedShardHasNothingToDo) {
  const Workplace work;
  const std::string run = "run " + tutorial("2d") + " --shard 1/2 -o " + (work / "out").string();
  ASSERT_EQ(talus_says(run).exit_code, 0);
  const auto before = files_of(work / "out");
  const Said said = talus_says(run + " --resume");
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_TRUE(contains(said.text, "Tutorial 1, section is already complete in ")) << said.text;
  EXPECT_EQ(differences(before, files_of(work / "out")), "");
}

// With a limit of 6 MB per file the table of end points does not fit.
TEST(Resume, AfterAFullDiskGivesTheSameBytes) {
  const Workplace work;
  const std::string run = "run " + tutorial("2d") + " -q --rocks 120000 --set output.paths=100 " +
                          "--set output.report=false --checkpoint-every 0.002 -o ";
  ASSERT_EQ(talus_says(run + (work / "whole").string()).exit_code, 0);
  const Said said = talus_says(run + (work / "full").string(), "ulimit -f 12000; ");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_TRUE(contains(said.text, "cannot write to this file (File too large). The first ")) << said.text;
  EXPECT_TRUE(contains(said.text,
                       " of 120000 rocks are kept: with --resume the run continues from there. Allow larger files "
                       "(ulimit -f), or write elsewhere with -o\n"))
      << said.text;
  EXPECT_TRUE(fs::exists(work / "full/run.state"));
  const Said again = talus_says(run + (work / "full").string() + " --resume");
  EXPECT_EQ(again.exit_code, 0) << again.text;
  EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "full")), "");
}

// With a limit of 100 kB per file the report, which is written last, does not fit.
TEST(Resume, AfterAFailedReportWritesTheMissingFiles) {
  const Workplace work;
  const std::string run = "run " + tutorial("2d") + " --rocks 5 --set output.vtk=true -o ";
  ASSERT_EQ(talus_says(run + (work / "whole").string()).exit_code, 0);
  const Said said = talus_says(run + (work / "out").string() + " -q", "ulimit -f 200; ");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_TRUE(contains(said.text, (work / "out/report.html").string() + ": cannot write to this file")) << said.text;
  EXPECT_FALSE(fs::exists(work / "out/summary.json")) << "it would mark the run as complete";
  const Said again = talus_says(run + (work / "out").string() + " --resume");
  EXPECT_EQ(again.exit_code, 0) << again.text;
  EXPECT_TRUE(contains(again.text, ": the run starts over\n")) << again.text;
  EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "out")), "");
}

class FinishedRun : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(talus_says(run).exit_code, 0); }
  const Workplace work;
  const std::string run = "run " + tutorial("2d") + " --set output.vtk=true -o " + (work / "out").string();
};

TEST_F(FinishedRun, ThatLostAFileIsRunAgain) {
  const auto whole = files_of(work / "out");
  EXPECT_TRUE(contains(talus_says(run + " --resume").text, " is already complete in "));
  for (const char* name : {"paths.vtp", "report.html", "paths.csv"}) {
    fs::remove(work / "out" / name);
    const Said said = talus_says(run + " --resume");
    EXPECT_TRUE(
        contains(said.text, name + (" is incomplete in " + (work / "out").string()) + ": the run starts over\n"))
        << said.text;
    EXPECT_EQ(differences(whole, files_of(work / "out")), "");
  }
  fs::resize_file(work / "out/endpoints.csv", 1000);
  EXPECT_TRUE(contains(talus_says(run + " --resume").text, "endpoints.csv is incomplete in "));
  EXPECT_EQ(differences(whole, files_of(work / "out")), "");
}

// Deeply nested lists must not overflow the stack of recursive functions.
TEST_F(FinishedRun, WhoseSummaryWasDamagedIsRunAgain) {
  const auto whole = files_of(work / "out");
  for (const std::string& damaged :
       {std::string(100'000, '['), "{\"fingerprint\": \"\", \"project\": " + std::string(100'000, '[')}) {
    std::ofstream(work / "out/summary.json") << damaged;
    const Said said = talus_says(run + " --resume");
    EXPECT_EQ(said.exit_code, 0) << said.text;
    EXPECT_EQ(differences(whole, files_of(work / "out")), "");
  }
  fs::remove(work / "out/summary.json");
  ASSERT_EQ(::mkfifo((work / "out/summary.json").c_str(), 0600), 0);
  EXPECT_EQ(talus_says(run + " --resume").exit_code, 0);
  EXPECT_EQ(differences(whole, files_of(work / "out")), "");
}

TEST_F(FinishedRun, OfAnotherProjectIsNotOverwritten) {
  const auto before = files_of(work / "out");
  const std::string summary = (work / "out/summary.json").string();
  EXPECT_EQ(talus_says(run + " --resume --seed 7").text,
            summary +
                ": these are the results of another project (sampling.seed was 1 and is 7). Undo the change to resume, "
                "or run without --resume to start over\n");
  const Said said = talus_says(run + " --resume --shard 1/2");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, summary +
                           ": these are the results of rocks 0 to 49 (expected shard 1/2 with rocks 0 to 24). "
                           "Undo the change to resume, or run without --resume to start over\n");
  EXPECT_EQ(differences(before, files_of(work / "out")), "");
  EXPECT_EQ(talus_says(run + " --seed 7").exit_code, 0) << "without --resume";
}

TEST(Resume, IsNotOfferedIfTheFolderHasVanished) {
  const Workplace work;
  Child child({"run", tutorial("2d"), "-q", "--rocks", "100000000", "--set", "output.paths=none", "--checkpoint-every",
               "0.002", "-o", (work / "out").string()},
              work / "said");
  ASSERT_TRUE(appears(work / "out/run.state")) << work.read("said");
  fs::rename(work / "out", work / "elsewhere");
  EXPECT_EQ(child.wait(), 2);
  const std::string said = work.read("said");
  EXPECT_TRUE(contains(said, (work / "out").string())) << said;
  EXPECT_TRUE(contains(said, "No such file or directory")) << said;
  EXPECT_FALSE(contains(said, "--resume")) << said;
}

TEST(Resume, IgnoresAStaleStateOfAnEarlierRun) {
  const Workplace work;
  const std::string run = "run " + tutorial("2d") + " -q -o " + (work / "out").string();
  fs::create_directory(work / "out");
  work.write("out/run.state", "of something else");
  work.write("out/run.state.part", "of something el");
  work.write("out/endpoints.csv.part", "rock\n");
  EXPECT_EQ(talus_says(run).exit_code, 0);
  EXPECT_FALSE(fs::exists(work / "out/run.state"));
  EXPECT_FALSE(fs::exists(work / "out/run.state.part"));
  EXPECT_FALSE(fs::exists(work / "out/endpoints.csv.part"));
}

TEST(Memory, DoesNotGrowWithTheNumberOfRocks) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers keep additional memory";
#endif
  const Workplace work;
  const auto peak = [&](const char* rocks, const char* maps, const char* store) {
    Child child({"run", tutorial("2d"), "-q", "--rocks", rocks, "--set", "output.paths=none", "--set", maps, "--set",
                 store, "--checkpoint-every", "0.2", "--threads", "2", "-o", (work / "out").string()},
                work / "said");
    EXPECT_EQ(child.wait(), 0) << work.read("said");
    return static_cast<double>(child.peak_memory());
  };
  constexpr double waiting_visits = 33.6e6;  // buffered for the maps at most [bytes]
  const auto none = "output.trajectories_MB=none", full = "output.trajectories_MB=16";  // after a part of `few` rocks
  struct Case {
    const char *maps, *store;
    double more;
  };
  for (const auto& [maps, store, more] : {Case{"output.maps=false", none, 0.0},
                                          {"output.maps=false", full, 0.0},
                                          {"output.maps=true", none, waiting_visits}}) {
    const double few = peak("100000", maps, store), many = peak("1000000", maps, store);
    EXPECT_LT(many, 1.1 * few + 4e6 + more) << maps << ", " << store;
  }
}

}  // namespace
}  // namespace talus::test
