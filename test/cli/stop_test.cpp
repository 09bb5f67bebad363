// Ctrl-C stops a run at once, even during a rock that takes minutes to compute.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "cli/child.hpp"
#include "cli/program.hpp"
#include "support/endless_slope.hpp"

namespace talus::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class CtrlC : public testing::Test {
 protected:
  /// Runs `short_rocks` that stop at once and five long ones, interrupts the run and returns its output.
  std::string said_when_stopped(int short_rocks) {
    const std::string text = testing_tools::endless_slope(short_rocks, 5);
    Child child({"run", work.write("endless.toml", text), "--threads", "2", "-q", "-o", (work / "out").string()},
                work / "said");
    std::this_thread::sleep_for(3s);
    child.signal(SIGINT);
    const auto begin = Clock::now();
    const int code = child.wait();
    EXPECT_LT(Clock::now() - begin, 1min);  // long for any machine, but much shorter than a long rock
    EXPECT_EQ(code, 3);
    return work.read("said");
  }
  const Workplace work;
};

TEST_F(CtrlC, AbandonsALongRockAndKeepsAllBeforeIt) {
  // With this many rocks the initial sample of a run contains none of the last five.
  const std::string said = said_when_stopped(17'000);
  EXPECT_NE(said.find("stopped after 17000 of 17005 rocks"), std::string::npos) << said;
  EXPECT_TRUE(said.ends_with(", and --resume continues from there\n")) << said;
  EXPECT_TRUE(std::filesystem::exists(work / "out/run.state"));
}

TEST_F(CtrlC, StopsASensitivityStudy) {
  work.write("endless.toml", testing_tools::endless_slope(17'000, 5));
  const std::string study = work.write("study.toml", R"(
rocks = 17005
[[site]]
project = "endless.toml"
[[parameter]]
path = "material.Rock.friction_angle_deg"
range = [5.70, 5.71]
[[result]]
quantity = "runout"
)");
  Child child({"sensitivity", study, "--threads", "2", "-q", "-o", (work / "out").string()}, work / "said");
  std::this_thread::sleep_for(3s);
  child.signal(SIGINT);
  const auto begin = Clock::now();
  EXPECT_EQ(child.wait(), 3);
  EXPECT_LT(Clock::now() - begin, 1min);
  const std::string said = work.read("said");
  EXPECT_TRUE(said.ends_with("stopped; finished runs are kept, and the same command continues from there\n")) << said;
  EXPECT_FALSE(std::filesystem::exists(work / "out/summary.json"));
}

TEST_F(CtrlC, StopsBeforeTheFirstRockIsFinished) {
  const std::string said = said_when_stopped(1);
  EXPECT_TRUE(said.ends_with("stopped before the first rock was finished\n")) << said;
}

}  // namespace
}  // namespace talus::test
