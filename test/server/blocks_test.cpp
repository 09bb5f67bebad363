// The blocks of a run over the API agree with the trajectories that the engine simulates.

#include "server/served_runs.hpp"

#include <algorithm>
#include <cmath>

#include "run_model.hpp"
#include "talus/campaign/simulate.hpp"

namespace talus {
namespace {

using testing_tools::ArraysOf;
using testing_tools::Json;
using testing_tools::Reply;

/// A slope with three kinds of rocks.
std::string slope_of_blocks(const std::string& terrain, const std::string& output = "") {
  return R"(name = "Blocks"

[analysis]
model = "rigid_body"

[terrain]
section = [[0, 40], [20, 20], [120, 15]]
)" + terrain +
         R"(
[[material]]
name = "Scree"
normal_restitution = 0.35
dynamic_friction = 0.6
rolling_friction = 0.05

[ground]
segments = ["Scree", "Scree"]

[[seeder]]
name = "Boxes"
position = [4, 10]
height_above_m = 2
rocks = 3
mass_kg = 1500
shape = "cube"

[[seeder]]
name = "Spheres"
position = [4, 20]
height_above_m = 2
rocks = 2
mass_kg = 1500

[output]
report = false
)" + output;
}

class RunBlocks : public testing_tools::ServedRuns {
 protected:
  std::string run_of(const std::string& text) {
    write(file_, text);
    const std::string id = begin(text);
    EXPECT_EQ(wait_for(id, "done")["state"], "done");
    return id;
  }
  [[nodiscard]] Reply ask_for(const std::string& id, const Json& rocks) const {
    return post("/api/runs/" + id + "/blocks", {{"rocks", rocks}});
  }
};

/// Compares the poses in an answer with the rock as it is simulated: at the end it lies as the engine says.
void expect_as_simulated(const ArraysOf& blocks, const Model& model) {
  const auto rocks = blocks.get<std::uint32_t>("rocks", "u32"),
             starts = blocks.get<std::uint32_t>("pose_starts", "u32");
  const auto times = blocks.get<float>("times", "f32"), positions = blocks.get<float>("positions", "f32");
  const auto turns = blocks.get<float>("turns", "f32");
  ASSERT_EQ(starts.size(), rocks.size() + 1);
  EXPECT_EQ(starts.back(), times.size());
  EXPECT_EQ(positions.size(), 3 * times.size());
  EXPECT_EQ(turns.size(), 4 * times.size());
  Simulator simulator(model);
  for (std::size_t k = 0; k < rocks.size(); ++k) {
    const RockRecord record = simulator.simulate(rocks[k], false, true);
    const RockBlock block = *block_of(model, rocks[k]);
    const std::size_t last = starts[k + 1] - 1;
    EXPECT_EQ(times[starts[k]], 0);
    EXPECT_NEAR(times[last], record.outcome.end.time, 1e-4);
    const Vec3 end = model.frame.global_from_local(record.outcome.end.position);
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(positions[3 * last + axis] + blocks.header["origin"][axis].get<double>(), end[axis], 1e-3);
    // Every pose is within the step of the store and single precision.
    for (std::size_t at = starts[k]; at < starts[k + 1]; ++at) {
      const Orientation turn(turns[4 * at + 3], turns[4 * at], turns[4 * at + 1], turns[4 * at + 2]);
      EXPECT_LT(angle_between(turn, orientation_at(simulator.log().attitudes, block.inertia, times[at])), 0.04);
    }
  }
}

TEST_F(RunBlocks, AreHullsThatMoveAndTurn) {
  const std::string stored = slope_of_blocks("width_m = 40\n");
  // Those of the second run are not stored, so they are simulated again.
  for (const std::string& text : {stored, stored + "trajectories_MB = \"none\"\n"}) {
    const std::string id = run_of(text);
    EXPECT_EQ(ArraysOf(get("/api/runs/" + id + "/paths")).header["blocks"], true);
    const ArraysOf blocks(ask_for(id, {0, 2, 4}));
    EXPECT_EQ(blocks.get<std::uint32_t>("rocks", "u32"), (std::vector<std::uint32_t>{0, 2})) << "4 is a sphere";
    EXPECT_EQ(blocks.get<std::uint32_t>("corner_starts", "u32"), (std::vector<std::uint32_t>{0, 8, 16}));
    EXPECT_EQ(blocks.get<std::uint32_t>("triangle_starts", "u32"), (std::vector<std::uint32_t>{0, 12, 24}));
    const auto triangles = blocks.get<std::uint32_t>("triangles", "u32");
    ASSERT_EQ(triangles.size(), 72U);
    EXPECT_EQ(*std::ranges::max_element(triangles), 7U);
    // The corners of a cube of 1,500 kg.
    const auto corners = blocks.get<float>("corners", "f32");
    const double half = 0.5 * std::cbrt(1500 / 2700.0);
    for (const float number : corners) EXPECT_NEAR(std::abs(number), half, 1e-5);
    const server::BuiltProject built = server::build(text, path(file_), {});
    expect_as_simulated(blocks, built.model);
  }
}

TEST_F(RunBlocks, OfASectionAreOutlines) {
  std::string text = slope_of_blocks("");
  for (const char* y : {"[4, 10]", "[4, 20]"}) text.replace(text.find(y), 7, "[4]");
  text.replace(text.find("\"cube\""), 6, "\"hexagon\"");
  const ArraysOf blocks(ask_for(run_of(text), {1}));
  EXPECT_TRUE(blocks.get<std::uint32_t>("triangles", "u32").empty());
  const auto corners = blocks.get<float>("corners", "f32");
  ASSERT_EQ(corners.size(), 18U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(corners[3 * k + 1], 0);
  const server::BuiltProject built = server::build(text, path(file_), {});
  expect_as_simulated(blocks, built.model);
}

TEST_F(RunBlocks, AreNoneAmongSpheres) {
  std::string text = slope_of_blocks("width_m = 40\n");
  text.replace(text.find("\"cube\""), 6, "\"sphere\"");
  const std::string id = run_of(text);
  EXPECT_EQ(ArraysOf(get("/api/runs/" + id + "/paths")).header["blocks"], false);
  EXPECT_TRUE(ArraysOf(ask_for(id, {0, 1})).get<float>("times", "f32").empty());
}

TEST_F(RunBlocks, AreNotAvailableOnceTheFilesHaveChanged) {
  std::string text = slope_of_blocks("width_m = 40\n");
  const std::string vertices = "[[0, 40], [20, 20], [120, 15]]";
  text.replace(text.find(vertices), vertices.size(), "\"slope.csv\"");
  write("slope.csv", "x_m,z_m\n0,40\n20,20\n120,15\n");
  const std::string id = run_of(text);
  write("slope.csv", "x_m,z_m\n0,41\n20,20\n120,15\n");
  EXPECT_EQ(ArraysOf(get("/api/runs/" + id + "/paths")).header["blocks"], false);
  EXPECT_EQ(ask_for(id, {0}).status, 404);
  EXPECT_EQ(ask_for(id, {0}).problem(),
            "Blocks: the blocks of this run are not available (the files of the project have changed since)");
}

TEST_F(RunBlocks, AreRefusedWithTheReason) {
  const std::string id = run_of(slope_of_blocks("width_m = 40\n"));
  EXPECT_EQ(ask_for(id, {5}).status, 404);
  EXPECT_EQ(ask_for(id, {5}).problem(), "5: there is no such rock (it was not run)");
  const Reply missing = post("/api/runs/" + id + "/blocks", Json::object());
  EXPECT_EQ(missing.status, 400);
  EXPECT_EQ(missing.problem(), "rocks: is missing");
  for (const Json& wrong : {Json(3), Json{-1}, Json{0.5}, Json(std::vector<int>(1001, 0))}) {
    const Reply reply = ask_for(id, wrong);
    EXPECT_EQ(reply.status, 400);
    EXPECT_EQ(reply.problem(), "rocks: is not valid (expected a list of at most 1000 numbers of rocks)");
  }
}

}  // namespace
}  // namespace talus
