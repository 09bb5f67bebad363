// Terrain from several meshes, and from meshes whose y points up.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_folder.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/model.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

using ::testing::HasSubstr;
using testing_tools::InputFolder;

// Two squares of 10 by 10 m, side by side, that fall by 5 m each towards +x.
const std::string upper = "v 0 0 10\nv 10 0 5\nv 10 10 5\nv 0 10 10\nf 1 2 3\nf 1 3 4\n";
const std::string lower = "v 10 0 5\nv 20 0 0\nv 20 10 0\nv 10 10 5\nf 1 2 3\nf 1 3 4\n";

class MeshList : public InputFolder {
 protected:
  MeshList() {
    write("upper.obj", upper);
    write("lower.obj", lower);
  }
  static std::string text(const std::string& terrain, const std::string& ground = "default = \"Rock\"") {
    return "[terrain]\n" + terrain + R"(
crs = "local"
[[material]]
name = "Rock"
[[material]]
name = "Soil"
[ground]
)" + ground +
           R"(
[[seeder]]
position = [5, 5, "surface"]
mass_kg = 100
)";
  }
  [[nodiscard]] Model model(const std::string& project) {
    write("slope.toml", project);
    Reading reading = read_project(path("slope.toml"));
    warnings_ = reading.warnings;
    project_ = reading.project;
    return build_model(reading.project, warnings_);
  }
  [[nodiscard]] std::string refusal(const std::string& project) {
    return refusal_of([&] { static_cast<void>(model(project)); });
  }
  static double elevation(const Model& model, double x, double y) {
    const Vec3 at = model.frame.local_from_global({x, y, 0});
    return std::get<TriangleMesh>(*model.surface).elevation(at.x(), at.y()).value_or(-1e9) + model.frame.origin.z();
  }

  Project project_;
};

TEST_F(MeshList, IsJoinedToOneSurface) {
  const Model built = model(text("mesh = [\"upper.obj\", \"lower.obj\"]"));
  EXPECT_EQ(warnings(), "");
  EXPECT_EQ(std::get<TriangleMesh>(*built.surface).facet_count(), 4U);
  EXPECT_NEAR(elevation(built, 5, 5), 7.5, 1e-12);
  EXPECT_NEAR(elevation(built, 15, 5), 2.5, 1e-12);
  EXPECT_THAT(built.terrain_report, HasSubstr("upper.obj: triangles 0 to 1\nlower.obj: triangles 2 to 3\n"));
  EXPECT_EQ(echo(project_)["terrain"]["mesh"].dump(), R"(["upper.obj","lower.obj"])");
}

TEST_F(MeshList, MayHaveCornersThatAreAlmostEqual) {
  write("lower.obj", "v 10.0004 0 5\nv 20 0 0\nv 20 10 0\nv 10 10.0004 5\nf 1 2 3\nf 1 3 4\n");
  const std::string apart = "mesh = [\"upper.obj\", \"lower.obj\"]\nmerge_tolerance_m = 0";
  EXPECT_LT(elevation(model(text(apart)), 10.0002, 5), -1e6);  // a crack
  const Model merged = model(text("mesh = [\"upper.obj\", \"lower.obj\"]"));
  EXPECT_EQ(warnings(), "");
  EXPECT_NEAR(elevation(merged, 10.0002, 5), 5, 1e-3);
}

TEST_F(MeshList, NumbersItsTrianglesFileAfterFile) {
  const Model built = model(text("mesh = [\"upper.obj\", \"lower.obj\"]", "triangles = [0, 0, 1, 1]"));
  const auto& mesh = std::get<TriangleMesh>(*built.surface);
  for (std::uint32_t k = 0; k < mesh.facet_count(); ++k) {
    const bool is_lower = mesh.outline({k}).edges[1].point.x() + built.frame.origin.x() > 15 ||
                          mesh.outline({k}).edges[2].point.x() + built.frame.origin.x() > 15;
    EXPECT_EQ(built.ground.material_of(mesh.source({k})).index, is_lower ? 1U : 0U) << k;
  }
}

TEST_F(MeshList, OfOneFileIsThatFile) {
  EXPECT_EQ(std::get<TriangleMesh>(*model(text("mesh = [\"upper.obj\"]")).surface).facet_count(), 2U);
  EXPECT_EQ(echo(project_)["terrain"]["mesh"], "upper.obj");
}

TEST_F(MeshList, ReportsProblemsOfAllItsFiles) {
  EXPECT_THAT(refusal(text("mesh = [\"upper.obj\", \"upper.obj\", \"a.stl\", \"b.tif\", 5]")),
              HasSubstr("mesh[4] is 5 (expected a text in quotes)"));
  const std::string wrong = refusal(text("mesh = [\"upper.obj\", \"upper.obj\", \"a.stl\", \"b.tif\"]"));
  EXPECT_THAT(wrong, HasSubstr("slope.toml:2: [terrain]: mesh[1] is \"upper.obj\" (it is listed twice). Leave it out"));
  EXPECT_THAT(wrong, HasSubstr("slope.toml:2: [terrain]: mesh[2] is \"a.stl\" (there is no such file)"));
  EXPECT_THAT(wrong,
              HasSubstr("slope.toml:2: [terrain]: mesh[3] is \"b.tif\" (expected a file that ends in .obj, .stl or "
                        ".ply)"));
  EXPECT_THAT(refusal(text("mesh = []")), HasSubstr("mesh is [] (expected one file or more)"));
  EXPECT_THAT(refusal(text("mesh = 3")), HasSubstr("mesh is 3 (expected a file name in quotes, or a list of them)"));
  write("upper.obj", "v 0 0\n");
  write("lower.obj", "f x\n");
  const std::string both = refusal(text("mesh = [\"upper.obj\", \"lower.obj\"]"));
  EXPECT_THAT(both, HasSubstr("mesh[0] upper.obj:1"));
  EXPECT_THAT(both, HasSubstr("mesh[1] lower.obj:1"));
}

TEST_F(MeshList, RefusesCornersThatDoNotExist) {
  write("upper.obj", "v 0 0 10\nv 10 0 5\nv 10 10 5\nf 1 2 4\n");
  EXPECT_THAT(refusal(text("mesh = [\"upper.obj\", \"lower.obj\"]")), HasSubstr("upper.obj"));
}

TEST_F(MeshList, WarnsOfAToleranceWithoutEffect) {
  static_cast<void>(model(text("mesh = \"upper.obj\"\nmerge_tolerance_m = 0.1")));
  EXPECT_THAT(warnings(),
              HasSubstr("merge_tolerance_m has no effect (there is one mesh, in which only equal vertices are "
                        "merged). Leave it out"));
}

// (x, y, z) of the file is (x, -z, y): a right-handed turn, so that what lies to the left stays to the left.
TEST_F(MeshList, MayHaveItsYUp) {
  write("turned.obj", "v 0 10 0\nv 10 5 0\nv 10 5 -10\nv 0 10 -10\nf 1 2 3\nf 1 3 4\n");
  const Model turned = model(text("mesh = \"turned.obj\"\nup = \"y\"")), straight = model(text("mesh = \"upper.obj\""));
  const auto &a = std::get<TriangleMesh>(*turned.surface), &b = std::get<TriangleMesh>(*straight.surface);
  ASSERT_EQ(a.facet_count(), b.facet_count());
  EXPECT_EQ(turned.frame.origin, straight.frame.origin);
  for (std::uint32_t k = 0; k < a.facet_count(); ++k) {
    const Outline one = a.outline({k}), other = b.outline({k});
    for (std::size_t e = 0; e < 3; ++e) EXPECT_EQ(one.edges[e].point, other.edges[e].point);
  }
  static_cast<void>(refusal(text("mesh = \"turned.obj\"")));
  EXPECT_THAT(warnings(),
              HasSubstr("\"turned.obj\" seems to lie on its side (as a whole it is 90 degrees steep and faces "
                        "along y; z points up). If y points up in the file, write up = \"y\" in [terrain]"));
}

}  // namespace
}  // namespace talus::project
