// A stopped campaign drops the rocks in progress at once, however long they take, and keeps all before them.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <string>
#include <vector>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/results/summary.hpp"

namespace talus::campaign_stop_test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// On an endless slope that friction barely holds: 20 rocks that rest at once, then one that moves for very long.
std::string endless(const char* analysis, const char* material, const std::string& width) {
  const std::string place = width.empty() ? "[0, \"surface\"]" : "[0, 50, \"surface\"]";
  return std::string(R"(
name = "Endless"
[analysis]
max_timestep_s = 1e-4
max_time_s = 1e6
max_steps = 1000000000
)") + analysis +
         R"(
[output]
maps = false
[terrain]
section = [[-1000, 100], [1e6, -100000]]
)" + width +
         R"(
[[material]]
name = "Rock"
)" + material +
         R"(
[[seeder]]
name = "short"
rocks = 20
mass_kg = 100
position = )" +
         place + R"(
[[seeder]]
name = "long"
horizontal_velocity_m_s = 1
rocks = 5
mass_kg = 100
position = )" +
         place + '\n';
}

Model model_of(const std::string& text) {
  Problems warnings;
  return project::build_model(project::read_project_text(text, "endless.toml").project, warnings);
}

struct Kind {
  std::string name, text;
};

class LongRocks : public testing::TestWithParam<Kind> {};

// Each of these rocks takes minutes.
INSTANTIATE_TEST_SUITE_P(
    Stop, LongRocks,
    testing::Values(Kind{"Glides", endless("rotation = false\n",
                                           "normal_restitution = 0\ntangential_restitution = 1\n"
                                           "friction_angle_deg = 5.7105932\n",
                                           "")},
                    Kind{"GlidesIn3D", endless("rotation = false\n",
                                               "normal_restitution = 0\ntangential_restitution = 1\n"
                                               "friction_angle_deg = 5.7105932\n",
                                               "width_m = 100")},
                    Kind{"Rolls", endless("model = \"rigid_sphere\"\n",
                                          "normal_restitution = 0\ntangential_restitution = 1\ndynamic_friction = 0.5\n"
                                          "rolling_friction = 0.100000001\n",
                                          "")}),
    [](const auto& each) { return each.param.name; });

TEST_P(LongRocks, AreDroppedAtOnce) {
  const Model model = model_of(GetParam().text);
  SummaryObserver summary(model.rocks(), model.barriers.size(), model.frame);
  Observer* const observers[] = {&summary};
  std::atomic<bool> stop{false};
  std::atomic<std::uint64_t> done{0};
  auto running = std::async(std::launch::async, [&] {
    return run_campaign(model, observers, {2, &stop, [&](std::uint64_t now) { done = now; }});
  });
  ASSERT_EQ(running.wait_for(2s), std::future_status::timeout) << "the rock ended too early";
  stop = true;
  const auto begin = Clock::now();
  const CampaignOutcome outcome = running.get();
  EXPECT_LT(Clock::now() - begin, 1min);  // long for any machine, and far less than the rock takes
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_EQ(outcome.done, 20U);  // all before the first one that was dropped
  EXPECT_EQ(done, 20U);
  EXPECT_EQ(summary.summary().done, 20U);

  Simulator simulator(model);
  const StopScope scope(&stop);
  EXPECT_THROW((void)simulator.simulate(20, true), Stopped);  // as for a replay
}

TEST(Stop, DoesNotAffectTheNextUseOfASimulator) {
  const Model model = model_of(endless("rotation = false\n",
                                       "normal_restitution = 0.3\ntangential_restitution = 0.8\n"
                                       "friction_angle_deg = 30\n",
                                       ""));
  Simulator stopped(model), other(model);
  std::atomic<bool> stop{false};
  const StopScope scope(&stop);
  SimulationOrder order;
  order.rocks = {0, 25};
  order.keep_rows = [](std::uint64_t) { return false; };
  std::vector<double> seen;
  order.see = [&](const RockRecord& record, const RockLog&) {
    seen.push_back(record.outcome.end.position.x());
    stop = stop || seen.size() == 7;
  };
  order.stop = &scope;
  const std::uint64_t next = stopped.simulate(order);
  EXPECT_GE(next, 7U);  // rocks that end at once are seen together
  EXPECT_EQ(next, seen.size());
  stop = false;
  order.rocks.first = next;
  EXPECT_EQ(stopped.simulate(order), 25U);
  ASSERT_EQ(seen.size(), 25U);
  for (std::uint64_t rock = 0; rock < 25; ++rock)
    EXPECT_EQ(seen[rock], other.simulate(rock, false).outcome.end.position.x()) << rock;
}

}  // namespace
}  // namespace talus::campaign_stop_test
