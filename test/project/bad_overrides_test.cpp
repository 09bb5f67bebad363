// Errors in `--set` and other options that override the file: the exact text of each.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "project/bad_project.hpp"

namespace talus::project {
namespace {

struct BadOverride {
  const char* name;
  std::vector<std::string> settings;
  std::string message;
};

void PrintTo(const BadOverride& bad, std::ostream* out) { *out << bad.name; }

class BadOverrides : public testing::TestWithParam<BadOverride> {};

TEST_P(BadOverrides, AreRefusedWithThisText) {
  EXPECT_EQ(refusal_of_reading(good_project, {.settings = GetParam().settings, .rocks = {}, .seed = {}}),
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

INSTANTIATE_TEST_SUITE_P(All, BadOverrides, testing::ValuesIn(bad_overrides), name_of_case<BadOverride>);

TEST(BadOverride, ZeroRocks) {
  EXPECT_EQ(refusal_of_reading(good_project, {.settings = {}, .rocks = 0, .seed = {}}),
            "--rocks 0: this is not a number of rocks (expected 1 to 1e12)");
}

TEST(BadOverride, ErrorsInOverridesFollowThoseInTheFile) {
  EXPECT_EQ(
      refusal_of_reading(changed({{"height_m = 3", "height_m = 0"}}),
                         {.settings = {"seeder.Crest.rocks=0"}, .rocks = {}, .seed = {}}),
      "slope.toml:30: barrier \"Fence\": height_m is 0 (nothing could hit it; expected more than 0, up to 10000)\n"
      "--set seeder.Crest.rocks=0: seeder \"Crest\": rocks is 0 (a seeder without rocks does nothing; expected 1 to "
      "1e12)");
}

}  // namespace
}  // namespace talus::project
