// Wavefront OBJ.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/mesh_files.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using Corners = std::array<std::uint32_t, 3>;
using ::testing::ElementsAre;

class MeshObj : public MeshFiles {};

TEST_F(MeshObj, ReadsVerticesAndFaces) {
  const RawMesh mesh = read("a.obj",
                            "# a slope\nmtllib x.mtl\no slope\nv 0 0 1.5\nv 1 0 -2e-3\nv 0 +1 0\nvn 0 0 1\nvt 0 0\n"
                            "usemtl rock\ns off\ng all\nf 1 2 3\nl 1 2\n");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{0, 0, 1.5}, Vec3{1, 0, -0.002}, Vec3{0, 1, 0}));
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}));
  EXPECT_EQ(warnings(), "");
}

TEST_F(MeshObj, KeepsEveryBitOfLargeCoordinates) {
  const RawMesh mesh = read("a.OBJ",
                            "v 2600000.123456 1200000.654321 450.0000001\nv 2600001.123456 1200000.654321 451.25\n"
                            "v 2600000.123456 1200001.654321 449.75\nf 1 2 3\n");
  EXPECT_EQ(mesh.vertices, swiss);
}

TEST_F(MeshObj, ReadsEveryFormOfCorner) {
  const RawMesh mesh = read("a.obj", square_obj +
                                         "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf 1/1/1 2/2/1 3/3/1\n"
                                         "f -4 -3 -2\nf -4/-1 -3/-1 -2/-1\nf 1/ 2/ 3/\n");
  EXPECT_THAT(mesh.triangles, ::testing::AllOf(::testing::SizeIs(7), ::testing::Each(Corners{0, 1, 2})));
}

TEST_F(MeshObj, RelativeIndicesCountBackFromTheirLine) {
  const RawMesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}, Corners{0, 2, 3}));
}

TEST_F(MeshObj, FacesMayPrecedeTheirVertices) {
  EXPECT_THAT(read("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\n").triangles, ElementsAre(Corners{0, 1, 2}));
}

TEST_F(MeshObj, IgnoresColoursAndWeights) {
  const RawMesh mesh = read("a.obj", "v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 1 0.1 0.2 0.3\nf 1 2 3\n");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}));
}

TEST_F(MeshObj, LinesMayBeContinuedAndEndInCrLf) {
  const RawMesh mesh =
      read("a.obj", "\xEF\xBB\xBFv 0 \\\r\n0 0\r\nv 1 0 0 # the second\r\nv 0 1 0\r\n\r\nf 1 \\\r\n2 \\\r\n3");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}));
  EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}));
}

TEST_F(MeshObj, ACommentThatEndsInABackslashIsNotContinued) {
  EXPECT_EQ(read("a.obj", "# from C:\\slopes\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").vertices.size(), 3U);
}

TEST_F(MeshObj, WarnsOfStatementsThatItIgnores) {
  static_cast<void>(read("a.obj", square_obj + "curv 0 1 1 2\ncurv 0 1 1 2\nf 1 2 3\n"));
  EXPECT_EQ(
      warnings(),
      "a.obj:5: warning: the statement \"curv\" is ignored (Talus reads vertices (v) and faces (f) of OBJ files)");
}

TEST_F(MeshObj, RefusesBadStatements) {
  EXPECT_EQ(refusal("a.obj", "f 1 2 3\n"),
            "a.obj: has no vertices (an OBJ file has a line such as `v 1.0 2.0 3.0` for each)");
  EXPECT_EQ(refusal("a.obj", square_obj),
            "a.obj: has no faces (points alone are not a surface). Triangulate the points first");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 0 1 2\n"),
            "a.obj:5: vertex 0 does not exist (OBJ numbers vertices from 1)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 5\n"),
            "a.obj:5: vertex 5 does not exist (the file has 4 vertices, numbered from 1)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 -5\n"),
            "a.obj:5: vertex -5 does not exist (4 vertices precede this line)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 4294967296\n"),
            "a.obj:5: vertex 4294967296 does not exist (an index has at most 32 bits)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 4294967295\n"),
            "a.obj:5: vertex 4294967295 does not exist (the file has 4 vertices, numbered from 1)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2\n"), "a.obj:5: a face with 2 corners (expected at least 3)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f\n"), "a.obj:5: a face with 0 corners (expected at least 3)");
  for (const std::string corner : {"three", "3.0", "3/x", "3/1/1/1", "/3", "99999999999999999999"}) {
    EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 " + corner + "\n"),
              "a.obj:5: \"" + corner + "\" is not a corner of a face (expected 7, 7/1, 7//3 or 7/1/3, all integers)");
  }
  EXPECT_EQ(refusal("a.obj", "v 0 0 abc\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: \"abc\" is not a number (expected a coordinate in metres)");
  EXPECT_EQ(refusal("a.obj", "v 0 0 1,5\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: \"1,5\" is not a number (expected a coordinate in metres). Write decimals with a point");
  EXPECT_EQ(refusal("a.obj", "v 0 0 nan\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: \"nan\" is not a finite number (expected a coordinate in metres)");
  EXPECT_EQ(refusal("a.obj", "v 0 -inf 0\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: \"-inf\" is not a finite number (expected a coordinate in metres)");
  EXPECT_EQ(refusal("a.obj", "v 0 1e999 0\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: \"1e999\" is out of range for a 64-bit number (expected a coordinate in metres)");
  EXPECT_EQ(refusal("a.obj", "v 0 0\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: a vertex with 2 coordinates (expected x, y and z)");
  EXPECT_EQ(refusal("a.obj", "v 7\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: a vertex with 1 coordinate (expected x, y and z)");
  EXPECT_EQ(refusal("a.obj", "v 1 2 3 4 5 6 7 8 9\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: a vertex with more than 8 numbers (expected x, y, z, and at most a weight and a colour)");
}

TEST_F(MeshObj, ReportsAllErrorsAtOnceWithTheirLines) {
  EXPECT_EQ(refusal("a.obj", "v 0 0 x\n# fine\nv 1 0 0\nv 1 1\n\nf 1 2 3\nf 1 2 0\nf 1 2 9\n"),
            "a.obj:1: \"x\" is not a number (expected a coordinate in metres)\n"
            "a.obj:4: a vertex with 2 coordinates (expected x, y and z)\n"
            "a.obj:7: vertex 0 does not exist (OBJ numbers vertices from 1)\n"
            "a.obj:8: vertex 9 does not exist (the file has 3 vertices, numbered from 1)");
}

TEST_F(MeshObj, StopsAfterTwentyErrors) {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += "v a b c\n";
  const std::string text = refusal("a.obj", bytes);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 20);
  EXPECT_THAT(text, ::testing::EndsWith("\na.obj: reading stopped (20 errors were found so far)"));
}

TEST_F(MeshObj, MessagesQuoteTextSafelyForATerminal) {
  EXPECT_EQ(
      refusal("a.obj", std::string{"v 0 0 \x1b[31m\x01\xff"} + std::string(100, 'x') + "\n" + square_obj + "f 1 2 3\n"),
      "a.obj:1: \"?[31m?ÿ" + std::string(33, 'x') + "...\" is not a number (expected a coordinate in metres)");
}

}  // namespace
}  // namespace talus
