#include "talus/archive/summary_json.hpp"

#include <gtest/gtest.h>

#include <string>

namespace talus {
namespace {

using Json = nlohmann::ordered_json;

struct Text : TextSink {
  void write(std::string_view more) override { text += more; }
  std::string text;
};

io::RunDescription description_of(std::size_t barriers) {
  io::RunDescription description;
  description.name = "Wall \"two\"";
  description.rocks = 10;
  description.barriers = barriers;
  description.project = {{"name", "Wall"}, {"seeder", {{{"name", "Line\nend"}}}}};
  description.model = {{"seed", 7},           {"barriers", Json::array()}, {"sources", Json::array()},
                       {"energy_datum_m", 0}, {"origin_m", {0, 0, 0}},     {"terrain", {{"kind", "section"}}}};
  for (std::size_t k = 0; k < barriers; ++k) {
    description.model["barriers"].push_back({{"name", "c" + std::to_string(k)}, {"kind", "collector"}});
  }
  return description;
}

std::string written(const io::RunDescription& description, const Summary& summary) {
  Text out;
  write_summary(out, description, {"a file named \xff"}, summary, {.range = {0, 10}, .shard = {}});
  return out.text;
}

// It is written piece by piece, and looks as if it had been in one.
TEST(SummaryFile, IsOneObjectInOneForm) {
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

TEST(SummaryFile, SaysLittleOfBarriersThatNoRockHit) {
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

}  // namespace
}  // namespace talus
