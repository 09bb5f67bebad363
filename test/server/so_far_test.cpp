// What a run has found so far: counts of all finished rocks, and trajectories that are those of its results.

#include "server/served_runs.hpp"

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;
using testing_tools::ServedRuns;

class SoFar : public ServedRuns {
 protected:
  /// The first answer about some rocks with trajectories.
  [[nodiscard]] Reply first_answer(const std::string& id) const {
    for (;;) {
      const Reply reply = get("/api/runs/" + id + "/so_far");
      if (reply.status == 200 && !ArraysOf(reply).get<std::uint32_t>("rocks", "u32").empty()) return reply;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
};

TEST_F(SoFar, CountsAllFinishedRocks) {
  const std::string id = begin(section(), {{"rocks", 3'000'000}});
  const Json early = ArraysOf(first_answer(id)).header["so_far"];
  const Reply later = get("/api/runs/" + id + "/so_far");
  ASSERT_EQ(later.status, 200);
  const Json now = ArraysOf(later).header["so_far"];
  EXPECT_GE(now["done"], early["done"]);
  EXPECT_EQ(now["planned"], 3'000'000);
  EXPECT_EQ(now["confidence"], 0.95);
  std::uint64_t rocks = 0;
  for (const Json& reason : now["end_reasons"]) {
    rocks += reason["rocks"].get<std::uint64_t>();
    const double share = reason["share"][0], low = reason["share"][1], high = reason["share"][2];
    EXPECT_DOUBLE_EQ(share, reason["rocks"].get<double>() / now["done"].get<double>());
    EXPECT_LT(low, share);
    EXPECT_GE(high, share);
  }
  EXPECT_EQ(rocks, now["done"]);
  ASSERT_EQ(now["rocks_hit"].size(), 1U);
  EXPECT_EQ(now["rocks_hit"][0]["name"], "Line at 15 m");
  EXPECT_LE(now["rocks_hit"][0]["rocks"], now["done"]);
  (void)ask(id, "stop");
  (void)wait_for(id, "stopped");
}

TEST_F(SoFar, HasTrajectoriesOfTheRun) {
  const std::string id = begin(section(), {{"rocks", 3'000'000}});
  const ArraysOf answer(first_answer(id));
  const auto rocks = answer.get<std::uint32_t>("rocks", "u32"), starts = answer.get<std::uint32_t>("starts", "u32");
  const auto times = answer.get<float>("times", "f32"), positions = answer.get<float>("positions", "f32");
  ASSERT_EQ(starts.size(), rocks.size() + 1);
  EXPECT_EQ(starts.front(), 0U);
  EXPECT_EQ(starts.back(), times.size());
  EXPECT_EQ(positions.size(), 3 * times.size());
  EXPECT_TRUE(std::is_sorted(rocks.begin(), rocks.end()));
  EXPECT_LE(rocks.size(), 1000U);
  EXPECT_EQ(answer.get<std::uint32_t>("barriers", "u32").size(), rocks.size());
  (void)ask(id, "stop");
  (void)wait(id, [](const Json& now) { return now["state"] == "stopped" && now["has_results"] == true; });
  for (std::size_t k = 0; k < std::min<std::size_t>(rocks.size(), 3); ++k) {
    const Json rock = get("/api/runs/" + id + "/rocks/" + std::to_string(rocks[k])).json();
    const Json end = rock["rows"].back();
    EXPECT_EQ(times[starts[k + 1] - 1], std::stof(end[3].get<std::string>()));
    const double x = answer.header["origin"][0].get<double>() + positions[3 * (starts[k + 1] - 1)];
    EXPECT_NEAR(x, std::stod(end[4].get<std::string>()), 1e-5);
  }
}

TEST_F(SoFar, BecomesAStoppedRunWithAsManyTrajectoriesAsAWholeOne) {
  const std::string id = begin(section(), {{"rocks", 3'000'000}});
  (void)wait(id, [](const Json& now) { return now["done"] >= 1000; });
  (void)ask(id, "stop");
  (void)wait(id, [](const Json& now) { return now["state"] == "stopped" && now["has_results"] == true; });
  const ArraysOf paths(get("/api/runs/" + id + "/paths"));
  const auto rocks = paths.get<std::uint32_t>("rocks", "u32"), starts = paths.get<std::uint32_t>("starts", "u32");
  ASSERT_EQ(rocks.size(), 20U) << "output.paths is 20";
  EXPECT_GE(paths.header["total"], 1000);
  EXPECT_TRUE(std::is_sorted(rocks.begin(), rocks.end()));
  const auto times = paths.get<float>("times", "f32"), positions = paths.get<float>("positions", "f32");
  for (const std::size_t k : {0U, 19U}) {
    const Json end = get("/api/runs/" + id + "/rocks/" + std::to_string(rocks[k])).json()["rows"].back();
    EXPECT_NEAR(times[starts[k + 1] - 1], std::stod(end[3].get<std::string>()), 1e-5);
    const double x = paths.header["origin"][0].get<double>() + positions[3 * (starts[k + 1] - 1)];
    EXPECT_NEAR(x, std::stod(end[4].get<std::string>()), 2e-3);  // the store's precision along the ground
  }
}

TEST_F(SoFar, IsOfRunsInProgressOnly) {
  const std::string first = begin(section(), {{"rocks", 3'000'000}}), second = begin(section());
  (void)first_answer(first);
  EXPECT_EQ(get("/api/runs/" + second + "/so_far").problem(),
            second + ": has no results so far (it is not being simulated)");
  (void)ask(first, "stop");
  (void)wait_for(second, "done");
  for (const std::string& id : {first, second}) EXPECT_EQ(get("/api/runs/" + id + "/so_far").status, 404);
  EXPECT_EQ(get("/api/runs/gone/so_far").status, 404);
}

TEST_F(SoFar, ChangesNoResult) {
  const std::string text = section();
  const std::string id = begin(text, {{"rocks", 20'000}});
  while (run(id)["state"] != "done") (void)get("/api/runs/" + id + "/so_far");
  EXPECT_EQ(test::differences(files_of(id), files_of_program(text, " --rocks 20000")), "");
}

}  // namespace
}  // namespace talus
