// The fingerprint of a campaign changes with every number that affects trajectories, in the project or its files.

#include "talus/model/fingerprint.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "cli/program.hpp"
#include "talus/model/model.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using test::Workplace;

struct Fingerprints {
  std::string inputs, sample;
};

Fingerprints fingerprints_of(const std::filesystem::path& file, const std::vector<std::string>& settings = {}) {
  Problems warnings;
  const Project project = read_project(file, {settings, {}, {}}).project;
  const Model model = build_model(project, warnings);
  return {fingerprint_of(echo(project), model), sample_of(model)};
}

const std::string mesh_project = R"(
[terrain]
mesh = "slope.obj"
[[material]]
name = "Rock"
[[seeder]]
type = "line"
points = [[2, 2, 30], [8, 2, 30]]
rocks = 100
mass_kg = 100
[output]
maps = false
)";
std::string slope(const char* height) {
  return std::string("v 0 0 0\nv 10 0 0\nv 10 10 ") + height + "\nv 0 10 8\nf 1 2 3\nf 1 3 4\n";
}

TEST(Fingerprint, IsTheSameForTheSameProject) {
  const Fingerprints once = fingerprints_of(test::tutorial("3d")), again = fingerprints_of(test::tutorial("3d"));
  EXPECT_EQ(once.inputs, again.inputs);
  EXPECT_EQ(once.sample, again.sample);
  EXPECT_EQ(once.inputs.size(), 32U);
  EXPECT_EQ(once.inputs.find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(Fingerprint, ChangesWithEverySetting) {
  std::set<std::string> seen;
  const std::vector<std::string> changes{"",
                                         "sampling.seed=2",
                                         "analysis.gravity_m_s2=9.80666",
                                         "name=Other",
                                         "output.paths=7",
                                         "seeder.0.rocks=51",
                                         "seeder.0.mass_kg=1001",
                                         "collector.0.height_m=3.6"};
  for (const std::string& change : changes) {
    const auto settings = change.empty() ? std::vector<std::string>() : std::vector{change};
    seen.insert(fingerprints_of(test::tutorial("3d"), settings).inputs);
  }
  EXPECT_EQ(seen.size(), changes.size());
}

// The text of the project is the same, but the file that it names changes.
TEST(Fingerprint, ChangesWithTheContentsOfFiles) {
  const Workplace work;
  const std::string project = work.write("slope.toml", mesh_project);
  work.write("slope.obj", slope("5"));
  const Fingerprints before = fingerprints_of(project);
  work.write("slope.obj", slope("5.000001"));
  const Fingerprints after = fingerprints_of(project);
  EXPECT_NE(before.inputs, after.inputs);
  EXPECT_NE(before.sample, after.sample);
  work.write("slope.obj", "# the same slope\n" + slope("5"));
  EXPECT_EQ(fingerprints_of(project).inputs, before.inputs);
}

TEST(Fingerprint, DoesNotDependOnTheFolderOfTheProject) {
  const Workplace one, other;
  for (const Workplace* work : {&one, &other}) {
    work->write("slope.toml", mesh_project);
    work->write("slope.obj", slope("5"));
  }
  EXPECT_EQ(fingerprints_of(one / "slope.toml").inputs, fingerprints_of(other / "slope.toml").inputs);
}

}  // namespace
}  // namespace talus::project
