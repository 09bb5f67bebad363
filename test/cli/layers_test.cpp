// Reference layers: checked by `talus check`, and without any effect on results.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#ifdef TALUS_HAS_GDAL

#include <filesystem>
#include <fstream>
#include <string>

#include "cli/program.hpp"
#include "cli/run_files.hpp"

namespace talus::test {
namespace {

using ::testing::HasSubstr;

const std::string slope = R"([terrain]
section = [[1000, 60], [1050, 20], [1090, 15]]
width_m = 60
[[material]]
name = "Scree"
roughness_deg = 5
[[seeder]]
type = "line"
points = [[1002, 10, "surface"], [1002, 50, "surface"]]
rocks = 40
mass_kg = 500
[[collector]]
name = "Road"
line = [[1070, 5], [1070, 55]]
height_m = 3
)";

const std::string layer = "[[layer]]\nname = \"Roads\"\nfile = \"roads.geojson\"\n";

const std::string road =
    R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:31287"}}, "features": [
      {"type": "Feature", "properties": {}, "geometry": {"type": "LineString", "coordinates": [[1060, 0], [1065, 60]]}}]})";

TEST(Layers, ChangeNoResult) {
  const Workplace work;
  std::ofstream(work / "roads.geojson") << road;
  const std::string plain = work.write("plain.toml", "name = \"slope\"\n" + slope);
  const std::string drawn = work.write("drawn.toml", "name = \"slope\"\n" + slope + layer);
  ASSERT_EQ(talus_says("check " + drawn).exit_code, 0) << talus_says("check " + drawn).text;
  ASSERT_EQ(talus_says("run " + plain + " -o " + (work / "a").string()).exit_code, 0);
  ASSERT_EQ(talus_says("run " + drawn + " -o " + (work / "b").string()).exit_code, 0);
  auto a = files_of(work / "a"), b = files_of(work / "b");
  for (const char* of_project : {"summary.json", "files.json", "report.html", "run.state"}) {
    a.erase(of_project);
    b.erase(of_project);
  }
  EXPECT_GT(a.size(), 4U);
  EXPECT_EQ(differences(a, b), "");
  // A run goes on without the file, and after a change of layers.
  std::filesystem::remove(work / "roads.geojson");
  EXPECT_THAT(talus_says("run " + plain + " --resume -o " + (work / "b").string()).text,
              HasSubstr("is already complete"));
  EXPECT_EQ(talus_says("run " + drawn + " -o " + (work / "c").string()).exit_code, 0);
}

TEST(Layers, AreChecked) {
  const Workplace work;
  const std::string text = slope + layer + "[[layer]]\nfile = \"far.geojson\"\n[[layer]]\nfile = \"notes.txt\"\n";
  std::string far = road;
  far.replace(far.find("[1060, 0]"), 9, "[9060, 0]");
  far.replace(far.find("[1065, 60]"), 10, "[9065, 60]");
  std::ofstream(work / "far.geojson") << far;
  std::ofstream(work / "notes.txt") << "not a map\n";
  const Said said = talus_says("check " + work.write("slope.toml", text));
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.text, HasSubstr("slope.toml:18: layer \"Roads\": file " + (work / "roads.geojson").string() +
                                   ": cannot be read (there is no such file)"));
  EXPECT_THAT(said.text, HasSubstr("slope.toml:20: layer 2: file " + (work / "far.geojson").string() +
                                   ": does not lie over the terrain (it covers x 9060 to 9065"));
  EXPECT_THAT(said.text, HasSubstr("slope.toml:22: layer 3: file " + (work / "notes.txt").string() +
                                   ": cannot be drawn (it is neither a raster nor a vector file"));
}

TEST(Layers, NeedColoursAndNamesOfTheirOwn) {
  const Workplace work;
  const Said said = talus_says("check " + work.write("slope.toml", slope + layer + "colour = \"red\"\n" + layer));
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.text,
              HasSubstr("colour is \"red\" (expected red, green and blue as hexadecimal numbers: \"#d95f02\")"));
  EXPECT_THAT(said.text, HasSubstr("two layers are named \"Roads\""));
}

}  // namespace
}  // namespace talus::test

#endif
