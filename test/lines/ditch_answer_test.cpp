// Ditches and benches that are asked after a run.

#include "talus/lines/ditch_answer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lines/slopes.hpp"
#include "support/simulated_paths.hpp"
#include "talus/lines/ditch_json.hpp"

namespace talus {
namespace {

using testing_tools::SimulatedRun;

DitchAnswer asked(const SimulatedRun& run, double toe, double far_edge) {
  return ask_ditch(run.model, run.paths, ditch_between(run.model, toe, far_edge, "ditch"));
}

std::string ditch_refusal(const Model& model, double toe, double far_edge) {
  try {
    static_cast<void>(ditch_between(model, toe, far_edge, "ditch"));
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return {};
}

/// From rest at height h with the horizontal velocity v, a rock lands v sqrt(2 h/g) away.
TEST(AskedDitch, HasTheImpactsOfTheParabola) {
  const SimulatedRun run(vertical_face);
  const double fall = std::sqrt(2 * 20.5 / -run.model.laws.gravity.z());
  const DitchAnswer answer = asked(run, 10, 16);
  EXPECT_EQ(answer.rocks, 5u);
  ASSERT_EQ(answer.arriving.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const RockInDitch& rock = answer.arriving[k];
    const double distance = static_cast<double>(k + 1) * fall - 0.1;
    ASSERT_TRUE(rock.first_impact.has_value());
    EXPECT_NEAR(*rock.first_impact, distance, 1e-9);
    EXPECT_NEAR(rock.farthest, distance, 1e-9);
    EXPECT_EQ(rock.gets_beyond, distance > 6);
    EXPECT_EQ(rock.ends_inside, distance < 6);
  }
  ASSERT_TRUE(answer.slope.has_value());
  EXPECT_NEAR(answer.slope->height, 20.5, 1e-9);
  EXPECT_NEAR(answer.slope->angle, std::atan2(20.5, 0.1), 1e-9);
}

/// What a barrier in the ditch does to rocks says nothing of the ditch: distances from the barrier on are lower limits.
TEST(AskedDitch, KnowsNoDistancesBehindItsBarrier) {
  const SimulatedRun run(vertical_face + "[[barrier]]\nline = 13.5\nheight_m = 30\n");
  const DitchAnswer answer = asked(run, 10, 16);
  ASSERT_EQ(answer.arriving.size(), 5u);
  EXPECT_NEAR(*answer.arriving[0].first_impact, 1.944, 1e-3);
  EXPECT_FALSE(answer.arriving[0].at_barrier.has_value());
  for (std::size_t k = 1; k < 5; ++k) {
    EXPECT_FALSE(answer.arriving[k].first_impact.has_value());
    EXPECT_NEAR(answer.arriving[k].at_barrier.value_or(0), 3.5, 1e-9);
    EXPECT_TRUE(answer.arriving[k].is_held());
  }
  const auto json = ditch_json(run.model, ditch_between(run.model, 10, 16, "ditch"), answer, 0.5);
  EXPECT_EQ(json["beyond"]["rocks"], 0);
  EXPECT_EQ(json["held"]["rocks"], 4);
  EXPECT_EQ(json["beyond_or_held"]["rocks"], 4);
  for (const char* what : {"impact", "rollout"}) {
    EXPECT_EQ(json[what]["rocks"], 5);
    EXPECT_NEAR(json[what]["known_to_m"].get<double>(), 3.5, 1e-9);
    EXPECT_NEAR(json[what]["percentiles"]["50"][0].get<double>(), 3.5, 1e-9);
    EXPECT_TRUE(json[what]["percentiles"]["50"][2].is_null());
  }
  // A fence past the far edge cuts nothing.
  const SimulatedRun far(vertical_face + "[[barrier]]\nline = 17\nheight_m = 30\n");
  const auto whole = ditch_json(far.model, ditch_between(far.model, 10, 16, "ditch"), asked(far, 10, 16), 0.5);
  EXPECT_EQ(whole["held"]["rocks"], 0);
  EXPECT_TRUE(whole["rollout"]["known_to_m"].is_null());
}

/// The mirrored slope has the mirrored answer.
TEST(AskedDitch, IsTheSameOnAMirroredSlope) {
  std::string mirrored = vertical_face;
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = mirrored.find(from, at)) != std::string::npos; at += to.size())
      mirrored.replace(at, from.size(), to);
  };
  replace("[[0, 20], [10, 20], [10, 0], [60, 0]]", "[[-60, 0], [-10, 0], [-10, 20], [0, 20]]");
  replace("[9.9,", "[-9.9,");
  replace("_m_s = ", "_m_s = -");
  const SimulatedRun right(vertical_face), left(mirrored);
  const DitchAnswer one = asked(right, 10, 16), other = asked(left, -10, -16);
  ASSERT_EQ(other.arriving.size(), one.arriving.size());
  for (std::size_t k = 0; k < one.arriving.size(); ++k) {
    EXPECT_NEAR(*other.arriving[k].first_impact, *one.arriving[k].first_impact, 1e-9);
    EXPECT_EQ(other.arriving[k].gets_beyond, one.arriving[k].gets_beyond);
  }
  EXPECT_NEAR(other.slope->angle, one.slope->angle, 1e-12);
}

TEST(AskedDitch, CountsRocksThatSlideIn) {
  const SimulatedRun run(R"([terrain]
section = [[0, 10], [10, 0], [60, 0]]
[[material]]
name = "Ice"
normal_restitution = 0
tangential_restitution = 1
friction_angle_deg = 10
[[seeder]]
position = [1, 9]
mass_kg = 100
)");
  const DitchAnswer answer = asked(run, 5, 8);
  ASSERT_EQ(answer.arriving.size(), 1u);
  EXPECT_EQ(answer.arriving[0].first_impact, 0.0);
  EXPECT_TRUE(answer.arriving[0].gets_beyond);
  EXPECT_NEAR(answer.arriving[0].farthest, run.records[0].outcome.end.position.x() + run.model.frame.origin.x() - 5,
              1e-9);
  // Released past the toe: it is not asked about.
  const DitchAnswer below = asked(run, 0.5, 8);
  EXPECT_EQ(below.rocks, 0u);
  EXPECT_EQ(below.released_beyond, 1u);
}

/// No rock gets lost between the answers, and a wider ditch keeps the rocks of a narrower one.
TEST(AskedDitch, KeepsMoreRocksIfItIsWider) {
  std::string slope = plain_slope;
  slope.replace(slope.find("width_m = 60\n"), 13, "");
  slope.replace(slope.find("points = [[1, 10], [1, 50]]"), 27, "points = [[1, \"surface\"], [2, \"surface\"]]");
  slope.replace(slope.find("height_above_m = 1\n"), 19, "");
  const SimulatedRun run(slope);
  std::size_t before = run.records.size();
  for (const double width : {2.0, 5.0, 10.0, 20.0, 50.0}) {
    const DitchAnswer answer = asked(run, 30, 30 + width);
    std::size_t beyond = 0;
    for (const RockInDitch& rock : answer.arriving) {
      EXPECT_EQ(rock.gets_beyond, rock.farthest > width - 1e-6);
      if (rock.first_impact) {
        EXPECT_LE(*rock.first_impact, rock.farthest + 1e-9);
      }
      beyond += rock.gets_beyond ? 1 : 0;
    }
    EXPECT_LE(beyond, before);
    before = beyond;
    const auto json = ditch_json(run.model, ditch_between(run.model, 30, 30 + width, "ditch"), answer, 0.95);
    EXPECT_EQ(json["beyond"]["rocks"].get<std::size_t>() + json["kept"]["rocks"].get<std::size_t>(), answer.rocks);
    EXPECT_EQ(json["rollout"]["rocks"], answer.arriving.size());
  }
}

TEST(AskedDitch, RefusesWhatIsNoStretchOfTheSection) {
  const Model model = testing_tools::model_of(vertical_face);
  EXPECT_EQ(ditch_refusal(model, 12, 12),
            "ditch: is 0 m wide (expected at least 1 mm). Give the toe, at the foot of the slope, and the far edge");
  EXPECT_EQ(ditch_refusal(model, 12, 80),
            "ditch: its far edge at x = 80 is off the section (rocks are only known on it)");
  EXPECT_EQ(ditch_refusal(model, NAN, 20), "ditch: point 1 is (nan, 0) (expected numbers)");
  EXPECT_EQ(ditch_refusal(testing_tools::model_of(plain_slope), 30, 35),
            "ditch: is a stretch of a section (this run is 3D). Ask for a line or a polygon");
}

}  // namespace
}  // namespace talus
