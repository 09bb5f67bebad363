// Every way to get a project file wrong that we know of, each with the exact text that the user sees.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "talus/project/read.hpp"

namespace talus::project {
namespace {

/// A good project. The cases below replace parts of it.
constexpr const char* good_project = R"(name = "Slope"

[analysis]
gravity_m_s2 = 9.81

[terrain]
section = [[0, 0], [10, -10], [20, -10]]

[[material]]
name = "Rock"
normal_restitution = 0.4
friction_angle_deg = 30

[[material]]
name = "Talus"
normal_restitution = 0.3

[ground]
segments = ["Rock", "Talus"]

[[seeder]]
name = "Crest"
position = [1, 5]
rocks = 10
mass_kg = 1000

[[barrier]]
name = "Fence"
line = 15
height_m = 3
)";

struct BadProject {
  const char* name;
  std::vector<std::pair<std::string, std::string>> replaced;  // in the good project: this by that
  std::string message;
};

std::string changed(const BadProject& bad) {
  std::string text = good_project;
  for (const auto& [from, to] : bad.replaced) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "the good project has no " << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
  }
  return text;
}

/// What the reader reports, or nothing where the project is good.
std::string message_about(const std::string& text, const Overrides& overrides = {}) {
  try {
    const Reading reading = read_project_text(text, "slope.toml", overrides);
    return "";
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
}

void PrintTo(const BadProject& bad, std::ostream* out) { *out << bad.name; }

template <class Case>
std::string name_of_case(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

class BadProjectTest : public testing::TestWithParam<BadProject> {};

TEST_P(BadProjectTest, IsRefusedWithThisText) { EXPECT_EQ(message_about(changed(GetParam())), GetParam().message); }

const std::vector<BadProject> bad_projects{
    {"SyntaxError",
     {{"rocks = 10", "rocks 10"}},
     "slope.toml:24: this is not TOML (Error while parsing key-value pair: expected '=', saw '1')"},
    {"KeyTwice",
     {{"rocks = 10",
       R"(rocks = 10
rocks = 11)"}},
     "slope.toml:25: this is not TOML (Error while parsing key-value pair: cannot redefine existing integer 'rocks')"},
    {"NumberTooLargeForToml",
     {{"rocks = 10", "rocks = 99999999999999999999"}},
     "slope.toml:24: this is not TOML (Error while parsing decimal integer: '99999999999999999999' is not "
     "representable in 64 bits)"},
    {"DecimalComma",
     {{"friction_angle_deg = 30", "friction_angle_deg = 30,5"}},
     "slope.toml:12: this is not TOML (Error while parsing key-value pair: expected a comment or whitespace, saw ','). "
     "Write 30.5: numbers have a decimal point"},
    {"WindowsPath",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "C:\data\dem.tif")"}},
     "slope.toml:7: this is not TOML (Error while parsing string: unknown escape sequence '\\d'). In double quotes a "
     "backslash begins an escape: write paths with /, or in single quotes"},
    {"DecimalCommaInQuotes",
     {{"friction_angle_deg = 30", "friction_angle_deg = \"30,5\""}},
     "slope.toml:12: material \"Rock\": friction_angle_deg is \"30,5\" (expected a number or { mean = ..., "
     "distribution = ..., ... }). Write 30.5, without quotes"},
    {"MistypedSize",
     {{"mass_kg", "diametr_m"}},
     "slope.toml:25: seeder \"Crest\": unknown key \"diametr_m\". Did you mean \"diameter_m\"?"},
    {"MistypedPosition",
     {{"position", "postion"}},
     "slope.toml:23: seeder \"Crest\": unknown key \"postion\". Did you mean \"position\"?"},
    {"MistypedTerrain",
     {{"section = [", "sektion = ["}},
     "slope.toml:7: [terrain]: unknown key \"sektion\". Did you mean \"section\"?"},
    {"MistypedRequiredKey",
     {{"height_m", "hight_m"}},
     "slope.toml:30: barrier \"Fence\": unknown key \"hight_m\". Did you mean \"height_m\"?"},
    {"UnknownKey",
     {{"gravity_m_s2", "gravity_ms2"}},
     "slope.toml:4: [analysis]: unknown key \"gravity_ms2\". Did you mean \"gravity_m_s2\"?"},
    {"UnknownKeyWithoutItsUnit",
     {{"gravity_m_s2", "gravity"}},
     "slope.toml:4: [analysis]: unknown key \"gravity\". Did you mean \"gravity_m_s2\"?"},
    {"UnknownKeyOfAnotherTable",
     {{"rocks = 10",
       R"(rocks = 10
height_m = 2)"}},
     "slope.toml:25: seeder \"Crest\": unknown key \"height_m\". It belongs to [[barrier]]"},
    {"UnknownKeyLikeNoOther",
     {{"gravity_m_s2 = 9.81", "wind = 3"}},
     "slope.toml:4: [analysis]: unknown key \"wind\" (expected one of model, rotation, gravity_m_s2, sliding, "
     "max_timestep_s, normal_velocity_cutoff_m_s, grazing_angle_deg, stopped_velocity_m_s, max_steps, max_time_s, "
     "energy_datum_m, friction_angle, scale_rn_by_velocity, rn_velocity_scale_m_s, scale_rn_by_mass, rn_mass_scale_kg "
     "or tangential_crsp_damping)"},
    {"UnknownTable",
     {{"[analysis]", "[analisys]"}},
     "slope.toml:3: unknown table [analisys]. Did you mean [analysis]?"},
    {"UnknownTableLikeNoOther",
     {{R"([analysis]
gravity_m_s2 = 9.81)",
       R"([weather]
wind = 3)"}},
     "slope.toml:3: unknown table [weather] (expected one of name, analysis, sampling, terrain, material, ground, "
     "area, seeder, barrier, collector, design or output)"},
    {"UnknownKeyBeforeTheFirstTable",
     {{R"(name = "Slope")", R"(titel = "Slope")"}},
     "slope.toml:1: unknown key \"titel\" (expected one of name, analysis, sampling, terrain, material, ground, area, "
     "seeder, barrier, collector, design or output)"},
    {"TableOnceInsteadOfList",
     {{"[[barrier]]", "[barrier]"}},
     "slope.toml:27: [barrier] is a single table (there may be several; expected [[barrier]])"},
    {"ListInsteadOfTable",
     {{"[analysis]", "[[analysis]]"}},
     "slope.toml:3: [[analysis]] is a list of tables (expected one table, [analysis])"},
    {"TableIsANumber",
     {{R"(name = "Slope")", "output = 3"}},
     "slope.toml:1: output is 3 (expected one table, [output])"},
    {"EntryIsNoTable",
     {{R"(name = "Slope")", "collector = [3]"}},
     "slope.toml:1: collector[0] is 3 (expected a table [[collector]])"},
    {"NumberInQuotes",
     {{"mass_kg = 1000", R"(mass_kg = "1000")"}},
     "slope.toml:25: seeder \"Crest\": mass_kg is \"1000\" (expected a number or { mean = ..., distribution = ..., ... "
     "}). Leave out the quotes"},
    {"TextForNumber",
     {{"height_m = 3", R"(height_m = "tall")"}},
     "slope.toml:30: barrier \"Fence\": height_m is \"tall\" (expected a number, more than 0, up to 10000)"},
    {"NumberForText",
     {{R"(name = "Fence")", "name = 7"}},
     "slope.toml:28: barrier 1: name is 7 (expected a text in quotes)"},
    {"EmptyName",
     {{R"(name = "Rock")", R"(name = "")"}},
     "slope.toml:10: material 1: name is \"\" (expected a text that is not empty)"},
    {"RealForWhole",
     {{"rocks = 10", "rocks = 1e3"}},
     "slope.toml:24: seeder \"Crest\": rocks is 1000 (expected a whole number, 1 to 1e12). Write 1000, without a "
     "decimal point or an exponent"},
    {"FractionOfARock",
     {{"rocks = 10", "rocks = 2.5"}},
     "slope.toml:24: seeder \"Crest\": rocks is 2.5 (expected a whole number, 1 to 1e12)"},
    {"TextForTruth",
     {{"gravity_m_s2 = 9.81", R"(rotation = "true")"}},
     "slope.toml:4: [analysis]: rotation is \"true\" (expected true or false). Leave out the quotes"},
    {"UnknownWord",
     {{"gravity_m_s2 = 9.81", R"(model = "rigid")"}},
     "slope.toml:4: [analysis]: model is \"rigid\" (expected \"lumped_mass\" or \"rigid_sphere\"). Did you mean "
     "\"rigid_sphere\"?"},
    {"NumberForWord",
     {{"gravity_m_s2 = 9.81", "model = 2"}},
     "slope.toml:4: [analysis]: model is 2 (expected \"lumped_mass\" or \"rigid_sphere\")"},
    {"RestitutionGainsEnergy",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 1.3, distribution = "normal", std_dev = 0.03 })"}},
     "slope.toml:11: material \"Rock\": normal_restitution mean is 1.3 (a rebound cannot gain energy; expected 0 to "
     "1). Did you mean 0.13?"},
    {"RestitutionInPercent",
     {{"normal_restitution = 0.4", "normal_restitution = 30"}},
     "slope.toml:11: material \"Rock\": normal_restitution is 30 (a rebound cannot gain energy; expected 0 to 1). Did "
     "you mean 0.3?"},
    {"NegativeRestitution",
     {{"normal_restitution = 0.4", "normal_restitution = -0.4"}},
     "slope.toml:11: material \"Rock\": normal_restitution is -0.4 (a restitution cannot be negative; expected 0 to "
     "1)"},
    {"FrictionAngleTooLarge",
     {{"friction_angle_deg = 30", "friction_angle_deg = 90"}},
     "slope.toml:12: material \"Rock\": friction_angle_deg is 90 (no rock would slide; expected 0 to 89.9)"},
    {"DensityInTonnes",
     {{"rocks = 10",
       R"(rocks = 10
density_kg_m3 = 2.7)"}},
     "slope.toml:25: seeder \"Crest\": density_kg_m3 is 2.7 (rock weighs about 2000 to 3300 kg/m3; expected 100 to "
     "20000). Did you mean 2700?"},
    {"NegativeGravity",
     {{"9.81", "-9.81"}},
     "slope.toml:4: [analysis]: gravity_m_s2 is -9.81 (gravity is a magnitude and always points down; expected 1e-6 to "
     "1000). Did you mean 9.81?"},
    {"NotANumber", {{"9.81", "nan"}}, "slope.toml:4: [analysis]: gravity_m_s2 is nan (expected a finite number)"},
    {"InfiniteNumber", {{"9.81", "inf"}}, "slope.toml:4: [analysis]: gravity_m_s2 is inf (expected a finite number)"},
    {"NegativeInfiniteCapacity",
     {{"height_m = 3",
       R"(height_m = 3
capacity_kJ = -inf)"}},
     "slope.toml:31: barrier \"Fence\": capacity_kJ is -inf (expected a finite number)"},
    {"ZeroCapacity",
     {{"height_m = 3",
       R"(height_m = 3
capacity_kJ = 0)"}},
     "slope.toml:31: barrier \"Fence\": capacity_kJ is 0 (it would stop nothing; a [[collector]] records rocks without "
     "stopping them; expected more than 0, up to 1e20)"},
    {"ZeroRocks",
     {{"rocks = 10", "rocks = 0"}},
     "slope.toml:24: seeder \"Crest\": rocks is 0 (a seeder without rocks does nothing; expected 1 to 1e12)"},
    {"TooManyRocks",
     {{"rocks = 10", "rocks = 2000000000000"}},
     "slope.toml:24: seeder \"Crest\": rocks is 2000000000000 (expected 1 to 1e12)"},
    {"NegativeMass",
     {{"mass_kg = 1000", "mass_kg = -1000"}},
     "slope.toml:25: seeder \"Crest\": mass_kg is -1000 (a rock has mass; expected 1e-9 to 1e12)"},
    {"NegativeSeed",
     {{"[terrain]",
       R"([sampling]
seed = -1

[terrain])"}},
     "slope.toml:7: [sampling]: seed is -1 (expected 0 or more)"},
    {"NoMassNorSize",
     {{R"(mass_kg = 1000
)",
       ""}},
     "slope.toml:21: seeder \"Crest\": the size of the rocks is missing (expected one of mass_kg, volume_m3 and "
     "diameter_m)"},
    {"MassAndDiameter",
     {{"mass_kg = 1000",
       R"(mass_kg = 1000
diameter_m = 1)"}},
     "slope.toml:26: seeder \"Crest\": mass_kg and diameter_m are given together (they exclude each other)"},
    {"NoStandardDeviation",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 0.4, distribution = "normal" })"}},
     "slope.toml:11: material \"Rock\": normal_restitution std_dev is missing (the normal distribution needs it)"},
    {"NegativeStandardDeviation",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 0.4, distribution = "normal", std_dev = -0.03 })"}},
     "slope.toml:11: material \"Rock\": normal_restitution std_dev is -0.03 (a standard deviation cannot be negative; "
     "expected 0 or more). Did you mean 0.03?"},
    {"NegativeRelativeLimit",
     {{"normal_restitution = 0.4",
       R"(normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 0.03, rel_min = -0.1 })"}},
     "slope.toml:11: material \"Rock\": normal_restitution rel_min is -0.1 (it is a distance below the mean; expected "
     "0 or more). Did you mean 0.1?"},
    {"BetaWithoutLimits",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 0.4, distribution = "beta", std_dev = 0.03 })"}},
     "slope.toml:11: material \"Rock\": normal_restitution limits are missing (the beta distribution lies between "
     "rel_min and rel_max)"},
    {"SpreadWithoutDistribution",
     {{"normal_restitution = 0.4", "normal_restitution = { mean = 0.4, std_dev = 0.03 }"}},
     "slope.toml:11: material \"Rock\": normal_restitution has std_dev but no distribution (it would have no effect). "
     "Add distribution = \"normal\", or another kind"},
    {"DistributionWithoutMean",
     {{"normal_restitution = 0.4", R"(normal_restitution = { distribution = "normal", std_dev = 0.03 })"}},
     "slope.toml:11: material \"Rock\": normal_restitution mean is missing"},
    {"UnknownDistribution",
     {{"normal_restitution = 0.4",
       R"(normal_restitution = { mean = 0.4, distribution = "gaussian", std_dev = 0.03 })"}},
     "slope.toml:11: material \"Rock\": normal_restitution distribution is \"gaussian\" (expected \"none\", "
     "\"normal\", \"uniform\", \"triangular\", \"beta\", \"exponential\", \"lognormal\" or \"gamma\")"},
    {"MisspeltDistribution",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 0.4, distribution = "nromal", std_dev = 0.03 })"}},
     "slope.toml:11: material \"Rock\": normal_restitution distribution is \"nromal\" (expected \"none\", \"normal\", "
     "\"uniform\", \"triangular\", \"beta\", \"exponential\", \"lognormal\" or \"gamma\"). Did you mean \"normal\"?"},
    {"UnknownKeyOfADistribution",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 0.4, distribution = "normal", stddev = 0.03 })"}},
     "slope.toml:11: material \"Rock\": unknown key \"stddev\" of normal_restitution. Did you mean \"std_dev\"?"},
    {"MeanInQuotes",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = "0.4" })"}},
     "slope.toml:11: material \"Rock\": normal_restitution mean is \"0.4\" (expected a number). Leave out the quotes"},
    {"ListForADistribution",
     {{"normal_restitution = 0.4", "normal_restitution = [0.4, 0.1]"}},
     "slope.toml:11: material \"Rock\": normal_restitution is [0.4, 0.1] (expected a number or { mean = ..., "
     "distribution = ..., ... })"},
    {"TerrainMissing",
     {{R"([terrain]
section = [[0, 0], [10, -10], [20, -10]]
)",
       ""}},
     "slope.toml: [terrain] is missing (a project needs it)"},
    {"TerrainEmpty",
     {{"section = [[0, 0], [10, -10], [20, -10]]", ""}},
     "slope.toml:6: [terrain]: there is no terrain (expected one of section, mesh, triangles, raster, points, lines, "
     "polylines and polygons)"},
    {"SectionAndMesh",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
mesh = "bowl.obj")"}},
     "slope.toml:8: [terrain]: section and mesh are given together (they exclude each other)"},
    {"SectionEmpty",
     {{"section = [[0, 0], [10, -10], [20, -10]]", "section = []"},
      {R"([ground]
segments = ["Rock", "Talus"]
)",
       R"([ground]
default = "Rock"
)"}},
     "slope.toml:7: [terrain]: section has 0 vertices (a slope has two or more)"},
    {"SectionOfOneVertex",
     {{"section = [[0, 0], [10, -10], [20, -10]]", "section = [[0, 0]]"},
      {R"([ground]
segments = ["Rock", "Talus"]
)",
       R"([ground]
default = "Rock"
)"}},
     "slope.toml:7: [terrain]: section has 1 vertex (a slope has two or more)"},
    {"SectionRepeatsAVertex",
     {{"[20, -10]]", "[10, -10]]"}},
     "slope.toml:7: [terrain]: section[2] is [10, -10] (it repeats the previous vertex). Leave it out"},
    {"SectionVertexOfThree",
     {{"[20, -10]]", "[20, 0, -10]]"}},
     "slope.toml:7: [terrain]: section[2] is [20, 0, -10] (expected a pair [x, z])"},
    {"SectionVertexNotANumber",
     {{"[20, -10]]", "[20, nan]]"}},
     "slope.toml:7: [terrain]: section[2][1] is nan (expected a finite number)"},
    {"SectionIsNoList",
     {{"section = [[0, 0], [10, -10], [20, -10]]", "section = 5"}},
     "slope.toml:7: [terrain]: section is 5 (expected a list [...])"},
    {"WidthNegative",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
width_m = -50)"}},
     "slope.toml:8: [terrain]: width_m is -50 (expected more than 0, up to 1e9)\n"
     "slope.toml:24: seeder \"Crest\": position is [1, 5] (expected [x, y, z] in a 3D analysis). For a height above "
     "the terrain, leave out z and give height_above_m\n"
     "slope.toml:30: barrier \"Fence\": line is 15 (expected two or more points on plan, [[x, y], [x, y]])"},
    {"WidthWithoutSection",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(mesh = "bowl.obj"
width_m = 50)"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:8: [terrain]: width_m is given without a section (it would have no effect)"},
    {"DeviationsOfTooFewVertices",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
section_std_dev_m = [[0.1, 0.1]])"}},
     "slope.toml:8: [terrain]: section_std_dev_m has 1 entry (expected one for each of the 3 vertices of the section)"},
    {"MoreThanAnyRockWeighs",
     {{"mass_kg = 1000", "mass_kg = 1e200"}},
     "slope.toml:25: seeder \"Crest\": mass_kg is 1e+200 (no rock is that heavy; expected 1e-9 to 1e12)"},
    {"FasterThanAnyRock",
     {{"mass_kg = 1000", "mass_kg = 1000\nhorizontal_velocity_m_s = 1e160"}},
     "slope.toml:26: seeder \"Crest\": horizontal_velocity_m_s is 1e+160 (no rock falls that fast; expected -10000 to "
     "10000)"},
    {"HigherThanAnyPlace",
     {{"position = [1, 5]", "position = [1, 5e99]"}},
     "slope.toml:23: seeder \"Crest\": position[1] is 5e+99 (coordinates are in metres; expected -1e9 to 1e9)"},
    {"ADirectionWithoutLength",
     {{"mass_kg = 1000", "mass_kg = 1000\ndirection = [1e-200, 0]"}},
     "slope.toml:26: seeder \"Crest\": direction is [1e-200, 0] (expected a direction whose length is not 0)"},
    {"ABarrierFarFromAnyPlace",
     {{"line = 15", "line = 15e200"}},
     "slope.toml:29: barrier \"Fence\": line is 1.5e+201 (coordinates lie within 1e+09 m)"},
    {"TimeWithoutEnd",
     {{"gravity_m_s2 = 9.81", "max_time_s = 1e155"}},
     "slope.toml:4: [analysis]: max_time_s is 1e+155 (expected more than 0, up to 1e6)"},
    {"StepsTooShort",
     {{"gravity_m_s2 = 9.81", "max_timestep_s = 1e-9"}},
     "slope.toml:4: [analysis]: max_timestep_s is 1e-09 (one slide would take billions of such steps; expected 1e-4 to "
     "1e6)"},
    {"DeviationsThatChangeTheOrder",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
section_std_dev_m = [[0, 0.1], [2, 0], [2, 0]])"}},
     "slope.toml:8: [terrain]: section_std_dev_m lets section[1] and section[2] swap places (vertices move by up to 3 "
     "standard deviations: the left one to x = 16, the right one to x = 14). Reduce their standard deviations in x, or "
     "leave out one of the vertices"},
    {"DeviationsThatChangeTheOrderFromRightToLeft",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[20, -10], [10, -10], [0, 0]]
section_std_dev_m = [[2, 0], [2, 0], [0, 0.1]])"}},
     "slope.toml:8: [terrain]: section_std_dev_m lets section[0] and section[1] swap places (vertices move by up to 3 "
     "standard deviations: the left one to x = 16, the right one to x = 14). Reduce their standard deviations in x, or "
     "leave out one of the vertices"},
    {"DeviationsIn3D",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
section_std_dev_m = [[0.1, 0.1], [0, 0], [0, 0]]
width_m = 50)"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:9: [terrain]: section_std_dev_m and width_m are given together (they exclude each other)"},
    {"TurnedIn2D",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
rotate_deg = 30)"}},
     "slope.toml:8: [terrain]: rotate_deg is given in 2D (a section cannot be rotated). Give width_m for 3D"},
    {"UnknownMeshFormat",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(mesh = "bowl.dwg")"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:7: [terrain]: mesh is \"bowl.dwg\" (expected a file that ends in .obj, .stl or .ply)"},
    {"TerrainRasterAndMesh",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif"
mesh = "bowl.obj")"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:7: [terrain]: mesh and raster are given together (they exclude each other)"},
    {"TurnedRaster",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif"
rotate_deg = 30)"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:8: [terrain]: rotate_deg is given with a raster (a raster has a fixed position, with rows from west "
     "to east). Leave it out"},
    {"SegmentsOnARaster",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif")"},
      {R"(segments = ["Rock", "Talus"])", R"(segments = ["Rock", "Talus"])"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:19: [ground]: segments is given without a section (a raster has cells). Use raster and classes"},
    {"TrianglesOnARaster",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif")"},
      {R"(segments = ["Rock", "Talus"])", R"(triangles = [0, 1])"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:19: [ground]: triangles is given for a raster (a raster has cells). Use raster and classes"},
    {"GroundRasterWithoutClasses",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif")"},
      {R"(segments = ["Rock", "Talus"])", R"(raster = "ground.tif")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:19: [ground]: classes is missing (the materials of its classes are not given). Write classes = { 1 = "
     "\"Rock\" }, with one entry for each class"},
    {"ClassesWithoutARaster",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif")"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock"
classes = { 1 = "Rock" })"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:20: [ground]: classes is given without a raster (it would have no effect)"},
    {"ClassOfAnUnknownMaterial",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif")"},
      {R"(segments = ["Rock", "Talus"])", R"(raster = "ground.tif"
classes = { 1 = "Rock", 2 = "Talos" })"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:20: [ground]: classes.2 is \"Talos\" (no material has this name; the project has \"Rock\", "
     "\"Talus\"). Did you mean \"Talus\"?"},
    {"ClassThatIsNoNumber",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif")"},
      {R"(segments = ["Rock", "Talus"])", R"(raster = "ground.tif"
classes = { rock = "Rock", 99999999999 = "Rock" })"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:20: [ground]: classes has the key \"99999999999\" (a class is a whole number of at most 32 "
     "bits)\nslope.toml:20: [ground]: classes has the key \"rock\" (a class is a whole number of at most 32 bits)"},
    {"ClassNamedTwice",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif")"},
      {R"(segments = ["Rock", "Talus"])", R"(raster = "ground.tif"
classes = { 1 = "Rock", 01 = "Talus" })"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:20: [ground]: classes.1 repeats class 1 (a class has one material)"},
    {"ClassesOfTheWrongKind",
     {{"section = [[0, 0], [10, -10], [20, -10]]", R"(raster = "dem.tif")"},
      {R"(segments = ["Rock", "Talus"])", R"(raster = "ground.tif"
classes = ["Rock", "Talus"])"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:20: [ground]: classes is [\"Rock\", \"Talus\"] (expected { 1 = \"...\", 2 = \"...\" } with one entry "
     "or more)"},
    {"GroundRasterForASection",
     {{R"(segments = ["Rock", "Talus"])", R"(raster = "ground.tif"
classes = { 1 = "Rock" })"}},
     "slope.toml:19: [ground]: raster is given for a section (a section has segments). Use segments, with one name for "
     "each segment"},
    {"TriangleIndexOutOfRange",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 3]])"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:8: [terrain]: triangles[0] is [0, 1, 3] (there are 3 vertices; expected 0 to 2). Vertices are "
     "numbered from 0"},
    {"TriangleOfTwoVertices",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 1]])"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:8: [terrain]: triangles[0] is [0, 1, 1] (a triangle has three different vertices)"},
    {"NegativeVertexNumber",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, -1]])"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:8: [terrain]: triangles[0][2] is -1 (expected 0 or more)"},
    {"InfiniteVertex",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(vertices = [[0, 0, 0], [10, 0, inf], [0, 10, 0]]
triangles = [[0, 1, 2]])"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:7: [terrain]: vertices[1][2] is inf (expected a finite number)"},
    {"VerticesWithoutTriangles",
     {{"section = [[0, 0], [10, -10], [20, -10]]", "vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]"},
      {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:6: [terrain]: triangles is missing (an inline mesh needs vertices and triangles)"},
    {"MaterialMissing",
     {{R"([[material]]
name = "Rock"
normal_restitution = 0.4
friction_angle_deg = 30

[[material]]
name = "Talus"
normal_restitution = 0.3
)",
       ""}},
     "slope.toml: [[material]] is missing (a project needs at least one)"},
    {"MaterialWithoutName",
     {{R"(name = "Rock"
)",
       ""}},
     "slope.toml:9: material 1: name is missing"},
    {"MaterialTwice",
     {{R"(name = "Talus")", R"(name = "Rock")"}, {R"(segments = ["Rock", "Talus"])", R"(segments = ["Rock", "Rock"])"}},
     "slope.toml:15: two materials are named \"Rock\" (the first begins in line 9). Give each its own name"},
    {"MaterialUnknown",
     {{R"(segments = ["Rock", "Talus"])", R"(segments = ["Rock", "Tallus"])"}},
     "slope.toml:19: [ground]: segments[1] is \"Tallus\" (no material has this name; the project has \"Rock\", "
     "\"Talus\"). Did you mean \"Talus\"?"},
    {"DefaultMaterialUnknown",
     {{R"(segments = ["Rock", "Talus"])", R"(default = "Grass")"}},
     "slope.toml:19: [ground]: default is \"Grass\" (no material has this name; the project has \"Rock\", \"Talus\")"},
    {"DefaultMaterialMissing",
     {{R"([ground]
segments = ["Rock", "Talus"]
)",
       ""}},
     "slope.toml: [ground]: default is missing (there are 2 materials). Write default = \"Rock\", or segments with one "
     "name for each segment"},
    {"SegmentMissing",
     {{R"(segments = ["Rock", "Talus"])", R"(segments = ["Rock"])"}},
     "slope.toml:19: [ground]: segments has 1 entry (expected 2: the section has 3 vertices)"},
    {"SegmentsOfAMesh",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 2]])"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:20: [ground]: segments is given without a section (a mesh has triangles). Use triangles, with one "
     "number for each triangle"},
    {"GroundTrianglesOfASection",
     {{R"(segments = ["Rock", "Talus"])", "triangles = [0, 1]"}},
     "slope.toml:19: [ground]: triangles is given for a section (a section has segments). Use segments, with one name "
     "for each segment"},
    {"GroundTrianglesTooMany",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 2]])"},
      {R"(segments = ["Rock", "Talus"])", "triangles = [0, 1]"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:20: [ground]: triangles has 2 entries (expected 1, one for each triangle of the terrain)"},
    {"GroundTriangleWithoutMaterial",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 2]])"},
      {R"(segments = ["Rock", "Talus"])", "triangles = [2]"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:20: [ground]: triangles[0] is 2 (there are 2 materials, numbered from 0; expected 0 to 1)"},
    {"GroundFromPolygons",
     {{R"(segments = ["Rock", "Talus"])",
       R"(default = "Rock"
polygons = "ground.gpkg"
attribute = "material")"}},
     "slope.toml:20: [ground]: polygons is given for a section (a section has segments). Use segments, with one name "
     "for each segment"},
    {"SeederMissing",
     {{R"([[seeder]]
name = "Crest"
position = [1, 5]
rocks = 10
mass_kg = 1000
)",
       ""}},
     "slope.toml: [[seeder]] is missing (a project needs at least one)"},
    {"SeederFromPolygon",
     {{"position = [1, 5]",
       R"(type = "polygon"
position = [1, 5])"}},
     "slope.toml:23: seeder \"Crest\": type is \"polygon\" in 2D (a section has no area). Use a point or a line, or "
     "give terrain.width_m for 3D"},
    {"SeederWithoutPosition",
     {{R"(position = [1, 5]
)",
       ""}},
     "slope.toml:21: seeder \"Crest\": position is missing (a point seeder needs it)"},
    {"PointsForAPoint",
     {{"position = [1, 5]", "points = [[1, 5], [2, 5]]"}},
     "slope.toml:23: seeder \"Crest\": points are given for a point (they belong to a line). Write type = \"line\""},
    {"PositionForALine",
     {{"position = [1, 5]",
       R"(type = "line"
position = [1, 5])"}},
     "slope.toml:24: seeder \"Crest\": position is given for a line (a line seeder needs two or more points). Write "
     "points = [..., ...]"},
    {"LineWithOnePoint",
     {{"position = [1, 5]",
       R"(type = "line"
points = [[1, 5]])"}},
     "slope.toml:24: seeder \"Crest\": points is [[1, 5]] (expected a list of two or more positions)"},
    {"LineRepeatsAPoint",
     {{"position = [1, 5]",
       R"(type = "line"
points = [[1, 5], [1, 5]])"}},
     "slope.toml:24: seeder \"Crest\": points[1] is [1, 5] (it repeats the previous point). Leave it out"},
    {"LineHalfOnTheSurface",
     {{"position = [1, 5]",
       R"(type = "line"
points = [[1, 5], [2, "surface"]])"}},
     "slope.toml:24: seeder \"Crest\": points[1] is [2, \"surface\"] (z is either \"surface\" for all points of a line "
     "or a number for all)"},
    {"PositionOfThreeIn2D",
     {{"position = [1, 5]", "position = [1, 0, 5]"}},
     "slope.toml:23: seeder \"Crest\": position is [1, 0, 5] (expected [x, z] in a 2D analysis). Leave out y, or give "
     "terrain.width_m for 3D"},
    {"PositionWithoutZ",
     {{"position = [1, 5]", "position = [1]"}},
     "slope.toml:23: seeder \"Crest\": position is [1] (expected [x, z] in a 2D analysis). For a height above the "
     "terrain, leave out z and give height_above_m"},
    {"PositionOnTheGround",
     {{"position = [1, 5]", R"(position = [1, "ground"])"}},
     "slope.toml:23: seeder \"Crest\": position[1] is \"ground\" (expected a number or \"surface\")"},
    {"PositionWithZAndHeight",
     {{"position = [1, 5]",
       R"(position = [1, 5]
height_above_m = 2)"}},
     "slope.toml:23: seeder \"Crest\": position has z, and height_above_m is given (both give the height). Leave one "
     "of them out"},
    {"HeightBelowTheGround",
     {{"position = [1, 5]",
       R"(position = [1]
height_above_m = -2)"}},
     "slope.toml:24: seeder \"Crest\": height_above_m is -2 (a rock starts on the ground or above it; expected 0 to "
     "1e9)"},
    {"SpeedAndHorizontalVelocity",
     {{"rocks = 10",
       R"(rocks = 10
speed_m_s = 3
horizontal_velocity_m_s = 1)"}},
     "slope.toml:25: seeder \"Crest\": horizontal_velocity_m_s and speed_m_s are given together (they exclude each "
     "other)"},
    {"DirectionWithoutLength",
     {{"rocks = 10",
       R"(rocks = 10
direction = [0, 0])"}},
     "slope.toml:25: seeder \"Crest\": direction is [0, 0] (expected a direction whose length is not 0)"},
    {"DirectionUpWithoutSpeed",
     {{"rocks = 10",
       R"(rocks = 10
direction = [1, 1])"}},
     "slope.toml:25: seeder \"Crest\": direction is [1, 1] (it is the direction of the horizontal velocity; expected z "
     "to be 0). For a velocity that points up or down, give speed_m_s"},
    {"DirectionAcrossIn2D",
     {{"rocks = 10",
       R"(rocks = 10
direction = [1, 1, 0])"}},
     "slope.toml:25: seeder \"Crest\": direction is [1, 1, 0] (expected y to be 0 in a 2D analysis)"},
    {"SeederTwice",
     {{"[[barrier]]",
       R"([[seeder]]
name = "Crest"
position = [2, 5]
mass_kg = 10

[[barrier]])"}},
     "slope.toml:28: two seeders are named \"Crest\" (the first begins in line 21). Give each its own name"},
    {"SeedersWithTooManyRocks",
     {{"rocks = 10", "rocks = 1000000000000"},
      {"[[barrier]]",
       R"([[seeder]]
position = [2, 5]
mass_kg = 10

[[barrier]])"}},
     "slope.toml:24: warning: seeder \"Crest\": its 1000000000000 rocks are identical (nothing about them or the "
     "ground is random, so they all follow one path). Give restitution or friction a distribution, or the ground a "
     "roughness\n"
     "slope.toml:27: all seeders together have 1000000000001 rocks (expected at most 1000000000000)"},
    {"BarrierWithoutHeight",
     {{R"(height_m = 3
)",
       ""}},
     "slope.toml:27: barrier \"Fence\": height_m is missing (expected more than 0, up to 10000)"},
    {"BarrierOfHeightZero",
     {{"height_m = 3", "height_m = 0"}},
     "slope.toml:30: barrier \"Fence\": height_m is 0 (nothing could hit it; expected more than 0, up to 10000)"},
    {"BarrierLyingDown",
     {{"height_m = 3",
       R"(height_m = 3
inclination_deg = 90)"}},
     "slope.toml:31: barrier \"Fence\": inclination_deg is 90 (it would lie on the ground; expected more than -90, "
     "less than 90)"},
    {"BarrierWithoutLine",
     {{R"(line = 15
)",
       ""}},
     "slope.toml:27: barrier \"Fence\": line is missing"},
    {"BarrierAcrossIn2D",
     {{"line = 15", "line = [[15, 0], [16, 50]]"}},
     "slope.toml:29: barrier \"Fence\": line is [[15, 0], [16, 50]] (expected x in a 2D analysis; these points differ "
     "in x)"},
    {"BarrierOfOnePointIn3D",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
width_m = 50)"},
      {"position = [1, 5]", "position = [1, 1, 5]"}},
     "slope.toml:30: barrier \"Fence\": line is 15 (expected two or more points on plan, [[x, y], [x, y]])"},
    {"BarrierRepeatsAPoint",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
width_m = 50)"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 0]]"}},
     "slope.toml:30: barrier \"Fence\": line[1] is [15, 0] (it repeats the previous point). Leave it out"},
    {"BarrierWithHalfARestitution",
     {{"height_m = 3",
       R"(height_m = 3
normal_restitution = 0.5)"}},
     "slope.toml:31: barrier \"Fence\": tangential_restitution is missing (a barrier has both restitutions, or neither "
     "if it holds the rocks it stops)"},
    {"CollectorWithCapacity",
     {{"[[barrier]]", "[[collector]]"},
      {"height_m = 3",
       R"(height_m = 3
capacity_kJ = 100)"}},
     "slope.toml:31: collector \"Fence\": unknown key \"capacity_kJ\". It belongs to [[barrier]]"},
    {"CollectorCalledAsABarrier",
     {{"height_m = 3",
       R"(height_m = 3

[[collector]]
name = "Fence"
line = 16
height_m = 5)"}},
     "slope.toml:33: two barriers or collectors are named \"Fence\" (the first begins in line 27). Give each its own "
     "name"},
    {"PathsInWords",
     {{"[terrain]",
       R"([output]
paths = "some"

[terrain])"}},
     "slope.toml:7: [output]: paths is \"some\" (expected \"all\", \"none\" or a number of rocks)"},
    {"PathsNegative",
     {{"[terrain]",
       R"([output]
paths = -1

[terrain])"}},
     "slope.toml:7: [output]: paths is -1 (expected 0 to 1e12)"},
    {"GeoPackageInWords",
     {{"[terrain]",
       R"([output]
geopackage = true

[terrain])"}},
     "slope.toml:7: [output]: geopackage is true (expected \"all\", \"none\" or a number of rocks)"},
    {"MapPercentileTwice",
     {{"[terrain]",
       R"([output]
percentiles = [50, 0.0, -0.0]

[terrain])"}},
     "slope.toml:7: [output]: percentiles[2] is 0 (it is listed twice). Leave it out"},
    {"TooManyPercentiles",
     {{"[terrain]",
       R"([output]
percentiles = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21]

[terrain])"}},
     "slope.toml:7: [output]: percentiles has 21 entries (expected at most 20)"},
    {"MapsAsOneName",
     {{"[terrain]",
       R"([output]
maps = "velocity"

[terrain])"}},
     "slope.toml:7: [output]: maps is \"velocity\" (expected true, false or a list of \"passages\", \"reach_share\", "
     "\"deposits\", \"impacts\", \"energy_total\", \"energy_translational\", \"velocity\" and \"bounce_height\"). "
     "Write [\"velocity\"]"},
    {"MapsInQuotes",
     {{"[terrain]",
       R"([output]
maps = "true"

[terrain])"}},
     "slope.toml:7: [output]: maps is \"true\" (expected true, false or a list of \"passages\", \"reach_share\", "
     "\"deposits\", \"impacts\", \"energy_total\", \"energy_translational\", \"velocity\" and \"bounce_height\"). "
     "Leave out the quotes"},
    {"MapsUnknown",
     {{"[terrain]",
       R"([output]
maps = ["velocity", "energy_totl", 7, "velocity_max_m_s"]

[terrain])"}},
     "slope.toml:7: [output]: maps[1] is \"energy_totl\" (expected \"passages\", \"reach_share\", \"deposits\", "
     "\"impacts\", \"energy_total\", \"energy_translational\", \"velocity\" or \"bounce_height\"). Did you mean "
     "\"energy_total\"?\n"
     "slope.toml:7: [output]: maps[2] is 7 (expected \"passages\", \"reach_share\", \"deposits\", \"impacts\", "
     "\"energy_total\", \"energy_translational\", \"velocity\" or \"bounce_height\")\n"
     "slope.toml:7: [output]: maps[3] is \"velocity_max_m_s\" (expected \"passages\", \"reach_share\", \"deposits\", "
     "\"impacts\", \"energy_total\", \"energy_translational\", \"velocity\" or \"bounce_height\"). Did you mean "
     "\"velocity\"?"},
    {"MapTwice",
     {{"[terrain]",
       R"([output]
maps = ["velocity", "impacts", "velocity"]

[terrain])"}},
     "slope.toml:7: [output]: maps[2] is \"velocity\" (it is listed twice). Leave it out"},
    {"TooManyMaps",
     {{"[terrain]",
       R"([output]
maps = [1, 2, 3, 4, 5, 6, 7, 8, 9]

[terrain])"}},
     "slope.toml:7: [output]: maps has 9 entries (expected at most 8)"},
    {"MapCellsInWords",
     {{"[terrain]",
       R"([output]
raster_cell_m = "fine"

[terrain])"}},
     "slope.toml:7: [output]: raster_cell_m is \"fine\" (expected a number or \"terrain\")"},
    {"MapCellsOfATerrainWithoutCells",
     {{"[terrain]",
       R"([output]
raster_cell_m = "terrain"

[terrain])"}},
     "slope.toml:7: [output]: raster_cell_m is \"terrain\" (the terrain is not a raster, so it has no cells). Give the "
     "cell size in metres"},
    {"NameIsAFolder",
     {{R"(name = "Slope")", R"(name = "../Slope")"}},
     "slope.toml:1: name is \"../Slope\" (the folder of the results has the same name). Use a name without slashes"},
    {"ANameWithALineBreak",
     {{"name = \"Rock\"", "name = \"Ro\\nck\""}},
     "slope.toml:10: material \"Ro\\nck\": name is \"Ro\\nck\" (expected a text without line breaks or other invisible "
     "characters). In double quotes \\t and \\n are such characters: write paths with /, or in single quotes"},
    {"TwoMistakesAtOnce",
     {{"9.81", "-9.81"}, {"rocks = 10", "rocks = 0"}, {"height_m = 3", R"(height_m = "tall")"}},
     "slope.toml:4: [analysis]: gravity_m_s2 is -9.81 (gravity is a magnitude and always points down; expected 1e-6 to "
     "1000). Did you mean 9.81?\n"
     "slope.toml:24: seeder \"Crest\": rocks is 0 (a seeder without rocks does nothing; expected 1 to 1e12)\n"
     "slope.toml:30: barrier \"Fence\": height_m is \"tall\" (expected a number, more than 0, up to 10000)"},
    {"OneBadListDoesNotHideTheRest",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       "section = [[0, nan], [1, nan], [2, nan], [3, nan], [4, nan], [5, nan], [6, nan], [7, nan], [8, nan], [9, nan], "
       "[10, nan], [11, nan]]"},
      {"rocks = 10", "rocks = 0"}},
     "slope.toml:7: [terrain]: section[0][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[1][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[2][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[3][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[4][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[5][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[6][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[7][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[8][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section[9][1] is nan (expected a finite number)\n"
     "slope.toml:7: [terrain]: section was read only up to entry 9 (10 of its entries are wrong so far)\n"
     "slope.toml:24: seeder \"Crest\": rocks is 0 (a seeder without rocks does nothing; expected 1 to 1e12)"},
    {"LongValueIsCut",
     {{"height_m = 3",
       R"(height_m = "three and a half metres, measured from the foot of the fence up to its upper cable")"}},
     "slope.toml:30: barrier \"Fence\": height_m is \"three and a half metres, measured from the foot of the fenc... "
     "(expected a number, more than 0, up to 10000)"},
    {"TextWithALineBreak",
     {{"height_m = 3", R"(height_m = "3\n")"}},
     "slope.toml:30: barrier \"Fence\": height_m is \"3\\n\" (expected a number, more than 0, up to 10000)"},
};

INSTANTIATE_TEST_SUITE_P(All, BadProjectTest, testing::ValuesIn(bad_projects), name_of_case<BadProject>);

class DoubtfulProjectTest : public testing::TestWithParam<BadProject> {};

TEST_P(DoubtfulProjectTest, IsReadWithThisWarning) {
  const Reading reading = read_project_text(changed(GetParam()), "slope.toml");
  EXPECT_EQ(reading.warnings.text(), GetParam().message);
}

const std::vector<BadProject> doubtful_projects{
    {"RocksThatAreAllTheSame",
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
     {{"section = [[0, 0], [10, -10], [20, -10]]", "section = [[0, 0], [10, -10], [20, -10]]\nwidth_m = 20"},
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
    {"DiameterOfAMountain",
     {{"mass_kg = 1000", "diameter_m = 60"}},
     "slope.toml:25: warning: seeder \"Crest\": diameter_m is 60 (this is larger than any rockfall block; rock masses "
     "of this size move as rock avalanches). diameter_m is in metres"},
    {"VolumeOfAMountain",
     {{"mass_kg = 1000", "volume_m3 = 9000"}},
     "slope.toml:25: warning: seeder \"Crest\": volume_m3 is 9000 (this is larger than any rockfall block; rock masses "
     "of this size move as rock avalanches). volume_m3 is in cubic metres"},
    {"MassOfAMountain",
     {{"mass_kg = 1000", "mass_kg = 1e11"}},
     "slope.toml:25: warning: seeder \"Crest\": mass_kg is 100000000000 (this is larger than any rockfall block; rock "
     "masses of this size move as rock avalanches). mass_kg is in kilograms"},
    {"BarrierOfAMountain",
     {{"height_m = 3", "height_m = 4000"}},
     "slope.toml:30: warning: barrier \"Fence\": height_m is 4000 (no barrier of this height has been built). To "
     "record rocks without stopping them, use a [[collector]]"},
    {"ReleaseHighAboveTheGround",
     {{"position = [1, 5]", "position = [1]\nheight_above_m = 2000"}},
     "slope.toml:24: warning: seeder \"Crest\": height_above_m is 2000 (rocks would start far above the ground). It is "
     "a height above the ground, not an elevation"},
    {"DeviationBeyondWhatARestitutionIs",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 10 })"}},
     "slope.toml:11: warning: material \"Rock\": normal_restitution has a std_dev of 10, but its limits cut off most "
     "of the distribution (only 4 % of the normal distribution lies between 0 and 1: draws are almost uniform there, "
     "with mean 0.4999). Give a smaller std_dev, or distribution = \"uniform\""},
    // A triangle with mean 1000 would have its mode at 600, below its lower limit: with the mode there its mean is
    // (900 + 900 + 1500) / 3.
    {"TriangleWhoseLimitsAreNotAboutItsMean",
     {{"mass_kg = 1000", R"(mass_kg = { mean = 1000, distribution = "triangular", rel_min = 100, rel_max = 500 })"}},
     "slope.toml:25: warning: seeder \"Crest\": mass_kg has the mean 1000, but its draws have the mean 1100 (they lie "
     "between 900 and 1500, not symmetrically about the mean). Give limits that are symmetric about the mean, or the "
     "mean that the draws should have"},
    {"UniformWhoseLimitsAreNotAboutItsMean",
     {{"mass_kg = 1000", R"(mass_kg = { mean = 1000, distribution = "uniform", rel_min = 100, rel_max = 500 })"}},
     "slope.toml:25: warning: seeder \"Crest\": mass_kg has the mean 1000, but its draws have the mean 1200 (they lie "
     "between 900 and 1500, not symmetrically about the mean). Give limits that are symmetric about the mean, or the "
     "mean that the draws should have"},
    {"NormalCutOnOneSide",
     {{"mass_kg = 1000", R"(mass_kg = { mean = 1000, distribution = "normal", std_dev = 300, rel_min = 0 })"}},
     // sqrt(2/pi) standard deviations above the mean: 1239.4
     "slope.toml:25: warning: seeder \"Crest\": mass_kg has the mean 1000, but its draws have the mean 1239 (they lie "
     "between 1000 and 3139, not symmetrically about the mean). Give limits that are symmetric about the mean, or the "
     "mean that the draws should have"},
    {"MassInTonnes",
     {{"mass_kg = 1000", "mass_kg = 1"}},
     "slope.toml:25: warning: seeder \"Crest\": mass_kg is 1 (masses are in kilograms, and this stone would fit in a "
     "hand). If it is in tonnes, write 1000"},
    {"LibraryGroundUnderASphere",
     {{"[analysis]", "[analysis]\nmodel = \"rigid_sphere\""},
      {"name = \"Rock\"", "name = \"Rock\"\nlike = \"talus_cover\""}},
     "slope.toml:12: warning: material \"Rock\": the friction of the rigid sphere is not given (the library only has "
     "restitutions, published for lumped masses; dynamic_friction = 0.5 and rolling_friction = 0.1 apply, and spheres "
     "go further and faster than points). Give both, and compare the results with what is known of the site"},
    {"DeviationBesideLimits",
     {{"normal_restitution = 0.4",
       R"(normal_restitution = { mean = 0.4, distribution = "uniform", std_dev = 0.03, rel_min = 0.1, rel_max = 0.1 })"}},
     "slope.toml:11: warning: material \"Rock\": std_dev of normal_restitution has no effect (the uniform distribution "
     "takes its width from rel_min and rel_max). Leave out std_dev, or the limits"},
    {"SettingsWithoutEffect",
     {{"[analysis]",
       R"([analysis]
rn_velocity_scale_m_s = 9
rn_mass_scale_kg = 9
tangential_crsp_damping = true)"}},
     "slope.toml:4: warning: [analysis]: rn_velocity_scale_m_s has no effect (it needs scale_rn_by_velocity = true)\n"
     "slope.toml:5: warning: [analysis]: rn_mass_scale_kg has no effect (it needs scale_rn_by_mass = true)\n"
     "slope.toml:6: warning: [analysis]: tangential_crsp_damping has no effect (it needs model = \"rigid_sphere\")"},
    {"RotationSwitchedOffForASphere",
     {{"[analysis]",
       R"([analysis]
model = "rigid_sphere"
rotation = false)"}},
     "slope.toml:5: warning: [analysis]: rotation has no effect (it needs model = \"lumped_mass\")"},
    {"SlidingAndFrictionOfASphere",
     {{"[analysis]",
       R"([analysis]
model = "rigid_sphere"
sliding = "closed_form"
friction_angle = "zero")"}},
     "slope.toml:5: warning: [analysis]: sliding has no effect (it needs model = \"lumped_mass\")\n"
     "slope.toml:6: warning: [analysis]: friction_angle has no effect (it needs model = \"lumped_mass\")"},
    {"TurnedAboutWithoutAngle",
     {{"section = [[0, 0], [10, -10], [20, -10]]",
       R"(section = [[0, 0], [10, -10], [20, -10]]
width_m = 50
rotate_about = [0, 25, 0])"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 50]]"}},
     "slope.toml:9: warning: [terrain]: rotate_about has no effect (it needs rotate_deg)"},
};

INSTANTIATE_TEST_SUITE_P(All, DoubtfulProjectTest, testing::ValuesIn(doubtful_projects), name_of_case<BadProject>);

struct BadOverride {
  const char* name;
  std::vector<std::string> settings;
  std::string message;
};

void PrintTo(const BadOverride& bad, std::ostream* out) { *out << bad.name; }

class BadOverrideTest : public testing::TestWithParam<BadOverride> {};

TEST_P(BadOverrideTest, IsRefusedWithThisText) {
  EXPECT_EQ(message_about(good_project, {.settings = GetParam().settings, .rocks = {}, .seed = {}}),
            GetParam().message);
}

const std::vector<BadOverride> bad_overrides{
    {"SetWithoutValue",
     {"analysis.gravity_m_s2"},
     "--set analysis.gravity_m_s2: this is not a setting (expected table.key=value, for example "
     "analysis.gravity_m_s2=9.81)"},
    {"SetWithoutKey",
     {"=3"},
     "--set =3: this is not a setting (expected table.key=value, for example analysis.gravity_m_s2=9.81)"},
    {"SetUnknownKey",
     {"analysis.gravity=9.81"},
     "--set analysis.gravity=9.81: [analysis]: unknown key \"gravity\". Did you mean \"gravity_m_s2\"?"},
    {"SetValueOutOfRange",
     {"analysis.gravity_m_s2=-9.81"},
     "--set analysis.gravity_m_s2=-9.81: [analysis]: gravity_m_s2 is -9.81 (gravity is a magnitude and always points "
     "down; expected 1e-6 to 1000). Did you mean 9.81?"},
    {"SetValueNotToml",
     {"analysis.gravity_m_s2=[9.81"},
     "--set analysis.gravity_m_s2=[9.81: the value is not TOML (Error while parsing array: encountered end-of-file)"},
    {"SetDecimalComma",
     {"analysis.gravity_m_s2=9,81"},
     "--set analysis.gravity_m_s2=9,81: the value is not TOML (Error while parsing key-value pair: expected a comment "
     "or whitespace, saw ','). Write 9.81: numbers have a decimal point"},
    {"SetTextForANumber",
     {"analysis.gravity_m_s2=9.81m"},
     "--set analysis.gravity_m_s2=9.81m: [analysis]: gravity_m_s2 is \"9.81m\" (expected a number, 1e-6 to 1000)"},
    {"SetNumberNotToml",
     {"analysis.gravity_m_s2=.5"},
     "--set analysis.gravity_m_s2=.5: the value is not TOML (Error while parsing floating-point: expected decimal "
     "digit, saw '.')"},
    {"SetNothing",
     {"name="},
     "--set name=: the value is not TOML (Error while parsing key-value pair: encountered end-of-file)"},
    {"SetTableLeftOpen",
     {"material.0.normal_restitution={ mean = 0.4"},
     "--set material.0.normal_restitution={ mean = 0.4: the value is not TOML (Error while parsing inline table: "
     "encountered end-of-file)"},
    {"SetTextLeftOpen",
     {"name=\"Slope"},
     "--set name=\"Slope: the value is not TOML (Error while parsing string: encountered end-of-file)"},
    {"SetNoText", {"name=\xff\xfe"}, "--set name=\xff\xfe: the value is not TOML (Encountered invalid utf-8 sequence)"},
    {"SetTwoValues",
     {"analysis.gravity_m_s2=9\nx=3"},
     "--set analysis.gravity_m_s2=9\n"
     "x=3: the value is not TOML (expected a single value)"},
    {"SetUnknownEntry",
     {"material.Granite.normal_restitution=0.4"},
     "--set material.Granite.normal_restitution=0.4: material has no entry Granite (expected 0 to 1, or \"Rock\", "
     "\"Talus\")"},
    {"SetEntryOutOfRange",
     {"seeder.1.rocks=10"},
     "--set seeder.1.rocks=10: seeder has no entry 1 (expected 0, or \"Crest\")"},
    {"SetPartOfAWord", {"name.first=3"}, "--set name.first=3: name is \"Slope\" (it has no parts to set)"},
    {"SetQuoteLeftOpen",
     {R"(material."Rock.normal_restitution=0.4)"},
     "--set material.\"Rock.normal_restitution=0.4: this is not a setting (expected table.key=value, for example "
     "analysis.gravity_m_s2=9.81)"},
};

INSTANTIATE_TEST_SUITE_P(All, BadOverrideTest, testing::ValuesIn(bad_overrides), name_of_case<BadOverride>);

TEST(BadProject, TheGoodOneIsGood) {
  EXPECT_EQ(message_about(good_project), "");
  EXPECT_EQ(read_project_text(good_project, "slope.toml").warnings.text(), "");
}

TEST(BadProject, EmptyText) {
  EXPECT_EQ(message_about(""),
            "slope.toml: [terrain] is missing (a project needs it)\n"
            "slope.toml: [[material]] is missing (a project needs at least one)\n"
            "slope.toml: [[seeder]] is missing (a project needs at least one)");
}

TEST(BadProject, NoRocksOnTheCommandLine) {
  EXPECT_EQ(message_about(good_project, {.settings = {}, .rocks = 0, .seed = {}}),
            "--rocks 0: this is not a number of rocks (expected 1 to 1e12)");
}

TEST(BadProject, NoWarningRestsOnAValueThatWasRefused) {
  const std::string bad_mass = R"(mass_kg = { mean = 1000, distribution = "normal", std_dev = -1 })";
  EXPECT_EQ(message_about(changed({"", {{"mass_kg = 1000", bad_mass}, {"rocks = 10", "rocks = 500"}}, ""})),
            "slope.toml:25: seeder \"Crest\": mass_kg std_dev is -1 (a standard deviation cannot be negative; expected "
            "0 or more). Did you mean 1?");
}

TEST(BadProject, CallsASeederWithoutANameByItsNumber) {
  const std::string text = changed({"", {{"name = \"Crest\"\n", ""}, {"rocks = 10", "rocks = 500"}}, ""});
  const Reading reading = read_project_text(text, "slope.toml");
  EXPECT_EQ(
      reading.warnings.text(),
      "slope.toml:23: warning: seeder 1: its 500 rocks are identical (nothing about them or the ground is random, so "
      "they all follow one path). Give restitution or friction a distribution, or the ground a roughness");
}

TEST(BadProject, WarningsStandBesideErrors) {
  EXPECT_EQ(message_about(changed({"", {{"mass_kg = 1000", "mass_kg = 2"}, {"rocks = 10", "rocks = 0"}}, ""})),
            "slope.toml:24: seeder \"Crest\": rocks is 0 (a seeder without rocks does nothing; expected 1 to 1e12)\n"
            "slope.toml:25: warning: seeder \"Crest\": mass_kg is 2 (masses are in kilograms, and this stone would fit "
            "in a hand). If it is in tonnes, write 2000");
}

TEST(BadProject, OverridesComeAfterTheFile) {
  EXPECT_EQ(
      message_about(changed({"", {{"height_m = 3", "height_m = 0"}}, ""}),
                    {.settings = {"seeder.Crest.rocks=0"}, .rocks = {}, .seed = {}}),
      "slope.toml:30: barrier \"Fence\": height_m is 0 (nothing could hit it; expected more than 0, up to 10000)\n"
      "--set seeder.Crest.rocks=0: seeder \"Crest\": rocks is 0 (a seeder without rocks does nothing; expected 1 to "
      "1e12)");
}

/// A folder that goes when the test is done.
class BadProjectFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "talus-project-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// The message, without the folder, which is another at every run.
  [[nodiscard]] std::string message(const std::filesystem::path& file) const {
    try {
      const Reading reading = read_project(file);
      return "";
    } catch (const BadInput& bad) {
      std::string text = bad.problems().text();
      for (std::size_t at = text.find(folder_.string()); at != std::string::npos; at = text.find(folder_.string())) {
        text.replace(at, folder_.string().size(), "FOLDER");
      }
      return text;
    }
  }

  [[nodiscard]] std::filesystem::path written(const std::string& text) const {
    const std::filesystem::path file = folder_ / "slope.toml";
    std::ofstream(file) << text;
    return file;
  }

  std::filesystem::path folder_;
};

TEST_F(BadProjectFile, IsReadWhereItIsGood) { EXPECT_EQ(message(written(good_project)), ""); }

TEST_F(BadProjectFile, Missing) {
  EXPECT_EQ(message(folder_ / "slope.toml"),
            "FOLDER/slope.toml: there is no such file. `talus new` writes a project to start from");
}

TEST_F(BadProjectFile, IsADirectory) {
  EXPECT_EQ(message(folder_), "FOLDER: this is a directory (expected a project file, for example slope.toml)");
}

TEST_F(BadProjectFile, IsADevice) {
  EXPECT_EQ(message("/dev/null"),
            "/dev/null: this is not a regular file (expected a project file, for example slope.toml)");
}

TEST_F(BadProjectFile, Unreadable) {
  const std::filesystem::path file = written(good_project);
  std::filesystem::permissions(file, std::filesystem::perms::none);
  // The administrator may read everything.
  EXPECT_EQ(message(file), geteuid() == 0 ? "" : "FOLDER/slope.toml: the file cannot be read (Permission denied)");
}

TEST_F(BadProjectFile, TooLarge) {
  const std::filesystem::path file = written(good_project);
  std::filesystem::resize_file(file, 300u << 20u);  // a hole, no bytes on the disk
  EXPECT_EQ(message(file),
            "FOLDER/slope.toml: the file has 300 MiB (a project file has at most 64 MiB). Keep a large terrain in a "
            "mesh file and name it by terrain.mesh");
}

TEST_F(BadProjectFile, Truncated) {
  const std::string text = good_project;
  EXPECT_EQ(message(written(text.substr(0, text.find("[10, -10]") + 4))),
            "FOLDER/slope.toml:7: this is not TOML (Error while parsing array: encountered end-of-file)");
}

TEST_F(BadProjectFile, IsNoText) {
  EXPECT_EQ(
      message(written("name = \"\xff\"")),
      "FOLDER/slope.toml:1: the byte 0xff is not UTF-8 (a project file is UTF-8; Latin-1 and Windows-1252 write "
      "letters such as \u00e4 and \u00e9 as single bytes). Save it as UTF-8; most editors offer this under Save as");
}

TEST_F(BadProjectFile, IsUtf16) {
  const std::string with_mark("\xff\xfen\0a\0", 6), without("n\0a\0m\0e\0", 8);
  for (const std::string& text : {with_mark, without}) {
    EXPECT_EQ(message(written(text)),
              "FOLDER/slope.toml: the file is UTF-16 (a project file is UTF-8). Save it as UTF-8; most editors offer "
              "this under Save as");
  }
}

TEST_F(BadProjectFile, NamesAMeshThatIsNotThere) {
  const BadProject with_mesh{"",
                             {{"section = [[0, 0], [10, -10], [20, -10]]", "mesh = \"bowl.obj\""},
                              {R"(segments = ["Rock", "Talus"])", R"(default = "Rock")"},
                              {"position = [1, 5]", "position = [1, 1, 5]"},
                              {"line = 15", "line = [[15, 0], [15, 50]]"}},
                             ""};
  const std::filesystem::path file = written(changed(with_mesh));
  EXPECT_EQ(message(file),
            "FOLDER/slope.toml:7: [terrain]: mesh is \"bowl.obj\" (there is no file FOLDER/bowl.obj). The path is "
            "relative to the project file");
  std::ofstream(folder_ / "bowl.obj") << "v 0 0 0\n";
  EXPECT_EQ(message(file), "");
}

}  // namespace
}  // namespace talus::project
