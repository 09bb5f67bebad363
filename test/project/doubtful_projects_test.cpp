// Projects that are read with a warning: the exact text of each warning.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "project/bad_project.hpp"

namespace talus::project {
namespace {

class DoubtfulProjects : public BadProjectTest {};

TEST_P(DoubtfulProjects, AreReadWithThisWarning) {
  const Reading reading = read_project_text(changed(GetParam().replacements), "slope.toml");
  EXPECT_EQ(reading.warnings.text(), GetParam().message);
}

const std::vector<BadProject> doubtful_projects{
    {"IdenticalRocks",
     {{"rocks = 10", "rocks = 500"}},
     "slope.toml:24: warning: seeder \"Crest\": its 500 rocks are identical (nothing about them or the ground is "
     "random, so they all follow one path). Give restitution or friction a distribution, or the ground a roughness"},
    {"RocksOfDifferentMass",
     {{"rocks = 10", "rocks = 500"},
      {"mass_kg = 1000", "mass_kg = { mean = 1000, std_dev = 100, distribution = \"normal\" }"}},
     ""},
    {"RocksOnRoughGround",
     {{"rocks = 10", "rocks = 500"}, {"name = \"Talus\"", "name = \"Talus\"\nroughness_deg = 3"}},
     ""},
    {"GeoPackageOfASection",
     {{"[terrain]",
       R"([output]
geopackage = 500

[terrain])"}},
     "slope.toml:7: warning: [output]: geopackage has no effect (a section has no position on a map). Give "
     "terrain.width_m for 3D"},
    {"MapsBySourceOfASection",
     {{"[terrain]",
       R"([output]
maps_by_source = true

[terrain])"}},
     "slope.toml:7: warning: [output]: maps_by_source has no effect (a section has no area to map). Give "
     "terrain.width_m for 3D"},
    {"MapsBySourceWithoutMaps",
     {{section, "section = [[0, 0], [10, -10], [20, -10]]\nwidth_m = 20"},
      {"position = [1, 5]", "position = [1, 10, 5]"},
      {"line = 15", "line = [[15, 0], [15, 20]]"},
      {"[terrain]",
       R"([output]
maps = false
maps_by_source = true

[terrain])"}},
     "slope.toml:8: warning: [output]: maps_by_source has no effect (maps is false). Set maps = true"},
    {"PercentilesOfCounts",
     {{"[terrain]",
       R"([output]
maps = ["passages", "reach_share"]
percentiles = [95]

[terrain])"}},
     "slope.toml:8: warning: [output]: percentiles has no effect (maps lists only counts). Add a quantity, such as "
     "\"energy_total\""},
    {"BandsOfAMapThatIsNotListed",
     {{"[terrain]",
       R"([sampling]
parameters = "posterior.csv"
ensembles = 2

[output]
maps = ["velocity"]
bands = ["velocity", "energy_total"]

[terrain])"}},
     "slope.toml:12: warning: [output]: bands: \"energy_total\" has no effect (maps does not list it). Add it there"},
    {"VtkWithoutPaths",
     {{"[terrain]",
       R"([output]
paths = "none"
vtk = true

[terrain])"}},
     "slope.toml:8: warning: [output]: vtk has no effect (paths is \"none\"). Set paths to a number of rocks"},
    {"FrictionAngleInRadians",
     {{"friction_angle_deg = 30", "friction_angle_deg = 0.5236"}},
     "slope.toml:12: warning: material \"Rock\": friction_angle_deg is 0.5236 (angles are in degrees, and this ground "
     "would be almost frictionless). If it is in radians, write 30"},
    {"DiameterTooLarge",
     {{"mass_kg = 1000", "diameter_m = 60"}},
     "slope.toml:25: warning: seeder \"Crest\": diameter_m is 60 (this is larger than any rockfall block; rock masses "
     "of this size move as rock avalanches). diameter_m is in metres"},
    {"VolumeTooLarge",
     {{"mass_kg = 1000", "volume_m3 = 9000"}},
     "slope.toml:25: warning: seeder \"Crest\": volume_m3 is 9000 (this is larger than any rockfall block; rock masses "
     "of this size move as rock avalanches). volume_m3 is in cubic metres"},
    {"MassTooLarge",
     {{"mass_kg = 1000", "mass_kg = 1e11"}},
     "slope.toml:25: warning: seeder \"Crest\": mass_kg is 100000000000 (this is larger than any rockfall block; rock "
     "masses of this size move as rock avalanches). mass_kg is in kilograms"},
    {"BarrierTooHigh",
     {{"height_m = 3", "height_m = 4000"}},
     "slope.toml:30: warning: barrier \"Fence\": height_m is 4000 (no barrier of this height has been built). To "
     "record rocks without stopping them, use a [[collector]]"},
    {"ReleaseHighAboveTheGround",
     {{"position = [1, 5]", "position = [1]\nheight_above_m = 2000"}},
     "slope.toml:24: warning: seeder \"Crest\": height_above_m is 2000 (rocks would start far above the ground). It is "
     "a height above the ground, not an elevation"},
    {"StandardDeviationTooLargeForARestitution",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 10 })"}},
     "slope.toml:11: warning: material \"Rock\": normal_restitution has a std_dev of 10, but its limits cut off most "
     "of the distribution (only 4 % of the normal distribution lies between 0 and 1: draws are almost uniform there, "
     "with mean 0.4999). Give a smaller std_dev, or distribution = \"uniform\""},
    // A triangle with mean 1000 would have its mode at 600, below its lower limit: with the mode there its mean is
    // (900 + 900 + 1500) / 3.
    {"TriangularWithAsymmetricLimits",
     {{"mass_kg = 1000", R"(mass_kg = { mean = 1000, distribution = "triangular", rel_min = 100, rel_max = 500 })"}},
     "slope.toml:25: warning: seeder \"Crest\": mass_kg has the mean 1000, but its draws have the mean 1100 (they lie "
     "between 900 and 1500, not symmetrically about the mean). Give limits that are symmetric about the mean, or the "
     "mean that the draws should have"},
    {"UniformWithAsymmetricLimits",
     {{"mass_kg = 1000", R"(mass_kg = { mean = 1000, distribution = "uniform", rel_min = 100, rel_max = 500 })"}},
     "slope.toml:25: warning: seeder \"Crest\": mass_kg has the mean 1000, but its draws have the mean 1200 (they lie "
     "between 900 and 1500, not symmetrically about the mean). Give limits that are symmetric about the mean, or the "
     "mean that the draws should have"},
    {"NormalTruncatedOnOneSide",
     {{"mass_kg = 1000", R"(mass_kg = { mean = 1000, distribution = "normal", std_dev = 300, rel_min = 0 })"}},
     // sqrt(2/pi) standard deviations above the mean: 1239.4
     "slope.toml:25: warning: seeder \"Crest\": mass_kg has the mean 1000, but its draws have the mean 1239 (they lie "
     "between 1000 and 3139, not symmetrically about the mean). Give limits that are symmetric about the mean, or the "
     "mean that the draws should have"},
    {"RoughnessOfBothSigns",
     {{"name = \"Rock\"",
       "name = \"Rock\"\nroughness_deg = { mean = 0, distribution = \"uniform\", rel_min = 11, rel_max = 11 }"}},
     ""},
    {"MassInTonnes",
     {{"mass_kg = 1000", "mass_kg = 1"}},
     "slope.toml:25: warning: seeder \"Crest\": mass_kg is 1 (masses are in kilograms, and this stone would fit in a "
     "hand). If it is in tonnes, write 1000"},
    {"SphereWithoutRollingFriction",
     {{"[analysis]", "[analysis]\nmodel = \"rigid_sphere\""},
      {"name = \"Rock\"", "name = \"Rock\"\nrolling_friction = 0.3"}},
     "slope.toml:16: warning: material \"Talus\": rolling_friction is not given (the default 0.1 brings spheres to "
     "rest "
     "only on slopes of less than 5.7 degrees). Give the tangent of the slope on which such rocks keep rolling "
     "(docs/laws.md, values of spheres), or like = a ground that has one (talus materials)"},
    {"SphereOnLibraryGroundWithoutRollingFriction",
     {{"[analysis]", "[analysis]\nmodel = \"rigid_sphere\""},
      {"name = \"Rock\"", "name = \"Rock\"\nlike = \"asphalt\""},
      {"name = \"Talus\"", "name = \"Talus\"\nlike = \"talus_cover\""}},
     "slope.toml:12: warning: material \"Rock\": rolling_friction is not given (the library has none for \"asphalt\", "
     "and the default 0.1 brings spheres to rest only on slopes of less than 5.7 degrees). Give the tangent of the "
     "slope on which such rocks keep rolling (docs/laws.md, values of spheres), or like = a ground that has one "
     "(talus materials)"},
    {"SphereThatSkidsBeforeItRolls",
     {{"[analysis]", "[analysis]\nmodel = \"rigid_sphere\""},
      {"name = \"Rock\"", "name = \"Rock\"\nrolling_friction = 0.8"},
      {"name = \"Talus\"", "name = \"Talus\"\nlike = \"talus_cover\""}},
     "slope.toml:12: warning: material \"Rock\": rolling_friction is 0.8, but dynamic_friction only 0.5 (a sphere "
     "skids "
     "before it resists like that, and comes to rest only on slopes of less than 26.6 degrees instead of 38.7). Give "
     "dynamic_friction = 0.8 or more"},
    {"SphereThatNeverStops",
     in_3d({{"[analysis]", "[analysis]\nmodel = \"rigid_sphere\""},
            {section, "raster = \"dem.tif\""},
            {segments, "default = \"Rock\""},
            {"name = \"Rock\"", "name = \"Rock\"\nrolling_friction = 0"},
            {"name = \"Talus\"", "name = \"Talus\"\nlike = \"talus_cover\""}}),
     "slope.toml:12: warning: material \"Rock\": rolling_friction is 0 (a sphere on it rolls until it leaves the model "
     "or lies in a pit). Give the tangent of the slope on which such rocks keep rolling (docs/laws.md, values of "
     "spheres)"},
    {"SmoothGroundIn3d",
     in_3d({{section, "raster = \"dem.tif\""},
            {segments, "default = \"Rock\""},
            {"normal_restitution = 0.4",
             "normal_restitution = { mean = 0.4, distribution = \"normal\", std_dev = 0.03 }"},
            {"rocks = 10", "rocks = 500"}}),
     "slope.toml:9: warning: no material has a roughness (on terrain in 3D all rocks from one place then follow almost "
     "the same path: nothing turns them aside). Give roughness_deg (docs/laws.md, values of roughness), or like = a "
     "ground that has one (talus materials)"},
    {"RoughGroundOfTheLibraryIn3d",
     in_3d({{section, "raster = \"dem.tif\""},
            {segments, "default = \"Rock\""},
            {"name = \"Rock\"", "name = \"Rock\"\nlike = \"talus_cover\""},
            {"rocks = 10", "rocks = 500"}}),
     ""},
    {"FewRocksOnSmoothGroundIn3d", in_3d({{section, "raster = \"dem.tif\""}, {segments, "default = \"Rock\""}}), ""},
    {"StandardDeviationWithLimits",
     {{"normal_restitution = 0.4",
       R"(normal_restitution = { mean = 0.4, distribution = "uniform", std_dev = 0.03, rel_min = 0.1, rel_max = 0.1 })"}},
     "slope.toml:11: warning: material \"Rock\": std_dev of normal_restitution has no effect (the uniform distribution "
     "takes its width from rel_min and rel_max). Leave out std_dev, or the limits"},
    {"SettingsWithoutEffect",
     {{"[analysis]",
       R"([analysis]
laws = "rocfall"
rn_velocity_scale_m_s = 9
rn_mass_scale_kg = 9)"}},
     "slope.toml:5: warning: [analysis]: rn_velocity_scale_m_s has no effect (it needs scale_rn_by_velocity = true)\n"
     "slope.toml:6: warning: [analysis]: rn_mass_scale_kg has no effect (it needs scale_rn_by_mass = true)"},
    {"SettingsWithAnEffectByDefault",
     {{"[analysis]",
       R"([analysis]
rn_velocity_scale_m_s = 9
tangential_crsp_damping = true
rolling_resistance_in_impacts = false)"}},
     ""},
    {"RotationOffForASphere",
     {{"[analysis]",
       R"([analysis]
model = "rigid_sphere"
rotation = false)"},
      {"name = \"Rock\"", "name = \"Rock\"\nrolling_friction = 0.3"},
      {"name = \"Talus\"", "name = \"Talus\"\nrolling_friction = 0.3"}},
     "slope.toml:5: warning: [analysis]: rotation has no effect (it needs model = \"lumped_mass\")"},
    {"SlidingAndFrictionOfASphere",
     {{"[analysis]",
       R"([analysis]
model = "rigid_sphere"
sliding = "closed_form"
friction_angle = "zero")"},
      {"name = \"Rock\"", "name = \"Rock\"\nrolling_friction = 0.3"},
      {"name = \"Talus\"", "name = \"Talus\"\nrolling_friction = 0.3"}},
     "slope.toml:5: warning: [analysis]: sliding has no effect (it needs model = \"lumped_mass\")\n"
     "slope.toml:6: warning: [analysis]: friction_angle has no effect (it needs model = \"lumped_mass\")"},
    {"RotatedAboutAPointWithoutAngle",
     in_3d({{section,
             R"(section = [[0, 0], [10, -10], [20, -10]]
width_m = 50
rotate_about = [0, 25, 0])"}}),
     "slope.toml:9: warning: [terrain]: rotate_about has no effect (it needs rotate_deg)"},
};

INSTANTIATE_TEST_SUITE_P(All, DoubtfulProjects, testing::ValuesIn(doubtful_projects), name_of_case<BadProject>);

TEST(DoubtfulProject, ASeederWithoutANameIsIdentifiedByItsNumber) {
  const std::string text = changed({{"name = \"Crest\"\n", ""}, {"rocks = 10", "rocks = 500"}});
  const Reading reading = read_project_text(text, "slope.toml");
  EXPECT_EQ(
      reading.warnings.text(),
      "slope.toml:23: warning: seeder 1: its 500 rocks are identical (nothing about them or the ground is random, so "
      "they all follow one path). Give restitution or friction a distribution, or the ground a roughness");
}

}  // namespace
}  // namespace talus::project
