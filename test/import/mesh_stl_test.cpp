// STL, text and binary.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/mesh_files.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using Corners = std::array<std::uint32_t, 3>;
using ::testing::ElementsAre;

class MeshStl : public MeshFiles {};

TEST_F(MeshStl, TextHasThreeVerticesPerTriangle) {
  for (const std::string& bytes :
       {text_stl, replaced(text_stl, "solid a slope\n", "SOLID\r\n"), text_stl + "solid again\nendsolid\n",
        "\n" + replaced(text_stl, "   vertex", "\tVertex ")}) {
    const RawMesh mesh = read("a.stl", bytes);
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0.5}, Vec3{0, 1, 0.25}));
    EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}));
  }
}

TEST_F(MeshStl, BinaryHasThreeVerticesPerTriangle) {
  for (const std::string head : {"made by hand", "solid in spite of being binary"}) {
    const RawMesh mesh = read("a.stl", binary_stl(2, {one_stl_triangle, one_stl_triangle}, head));
    EXPECT_EQ(mesh.vertices.size(), 6U);
    EXPECT_EQ(mesh.vertices[4], (Vec3{1, 0, 0.5}));
    EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}, Corners{3, 4, 5}));
    EXPECT_EQ(warnings(), "");
  }
}

TEST_F(MeshStl, WarnsOfSinglePrecision) {
  auto far = one_stl_triangle;
  far[1][0] = 2'600'000;
  static_cast<void>(read("a.stl", binary_stl(1, {far})));
  EXPECT_EQ(
      warnings(),
      "a.stl: warning: coordinates are stored in single precision (near 2600000 m such numbers are 0.25 m apart). "
      "Write the file in double precision, or subtract an offset before writing it");
}

TEST_F(MeshStl, RefusesBadFiles) {
  EXPECT_EQ(refusal("a.stl", "hello\n"),
            "a.stl: is not an STL file (it has 6 bytes and does not begin with \"solid\"; a binary STL file has at "
            "least 84)");
  EXPECT_EQ(
      refusal("a.stl", binary_stl(3, {one_stl_triangle, one_stl_triangle})),
      "a.stl: declares 3 triangles, but has the wrong length (they take 234 bytes; the file has 184). It may have "
      "been cut short");
  EXPECT_EQ(
      refusal("a.stl", binary_stl(4'294'967'295, {one_stl_triangle})),
      "a.stl: declares 4294967295 triangles, but has the wrong length (they take 214748364834 bytes; the file has "
      "134). It may have been cut short");
  EXPECT_EQ(
      refusal("a.stl", binary_stl(3, {one_stl_triangle}, "solid but cut short") + std::string(1, '\0')),
      "a.stl: declares 3 triangles, but has the wrong length (they take 234 bytes; the file has 135). It may have "
      "been cut short");
  EXPECT_EQ(refusal("a.stl", binary_stl(1, {one_stl_triangle, one_stl_triangle})),
            "a.stl: declares 1 triangle, but has the wrong length (they take 134 bytes; the file has 184). Its "
            "header may "
            "be damaged");
  EXPECT_EQ(refusal("a.stl", binary_stl(0, {})), "a.stl: has no triangles (a terrain needs at least one)");
  EXPECT_EQ(refusal("a.stl", "solid\nendsolid\n"), "a.stl: has no triangles (a terrain needs at least one)");
  auto bad = one_stl_triangle;
  bad[2][1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal("a.stl", binary_stl(2, {one_stl_triangle, bad})),
            "a.stl: triangle 2 of 2: a coordinate is not a finite number (expected metres)");
  EXPECT_EQ(refusal("a.stl", replaced(text_stl, "endsolid a slope\n", "")),
            "a.stl:8: the file ends too early (expected \"facet\" or \"endsolid\"). It may have been cut short");
  EXPECT_EQ(refusal("a.stl", text_stl.substr(0, text_stl.find("  endloop"))),
            "a.stl:6: the file ends too early (expected \"endloop\"). It may have been cut short");
  EXPECT_EQ(refusal("a.stl", text_stl.substr(0, text_stl.find("   vertex"))),
            "a.stl:3: the file ends too early (expected \"vertex\"). It may have been cut short");
  EXPECT_EQ(refusal("a.stl", text_stl.substr(0, text_stl.find("  outer"))),
            "a.stl:2: the file ends too early (expected \"outer loop\"). It may have been cut short");
  EXPECT_EQ(refusal("a.stl", text_stl.substr(0, text_stl.find(" endfacet"))),
            "a.stl:7: the file ends too early (expected \"endfacet\"). It may have been cut short");
  EXPECT_EQ(refusal("a.stl", text_stl + "facet\n"), "a.stl:10: \"facet\" is out of place (expected \"solid\")");
  EXPECT_EQ(refusal("a.stl", replaced(text_stl, "  endloop", "  vertex 1 1 1\n endloop")),
            "a.stl:7: \"vertex\" is out of place (expected \"endloop\")");
  EXPECT_EQ(refusal("a.stl", replaced(text_stl, "vertex 1 0 0.5", "vertex 1 0")),
            "a.stl:5: a vertex with 2 coordinates (expected x, y and z)");
  EXPECT_EQ(refusal("a.stl", replaced(replaced(text_stl, "vertex 1 0 0.5", "vertex 1 oh 0.5"), "0.25", "inf")),
            "a.stl:5: \"oh\" is not a number (expected a coordinate in metres)\n"
            "a.stl:6: \"inf\" is not a finite number (expected a coordinate in metres)");
}

}  // namespace
}  // namespace talus
