// The echo of projects: every key is read into its member and written back.

#include "talus/project/echo.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "project/sample_projects.hpp"

namespace talus::project {
namespace {

using Json = nlohmann::ordered_json;

/// Calls `visit(table, setting, given value, echoed value)` for every key that a sample gives.
template <class Visit>
void for_given_keys(const char* sample, Visit visit) {
  const Json given = as_json(sample), echoed = echo(read_sample(sample));
  for (const Table& table : tables()) {
    Json given_rows = Json::array(), echoed_rows = Json::array();
    if (table.key.empty()) {
      given_rows.push_back(given);
      echoed_rows.push_back(echoed);
    } else if (given.contains(table.key)) {
      given_rows = table.repeated ? given.at(std::string(table.key)) : Json::array({given.at(std::string(table.key))});
      echoed_rows =
          table.repeated ? echoed.at(std::string(table.key)) : Json::array({echoed.at(std::string(table.key))});
    }
    ASSERT_EQ(given_rows.size(), echoed_rows.size());
    for (std::size_t i = 0; i < given_rows.size(); ++i) {
      for (const Setting& setting : table.settings) {
        const std::string key(setting.key);
        if (given_rows[i].contains(key)) visit(table, setting, given_rows[i][key], echoed_rows[i].value(key, Json()));
      }
    }
  }
}

TEST(Settings, EveryKeyIsReadIntoItsMemberAndEchoed) {
  std::set<std::string> seen;
  for (const char* sample : samples) {
    for_given_keys(sample, [&](const Table& table, const Setting& setting, const Json& given, Json echoed) {
      if (given.is_number() && echoed.is_object()) echoed = echoed["mean"];
      // The order of keys is irrelevant.
      EXPECT_EQ(nlohmann::json(given), nlohmann::json(echoed)) << row_name(table, setting);
      const auto initial = default_of(table, setting);
      if (!initial || given != *initial) seen.insert(row_name(table, setting));
    });
  }
  for (const Table& table : tables()) {
    for (const Setting& setting : table.settings) {
      EXPECT_TRUE(seen.contains(row_name(table, setting)))
          << row_name(table, setting) << " has no value other than its default in any sample";
    }
  }
}

TEST(Settings, EveryKeyOfADistributionIsRead) {
  std::set<std::string> seen;
  for_given_keys(in_2d, [&](const Table&, const Setting&, const Json& given, const Json&) {
    if (!given.is_object()) return;
    for (const auto& [key, value] : given.items()) seen.insert(key);
  });
  for (const Setting& setting : distribution_table().settings) EXPECT_TRUE(seen.contains(std::string(setting.key)));
}

TEST(Echo, ReadsBackAsTheSameProject) {
  for (const char* sample : samples) {
    const Json once = echo(read_sample(sample));
    EXPECT_EQ(once, echo(read_sample(text_of_echo(once)))) << once.dump(2);
  }
}

TEST(Echo, KeepsEveryBitOfANumber) {
  const double odd = 0.1 + 0.2;
  Project project = read_sample(in_2d);
  project.analysis.gravity_m_s2 = odd;
  project.sampling.seed = 18446744073709551615u;
  const Json back = Json::parse(echo(project).dump());
  EXPECT_EQ(back["analysis"]["gravity_m_s2"].get<double>(), odd);
  EXPECT_EQ(back["sampling"]["seed"].get<std::uint64_t>(), project.sampling.seed);
}

TEST(Echo, WritesAnInfiniteCapacityAsText) {
  EXPECT_EQ(echo(read_sample(inline_mesh))["barrier"][0]["capacity_kJ"], "inf");
}

TEST(Echo, OmitsTheMassIfTheSizeIsGiven) {
  const Json seeders = echo(read_sample(inline_mesh))["seeder"];
  EXPECT_FALSE(seeders[0].contains("mass_kg"));
  EXPECT_FALSE(seeders[0].contains("horizontal_velocity_m_s"));
  EXPECT_TRUE(seeders[1].contains("horizontal_velocity_m_s"));
}

}  // namespace
}  // namespace talus::project
