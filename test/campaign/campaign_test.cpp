// Results do not depend on threads, on blocks, or on the order of rocks; a campaign can be stopped.

#include "talus/campaign/campaign.hpp"
#include "support/places.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "talus/campaign/simulate.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/results/summary.hpp"

namespace talus::campaign_test {
namespace {

Model tutorial_model(const char* dimensions, std::int64_t rocks, std::vector<std::string> settings = {}) {
  Problems warnings;
  const auto file = std::filesystem::path(talus::places::in_source("/examples/tutorial-1")) /
                    (std::string("tutorial-1-") + dimensions + ".toml");
  return project::build_model(project::read_project(file, {std::move(settings), rocks, {}}).project, warnings);
}

std::uint64_t bits_of(const RockOutcome& outcome) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const double x : {outcome.end.position.x(), outcome.end.position.y(), outcome.end.position.z(), outcome.end.time,
                         outcome.max_kinetic_energy, outcome.max_bounce}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
  }
  return hash;
}

TEST(Campaign, SimulatesARockTheSameInAnyOrder) {
  for (const char* model_kind : {"lumped_mass", "rigid_sphere"}) {
    const Model model = tutorial_model("3d", 200, {std::string("analysis.model=") + model_kind});
    Simulator forwards(model), backwards(model);
    std::vector<std::uint64_t> hashes(200);
    for (std::uint64_t rock = 0; rock < 200; ++rock) hashes[rock] = bits_of(forwards.simulate(rock, false).outcome);
    for (std::uint64_t rock = 200; rock-- > 0;)
      EXPECT_EQ(bits_of(backwards.simulate(rock, true).outcome), hashes[rock]) << rock;
  }
}

// Rocks simulated together have the bits, rows and pieces of rocks simulated alone, and come in the order of their
// numbers.
TEST(Campaign, SimulatesRocksTogetherAsAlone) {
  for (const char* dimensions : {"2d", "3d"}) {
    for (const char* model_kind : {"lumped_mass", "rigid_sphere"}) {
      const Model model = tutorial_model(dimensions, 500, {std::string("analysis.model=") + model_kind});
      Simulator together(model), alone(model);
      std::uint64_t next = 100;
      std::size_t glides = 0;
      SimulationOrder order;
      order.rocks = {100, 400};
      order.keep_rows = [](std::uint64_t rock) { return rock % 2 == 0; };
      order.keep_pieces = true;
      order.see = [&](const RockRecord& record, const RockLog& log) {
        ASSERT_EQ(record.rock, next++);
        const RockRecord other = alone.simulate(record.rock, true, true);
        ASSERT_EQ(bits_of(record.outcome), bits_of(other.outcome)) << record.rock;
        ASSERT_EQ(log.rows.size(), record.rock % 2 == 0 ? alone.log().rows.size() : 0U);
        ASSERT_EQ(log.pieces.size(), alone.log().pieces.size());
        ASSERT_EQ(log.glide_steps.size(), alone.log().glide_steps.size());
        for (std::size_t k = 0; k < log.pieces.size(); ++k) {
          ASSERT_EQ(log.pieces[k].path.p, alone.log().pieces[k].path.p);
          ASSERT_EQ(log.pieces[k].steps.count, alone.log().pieces[k].steps.count);
          glides += log.pieces[k].steps.count > 1 ? 1 : 0;
        }
      };
      together.simulate(order);
      EXPECT_EQ(next, 400U);
      EXPECT_EQ(glides > 0, std::string(model_kind) == "lumped_mass") << dimensions;
    }
  }
}

TEST(Campaign, HasTheSameSumsOnAnyNumberOfThreads) {
  const Model model = tutorial_model("2d", 3000);
  std::vector<Descriptive> seen;
  for (const int threads : {1, 2, 8}) {
    SummaryObserver summary(model.rocks(), model.barriers.size(), model.frame);
    Observer* const observers[] = {&summary};
    EXPECT_EQ(run_campaign(model, observers, {threads, nullptr, {}}).done, 3000U);
    seen.push_back(summary.summary().runout_plan.describe());
  }
  for (const Descriptive& d : seen) {
    EXPECT_EQ(d.mean, seen[0].mean);
    EXPECT_EQ(d.skewness, seen[0].skewness);
    EXPECT_EQ(d.median, seen[0].median);
    EXPECT_EQ(d.sum, seen[0].sum);
  }
}

// Ranges with other borders than those of blocks: each rock is seen once, in order.
TEST(Campaign, RunsTheRocksOfARange) {
  struct Numbers : Observer {
    struct Part : ObserverPart {
      void see(const RockRecord& record, const RockLog&) override { rocks.push_back(record.rock); }
      std::vector<std::uint64_t> rocks;
    };
    [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
    [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override { return std::make_unique<Part>(); }
    void commit(ObserverPart& part) override {
      for (const std::uint64_t rock : static_cast<Part&>(part).rocks) rocks.push_back(rock);
    }
    std::vector<std::uint64_t> rocks;
  };
  const Model model = tutorial_model("2d", 2000);
  Numbers seen;
  Observer* const observers[] = {&seen};
  for (const RockRange& range : {RockRange{0, 1}, RockRange{1, 1}, RockRange{1, 1500}, RockRange{1500, 2000}}) {
    std::uint64_t reported = range.first;
    CampaignOptions options{4, nullptr, [&](std::uint64_t done) { reported = done; }, range};
    const CampaignOutcome outcome = run_campaign(model, observers, options);
    EXPECT_EQ(outcome.done, range.last);
    EXPECT_EQ(reported, range.last);
    EXPECT_FALSE(outcome.interrupted);
  }
  ASSERT_EQ(seen.rocks.size(), 2000U);
  for (std::uint64_t rock = 0; rock < 2000; ++rock) EXPECT_EQ(seen.rocks[rock], rock);
}

// An error while blocks are committed, such as a full disk, ends the campaign and reaches the caller.
TEST(Campaign, EndsWithAnExceptionFromProgress) {
  const Model model = tutorial_model("2d", 1'000'000'000);
  const CampaignOptions options{2, nullptr, [](std::uint64_t done) {
                                  if (done > 1000) throw BadInput(Problem{.what = "the disk is full"});
                                }};
  EXPECT_THROW((void)run_campaign(model, {}, options), BadInput);
}

TEST(Campaign, CountsEveryRockOnceAndLosesNone) {
  const Model model = tutorial_model("3d", 10'000);
  SummaryObserver summary(model.rocks(), model.barriers.size(), model.frame);
  Observer* const observers[] = {&summary};
  (void)run_campaign(model, observers, {});
  std::uint64_t ended = 0;
  for (const std::uint64_t count : summary.summary().ends) ended += count;
  EXPECT_EQ(ended, 10'000U);
  EXPECT_EQ(summary.summary().ends[static_cast<std::size_t>(EndReason::lost)], 0U);
}

TEST(Campaign, StopsOnRequestAndKeepsTheFirstRocks) {
  const Model model = tutorial_model("2d", 1'000'000);
  SummaryObserver summary(model.rocks(), model.barriers.size(), model.frame);
  Observer* const observers[] = {&summary};
  std::atomic<bool> stop{false};
  CampaignOptions options{2, &stop, [&](std::uint64_t done) { stop = stop || done > 2000; }};
  const CampaignOutcome outcome = run_campaign(model, observers, options);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_GT(outcome.done, 2000U);
  EXPECT_LT(outcome.done, 1'000'000U);
  EXPECT_EQ(summary.summary().done, outcome.done);
}

TEST(Campaign, LatinHypercubeReducesTheScatterOfTheMean) {
  // Over several seeds, the mean release velocity scatters far less if it is stratified.
  const auto scatter = [](const char* method) {
    double squares = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Model model = tutorial_model("2d", 50, {std::string("sampling.method=") + method});
      model.seed = seed;
      Simulator simulator(model);
      double sum = 0;
      for (std::uint64_t rock = 0; rock < 50; ++rock) sum += simulator.simulate(rock, false).outcome.start.velocity.x();
      squares += (sum / 50 - 1.5) * (sum / 50 - 1.5);
    }
    return std::sqrt(squares / 20);
  };
  EXPECT_NEAR(scatter("monte_carlo"), 0.15 / std::sqrt(50.0), 0.008);
  EXPECT_LT(scatter("latin_hypercube"), 0.002);
}

// A section that varies from rock to rock, with a barrier between two collectors.
Model uncertain_model(const char* deviations) {
  Problems warnings;
  const std::string text = std::string(R"(
[terrain]
section = [[0, 60], [40, 30], [60, 20], [100, 15]]
section_std_dev_m = )") + deviations +
                           R"(
[[material]]
name = "Rock"
normal_restitution = 0.35
tangential_restitution = 0.9
friction_angle_deg = 5
[[seeder]]
position = [2, "surface"]
rocks = 300
mass_kg = 1000
horizontal_velocity_m_s = 1
[[barrier]]
name = "Wall"
line = 60
height_m = 5
[[collector]]
name = "Before"
line = 50
height_m = 50
[[collector]]
name = "Behind"
line = 61
height_m = 50
)";
  return project::build_model(project::read_project_text(text, "slope.toml").project, warnings);
}

TEST(Campaign, BarriersStandOnTheSlopeOfEachRock) {
  const Model model = uncertain_model("[[0, 0], [0, 0.5], [0, 0.5], [0, 0.5]]");
  Simulator simulator(model);
  double lowest = 1e300, highest = -1e300;
  for (std::uint64_t rock = 0; rock < model.rocks(); ++rock) {
    const RockRecord record = simulator.simulate(rock, false);
    ASSERT_EQ(record.outcome.reason, EndReason::stopped_by_barrier) << rock;
    ASSERT_EQ(simulator.log().hits.size(), 2U) << rock;
    EXPECT_EQ(simulator.log().hits[0].barrier, BarrierId{1});
    const Passage& hit = simulator.log().hits[1];
    EXPECT_EQ(hit.barrier, BarrierId{0});
    const double foot = hit.motion.position.z() - hit.height;
    lowest = std::min(lowest, foot);
    highest = std::max(highest, foot);
  }
  // Three hundred normal values extend over about five standard deviations.
  EXPECT_GT(highest - lowest, 2);
  EXPECT_LE(highest - lowest, 3);
}

TEST(Campaign, BarriersOnAVaryingSectionWithoutVariationDoNotMove) {
  const Model model = uncertain_model("[[0, 0], [0, 0], [0, 0], [0, 0]]");
  Model certain = uncertain_model("[[0, 0], [0, 0], [0, 0], [0, 0]]");
  certain.varying.reset();
  Simulator one(model), other(certain);
  for (std::uint64_t rock = 0; rock < 20; ++rock) {
    ASSERT_EQ(bits_of(one.simulate(rock, false).outcome), bits_of(other.simulate(rock, false).outcome));
    ASSERT_EQ(one.log().hits.size(), other.log().hits.size());
    ASSERT_EQ(one.log().hits.back().height, other.log().hits.back().height);
  }
}

TEST(Campaign, DrawsMaterialsOncePerRockOnRequest) {
  const Model per_rock = tutorial_model("2d", 1, {"sampling.materials=per_rock"});
  const Model per_impact = tutorial_model("2d", 1);
  EXPECT_NE(bits_of(Simulator(per_rock).simulate(0, false).outcome),
            bits_of(Simulator(per_impact).simulate(0, false).outcome));
}

}  // namespace
}  // namespace talus::campaign_test
