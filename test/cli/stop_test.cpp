// Ctrl-C is heard at once, also in the middle of a rock that takes minutes.

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
  /// What a run of so many rocks that rest at once and five that do not says when it is stopped, which it hears soon.
  std::string said_when_stopped(int rocks_at_rest) {
    const std::string text = testing_tools::endless_slope(rocks_at_rest, 5);
    Child child({"run", work.write("endless.toml", text), "--threads", "2", "-q", "-o", (work / "out").string()},
                work / "said");
    std::this_thread::sleep_for(3s);
    child.signal(SIGINT);
    const auto begin = Clock::now();
    const int code = child.wait();
    EXPECT_LT(Clock::now() - begin, 1min);  // long for any machine, and far less than the rock takes
    EXPECT_EQ(code, 3);
    return work.read("said");
  }
  const Workplace work;
};

TEST_F(CtrlC, LeavesALongRockAndKeepsAllBefore) {
  // Of so many, none of the rocks of the sample that a run begins with is one of the last five.
  const std::string said = said_when_stopped(17'000);
  EXPECT_NE(said.find("stopped after 17000 of 17005 rocks"), std::string::npos) << said;
  EXPECT_TRUE(said.ends_with(", and --resume goes on from there\n")) << said;
  EXPECT_TRUE(std::filesystem::exists(work / "out/run.state"));
}

TEST_F(CtrlC, IsHeardBeforeTheFirstRock) {
  const std::string said = said_when_stopped(1);
  EXPECT_TRUE(said.ends_with("stopped before the first rock was done\n")) << said;
}

}  // namespace
}  // namespace talus::test
