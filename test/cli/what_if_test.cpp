// `talus what-if`: its figures are those of `talus line`, and what it writes and refuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "cli/child.hpp"
#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/endless_slope.hpp"

namespace talus::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class WhatIfCommand : public ::testing::Test {
 protected:
  [[nodiscard]] Said what_if(const std::string& options) const {
    return talus_says("what-if " + slope_ + " " + options);
  }
  [[nodiscard]] json written() const { return json::parse(work_.read("what/what_if.json")); }

  Workplace work_;
  std::string slope_ = write_slope_with_barrier(work_);
};

TEST_F(WhatIfCommand, HasTheFiguresOfLine) {
  ASSERT_EQ(talus_says("run " + slope_ + " -q --rocks 300 -o " + (work_ / "out").string()).exit_code, 0);
  for (const std::string question : {"--line '15,0 15,50'", "--barrier Fence"}) {
    ASSERT_EQ(
        talus_says("line " + (work_ / "out").string() + " " + question + " --json " + (work_ / "line.json").string())
            .exit_code,
        0);
    const Said said = what_if("--rocks 300 -q -o " + (work_ / "what").string() + " " + question);
    ASSERT_EQ(said.exit_code, 0) << said.text;
    const json line = json::parse(work_.read("line.json"))["whole"], base = written()["base"];
    EXPECT_GT(base["rocks"], 50);
    EXPECT_EQ(base["rocks"], line["rocks"]);
    EXPECT_EQ(base["share"][0], line["share"]["value"]);
    EXPECT_EQ(base["share"][1], line["share"]["low"]);
    const std::pair<const char*, const char*> keys[] = {
        {"energy_J", "ke_translational_J"}, {"height_m", "height_m"}, {"velocity_m_s", "velocity_m_s"}};
    for (const auto& [ours, theirs] : keys) {
      for (std::size_t k = 0; k < 3; ++k) {  // the store has five digits along the ground
        const json &one = base[ours][k], &other = line["percentiles"][theirs]["95"][k];
        ASSERT_EQ(one.is_null(), other.is_null());
        if (one.is_null()) continue;
        EXPECT_NEAR(one.get<double>(), other.get<double>(), 1e-4 * std::max(1.0, other.get<double>()));
      }
    }
  }
}

TEST_F(WhatIfCommand, WritesATableOfTheSteps) {
  const Said said = what_if("--polygon '12,5 25,5 25,45 12,45' --step normal_restitution=20% --step mass=50 -o " +
                            (work_ / "what").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("5 sets of values, the same rocks in each\n"));
  EXPECT_THAT(said.text, HasSubstr("75 of 75 rocks in each set"));
  EXPECT_THAT(said.text, HasSubstr("\nNormal restitution               -20 %  "));
  EXPECT_THAT(said.text, HasSubstr("\nRock mass                        +50 %  "));
  const std::string table = work_.read("what/what_if.csv");
  EXPECT_TRUE(table.starts_with("factor,step_percent,changes,clipped,rocks,crossing,gained,lost,share,")) << table;
  EXPECT_THAT(table, HasSubstr("\nbase,,,,75,"));
  EXPECT_THAT(table, HasSubstr("\nmass,50,"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 6);
  // A heavier rock of a lumped mass goes the same way with as much more energy.
  const json all = written();
  for (const json& each : all["variations"]) {
    if (each["factor"] != "mass") continue;
    EXPECT_EQ(each["difference"]["gained"], 0);
    EXPECT_EQ(each["difference"]["lost"], 0);
    EXPECT_NEAR(each["energy_J"][0].get<double>() / all["base"]["energy_J"][0].get<double>(),
                1 + each["step_percent"].get<double>() / 100, 1e-9);
  }
}

TEST_F(WhatIfCommand, RefusesWithTheReason) {
  const auto refusal = [&](const std::string& options) {
    const Said said = what_if(options);
    EXPECT_EQ(said.exit_code, 2) << said.text;
    return said.text;
  };
  EXPECT_EQ(refusal("--line '15,0 15,50' --step mass"),
            "--step: \"mass\" is not a step (expected a factor and a percentage). For example --step "
            "normal_restitution=10%\n");
  EXPECT_EQ(refusal("--line '15,0 15,50' --step mass=100%"),
            "--step: the step of mass is 100 % (expected a share of the value, above 0 and below 100 %)\n");
  EXPECT_THAT(refusal("--line '15,0 15,50' --material Wood"), HasSubstr("there is no material \"Wood\""));
  EXPECT_THAT(refusal("--line '15,0'"), HasSubstr("--line: has 1 point"));
  EXPECT_THAT(refusal("--barrier Net"), HasSubstr("no barrier or collector \"Net\""));
}

TEST_F(WhatIfCommand, KeepsWhatIsDoneAtCtrlC) {
  const std::string endless = work_.write("endless.toml", testing_tools::endless_slope(17'000, 5));
  Child child({"what-if", endless, "--line", "5", "--step", "mass=25%", "--threads", "2", "-q", "-o", (work_ / "what").string()},
              work_ / "said");
  std::this_thread::sleep_for(std::chrono::seconds(3));
  child.signal(SIGINT);
  EXPECT_EQ(child.wait(), 3);
  EXPECT_THAT(work_.read("said"), HasSubstr("stopped; the figures are of the rocks so far, a fair sample\n"));
  EXPECT_GT(written()["rocks"], 0);
  EXPECT_LT(written()["rocks"], 17'005);
}

}  // namespace
}  // namespace talus::test
