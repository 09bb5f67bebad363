// What if over the API: a job beside a run.

#include "server/served_results.hpp"

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Reply;

class WhatIfJob : public testing_tools::ServedResults {
 protected:
  [[nodiscard]] std::string path() const { return "/api/runs/" + id_ + "/what_if"; }
  Json wait_while_running() const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(5);
    for (;;) {
      const Json state = get(path()).json();
      if (state["state"] != "running" || std::chrono::steady_clock::now() > end) return state;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  [[nodiscard]] std::string refusal(const Json& question, int status) const {
    const Reply reply = post(path(), question);
    EXPECT_EQ(reply.status, status) << reply.body;
    return reply.json()["problems"][0]["text"];
  }
};

TEST_F(WhatIfJob, AnswersInTheBackground) {
  EXPECT_EQ(get(path()).json(), Json());
  EXPECT_EQ(post(path() + "/stop", Json::object()).status, 404);
  const Json line{{"line", {{15, 0}, {15, 50}}}};
  const Reply begun = post(path(), line);
  ASSERT_EQ(begun.status, 202) << begun.body;
  EXPECT_EQ(begun.json()["run"], id_);
  EXPECT_EQ(begun.json()["question"], line);
  const Json state = wait_while_running();
  EXPECT_EQ(state["state"], "done");
  EXPECT_EQ(state["done"], 75);
  EXPECT_EQ(state["problems"], Json::array());
  EXPECT_TRUE(state["overrides"]["rocks"].is_null());
  // The card of the line has the same figures.
  const Json card = post("/api/runs/" + id_ + "/line", line).json()["whole"], base = state["answer"]["base"];
  EXPECT_EQ(base["rocks"], card["rocks"]);
  EXPECT_EQ(base["share"][2], card["share"]["high"]);
  EXPECT_NEAR(base["height_m"][0].get<double>(), card["percentiles"]["height_m"]["95"][0].get<double>(), 1e-4);
  const Json& first = state["answer"]["variations"][0];
  EXPECT_EQ(first["factor"], "normal_restitution");
  EXPECT_EQ(first["step_percent"], -10);
  EXPECT_EQ(first["changes"][0]["path"], (Json{"material", 0, "normal_restitution"}));
}

/// Models come first, with both energies and where rocks end; without steps the usual ones follow.
TEST_F(WhatIfJob, RunsTheOtherRockModels) {
  ASSERT_EQ(post(path(), {{"barrier", "Fence"}, {"models", true}, {"steps", Json::object()}}).status, 202);
  const Json answer = wait_while_running()["answer"];
  EXPECT_EQ(answer["model"], "lumped_mass");
  ASSERT_EQ(answer["variations"].size(), 2U);
  const Json& sphere = answer["variations"][0];
  EXPECT_EQ(sphere["factor"], "model");
  EXPECT_EQ(sphere["model"], "rigid_sphere");
  EXPECT_EQ(sphere["step_percent"], nullptr);
  EXPECT_EQ(sphere["text"], "lumped_mass to rigid_sphere");
  EXPECT_EQ(sphere["energy_J"], sphere["ke_translational_J"]);
  EXPECT_GE(sphere["ke_total_J"][0], sphere["ke_translational_J"][0]);
  EXPECT_GT(sphere["runout_m"][0], 0);
  EXPECT_EQ(answer["variations"][1]["changes"][1]["after"], "block");
  EXPECT_EQ(answer["side_view"]["sets"].size(), 3U);
  ASSERT_EQ(post(path(), {{"barrier", "Fence"}, {"models", true}}).status, 202);
  const Json all = wait_while_running()["answer"]["variations"];
  EXPECT_EQ(all[0]["factor"], "model");
  EXPECT_EQ(all[2]["factor"], "normal_restitution");
  EXPECT_EQ(refusal({{"barrier", "Fence"}, {"models", "all"}}, 400), "models: is not true or false");
}

TEST_F(WhatIfJob, IsStopped) {
  ASSERT_EQ(post(path(), {{"barrier", "Fence"}, {"seconds", 600}}).status, 202);
  EXPECT_EQ(post(path() + "/stop", Json::object()).status, 200);
  const Json state = wait_while_running();
  EXPECT_TRUE(state["state"] == "stopped" || state["state"] == "done") << state.dump();
  EXPECT_EQ(state["answer"]["rocks"], state["done"]);
}

TEST_F(WhatIfJob, ChangesWhatIsAsked) {
  const Json question{{"polygon", {{12, 5}, {25, 5}, {25, 45}, {12, 45}}}, {"steps", {{"mass", 50}}}, {"rocks", 64}};
  ASSERT_EQ(post(path(), question).status, 202);
  const Json answer = wait_while_running()["answer"];
  EXPECT_EQ(answer["rocks"], 64);
  EXPECT_EQ(answer["planned"], 75);
  ASSERT_EQ(answer["variations"].size(), 2U);
  EXPECT_EQ(answer["variations"][1]["step_percent"], 50);
}

TEST_F(WhatIfJob, NamesWhatCanBeVaried) {
  const Json all = get(path() + "/choices").json();
  EXPECT_EQ(all["factors"][0],
            (Json{{"factor", "normal_restitution"}, {"title", "Normal restitution"}, {"usual_percent", 10}}));
  const std::string first = all["materials"][0];
  EXPECT_EQ(get(path() + "/choices?material=" + first).json()["factors"].back()["factor"], "mass");
  const Reply reply = get(path() + "/choices?material=Snow");
  EXPECT_EQ(reply.status, 422);
  EXPECT_EQ(std::string(reply.json()["problems"][0]["text"]).find("material: there is no material \"Snow\""), 0U);
}

TEST_F(WhatIfJob, RefusesBadQuestions) {
  EXPECT_EQ(refusal(Json::object(), 400), "line: is missing (expected one of line, barrier, polygon)");
  EXPECT_EQ(refusal({{"line", {{15, 0}, {15, 50}}}, {"barrier", "Fence"}}, 400),
            "barrier: cannot be given with others (expected one of line, barrier, polygon)");
  EXPECT_EQ(refusal({{"barrier", "Fence"}, {"seconds", 1e9}}, 400),
            "seconds: is not valid (expected a number above 0, up to 600)");
  EXPECT_EQ(refusal({{"barrier", "Fence"}, {"steps", {{"mass", "much"}}}}, 400), "steps: mass is not a number");
  EXPECT_EQ(
      refusal({{"barrier", "Fence"}, {"steps", {{"weight", 5}}}}, 422).find("steps: there is no factor \"weight\""),
      0U);
  EXPECT_EQ(refusal({{"line", {{1e6, 0}, {1e6, 50}}}}, 422).find("line: does not touch the terrain"), 0U);
  EXPECT_EQ(get(path()).json(), Json());
}

}  // namespace
}  // namespace talus
