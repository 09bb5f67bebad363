#include "talus/project/setting_paths.hpp"

#include <gtest/gtest.h>

#include "talus/project/document.hpp"
#include "talus/project/problem_paths.hpp"

namespace talus::project {
namespace {

const std::string sample_text = R"(name = "Slope"

[terrain]
mesh = "data/slope.obj"

[[material]]
name = "A"
normal_restitution = { mean = 0.5 }

[[material]]
name = "B"
"strange key" = [1, [2, 3]]
)";

TEST(SettingPaths, LocateAValue) {
  const Document document(sample_text, "slope.toml");
  const SettingPaths paths(document.root());
  const toml::table& root = document.root();
  EXPECT_EQ(paths.of(*root.get("name")), "name");
  EXPECT_EQ(paths.of(*root["terrain"]["mesh"].node()), "terrain.mesh");
  EXPECT_EQ(paths.of(*root["material"].node()), "material");
  EXPECT_EQ(paths.of(*root["material"][1].node()), "material.1");
  EXPECT_EQ(paths.of(*root["material"][0]["normal_restitution"]["mean"].node()), "material.0.normal_restitution.mean");
  EXPECT_EQ(paths.of(*root["material"][1]["strange key"][1][0].node()), "material.1.\"strange key\".1.0");
  EXPECT_EQ(paths.of(root), "");
  const Document other(sample_text, "slope.toml");
  EXPECT_EQ(paths.of(*other.root().get("name")), "");  // of another document
}

TEST(SettingPaths, LocateTheFirstValueOnALine) {
  const Document document(sample_text, "slope.toml");
  const SettingPaths paths(document.root());
  EXPECT_EQ(paths.on_line(1), "name");
  EXPECT_EQ(paths.on_line(2), "");
  EXPECT_EQ(paths.on_line(3), "terrain");
  EXPECT_EQ(paths.on_line(6), "material.0");
  EXPECT_EQ(paths.on_line(8), "material.0.normal_restitution");
  EXPECT_EQ(paths.on_line(10), "material.1");
  EXPECT_EQ(paths.of_text("data/slope.obj"), "terrain.mesh");
  EXPECT_EQ(paths.of_text("slope.obj"), "");
}

TEST(SettingPaths, IncludeValuesSetLater) {
  Document document(sample_text, "slope.toml");
  Problems problems;
  EXPECT_EQ(document.at(*document.root()["material"][0].node()).path, "material.0");
  document.set("material.0.normal_restitution.std_dev=0.1", problems);
  document.set("output.vtk=true", problems);
  EXPECT_EQ(document.at(*document.root()["material"][0]["normal_restitution"]["std_dev"].node()).path,
            "material.0.normal_restitution.std_dev");
  EXPECT_EQ(document.at(*document.root()["output"]["vtk"].node()).path, "output.vtk");
}

TEST(SettingPaths, AreNotInTheTextOfAProblem) {
  const Document document(sample_text, "slope.toml");
  Problem problem = document.at(*document.root().get("name"));
  problem.what = "is not a name";
  EXPECT_EQ(problem.text(), "slope.toml:1: is not a name");
}

TEST(ProblemPaths, AreFoundByLineFileAndTable) {
  const auto path_of = [](Problem problem) {
    Problems problems;
    problems.add(std::move(problem));
    return with_paths(problems, sample_text, "folder/slope.toml").list().front().path;
  };
  EXPECT_EQ(path_of({.file = "folder/slope.toml", .line = 10, .what = "is off the terrain"}), "material.1");
  EXPECT_EQ(path_of({.file = "folder/slope.toml", .line = 500, .what = "is off the terrain"}), "");
  EXPECT_EQ(path_of({.file = "data/slope.obj", .line = 7, .what = "has no vertex 9"}), "terrain.mesh");
  EXPECT_EQ(path_of({.file = "folder/data/slope.obj", .what = "has no vertex 9"}), "terrain.mesh");
  EXPECT_EQ(path_of({.file = "other.obj", .what = "has no vertex 9"}), "");
  EXPECT_EQ(path_of({.file = "folder/slope.toml", .where = "[ground]", .what = "raster does not reach"}), "ground");
  EXPECT_EQ(path_of({.file = "folder/slope.toml", .where = "terrain", .what = "mesh[2] has no area"}),
            "terrain.mesh.2");
  EXPECT_EQ(path_of({.file = "folder/slope.toml", .where = "terrain", .what = "others[2] have no area"}), "terrain");
  EXPECT_EQ(path_of({.file = "x", .what = "", .path = "known.before"}), "known.before");
}

TEST(ProblemPaths, StayEmptyIfTheTextIsNotToml) {
  Problems problems;
  problems.add(Problem{.file = "slope.toml", .line = 1, .what = "this is not TOML"});
  EXPECT_EQ(with_paths(problems, "[[", "slope.toml").list().front().path, "");
}

}  // namespace
}  // namespace talus::project
