// Sets of factors: those of the program, what a project makes of them, and the exact text of refusals.

#include "talus/project/factor_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "cli/program.hpp"
#include "support/projects.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using testing::HasSubstr;

constexpr const char* own_set = R"(name = "Canton"
title = "Guideline of the canton"
design_percentile = 99
upper_clearance_m = 1
[[source]]
key = "us"
text = "Our office"
checked = "All of it"
[[factor]]
key = "rock"
symbol = "c_1"
multiplies = ["energy", "height"]
value = 1.5
meaning = "For everything"
source = "us"
[[factor]]
key = "risk_factor"
symbol = "c_2"
multiplies = ["energy"]
meaning = "Given by the project"
source = "us"
)";

std::string refusal_of(const std::string& text) {
  try {
    (void)read_factor_set(Document(text, "own.toml"));
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return "";
}

TEST(FactorSets, OfEachStandardAreInTheProgram) {
  std::vector<std::string> names;
  for (const FactorSet& set : factor_sets()) names.push_back(set.name);
  std::ranges::sort(names);
  std::vector<std::string> declared;
  for (const std::string_view standard : words<DesignStandard>()) {
    if (standard != word(DesignStandard::none)) declared.emplace_back(standard);
  }
  std::ranges::sort(declared);
  EXPECT_EQ(names, declared);
}

TEST(FactorSets, HaveEveryKeyOfADesign) {
  for (const std::string_view key : factor_keys) {
    EXPECT_TRUE(table("design").find(key)) << key;
    const bool is_used = std::ranges::any_of(factor_sets(), [&](const FactorSet& set) { return set.find(key); });
    EXPECT_TRUE(is_used) << key;
  }
}

// A value without a source is refused when a set is read. A factor without a value says why.
TEST(FactorSets, SayWhatCouldNotBeRead) {
  for (const FactorSet& set : factor_sets()) {
    EXPECT_FALSE(set.not_read.empty()) << set.name;
    for (const Factor& factor : set.factors) {
      EXPECT_TRUE(factor.value || !factor.not_read.empty()) << set.name << " " << factor.key;
    }
  }
}

TEST(FactorSet, GivesValuesThatTheProjectMayOverride) {
  const FactorSet set = read_factor_set(Document(own_set, "own.toml"));
  EXPECT_EQ(set.name, "Canton");
  EXPECT_EQ(set.design_percentile, 99);
  ASSERT_EQ(set.factors.size(), 2u);
  Design design;
  EXPECT_EQ(value_of(set.factors[0], design), 1.5);
  EXPECT_EQ(value_of(set.factors[1], design), std::nullopt);
  design.risk_factor = 1.25;
  EXPECT_EQ(value_of(set.factors[1], design), 1.25);
}

TEST(FactorSet, IsRefusedWithAllProblemsAtOnce) {
  EXPECT_EQ(refusal_of(own_set), "");
  const std::string empty = refusal_of("name = \"Empty\"\n");
  EXPECT_THAT(empty, HasSubstr("title is missing"));
  EXPECT_THAT(empty, HasSubstr("[[source]] is missing (a set of factors needs at least one)"));
  EXPECT_THAT(empty, HasSubstr("[[factor]] is missing (a set of factors needs at least one)"));
  EXPECT_EQ(refusal_of(R"(name = "Wrong"
title = "Wrong"
desing_percentile = 95
[[source]]
key = "us"
text = "Our office"
checked = "All of it"
[[factor]]
key = "mass"
symbol = "c"
multiplies = ["mas", "volume"]
value = 0.9
meaning = "Of the mass"
source = "use"
[[factor]]
key = "ours"
symbol = "c"
multiplies = ["energy"]
meaning = "Without a value"
source = "us"
[[factor]]
key = "ours"
symbol = "c"
multiplies = ["energy"]
value = 1
meaning = "Again"
source = "us"
)"),
            "own.toml:3: unknown key \"desing_percentile\". Did you mean design_percentile?\n"
            "own.toml:8: factor \"mass\": multiplies \"mas\" (a factor can multiply velocity, height, mass, energy, "
            "capacity, elongation). Did you mean \"mass\"?\n"
            "own.toml:8: factor \"mass\": multiplies \"volume\" (a factor can multiply velocity, height, mass, energy, "
            "capacity, elongation)\n"
            "own.toml:8: factor \"mass\": source is \"use\" (no [[source]] has this key; the set has \"us\"). Did you "
            "mean \"us\"?\n"
            "own.toml:12: factor 1: value is 0.9 (a safety factor cannot be less than 1; expected 1 to 1e6)\n"
            "own.toml:15: factor \"ours\": value is missing ([design] has no key of this name, so the project cannot "
            "give it)\n"
            "own.toml:21: two factors have the key \"ours\" (the first begins in line 15). Give each its own key");
}

/// A folder with a set of factors, unless it is empty, and a project that names it.
std::string problems_with_file(const test::Workplace& work, const std::string& set, const std::string& more = "") {
  std::filesystem::remove(work / "own.toml");
  if (!set.empty()) work.write("own.toml", set);
  const std::string project = work.write("slope.toml", R"([terrain]
section = [[0, 0], [30, -20]]
[[material]]
name = "Rock"
[[seeder]]
position = [1, 5]
mass_kg = 1000
[[collector]]
line = 20
height_m = 5
[design]
standard_file = "own.toml"
)" + more);
  std::string text;
  try {
    text = read_project(project).warnings.text();
  } catch (const BadInput& bad) {
    text = bad.problems().text();
  }
  for (std::size_t at; (at = text.find(project)) != std::string::npos;) text.replace(at, project.size(), "slope.toml");
  const std::string folder = (work / "").string();
  for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
  return text;
}

TEST(FactorSet, MayBeAFileBesideTheProject) {
  const test::Workplace work;
  EXPECT_EQ(problems_with_file(work, own_set, "risk_factor = 1.2\n"), "");
  EXPECT_EQ(
      problems_with_file(work, own_set),
      "slope.toml:11: [design]: risk_factor is missing (Canton needs c_2, and has no value for it: it is an input). "
      "Take it from the edition that binds you");
  EXPECT_THAT(problems_with_file(work, "name = 3\n"),
              HasSubstr("slope.toml:12: [design]: standard_file own.toml:1: name is 3 (expected a text in quotes)"));
  EXPECT_THAT(problems_with_file(work, "= what\n"),
              HasSubstr("slope.toml:12: [design]: standard_file own.toml:1: this is not TOML"));
  EXPECT_EQ(
      problems_with_file(work, ""),
      "slope.toml:12: [design]: standard_file is \"own.toml\" (there is no such file). The path is relative to "
      "the project file");
}

}  // namespace
}  // namespace talus::project
