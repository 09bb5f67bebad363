// Hostile projects that would exhaust the stack or the time, and terrains that are not what they seem.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "support/input_folder.hpp"
#include "support/projects.hpp"

namespace talus::project {
namespace {

using testing_tools::refusal_of_reading;

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int k = 0; k < times; ++k) text += part;
  return text;
}

std::string with_section(const std::string& section) {
  return "[terrain]\nsection = " + section +
         "\n[[material]]\nname = \"Rock\"\n[[seeder]]\nposition = [1, \"surface\"]\nmass_kg = 10\n";
}

TEST(RefusedProject, AKeyWithTooManyParts) {
  const std::string why = " (the longest keys of a project have three, such as [material.normal_restitution] mean)";
  const std::string parts = repeated("a.", 200'000) + "a";
  EXPECT_EQ(refusal_of_reading("name = \"x\"\n" + parts + " = 1\n"),
            "slope.toml:2: a key has more than 16 parts" + why);
  EXPECT_EQ(refusal_of_reading("\n\n[" + parts + "]\n"), "slope.toml:3: a key has more than 16 parts" + why);
  EXPECT_EQ(refusal_of_reading("x = { " + repeated("\"a.b\" . ", 20) + "c = 1 }"),
            "slope.toml:1: a key has more than 16 parts" + why);
  EXPECT_EQ(refusal_of_reading("a = \"\"\"\n\n\\\"\"\"\"\n" + parts + " = 1\n"),
            "slope.toml:4: a key has more than 16 parts" + why);
  EXPECT_EQ(refusal_of_reading("a = 'b\n" + parts), "slope.toml:2: a key has more than 16 parts" + why);
}

TEST(RefusedProject, DotsInStringsCommentsAndNumbersAreNotParts) {
  const std::string points = repeated("a.", 50);
  EXPECT_EQ(
      refusal_of_reading("name = \"" + points + "\"  # " + points + "\n" +
                         with_section("[[0.5, 0.5], [1.5, 0.5], [2.5, 0.5], [3.5, 0.5], [4.5, 0.5], [5.5, 0.5], [6.5, "
                                      "0.5], [7.5, 0.5], [8.5, 0.5], [9.5, 0.5], [10.5, 0.5]]")),
      "");
}

TEST(RefusedProject, DeeplyNestedValues) {
  EXPECT_EQ(refusal_of_reading("a = " + repeated("[", 100'000) + repeated("]", 100'000)),
            "slope.toml:1: this is not TOML (Error while parsing value: exceeded maximum nested value depth of 256 "
            "(TOML_MAX_NESTED_VALUES))");
}

TEST(RefusedProject, ATableWithoutAName) {
  EXPECT_EQ(refusal_of_reading("[=]\n"),
            "slope.toml:1: this is not TOML (Error while parsing key: expected bare key starting character or string "
            "delimiter, saw '=')");
}

TEST(RefusedProject, CharactersNearTheRangeOfBlanks) {
  for (const std::string letter : {"\u0362", "\u0100", "\u3100", "\uFE00"}) {
    EXPECT_EQ(refusal_of_reading("a = [1, " + letter + "2]"),
              "slope.toml:1: this is not TOML (Error while parsing value: could not determine value type)")
        << letter;
  }
}

TEST(RefusedProject, AnOverrideWithTooManyParts) {
  const std::string good = with_section("[[0, 0], [10, -10]]");
  const std::string key = repeated("a.", 16) + "a";
  EXPECT_EQ(refusal_of_reading(good, {.settings = {key + "=1"}}),
            "--set " + key +
                "=1: the key has 17 parts (the longest keys of a project have four, such as "
                "material.Rock.normal_restitution.mean)");
  EXPECT_EQ(refusal_of_reading(good, {.settings = {"name={" + key + " = 1}"}}),
            "--set name={" + key + " = 1}: the value is not TOML (a key in it has more than 16 parts)");
}

TEST(RefusedProject, ASectionThatCrossesItself) {
  EXPECT_EQ(refusal_of_reading(with_section("[[0, 0], [10, -10], [10, 0], [0, -10]]")),
            "slope.toml:2: [terrain]: section crosses or touches itself (at or near x = 5, z = -5). Give its vertices "
            "in order along the slope");
  EXPECT_EQ(refusal_of_reading(with_section("[[0, 0], [10, 0], [10, -10], [8, -12], [20, -20]]")), "") << "an overhang";
}

TEST(RefusedProject, ASectionTooFarAway) {
  EXPECT_EQ(refusal_of_reading(with_section("[[0, 0], [1e300, 0], [20, -1e10]]")),
            "slope.toml:2: [terrain]: section[1] is [1e+300, 0] (coordinates lie within 1e+09 m)\n"
            "slope.toml:2: [terrain]: section[2] is [20, -10000000000] (coordinates lie within 1e+09 m)");
}

TEST(RefusedProject, ManyDuplicateNamesAreReportedQuickly) {
  std::string text = with_section("[[0, 0], [10, -10]]");
  for (int k = 0; k < 30'000; ++k)
    text += "[[barrier]]\nname = \"b" + std::to_string(k / 2) + "\"\nline = 5\nheight_m = 1\n";
  const std::string message = refusal_of_reading(text);
  EXPECT_TRUE(message.starts_with(
      "slope.toml:13: two barriers or collectors are named \"b0\" (the first begins in line 8). Give "
      "each its own name\n"))
      << message.substr(0, 200);
}

TEST(RefusedProject, TooManyEntries) {
  std::string text = with_section("[[0, 0], [10, -10]]");
  for (int k = 0; k < 100'001; ++k) text += "[[barrier]]\n";
  EXPECT_EQ(refusal_of_reading(text), "slope.toml:8: [[barrier]] has 100001 entries (expected at most 100000)");
}

TEST(RefusedProject, OnlyTheFirstOfManyUnknownKeysAreReported) {
  std::string text;
  for (int k = 1000; k < 1250; ++k) text += "qqq" + std::to_string(k) + " = 1\n";
  const std::string message = refusal_of_reading(text + with_section("[[0, 0], [10, -10]]"));
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 100);
  EXPECT_TRUE(message.starts_with("slope.toml:1: unknown key \"qqq1000\" (expected one of ")) << message.substr(0, 200);
  EXPECT_NE(message.find("\nslope.toml:1: 150 more keys are unknown\nslope.toml:2: unknown key \"qqq1001\""),
            std::string::npos)
      << message.substr(0, 400);
}

class RefusedMesh : public testing_tools::InputFolder {
 protected:
  [[nodiscard]] std::string refusal(const std::string& terrain) const {
    write("slope.toml", "[terrain]\n" + terrain +
                            "\n[[material]]\nname = \"Rock\"\n[[seeder]]\nposition = [13.1001, 47.2001, \"surface\"]\n"
                            "mass_kg = 10\n");
    return refusal_of([&] {
      Reading reading = read_project(path("slope.toml"));
      static_cast<void>(build_model(reading.project, reading.warnings));
    });
  }
};

TEST_F(RefusedMesh, InDegrees) {
  write("slope.obj", "v 13.1 47.2 900\nv 13.101 47.2 800\nv 13.1 47.201 850\nf 1 2 3\n");
  EXPECT_EQ(refusal("mesh = \"slope.obj\""),
            "slope.toml:2: [terrain]: mesh slope.obj: seems to be in degrees (it lies within x = 13.1 to 13.101, y = "
            "47.2 to 47.201 and is 100 m high). "
            "Project it to metres; or, if it is in metres, set crs = \"local\"");
  EXPECT_EQ(refusal("mesh = \"slope.obj\"\ncrs = \"local\""), "was read");
}

TEST_F(RefusedMesh, ThatIsAFolderOrAPipe) {
  std::filesystem::create_directories(folder_ / "dir.obj");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_EQ(refusal("mesh = \"dir.obj\""),
            "slope.toml:2: [terrain]: mesh is \"dir.obj\" (it is a folder). The path is relative to the project file");
  EXPECT_EQ(refusal("mesh = \"pipe.obj\""),
            "slope.toml:2: [terrain]: mesh is \"pipe.obj\" (it is not an ordinary file). The path is relative to "
            "the project file");
}

}  // namespace
}  // namespace talus::project
