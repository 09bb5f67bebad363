// `talus compare --models`: its figures are those of runs with each model, and what it writes and refuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/program.hpp"
#include "cli/run_files.hpp"

namespace talus::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class CompareCommand : public ::testing::Test {
 protected:
  [[nodiscard]] Said compare(const std::string& options) const {
    return talus_says("compare " + slope_ + " " + options);
  }

  Workplace work_;
  std::string slope_ = write_slope_with_barrier(work_);
};

TEST_F(CompareCommand, HasTheFiguresOfARunWithEachModel) {
  const Said said = compare("--models -q --line '15,0 15,50' -o " + (work_ / "all").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("with each model, the same in all; at the line\n"));
  EXPECT_THAT(said.text, HasSubstr("lumped mass (the project's)"));
  EXPECT_THAT(said.text, HasSubstr("rigid body, shape block"));
  const json all = json::parse(work_.read("all/compare.json"));
  ASSERT_EQ(all["variations"].size(), 2U);
  for (const json& each : all["variations"]) {
    const std::string model = each["model"];
    std::string set = " --set analysis.model=" + model;
    if (model == "rigid_body") set += " --set seeder.0.shape=block --set seeder.1.shape=block";
    ASSERT_EQ(talus_says("run " + slope_ + " -q" + set + " -o " + (work_ / model).string()).exit_code, 0);
    ASSERT_EQ(
        talus_says("line " + (work_ / model).string() + " --line '15,0 15,50' --json " + (work_ / "line.json").string())
            .exit_code,
        0);
    EXPECT_EQ(json::parse(work_.read("line.json"))["whole"]["rocks"], each["rocks"]) << model;
    const json summary = json::parse(work_.read(model + "/summary.json"));
    EXPECT_NEAR(each["runout_median_m"][0].get<double>(), summary["statistics"]["runout_xy_m"]["median"].get<double>(),
                0.01)
        << model;
  }
}

TEST_F(CompareCommand, TakesTheFirstCollectorOrBarrierAndWritesAPage) {
  const Said said = compare("--models -o " + (work_ / "out").string());
  ASSERT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("; at collector \"Line at 15 m\"\n"));
  EXPECT_THAT(said.text, HasSubstr("compare.html to see paths and figures of each model\n"));
  const std::string page = work_.read("out/compare.html");
  EXPECT_THAT(page, HasSubstr("\"side_view\":{\"is_section\":false"));
  EXPECT_TRUE(work_.read("out/compare.csv").starts_with("factor,step_percent,changes,"));
  EXPECT_THAT(work_.read("out/compare.csv"), HasSubstr("\nmodel,,lumped_mass to rigid_sphere,"));
}

TEST_F(CompareCommand, RefusesToCompareNothing) {
  const Said said = compare("");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.text, HasSubstr("nothing to compare is given (expected --models)"));
  EXPECT_EQ(compare("--models --line '1,1 2,2' --barrier Fence").exit_code, 2);
  EXPECT_EQ(compare("--models --barrier Fense").exit_code, 2);
}

}  // namespace
}  // namespace talus::test
