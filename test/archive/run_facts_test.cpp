#include "talus/archive/run_facts.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/sample_run_3d.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;

RunFacts facts_of(const Json& summary) {
  const sample_run::Folder folder("run-facts");
  folder.write("summary.json", summary.dump());
  return read_run_facts(folder.path);
}

TEST(RunFacts, AreThoseOfTheSummary) {
  Json summary = sample_run::summary_3d();
  summary["terrain"]["crs_wkt"] = "PROJCRS[...]";
  summary["origin_m"] = {1024, 2048, 0};
  const RunFacts facts = facts_of(summary);
  EXPECT_FALSE(facts.is_section);
  EXPECT_EQ(facts.summary.origin_m, (std::array<double, 3>{1024, 2048, 0}));
  EXPECT_EQ(facts.summary.terrain.crs_wkt, "PROJCRS[...]");
  EXPECT_EQ(facts.planned_rocks(), 6U);
  EXPECT_TRUE(facts.wants_geopackage);
  EXPECT_TRUE(facts.wants_vtk);
  ASSERT_EQ(facts.barriers.size(), 2U);
  const BarrierFacts& fence = facts.barriers[0];
  EXPECT_EQ(fence.name, "Fence");
  EXPECT_EQ(fence.kind, "barrier");
  ASSERT_EQ(fence.line_xyz.size(), 3U);
  EXPECT_EQ(fence.line_xyz[1], (std::array<double, 3>{10, 20, 5.5}));
  EXPECT_EQ(fence.stations.size(), 3U);
  EXPECT_EQ(fence.stations[0], 0);
  EXPECT_EQ(fence.height_m, 3);
  EXPECT_EQ(fence.inclination_deg, -10);
  EXPECT_EQ(fence.capacity_kJ, 500);
  EXPECT_EQ(fence.hits, 3U);
  EXPECT_EQ(fence.rocks_hit, 2U);
  EXPECT_EQ(fence.passed_above, 1U);
  EXPECT_EQ(fence.outcomes.stopped, 2U);
  EXPECT_EQ(fence.outcomes.rebounded, 1U);
  EXPECT_EQ(fence.least_clearance_m, 0.25);
  EXPECT_EQ(fence.statistics_of("ke_total_J").percentiles.p95, 9.6e4);
  EXPECT_EQ(fence.statistics_of("ke_translational_J").maximum, 1e5);
  EXPECT_EQ(fence.statistics_of("impact_height_m").percentiles.p99, 2.5);
  EXPECT_EQ(fence.statistics_of("velocity_m_s").maximum, 17);
  EXPECT_EQ(facts.barriers[1].capacity_kJ, std::nullopt);
  EXPECT_EQ(facts.barriers[1].statistics_of("velocity_m_s").maximum, std::nullopt);
}

TEST(RunFacts, HaveStationsAlongTheLineOfTheInput) {
  Json summary = sample_run::summary_3d();
  summary["barriers"][0]["stations_m"] = {7, 30, 60};
  EXPECT_EQ(facts_of(summary).barriers[0].stations, (std::vector<double>{7, 30, 60}));
}

TEST(RunFacts, HaveNoCapacityForAWallWithoutLimit) {
  Json summary = sample_run::summary_3d();
  summary["project"]["barrier"][0]["capacity_kJ"] = "inf";
  EXPECT_EQ(facts_of(summary).barriers[0].capacity_kJ, std::nullopt);
}

TEST(RunFacts, HaveNoStatisticsOfABarrierWithoutHits) {
  Json summary = sample_run::summary_3d();
  Json& fence = summary["barriers"][0];
  fence["hits"] = 0;
  fence.erase("statistics");
  fence.erase("histograms");
  const BarrierFacts facts = facts_of(summary).barriers[0];
  EXPECT_EQ(facts.hits, 0U);
  EXPECT_EQ(facts.height_m, 3);
  EXPECT_EQ(facts.statistics_of("ke_total_J").maximum, std::nullopt);
}

TEST(RunFacts, HaveTheSourceOfEachRock) {
  const RunFacts facts = facts_of(sample_run::summary_3d());
  const char* const expected[] = {"Wall", "Wall", "Tower, \"old\"", "Tower, \"old\"", "Wall", "Wall", ""};
  for (std::uint64_t rock = 0; rock < 7; ++rock) EXPECT_EQ(facts.source_of(rock), expected[rock]) << rock;
  Json summary = sample_run::summary_3d();
  summary["sources"] = summary["releases"] = Json::array();
  EXPECT_EQ(facts_of(summary).source_of(0), "");
}

TEST(RunFacts, WantNoGeoPackageForASection) {
  Json summary = sample_run::summary_3d();
  summary["terrain"]["kind"] = "section";
  EXPECT_FALSE(facts_of(summary).wants_geopackage);
  summary = sample_run::summary_3d();
  summary["project"]["output"]["geopackage"] = "none";
  EXPECT_FALSE(facts_of(summary).wants_geopackage);
  summary["project"]["output"]["geopackage"] = "all";
  EXPECT_TRUE(facts_of(summary).wants_geopackage);
}

std::string message_about(const std::string& text) {
  const sample_run::Folder folder("run-facts");
  if (!text.empty()) folder.write("summary.json", text);
  try {
    static_cast<void>(read_run_facts(folder.path));
  } catch (const BadInput& bad) {
    return std::string(bad.what()).substr(folder.path.string().size() + 1);
  }
  return "was read";
}

std::string message_about_value(const char* pointer, const Json& value) {
  Json summary = sample_run::summary_3d();
  summary[Json::json_pointer(pointer)] = value;
  return message_about(summary.dump());
}

TEST(RunFacts, RefuseOtherFiles) {
  const std::string hint = ". Name a folder that `talus run` has written";
  EXPECT_EQ(message_about(""), "summary.json: there is no such file (the folder of a finished run has it)" + hint);
  EXPECT_EQ(message_about("[1, 2"),
            "summary.json:1: the JSON ends too early (after 5 bytes). The file was cut short or damaged; run the "
            "project again to write it anew");
  EXPECT_EQ(message_about("[1, 2]"), "summary.json: is of type array (expected an object)" + hint);
  EXPECT_EQ(message_about(std::string(100'000, '[')),
            "summary.json: is damaged (its lists are nested 100000 deep; expected at most 100)" + hint);
  EXPECT_EQ(message_about("{}"), "summary.json: talus: is missing (a run writes it)" + hint);
  EXPECT_EQ(message_about_value("/rocks/planned", -6),
            "summary.json: rocks/planned: is of type number (expected a whole number, 0 or more)" + hint);
  EXPECT_EQ(message_about_value("/project/output/geopackage", "some"),
            "summary.json: project/output/geopackage: is of type string (expected a whole number, 0 or more)" + hint);
  EXPECT_EQ(message_about_value("/barriers/0/line_xyz/1/2", "high"),
            "summary.json: barriers/0/line_xyz/1/2: is of type string (expected a number)" + hint);
  EXPECT_EQ(message_about_value("/barriers", 3), "summary.json: barriers: is of type number (expected a list)" + hint);
  EXPECT_EQ(message_about_value("/barriers/1", 3),
            "summary.json: barriers/1: is of type number (expected an object)" + hint);
  EXPECT_EQ(message_about_value("/barriers/1/name", "Road"),
            "summary.json: project/collector/Road: is missing (a run writes it)" + hint);
  EXPECT_EQ(message_about_value("/sources", 3), "summary.json: sources: is of type number (expected a list)" + hint);
}

}  // namespace
}  // namespace talus
