// Commands that run no rocks.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace talus {
namespace {

using namespace test;
using ::testing::HasSubstr;

TEST(TalusNew, WritesAProjectThatRuns) {
  const Workplace place;
  const std::string file = (place / "slope.toml").string(), out = (place / "out").string();
  const Said said = talus_says("new " + file);
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_THAT(said.text, HasSubstr("`talus run " + file + "`"));
  const Said checked = talus_says("check " + file);
  EXPECT_EQ(checked.exit_code, 0) << checked.text;
  EXPECT_EQ(talus_says("run " + file + " -o " + out).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(out + "/report.html"));

  EXPECT_EQ(talus_says("new " + file).exit_code, 2) << "it already exists";
  EXPECT_EQ(talus_says("new --force " + file).exit_code, 0);
}

TEST(TalusNew, RefusesAnImpossibleFileName) {
  const Workplace place;
  const Said said = talus_says("new " + (place / std::string(300, 'a')).string() + ".toml");
  EXPECT_EQ(said.exit_code, 2) << said.text;
  EXPECT_THAT(said.text, HasSubstr("cannot create this file"));
}

TEST(TalusMaterials, ListsTheLibraryWithItsSources) {
  const Said said = talus_says("materials");
  EXPECT_EQ(said.exit_code, 0);
  for (const char* part :
       {"bedrock_outcrops", "talus_cover", "Rn", "mu_r", "[1] T. J. Pfeiffer", "0.37 to 0.67 [", "Kirkby"})
    EXPECT_THAT(said.text, HasSubstr(part));
}

TEST(TalusSchema, IsJsonWithEveryTable) {
  const auto schema = nlohmann::json::parse(talus_says("schema").text);
  for (const char* table : {"analysis", "terrain", "material", "seeder", "barrier", "output"}) {
    EXPECT_TRUE(schema.at("properties").contains(table)) << table;
  }
}

}  // namespace
}  // namespace talus
