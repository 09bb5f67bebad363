// The declaration of the settings: complete, consistent, and with limits for all numbers.

#include "talus/project/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "project/sample_projects.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/schema.hpp"
#include "talus/project/schema_module.hpp"

namespace talus::project {
namespace {

using Json = nlohmann::ordered_json;

TEST(Settings, NoTwoKeysFillOneMember) {
  for (const Table& table : tables()) {
    Project project;
    const Row row = table.add(project);
    std::map<const void*, std::string> owners;
    for (const Setting& setting : table.settings) {
      const void* member = std::visit(
          [](auto slot) -> const void* {
            if constexpr (std::is_pointer_v<decltype(slot)>) return slot;
            return nullptr;  // position and points share a member on purpose, as do the sizes
          },
          setting.slot(row));
      if (!member) continue;
      const auto [owner, is_first] = owners.emplace(member, row_name(table, setting));
      EXPECT_TRUE(is_first) << row_name(table, setting) << " fills the member of " << owner->second;
    }
  }
}

TEST(Settings, EveryKeyIsDocumented) {
  const auto expect_documented = [](const Table& table) {
    EXPECT_FALSE(table.meaning.empty()) << table.key;
    for (const Setting& setting : table.settings) {
      const std::string name = row_name(table, setting);
      EXPECT_FALSE(setting.source.empty()) << name;
      ASSERT_FALSE(setting.meaning.empty()) << name;
      EXPECT_EQ(setting.meaning.back(), '.') << name;
      EXPECT_TRUE(setting.required || !setting.without_it.empty() || default_of(table, setting))
          << name << " has no default and no text about it";
      EXPECT_FALSE(setting.required && !setting.without_it.empty()) << name;
    }
  };
  for (const Table& table : tables()) expect_documented(table);
  expect_documented(distribution_table());
}

TEST(Settings, UnitsAgreeWithTheNamesOfTheKeys) {
  // Endings of keys and their units; longer endings first.
  const std::vector<std::pair<std::string, std::string>> endings{
      {"_kg_m3", "kg/m3"}, {"_deg_s", "deg/s"}, {"_m_s2", "m/s2"}, {"_m_s", "m/s"}, {"_kg_s", "kg/s"},
      {"_per_s", "1/s"},   {"_per_m", "1/m"},   {"_deg", "deg"},   {"_kg", "kg"},   {"_kJ", "kJ"},
      {"_m3", "m3"},       {"_m", "m"},         {"_s", "s"}};
  for (const Table& table : tables()) {
    for (const Setting& setting : table.settings) {
      for (const auto& [ending, unit] : endings) {
        if (!setting.key.ends_with(ending)) continue;
        EXPECT_EQ(setting.unit, unit) << row_name(table, setting);
        break;
      }
    }
  }
}

TEST(Settings, ExclusionsAreMutualAndKnown) {
  for (const Table& table : tables()) {
    for (const Setting& setting : table.settings) {
      for (const std::string_view other : table.excluded_by(setting.key)) {
        const Setting* excluded = table.find(other);
        ASSERT_NE(excluded, nullptr) << row_name(table, setting) << " excludes " << other;
        const auto back = table.excluded_by(other);
        EXPECT_NE(std::find(back.begin(), back.end(), setting.key), back.end())
            << row_name(table, setting) << " and " << other;
      }
    }
  }
}

TEST(Settings, DefaultsLieInTheirRanges) {
  for (const Table& table : tables()) {
    for (const Setting& setting : table.settings) {
      auto value = default_of(table, setting);
      if (value && value->is_object()) value = (*value)["mean"];
      if (value && value->is_number()) {
        EXPECT_TRUE(setting.range.contains(value->get<double>())) << row_name(table, setting);
      }
    }
  }
}

TEST(Settings, RangesAreInPlainWords) {
  EXPECT_EQ((Range{}).text(), "any number");
  EXPECT_EQ((Range{.least = 0}).text(), "0 or more");
  EXPECT_EQ((Range{.least = 0, .least_excluded = true}).text(), "more than 0");
  EXPECT_EQ((Range{.least = 0, .most = 1}).text(), "0 to 1");
  EXPECT_EQ((Range{.least = 0, .most = 90, .most_excluded = true}).text(), "0 to less than 90");
  EXPECT_EQ((Range{.least = -90, .most = 90, .least_excluded = true, .most_excluded = true}).text(),
            "more than -90, less than 90");
  EXPECT_EQ((Range{.least = 1e-9, .most = 1e12}).text(), "1e-9 to 1e12");
  EXPECT_EQ((Range{.least = -1e9, .most = 123456789}).text(), "-1e9 to 123456789");
  EXPECT_EQ((Range{.least = 0.01, .most = 10000}).text(), "0.01 to 10000");
}

/// Whether a slot holds numbers.
struct IsNumber {
  template <class Member>
  bool operator()(const Member&) const {
    return false;
  }
  bool operator()(double*) const { return true; }
  bool operator()(std::optional<double>*) const { return true; }
  bool operator()(std::int64_t*) const { return true; }
  bool operator()(std::optional<std::int64_t>*) const { return true; }
  bool operator()(std::uint64_t*) const { return true; }
  bool operator()(Distribution*) const { return true; }
  bool operator()(std::optional<Distribution>*) const { return true; }
  bool operator()(std::array<double, 3>*) const { return true; }
  bool operator()(std::vector<double>*) const { return true; }
  bool operator()(std::vector<std::int64_t>*) const { return true; }
  bool operator()(std::vector<std::array<double, 2>>*) const { return true; }
  bool operator()(std::vector<std::array<double, 3>>*) const { return true; }
  bool operator()(std::vector<std::array<std::int64_t, 3>>*) const { return true; }
  bool operator()(std::vector<std::vector<std::array<double, 3>>>*) const { return true; }
  bool operator()(PositionSlot) const { return true; }
  bool operator()(PointsSlot) const { return true; }
  bool operator()(PlanLineSlot) const { return true; }
  bool operator()(PlanPolygonSlot) const { return true; }
  bool operator()(SizeSlot) const { return true; }
  bool operator()(DirectionSlot) const { return true; }
  bool operator()(LimitSlot) const { return true; }
  bool operator()(MapCellSlot) const { return true; }
};

// Values beyond any real case are refused, so that no result overflows.
TEST(Settings, AllNumbersHaveLimits) {
  const std::set<std::string> without_need{
      "sampling.seed",     "ground.triangles",     "terrain.triangles",  // whole numbers, or checked as places
      "terrain.vertices",  "terrain.polylines",    "barrier.line",         "collector.line",
      "area.polygon",      "forest.polygon",       "seeder.polygon",       "shape.polygon",
      "distribution.mean", "distribution.std_dev", "distribution.rel_min", "distribution.rel_max"};
  std::set<std::string> without;
  const auto check = [&](const Table& table) {
    Project blank;
    Distribution distribution;
    for (const Setting& setting : table.settings) {
      const Slot slot = setting.slot(table.add ? table.add(blank) : Row(&distribution));
      const bool is_number = std::visit(IsNumber{}, slot);
      if (is_number && !std::isfinite(setting.range.most)) {
        without.insert(std::string(table.key) + "." + std::string(setting.key));
      }
    }
  };
  for (const Table& table : tables()) check(table);
  check(distribution_table());
  EXPECT_EQ(without, without_need);
}

TEST(Settings, BoundsOfDrawsAreTheRanges) {
  EXPECT_EQ(bounds("material", "normal_restitution").least, 0);
  EXPECT_EQ(bounds("material", "normal_restitution").most, 1);
  EXPECT_EQ(bounds("material", "dynamic_friction").least, 0);
  EXPECT_EQ(bounds("material", "dynamic_friction").most, 1e6);
  EXPECT_EQ(bounds("seeder", "horizontal_velocity_m_s").least, -1e4);
  EXPECT_EQ(bounds(Range{}).least, Bounds{}.least);
  EXPECT_EQ(bounds(Range{}).most, Bounds{}.most);
}

TEST(Settings, BelongToTheGroupsOfTheirTable) {
  std::size_t grouped = 0;
  for (const Table& table : tables()) {
    std::set<std::string_view> known;
    for (const Group& group : table.groups) EXPECT_TRUE(known.insert(group.title).second) << table.key;
    for (const Setting& setting : table.settings) {
      grouped += setting.group.empty() ? 0 : 1;
      EXPECT_TRUE(setting.group.empty() || known.contains(setting.group)) << row_name(table, setting);
    }
  }
  EXPECT_GT(grouped, 80U);
}

Json schema_of(const Table& table, const Setting& setting) {
  const Json all = schema();
  if (table.key.empty()) return all["properties"][std::string(setting.key)];
  const Json found = all["properties"][std::string(table.key)];
  return (table.repeated ? found["items"] : found)["properties"][std::string(setting.key)];
}

TEST(ConditionsOfSettings, AreThoseOfTheReport) {
  const std::string script = report_settings();
  const std::size_t begin = script.find('{', script.find("const settingConditions = ")),
                    end = script.find(";\n", begin);
  const auto embedded = nlohmann::json::parse(script.substr(begin, end - begin));
  std::size_t compared = 0;
  for (const Table& table : tables()) {
    if (table.key.empty()) continue;
    for (const Setting& setting : table.settings) {
      const Json declared = schema_of(table, setting);
      const auto& of_table = embedded.at(std::string(table.key));
      const bool has_conditions = declared.contains("x-applies-when");
      ASSERT_EQ(of_table.contains(std::string(setting.key)), has_conditions) << row_name(table, setting);
      if (!has_conditions) continue;
      EXPECT_EQ(of_table.at(std::string(setting.key)), nlohmann::json::parse(declared["x-applies-when"].dump()))
          << row_name(table, setting);
      ++compared;
    }
  }
  EXPECT_GT(compared, 50U);
}

TEST(DefaultsOfSettings, AreThoseOfTheReport) {
  const std::string script = report_settings();
  const std::size_t begin = script.find('{', script.find("const settingDefaults = ")), end = script.find(";\n", begin);
  const auto embedded = nlohmann::json::parse(script.substr(begin, end - begin));
  std::size_t compared = 0;
  for (const Table& table : tables()) {
    if (table.key.empty()) continue;
    const auto& of_table = embedded.at(std::string(table.key));
    for (const Setting& setting : table.settings) {
      const Json declared = schema_of(table, setting);
      ASSERT_EQ(of_table.contains(std::string(setting.key)), declared.contains("default")) << row_name(table, setting);
      if (!declared.contains("default")) continue;
      EXPECT_EQ(of_table.at(std::string(setting.key)), nlohmann::json::parse(declared["default"].dump()))
          << row_name(table, setting);
      ++compared;
    }
  }
  EXPECT_GT(compared, 50U);
}

// A condition on an unknown setting, or on a word that the setting does not have, would never be true.
TEST(Settings, ConditionsNameSettingsAndTheirWords) {
  std::size_t seen = 0;
  for (const Table& table : tables()) {
    for (const Setting& setting : table.settings) {
      for (const Need& need : setting.applies_when) {
        ASSERT_FALSE(need.any_of.empty()) << row_name(table, setting);
        for (const auto& [key, kind, values] : need.any_of) {
          ++seen;
          const std::size_t dot = key.find('.');
          const std::string_view other = dot == std::string_view::npos ? table.key : key.substr(0, dot);
          const auto home = std::ranges::find(tables(), other, &Table::key);
          ASSERT_NE(home, tables().end()) << row_name(table, setting) << ": " << key;
          const Setting* subject = home->find(dot == std::string_view::npos ? key : key.substr(dot + 1));
          ASSERT_NE(subject, nullptr) << row_name(table, setting) << ": " << key;
          EXPECT_TRUE(dot == std::string_view::npos || !home->repeated) << key;
          const bool compares_words = kind == Condition::Kind::one_of || kind == Condition::Kind::none_of;
          EXPECT_EQ(compares_words, !values.empty()) << row_name(table, setting) << ": " << key;
          const Json node = schema_of(*home, *subject);
          if (!node.contains("enum")) continue;
          for (const std::string_view value : values) {
            EXPECT_NE(std::ranges::find(node["enum"], Json(value)), node["enum"].end()) << key << " = " << value;
          }
        }
      }
    }
  }
  EXPECT_GT(seen, 60U);
}

}  // namespace
}  // namespace talus::project
