// Values of the wrong kind or out of range: the exact text of each error.

#include <gtest/gtest.h>

#include <vector>

#include "project/bad_project.hpp"

namespace talus::project {
namespace {

class BadValues : public BadProjectTest {};

TEST_P(BadValues, AreRefusedWithThisText) {
  EXPECT_EQ(refusal_of_reading(changed(GetParam().replacements)), GetParam().message);
}

const std::vector<BadProject> bad_values{
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
    {"RealForAWholeNumber",
     {{"rocks = 10", "rocks = 1e3"}},
     "slope.toml:24: seeder \"Crest\": rocks is 1000 (expected a whole number, 1 to 1e12). Write 1000, without a "
     "decimal point or an exponent"},
    {"FractionOfARock",
     {{"rocks = 10", "rocks = 2.5"}},
     "slope.toml:24: seeder \"Crest\": rocks is 2.5 (expected a whole number, 1 to 1e12)"},
    {"TextForABoolean",
     {{"gravity_m_s2 = 9.81", R"(rotation = "true")"}},
     "slope.toml:4: [analysis]: rotation is \"true\" (expected true or false). Leave out the quotes"},
    {"UnknownWord",
     {{"gravity_m_s2 = 9.81", R"(model = "rigid")"}},
     "slope.toml:4: [analysis]: model is \"rigid\" (expected \"lumped_mass\", \"rigid_sphere\" or \"rigid_body\"). Did "
     "you mean "
     "\"rigid_sphere\"?"},
    {"NumberForWord",
     {{"gravity_m_s2 = 9.81", "model = 2"}},
     "slope.toml:4: [analysis]: model is 2 (expected \"lumped_mass\", \"rigid_sphere\" or \"rigid_body\")"},
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
    {"NoSize",
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
     "slope.toml:11: material \"Rock\": normal_restitution limits are missing (the beta distribution needs rel_min "
     "and rel_max)"},
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
     "\"normal\", \"uniform\", \"triangular\", \"beta\", \"exponential\", \"lognormal\", \"gamma\" or \"empirical\")"},
    {"MisspeltDistribution",
     {{"normal_restitution = 0.4", R"(normal_restitution = { mean = 0.4, distribution = "nromal", std_dev = 0.03 })"}},
     "slope.toml:11: material \"Rock\": normal_restitution distribution is \"nromal\" (expected \"none\", \"normal\", "
     "\"uniform\", \"triangular\", \"beta\", \"exponential\", \"lognormal\", \"gamma\" or \"empirical\"). Did you mean "
     "\"normal\"?"},
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
    {"NameIsAPath",
     {{R"(name = "Slope")", R"(name = "../Slope")"}},
     "slope.toml:1: name is \"../Slope\" (the folder of the results has the same name). Use a name without slashes"},
    {"NameWithALineBreak",
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
     {{section,
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
    {"TimeTooLong",
     {{"gravity_m_s2 = 9.81", "max_time_s = 1e155"}},
     "slope.toml:4: [analysis]: max_time_s is 1e+155 (expected more than 0, up to 1e6)"},
    {"StepsTooShort",
     {{"gravity_m_s2 = 9.81", "max_timestep_s = 1e-9"}},
     "slope.toml:4: [analysis]: max_timestep_s is 1e-09 (one slide would take billions of such steps; expected 1e-4 to "
     "1e6)"},
    {"MassTooLarge",
     {{"mass_kg = 1000", "mass_kg = 1e200"}},
     "slope.toml:25: seeder \"Crest\": mass_kg is 1e+200 (no rock is that heavy; expected 1e-9 to 1e12)"},
    {"VelocityTooLarge",
     {{"mass_kg = 1000", "mass_kg = 1000\nhorizontal_velocity_m_s = 1e160"}},
     "slope.toml:26: seeder \"Crest\": horizontal_velocity_m_s is 1e+160 (no rock falls that fast; expected -10000 to "
     "10000)"},
};

INSTANTIATE_TEST_SUITE_P(All, BadValues, testing::ValuesIn(bad_values), name_of_case<BadProject>);

TEST(BadProject, NoWarningDependsOnARefusedValue) {
  const std::string bad_mass = R"(mass_kg = { mean = 1000, distribution = "normal", std_dev = -1 })";
  EXPECT_EQ(refusal_of_reading(changed({{"mass_kg = 1000", bad_mass}, {"rocks = 10", "rocks = 500"}})),
            "slope.toml:25: seeder \"Crest\": mass_kg std_dev is -1 (a standard deviation cannot be negative; expected "
            "0 or more). Did you mean 1?");
}

TEST(BadProject, WarningsAreListedWithErrors) {
  EXPECT_EQ(refusal_of_reading(changed({{"mass_kg = 1000", "mass_kg = 2"}, {"rocks = 10", "rocks = 0"}})),
            "slope.toml:24: seeder \"Crest\": rocks is 0 (a seeder without rocks does nothing; expected 1 to 1e12)\n"
            "slope.toml:25: warning: seeder \"Crest\": mass_kg is 2 (masses are in kilograms, and this stone would fit "
            "in a hand). If it is in tonnes, write 2000");
}

}  // namespace
}  // namespace talus::project
