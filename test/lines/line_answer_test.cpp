// Lines that are asked after a run: the figures are those of a collector that was there before it.

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "lines/slopes.hpp"
#include "support/simulated_paths.hpp"
#include "talus/lines/line_answer.hpp"

namespace talus {
namespace {

using testing_tools::replaced;
using testing_tools::SimulatedRun;

constexpr const char* collectors = R"(
[[collector]]
name = "Bench"
line = [[15, 2], [16, 30], [14, 58]]
height_m = 5

[[collector]]
name = "Foot"
line = [[32, 10], [34, 50]]
height_m = 2

[[collector]]
name = "Far"
line = [[52, 0], [50, 60]]
height_m = 3

[design]
section_m = 8
percentiles = [5, 50, 95, 100]
)";

/// Lines as drawn after the run, with the heights of the collectors.
std::vector<AskedLine> drawn_again(const SimulatedRun& with, const Model& model) {
  std::vector<AskedLine> lines;
  Problems warnings;
  for (const project::Barrier& barrier : with.project.barriers) {
    if (barrier.is_collector) lines.push_back(drawn_line(model, barrier.line, barrier.height_m, "line", warnings));
  }
  EXPECT_EQ(warnings.text(), "");
  return lines;
}

/// design.csv of the answers, with the names of the run's lines.
std::string table_of(const DesignPlan& plan, const std::vector<LineAnswer>& answers) {
  DesignResult result;
  for (const LineAnswer& answer : answers) result.lines.push_back(answer.result);
  return design_table(plan, result);
}

std::vector<std::string> cells_of(const std::string& table) {
  std::vector<std::string> cells(1);
  for (const char c : table) {
    if (c == ',' || c == '\n') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// All cells are equal: words, and numbers to within `tolerance` of their size.
void expect_same_table(const std::string& asked, const std::string& run, double tolerance) {
  const auto a = cells_of(asked), b = cells_of(run);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    double x = 0, y = 0;
    const auto is_number = [](const std::string& text, double& value) {
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      return error == std::errc() && end == text.data() + text.size();
    };
    if (is_number(a[k], x) && is_number(b[k], y)) {
      EXPECT_NEAR(x, y, tolerance * (1e-3 + std::abs(y))) << "cell " << k;
    } else {
      EXPECT_EQ(a[k], b[k]) << "cell " << k;
    }
  }
}

/// Runs the project with and without its collectors, and asks the run without for their lines.
void expect_figures_of_collectors(const std::string& ground, const std::string& lines, double tolerance) {
  const SimulatedRun with(ground + lines), without(ground);
  const auto answers =
      ask_lines(without.model, project::design_basis(with.project), without.paths, drawn_again(with, without.model));
  DesignPlan plan = with.plan;
  std::erase_if(plan.lines, [&](const DesignLine& line) { return !with.model.barriers[line.barrier].is_collector; });
  DesignResult design;
  for (std::size_t k = 0; k < with.plan.lines.size(); ++k) {
    if (with.model.barriers[with.plan.lines[k].barrier].is_collector) design.lines.push_back(with.design.lines[k]);
  }
  const std::string asked = table_of(plan, answers), run = design_table(plan, design);
  ASSERT_EQ(answers.size(), design.lines.size());
  for (std::size_t k = 0; k < answers.size(); ++k) {
    EXPECT_GT(answers[k].result.whole.rocks, 20u) << "too few rocks for a test";
    EXPECT_EQ(answers[k].plan.lines.front().length, plan.lines[k].length);
    EXPECT_EQ(answers[k].crossings.size(), design.lines[k].whole.rocks);
  }
  expect_same_table(asked, run, tolerance);
}

// In flight all digits are those of the collector (path_crossings_test.cpp). Along the ground a collector in the way
// cuts glides into other legs, and the last digits differ.
constexpr double by_rounding = 1e-9;

TEST(AskedLine, HasTheFiguresOfACollectorForALumpedMass) {
  expect_figures_of_collectors(bouncing_slope, collectors, by_rounding);
}

/// Without steps a collector in the way changes no trajectory.
TEST(AskedLine, HasAllButTheLastDigitsOfACollectorOnTheGround) {
  expect_figures_of_collectors(
      replaced(bouncing_slope, "model = \"lumped_mass\"", "model = \"lumped_mass\"\nsliding = \"closed_form\""),
      collectors, 1e-14);
}

TEST(AskedLine, HasTheFiguresOfACollectorForASphere) {
  expect_figures_of_collectors(replaced(bouncing_slope, "lumped_mass", "rigid_sphere"), collectors, by_rounding);
}

TEST(AskedLine, HasTheFiguresOfACollectorInAForest) {
  std::string forest =
      replaced(bouncing_slope, "roughness_deg = 12", "roughness_deg = 12\nforest = \"open\"\nforest_height_m = 8");
  forest = replaced(forest, "friction_angle_deg = 34", "friction_angle_deg = 12");
  expect_figures_of_collectors(forest, collectors, by_rounding);
}

TEST(AskedLine, HasTheFiguresOfACollectorBehindABarrier) {
  const std::string net = R"(
[[barrier]]
name = "Net"
line = [[24, 0], [24, 40]]
height_m = 3
capacity_kJ = 120
normal_restitution = 0.3
tangential_restitution = 0.6
)";
  for (const char* model : {"lumped_mass", "rigid_sphere"})
    expect_figures_of_collectors(replaced(bouncing_slope, "lumped_mass", model) + net, collectors, by_rounding);
}

TEST(AskedLine, HasTheFiguresOfACollectorInASection) {
  std::string section = replaced(bouncing_slope, "width_m = 60\n", "");
  section = replaced(section, "type = \"line\"\npoints = [[1, 10], [1, 50]]\nheight_above_m = 1", "position = [1, 0]");
  constexpr const char* at = R"(
[[collector]]
name = "Bench"
line = 15
height_m = 5

[[collector]]
name = "Foot"
line = 33
height_m = 2

[design]
)";
  for (const char* model : {"lumped_mass", "rigid_sphere"})
    expect_figures_of_collectors(replaced(section, "lumped_mass", model), at, by_rounding);
  // Vertices that vary from rock to rock: the line stands on the ground of each.
  const std::string varying =
      replaced(section, "[30, -27], [70, -34]]",
               "[30, -27], [70, -34]]\nsection_std_dev_m = [[0, 0], [0, 0.5], [0, 0.5], [0, 0.5], [0, 0]]");
  expect_figures_of_collectors(varying, at, by_rounding);
}

/// A barrier of the run has the figures of its own design, with the places where spheres touch it.
TEST(AskedLine, OfABarrierHasTheFiguresOfItsDesign) {
  const SimulatedRun run(replaced(bouncing_slope, "lumped_mass", "rigid_sphere") + R"(
[[barrier]]
name = "Net"
line = [[24, 0], [26, 60]]
height_m = 3
inclination_deg = 10
capacity_kJ = 120

[design]
section_m = 8
)");
  const AskedLine net = line_of_barrier(run.model, "Net", "barrier");
  const auto answers = ask_lines(run.model, project::design_basis(run.project), run.paths, std::span(&net, 1));
  EXPECT_GT(answers.front().result.whole.rocks, 100u);
  expect_same_table(table_of(run.plan, answers), design_table(run.plan, run.design), by_rounding);
}

/// With only some of the paths, shares are of those.
TEST(AskedLine, OfASampleHasSharesOfTheSample) {
  SimulatedRun run(bouncing_slope + collectors);
  const auto lines = drawn_again(run, run.model);
  const auto all = ask_lines(run.model, project::design_basis(run.project), run.paths, lines);
  run.paths.keep(400, [](std::uint64_t rock) { return rock % 4 == 1; });
  const auto some = ask_lines(run.model, project::design_basis(run.project), run.paths, lines);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto &whole = all[k].result.whole, &part = some[k].result.whole;
    EXPECT_EQ(some[k].rocks, 100u);
    EXPECT_EQ(part.share->of, 100u);
    EXPECT_LT(part.rocks, whole.rocks);
    EXPECT_GT(part.share->high - part.share->low, whole.share->high - whole.share->low);
    EXPECT_LE(part.share->low, whole.share->value);
    EXPECT_GE(part.share->high, whole.share->value);
    for (const CrossingRock& crossing : some[k].crossings) EXPECT_EQ(crossing.rock % 4, 1u);
  }
}

TEST(AskedLine, JudgesKitsByHeightAndEnergyTogether) {
  const SimulatedRun run(bouncing_slope + collectors);
  const auto answers = ask_lines(run.model, project::design_basis(run.project), run.paths, drawn_again(run, run.model));
  const LineAnswer& answer = answers.front();
  const DesignPlan& plan = answer.plan;
  for (std::size_t h = 0; h < plan.heights.size(); ++h) {
    for (std::size_t e = 0; e < plan.energies.size(); ++e) {
      const KitAnswer kit = judge_kit(answer, plan.heights[h], plan.energies[e]);
      EXPECT_EQ(kit.stopped->rocks, answer.demands.caught(h, e));
      EXPECT_EQ(kit.above, answer.demands.above(h));
      EXPECT_EQ(kit.stopped->rocks + kit.above + kit.through, answer.crossings.size());
    }
  }
}

TEST(AskedLine, IsWorstWhereItAsksForTheMostEnergy) {
  const SimulatedRun run(bouncing_slope + collectors);
  const auto answers = ask_lines(run.model, project::design_basis(run.project), run.paths, drawn_again(run, run.model));
  for (const LineAnswer& answer : answers) {
    const auto worst = answer.worst_section();
    ASSERT_TRUE(worst);
    for (const DesignFigures& section : answer.result.sections) {
      if (!section.demand) continue;
      EXPECT_LE(section.demand->maximum_energy, answer.result.sections[*worst].demand->maximum_energy);
    }
    const auto maxima = answer.maxima();
    double most = 0;
    for (const CrossingRock& crossing : answer.crossings)
      most = std::max(most, crossing.at.of(CrossingQuantity::velocity));
    EXPECT_EQ((*maxima)[static_cast<std::size_t>(CrossingQuantity::velocity)], most);
  }
}

/// Both ways are one path past one fence, further up or down.
TEST(AskedLine, MayCrossItselfAndBeLong) {
  const SimulatedRun run(bouncing_slope);
  Problems warnings;
  const AskedLine line =
      drawn_line(run.model, std::vector<PlanPlace>{{15, 2}, {25, 58}, {15, 58}, {25, 2}}, 5, "line", warnings);
  const auto answers = ask_lines(run.model, project::design_basis(run.project), run.paths, std::span(&line, 1));
  EXPECT_GT(answers.front().crossings.size(), 100u);
  // Each rock counts once.
  for (std::size_t k = 1; k < answers.front().crossings.size(); ++k)
    EXPECT_LT(answers.front().crossings[k - 1].rock, answers.front().crossings[k].rock);
}

std::string line_refusal(const Model& model, const std::vector<PlanPlace>& line) {
  Problems warnings;
  try {
    static_cast<void>(drawn_line(model, line, 5, "line", warnings));
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return warnings.text();
}

TEST(AskedLine, IsRefusedWithTheReason) {
  const Model model = testing_tools::model_of(bouncing_slope);
  EXPECT_EQ(line_refusal(model, {}), "line: has 0 points (expected at least 2, from one end to the other)");
  EXPECT_EQ(line_refusal(model, {{3, 4}}), "line: has 1 point (expected at least 2, from one end to the other)");
  EXPECT_EQ(line_refusal(model, {{3, NAN}, {1e12, 4}, {5, 6}}),
            "line: point 1 is (3, nan) (expected numbers)\n"
            "line: point 2 is (1e+12, 4) (coordinates are in metres, up to 1e+09)");
  EXPECT_EQ(line_refusal(model, {{3, 4}, {3, 4}}), "line: is 0 m long (expected at least 1e-05 m)");
  EXPECT_EQ(line_refusal(model, {{2600000, 1200000}, {2600050, 1200000}}),
            "line: does not touch the terrain (rocks are only known there). Give it in the coordinates of the project");
  EXPECT_EQ(line_refusal(model, {{30, 65}, {50, 65}}),
            "line: does not touch the terrain (rocks are only known there). With x and y swapped it would lie on the "
            "terrain");
  EXPECT_EQ(line_refusal(model, {{30, 50}, {30, 70}}),
            "warning: line: 10 of 20 m are off the terrain (its ends are cut there, and it crosses a gap in a straight "
            "line)");
  Problems none;
  EXPECT_THROW(static_cast<void>(line_of_barrier(model, "Net", "barrier")), BadInput);
}

}  // namespace
}  // namespace talus
