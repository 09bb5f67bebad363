// Parameters by their path, and sites that are built once and run with many sets of them.

#include "talus/study/prepared_site.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/projects.hpp"
#include "talus/campaign/simulate.hpp"

namespace talus::study {
namespace {

using testing_tools::replaced;

const std::string slope = R"(
[terrain]
section = [[0, 0], [10, -10], [100, -10]]
[[material]]
name = "Scree"
normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 0.04 }
tangential_restitution = { mean = 0.8, distribution = "normal", std_dev = 0.04 }
friction_angle_deg = 30
[[material]]
name = "Meadow 1.5"
[ground]
segments = ["Scree", "Meadow 1.5"]
[[seeder]]
type = "point"
position = [1, 5]
mass_kg = 100
rocks = 20
[[collector]]
line = 8
height_m = 10
)";

project::Project project_of(const std::string& text) { return project::read_project_text(text, "slope.toml").project; }

PreparedSite site_of(const std::string& text) {
  Problems warnings;
  return {project_of(text), warnings};
}

project::SettingNumber number_of(const project::Project& project, const std::string& path) {
  Problems problems;
  auto number = project::SettingNumber::find(project, path, {}, problems);
  EXPECT_EQ(problems.text(), "");
  return *number;
}

std::string refusal_of(const std::string& path, const std::string& text = slope) {
  Problems problems;
  static_cast<void>(
      project::SettingNumber::find(project_of(text), path, Problem{.file = "study.toml", .line = 3}, problems));
  return problems.text();
}

TEST(SettingNumber, IsTheMeanOfADistribution) {
  project::Project project = project_of(slope);
  const project::SettingNumber number = number_of(project, "material.Scree.normal_restitution");
  EXPECT_EQ(number.value_in(project), 0.4);
  EXPECT_EQ(number.range().most, 1);
  EXPECT_EQ(number.set(project, 0.5), std::nullopt);
  EXPECT_EQ(project.materials[0].normal_restitution.mean, 0.5);
  EXPECT_EQ(project.materials[0].normal_restitution.std_dev, 0.04);
}

TEST(SettingNumber, IsAPartOfADistributionOrAPlainNumber) {
  project::Project project = project_of(slope);
  EXPECT_EQ(number_of(project, "material.0.normal_restitution.std_dev").set(project, 0.1), std::nullopt);
  EXPECT_EQ(project.materials[0].normal_restitution.std_dev, 0.1);
  EXPECT_EQ(number_of(project, "analysis.grazing_angle_deg").set(project, 5), std::nullopt);
  EXPECT_EQ(project.analysis.grazing_angle_deg, 5);
  EXPECT_EQ(number_of(project, "material.\"Meadow 1.5\".friction_angle_deg").set(project, 35), std::nullopt);
  EXPECT_EQ(project.materials[1].friction_angle_deg.mean, 35);
}

TEST(SettingNumber, OfAllEntriesIsShared) {
  project::Project project = project_of(slope);
  EXPECT_EQ(number_of(project, "material.*.roughness_deg").set(project, 7), std::nullopt);
  EXPECT_EQ(project.materials[0].roughness_deg.mean, 7);
  EXPECT_EQ(project.materials[1].roughness_deg.mean, 7);
}

TEST(SettingNumber, RefusesWhatCannotBeVaried) {
  EXPECT_EQ(refusal_of("material.Scre.normal_restitution"),
            "study.toml:3: \"material.Scre.normal_restitution\" names no [[material]] (the project has \"Scree\", "
            "\"Meadow 1.5\"). Use a name, a number from 0, or * for all");
  EXPECT_EQ(refusal_of("material.Scree.normal_restitutoin"),
            "study.toml:3: \"material.Scree.normal_restitutoin\" is no setting ([[material]] has no key "
            "normal_restitutoin). Did you mean normal_restitution?");
  EXPECT_EQ(refusal_of("terrain.width_m"),
            "study.toml:3: \"terrain.width_m\" cannot be varied (a study varies numbers of [[material]], "
            "[[forest]] and [analysis], sizes and velocities of [[seeder]], b_over_a and c_over_b of [[shape]], and "
            "capacity_kJ of [[barrier]])");
  EXPECT_EQ(refusal_of("analysis.max_steps"),
            "study.toml:3: \"analysis.max_steps\" cannot be varied (a study varies numbers of [[material]], "
            "[[forest]] and [analysis], sizes and velocities of [[seeder]], b_over_a and c_over_b of [[shape]], and "
            "capacity_kJ of [[barrier]])");
  EXPECT_EQ(refusal_of("seeder.0.volume_m3"),
            "study.toml:3: \"seeder.0.volume_m3\" is not given in the project (a study varies numbers that are). Give "
            "it a value there");
  EXPECT_EQ(
      refusal_of("seeder.0.mass_kg", replaced(slope, "mass_kg = 100", "volume_m3 = 1")),
      "study.toml:3: \"seeder.0.mass_kg\" is not given in the project (a study varies numbers that are). Give it a "
      "value there");
  EXPECT_EQ(refusal_of("material.Scree.friction_angle_deg.std_dev"),
            "study.toml:3: \"material.Scree.friction_angle_deg.std_dev\" has no effect (the property is a plain number "
            "in the project). Give it a distribution there");
  EXPECT_EQ(refusal_of("material.Scree.rolling_friction"),
            "study.toml:3: warning: \"material.Scree.rolling_friction\" has no effect (analysis.model is "
            "\"lumped_mass\")");
}

TEST(SettingNumber, DoesNotTakeAValueOutsideTheSettingsRange) {
  project::Project project = project_of(slope);
  EXPECT_EQ(number_of(project, "material.0.normal_restitution").set(project, 1.2),
            "material.0.normal_restitution is 1.2; expected 0 to 1");
  EXPECT_EQ(project.materials[0].normal_restitution.mean, 0.4);
}

TEST(Prior, InvertsItsDistributionFunction) {
  const project::Prior flat = project::Prior::uniform(0.2, 0.6);
  EXPECT_NEAR(flat.value(0.25), 0.3, 1e-12);
  EXPECT_NEAR(flat.share_below(0.5), 0.75, 1e-9);
  const project::Prior bell({0.4, DistributionKind::normal, 0.1, {}, {}}, {0, 1});
  EXPECT_NEAR(bell.value(0.5), 0.4, 1e-4);
  EXPECT_NEAR(bell.share_below(bell.value(0.9)), 0.9, 1e-9);
}

TEST(PreparedSite, GivesTheRocksOfARunOfTheSameProject) {
  const PreparedSite site = site_of(slope);
  const std::vector numbers{number_of(site.project(), "material.Scree.normal_restitution"),
                            number_of(site.project(), "seeder.0.mass_kg"),
                            number_of(site.project(), "analysis.gravity_m_s2")};
  const SetOutcome outcome = site.run(numbers, {0.3, 250, 9});
  project::Project project = project_of(slope);
  project.materials[0].normal_restitution.mean = 0.3;
  project.seeders[0].size->distribution.mean = 250;
  project.analysis.gravity_m_s2 = 9;
  Problems warnings;
  const Model model = project::build_model(project, warnings);
  Simulator simulator(model);
  ASSERT_EQ(outcome.ends.size(), 20U);
  for (std::uint64_t rock = 0; rock < 20; ++rock) {
    const RockRecord record = simulator.simulate(rock, false);
    EXPECT_EQ(outcome.ends[rock].end, model.frame.global_from_local(record.outcome.end.position));
    EXPECT_EQ(outcome.ends[rock].mass, 250);
  }
  EXPECT_GT(outcome.crossings.size(), 0U);
}

// The ratios of blocks and of sections, of a shape and of one in a group.
TEST(PreparedSite, VariesTheShapesOfRocks) {
  const std::string bodies = "[analysis]\nmodel = \"rigid_body\"\n" +
                             replaced(slope, "mass_kg = 100", "mass_kg = 100\nshape = \"Mixed\"") +
                             "[[shape]]\nname = \"Mixed\"\nof = [\"Slab\", \"square\"]\n"
                             "[[shape]]\nname = \"Slab\"\nb_over_a = 0.9\n";
  std::string in_3d = bodies;
  for (const auto& [in_section, on_terrain] :
       {std::pair("100, -10]]", "100, -10]]\nwidth_m = 20"), std::pair("= 0.9\n", "= 0.9\nc_over_b = 0.8\n"),
        std::pair("position = [1, 5]", "position = [1, 10, 5]"), std::pair("line = 8", "line = [[8, 0], [8, 20]]"),
        std::pair("\"square\"", "\"cube\"")})
    in_3d = replaced(in_3d, in_section, on_terrain);
  for (const std::string& text : {bodies, in_3d}) {
    const PreparedSite site = site_of(text);
    const SetOutcome outcome = site.run(std::vector{number_of(site.project(), "shape.Slab.b_over_a")}, {0.5});
    project::Project project = project_of(text);
    project.shapes[1].b_over_a->mean = 0.5;
    Problems warnings;
    const Model model = project::build_model(project, warnings);
    Simulator simulator(model);
    ASSERT_EQ(outcome.ends.size(), 20U);
    int slabs = 0;
    for (std::uint64_t rock = 0; rock < 20; ++rock) {
      const RockRecord record = simulator.simulate(rock, false);
      EXPECT_EQ(outcome.ends[rock].end, model.frame.global_from_local(record.outcome.end.position));
      slabs += record.block->axes.y() / record.block->axes.x() < 0.7 ? 1 : 0;  // with b/a near 0.5
    }
    EXPECT_GT(slabs, 3);
  }
}

TEST(PreparedSite, GivesTheSameBitsOnAnyNumberOfThreads) {
  const PreparedSite site = site_of(slope);
  const std::vector numbers{number_of(site.project(), "material.Scree.normal_restitution")};
  std::vector<ParameterSet> sets;
  for (int k = 0; k < 40; ++k) sets.push_back({0.01 * k});
  const auto ends_on = [&](int threads) {
    std::vector<double> ends(sets.size());
    site.run(numbers, sets, {.threads = threads, .keep_marks = true}, [&](std::size_t k, SetOutcome&& outcome) {
      for (const RockEnd& end : outcome.ends) ends[k] += end.end.x();
      ends[k] += static_cast<double>(outcome.marks.size());
    });
    return ends;
  };
  const std::vector<double> one = ends_on(1);
  EXPECT_EQ(one, ends_on(4));
  EXPECT_NE(one.front(), one.back());
}

TEST(PreparedSite, RefusesValuesThatLeaveNothingOfADistribution) {
  const PreparedSite site =
      site_of(replaced(slope, "std_dev = 0.04 }", "std_dev = 0.04, rel_min = 0.1, rel_max = 0.1 }"));
  const std::vector numbers{number_of(site.project(), "material.Scree.normal_restitution.std_dev")};
  EXPECT_THROW(static_cast<void>(site.with(numbers, {-1})), BadInput);
}

}  // namespace
}  // namespace talus::study
