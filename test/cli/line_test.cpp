// `talus line` answers from the folder of a run.

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/run_files.hpp"
#include "lines/slopes.hpp"

namespace talus::test {
namespace {

class LineCommand : public ::testing::Test {
 protected:
  LineCommand() {
    const Said said = talus_says("run " + write_slope_with_barrier(work_) + " --quiet -o " + out());
    EXPECT_EQ(said.exit_code, 0) << said.text;
  }
  [[nodiscard]] std::string out() const { return (work_ / "out").string(); }
  [[nodiscard]] Said line(const std::string& options) const { return talus_says("line " + out() + " " + options); }
  /// What it prints, or why it refuses, without the name of the test's folder.
  [[nodiscard]] std::string text_of(const std::string& options, int exit_code = 0) const {
    const Said said = line(options);
    EXPECT_EQ(said.exit_code, exit_code) << said.text;
    std::string text = said.text;
    const std::string folder = (work_ / "").string();
    for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
    return text;
  }

  Workplace work_;
};

std::vector<std::string> rows_of(const std::string& text, const std::string& line) {
  std::vector<std::string> rows;
  std::istringstream in(text);
  for (std::string row; std::getline(in, row);) {
    if (row.starts_with(line)) rows.push_back(row.substr(line.size()));
  }
  return rows;
}

/// Numbers are equal to five digits, which the store has of motion along the ground; everything else is the same.
void expect_same_row(const std::string& asked, const std::string& run) {
  std::istringstream a(asked), b(run);
  std::string left, right;
  while (std::getline(b, right, ',')) {
    ASSERT_TRUE(std::getline(a, left, ',')) << asked;
    double x = 0, y = 0;
    const auto is_number = [](const std::string& text, double& value) {
      return std::from_chars(text.data(), text.data() + text.size(), value).ptr == text.data() + text.size();
    };
    if (!right.empty() && is_number(left, x) && is_number(right, y)) {
      EXPECT_NEAR(x, y, 1e-4 * std::max(1.0, std::abs(y)));
    } else {
      EXPECT_EQ(left, right);
    }
  }
}

TEST_F(LineCommand, PrintsTheRowsOfADesign) {
  for (const char* name : {"Line at 15 m", "Fence"}) {
    const auto asked = rows_of(text_of("--csv --barrier '" + std::string(name) + "'"), name);
    const auto run = rows_of(work_.read("out/design.csv"), name);
    ASSERT_EQ(asked.size(), run.size());
    EXPECT_GT(run.size(), 5U);
    for (std::size_t k = 0; k < run.size(); ++k) expect_same_row(asked[k], run[k]);
  }
}

TEST_F(LineCommand, SaysWhatCrossesALine) {
  const std::string text = text_of("--line '15,0 15,50' --height 2 --energy 100 --json " + (work_ / "a.json").string());
  const auto json = nlohmann::json::parse(work_.read("a.json"));
  EXPECT_NE(text.find("of 75 rocks cross the line of 50 m: " + json["card"]["share"].get<std::string>()),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(json["kit"]["text"].get<std::string>()), std::string::npos) << text;
  EXPECT_NE(text.find("UNI 11211-4 asks for class"), std::string::npos) << text;
  EXPECT_NE(text.find("the worst"), std::string::npos) << text;
}

TEST_F(LineCommand, ReadsLinesFromTables) {
  work_.write("line.csv", "x_m,y_m\n15,0\n15,50\n");
  const std::string given = text_of("--line '15,0 15,50'");
  EXPECT_EQ(text_of("--line " + (work_ / "line.csv").string()), given);
  work_.write("bad.csv", "x_m,y_m\n15,0\n15,east\n");
  EXPECT_EQ(text_of("--line " + (work_ / "bad.csv").string(), 2), "bad.csv:3: y_m is \"east\" (expected a number)\n");
}

TEST_F(LineCommand, SaysWhatEntersAPolygon) {
  const std::string text = text_of("--polygon '5,5 25,5 25,45 5,45'");
  EXPECT_NE(text.find("rocks enter the polygon of 800 m2"), std::string::npos) << text;
  EXPECT_NE(text.find("rocks stop in the polygon of 800 m2"), std::string::npos) << text;
}

TEST_F(LineCommand, SaysWhatStaysInADitch) {
  work_.write("face.toml", vertical_face);
  const std::string face = (work_ / "face").string();
  const Said run = talus_says("run " + (work_ / "face.toml").string() + " --quiet -o " + face);
  ASSERT_EQ(run.exit_code, 0) << run.text;
  const Said said = talus_says("line " + face + " --ditch 10 16");
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_EQ(said.text.substr(0, said.text.find('\n')), "5 rocks get past the toe: 100.0 % (47.8 to 100.0 %) of 5");
  EXPECT_NE(said.text.find("3 rocks get beyond the far edge, 6 m from the toe: 60.0 %"), std::string::npos)
      << said.text;
  EXPECT_NE(said.text.find(" 50 %        6.03 m (too few rocks)"), std::string::npos) << said.text;
  EXPECT_NE(said.text.find("Modified Ritchie criterion: 8.6 m"), std::string::npos) << said.text;

  work_.write("fence.toml", vertical_face + "[[barrier]]\nline = 13.5\nheight_m = 30\n");
  const std::string fence = (work_ / "fence").string();
  ASSERT_EQ(talus_says("run " + (work_ / "fence.toml").string() + " --quiet -o " + fence).exit_code, 0);
  const Said held = talus_says("line " + fence + " --ditch 10 16");
  EXPECT_NE(held.text.find("4 rocks are held by a barrier before it; how far they would get is unknown: 80.0 %"),
            std::string::npos)
      << held.text;
  EXPECT_NE(held.text.find(" 50 %                     >= 3.50 m                     >= 3.50 m"), std::string::npos)
      << held.text;
  EXPECT_EQ(text_of("--ditch 10 16", 2),
            "--ditch: is a stretch of a section (this run is 3D). Ask for a line or a polygon\n");
}

TEST_F(LineCommand, TakesADesignForAProjectWithoutLines) {
  work_.write("face.toml", vertical_face);
  const std::string face = (work_ / "face").string();
  const Said run = talus_says("run " + (work_ / "face.toml").string() + " --quiet -o " + face);
  ASSERT_EQ(run.exit_code, 0) << run.text;
  const Said said = talus_says("line " + face + " --line 12 --design confidence=0.9");
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_NE(said.text.find("confidence 90 %)"), std::string::npos) << said.text;
}

TEST_F(LineCommand, RefusesWithTheReason) {
  EXPECT_EQ(text_of("--line '15,0 15,north'", 2),
            "--line: \"15,north\" is not a place (expected x,y). Write \"x,y x,y ...\", or name a file that "
            "exists\n");
  EXPECT_EQ(text_of("--line fence.gpkg", 2),
            "--line: \"fence.gpkg\" cannot be read (there is no such file). Write \"x,y x,y ...\", or name a file that "
            "exists\n");
  EXPECT_EQ(text_of("--line '15,0'", 2), "--line: has 1 point (expected at least 2, from one end to the other)\n");
  EXPECT_EQ(text_of("--barrier Net", 2),
            "--barrier: the run has no barrier or collector \"Net\" (it has \"Fence\", \"Line at 15 m\")\n");
  std::filesystem::remove(work_ / "out" / "trajectories.bin");
  EXPECT_EQ(text_of("--barrier Fence", 2),
            "out/trajectories.bin: the run has no stored trajectories (lines are asked of the paths of its "
            "rocks). Run it again with output.trajectories\n");
}

TEST(LineOfASectionFile, IsRefusedWithoutTheWarningsOfTheRun) {
  const Workplace work;
  work.write("profile.csv", "0,20\n10,10\n30,10\n");
  work.write("slope.toml",
             "terrain.section = 'profile.csv'\n[[material]]\nname = 'ground'\nlike = 'talus_cover'\n"
             "[[seeder]]\ntype = 'point'\nposition = [1, 'surface']\nrocks = 5\nmass_kg = 100\n");
  const std::string out = (work / "out").string();
  const Said run = talus_says("run " + (work / "slope.toml").string() + " --quiet -o " + out);
  ASSERT_EQ(run.exit_code, 0) << run.text;
  const std::string profile = (work / "profile.csv").string();
  std::filesystem::remove(profile);
  const Said said = talus_says("line " + out + " --line 5");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_NE(said.text.find("section " + profile + ": cannot be read (No such file or directory)"), std::string::npos)
      << said.text;
  EXPECT_EQ(said.text.find('\n'), said.text.size() - 1) << said.text;
}

}  // namespace
}  // namespace talus::test
