// `talus run --shard` and `talus merge` on the command line.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/dice.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;
using testing_tools::Dice;

/// Maps and maps by source, and some of the paths.
const std::string settings =
    " -q --rocks 3000 --set output.paths=200 --set output.maps_by_source=true --set "
    "output.percentiles=[95] ";

void expect_done(const Said& said) { EXPECT_EQ(said.exit_code, 0) << said.text; }

std::string shard_folder(int number, int of) { return std::to_string(number) + "-of-" + std::to_string(of); }

void run_shard(const Workplace& work, const std::string& project, int number, int of, const std::string& more = "") {
  expect_done(talus_says("run " + project + settings + more + " --shard " + std::to_string(number) + "/" +
                         std::to_string(of) + " -o " + (work / shard_folder(number, of)).string()));
}

std::string folders(const Workplace& work, std::vector<int> numbers, int of) {
  std::string text;
  for (const int number : numbers) text += (work / shard_folder(number, of)).string() + " ";
  return text;
}

TEST(Shards, MergedInAnyOrderGiveTheBytesOfOneRun) {
  Dice dice(3);
  const Workplace work;
  std::string text = work.read(write_slope_with_barrier(work));
  const std::string strong = "capacity_kJ = 60";  // no rock has as much
  text.replace(text.find(strong), strong.size(), "capacity_kJ = 10");
  const std::string project = work.write("slope.toml", text);
  const auto path = [&](const char* name) { return (work / name).string(); };
  expect_done(talus_says("run " + project + settings + "--threads 1 -o " + path("whole")));
  const auto whole = files_of(work / "whole");
  ASSERT_GT(whole.size(), 5U);
  ASSERT_TRUE(whole.contains("design.csv") && whole.contains("design_ranking.csv"));
  for (const char* outcome : {"stopped", "broke through", "passed"}) {
    ASSERT_NE(whole.at("barriers.csv").find(outcome), std::string::npos) << "the project does not cover this outcome";
  }
  for (const std::string threads : {"1", "2", "8"}) {
    for (const int shards : {1, 3, 7}) {
      std::vector<int> order;
      for (int k = 1; k <= shards; ++k) order.push_back(k);
      for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[dice.below(k)]);
      for (const int k : order) run_shard(work, project, k, shards, "--threads " + threads);
      expect_done(talus_says("merge -q " + folders(work, order, shards) + "-o " + path("merged")));
      EXPECT_EQ(differences(whole, files_of(work / "merged")), "") << shards << " shards, " << threads << " threads";
      fs::remove_all(work / "merged");
    }
  }
}

TEST(Shards, ContainTheirRocksAndTheStateForMerging) {
  const Workplace work;
  run_shard(work, tutorial("3d"), 2, 3);
  const auto files = files_of(work / "2-of-3");
  std::vector<std::string> names;
  for (const auto& [name, bytes] : files) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"barriers.csv", "endpoints.csv", "files.json", "paths.csv", "run.state",
                                             "summary.json"}));
  const auto summary = nlohmann::json::parse(files.at("summary.json"));
  EXPECT_EQ(summary["shard"], nlohmann::json::parse(R"({"number": 2, "of": 3, "first_rock": 1000, "rocks": 1000})"));
  EXPECT_EQ(summary["rocks"]["done"], 1000);
  EXPECT_EQ(summary["interrupted"], false);
  const std::string& endpoints = files.at("endpoints.csv");
  EXPECT_EQ(endpoints.substr(endpoints.find('\n') + 1, 5), "1000,");
  EXPECT_EQ(std::count(endpoints.begin(), endpoints.end(), '\n'), 1001);
}

TEST(Shards, AreWrittenNextToTheProjectByDefault) {
  const Workplace work;
  ASSERT_EQ(talus_says("new " + (work / "slope.toml").string()).exit_code, 0);
  const std::string run = "run " + (work / "slope.toml").string() + " -q --set name=Cliff --shard ";
  for (const std::string shard : {"1/2", "2/2"}) expect_done(talus_says(run + shard));
  EXPECT_TRUE(fs::exists(work / "Cliff-shard-1-of-2/run.state"));
  EXPECT_TRUE(fs::exists(work / "Cliff-shard-2-of-2/run.state"));
  // Merging several folders writes into a folder named after the project; merging one folder writes into that folder.
  const std::string here = "cd " + (work / "").string() + " && ";
  expect_done(talus_says("merge -q Cliff-shard-1-of-2 Cliff-shard-2-of-2", here));
  EXPECT_TRUE(fs::exists(work / "Cliff/summary.json"));
  fs::create_directory(work / "all");
  fs::rename(work / "Cliff-shard-1-of-2", work / "all/1");
  fs::rename(work / "Cliff-shard-2-of-2", work / "all/2");
  expect_done(talus_says("merge -q " + (work / "all").string()));
  EXPECT_EQ(work.read("all/endpoints.csv"), work.read("Cliff/endpoints.csv"));
}

TEST(Shards, MoreThanRocksIncludeEmptyOnes) {
  const Workplace work;
  for (int k = 1; k <= 4; ++k) {
    expect_done(talus_says("run " + tutorial("2d") + " -q --rocks 2 --shard " + std::to_string(k) + "/4 -o " +
                           (work / shard_folder(k, 4)).string()));
  }
  expect_done(talus_says("run " + tutorial("2d") + " -q --rocks 2 -o " + (work / "whole").string()));
  expect_done(talus_says("merge -q " + folders(work, {3, 1, 4, 2}, 4) + "-o " + (work / "merged").string()));
  EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "merged")), "");
}

TEST(Shards, NeedNoProjectToBeMerged) {
  const Workplace work;
  const std::string project = write_slope_with_barrier(work);
  expect_done(talus_says("run " + project + settings + "-o " + (work / "whole").string()));
  for (int k = 1; k <= 3; ++k) run_shard(work, project, k, 3);
  fs::remove(project);
  expect_done(talus_says("merge -q " + folders(work, {1, 2, 3}, 3) + "-o " + (work / "merged").string()));
  EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "merged")), "");
}

// Sums hold positions relative to the model's origin, which merging reads from the states.
TEST(Shards, InMapCoordinatesGiveTheBytesOfOneRun) {
  const Workplace work;
  const std::string project = work.write("map.toml", R"(
[terrain]
section = [[652100, 30], [652110, 20], [652200, -10], [652300, -12]]
[[material]]
name = "A"
normal_restitution = { mean = 0.35, distribution = "normal", std_dev = 0.04 }
tangential_restitution = 0.85
friction_angle_deg = 30
[[seeder]]
position = [652101, "surface"]
rocks = 100001
mass_kg = 1000
[output]
paths = "none"
report = false
)");
  const std::string run = "run -q " + project;
  expect_done(talus_says(run + " -o " + (work / "whole").string()));
  for (int k = 1; k <= 2; ++k) {
    expect_done(talus_says(run + " --shard " + std::to_string(k) + "/2 -o " + (work / shard_folder(k, 2)).string()));
  }
  expect_done(talus_says("merge -q " + folders(work, {2, 1}, 2) + "-o " + (work / "merged").string()));
  EXPECT_EQ(differences(files_of(work / "whole"), files_of(work / "merged")), "");
}

class MergeRefuses : public testing::Test {
 protected:
  void SetUp() override {
    for (int k = 1; k <= 3; ++k) run_shard(work, tutorial("3d"), k, 3);
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (work / name).string(); }
  void expect_refused(const std::string& arguments, const std::string& message) const {
    const Said said = talus_says("merge " + arguments + " -o " + at("merged"));
    EXPECT_EQ(said.exit_code, 2);
    EXPECT_EQ(said.text, message);
    EXPECT_FALSE(fs::exists(work / "merged"));
  }
  const Workplace work;
};

TEST_F(MergeRefuses, MissingRocks) {
  expect_refused(
      folders(work, {2}, 3),
      "merge: rocks 0 to 999 of 3000 are missing (no folder has them). Name all folders, run the shards that "
      "have not been run, or merge what there is with --partial\n"
      "merge: rocks 2000 to 2999 of 3000 are missing (no folder has them). Name all folders, run the shards "
      "that have not been run, or merge what there is with --partial\n");
  const Said said = talus_says("merge --partial " + folders(work, {3, 1}, 3) + "-o " + at("part"));
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_NE(said.text.find("2000 of 3000 rocks, from 2 runs"), std::string::npos) << said.text;
  EXPECT_NE(said.text.find("missing: rocks 1000 to 1999"), std::string::npos) << said.text;
  const auto summary = nlohmann::json::parse(work.read("part/summary.json"));
  EXPECT_EQ(summary["interrupted"], true);
  EXPECT_EQ(summary["missing_rocks"], nlohmann::json::parse("[[1000, 1000]]"));
  EXPECT_EQ(summary["rocks"]["done"], 2000);
  const std::string endpoints = work.read("part/endpoints.csv");
  EXPECT_EQ(std::count(endpoints.begin(), endpoints.end(), '\n'), 2001);
}

TEST_F(MergeRefuses, DuplicateRocks) {
  run_shard(work, tutorial("3d"), 3, 4);  // rocks 1500 to 2249
  expect_refused(folders(work, {1, 2, 3}, 3) + at("3-of-4"),
                 at("3-of-4/run.state") + ": rocks 1500 to 1999 are also in " + at("2-of-3") +
                     " (every rock counts once). Leave out one of the two folders\n" + at("3-of-3/run.state") +
                     ": rocks 2000 to 2249 are also in " + at("3-of-4") +
                     " (every rock counts once). Leave out one of the two folders\n");
}

TEST_F(MergeRefuses, RunsOfAnotherProject) {
  fs::remove_all(work / "2-of-3");
  run_shard(work, tutorial("3d"), 2, 3, "--seed 5 --set analysis.gravity_m_s2=9.7");
  expect_refused(folders(work, {1, 2, 3}, 3),
                 at("2-of-3/run.state") + ": this run does not belong to that in " + at("1-of-3") +
                     " (analysis.gravity_m_s2 was 9.80665 and is 9.7; sampling.seed was 1 and is 5). Merge runs of one "
                     "project, unchanged, with one build of talus\n");
}

TEST_F(MergeRefuses, ChangedStatesAndTables) {
  std::string state = work.read("1-of-3/run.state");
  work.write("1-of-3/run.state", state.substr(0, state.size() - 100));
  fs::remove(work / "2-of-3/run.state");
  const std::string why =
      "cannot use this state of a run (it was cut short, changed or damaged). Remove it, and run "
      "these rocks again without --resume\n";
  expect_refused(folders(work, {1, 2, 3}, 3),
                 at("2-of-3") +
                     ": there is no state of a run in this folder (expected run.state here or in a "
                     "subfolder). Name folders that `talus run --shard` has written\n");
  run_shard(work, tutorial("3d"), 2, 3);
  expect_refused(folders(work, {1, 2, 3}, 3), at("1-of-3/run.state") + ": " + why);
  work.write("1-of-3/run.state", state);

  std::string endpoints = work.read("1-of-3/endpoints.csv"), paths = work.read("3-of-3/paths.csv");
  endpoints[endpoints.size() - 5] ^= 1;
  work.write("1-of-3/endpoints.csv", endpoints);
  work.write("3-of-3/paths.csv", paths.substr(0, paths.size() - 10));
  fs::remove(work / "2-of-3/barriers.csv");
  expect_refused(
      folders(work, {1, 2, 3}, 3),
      at("1-of-3/endpoints.csv") +
          ": this table is not the one that the state was saved with (its rows up to the saved place differ). It was "
          "changed or removed; run these rocks again\n" +
          at("2-of-3/barriers.csv") +
          ": this table is missing (No such file or directory). It was changed or removed; run these rocks again\n" +
          at("3-of-3/paths.csv") + ": this table is too short (it has " + std::to_string(paths.size() - 10) +
          " bytes, expected at least " + std::to_string(paths.size()) +
          "). It was changed or removed; run these rocks again\n");
}

TEST_F(MergeRefuses, ToOverwriteItsInput) {
  const Said said = talus_says("merge " + folders(work, {1, 2, 3}, 3) + "-o " + at("2-of-3"));
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.text, at("2-of-3") +
                           ": cannot write the results here (it is the folder of one of the runs to merge). "
                           "Choose another folder with -o\n");
}

TEST(Shards, AreRefusedIfMalformed) {
  for (const std::string shard : {"0/3", "4/3", "3", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/0"}) {
    const Said said = talus_says("run " + tutorial("2d") + " --shard=" + shard);
    EXPECT_EQ(said.exit_code, 2);
    EXPECT_EQ(said.text,
              "--shard: \"" + shard + "\" is not a shard (expected i/n with i from 1 to n). For example --shard 2/7\n");
  }
}

}  // namespace
}  // namespace talus::test
