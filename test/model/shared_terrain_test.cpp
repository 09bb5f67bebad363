// Several models on one terrain.

#include <gtest/gtest.h>

#include <string>

#include "talus/model/fingerprint.hpp"
#include "talus/model/model.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/parameter.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

const std::string shared_slope = R"(
[terrain]
section = [[0, 0], [10, -10], [20, -10]]
[[material]]
name = "Rock"
[[seeder]]
name = "Crest"
type = "point"
position = [1, 5]
mass_kg = 100
[[barrier]]
line = 15
height_m = 2
)";

Project with(const std::string& setting) {
  return read_project_text(shared_slope, "slope.toml", {.settings = {setting}}).project;
}

std::string fingerprint(const Project& project, const Model& model) { return fingerprint_of(echo(project), model); }

TEST(SharedTerrain, IsThatOfAllModels) {
  Problems warnings;
  const Project first = read_project_text(shared_slope, "slope.toml").project, other = with("seeder.Crest.position=[2, 5]");
  const BuiltTerrain terrain = read_terrain(first, warnings);
  const Model here = build_model(first, terrain, warnings), there = build_model(other, terrain, warnings);
  EXPECT_EQ(&*here.surface, &*there.surface);
  EXPECT_EQ(fingerprint(first, here), fingerprint(first, build_model(first, warnings)));
  EXPECT_EQ(fingerprint(other, there), fingerprint(other, build_model(other, warnings)));
  EXPECT_NE(fingerprint(first, here), fingerprint(other, there));
}

// A copy that gets these settings is the model that would be built with them.
TEST(SharedTerrain, IsKeptForSettingsOfNumbers) {
  Problems warnings;
  const Model model = build_model(read_project_text(shared_slope, "slope.toml").project, warnings);
  for (const std::string setting : {"material.Rock.roughness_deg=3", "analysis.model=rigid_sphere",
                                    "seeder.Crest.mass_kg=200", "barrier.0.capacity_kJ=50", "output.maps=false"}) {
    EXPECT_TRUE(needs_no_terrain(setting.substr(0, setting.find('='))));
    const Project changed = with(setting);
    Model copy = model;
    set_properties(changed, copy);
    const Model fresh = build_model(changed, warnings);
    EXPECT_EQ(&*copy.surface, &*model.surface);
    EXPECT_EQ(fingerprint(changed, copy), fingerprint(changed, fresh)) << setting;
    EXPECT_EQ(sample_of(copy), sample_of(fresh)) << setting;
  }
}

TEST(SharedTerrain, IsNotKeptForPlaces) {
  for (const char* path : {"terrain.section", "seeder.Crest.position", "seeder.Crest.rocks", "barrier.0.line",
                           "material", "barrier.0.height_m", "material.Rock.name", "analysis.energy_datum_m",
                           "output.runout_from", "sampling.seed", "material.Rock.hardness", "name", "", "seeder.Crest"})
    EXPECT_FALSE(needs_no_terrain(path)) << path;
}

}  // namespace
}  // namespace talus::project
