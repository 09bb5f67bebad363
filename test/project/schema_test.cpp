// The JSON Schema, the reference page and the TypeScript module, which are generated from the declaration of the
// settings.

#include "talus/project/schema.hpp"
#include "support/places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include "project/sample_projects.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/reference.hpp"
#include "talus/project/schema_module.hpp"
#include "talus/project/starter.hpp"

namespace talus::project {
namespace {

using Json = nlohmann::ordered_json;

/// The first rule of the schema that a value breaks, for the subset of JSON Schema in use; "" if none.
std::string broken_rule(const Json& schema, const Json& value, const std::string& path) {
  if (schema.contains("anyOf")) {
    std::string all;
    for (const Json& choice : schema["anyOf"]) {
      const std::string broken = broken_rule(choice, value, path);
      if (broken.empty()) return "";
      all += broken + "; ";
    }
    return all;
  }
  if (schema.contains("const") && schema["const"] != value) return path + " is not the constant";
  if (schema.contains("enum")) {
    const Json& words = schema["enum"];
    return std::find(words.begin(), words.end(), value) == words.end() ? path + " is not in the list" : "";
  }
  const std::string type = schema.value("type", "");
  const bool fits = type.empty() || (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
                    (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
                    (type == "integer" && value.is_number_integer()) || (type == "number" && value.is_number());
  if (!fits) return path + " is not of type " + type;
  if (value.is_number()) {
    const double number = value.get<double>();
    if (schema.contains("minimum") && number < schema["minimum"].get<double>()) return path + " is too small";
    if (schema.contains("maximum") && number > schema["maximum"].get<double>()) return path + " is too large";
    if (schema.contains("exclusiveMinimum") && number <= schema["exclusiveMinimum"].get<double>()) {
      return path + " is too small";
    }
    if (schema.contains("exclusiveMaximum") && number >= schema["exclusiveMaximum"].get<double>()) {
      return path + " is too large";
    }
  }
  if (value.is_array()) {
    if (value.size() < schema.value("minItems", std::size_t{0})) return path + " is too short";
    if (value.size() > schema.value("maxItems", value.size())) return path + " is too long";
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string broken = broken_rule(schema["items"], value[i], path + '[' + std::to_string(i) + ']');
      if (!broken.empty()) return broken;
    }
  }
  if (value.is_object()) {
    for (const auto& [key, item] : value.items()) {
      const bool is_named = schema.contains("properties") && schema["properties"].contains(key);
      const Json& others = schema["additionalProperties"];
      if (!is_named && !others.is_object()) return path + '.' + key + " is unknown";
      const std::string broken = broken_rule(is_named ? schema["properties"][key] : others, item, path + '.' + key);
      if (!broken.empty()) return broken;
    }
    for (const Json& key : schema.value("required", Json::array())) {
      if (!value.contains(key.get<std::string>())) return path + '.' + key.get<std::string>() + " is missing";
    }
  }
  return "";
}

TEST(Schema, AcceptsWhatTheReaderAccepts) {
  for (const char* sample : samples) EXPECT_EQ(broken_rule(schema(), as_json(sample), ""), "");
  EXPECT_EQ(broken_rule(schema(), as_json(starter().c_str()), ""), "");
}

TEST(Schema, RefusesWhatTheReaderRefuses) {
  const auto broken = [](auto change) {
    Json project = as_json(in_2d);
    change(project);
    return broken_rule(schema(), project, "");
  };
  EXPECT_EQ(broken([](Json& p) { p["analysis"]["gravity"] = 9.81; }), ".analysis.gravity is unknown");
  EXPECT_EQ(broken([](Json& p) { p["analysis"]["gravity_m_s2"] = -9.81; }), ".analysis.gravity_m_s2 is too small");
  EXPECT_EQ(broken([](Json& p) { p["analysis"]["model"] = "cube"; }), ".analysis.model is not in the list");
  EXPECT_EQ(broken([](Json& p) { p["seeder"][0]["rocks"] = 0; }), ".seeder[0].rocks is too small");
  EXPECT_EQ(broken([](Json& p) { p["seeder"] = Json::array(); }), ".seeder is too short");
  EXPECT_EQ(broken([](Json& p) { p.erase("terrain"); }), ".terrain is missing");
  EXPECT_EQ(broken([](Json& p) { p["barrier"][0].erase("height_m"); }), ".barrier[0].height_m is missing");
  EXPECT_EQ(broken([](Json& p) { p["collector"][0]["capacity_kJ"] = 5; }), ".collector[0].capacity_kJ is unknown");
  EXPECT_NE(broken([](Json& p) { p["material"][0]["normal_restitution"] = 1.3; }), "");
  EXPECT_NE(broken([](Json& p) { p["material"][0]["normal_restitution"]["mean"] = 1.3; }), "");
}

TEST(Schema, HasEverySettingWithItsDefault) {
  const Json whole = schema();
  for (const Table& table : tables()) {
    const Json* place = &whole;
    if (!table.key.empty()) place = &whole["properties"][std::string(table.key)];
    if (table.repeated) place = &(*place)["items"];
    for (const Setting& setting : table.settings) {
      const Json& property = (*place)["properties"][std::string(setting.key)];
      EXPECT_EQ(property["description"], meaning_of(setting)) << row_name(table, setting);
      const auto value = default_of(table, setting);
      if (!value || !setting.without_it.empty() || *value == "inf") continue;
      EXPECT_EQ(property["default"], *value) << row_name(table, setting);
      EXPECT_EQ(broken_rule(property, property["default"], ""), "") << row_name(table, setting);
    }
  }
}

TEST(Schema, SaysWhenSettingsApply) {
  const Json terrain = schema()["properties"]["terrain"];
  EXPECT_EQ(terrain["properties"]["boundary"]["x-applies-when"],
            Json::parse(R"([[{"key": "points", "given": true}, {"key": "lines", "given": true}]])"));
  const Json analysis = schema()["properties"]["analysis"]["properties"];
  EXPECT_EQ(analysis["rn_mass_scale_kg"]["x-applies-when"],
            Json::parse(R"([[{"key": "scale_rn_by_mass", "is": ["true"]}]])"));
  EXPECT_EQ(analysis["rn_mass_scale_kg"]["x-group"], "Restitution");
  EXPECT_EQ(analysis["model"]["x-topic"]["heading"], "Which model?");
}

TEST(ReferencePage, NamesEverySettingAndItsMeaning) {
  const std::string page = reference_page();
  const auto expect_named = [&](const Table& table) {
    for (const Setting& setting : table.settings) {
      EXPECT_NE(page.find("| `" + std::string(setting.key) + "` |"), std::string::npos) << row_name(table, setting);
      // That paths are relative to the project file the page says once; bars are escaped in a table.
      std::string meaning(setting.meaning);
      for (const char* once :
           {" The path is relative to the project file.", " Paths are relative to the project file."})
        meaning = std::regex_replace(meaning, std::regex(once), "");
      meaning = std::regex_replace(meaning, std::regex(R"(\|)"), R"(\|)");
      EXPECT_NE(page.find(meaning), std::string::npos) << row_name(table, setting);
    }
  };
  for (const Table& table : tables()) expect_named(table);
  expect_named(distribution_table());
}

TEST(SettingsOfOneRockModel, AreMarkedInTheSchemaAndTheReference) {
  const Json materials = schema()["properties"]["material"]["items"]["properties"];
  EXPECT_EQ(materials["rolling_friction"]["x-applies-when"],
            Json::parse(R"([[{"key": "analysis.model", "is": ["rigid_sphere", "rigid_body"]}]])"));
  EXPECT_EQ(materials["friction_angle_deg"]["x-applies-when"],
            Json::parse(R"([[{"key": "analysis.model", "is": ["lumped_mass"]}]])"));
  EXPECT_FALSE(materials["normal_restitution"].contains("x-applies-when"));
  EXPECT_EQ(materials["friction_angle_deg"]["description"], "Lumped mass: phi, the friction angle of sliding.");
  EXPECT_NE(reference_page().find("Rigid sphere and body: mu, the coefficient of friction while the contact slips."),
            std::string::npos);
}

void expect_fresh(const std::string& name, const std::string& made) {
  const std::string file = talus::places::in_source(name);
  if (std::getenv("TALUS_RENEW_REFERENCE")) std::ofstream(file) << made;
  std::ifstream stream(file);
  ASSERT_TRUE(stream) << file;
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_TRUE(text.str() == made) << name << " is out of date; run this test with TALUS_RENEW_REFERENCE=1";
}

TEST(ReferencePage, IsNotStale) { expect_fresh("/docs/project-file.md", reference_page()); }

TEST(SchemaModule, IsNotStale) { expect_fresh("/web/src/generated/schema.ts", schema_module()); }

TEST(ReportSettings, IsNotStale) { expect_fresh("/web/src/generated/reportSettings.ts", report_settings()); }

}  // namespace
}  // namespace talus::project
