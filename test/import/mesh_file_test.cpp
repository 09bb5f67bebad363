#include "talus/import/mesh_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "talus/import/mesh_formats.hpp"

namespace talus {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using ::testing::ElementsAre;

// A folder for one test, gone with it.
class MeshFile : public ::testing::Test {
 protected:
  MeshFile() {
    const auto* const info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path{::testing::TempDir()} /
              ("talus_mesh_" + std::string{info->name()} + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~MeshFile() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  [[nodiscard]] RawMesh read(const std::string& name, std::string_view bytes) {
    std::ofstream{path(name), std::ios::binary}.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    warnings_ = Problems{};
    return read_mesh_file(path(name), warnings_);
  }

  // What the user is told, without the folder.
  [[nodiscard]] std::string without_folder(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) text.erase(at, prefix.size());
    return text;
  }

  [[nodiscard]] std::string refusal(const std::string& name) const {
    try {
      static_cast<void>(read_mesh_file(path(name)));
    } catch (const BadInput& error) {
      return without_folder(error.what());
    }
    return "was read";
  }

  [[nodiscard]] std::string refusal(const std::string& name, std::string_view bytes) {
    try {
      static_cast<void>(read(name, bytes));
    } catch (const BadInput& error) {
      return without_folder(error.what());
    }
    return "was read";
  }

  [[nodiscard]] std::string warnings() const { return without_folder(warnings_.text()); }

  std::filesystem::path folder_;
  Problems warnings_;
};

template <class T>
std::string bytes_of(T value, std::endian order) {
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return {bytes.data(), bytes.size()};
}

std::string binary_stl(std::uint32_t declared, const std::vector<std::array<std::array<float, 3>, 3>>& triangles,
                       std::string head = "made by hand") {
  head.resize(80, ' ');
  std::string out = head + bytes_of(declared, std::endian::little);
  for (const auto& triangle : triangles) {
    out += std::string(12, '\0');
    for (const auto& corner : triangle) {
      for (const float value : corner) out += bytes_of(value, std::endian::little);
    }
    out += std::string(2, '\0');
  }
  return out;
}

const std::array<std::array<float, 3>, 3> one_stl_triangle{{{0, 0, 0}, {1, 0, 0.5F}, {0, 1, 0.25F}}};

// Coordinates of Swiss size, to a tenth of a micrometre: not to be had in single precision.
const std::vector<Vec3> swiss{{2'600'000.123456, 1'200'000.654321, 450.0000001},
                              {2'600'001.123456, 1'200'000.654321, 451.25},
                              {2'600'000.123456, 1'200'001.654321, 449.75}};

std::string binary_ply(std::endian order, bool faces_first = false) {
  const std::string vertices =
      "element vertex 3\nproperty uchar red\nproperty double x\nproperty double y\n"
      "property double z\nproperty list uchar short tags\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nproperty float quality\n";
  std::string vertex_bytes;
  for (const Vec3& v : swiss) {
    vertex_bytes += '\x7f';
    for (int axis = 0; axis < 3; ++axis) vertex_bytes += bytes_of(v[axis], order);
    vertex_bytes += '\x02' + bytes_of(std::int16_t{5}, order) + bytes_of(std::int16_t{-7}, order);
  }
  std::string face_bytes = "\x03";
  for (const std::int32_t corner : {2, 0, 1}) face_bytes += bytes_of(corner, order);
  face_bytes += bytes_of(0.5F, order);
  const std::string format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
  return "ply\nformat " + format + " 1.0\ncomment by hand\n" + (faces_first ? faces + vertices : vertices + faces) +
         "end_header\n" + (faces_first ? face_bytes + vertex_bytes : vertex_bytes + face_bytes);
}

const std::string text_ply =
    "ply\nformat ascii 1.0\ncomment a square\nobj_info by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nelement face 2\nproperty list uchar int vertex_index\nelement edge 1\n"
    "property int from\nproperty int to\nend_header\n"
    "2600000.123456 0 0 255\n1 0 0 255\n1 1 0 255\n0 1 0 255\n3 0 1 2\n3 0 2 3\n0 2\n";

const std::string text_stl =
    "solid a slope\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0.5\n   vertex 0 1 0.25\n"
    "  endloop\n endfacet\nendsolid a slope\n";

const std::string square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string replaced(std::string text, std::string_view old_part, std::string_view new_part) {
  const auto at = text.find(old_part);
  EXPECT_NE(at, std::string::npos) << old_part;
  return text.replace(at, old_part.size(), new_part);
}

double area_in_plan(const RawMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Vec3 b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    sum += a.cross(b).z() / 2;
  }
  return sum;
}

// ---- OBJ ----

TEST_F(MeshFile, ObjGivesVerticesAndFaces) {
  const RawMesh mesh = read("a.obj",
                            "# a slope\nmtllib x.mtl\no slope\nv 0 0 1.5\nv 1 0 -2e-3\nv 0 +1 0\nvn 0 0 1\nvt 0 0\n"
                            "usemtl rock\ns off\ng all\nf 1 2 3\nl 1 2\n");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{0, 0, 1.5}, Vec3{1, 0, -0.002}, Vec3{0, 1, 0}));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_EQ(warnings(), "");
}

TEST_F(MeshFile, ObjKeepsEveryBitOfLargeCoordinates) {
  const RawMesh mesh = read("a.OBJ",
                            "v 2600000.123456 1200000.654321 450.0000001\nv 2600001.123456 1200000.654321 451.25\n"
                            "v 2600000.123456 1200001.654321 449.75\nf 1 2 3\n");
  EXPECT_EQ(mesh.vertices, swiss);
}

TEST_F(MeshFile, ObjTakesEveryFormOfCorner) {
  const RawMesh mesh = read("a.obj", square_obj +
                                         "f 1 2 3\nf 1/1 2/2 3/3\nf 1//1 2//1 3//1\nf 1/1/1 2/2/1 3/3/1\n"
                                         "f -4 -3 -2\nf -4/-1 -3/-1 -2/-1\nf 1/ 2/ 3/\n");
  EXPECT_THAT(mesh.triangles, ::testing::AllOf(::testing::SizeIs(7), ::testing::Each(Triangle{0, 1, 2})));
}

TEST_F(MeshFile, ObjRelativeIndicesCountBackFromTheirLine) {
  const RawMesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST_F(MeshFile, ObjMayNameVerticesThatComeLater) {
  EXPECT_THAT(read("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\n").triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST_F(MeshFile, ObjLeavesOutColoursAndWeights) {
  const RawMesh mesh = read("a.obj", "v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 1 0.1 0.2 0.3\nf 1 2 3\n");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}));
}

TEST_F(MeshFile, ObjLinesMayBeContinuedAndEndInCrLf) {
  const RawMesh mesh =
      read("a.obj", "\xEF\xBB\xBFv 0 \\\r\n0 0\r\nv 1 0 0 # the second\r\nv 0 1 0\r\n\r\nf 1 \\\r\n2 \\\r\n3");
  EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}));
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST_F(MeshFile, ObjCommentThatEndsInABackslashIsNotContinued) {
  EXPECT_EQ(read("a.obj", "# from C:\\slopes\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").vertices.size(), 3U);
}

TEST_F(MeshFile, ObjWarnsOfStatementsThatItLeavesOut) {
  static_cast<void>(read("a.obj", square_obj + "curv 0 1 1 2\ncurv 0 1 1 2\nf 1 2 3\n"));
  EXPECT_EQ(
      warnings(),
      "a.obj:5: warning: the statement \"curv\" is left out (Talus reads vertices (v) and faces (f) of OBJ files)");
}

TEST_F(MeshFile, ObjRefusals) {
  EXPECT_EQ(refusal("a.obj", "f 1 2 3\n"),
            "a.obj: has no vertices (an OBJ file has a line such as `v 1.0 2.0 3.0` for each)");
  EXPECT_EQ(refusal("a.obj", square_obj),
            "a.obj: has no faces (points alone are not a surface). Triangulate the points first");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 0 1 2\n"),
            "a.obj:5: vertex 0 does not exist (OBJ counts vertices from 1)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 5\n"),
            "a.obj:5: vertex 5 does not exist (the file has 4, counted from 1)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 -5\n"),
            "a.obj:5: vertex -5 does not exist (counted back from this line there are 4)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 4294967296\n"),
            "a.obj:5: vertex 4294967296 does not exist (an index has at most 32 bits)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2 4294967295\n"),
            "a.obj:5: vertex 4294967295 does not exist (the file has 4, counted from 1)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f 1 2\n"), "a.obj:5: a face with 2 corners (expected at least 3)");
  EXPECT_EQ(refusal("a.obj", square_obj + "f\n"), "a.obj:5: a face with 0 corners (expected at least 3)");
  for (const std::string corner : {"three", "3.0", "3/x", "3/1/1/1", "/3", "99999999999999999999"}) {
    EXPECT_EQ(
        refusal("a.obj", square_obj + "f 1 2 " + corner + "\n"),
        "a.obj:5: \"" + corner + "\" is not a corner of a face (expected 7, 7/1, 7//3 or 7/1/3, all whole numbers)");
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
            "a.obj:1: \"1e999\" cannot be held by a 64-bit number (expected a coordinate in metres)");
  EXPECT_EQ(refusal("a.obj", "v 0 0\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: a vertex with 2 coordinates (expected x, y and z)");
  EXPECT_EQ(refusal("a.obj", "v 7\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: a vertex with 1 coordinate (expected x, y and z)");
  EXPECT_EQ(refusal("a.obj", "v 1 2 3 4 5 6 7 8 9\n" + square_obj + "f 1 2 3\n"),
            "a.obj:1: a vertex with more than 8 numbers (expected x, y, z, and at most a weight and a colour)");
}

TEST_F(MeshFile, ObjTellsAllProblemsAtOnceWithTheirLines) {
  EXPECT_EQ(refusal("a.obj", "v 0 0 x\n# fine\nv 1 0 0\nv 1 1\n\nf 1 2 3\nf 1 2 0\nf 1 2 9\n"),
            "a.obj:1: \"x\" is not a number (expected a coordinate in metres)\n"
            "a.obj:4: a vertex with 2 coordinates (expected x, y and z)\n"
            "a.obj:7: vertex 0 does not exist (OBJ counts vertices from 1)\n"
            "a.obj:8: vertex 9 does not exist (the file has 3, counted from 1)");
}

TEST_F(MeshFile, ObjStopsAfterTwentyProblems) {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += "v a b c\n";
  const std::string text = refusal("a.obj", bytes);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 20);
  EXPECT_THAT(text, ::testing::EndsWith("\na.obj: reading stopped (20 errors were found so far)"));
}

TEST_F(MeshFile, MessagesShowForeignTextFitForATerminal) {
  EXPECT_EQ(
      refusal("a.obj", std::string{"v 0 0 \x1b[31m\x01\xff"} + std::string(100, 'x') + "\n" + square_obj + "f 1 2 3\n"),
      "a.obj:1: \"?[31m??" + std::string(33, 'x') + "...\" is not a number (expected a coordinate in metres)");
}

// ---- faces of many corners ----

TEST_F(MeshFile, ConvexFacesBecomeFans) {
  EXPECT_THAT(read("a.obj", square_obj + "f 1 2 3 4\n").triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST_F(MeshFile, ConcaveFacesAreCutInside) {
  // An L whose first corner does not see all of it.
  const std::string vertices = "v 2 1 5\nv 1 1 5\nv 1 2 5\nv 0 2 5\nv 0 0 5\nv 2 0 5\n";
  const RawMesh mesh = read("a.obj", vertices + "f 1 2 3 4 5 6\n");
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_DOUBLE_EQ(area_in_plan(mesh), 3.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    RawMesh one{mesh.vertices, {mesh.triangles[i]}};
    EXPECT_GT(area_in_plan(one), 0) << i;
  }
  EXPECT_DOUBLE_EQ(area_in_plan(read("b.obj", vertices + "f 6 5 4 3 2 1\n")), -3.0);
}

TEST_F(MeshFile, RandomStarShapedFacesKeepTheirAreaInAnyPlane) {
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> radius{0.1, 10};
  for (int trial = 0; trial < 200; ++trial) {
    const int corners = 4 + trial % 30;
    const Vec3 u = Vec3{radius(random), radius(random), radius(random)}.normalized();
    const Vec3 v = u.unitOrthogonal();
    std::string bytes;
    std::string face = "f";
    std::vector<Vec3> points;
    Vec3 doubled_area = Vec3::Zero();
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const Vec3 p = Vec3{2'600'000, 1'200'000, 500} + radius(random) * (std::cos(angle) * u + std::sin(angle) * v);
      points.push_back(p);
      std::array<char, 120> line{};
      std::snprintf(line.data(), line.size(), "v %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
      bytes += line.data();
      face += " " + std::to_string(i + 1);
    }
    for (int i = 0; i < corners; ++i)
      doubled_area += (points[i] - points[0]).cross(points[(i + 1) % corners] - points[0]);
    const RawMesh mesh = read("a.obj", bytes + face + "\n");
    ASSERT_EQ(mesh.triangles.size(), static_cast<std::size_t>(corners) - 2);
    double sum = 0;  // of areas, each counted positive: equal to the face's only if no triangle lies on another
    for (const Triangle& t : mesh.triangles) {
      sum += (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
    }
    EXPECT_NEAR(sum, doubled_area.norm(), 1e-6) << trial;
  }
}

TEST_F(MeshFile, CornersInLineWithTheirNeighboursStayCornersOfRealTriangles) {
  // (1 0 0) lies on the side of the square; a fan from (0 0 0) would give it a triangle without area.
  const RawMesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
  EXPECT_EQ(mesh.triangles.size(), 3U);
  for (const Triangle& t : mesh.triangles) EXPECT_GT(area_in_plan({mesh.vertices, {t}}), 0.5);
}

TEST_F(MeshFile, FacesWithRepeatedCornersLoseThem) {
  EXPECT_THAT(read("a.obj", square_obj + "f 1 2 2 3 1\n").triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(read("b.obj", square_obj + "f 1 2 2 1\n").triangles, ElementsAre(Triangle{0, 1, 1}));
}

TEST_F(MeshFile, FacesThatCannotBeCutAreRefused) {
  EXPECT_EQ(
      refusal("a.obj", "v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 1 0\nf 1 2 3 4\n"),
      "a.obj:5: a face with 4 corners crosses itself (it cannot be cut into triangles). Triangulate it in the program "
      "that made it");
  EXPECT_EQ(
      refusal("a.obj", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n"),
      "a.obj:5: a face with 4 corners crosses itself (it cannot be cut into triangles). Triangulate it in the program "
      "that made it");
  std::string many = "f";
  for (int i = 0; i < 1001; ++i) many += i % 2 == 0 ? " 1" : " 2";
  EXPECT_EQ(refusal("a.obj", square_obj + many + "\n"),
            "a.obj:5: a face with 1001 corners (Talus cuts faces of up to 1000 into triangles). Triangulate it in the "
            "program that made it");
}

// ---- STL ----

TEST_F(MeshFile, StlTextGivesThreeVerticesATriangle) {
  for (const std::string& bytes :
       {text_stl, replaced(text_stl, "solid a slope\n", "SOLID\r\n"), text_stl + "solid again\nendsolid\n",
        "\n" + replaced(text_stl, "   vertex", "\tVertex ")}) {
    const RawMesh mesh = read("a.stl", bytes);
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0.5}, Vec3{0, 1, 0.25}));
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
  }
}

TEST_F(MeshFile, StlBinaryGivesTheSame) {
  for (const std::string head : {"made by hand", "solid in spite of being binary"}) {
    const RawMesh mesh = read("a.stl", binary_stl(2, {one_stl_triangle, one_stl_triangle}, head));
    EXPECT_EQ(mesh.vertices.size(), 6U);
    EXPECT_EQ(mesh.vertices[4], (Vec3{1, 0, 0.5}));
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{3, 4, 5}));
    EXPECT_EQ(warnings(), "");
  }
}

TEST_F(MeshFile, StlBinaryWarnsOfSinglePrecision) {
  auto far = one_stl_triangle;
  far[1][0] = 2'600'000;
  static_cast<void>(read("a.stl", binary_stl(1, {far})));
  EXPECT_EQ(
      warnings(),
      "a.stl: warning: coordinates are stored in single precision (near 2600000 m such numbers are 0.25 m apart). "
      "Write the file in double precision, or subtract an offset before writing it");
}

TEST_F(MeshFile, StlRefusals) {
  EXPECT_EQ(refusal("a.stl", "hello\n"),
            "a.stl: is not an STL file (it has 6 bytes and does not begin with \"solid\"; a binary STL file has at "
            "least 84)");
  EXPECT_EQ(
      refusal("a.stl", binary_stl(3, {one_stl_triangle, one_stl_triangle})),
      "a.stl: declares 3 triangles, but its length does not fit (that takes 234 bytes; the file has 184). It may have "
      "been cut short");
  EXPECT_EQ(
      refusal("a.stl", binary_stl(4'294'967'295, {one_stl_triangle})),
      "a.stl: declares 4294967295 triangles, but its length does not fit (that takes 214748364834 bytes; the file has "
      "134). It may have been cut short");
  EXPECT_EQ(
      refusal("a.stl", binary_stl(3, {one_stl_triangle}, "solid but cut short") + std::string(1, '\0')),
      "a.stl: declares 3 triangles, but its length does not fit (that takes 234 bytes; the file has 135). It may have "
      "been cut short");
  EXPECT_EQ(refusal("a.stl", binary_stl(1, {one_stl_triangle, one_stl_triangle})),
            "a.stl: declares 1 triangle, but its length does not fit (that takes 134 bytes; the file has 184). Its "
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

// ---- PLY ----

TEST_F(MeshFile, PlyTextIsReadAsDoublesWhateverItsHeaderSays) {
  for (const bool crlf : {false, true}) {
    std::string bytes = text_ply;
    for (std::size_t at = 0; crlf && (at = bytes.find('\n', at)) != std::string::npos; at += 2) bytes.insert(at, "\r");
    const RawMesh mesh = read("a.ply", bytes);
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{2'600'000.123456, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}));
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    EXPECT_EQ(warnings(), "");
  }
}

TEST_F(MeshFile, PlyBinaryOfEitherByteOrderKeepsEveryBit) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const bool faces_first : {false, true}) {
      const RawMesh mesh = read("a.ply", binary_ply(order, faces_first));
      EXPECT_EQ(mesh.vertices, swiss);
      EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{2, 0, 1}));
      EXPECT_EQ(warnings(), "");
    }
  }
}

TEST_F(MeshFile, PlyReadsEveryNumberType) {
  struct Case {
    std::string type;
    std::string minus_three;
  };
  const auto little = std::endian::little;
  const std::vector<Case> cases{
      {"char", bytes_of(std::int8_t{-3}, little)},   {"int8", bytes_of(std::int8_t{-3}, little)},
      {"short", bytes_of(std::int16_t{-3}, little)}, {"int16", bytes_of(std::int16_t{-3}, little)},
      {"int", bytes_of(std::int32_t{-3}, little)},   {"int32", bytes_of(std::int32_t{-3}, little)},
      {"float32", bytes_of(-3.0F, little)},          {"float64", bytes_of(-3.0, little)}};
  for (const Case& c : cases) {
    const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty " + c.type +
                               " x\nproperty uint16 y\nproperty uint z\nelement face 1\n"
                               "property list ushort uint8 vertex_indices\nend_header\n";
    std::string body;
    for (int i = 0; i < 3; ++i) {
      body += c.minus_three + bytes_of(std::uint16_t{65'535}, little) + bytes_of(std::uint32_t{4'000'000'000}, little);
    }
    body += bytes_of(std::uint16_t{3}, little) + std::string{"\0\1\2", 3};
    const RawMesh mesh = read("a.ply", header + body + std::string{"\0\n", 2});
    EXPECT_EQ(mesh.vertices[2], (Vec3{-3, 65'535, 4'000'000'000})) << c.type;
    EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
  }
}

TEST_F(MeshFile, PlyBinaryWarnsOfSinglePrecision) {
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
  for (int i = 0; i < 9; ++i) bytes += bytes_of(-1'200'000.0F * static_cast<float>(i % 2), std::endian::big);
  static_cast<void>(read("a.ply", bytes + std::string{"\3\0\1\2", 4}));
  EXPECT_EQ(
      warnings(),
      "a.ply: warning: coordinates are stored in single precision (near 1200000 m such numbers are 0.12 m apart). "
      "Write the file in double precision, or subtract an offset before writing it");
}

TEST_F(MeshFile, PlyHeaderRefusals) {
  const auto with = [&](std::string_view old_part, std::string_view new_part) {
    return refusal("a.ply", replaced(text_ply, old_part, new_part));
  };
  EXPECT_EQ(refusal("a.ply", "polygons\n"), "a.ply:1: is not a PLY file (its first line must be `ply`)");
  EXPECT_EQ(with("format ascii 1.0\n", ""),
            "a.ply:14: the header names no format (expected `format ascii 1.0` or the like)");
  EXPECT_EQ(with("ascii", "text"),
            "a.ply:2: the format \"text\" is unknown (expected ascii, binary_little_endian or binary_big_endian)");
  EXPECT_EQ(with("1.0", "2.0"), "a.ply:2: the version \"2.0\" is unknown (expected 1.0)");
  EXPECT_EQ(with("obj_info", "objinfo"),
            "a.ply:4: \"objinfo\" is not a statement of a PLY header (expected format, element, property, comment, "
            "obj_info or "
            "end_header)");
  EXPECT_EQ(refusal("a.ply", text_ply.substr(0, text_ply.find("end_header"))),
            "a.ply:14: the header has no end (expected `end_header`). The file may have been cut short");
  EXPECT_EQ(with("vertex 4", "vertex -4"),
            "a.ply:5: \"-4\" is not a number of elements (expected `element vertex 8` or the like)");
  EXPECT_EQ(with("vertex 4", "vertex"),
            "a.ply:5: \"\" is not a number of elements (expected `element vertex 8` or the like)");
  EXPECT_EQ(with("element vertex 4\n", ""), "a.ply:5: a property before any element (it belongs to none)");
  EXPECT_EQ(
      with("float y", "real y"),
      "a.ply:7: the type \"real\" is unknown (expected char, uchar, short, ushort, int, uint, float or double, or int8 "
      "to float64)");
  EXPECT_EQ(with("list uchar", "list float"),
            "a.ply:11: the length of a list has a type with a fraction (expected uchar, int or the like)");
  EXPECT_EQ(with("uchar red", "uchar"),
            "a.ply:9: a property without a name (expected `property double x` or the like)");
  EXPECT_EQ(with("float y", "float height"),
            "a.ply:5: the element \"vertex\" must have the properties x, y and z, once each (they are its position)");
  EXPECT_EQ(with("float y", "float x"),
            "a.ply:5: the element \"vertex\" must have the properties x, y and z, once each (they are its position)");
  EXPECT_EQ(with("float y", "list int float y"),
            "a.ply:5: the element \"vertex\" must have the properties x, y and z, once each (they are its position)");
  EXPECT_EQ(with("vertex_index", "corners"),
            "a.ply:10: the element \"face\" must have one list vertex_indices of whole numbers (they are its corners)");
  EXPECT_EQ(with("uchar int vertex_index", "uchar float vertex_index"),
            "a.ply:10: the element \"face\" must have one list vertex_indices of whole numbers (they are its corners)");
  EXPECT_EQ(with("property int from\nproperty int to\n", ""),
            "a.ply:12: the element \"edge\" has no properties (so nothing can be read of it)");
  EXPECT_EQ(with("element edge 1", "element face 1\nproperty list uchar int vertex_index"),
            "a.ply:10: the element \"face\" is declared more than once (expected one)\n"
            "a.ply:12: the element \"face\" is declared more than once (expected one)");
  EXPECT_EQ(with("element vertex", "element point"), "a.ply: has no vertices (the header declares no element vertex)");
  EXPECT_EQ(with("element face 2", "element face 0"),
            "a.ply: has no faces (the header declares no element face). Triangulate the points first");
  EXPECT_EQ(with("element face", "element tristrips"),
            "a.ply: has no faces (the header declares no element face). Write triangles instead of strips");
}

TEST_F(MeshFile, PlyTextRefusals) {
  const auto with = [&](std::string_view old_part, std::string_view new_part) {
    return refusal("a.ply", replaced(text_ply, old_part, new_part));
  };
  EXPECT_EQ(
      with("vertex 4", "vertex 18446744073709551615"),
      "a.ply:5: the header declares 18446744073709551615 of \"vertex\" (what is left of the file has room for 9 at "
      "most). The file may have been cut short");
  EXPECT_EQ(
      with("face 2", "face 11"),
      "a.ply:10: the header declares 11 of \"face\" (what is left of the file has room for 10 at most). The file may "
      "have been cut short");
  EXPECT_EQ(with("face 2", "face 5"),
            "a.ply:22: the line has more values than the header declares (each element has its own line)\n"
            "a.ply:22: the file ends too early (face 4 of 5 is missing). It may have been cut short");
  EXPECT_EQ(
      with("edge 1", "edge 0"),
      "a.ply:22: the file goes on after its last element (the header declares fewer elements than there are lines)");
  EXPECT_EQ(with("3 0 1 2", "3 0 1"),
            "a.ply:20: the line has fewer values than the header declares (vertex_index is missing)");
  EXPECT_EQ(with("3 0 1 2", "3 0 1 2 3"),
            "a.ply:20: the line has more values than the header declares (each element has its own line)");
  EXPECT_EQ(with("3 0 1 2", "4000000000 0 1 2"),
            "a.ply:20: the line has fewer values than the header declares (vertex_index is missing)");
  EXPECT_EQ(with("3 0 1 2", "-3 0 1 2"), "a.ply:20: a list with -3 values (a length is not negative)");
  EXPECT_EQ(with("3 0 1 2", "2 0 1"), "a.ply:20: a face with 2 corners (expected at least 3)");
  EXPECT_EQ(with("3 0 1 2", "1 0"), "a.ply:20: a face with 1 corner (expected at least 3)");
  EXPECT_EQ(with("3 0 1 2", "3 0 1 x"), "a.ply:20: \"x\" is not a whole number (expected vertex_index)");
  EXPECT_EQ(with("3 0 1 2", "3 0 1 -1"), "a.ply:20: vertex -1 does not exist (PLY counts vertices from 0)");
  EXPECT_EQ(with("3 0 1 2", "3 0 1 4"), "a.ply:20: vertex 4 does not exist (the file has 4, counted from 0)");
  EXPECT_EQ(with("1 1 0 255", "1 1"), "a.ply:18: the line has fewer values than the header declares (z is missing)");
  EXPECT_EQ(with("1 1 0 255", "1 NaN 0 255"),
            "a.ply:18: \"NaN\" is not a finite number (expected a coordinate in metres)");
  EXPECT_EQ(refusal("a.ply", text_ply.substr(0, text_ply.find("0 2\n"))),
            "a.ply:12: the header declares 1 of \"edge\" (what is left of the file has room for 0 at most). The file "
            "may have "
            "been cut short");
}

TEST_F(MeshFile, PlyBinaryRefusals) {
  const std::string good = binary_ply(std::endian::little);
  EXPECT_EQ(refusal("a.ply", good.substr(0, good.size() - 1)),
            "a.ply: face 1 of 1: the file ends too early (3 bytes are left of 4 needed). It may have been cut short");
  EXPECT_EQ(refusal("a.ply", good + "more"),
            "a.ply: 4 bytes follow the last element (the header declares fewer elements than there are)");
  EXPECT_EQ(
      refusal("a.ply", replaced(good, "vertex 3", "vertex 4000000000")),
      "a.ply:4: the header declares 4000000000 of \"vertex\" (what is left of the file has room for 4 at most). The "
      "file may have been cut short");
  const std::string one_face =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\n"
      "property char z\nelement face 1\nproperty list int int vertex_indices\nend_header\n"
      "abcdefgix";
  const auto corners = [](std::vector<std::int32_t> values) {
    std::string out;
    for (const std::int32_t value : values) out += bytes_of(value, std::endian::little);
    return out;
  };
  EXPECT_EQ(
      refusal("a.ply", one_face + corners({2'000'000'000, 0, 1, 2})),
      "a.ply: face 1 of 1: a list with 2000000000 values (12 bytes are left in the file). The file may be damaged");
  EXPECT_EQ(refusal("a.ply", one_face + corners({-1, 0, 1, 2})),
            "a.ply: face 1 of 1: a list with -1 values (12 bytes are left in the file). The file may be damaged");
  EXPECT_EQ(refusal("a.ply", one_face + corners({3, 0, 1, -2})),
            "a.ply: face 1 of 1: vertex -2 does not exist (PLY counts vertices from 0)");
  EXPECT_EQ(refusal("a.ply", one_face + corners({3, 0, 1, 3})),
            "a.ply: face 1 of 1: vertex 3 does not exist (the file has 3, counted from 0)");
  EXPECT_EQ(refusal("a.ply", one_face + corners({0})),
            "a.ply: face 1 of 1: a face with 0 corners (expected at least 3)");
  std::string infinite = good;
  const std::string inf = bytes_of(std::numeric_limits<double>::infinity(), std::endian::little);
  infinite.replace(infinite.find("end_header\n") + 11 + 1, 8, inf);
  EXPECT_EQ(refusal("a.ply", infinite), "a.ply: vertex 1 of 3: a coordinate is not a finite number (expected metres)");
}

// ---- files ----

TEST_F(MeshFile, FilesThatCannotBeRead) {
  EXPECT_EQ(refusal("nowhere.obj"),
            "nowhere.obj: cannot be read (No such file or directory). Paths are relative to the project file");
  std::filesystem::create_directory(path("folder.stl"));
  EXPECT_EQ(refusal("folder.stl"), "folder.stl: cannot be read (it is a folder). Name a file");
  EXPECT_EQ(refusal("empty.ply", ""), "empty.ply: is empty (it has no bytes)");
  EXPECT_EQ(refusal("slope.dxf", "0\n"),
            "slope.dxf: is not a mesh that Talus can read (its name ends in \".dxf\"; expected .obj, .stl or .ply). "
            "Convert it, or "
            "name the file after its format");
  EXPECT_EQ(
      refusal("slope", "0\n"),
      "slope: is not a mesh that Talus can read (its name has no ending; expected .obj, .stl or .ply). Convert it, "
      "or name "
      "the file after its format");
}

TEST_F(MeshFile, FilesThatAreNotOrdinary) {
  std::filesystem::create_symlink("/dev/zero", path("endless.obj"));
  EXPECT_EQ(refusal("endless.obj"), "endless.obj: cannot be read (it is not an ordinary file)");
}

TEST_F(MeshFile, FilesThatAreTooLarge) {
  std::ofstream{path("huge.obj")} << "v 0 0 0\n";
  std::error_code error;
  std::filesystem::resize_file(path("huge.obj"), largest_mesh_file_bytes, error);  // a hole; takes no room on the disk
  if (error) GTEST_SKIP() << "this disk has no files with holes: " << error.message();
  EXPECT_EQ(
      refusal("huge.obj"),
      "huge.obj: is too large (4294967295 bytes; Talus reads up to 4294967294). Cut the mesh to the slope, or use a "
      "raster");
}

TEST_F(MeshFile, FilesWithoutPermission) {
  std::ofstream{path("secret.obj")} << square_obj;
  std::filesystem::permissions(path("secret.obj"), std::filesystem::perms::none);
  if (::geteuid() == 0) GTEST_SKIP() << "the superuser may read everything";
  EXPECT_EQ(refusal("secret.obj"),
            "secret.obj: cannot be read (Permission denied). Paths are relative to the project file");
}

// ---- anything at all ----

// Bytes changed, left out, put in, repeated or cut off at random: a mesh with indices that exist, or BadInput.
TEST(MeshFileMutations, GiveAMeshOrBadInput) {
  struct Seed {
    RawMesh (*read)(std::string_view, MeshProblems&);
    std::string bytes;
  };
  const std::string obj =
      "# x\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0\nv 0 1 \\\n0\nv 0.5 0.5 0\nf 1 2 5 3 4\nf -3//1 2/1 1/2/3\n";
  const std::vector<Seed> seeds{{read_obj, obj},
                                {read_stl, text_stl},
                                {read_stl, binary_stl(2, {one_stl_triangle, one_stl_triangle})},
                                {read_ply, text_ply},
                                {read_ply, binary_ply(std::endian::little)},
                                {read_ply, binary_ply(std::endian::big, true)}};
  std::mt19937_64 random{20240229};
  const auto below = [&](std::size_t n) { return static_cast<std::ptrdiff_t>(random() % n); };
  int read = 0;
  int refused = 0;
  for (int trial = 0; trial < 12'000; ++trial) {
    const Seed& seed = seeds[static_cast<std::size_t>(trial) % seeds.size()];
    std::string bytes = seed.bytes;
    for (auto changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes) {
      const auto at = bytes.begin() + below(bytes.size());
      switch (below(6)) {
        case 0:
          *at = static_cast<char>(below(256));
          break;
        case 1:
          *at = static_cast<char>('0' + below(10));
          break;
        case 2:
          bytes.erase(at);
          break;
        case 3:
          bytes.insert(at, static_cast<char>(below(256)));
          break;
        case 4:
          bytes.insert(static_cast<std::size_t>(at - bytes.begin()), bytes, 0, static_cast<std::size_t>(below(20)));
          break;
        default:
          bytes.erase(at + below(static_cast<std::size_t>(bytes.end() - at)), bytes.end());
          break;
      }
    }
    MeshProblems problems{"mutated"};
    try {
      const RawMesh mesh = seed.read(bytes, problems);
      ++read;
      EXPECT_FALSE(mesh.triangles.empty());
      for (const Vec3& v : mesh.vertices) EXPECT_TRUE(v.allFinite());
      for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t v : t) EXPECT_LT(v, mesh.vertices.size());
      }
    } catch (const BadInput& error) {
      ++refused;
      EXPECT_THAT(error.what(), ::testing::StartsWith("mutated"));
    }
  }
  // Both ends are met often, or the test shows nothing.
  EXPECT_GT(read, 500);
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace talus
