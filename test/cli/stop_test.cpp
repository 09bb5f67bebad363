// Ctrl-C is heard at once, also in the middle of a rock that takes minutes.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "cli/child.hpp"
#include "cli/program.hpp"

namespace talus::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// A rock that slides for days of its time, which takes minutes to compute.
constexpr const char* endless = R"(
name = "Endless"
[analysis]
rotation = false
max_timestep_s = 1e-4
max_time_s = 1e6
max_steps = 1000000000
[terrain]
section = [[-1000, 100], [1e6, -100000]]
[[material]]
name = "Rock"
normal_restitution = 0
tangential_restitution = 1
friction_angle_deg = 5.7105932
[[seeder]]
name = "short"
position = [0, "surface"]
rocks = SHORT
mass_kg = 100
[[seeder]]
name = "long"
position = [0, "surface"]
horizontal_velocity_m_s = 1
rocks = 5
mass_kg = 100
)";

class CtrlC : public testing::Test {
 protected:
  /// What a run of so many rocks that rest at once and five that do not says when it is stopped, which it hears soon.
  std::string said_when_stopped(const std::string& rocks_at_rest) {
    std::string text = endless;
    text.replace(text.find("SHORT"), 5, rocks_at_rest);
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
  const std::string said = said_when_stopped("17000");
  EXPECT_NE(said.find("stopped after 17000 of 17005 rocks"), std::string::npos) << said;
  EXPECT_TRUE(said.ends_with(", and --resume goes on from there\n")) << said;
  EXPECT_TRUE(std::filesystem::exists(work / "out/run.state"));
}

TEST_F(CtrlC, IsHeardBeforeTheFirstRock) {
  const std::string said = said_when_stopped("1");
  EXPECT_TRUE(said.ends_with("stopped before the first rock was done\n")) << said;
}

}  // namespace
}  // namespace talus::test
