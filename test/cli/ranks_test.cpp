// `mpirun talus run` on the command line. The messages between ranks are tested in test/run/run_on_ranks_test.cpp.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "cli/child.hpp"
#include "cli/mpirun.hpp"
#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/endless_slope.hpp"
#include "talus/archive/run_state.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;

bool has_text(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class OnRanks : public testing::Test {
 protected:
  void SetUp() override {
#ifndef TALUS_HAS_MPI
    GTEST_SKIP() << "built without MPI";
#endif
    if (!has_mpirun()) GTEST_SKIP() << "there is no mpirun";
  }

  /// 3D terrain with a barrier and a collector, maps by source, all paths.
  [[nodiscard]] std::vector<std::string> run_3d(const std::string& folder, const std::string& rocks = "3000") const {
    return {"run",   write_slope_with_barrier(work), "--set",   "output.maps_by_source=true",
            "--set", "output.percentiles=[95]",      "--set",   "output.raster_cell_m=4",
            "--set", "output.paths=\"all\"",         "--rocks", rocks,
            "-o",    (work / folder).string()};
  }
  [[nodiscard]] std::vector<std::string> run_2d(const std::string& folder) const {
    return {"run", tutorial("2d"), "--rocks", "5000", "--set", "output.paths=\"all\"", "-o", (work / folder).string()};
  }
  [[nodiscard]] Said alone(const std::vector<std::string>& arguments) const {
    Said said{Child(arguments, work / "said").wait(), ""};
    said.text = work.read("said");
    return said;
  }
  [[nodiscard]] Said on(int ranks, const std::vector<std::string>& arguments) const {
    Said said{Child(arguments, work / "said", mpirun(ranks)).wait(), ""};
    said.text = work.read("said");
    return said;
  }
  /// Kills all processes of a run into this folder: if only mpirun is killed its ranks continue for a moment.
  void kill_all(const std::string& folder) const {
    const std::string word = (work / folder).string();
    for (const pid_t process : processes_with(word)) kill(process, SIGKILL);
    for (int k = 0; k < 1000 && !processes_with(word).empty(); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_TRUE(processes_with(word).empty());
  }
  /// Compares a run into the folder `ranks`, on several numbers of ranks, with one on a single thread.
  void expect_bytes_of_one_thread(std::vector<std::string> there) const {
    const std::string there_folder = (work / "ranks").string();
    there.insert(there.end(), {"--threads", "1"});
    auto here = there;
    std::ranges::replace(here, there_folder, (work / "whole").string());
    ASSERT_EQ(alone(here).exit_code, 0) << work.read("said");
    const auto whole = files_of(work / "whole");
    const struct {
      int ranks;
      const char* threads;
    } ways[] = {{1, "1"}, {2, "1"}, {2, "2"}, {4, "1"}};
    for (const auto& [ranks, threads] : ways) {
      there.back() = threads;
      const Said said = on(ranks, there);
      ASSERT_EQ(said.exit_code, 0) << said.text;
      EXPECT_EQ(differences(whole, files_of(there_folder)), "") << ranks << " ranks of " << threads << " threads";
      EXPECT_EQ(count(said.text, "Results are in"), 1) << said.text;
      fs::remove_all(there_folder);
    }
  }
  const Workplace work;
};

std::vector<std::string> with(std::vector<std::string> arguments, std::initializer_list<std::string> more) {
  arguments.insert(arguments.end(), more);
  return arguments;
}

TEST_F(OnRanks, In2dGivesTheBytesOfOneThread) { expect_bytes_of_one_thread(run_2d("ranks")); }

TEST_F(OnRanks, In3dGivesTheBytesOfOneThread) { expect_bytes_of_one_thread(run_3d("ranks")); }

TEST_F(OnRanks, ShardsAreMergedToTheBytesOfOneThread) {
  ASSERT_EQ(alone(with(run_3d("whole"), {"--threads", "1"})).exit_code, 0);
  for (const std::string number : {"2", "3", "1"}) {
    const Said said = on(2, with(run_3d("shard-" + number), {"--shard", number + "/3", "--threads", "1"}));
    ASSERT_EQ(said.exit_code, 0) << said.text;
    EXPECT_TRUE(has_text(said.text, "of 2 ranks)")) << said.text;
  }
  ASSERT_EQ(alone({"merge", (work / "shard-1").string(), (work / "shard-2").string(), (work / "shard-3").string(), "-o",
                   (work / "merged").string()})
                .exit_code,
            0)
      << work.read("said");
  EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "merged")), "");
}

TEST_F(OnRanks, AKilledRunIsResumedByOneProcessAndViceVersa) {
  const auto run = [&](const char* folder) {
    return with(run_3d(folder, "40000"),
                {"--set", "output.paths=500", "--set", "output.report=false", "--set", "output.geopackage=\"none\"",
                 "--checkpoint-every", "0.002", "--threads", "1"});
  };
  ASSERT_EQ(alone(run("whole")).exit_code, 0);
  const auto whole = files_of(work / "whole");
  for (const bool ranks_first : {true, false}) {
    {
      Child child(run("killed"), work / "said", ranks_first ? mpirun(3) : std::vector<std::string>());
      ASSERT_TRUE(appears(work / "killed/run.state")) << work.read("said");
      kill_all("killed");
      ASSERT_NE(child.wait(), 0) << work.read("said");
    }
    const auto again = with(run("killed"), {"--resume"});
    const Said said = ranks_first ? alone(again) : on(2, again);
    ASSERT_EQ(said.exit_code, 0) << said.text;
    EXPECT_EQ(count(said.text, "resuming after"), 1) << said.text;
    EXPECT_EQ(differences(whole, files_of(work / "killed")), "") << (ranks_first ? "ranks first" : "ranks last");
    EXPECT_TRUE(has_text(on(2, again).text, "is already complete in"));
    fs::remove_all(work / "killed");
  }
}

TEST_F(OnRanks, AreStoppedBySigusr1AndKeepTheirResults) {
  const auto run = [&](const char* folder) {
    return with(run_3d(folder, "100000"),
                {"--set", "output.paths=500", "--set", "output.report=false", "--set", "output.geopackage=\"none\"",
                 "--checkpoint-every", "0.01", "--threads", "1"});
  };
  Child child(run("stopped"), work / "said", mpirun(2));
  ASSERT_TRUE(appears(work / "stopped/run.state")) << work.read("said");
  ASSERT_TRUE(comes_true([&] { return read_header(work.read("stopped/run.state")).done > 0; }));
  child.signal(SIGUSR1);
  EXPECT_EQ(child.wait(), 3) << work.read("said");
  EXPECT_EQ(count(work.read("said"), ", and --resume continues from there"), 1) << work.read("said");
  const auto summary = nlohmann::json::parse(work.read("stopped/summary.json"));
  EXPECT_EQ(summary["interrupted"], true);
  const auto done = summary["rocks"]["done"].get<std::int64_t>();
  EXPECT_GT(done, 0);
  EXPECT_LT(done, 100000);
  const std::string endpoints = work.read("stopped/endpoints.csv");
  EXPECT_EQ(std::count(endpoints.begin(), endpoints.end(), '\n'), done + 1);
}

TEST_F(OnRanks, AreStoppedDuringLongRocks) {
  const std::string project = work.write("endless.toml", testing_tools::endless_slope(650, 3, 947));
  Child child({"run", project, "--threads", "1", "-q", "-o", (work / "out").string()}, work / "said", mpirun(2));
  ASSERT_TRUE(appears(work / "out/endpoints.csv.part")) << work.read("said");
  std::this_thread::sleep_for(std::chrono::seconds(3));
  child.signal(SIGUSR1);
  const auto asked = std::chrono::steady_clock::now();
  EXPECT_EQ(child.wait(), 3);
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::minutes(1));  // each of the rocks takes minutes
  EXPECT_EQ(count(work.read("said"), "stopped after 650 of 1600 rocks"), 1) << work.read("said");
}

TEST_F(OnRanks, ReportErrorsOfAProjectOnce) {
  const std::string project = work.write("bad.toml", "name = \"Bad\"\n[analysis]\ngravity_m_s2 = -1\nslinding = 3\n");
  const Said expected = alone({"run", project});
  ASSERT_EQ(expected.exit_code, 2);
  const Said said = on(3, {"run", project});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(count(said.text, expected.text), 1) << said.text;
  EXPECT_EQ(count(said.text, "slinding"), count(expected.text, "slinding")) << said.text;
}

TEST_F(OnRanks, ReportErrorsOfACommandLineOnce) {
  const Said mistyped = on(3, {"rnu", tutorial("2d")});
  EXPECT_EQ(mistyped.exit_code, 2);
  EXPECT_EQ(count(mistyped.text, "Did you mean \"run\"?"), 1) << mistyped.text;
  const Said version = on(3, {"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.text, "talus " TALUS_VERSION "\n");
  // With --alone each process may have other arguments. (Tested with --help: after an error in one process mpirun may
  // end the others.)
  EXPECT_EQ(count(on(3, {"run", "--alone", "--help"}).text, "Usage:"), 3);
}

TEST_F(OnRanks, ReportOnceThatTheFolderCannotBeWritten) {
  work.write("file", "");
  const Said said = on(3, {"run", tutorial("2d"), "-o", (work / "file").string()});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(count(said.text, (work / "file").string() + ": cannot create this folder"), 1) << said.text;
}

TEST_F(OnRanks, AreAllEndedByAFullDisk) {
  const std::vector<std::string> run = {"run",
                                        tutorial("2d"),
                                        "-q",
                                        "--rocks",
                                        "120000",
                                        "--set",
                                        "output.paths=100",
                                        "--set",
                                        "output.report=false",
                                        "--checkpoint-every",
                                        "0.002",
                                        "--threads",
                                        "1",
                                        "-o",
                                        (work / "full").string()};
  auto before = mpirun(2);
  before.insert(before.end(), {"sh", "-c", "ulimit -f 12000; exec \"$@\"", "sh"});
  Child child(run, work / "said", before);
  EXPECT_EQ(child.wait(), 2);
  const std::string said = work.read("said");
  EXPECT_EQ(count(said, "cannot write to this file (File too large). The first "), 1) << said;
  EXPECT_TRUE(has_text(said,
                       " of 120000 rocks are kept: with --resume the run continues from there. Allow larger files "
                       "(ulimit -f), or write elsewhere with -o\n"))
      << said;
  EXPECT_TRUE(fs::exists(work / "full/run.state"));
}

// As when srun starts shards: each process runs its own shard into its own folder.
TEST_F(OnRanks, MayEachRunAlone) {
  auto before = mpirun(2);
  before.insert(before.end(),
                {"sh", "-c", R"(exec "$@" --shard $((OMPI_COMM_WORLD_RANK + 1))/2 -o "$0/$OMPI_COMM_WORLD_RANK")",
                 (work / "shards").string()});
  EXPECT_EQ(Child({"run", tutorial("2d"), "-q", "--alone"}, work / "said", before).wait(), 0) << work.read("said");
  ASSERT_EQ(alone({"merge", "-q", (work / "shards").string(), "-o", (work / "merged").string()}).exit_code, 0)
      << work.read("said");
  ASSERT_EQ(alone({"run", tutorial("2d"), "-q", "-o", (work / "whole").string()}).exit_code, 0);
  EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "merged")), "");
}

// Under a launcher that this program's MPI does not support, each process would run all rocks, into the same folder.
TEST(Ranks, ThatDoNotFindEachOtherAreRefused) {
  if (!has_mpirun()) GTEST_SKIP() << "there is no mpirun, parts of which MPI needs";
  const Workplace work;
  const std::string run = "run " + tutorial("2d") + " -o " + (work / "out").string();
  std::string launched = "PMI_SIZE=3 OMPI_MCA_btl=self ";
  for (const std::string& word : environment_of_mpi()) launched += word + ' ';
  const std::string first = launched + "PMI_RANK=0 ", second = launched + "PMI_RANK=1 ";
#ifdef TALUS_HAS_MPI
  const std::string why =
      "(this program's MPI does not recognize the launcher that started them). Start them with the mpirun of that MPI, "
      "or with srun --mpi=pmix, or ";
#else
  const std::string why = "(this program was built without MPI). Build it with TALUS_MPI=ON, or ";
#endif
  const Said said = talus_says(run, first);
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_TRUE(has_text(said.text, "mpirun: cannot share the rocks between 3 processes " + why +
                                      "run each process on its own (--alone)\n"))
      << said.text;
  EXPECT_EQ(talus_says(run, second).text, "");
  EXPECT_FALSE(fs::exists(work / "out"));
  EXPECT_EQ(talus_says(run + " --alone", second).exit_code, 0);
  EXPECT_TRUE(fs::exists(work / "out/summary.json"));
}

}  // namespace
}  // namespace talus::test
