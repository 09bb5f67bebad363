#include "talus/project/run_results.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace talus::project {
namespace {

using Ends = std::vector<std::pair<EndReason, std::uint64_t>>;

/// What a run warns of after so many rocks, of which these did not come to rest.
std::string warned_after(std::uint64_t rocks, const Ends& ends) {
  Summary summary(rocks, 0);
  summary.done = rocks;
  for (const auto& [reason, count] : ends) summary.ends[static_cast<std::size_t>(reason)] = count;
  Problems warnings;
  warn_of_rocks(summary, warnings);
  return warnings.text();
}

TEST(WarningsOfRocks, TellOfEndsThatAreTheModelsAndNotTheSlopes) {
  EXPECT_EQ(
      warned_after(20'000, {{EndReason::no_data, 18'369}}),
      "warning: rocks: 18369 of 20000 rocks ended where the terrain has no data (runout, reach and end points are "
      "cut there). Use a terrain that has data where rocks come");
  EXPECT_EQ(warned_after(100, {{EndReason::maximum_steps, 1}, {EndReason::maximum_time, 1}}),
            "warning: rocks: 1 of 100 rocks were ended after the maximum number of steps (runout, reach and end points "
            "are cut there). Raise analysis.max_steps\n"
            "warning: rocks: 1 of 100 rocks were ended at the maximum time (runout, reach and end points are cut "
            "there). Raise analysis.max_time_s");
}

TEST(WarningsOfRocks, LeaveOneInAHundredAlone) {
  EXPECT_EQ(warned_after(200, {{EndReason::no_data, 1}, {EndReason::maximum_time, 1}}), "");
  EXPECT_NE(warned_after(199, {{EndReason::no_data, 1}, {EndReason::maximum_time, 1}}), "");
  EXPECT_EQ(warned_after(0, {}), "");
}

TEST(WarningsOfRocks, TakeTheEdgeOfTheModelForMeant) {
  EXPECT_EQ(warned_after(100, {{EndReason::left_model, 100}}), "");
}

}  // namespace
}  // namespace talus::project
