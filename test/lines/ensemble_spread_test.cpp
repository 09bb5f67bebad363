// The range between ensembles at a line and in an area, against runs of each ensemble alone.

#include "talus/lines/ensemble_spread.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lines/slopes.hpp"
#include "support/simulated_paths.hpp"
#include "talus/lines/asked_run.hpp"

namespace talus {
namespace {

using testing_tools::replaced;
using testing_tools::SimulatedPaths;
using testing_tools::SimulatedRun;

/// The bouncing slope with a set of parameters for each of so many ensembles, which differ by `step`.
std::string slope_with_ensembles(int ensembles, double step) {
  const std::string file = testing::TempDir() + "ensemble_spread_" + std::to_string(ensembles) + ".csv";
  std::ofstream sample(file);
  sample << "material.0.tangential_restitution.mean\n";
  for (int k = 0; k < ensembles; ++k) sample << 0.9 - step * k << "\n";
  return replaced(
      bouncing_slope, "[analysis]",
      "[sampling]\nparameters = \"" + file + "\"\nensembles = " + std::to_string(ensembles) + "\n\n[analysis]");
}

constexpr std::array<PlanPlace, 2> foot{{{25, 2}, {25, 58}}};

LineSpread spread_at_foot(const SimulatedRun& run) {
  Problems warnings;
  const AskedLine line = drawn_line(run.model, foot, asked_height, "line", warnings);
  return ensemble_spread(
      run.model, run.paths.rocks(),
      ask_lines(run.model, project::design_basis(run.project), run.paths, std::span(&line, 1)).front());
}

TEST(EnsembleSpread, IsOverTheAnswersOfEachEnsembleAlone) {
  constexpr std::uint64_t ensembles = 8;
  const SimulatedRun run(slope_with_ensembles(ensembles, 0.05));
  ASSERT_EQ(run.model.ensembles.size(), ensembles);
  const LineSpread spread = spread_at_foot(run);
  Problems warnings;
  const AskedLine line = drawn_line(run.model, foot, asked_height, "line", warnings);
  const auto basis = project::design_basis(run.project);
  std::vector<double> shares, energies, heights;
  for (std::uint64_t k = 0; k < ensembles; ++k) {
    SimulatedPaths alone = run.paths;
    alone.keep(run.paths.simulated(), [&](std::uint64_t rock) { return rock % ensembles == k; });
    const LineAnswer answer = ask_lines(run.model, basis, alone, std::span(&line, 1)).front();
    shares.push_back(answer.result.whole.share->value);
    if (!answer.result.whole.demand) continue;  // none of its rocks crosses
    energies.push_back(answer.result.whole.demand->maximum_energy);
    heights.push_back(answer.result.whole.demand->height);
  }
  const LineAnswer all = ask_lines(run.model, basis, run.paths, std::span(&line, 1)).front();
  EXPECT_EQ(spread.ensembles, ensembles);
  EXPECT_EQ(spread.crossing, energies.size());
  EXPECT_LT(energies.size(), ensembles) << "an ensemble without crossing rocks has a share, and no energy";
  // With up to twenty values the quantiles 5 and 95 % are between the two least and the two greatest.
  const auto expect_range = [](std::vector<double> values, double of_all, const std::optional<Estimate>& range) {
    std::ranges::sort(values);
    const std::size_t last = values.size() - 1;
    const double part = 0.05 * static_cast<double>(last);
    ASSERT_TRUE(range);
    EXPECT_DOUBLE_EQ(range->value, of_all);
    EXPECT_NEAR(*range->low, values[0] + part * (values[1] - values[0]), 1e-9 * values[last]);
    EXPECT_NEAR(*range->high, values[last] - part * (values[last] - values[last - 1]), 1e-9 * values[last]);
    EXPECT_LT(*range->low, *range->high);
  };
  expect_range(shares, all.result.whole.share->value, spread.share);
  expect_range(energies, all.result.whole.demand->maximum_energy, spread.needed_energy);
  expect_range(heights, all.result.whole.demand->height, spread.needed_height);
}

/// With equal sets only the chance of the rocks is left.
TEST(EnsembleSpread, IsWiderWhereParametersDiffer) {
  const auto width = [](double step) {
    const auto share = spread_at_foot(SimulatedRun(slope_with_ensembles(10, step))).share;
    return *share->high - *share->low;
  };
  EXPECT_GT(width(0.06), 2 * width(0));
}

TEST(EnsembleSpread, IsUnknownOfFewEnsembles) {
  const LineSpread spread = spread_at_foot(SimulatedRun(slope_with_ensembles(4, 0.05)));
  EXPECT_EQ(spread.ensembles, 4u);
  EXPECT_FALSE(spread.share);
  EXPECT_FALSE(spread.needed_energy);
}

TEST(EnsembleSpread, OfAnAreaIsOverTheAnswersOfEachEnsembleAlone) {
  constexpr std::uint64_t ensembles = 8;
  const SimulatedRun run(slope_with_ensembles(ensembles, 0.05));
  Problems warnings;
  constexpr std::array<PlanPlace, 4> corners{{{14, 2}, {60, 2}, {60, 58}, {14, 58}}};
  const AskedArea area = drawn_area(run.model, corners, "polygon", warnings);
  const auto basis = project::design_basis(run.project);
  const auto answer_of = [&](const RockPaths& paths) { return ask_area(run.model, basis, paths, area); };
  const AreaAnswer all = answer_of(run.paths);
  std::vector<double> entering, stopping;
  for (std::uint64_t k = 0; k < ensembles; ++k) {
    SimulatedPaths alone = run.paths;
    alone.keep(run.paths.simulated(), [&](std::uint64_t rock) { return rock % ensembles == k; });
    const AreaAnswer answer = answer_of(alone);
    entering.push_back(static_cast<double>(answer.entering.size()) / static_cast<double>(answer.rocks));
    stopping.push_back(static_cast<double>(answer.stopping().size()) / static_cast<double>(answer.rocks));
  }
  const AreaSpread spread = ensemble_spread(run.model, run.paths.rocks(), all);
  EXPECT_EQ(spread.ensembles, ensembles);
  const auto expect_range = [&](std::vector<double> values, std::size_t of_all, const std::optional<Estimate>& range) {
    std::ranges::sort(values);
    const std::size_t last = values.size() - 1;
    const double part = 0.05 * static_cast<double>(last);
    ASSERT_TRUE(range);
    EXPECT_DOUBLE_EQ(range->value, static_cast<double>(of_all) / static_cast<double>(all.rocks));
    EXPECT_NEAR(*range->low, values[0] + part * (values[1] - values[0]), 1e-12);
    EXPECT_NEAR(*range->high, values[last] - part * (values[last] - values[last - 1]), 1e-12);
    EXPECT_LT(*range->low, *range->high);
  };
  expect_range(entering, all.entering.size(), spread.share);
  expect_range(stopping, all.stopping().size(), spread.stopping);
  const AskedRun asked(run.model, std::make_unique<SimulatedPaths>(run.paths));
  const auto json = asked.area(basis, area, {}).json.at("ensembles");
  for (const char* key : {"share", "stopping", "ke_translational_J", "ke_total_J", "height_m", "velocity_m_s"})
    EXPECT_EQ(json.at(key).size(), 3u) << key;
  EXPECT_FALSE(json.contains("needs_energy_J"));
}

TEST(EnsembleSpread, IsInTheAnswerOfALine) {
  Problems warnings;
  const auto answer_of = [&](const std::string& text) {
    const SimulatedRun run(text);
    const AskedRun asked(run.model, std::make_unique<SimulatedPaths>(run.paths));
    return asked.line(project::design_basis(run.project), drawn_line(run.model, foot, 5, "line", warnings), {}).json;
  };
  const auto json = answer_of(slope_with_ensembles(8, 0.05)).at("ensembles");
  EXPECT_EQ(json["ensembles"], 8);
  EXPECT_EQ(json["confidence"], 0.9);
  for (const char* key : {"share", "ke_translational_J", "ke_total_J", "height_m", "velocity_m_s", "needs_energy_J",
                          "needs_class", "needs_height_m"})
    EXPECT_EQ(json.at(key).size(), 3u) << key;
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(json["needs_class"][k], needed_class({}, json["needs_energy_J"][k].get<double>()));
  EXPECT_TRUE(answer_of(bouncing_slope).at("ensembles").is_null());
}

}  // namespace
}  // namespace talus
