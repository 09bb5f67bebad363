// Lines and polygons over the API agree with the design of the run.

#include "server/served_results.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;

class AskedLines : public testing_tools::ServedResults {
 protected:
  [[nodiscard]] Reply asked(const Json& question) const { return post("/api/runs/" + id_ + "/line", question); }
  [[nodiscard]] Json answer(const Json& question) const {
    const Reply reply = asked(question);
    EXPECT_EQ(reply.status, 200) << reply.body;
    return reply.status == 200 ? reply.json() : Json();
  }
  [[nodiscard]] std::string refusal(const Json& question, int status) const {
    const Reply reply = asked(question);
    EXPECT_EQ(reply.status, status) << reply.body;
    return reply.json()["problems"][0]["text"];
  }
  /// The line of the design with this name.
  [[nodiscard]] Json designed(const std::string& name) const {
    const Json summary = of("/summary").json();
    for (const Json& line : summary["design"]["lines"]) {
      if (line["name"] == name) return line;
    }
    return {};
  }
};

/// The store keeps motion along the ground with five digits.
void expect_same_figures(const Json& asked, const Json& design) {
  EXPECT_EQ(asked["rocks"], design["rocks"]);
  EXPECT_EQ(asked["share"], design["share"]);
  EXPECT_EQ(asked["from_m"], design["from_m"]);
  EXPECT_EQ(asked["to_m"], design["to_m"]);
  ASSERT_EQ(asked["percentiles"].size(), design["percentiles"].size());
  for (const auto& [quantity, percentiles] : design["percentiles"].items()) {
    for (const auto& [percentile, values] : percentiles.items()) {
      const Json& ours = asked["percentiles"][quantity][percentile];
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_EQ(ours[k].is_null(), values[k].is_null()) << quantity << percentile;
        if (values[k].is_null()) continue;
        const double value = values[k];
        EXPECT_NEAR(ours[k].get<double>(), value, 1e-4 * std::max(1.0, std::abs(value))) << quantity << percentile;
      }
    }
  }
}

TEST_F(AskedLines, HaveTheFiguresOfTheDesign) {
  for (const char* name : {"Line at 15 m", "Fence"}) {
    const Json design = designed(name), asked = answer({{"barrier", name}});
    EXPECT_EQ(asked["run"]["rocks"], 75);
    EXPECT_EQ(asked["run"]["stored"], 75);
    EXPECT_EQ(asked["length_m"], design["length_m"]);
    expect_same_figures(asked["whole"], design);
    ASSERT_EQ(asked["sections"].size(), design["sections"].size());
    for (std::size_t k = 0; k < design["sections"].size(); ++k)
      expect_same_figures(asked["sections"][k], design["sections"][k]);
  }
  const Json drawn = answer({{"line", {{15, 0}, {15, 50}}}, {"height_m", 3.5}, {"energy_kJ", 100}});
  expect_same_figures(drawn["whole"], designed("Line at 15 m"));
  EXPECT_EQ(drawn["kind"], "line");
  EXPECT_EQ(drawn["problems"], Json::array());
}

TEST_F(AskedLines, JudgeAKitAsTheirTableDoes) {
  const Json asked = answer({{"line", {{15, 0}, {15, 50}}}, {"height_m", 2}, {"energy_kJ", 100}});
  const Json &kit = asked["kit"], &kits = asked["kits"];
  const auto place = [&](const char* key, double value) {
    const auto values = kits[key].get<std::vector<double>>();
    return static_cast<std::size_t>(std::ranges::find(values, value) - values.begin());
  };
  const std::size_t h = place("heights_m", 2), e = place("energies_kJ", 100);
  EXPECT_EQ(kits["stopped"].at(h).at(e), kit["stopped"]);
  EXPECT_EQ(kits["low"].at(h).at(e), kit["share"]["low"]);
  EXPECT_EQ(kit["of"], asked["whole"]["rocks"]);
  EXPECT_EQ(kit["stopped"].get<int>() + kit["above"].get<int>() + kit["through"].get<int>(), kit["of"].get<int>());
  int clearing = 0, crossing = 0;
  for (const Json& rocks : asked["sources"]["clearing"]) clearing += rocks.get<int>();
  for (const Json& rocks : asked["sources"]["crossing"]) crossing += rocks.get<int>();
  EXPECT_EQ(clearing, kit["of"].get<int>() - kit["stopped"].get<int>());
  EXPECT_EQ(crossing, kit["of"].get<int>());
  EXPECT_EQ(asked["crossing_rocks"].size(), kit["of"].get<std::size_t>());
}

TEST_F(AskedLines, TakeOtherSettingsOfTheDesign) {
  const Json usual = answer({{"barrier", "Fence"}});
  const Json plain = answer({{"barrier", "Fence"}, {"design", {{"standard", "none"}, {"design_percentile", 50}}}});
  EXPECT_EQ(usual["standard"], "UNI 11211-4");
  EXPECT_TRUE(plain["standard"].is_null());
  EXPECT_EQ(plain["design_percentile"], 50);
  EXPECT_EQ(plain["whole"]["needs"]["height_m"], plain["whole"]["percentiles"]["height_m"]["50"][0]);
  EXPECT_EQ(refusal({{"barrier", "Fence"}, {"design", {{"confidence", 95}}}}, 422).find("--set design.confidence=95"),
            0U);
}

TEST_F(AskedLines, FilterRocksByWhatCrossesAndWhereItComesFrom) {
  const Json asked = answer({{"line", {{15, 0}, {15, 50}}}});
  const std::string selection = asked["selection"];
  const auto crossing = asked["crossing_rocks"].get<std::vector<std::uint32_t>>();
  const Json statistics = of("/statistics?of=runout_xy_m&crossing=" + selection).json();
  EXPECT_EQ(statistics["count"], crossing.size());
  const ArraysOf ends(of("/endpoints?crossing=" + selection));
  EXPECT_EQ(ends.get<std::uint32_t>("rocks", "u32"), crossing);
  EXPECT_EQ(ends.header["total"], crossing.size());

  const ArraysOf releases(of("/releases"));
  const auto rocks = releases.get<std::uint32_t>("rocks", "u32");
  ASSERT_EQ(rocks.size(), 2U);  // a line and a point
  EXPECT_EQ(rocks[1], 25U);
  EXPECT_EQ(of("/statistics?of=runout_xy_m&release=1").json()["count"], 25);
  const ArraysOf paths(of("/paths?release=1&crossing=" + selection));
  for (const std::uint32_t release : paths.get<std::uint32_t>("releases", "u32")) EXPECT_EQ(release, 1U);
  EXPECT_EQ(paths.get<std::uint32_t>("rocks", "u32").size(),
            static_cast<std::size_t>(std::ranges::count_if(crossing, [](std::uint32_t rock) { return rock >= 50; })));

  EXPECT_EQ(of("/statistics?of=runout_xy_m&crossing=s999").status, 404);
  EXPECT_EQ(of("/statistics?of=runout_xy_m&release=2").status, 400);
}

TEST_F(AskedLines, AnswerManyAtOnceAsOneByOne) {
  const Json lines = {{{15, 0}, {15, 50}}, {{20, 0}, {20, 50}}, {{500, 0}, {500, 50}}};
  const Json many = answer({{"lines", lines}});
  ASSERT_EQ(many["lines"].size(), 3U);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(many["lines"][k]["whole"], answer({{"line", lines[k]}})["whole"]);
  EXPECT_TRUE(many["lines"][2]["foot"].is_null());
  EXPECT_EQ(many["lines"][2]["problems"][0]["what"], "does not touch the terrain");
}

// By kind and place, as in the summary of a run, so that programs find what is said twice.
TEST_F(AskedLines, DoubtsHaveKinds) {
  const Json asked = answer({{"barrier", "Fence"}, {"height_m", 0.01}, {"energy_kJ", 100}});
  ASSERT_FALSE(asked["problems"].empty());
  const auto kit = std::ranges::find(asked["problems"], "kit_below_block", [](const Json& of) { return of["kind"]; });
  ASSERT_NE(kit, asked["problems"].end());
  EXPECT_EQ((*kit)["where"], "line \"Fence\"");
  EXPECT_EQ(answer({{"polygon", {{-1, -1}, {30, -1}, {30, 51}, {-1, 51}}}})["problems"][0]["kind"], "");
}

TEST_F(AskedLines, OfAPolygonCountWhatEntersAndStops) {
  const Json asked = answer({{"polygon", {{-1, -1}, {30, -1}, {30, 51}, {-1, 51}}}});
  EXPECT_EQ(asked["kind"], "polygon");
  EXPECT_EQ(asked["entering"]["rocks"], 75);
  EXPECT_EQ(asked["problems"].size(), 1U);  // its corners are off the terrain
  std::size_t stopping = 0;
  for (const auto& row : endpoints()) stopping += row[10] != "left model" ? 1 : 0;
  EXPECT_EQ(asked["stopping"]["rocks"], stopping);
}

TEST_F(AskedLines, AreRefusedWithTheReason) {
  EXPECT_EQ(refusal({{"section_m", 3}}, 400), "line: is missing (expected line, lines, barrier or polygon)");
  EXPECT_EQ(refusal({{"line", Json::array()}, {"barrier", "Fence"}}, 400),
            "barrier: cannot be given with line (one thing is asked at a time)");
  EXPECT_EQ(refusal({{"line", {{15, 0}}}}, 422), "line: has 1 point (expected at least 2, from one end to the other)");
  EXPECT_EQ(refusal({{"line", {{15, 0}, {15, "x"}}}}, 400), "line[1]: is not valid (expected 2 numbers)");
  EXPECT_EQ(refusal({{"barrier", "Net"}}, 422),
            "barrier: the run has no barrier or collector \"Net\" (it has \"Fence\", \"Line at 15 m\")");
  EXPECT_EQ(refusal({{"barrier", "Fence"}, {"height_m", 3}}, 400),
            "energy_kJ: is missing (a kit has a height and an energy)");
  EXPECT_EQ(refusal({{"barrier", "Fence"}, {"section_m", 0}}, 400),
            "section_m: is not valid (expected a number above 0)");
  EXPECT_EQ(refusal({{"barrier", "Fence"}, {"size", 1}}, 400), "size: is not a key of this request");
  const Json later = {{"barrier", "Fence"}, {"drag", {{"id", "a"}, {"number", 7}}}};
  EXPECT_EQ(asked(later).status, 200);
  EXPECT_EQ(refusal({{"barrier", "Fence"}, {"drag", {{"id", "a"}, {"number", 6}}}}, 409),
            "drag: a later request of this drag has arrived");
  EXPECT_EQ(asked(later).status, 200);
}

TEST_F(AskedLines, NeedStoredTrajectories) {
  std::filesystem::remove(folder_ / "trajectories.bin");
  EXPECT_EQ(refusal({{"barrier", "Fence"}}, 422),
            "trajectories.bin: the run has no stored trajectories (lines are asked of the paths of its rocks). Run it "
            "again with output.trajectories");
}

}  // namespace
}  // namespace talus
