// Several programs that write into the same folder.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/child.hpp"
#include "cli/program.hpp"
#include "cli/run_files.hpp"

namespace talus::test {
namespace {

namespace fs = std::filesystem;

class OneFolder : public testing::Test {
 protected:
  [[nodiscard]] std::string folder() const { return (work / "results").string(); }
  [[nodiscard]] std::vector<std::string> run(const char* rocks) const {
    return {"run", tutorial("3d"), "-q", "--rocks", rocks, "--checkpoint-every", "0.002", "-o", folder()};
  }
  [[nodiscard]] std::string few_rocks() const { return "run " + tutorial("3d") + " -q --rocks 50 -o " + folder(); }
  void expect_refused(const std::string& command) const {
    const Said said = talus_says(command);
    EXPECT_EQ(said.exit_code, 2) << command;
    EXPECT_EQ(said.text, folder() +
                             ": cannot write results here (another program is writing results into this folder). Wait "
                             "until it has ended, or write elsewhere with -o\n");
  }
  const Workplace work;
};

TEST_F(OneFolder, TakesOneRunAtATimeAndIsFreeAfterAKill) {
  ASSERT_EQ(
      talus_says("run " + tutorial("3d") + " -q --rocks 50 --shard 1/1 -o " + (work / "shard").string()).exit_code, 0);
  ASSERT_EQ(talus_says(few_rocks()).exit_code, 0);
  const auto before = files_of(folder());
  Child first(run("100000"), work / "said");
  ASSERT_TRUE(appears(work / "results/run.state")) << work.read("said");
  first.signal(SIGSTOP);
  expect_refused(few_rocks());
  expect_refused(few_rocks() + " --resume");
  expect_refused("merge -q " + (work / "shard").string() + " -o " + folder());
  expect_refused("report " + folder());
  EXPECT_EQ(talus_says("report " + folder() + " -o " + (work / "page.html").string()).exit_code, 0)
      << "the earlier results can still be read";
  EXPECT_EQ(work.read("results/endpoints.csv"), before.at("endpoints.csv"));

  first.signal(SIGKILL);
  first.wait();
  auto resumed = run("100000");
  resumed.emplace_back("--resume");
  EXPECT_EQ(Child(resumed, work / "said").wait(), 0) << work.read("said");
}

TEST_F(OneFolder, IsRefusedForTwoShardsOfARun) {
  auto shard = run("200000");
  shard.insert(shard.end(), {"--shard", "1/2"});
  Child first(shard, work / "said");
  ASSERT_TRUE(appears(work / "results/run.state")) << work.read("said");
  first.signal(SIGSTOP);
  expect_refused("run " + tutorial("3d") + " -q --rocks 200000 --shard 2/2 -o " + folder());
}

}  // namespace
}  // namespace talus::test
