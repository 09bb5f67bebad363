// PLY, text and binary.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/mesh_files.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using Corners = std::array<std::uint32_t, 3>;
using ::testing::ElementsAre;

class MeshPly : public MeshFiles {};

TEST_F(MeshPly, TextIsReadAsDoublesWhateverTheHeaderDeclares) {
  for (const bool crlf : {false, true}) {
    std::string bytes = text_ply;
    for (std::size_t at = 0; crlf && (at = bytes.find('\n', at)) != std::string::npos; at += 2) bytes.insert(at, "\r");
    const RawMesh mesh = read("a.ply", bytes);
    EXPECT_THAT(mesh.vertices, ElementsAre(Vec3{2'600'000.123456, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}));
    EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}, Corners{0, 2, 3}));
    EXPECT_EQ(warnings(), "");
  }
}

TEST_F(MeshPly, BinaryInEitherByteOrderKeepsEveryBit) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const bool faces_first : {false, true}) {
      const RawMesh mesh = read("a.ply", binary_ply(order, faces_first));
      EXPECT_EQ(mesh.vertices, swiss);
      EXPECT_THAT(mesh.triangles, ElementsAre(Corners{2, 0, 1}));
      EXPECT_EQ(warnings(), "");
    }
  }
}

TEST_F(MeshPly, ReadsEveryNumberType) {
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
    EXPECT_THAT(mesh.triangles, ElementsAre(Corners{0, 1, 2}));
  }
}

TEST_F(MeshPly, WarnsOfSinglePrecision) {
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

TEST_F(MeshPly, RefusesBadHeaders) {
  const auto with = [&](std::string_view old_part, std::string_view new_part) {
    return refusal("a.ply", replaced(text_ply, old_part, new_part));
  };
  EXPECT_EQ(refusal("a.ply", "polygons\n"), "a.ply:1: is not a PLY file (its first line must be `ply`)");
  EXPECT_EQ(with("format ascii 1.0\n", ""), "a.ply:14: the header has no format (for example `format ascii 1.0`)");
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
            "a.ply:5: \"-4\" is not a count of elements (for example `element vertex 8`)");
  EXPECT_EQ(with("vertex 4", "vertex"), "a.ply:5: \"\" is not a count of elements (for example `element vertex 8`)");
  EXPECT_EQ(with("element vertex 4\n", ""),
            "a.ply:5: a property before any element (a property belongs to the element before it)");
  EXPECT_EQ(
      with("float y", "real y"),
      "a.ply:7: the type \"real\" is unknown (expected char, uchar, short, ushort, int, uint, float or double, or int8 "
      "to float64)");
  EXPECT_EQ(with("list uchar", "list float"),
            "a.ply:11: the length of a list has no integer type (for example uchar or int)");
  EXPECT_EQ(with("uchar red", "uchar"), "a.ply:9: a property without a name (for example `property double x`)");
  EXPECT_EQ(with("float y", "float height"),
            "a.ply:5: the element \"vertex\" must have the properties x, y and z, once each (they are its position)");
  EXPECT_EQ(with("float y", "float x"),
            "a.ply:5: the element \"vertex\" must have the properties x, y and z, once each (they are its position)");
  EXPECT_EQ(with("float y", "list int float y"),
            "a.ply:5: the element \"vertex\" must have the properties x, y and z, once each (they are its position)");
  EXPECT_EQ(with("vertex_index", "corners"),
            "a.ply:10: the element \"face\" must have one list vertex_indices of integers (they are its corners)");
  EXPECT_EQ(with("uchar int vertex_index", "uchar float vertex_index"),
            "a.ply:10: the element \"face\" must have one list vertex_indices of integers (they are its corners)");
  EXPECT_EQ(with("property int from\nproperty int to\n", ""),
            "a.ply:12: the element \"edge\" has no properties (so there is nothing to read)");
  EXPECT_EQ(with("element edge 1", "element face 1\nproperty list uchar int vertex_index"),
            "a.ply:10: the element \"face\" is declared more than once (expected one)\n"
            "a.ply:12: the element \"face\" is declared more than once (expected one)");
  EXPECT_EQ(with("element vertex", "element point"), "a.ply: has no vertices (the header declares no element vertex)");
  EXPECT_EQ(with("element face 2", "element face 0"),
            "a.ply: has no faces (the header declares no element face). Triangulate the points first");
  EXPECT_EQ(with("element face", "element tristrips"),
            "a.ply: has no faces (the header declares no element face). Write triangles instead of strips");
}

TEST_F(MeshPly, RefusesBadText) {
  const auto with = [&](std::string_view old_part, std::string_view new_part) {
    return refusal("a.ply", replaced(text_ply, old_part, new_part));
  };
  EXPECT_EQ(with("vertex 4", "vertex 18446744073709551615"),
            "a.ply:5: the header declares 18446744073709551615 of \"vertex\" (the rest of the file has room for 9 at "
            "most). The file may have been cut short");
  EXPECT_EQ(with("face 2", "face 11"),
            "a.ply:10: the header declares 11 of \"face\" (the rest of the file has room for 10 at most). The file may "
            "have been cut short");
  EXPECT_EQ(with("face 2", "face 5"),
            "a.ply:22: the line has more values than the header declares (each element has its own line)\n"
            "a.ply:22: the file ends too early (face 4 of 5 is missing). It may have been cut short");
  EXPECT_EQ(
      with("edge 1", "edge 0"),
      "a.ply:22: the file continues after its last element (the header declares fewer elements than there are lines)");
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
  EXPECT_EQ(with("3 0 1 2", "3 0 1 -1"), "a.ply:20: vertex -1 does not exist (PLY numbers vertices from 0)");
  EXPECT_EQ(with("3 0 1 2", "3 0 1 4"), "a.ply:20: vertex 4 does not exist (the file has 4 vertices, numbered from 0)");
  EXPECT_EQ(with("1 1 0 255", "1 1"), "a.ply:18: the line has fewer values than the header declares (z is missing)");
  EXPECT_EQ(with("1 1 0 255", "1 NaN 0 255"),
            "a.ply:18: \"NaN\" is not a finite number (expected a coordinate in metres)");
  EXPECT_EQ(refusal("a.ply", text_ply.substr(0, text_ply.find("0 2\n"))),
            "a.ply:12: the header declares 1 of \"edge\" (the rest of the file has room for 0 at most). The file "
            "may have "
            "been cut short");
}

TEST_F(MeshPly, RefusesBadBinaryFiles) {
  const std::string good = binary_ply(std::endian::little);
  EXPECT_EQ(refusal("a.ply", good.substr(0, good.size() - 1)),
            "a.ply: face 1 of 1: the file ends too early (4 bytes are needed, 3 remain). It may have been cut short");
  EXPECT_EQ(refusal("a.ply", good + "more"),
            "a.ply: 4 bytes follow the last element (the header declares fewer elements than there are)");
  EXPECT_EQ(refusal("a.ply", replaced(good, "vertex 3", "vertex 4000000000")),
            "a.ply:4: the header declares 4000000000 of \"vertex\" (the rest of the file has room for 4 at most). The "
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
  EXPECT_EQ(refusal("a.ply", one_face + corners({2'000'000'000, 0, 1, 2})),
            "a.ply: face 1 of 1: a list with 2000000000 values (12 bytes remain in the file). The file may be damaged");
  EXPECT_EQ(refusal("a.ply", one_face + corners({-1, 0, 1, 2})),
            "a.ply: face 1 of 1: a list with -1 values (12 bytes remain in the file). The file may be damaged");
  EXPECT_EQ(refusal("a.ply", one_face + corners({3, 0, 1, -2})),
            "a.ply: face 1 of 1: vertex -2 does not exist (PLY numbers vertices from 0)");
  EXPECT_EQ(refusal("a.ply", one_face + corners({3, 0, 1, 3})),
            "a.ply: face 1 of 1: vertex 3 does not exist (the file has 3 vertices, numbered from 0)");
  EXPECT_EQ(refusal("a.ply", one_face + corners({0})),
            "a.ply: face 1 of 1: a face with 0 corners (expected at least 3)");
  std::string infinite = good;
  const std::string inf = bytes_of(std::numeric_limits<double>::infinity(), std::endian::little);
  infinite.replace(infinite.find("end_header\n") + 11 + 1, 8, inf);
  EXPECT_EQ(refusal("a.ply", infinite), "a.ply: vertex 1 of 3: a coordinate is not a finite number (expected metres)");
}

}  // namespace
}  // namespace talus
