// Rocks that pass beyond the ends of an asked line.

#include "talus/lines/beyond_ends.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include "lines/slopes.hpp"
#include "support/simulated_paths.hpp"
#include "talus/lines/asked_run.hpp"

namespace talus {
namespace {

using testing_tools::SimulatedRun;
using Beyond = std::optional<std::array<std::uint64_t, 2>>;

class BeyondEnds : public testing::Test {
 protected:
  /// The slope falls along x and is 60 m wide; in stretches of 5 m.
  SimulatedRun run_{bouncing_slope};
  project::DesignBasis basis_ = [this] {
    auto basis = project::design_basis(run_.project);
    basis.design.section_m = 5;
    return basis;
  }();

  AskedLine line(const std::vector<PlanPlace>& places) const {
    Problems warnings;
    return drawn_line(run_.model, places, asked_height, "line", warnings);
  }
  LineAnswer answer_of(const AskedLine& asked) const {
    return ask_lines(run_.model, basis_, run_.paths, std::span(&asked, 1)).front();
  }
  Beyond beyond(const std::vector<PlanPlace>& places) const {
    const AskedLine asked = line(places);
    return rocks_beyond_ends(run_.model, basis_, run_.paths, asked, answer_of(asked));
  }
};

TEST_F(BeyondEnds, AreThoseThatCrossItsContinuation) {
  // Rocks cross x = 40 once: beyond a part of it pass those that cross the stretches beside.
  const LineAnswer whole = answer_of(line({{40, 0}, {40, 60}}));
  const auto rocks_from = [&](std::size_t first, std::size_t last) {
    std::uint64_t rocks = 0;
    for (std::size_t k = first; k <= last; ++k) rocks += whole.result.sections[k].rocks;
    return rocks;
  };
  ASSERT_GT(std::min(rocks_from(1, 3), rocks_from(7, 9)), 20u);
  EXPECT_EQ(beyond({{40, 20}, {40, 35}}), (std::array{rocks_from(1, 3), rocks_from(7, 9)}));
  EXPECT_EQ(beyond({{40, 35}, {40, 20}}), (std::array{rocks_from(7, 9), rocks_from(1, 3)}));
  // The last corner of a line drawn by hand does not turn it.
  EXPECT_EQ(beyond({{40, 20}, {40, 34.5}, {40.2, 35}})->at(0), rocks_from(1, 3));
  // A continuation ends with the terrain.
  EXPECT_EQ(beyond({{40, 0}, {40, 20}}), (std::array{std::uint64_t{0}, rocks_from(4, 7)}));
  EXPECT_EQ(beyond({{40, 0}, {40, 60}}), (std::array<std::uint64_t, 2>{}));
}

TEST_F(BeyondEnds, AreUnknownAroundAPlaceAndInASection) {
  EXPECT_EQ(beyond({{40, 20}, {45, 25}, {40, 30}, {35, 25}, {40, 20}}), Beyond());
  const SimulatedRun section(vertical_face);
  Problems warnings;
  const AskedLine place = drawn_line(section.model, std::vector<PlanPlace>{{15, 0}}, asked_height, "line", warnings);
  const auto basis = project::design_basis(section.project);
  const auto answer = ask_lines(section.model, basis, section.paths, std::span(&place, 1)).front();
  EXPECT_EQ(rocks_beyond_ends(section.model, basis, section.paths, place, answer), Beyond());
}

TEST_F(BeyondEnds, AreWarnedOfIfTheyMatter) {
  const AskedRun asked(run_.model, std::make_unique<testing_tools::SimulatedPaths>(run_.paths));
  const RunAnswer part = asked.line(basis_, line({{40, 20}, {40, 35}}), {});
  const auto counts = part.json.at("beyond_ends").get<std::array<std::uint64_t, 2>>();
  ASSERT_EQ(part.warnings.list().back().kind, ProblemKind::beyond_ends);
  EXPECT_EQ(part.warnings.list().back().what,
            std::to_string(counts[0] + counts[1]) + " of 400 rocks pass beyond its ends, " + std::to_string(counts[0]) +
                " beyond the first point and " + std::to_string(counts[1]) + " beyond the last");
  for (const Problem& problem : asked.line(basis_, line({{40, 0}, {40, 60}}), {}).warnings.list())
    EXPECT_NE(problem.kind, ProblemKind::beyond_ends);
}

}  // namespace
}  // namespace talus
