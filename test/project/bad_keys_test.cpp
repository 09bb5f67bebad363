// Project files that are not TOML, and unknown or misplaced keys: the exact text of each error.

#include <gtest/gtest.h>

#include <vector>

#include "project/bad_project.hpp"

namespace talus::project {
namespace {

class BadKeys : public BadProjectTest {};

TEST_P(BadKeys, AreRefusedWithThisText) {
  EXPECT_EQ(refusal_of_reading(changed(GetParam().replacements)), GetParam().message);
}

const std::vector<BadProject> bad_keys{
    {"SyntaxError",
     {{"rocks = 10", "rocks 10"}},
     "slope.toml:24: this is not TOML (Error while parsing key-value pair: expected '=', saw '1')"},
    {"DuplicateKey",
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
     {{section, R"(raster = "C:\data\dem.tif")"}},
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
     "slope.toml:25: seeder \"Crest\": unknown key \"height_m\". It belongs to [[forest]], [[barrier]] and "
     "[[collector]]"},
    {"UnknownKeyLikeNoOther",
     {{"gravity_m_s2 = 9.81", "wind = 3"}},
     "slope.toml:4: [analysis]: unknown key \"wind\" (expected one of laws, model, rotation, gravity_m_s2, sliding, "
     "max_timestep_s, normal_velocity_cutoff_m_s, grazing_angle_deg, stopped_velocity_m_s, max_steps, max_time_s, "
     "energy_datum_m, friction_angle, roughness_law, scale_rn_by_velocity, rn_velocity_scale_m_s, scale_rn_by_mass, "
     "rn_mass_scale_kg, tangential_crsp_damping or rolling_resistance_in_impacts)"},
    {"UnknownTable",
     {{"[analysis]", "[analisys]"}},
     "slope.toml:3: unknown table [analisys]. Did you mean [analysis]?"},
    {"UnknownTableLikeNoOther",
     {{R"([analysis]
gravity_m_s2 = 9.81)",
       R"([weather]
wind = 3)"}},
     "slope.toml:3: unknown table [weather] (expected one of name, analysis, sampling, terrain, material, ground, "
     "area, forest, shape, seeder, barrier, collector, kit, design, output, report or layer)"},
    {"UnknownKeyBeforeTheFirstTable",
     {{R"(name = "Slope")", R"(titel = "Slope")"}},
     "slope.toml:1: unknown key \"titel\" (expected one of name, analysis, sampling, terrain, material, ground, area, "
     "forest, shape, seeder, barrier, collector, kit, design, output, report or layer)"},
    {"TableOnceInsteadOfList",
     {{"[[barrier]]", "[barrier]"}},
     "slope.toml:27: [barrier] is a single table (there may be several; expected [[barrier]])"},
    {"ListInsteadOfTable",
     {{"[analysis]", "[[analysis]]"}},
     "slope.toml:3: [[analysis]] is a list of tables (expected one table, [analysis])"},
    {"TableIsANumber",
     {{R"(name = "Slope")", "output = 3"}},
     "slope.toml:1: output is 3 (expected one table, [output])"},
    {"EntryIsNotATable",
     {{R"(name = "Slope")", "collector = [3]"}},
     "slope.toml:1: collector[0] is 3 (expected a table [[collector]])"},
};

INSTANTIATE_TEST_SUITE_P(All, BadKeys, testing::ValuesIn(bad_keys), name_of_case<BadProject>);

TEST(BadProject, TheUnchangedOneIsGood) {
  EXPECT_EQ(refusal_of_reading(good_project), "");
  EXPECT_EQ(read_project_text(good_project, "slope.toml").warnings.text(), "");
}

TEST(BadProject, AnEmptyTextLacksTheRequiredTables) {
  EXPECT_EQ(refusal_of_reading(""),
            "slope.toml: [terrain] is missing (a project needs it)\n"
            "slope.toml: [[material]] is missing (a project needs at least one)\n"
            "slope.toml: [[seeder]] is missing (a project needs at least one)");
}

}  // namespace
}  // namespace talus::project
