// Ditches over the API.

#include "lines/slopes.hpp"
#include "server/served_results.hpp"

namespace talus {
namespace {

using testing_tools::Json;
using testing_tools::Reply;

class AskedDitches : public testing_tools::ServedRuns {
 protected:
  AskedDitches() : id_(begin(vertical_face)) { EXPECT_EQ(wait_for(id_, "done")["state"], "done"); }
  [[nodiscard]] Reply asked(const Json& question) const { return post("/api/runs/" + id_ + "/ditch", question); }

  std::string id_;
};

TEST_F(AskedDitches, HaveSharesDistancesAndCriteria) {
  const Reply reply = asked({{"toe_m", 10}, {"far_m", 16}});
  ASSERT_EQ(reply.status, 200) << reply.body;
  const Json json = reply.json();
  EXPECT_EQ(json["rocks"], 5);
  EXPECT_EQ(json["arriving"]["rocks"], 5);
  EXPECT_EQ(json["beyond"]["rocks"], 3);
  EXPECT_EQ(json["inside"]["rocks"], 2);
  EXPECT_EQ(json["retained"]["share"]["value"], 0.4);
  EXPECT_LT(json["retained"]["share"]["low"].get<double>(), 0.4);
  EXPECT_NEAR(json["impact"]["percentiles"]["50"][0].get<double>(), 6.03, 0.01);
  EXPECT_TRUE(json["impact"]["percentiles"]["99"][2].is_null());  // five rocks give no upper end
  EXPECT_EQ(json["criteria"].size(), 3U);
  EXPECT_NEAR(json["criteria"][0]["width_m"].get<double>(), 8.6, 1e-9);
  // Its rocks are a selection for filters.
  const std::string selection = json["selection"];
  EXPECT_EQ(get("/api/runs/" + id_ + "/statistics?of=runout_xy_m&crossing=" + selection).json()["count"], 5);
}

TEST_F(AskedDitches, RefuseWhatIsNotOne) {
  const Reply off = asked({{"toe_m", 10}, {"far_m", 160}});
  EXPECT_EQ(off.status, 422);
  EXPECT_EQ(off.json()["problems"][0]["text"],
            "ditch: its far edge at x = 160 is off the section (rocks are only known on it)");
  EXPECT_EQ(asked({{"toe_m", 10}}).status, 400);
  EXPECT_EQ(asked({{"toe_m", 10}, {"far_m", 12}, {"depth_m", 1}}).status, 400);
  EXPECT_EQ(asked({{"toe_m", "x"}, {"far_m", 12}}).status, 400);
}

}  // namespace
}  // namespace talus
