#include "talus/archive/summary_json.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/sample_run.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;

struct Text : TextSink {
  void write(std::string_view more) override { text += more; }
  std::string text;
};

RunDescription description_of(std::size_t barriers) {
  RunDescription description;
  description.name = "Wall \"two\"";
  description.rocks = 10;
  description.barriers = barriers;
  description.project = {{"name", "Wall"}, {"seeder", {{{"name", "Line\nend"}}}}};
  description.model = {{"seed", 7U},
                       {"barriers", Json::array()},
                       {"sources", Json::array()},
                       {"releases", Json::array()},
                       {"energy_datum_m", 0},
                       {"origin_m", {0, 0, 0}},
                       {"terrain", {{"kind", "section"}}}};
  for (std::size_t k = 0; k < barriers; ++k) {
    description.model["barriers"].push_back(
        {{"name", "c" + std::to_string(k)}, {"kind", "collector"}, {"line_xyz", Json::array()}});
  }
  return description;
}

std::string written(const RunDescription& description, const Summary& summary) {
  Text out;
  write_summary(out, description, {{"a file named \xff"}}, summary, {.range = {0, 10}, .shard = {}});
  return out.text;
}

// Written piece by piece, it looks the same as if written at once.
TEST(SummaryFile, IsOneConsistentlyFormattedObject) {
  for (const std::size_t barriers : {0U, 1U, 3U}) {
    Summary summary(10, barriers);
    if (barriers > 0) summary.barriers[0].height.add(1);
    const std::string text = written(description_of(barriers), summary);
    const Json json = Json::parse(text, nullptr, false);
    ASSERT_TRUE(json.is_object()) << text;
    EXPECT_EQ(text, json.dump(1) + "\n");
    EXPECT_EQ(json["name"], "Wall \"two\"");
    EXPECT_EQ(json["barriers"].size(), barriers);
    EXPECT_EQ(json["project"]["seeder"][0]["name"], "Line\nend");
    EXPECT_TRUE(json.contains("timings"));
  }
}

TEST(SummaryFile, HasNoStatisticsOfBarriersWithoutHits) {
  Summary summary(10, 2);
  BarrierTally& hit = summary.barriers[1];
  for (Tally* tally : {&hit.translational_energy, &hit.total_energy, &hit.height, &hit.velocity}) tally->add(2);
  const Json barriers = Json::parse(written(description_of(2), summary))["barriers"];
  EXPECT_EQ(barriers[0]["hits"], 0);
  EXPECT_FALSE(barriers[0].contains("statistics"));
  EXPECT_FALSE(barriers[0].contains("histograms"));
  EXPECT_EQ(barriers[1]["hits"], 1);
  EXPECT_EQ(barriers[1]["statistics"]["velocity_m_s"]["mean"], 2);
  EXPECT_EQ(barriers[1]["histograms"]["impact_height_m"]["counts"].size(), 1U);
}

// Writing, reading and writing again gives the same text: one declaration serves both.
TEST(SummaryFile, IsReadAsWritten) {
  Summary summary(10, 2);
  summary.done = 10;
  summary.ends[static_cast<std::size_t>(EndReason::at_rest)] = 10;
  for (int k = 0; k < 10; ++k) summary.end_x.add(0.1 * k);
  summary.barriers[1].translational_energy.add(5);
  const sample_run::Folder folder("summary-file");
  Text out;
  const RunCourse course{.range = {2, 8}, .shard = Shard{2, 3}, .missing = {{3, 4}}, .seconds = 0.5, .threads = 2};
  ToldWarnings warnings{{"one"}};
  warnings.add({.where = "rocks", .what = "slid", .kind = ProblemKind::mostly_on_ground}, "two");
  write_summary(out, description_of(2), warnings, summary, course);
  folder.write("summary.json", out.text);
  const RunSummary read = read_run_summary(folder.path / "summary.json");
  EXPECT_EQ(json_of(read).dump(1) + "\n", out.text);
  EXPECT_EQ(read.shard->first_rock, 2U);
  ASSERT_EQ(read.warning_kinds.size(), 1U);
  EXPECT_EQ(read.warning_kinds[0].kind, "mostly_on_ground");
  EXPECT_EQ(read.warnings.at(read.warning_kinds[0].warning), "two");
  EXPECT_EQ(read.barriers[1].hits, 1U);
  EXPECT_EQ(read.statistics[0].second.count, 10U);
  std::vector<std::string> taken;
  const auto take = [&](const BarrierSummary& barrier) { taken.push_back(barrier.name); };
  EXPECT_TRUE(read_run_summary(folder.path / "summary.json", take).barriers.empty());
  EXPECT_EQ(taken, (std::vector<std::string>{"c0", "c1"}));
}

// The identity of the run can be read even if another version of the program wrote the rest.
TEST(SummaryFile, HasTheIdentityOfItsRun) {
  const sample_run::Folder folder("summary-file");
  Json summary = sample_run::summary("Slope");
  for (const char* key : {"statistics", "histograms", "notes", "timings"}) summary.erase(key);
  summary["barriers"] = {1, 2};
  folder.write("summary.json", summary.dump());
  const RunIdentity run = read_run_identity(folder.path / "summary.json");
  EXPECT_EQ(run.fingerprint, "46d0eda3684e621596ce0884751bc736");
  EXPECT_EQ(run.talus.version, "0.1.0");
  EXPECT_EQ(run.rocks.planned, 2U);
  EXPECT_EQ(run.project->at("name"), "Slope");
  EXPECT_THROW((void)read_run_summary(folder.path / "summary.json"), BadInput);
}

}  // namespace
}  // namespace talus
