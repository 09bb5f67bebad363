#include "talus/model/cut_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_folder.hpp"
#include "talus/import/section_file.hpp"
#include "talus/meshing/simplified_line.hpp"
#include "talus/model/build_terrain.hpp"
#include "talus/project/read.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Corner = std::array<double, 2>;

class CutSection : public InputFolder {
 protected:
  /// Two planes that meet at x = 100 in a ridge along y.
  [[nodiscard]] project::BuiltTerrain roof() {
    write("roof.obj",
          "v 0 0 50\nv 100 0 90\nv 100 200 90\nv 0 200 50\nv 160 0 60\nv 160 200 60\n"
          "f 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n");
    project::Project project;
    project.file = path("roof.obj");
    project.terrain.mesh.files = {"roof.obj"};
    project.terrain.crs = "local";
    return project::build_terrain(project, warnings_);
  }
  [[nodiscard]] std::vector<SectionVertex> cut(const std::vector<Corner>& line, double tolerance) {
    const project::BuiltTerrain built = roof();
    return cut_section(*built.surface, built.frame, line, tolerance, "--line");
  }
};

TEST_F(CutSection, HasAVertexAtEachBend) {
  const auto section = cut({{10, 20}, {130, 110}}, 1e-6);
  ASSERT_EQ(section.size(), 3U);
  EXPECT_NEAR(section[1].distance, 90 * 150.0 / 120, 1e-9);
  EXPECT_NEAR(section[1].place.z(), 90, 1e-6);
  EXPECT_NEAR((section[0].place - Vec3(10, 20, 54)).norm(), 0, 1e-6);
  EXPECT_NEAR((section[2].place - Vec3(130, 110, 75)).norm(), 0, 1e-6);
}

TEST_F(CutSection, IsReadBackFromItsTable) {
  const auto section = cut({{10, 20}, {130, 110}}, 0);
  write("profile.csv", section_table(section));
  const auto read = read_section_file({path("profile.csv"), "", 0}, warnings_);
  ASSERT_EQ(read.size(), section.size());
  for (std::size_t k = 0; k < read.size(); ++k) {
    EXPECT_NEAR(read[k][0], section[k].distance, 1e-4);
    EXPECT_NEAR(read[k][1], section[k].place.z(), 1e-4);
  }
}

TEST_F(CutSection, RefusesLinesBeyondTheGround) {
  EXPECT_THAT(refusal_of([&] {
                static_cast<void>(cut({{10, 20}, {300, 20}}, 0));
              }),
              HasSubstr("--line: the line leaves the ground (there is none beyond 150 m along the line)"));
  EXPECT_THAT(refusal_of([&] {
                static_cast<void>(cut({{500, 20}, {600, 20}}, 0));
              }),
              HasSubstr("the line leaves the ground (there is none beyond 0 m along the line)"));
  EXPECT_THAT(refusal_of([&] { static_cast<void>(cut({{10, 20}, {10, 20}}, 0)); }), HasSubstr("has no length"));
}

TEST(SimplifiedLine, KeepsTheEndsAndWhatIsFartherThanTheTolerance) {
  const std::vector<Vec2> line{{0, 0}, {1, 0.4}, {2, 0}, {3, 2}, {4, 0}};
  EXPECT_THAT(vertices_to_keep(line, 0.5), ElementsAre(0U, 2U, 3U, 4U));
  EXPECT_THAT(vertices_to_keep(line, 0.1), ElementsAre(0U, 1U, 2U, 3U, 4U));
  EXPECT_THAT(vertices_to_keep(line, 5), ElementsAre(0U, 4U));
}

}  // namespace

namespace project {
namespace {

class SectionOfProject : public testing_tools::InputFolder {
 protected:
  [[nodiscard]] Reading read(const std::string& terrain, const std::string& position = "[2, \"surface\"]") {
    write("slope.toml", "[terrain]\n" + terrain +
                            "\n[[material]]\nname = \"Scree\"\n[[seeder]]\ntype = \"point\"\nposition = " + position +
                            "\nrocks = 5\nmass_kg = 100\n");
    return read_project(path("slope.toml"), {});
  }
};

TEST_F(SectionOfProject, IsThatOfItsFile) {
  write("profile.csv", "distance_m,z_m\n0,30\n10,12\n40,5\n");
  const Reading reading = read("section = \"profile.csv\"");
  EXPECT_TRUE(reading.project.is_2d());
  EXPECT_EQ(reading.project.terrain.section.vertices, (std::vector<Corner>{{0, 30}, {10, 12}, {40, 5}}));
  ASSERT_EQ(reading.project.named_files.size(), 1U);
  EXPECT_EQ(read("section = \"profile.csv\"\nwidth_m = 20", "[2, 5, \"surface\"]").project.is_2d(), false);
}

TEST_F(SectionOfProject, ProblemsOfTheFileStandAtTheLineThatNamesIt) {
  const auto refusal = [&](const std::string& terrain) {
    return refusal_of([&] { static_cast<void>(read(terrain)); });
  };
  write("profile.csv", "distance_m,z_m\n0,30\n10,low\n");
  EXPECT_THAT(refusal("section = \"profile.csv\""),
              HasSubstr("slope.toml:2: [terrain]: section profile.csv:3: \"low\" is not a number"));
  EXPECT_THAT(refusal("section = \"other.csv\""), HasSubstr("slope.toml:2: [terrain]: section other.csv: cannot be "
                                                            "read (there is no such file)"));
  write("profile.csv", "distance_m,z_m\n0,30\n10,12\n5,20\n10,25\n2,10\n");
  EXPECT_THAT(refusal("section = \"profile.csv\""), HasSubstr("section crosses or touches itself"));
  EXPECT_THAT(refusal("section = 3"), HasSubstr("a list of vertices [x, z], or a file name in quotes"));
  EXPECT_THAT(refusal("section = [[0, 30], [10, 12]]\nsection_tolerance_m = 1"),
              HasSubstr("section_tolerance_m is given (the section is not in a file)"));
}

TEST_F(SectionOfProject, ALinkToOutsideTheFolderIsNotRead) {
  write("profile.csv", "distance_m,z_m\n0,30\n10,12\n");
  std::filesystem::create_directory(path("inner"));
  std::filesystem::create_symlink("../profile.csv", path("inner/profile.csv"));
  write("inner/slope.toml", "[terrain]\nsection = \"profile.csv\"\n");
  EXPECT_THAT(refusal_of([&] { static_cast<void>(read_project(path("inner/slope.toml"), {})); }),
              HasSubstr("it is a link to outside the project's folder"));
}

}  // namespace
}  // namespace project
}  // namespace talus
