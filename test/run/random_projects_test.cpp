// For any project: it is refused or runs to its end, in a section nothing leaves the plane, energy never rises, rocks
// are not lost, and tables have numbers only.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "support/random_projects.hpp"
#include "support/scenes.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"
#include "talus/run/run.hpp"

namespace talus {
namespace {

using testing_tools::RandomProject;
using testing_tools::rows_up_to;
using testing_tools::total_energy;

bool is_in_plane(const Motion& motion) {
  return motion.position.y() == 0 && motion.velocity.y() == 0 && motion.spin.x() == 0 && motion.spin.z() == 0;
}

/// What is wrong with a rock's path; empty if nothing is.
std::string what_is_wrong(const Model& model, const RockRecord& record, const RockLog& log) {
  const Rock& body = record.body;
  const Vec3& gravity = model.laws.gravity;
  const auto& rows = log.rows;
  const Box bounds = std::visit([](const auto& surface) { return surface.bounds(); }, *model.surface);
  const double weight = body.mass * gravity.norm();
  double highest = bounds.high.z();
  for (const PathRow& row : rows) highest = std::max(highest, row.motion.position.z());
  const double size = highest - bounds.low.z() + (bounds.high - bounds.low).norm();
  // A step with drag may be this far from the exact one.
  const bool has_drag = std::ranges::any_of(model.ground.materials(), [](const Material& material) {
    return material.ground_drag > 0 || material.has_forest();
  });
  const double unseen = has_drag ? tolerance::unseen_way : 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Motion& motion = rows[k].motion;
    const testing_tools::Followed so_far{record.outcome, log};
    if (!testing_tools::is_finite(motion)) return "not finite" + rows_up_to(so_far, k);
    if (model.laws.in_section && !is_in_plane(motion)) return "off the plane" + rows_up_to(so_far, k);
    if (k == 0) continue;
    if (motion.time < rows[k - 1].motion.time) return "time runs backwards" + rows_up_to(so_far, k);
    const double before = total_energy(rows[k - 1].motion, body, gravity), after = total_energy(motion, body, gravity);
    // As RandomRocks: rounding, and the thickness within which a rock is on the ground, for each leg of a row.
    const double scale = testing_tools::kinetic_energy(motion, body) + weight * size;
    if (after > before + 1e-10 * scale + (64 * contact_slack + unseen) * weight)
      return fmt::format("gains {:.3g} of {:.3g} J", after - before, scale) + rows_up_to(so_far, k);
  }
  return "";
}

/// The name of a table with something other than numbers; empty if there is none.
std::string table_without_numbers(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    const std::string text = test::bytes_of(entry.path());
    for (const char* word : {"nan", "inf"}) {
      for (const char* before : {",", ",-"}) {
        if (text.find(std::string(before) + word) != std::string::npos) return entry.path().filename().string();
      }
    }
  }
  return "";
}

/// Up to one rock in this many may fall through the surface.
constexpr std::uint64_t rocks_of_one_lost = 20'000;

TEST(RandomProjects, AreRefusedOrRunToTheirEnds) {
  const char* const wish = std::getenv("TALUS_TEST_EFFORT");
  const int projects = 40 * (wish == nullptr ? 1 : std::max(1, std::atoi(wish)));
  const test::Workplace work;
  int refused = 0, wrong = 0;
  std::uint64_t rocks = 0, lost = 0;
  for (int number = 0; number < projects && wrong < 3; ++number) {
    const RandomProject project(static_cast<std::uint64_t>(number));
    SCOPED_TRACE("project " + std::to_string(number));
    Problems warnings;
    std::optional<project::Reading> reading;
    std::optional<Model> model;
    try {
      reading = project::read_project_text(project.text(), work / "random.toml");
      model = project::build_model(reading->project, warnings);
    } catch (const BadInput& bad) {
      ++refused;
      EXPECT_FALSE(bad.problems().text().empty());
      continue;
    }
    Simulator simulator(*model);
    for (std::uint64_t rock = 0; rock < model->rocks(); ++rock) {
      const RockRecord record = simulator.simulate(rock, true);
      ++rocks;
      if (record.outcome.reason == EndReason::lost) ++lost;
      const std::string what = what_is_wrong(*model, record, simulator.log());
      if (what.empty()) continue;
      ADD_FAILURE() << "rock " << rock << ": " << what << project.text();
      ++wrong;
      break;
    }
    const std::filesystem::path folder = work / "run";
    (void)project::run_into(folder, reading->project, *model, warnings, {.campaign = {1, nullptr, {}}});
    EXPECT_EQ(table_without_numbers(folder), "");
    std::filesystem::remove_all(folder);
  }
  RecordProperty("rocks", std::to_string(rocks));
  RecordProperty("lost", std::to_string(lost));
  EXPECT_LE(lost, 1 + rocks / rocks_of_one_lost);
  EXPECT_LT(refused, projects / 5);
}

}  // namespace
}  // namespace talus
