#include "talus/run/run_warnings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace talus::project {
namespace {

using Ends = std::vector<std::pair<EndReason, std::uint64_t>>;

/// The warnings of a run of this many rocks, of which some did not come to rest.
std::string warned_after(std::uint64_t rocks, const Ends& ends) {
  Summary summary(rocks, 0);
  summary.done = rocks;
  for (const auto& [reason, count] : ends) summary.ends[static_cast<std::size_t>(reason)] = count;
  Problems warnings;
  warn_of_rocks(summary, warnings);
  return warnings.text();
}

TEST(WarningsOfRocks, ReportEndsAtLimitsOfTheModel) {
  EXPECT_EQ(
      warned_after(20'000, {{EndReason::no_data, 18'369}}),
      "warning: rocks: 18369 of 20000 rocks ended where the terrain has no data (runout, reach and end points are "
      "cut there). Use a terrain that has data where rocks go");
  EXPECT_EQ(warned_after(100, {{EndReason::maximum_steps, 1}, {EndReason::maximum_time, 1}}),
            "warning: rocks: 1 of 100 rocks were ended after the maximum number of steps (runout, reach and end points "
            "are cut there). Raise analysis.max_steps\n"
            "warning: rocks: 1 of 100 rocks were ended at the maximum time (runout, reach and end points are cut "
            "there). Raise analysis.max_time_s");
}

TEST(WarningsOfRocks, IgnoreOneInAHundred) {
  EXPECT_EQ(warned_after(200, {{EndReason::no_data, 1}, {EndReason::maximum_time, 1}}), "");
  EXPECT_NE(warned_after(199, {{EndReason::no_data, 1}, {EndReason::maximum_time, 1}}), "");
  EXPECT_EQ(warned_after(0, {}), "");
}

TEST(WarningsOfRocks, IgnoreRocksThatLeaveTheModel) {
  EXPECT_EQ(warned_after(100, {{EndReason::left_model, 100}}), "");
}

// More than half of the way of all rocks.
TEST(WarningsOfRocks, ReportThatTheySlid) {
  const auto warned = [](double flown, double on_ground) {
    Summary summary(100, 0);
    summary.done = 100;
    summary.flown.add(flown);
    summary.on_ground.add(on_ground);
    Problems warnings;
    warn_of_rocks(summary, warnings);
    return warnings.text();
  };
  EXPECT_EQ(
      warned(2, 8),
      "warning: rocks: 80 % of the way of all rocks was slid or rolled (blocks bounce on natural ground: heights, "
      "and what fences must have, may be far too low). Look at roughness_deg of the materials before you use "
      "heights of this run");
  EXPECT_EQ(warned(8, 8), "");
  EXPECT_EQ(warned(0, 0), "");
}

RunDescription described(const char* model) {
  RunDescription description;
  description.model = nlohmann::ordered_json::parse(model);
  return description;
}

TEST(WarningsOfSources, NameSourcesWhoseRocksWereNotRun) {
  const RunDescription three = described(
      R"({"sources": [{"name": "West", "rocks": 20}, {"name": "Middle", "rocks": 20}, {"name": "East", "rocks": 20}],
          "releases": [{"first_rock": 0, "rocks": 30, "rocks_at_once": 1, "places": 30, "step": 11, "start": 4,
                        "sources": [[0, 0], [10, 1]]},
                       {"first_rock": 30, "rocks": 30, "rocks_at_once": 1, "places": 30, "step": 11, "start": 4,
                        "sources": [[0, 2], [20, 0]]}]})");
  const auto warnings_of = [&](std::uint64_t first_not_run) {
    Problems warnings;
    warn_of_sources(three, first_not_run, warnings);
    return warnings.text();
  };
  const std::string hint = "). Go on with --resume; what there is says nothing of the whole";
  EXPECT_EQ(warnings_of(20),
            "warning: rocks: the run was stopped before \"East\" released any rock (rocks are run seeder after seeder; "
            "of \"West\", \"Middle\" not all were" +
                hint);
  EXPECT_EQ(warnings_of(35),
            "warning: rocks: the run was stopped before all sources had released their rocks (rocks are run seeder "
            "after seeder; of \"West\", \"East\" not all were" +
                hint);
  Problems warnings;
  const RunDescription one = described(
      R"({"sources": [{"name": "West", "rocks": 70}, {"name": "East", "rocks": 30}],
          "releases": [{"first_rock": 0, "rocks": 100, "rocks_at_once": 1, "places": 100, "step": 61, "start": 0,
                        "sources": [[0, 0], [70, 1]]}]})");
  warn_of_sources(one, 5, warnings);
  EXPECT_EQ(warnings.text(), "") << "the first rocks of a seeder are spread over all of its places";
  warn_of_sources(one, 1, warnings);
  EXPECT_EQ(warnings.text(),
            "warning: rocks: the run was stopped before \"East\" released any rock (few rocks were "
            "run; of \"West\" not all were" +
                hint);
}

TEST(WarningsOfCollectors, ReportHowManyRocksPassedAbove) {
  const RunDescription two =
      described(R"({"barriers": [{"name": "Net", "kind": "barrier"}, {"name": "Road", "kind": "collector"}]})");
  const auto warnings_of = [&](std::uint64_t above) {
    Summary summary(1000, 2);
    for (BarrierTally& tally : summary.barriers) {
      tally.rocks_hit = 990;
      tally.rocks_passed_above = above;
    }
    Problems warnings;
    warn_of_collectors(two, summary, warnings);
    return warnings.text();
  };
  EXPECT_EQ(
      warnings_of(110),
      "warning: collector \"Road\": 110 of 1100 rocks passed above it (its hits are those of the others only; a design, "
      "and a line that is asked, have all). Raise its height_m");
  EXPECT_EQ(warnings_of(10), "") << "one in a hundred";
}

DesignPlan two_lines() {
  DesignPlan plan;
  plan.lines = {{"Upper", 0, 25, 10, 3}, {"Lower", 1, 8, 10, 1}};
  plan.catch_share = 0.95;
  plan.energies = {10e3};
  return plan;
}

TEST(WarningsOfDesign, ReportWhatLimitsTheBestKitOfALine) {
  DesignResult result;
  result.lines.resize(2);
  result.lines[0].whole.rocks = 3611;
  KitChoice kit{.line = 0,
                .height = 4,
                .limit = KitLimit::ends,
                .caught = RockShare{3500, 4501, 0.78, 0.77, 0.79},
                .beside = 890};
  result.ranking = {kit, kit};
  const auto warned = [&] {
    Problems warnings;
    warn_of_design(two_lines(), result, warnings);
    return warnings.text();
  };
  const std::string nobody =
      "warning: line \"Lower\": no rock crosses it (there is nothing to design a barrier for). Check where the line "
      "lies; with few rocks, run more";
  EXPECT_EQ(warned(), nobody +
                          "\nwarning: line \"Upper\": no kit catches 95 % of the rocks (890 of 4,501 pass beyond the "
                          "ends of the line: lengthen it)");
  result.ranking.front().suffices = true;
  result.ranking.front().limit = KitLimit::none;
  EXPECT_EQ(warned(), nobody);
}

// The 95th percentile may be that of small blocks, and a kit may be lower still.
TEST(WarningsOfDesign, ReportHeightsBelowTheSizeOfTheBlocks) {
  DesignPlan plan = two_lines();
  plan.lines.resize(1);
  DesignResult result;
  result.lines.resize(1);
  result.lines[0].whole.rocks = 100;
  result.lines[0].whole.largest_block = 1.12;
  result.lines[0].whole.demand = KitDemand{100e3, 0, 0.9};
  result.ranking = {KitChoice{.line = 0, .height = 1, .suffices = true, .caught = RockShare{96, 100, 0.96, 0.9, 0.99}}};
  std::vector<ProblemKind> kinds;
  const auto warned = [&] {
    Problems warnings;
    warn_of_design(plan, result, warnings);
    for (const Problem& problem : warnings.list()) kinds.push_back(problem.kind);
    return warnings.text();
  };
  const std::string rest =
      " m, less than the largest block that crosses (its diameter is 1.12 m: such a block reaches over the fence even "
      "as it rolls). Take at least that height, or a higher percentile";
  EXPECT_EQ(warned(), "warning: line \"Upper\": the height that a fence must have is 0.90" + rest +
                          "\nwarning: line \"Upper\": the kit's height is 1.00" + rest);
  EXPECT_EQ(kinds, (std::vector{ProblemKind::height_below_block, ProblemKind::kit_below_block}));
  result.lines[0].whole.demand->height = 1.12;
  result.ranking.front().height = 2;
  EXPECT_EQ(warned(), "");
}

}  // namespace
}  // namespace talus::project
