// Answers as JSON: numbers as cards show them, and what would be enough.

#include "talus/lines/line_json.hpp"

#include <gtest/gtest.h>

#include <string>

#include "lines/slopes.hpp"
#include "support/simulated_paths.hpp"
#include "talus/lines/asked_run.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;
using testing_tools::SimulatedPaths;
using testing_tools::SimulatedRun;

TEST(ThreeDigits, AreAsACardShowsThem) {
  EXPECT_EQ(three_digits(0), "0.00");
  EXPECT_EQ(three_digits(0.416), "0.42");
  EXPECT_EQ(three_digits(3.414), "3.41");
  EXPECT_EQ(three_digits(9.999), "10.0");
  EXPECT_EQ(three_digits(18.24), "18.2");
  EXPECT_EQ(three_digits(99.96), "100");
  EXPECT_EQ(three_digits(412.4), "412");
  EXPECT_EQ(three_digits(999.6), "1,000");
  EXPECT_EQ(three_digits(1243), "1,243");
  EXPECT_EQ(three_digits(1234567.4), "1,234,567");
}

// Of numbers that are above, at and below the share of rocks.
TEST(RoundedPercents, RoundHalvesUp) {
  EXPECT_EQ(rounded_percents(1905. / 2000), 95.3);
  EXPECT_EQ(rounded_percents(201. / 400), 50.3);
  EXPECT_EQ(rounded_percents(23. / 80), 28.8);
  EXPECT_EQ(rounded_percents(0.3724), 37.2);
  EXPECT_EQ(rounded_percents(0), 0);
  EXPECT_EQ(rounded_percents(1), 100);
}

const std::string card_slope = testing_tools::replaced(plain_slope, "rocks = 150", "rocks = 40");
Json answer_to(const SimulatedRun& run, const std::vector<PlanPlace>& line, const AnswerOptions& options = {}) {
  Problems warnings;
  const AskedRun asked(run.model, std::make_unique<SimulatedPaths>(run.paths));
  project::DesignBasis basis = project::design_basis(run.project);
  add_kits_for_sliders(basis);
  return asked.line(basis, drawn_line(run.model, line, 5, "line", warnings), options).json;
}

TEST(LineJson, SaysHowManyRocksWouldBeEnough) {
  const SimulatedRun run(card_slope);
  const Json few = answer_to(run, {{35, 0}, {35, 60}});
  const Json& enough = few["enough"];
  // Forty rocks have no upper end of the 95th percentile: it takes 72.
  EXPECT_TRUE(few["whole"]["percentiles"]["ke_total_J"]["95"][2].is_null());
  EXPECT_FALSE(enough["energy"]["is_enough"].get<bool>());
  EXPECT_GE(enough["energy"]["rocks"].get<std::uint64_t>(), 72u);
  EXPECT_GE(enough["rocks"].get<std::uint64_t>(), enough["energy"]["rocks"].get<std::uint64_t>());
  EXPECT_NE(enough["text"].get<std::string>().find("(now 40)"), std::string::npos);
  EXPECT_NE(few["card"]["energy_interval"].get<std::string>().find("no upper end"), std::string::npos);
  EXPECT_EQ(few["design"]["energy_J"], few["whole"]["percentiles"]["ke_translational_J"]["95"]);
  EXPECT_EQ(few["design"]["height_m"], few["whole"]["percentiles"]["height_m"]["95"]);
  EXPECT_EQ(few["design"]["velocity_m_s"], few["whole"]["percentiles"]["velocity_m_s"]["95"]);
  const Json loose = answer_to(run, {{35, 0}, {35, 60}}, {.kit = {}, .precision = 1e6, .wants_sources = false});
  EXPECT_TRUE(loose["enough"]["share"]["is_enough"].get<bool>());
  EXPECT_FALSE(loose.contains("sources"));
}

// Blocks of 900 kg are 0.86 m in diameter.
TEST(AnsweredLine, SaysWhyItShouldNotBeTrusted) {
  const SimulatedRun run(card_slope);
  Problems warnings;
  const auto doubts = [&](const std::optional<WaysSummary>& ways, double kit_height) {
    const AskedRun asked(run.model, std::make_unique<SimulatedPaths>(run.paths), ways);
    const AskedLine line = drawn_line(run.model, std::vector<PlanPlace>{{35, 0}, {35, 60}}, 5, "line", warnings);
    return asked.line(project::design_basis(run.project), line, {.kit = KitSize{kit_height, 1e6}}).warnings.text();
  };
  EXPECT_EQ(doubts(WaysSummary{6, 4}, 3), "");
  EXPECT_EQ(doubts({}, 3), "") << "of a program that did not say";
  EXPECT_NE(doubts(WaysSummary{4, 6}, 3).find("warning: rocks: 60 % of the way of all rocks was slid or rolled"),
            std::string::npos);
  EXPECT_EQ(doubts({}, 0.8),
            "warning: line: the kit's height is 0.80 m, less than the largest block that crosses (its diameter is 0.86 "
            "m: such a block reaches over the fence even as it rolls). Take at least that height, or a higher "
            "percentile");
}

TEST(LineJson, OfALineThatNoRockCrosses) {
  const SimulatedRun run(card_slope);
  const Json none = answer_to(run, {{0.2, 0}, {0.2, 60}}, {.kit = KitSize{3, 1e6}, .precision = 0.1});
  EXPECT_EQ(none["whole"]["rocks"], 0);
  EXPECT_EQ(none["card"]["share"], "0.0 %");
  EXPECT_EQ(none["card"]["energy"], "");
  EXPECT_TRUE(none["design"]["energy_J"].is_null());
  EXPECT_TRUE(none["worst"].is_null());
  EXPECT_TRUE(none["whole"]["maxima"].is_null());
  EXPECT_TRUE(none["kits"]["share"][0][0].is_null());
  EXPECT_EQ(none["kit"]["text"], "3 m and 1,000 kJ: no rock crosses here");
  EXPECT_EQ(none["enough"]["text"], "None of 40 rocks crosses: more rocks would show rarer ones");
  EXPECT_EQ(none["sources"]["release"], Json::array());
}

TEST(AskedRun, RefusesTrajectoriesOfAnotherRun) {
  const SimulatedRun run(card_slope);
  auto paths = std::make_unique<SimulatedPaths>(run.paths);
  paths->keep(41, [](std::uint64_t) { return true; });
  try {
    const AskedRun asked(run.model, std::move(paths));
    FAIL() << "accepted";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.problems().text(),
              "the trajectories are of another run (they are of 41 rocks, and the project has 40)");
  }
}

TEST(UsualSection, MakesAboutTwentyOnALine) {
  const auto of = [](double length) {
    Barrier line;
    const std::vector<Vec3> foot{{0, 0, 0}, {length, 0, 0}};
    line.set_panels(panels_over(foot, 5, 0));
    return usual_section(line);
  };
  EXPECT_DOUBLE_EQ(of(200), 10);
  EXPECT_DOUBLE_EQ(of(82.4), 5);
  EXPECT_DOUBLE_EQ(of(30), 2);
  EXPECT_DOUBLE_EQ(of(1), 0.05);
}

}  // namespace
}  // namespace talus
