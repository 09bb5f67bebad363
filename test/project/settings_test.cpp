#include "talus/project/settings.hpp"
#include "talus/project/document.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"
#include "talus/project/reference.hpp"
#include "talus/project/schema.hpp"
#include "talus/project/schema_module.hpp"
#include "talus/project/starter.hpp"
#include "talus/report/page/assets.hpp"

namespace talus::project {
namespace {

using Json = nlohmann::ordered_json;

// Projects that between them have every key, each with another value than its default.

constexpr const char* in_2d = R"(
name = "Other"
[analysis]
model = "rigid_sphere"
rotation = true
gravity_m_s2 = 9.81
sliding = "closed_form"
max_timestep_s = 0.02
normal_velocity_cutoff_m_s = 0.2
grazing_angle_deg = 2
stopped_velocity_m_s = 0.3
max_steps = 20000
max_time_s = 700.5
energy_datum_m = -25
friction_angle = "tangential_restitution"
scale_rn_by_velocity = true
rn_velocity_scale_m_s = 9
scale_rn_by_mass = true
rn_mass_scale_kg = 2000
tangential_crsp_damping = true
[sampling]
seed = 77
method = "latin_hypercube"
materials = "per_rock"
[terrain]
section = [[0, 0.1], [10, -10], [20, -12]]
section_std_dev_m = [[0, 0.5], [0.25, 0.5], [0, 0]]
[[material]]
name = "Rock"
normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 0.03, rel_min = 0.1, rel_max = 0.2 }
tangential_restitution = { mean = 0.8, distribution = "uniform", rel_min = 0.1, rel_max = 0.1 }
friction_angle_deg = { mean = 31, distribution = "lognormal", std_dev = 2 }
roughness_deg = { mean = 2, distribution = "none" }
roughness_spacing_m = 0.5
roughness_amplitude_m = 0.05
dynamic_friction = { mean = 0.6, distribution = "gamma", std_dev = 0.1 }
rolling_friction = { mean = 0.2, distribution = "triangular", rel_min = 0.1, rel_max = 0.1 }
[[material]]
name = "Talus"
[ground]
default = "Talus"
segments = ["Rock", "Talus"]
[[seeder]]
name = "Crest"
type = "point"
position = [1]
height_above_m = 2.5
rocks = 12
mass_kg = { mean = 500, distribution = "exponential" }
density_kg_m3 = { mean = 2600, distribution = "beta", std_dev = 20, rel_min = 100, rel_max = 100 }
horizontal_velocity_m_s = { mean = 1.5, distribution = "normal", std_dev = 0.2 }
vertical_velocity_m_s = { mean = -1, distribution = "none" }
rotational_velocity_deg_s = { mean = 30, distribution = "none" }
direction = [-1, 0]
[[barrier]]
name = "Fence"
line = 15
height_m = 3.5
inclination_deg = 10
capacity_kJ = 500
normal_restitution = 0.1
tangential_restitution = 0.2
[[collector]]
name = "Track"
line = 17
height_m = 5
inclination_deg = -5
[design]
lines = ["Fence"]
protect = "Track"
section_m = 25
percentiles = [10, 97.5]
confidence = 0.9
standard = "none"
design_percentile = 99
trajectory_factor = 1.02
topography_factor = 1.05
volume_factor = 1.02
density_factor = 1.01
risk_factor = 1.2
energy_level = "SEL"
energy_factor = 1.5
energy = "total"
upper_clearance_m = 1
catch_share = 0.99
heights_m = [3, 6]
energies_kJ = [500, 8500.5]
cost_height_exponent = 2
cost_energy_exponent = 0
[output]
endpoints = 30
paths = 3
report = false
)";

constexpr const char* inline_mesh = R"(
[analysis]
rotation = false
[terrain]
vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0.1]]
triangles = [[0, 1, 2]]
rotate_deg = 30
rotate_about = [0, 25, 0]
[[material]]
name = "Rock"
forest_drag_kg_s = 400
forest_height_m = 12
[[material]]
name = "Talus"
forest = "dense"
forest_height_m = 20
ground_drag_per_s = 0.5
[ground]
triangles = [1]
[[seeder]]
type = "line"
points = [[1, 1, "surface"], [1, 2, "surface"]]
volume_m3 = { mean = 0.5, distribution = "none" }
speed_m_s = { mean = 2, distribution = "none" }
direction = [0, 1, -1]
[[seeder]]
position = [1, 1, 5]
diameter_m = { mean = 0.5, distribution = "none" }
[[barrier]]
line = [[15, 0], [15, 50]]
height_m = 3.5
[design]
block_mass_kg = 1200
[output]
paths = "none"
maps = false
maps_by_source = true
raster_cell_m = 2.5
percentiles = [25, 99.9]
geopackage = "all"
vtk = true
)";

constexpr const char* mesh_file = R"(
[terrain]
mesh = "bowl.obj"
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 1
)";

constexpr const char* extruded = R"(
[terrain]
section = [[0, 0], [10, -10]]
width_m = 50
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
)";

constexpr const char* raster_file = R"(
[terrain]
raster = "dem.tif"
[[material]]
name = "Rock"
[[material]]
name = "Scree"
[ground]
default = "Scree"
raster = "ground.tif"
classes = { 1 = "Rock", -2 = "Scree" }
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
[output]
maps = ["reach_share", "energy_total", "velocity"]
raster_cell_m = "terrain"
)";

constexpr const char* survey = R"(
[terrain]
points = "ground.las"
point_classes = [2, 8]
points_layer = "spots"
lines = "lines.gpkg"
lines_layer = "contours"
elevation_attribute = "elev"
boundary = "area.gpkg"
boundary_layer = "slope"
max_edge_m = 25
remove_spikes_m = 4
crs = "EPSG:31287"
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
)";

constexpr const char* inline_polylines = R"(
[terrain]
polylines = [[[0, 0, 0], [10, 0, -5], [0, 10, 0.5], [0, 0, 0]]]
merge_tolerance_m = 0.5
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
)";

constexpr const char* polygon_file = R"(
[terrain]
polygons = "faces.dxf"
polygons_layer = "entities"
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
)";

constexpr const char* from_gis = R"(
[terrain]
mesh = "bowl.obj"
[[material]]
name = "Rock"
like = "bedrock_outcrops"
[[material]]
name = "Scree"
[ground]
polygons = "ground.gpkg"
layer = "2024"
attribute = "kind"
values = { Fels = "Rock", "Schutt, grob" = "Scree" }
[[area]]
name = "fan"
material = "Scree"
polygon = [[0, 0], [5, 0], [5, 5.5]]
[[seeder]]
type = "line"
source = "north face"
lines = "cliff.gpkg"
layer = "edges"
source_attribute = "name"
mass_kg = 10
[[seeder]]
type = "polygon"
polygons = "cliffs.gpkg"
min_slope_deg = 45
cell_m = 5
rocks_per_cell = 3
place = "centre"
mass_kg = 10
[[seeder]]
type = "polygon"
polygon = [[0, 0], [10, 0], [10, 10.5]]
cell_m = 5
mass_kg = 10
[[seeder]]
type = "raster"
max_slope_deg = 60.5
mask = "release.tif"
mask_value = -2
cell_m = 2.5
mass_kg = 10
)";

const std::vector<const char*> samples{survey,    inline_polylines, polygon_file, in_2d,   inline_mesh,
                                       mesh_file, raster_file,      from_gis,     extruded};

Json as_json(const char* toml_text) {
  const toml::table parsed = toml::parse(std::string_view(toml_text));
  std::ostringstream text;
  text << toml::json_formatter(parsed);
  return Json::parse(text.str());
}

Project read(const std::string& text) { return read_project_text(text, "slope.toml").project; }

/// JSON as TOML, for what an echo holds.
std::string as_toml(const Json& value) {
  std::string out;
  if (value == "inf") return "inf";
  if (value.is_object()) {
    for (const auto& [key, item] : value.items()) {
      out += (out.empty() ? "" : ", ") + Json(key).dump() + " = " + as_toml(item);
    }
    return "{ " + out + " }";
  }
  if (value.is_array()) {
    for (const auto& item : value) out += (out.empty() ? "" : ", ") + as_toml(item);
    return '[' + out + ']';
  }
  return value.dump();
}

std::string file_of(const Json& echoed) {
  std::string out;
  for (const auto& [key, value] : echoed.items()) out += key + " = " + as_toml(value) + '\n';
  return out;
}

std::string row_name(const Table& table, const Setting& setting) {
  return std::string(table.key) + '.' + std::string(setting.key);
}

/// Calls `visit(name, setting, given value, echoed value)` for every key that a sample gives.
template <class Visit>
void for_given_keys(const char* sample, Visit visit) {
  const Json given = as_json(sample), echoed = echo(read(sample));
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
      // The order of keys does not count.
      EXPECT_EQ(nlohmann::json(given), nlohmann::json(echoed)) << row_name(table, setting);
      const auto initial = default_of(table, setting);
      if (!initial || given != *initial) seen.insert(row_name(table, setting));
    });
  }
  for (const Table& table : tables()) {
    for (const Setting& setting : table.settings) {
      EXPECT_TRUE(seen.contains(row_name(table, setting)))
          << row_name(table, setting) << " is in no sample of this test with another value than its default";
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

TEST(Settings, NoTwoKeysFillOneMember) {
  for (const Table& table : tables()) {
    Project project;
    const Row row = table.add(project);
    std::map<const void*, std::string> owners;
    for (const Setting& setting : table.settings) {
      const void* member = std::visit(
          [](auto slot) -> const void* {
            if constexpr (std::is_pointer_v<decltype(slot)>) return slot;
            return nullptr;  // position and points share a member on purpose
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
          << name << " does not say what holds without it";
      EXPECT_FALSE(setting.required && !setting.without_it.empty()) << name;
    }
  };
  for (const Table& table : tables()) expect_documented(table);
  expect_documented(distribution_table());
}

TEST(Settings, UnitsAgreeWithTheNamesOfTheKeys) {
  // The ending of a key and the unit that it stands for; longer endings first.
  const std::vector<std::pair<std::string, std::string>> endings{
      {"_kg_m3", "kg/m3"}, {"_deg_s", "deg/s"}, {"_m_s2", "m/s2"}, {"_m_s", "m/s"},
      {"_kg_s", "kg/s"},   {"_per_s", "1/s"},   {"_deg", "deg"},   {"_kg", "kg"},
      {"_kJ", "kJ"},       {"_m3", "m3"},       {"_m", "m"},       {"_s", "s"}};
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

/// Does it hold numbers that the project file gives?
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
  bool operator()(DirectionSlot) const { return true; }
  bool operator()(RockLimitSlot) const { return true; }
  bool operator()(MapCellSlot) const { return true; }
};

TEST(Settings, RangesReadAsPeopleSayThem) {
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

// What no engineer meets is refused, so that nothing that follows from it overflows.
TEST(Settings, AllNumbersHaveLimits) {
  const std::set<std::string> without_need{
      "sampling.seed",    "ground.triangles",  "terrain.triangles",
      "terrain.section",  // whole, or looked at as places
      "terrain.vertices", "terrain.polylines", "barrier.line",         "collector.line",       "area.polygon",
      "seeder.polygon",   "distribution.mean", "distribution.std_dev", "distribution.rel_min", "distribution.rel_max"};
  std::set<std::string> without;
  const auto look = [&](const Table& table) {
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
  for (const Table& table : tables()) look(table);
  look(distribution_table());
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

TEST(Echo, ComesBackAsTheSameProject) {
  for (const char* sample : samples) {
    const Json once = echo(read(sample));
    EXPECT_EQ(once, echo(read(file_of(once)))) << once.dump(2);
  }
}

TEST(Echo, KeepsEveryBitOfANumber) {
  const double odd = 0.1 + 0.2;
  Project project = read(in_2d);
  project.analysis.gravity_m_s2 = odd;
  project.sampling.seed = 18446744073709551615u;
  const Json back = Json::parse(echo(project).dump());
  EXPECT_EQ(back["analysis"]["gravity_m_s2"].get<double>(), odd);
  EXPECT_EQ(back["sampling"]["seed"].get<std::uint64_t>(), project.sampling.seed);
}

TEST(Echo, WritesAnInfiniteCapacityAsText) { EXPECT_EQ(echo(read(inline_mesh))["barrier"][0]["capacity_kJ"], "inf"); }

TEST(Echo, LeavesOutTheMassWhereTheSizeIsGiven) {
  const Json seeders = echo(read(inline_mesh))["seeder"];
  EXPECT_FALSE(seeders[0].contains("mass_kg"));
  EXPECT_FALSE(seeders[0].contains("horizontal_velocity_m_s"));
  EXPECT_TRUE(seeders[1].contains("horizontal_velocity_m_s"));
}

/// Which of the schema's rules a value breaks, for the few words of JSON Schema that the schema uses.
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
    return std::find(words.begin(), words.end(), value) == words.end() ? path + " is not a word of the list" : "";
  }
  const std::string type = schema.value("type", "");
  const bool fits = type.empty() || (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
                    (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
                    (type == "integer" && value.is_number_integer()) || (type == "number" && value.is_number());
  if (!fits) return path + " is no " + type;
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
  EXPECT_EQ(broken([](Json& p) { p["analysis"]["model"] = "cube"; }), ".analysis.model is not a word of the list");
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

TEST(ReferencePage, NamesEverySettingAndItsMeaning) {
  const std::string page = reference_page();
  const auto expect_named = [&](const Table& table) {
    for (const Setting& setting : table.settings) {
      EXPECT_NE(page.find("| `" + std::string(setting.key) + "` |"), std::string::npos) << row_name(table, setting);
      EXPECT_NE(page.find(std::string(setting.meaning)), std::string::npos) << row_name(table, setting);
    }
  };
  for (const Table& table : tables()) expect_named(table);
  expect_named(distribution_table());
}

TEST(SettingsOfOneRockModel, AreSaidToBeInTheSchemaAndTheReference) {
  const Json materials = schema()["properties"]["material"]["items"]["properties"];
  EXPECT_EQ(materials["rolling_friction"]["x-applies-when"],
            Json::parse(R"([[{"key": "analysis.model", "is": ["rigid_sphere"]}]])"));
  EXPECT_EQ(materials["friction_angle_deg"]["x-applies-when"],
            Json::parse(R"([[{"key": "analysis.model", "is": ["lumped_mass"]}]])"));
  EXPECT_FALSE(materials["normal_restitution"].contains("x-applies-when"));
  EXPECT_EQ(materials["friction_angle_deg"]["description"], "Lumped mass: phi, the friction angle of sliding.");
  EXPECT_NE(reference_page().find("Rigid sphere: mu, the coefficient of friction while the contact slips."),
            std::string::npos);
}

Json schema_of(const Table& table, const Setting& setting) {
  const Json all = schema();
  if (table.key.empty()) return all["properties"][std::string(setting.key)];
  const Json found = all["properties"][std::string(table.key)];
  return (table.repeated ? found["items"] : found)["properties"][std::string(setting.key)];
}

TEST(ConditionsOfSettings, AreEmbeddedInTheReport) {
  const std::string_view script = assets::script;
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

void expect_fresh(const std::string& name, const std::string& made) {
  const std::string file = std::string(TALUS_SOURCE_DIR) + name;
  if (std::getenv("TALUS_RENEW_REFERENCE")) std::ofstream(file) << made;
  std::ifstream stream(file);
  ASSERT_TRUE(stream) << file;
  std::ostringstream text;
  text << stream.rdbuf();
  EXPECT_TRUE(text.str() == made)
      << name << " does not say what the declaration says; run this test with TALUS_RENEW_REFERENCE=1";
}

TEST(ReferencePage, IsNotStale) { expect_fresh("/docs/project-file.md", reference_page()); }

TEST(SchemaModule, IsNotStale) { expect_fresh("/web/src/generated/schema.ts", schema_module()); }

TEST(Settings, StandInTheGroupsOfTheirTable) {
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

// A condition that names no setting, or a word that the setting never has, would never hold.
TEST(Settings, ConditionsAreAboutSettingsAndTheirWords) {
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
          const bool asks_for_words = kind == Condition::Kind::one_of || kind == Condition::Kind::none_of;
          EXPECT_EQ(asks_for_words, !values.empty()) << row_name(table, setting) << ": " << key;
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

TEST(Schema, SaysWhenSettingsApply) {
  const Json terrain = schema()["properties"]["terrain"];
  EXPECT_EQ(terrain["properties"]["boundary"]["x-applies-when"],
            Json::parse(R"([[{"key": "points", "given": true}, {"key": "lines", "given": true}]])"));
  const Json analysis = schema()["properties"]["analysis"]["properties"];
  EXPECT_EQ(analysis["rn_mass_scale_kg"]["x-applies-when"],
            Json::parse(R"([[{"key": "scale_rn_by_mass", "is": ["true"]}]])"));
  EXPECT_EQ(analysis["rn_mass_scale_kg"]["x-group"], "Restitution");
  EXPECT_EQ(analysis["model"]["x-topic"]["heading"], "The laws");
}

}  // namespace
}  // namespace talus::project
