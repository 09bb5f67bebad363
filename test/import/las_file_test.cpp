#include "talus/import/las_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/input_folder.hpp"
#include "support/las.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;
using ::testing::Pair;

class LasFileTest : public InputFolder {
 protected:
  [[nodiscard]] LasFile read(const LasSpec& spec, const std::vector<std::int64_t>& classes = {}) const {
    LasBytes(spec).write(file_);
    return read_las_file(file_, classes);
  }
  [[nodiscard]] std::string refusal_of_file(const std::vector<std::int64_t>& classes = {}) const {
    return refusal_of([&] { static_cast<void>(read_las_file(file_, classes)); });
  }
  [[nodiscard]] std::string refusal(const LasSpec& spec, const std::vector<std::int64_t>& classes = {}) const {
    LasBytes(spec).write(file_);
    return refusal_of_file(classes);
  }

  /// Overwrites a byte of the file.
  void patch(int at, int value) const {
    std::fstream bytes(file_, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(at);
    bytes.put(static_cast<char>(value));
  }

  std::filesystem::path file_ = path("p.las");
};

LasSpec six_points(int minor = 2, int format = 0) {
  LasSpec spec;
  spec.minor = minor;
  spec.format = format;
  spec.offset = {600000, 5200000, 0};
  spec.points = {{{600001.25, 5200002.5, 812.07}, 2}, {{600011.25, 5200002.5, 830.5}, 5},
                 {{600001.25, 5200012.5, 815}, 2},    {{600006, 5200006, -50}, 7},
                 {{600007, 5200007, 814}, 2, true},   {{600007, 5200003, 814}, 0}};
  return spec;
}

TEST_F(LasFileTest, ReadsEveryFormatOfEveryVersion) {
  for (int minor = 0; minor <= 4; ++minor) {
    for (int format = 0; format <= 10; ++format) {
      LasSpec spec = six_points(minor, format);
      spec.extra_bytes = format % 3;
      const LasFile las = read(spec);
      ASSERT_EQ(las.points.size(), 4U) << "1." << minor << ", format " << format;
      for (const auto& [read, given] : {std::pair{0, 0}, {1, 1}, {2, 2}, {3, 5}}) {
        EXPECT_LT((las.points[static_cast<std::size_t>(read)] - spec.points[static_cast<std::size_t>(given)].at).norm(),
                  1e-8);
      }
      EXPECT_EQ(las.declared, 6U);
      EXPECT_EQ(las.withheld, 1U);
      EXPECT_THAT(las.of_class, ElementsAre(Pair(0, 1), Pair(2, 2), Pair(5, 1), Pair(7, 1)));
    }
  }
}

TEST_F(LasFileTest, ReadsManyBlocks) {
  LasSpec spec;
  for (int k = 0; k < 150'000; ++k)
    spec.points.push_back({{k % 400 + 0.01 * (k % 7), k / 400.0, 0.01 * (k % 1000)}, 2});
  const LasFile las = read(spec);
  ASSERT_EQ(las.points.size(), spec.points.size());
  for (std::size_t k = 0; k < las.points.size(); ++k)
    ASSERT_LT((las.points[k] - spec.points[k].at).abs().largest(), 0.0051);
}

TEST_F(LasFileTest, ReadsTheRequestedClasses) {
  EXPECT_EQ(read(six_points(), {2}).points.size(), 2U);
  EXPECT_EQ(read(six_points(4, 6), {2, 5}).points.size(), 3U);
  EXPECT_EQ(read(six_points(), {7}).points.size(), 1U);  // noise, on request
  EXPECT_EQ(
      refusal(six_points(), {3, 4}),
      "p.las: has no points of the classes in point_classes (it has 1 of class 0, 2 of class 2, 1 of class 5, 1 of "
      "class 7)");
}

TEST_F(LasFileTest, ReadsTheCoordinateSystem) {
  LasSpec spec = six_points();
  spec.geo_keys = {{1024, 1}, {3072, 31287}, {3076, 9001}, {4096, 5778}, {4099, 9001}};
  const LasCrs keys = read(spec).crs;
  EXPECT_EQ(keys.projected_epsg, 31287);
  EXPECT_EQ(keys.vertical_epsg, 5778);
  EXPECT_EQ(keys.plan_unit_epsg, 9001);
  EXPECT_EQ(keys.vertical_unit_epsg, 9001);
  EXPECT_FALSE(keys.is_geographic);
  spec.geo_keys = {{1024, 2}, {2048, 4326}, {3072, 32767}};
  const LasCrs degrees = read(spec).crs;
  EXPECT_TRUE(degrees.is_geographic);
  EXPECT_EQ(degrees.geographic_epsg, 4326);
  EXPECT_EQ(degrees.projected_epsg, std::nullopt);
  spec = six_points(4, 6);
  spec.wkt = "PROJCRS[\"x\"]";
  EXPECT_EQ(read(spec).crs.wkt, spec.wkt);
  EXPECT_EQ(read(six_points()).crs.wkt, "");
}

TEST_F(LasFileTest, RefusesFilesThatAreNotLas) {
  std::ofstream(file_) << "x,y,z\n1,2,3\n";
  EXPECT_EQ(refusal_of_file(), "p.las: is not a LAS file (its 12 bytes are less than a header)");
  std::ofstream(file_) << std::string(400, 'x');
  EXPECT_EQ(refusal_of_file(), "p.las: is not a LAS file (it does not begin with LASF)");
  std::filesystem::remove(file_);
  EXPECT_EQ(refusal_of_file(),
            "p.las: cannot be read (No such file or directory). Paths are relative to the project file");
  EXPECT_EQ(refusal(six_points(7)), "p.las: is LAS 1.7 (Talus reads 1.0 to 1.4)");
  LasBytes(six_points()).write(file_);
  patch(104, 11);
  EXPECT_EQ(refusal_of_file(), "p.las: has points of format 11 (Talus reads formats 0 to 10)");
}

TEST_F(LasFileTest, RefusesCompressedPointsWithTheCommandToUnpackThem) {
  LasBytes(six_points()).write(file_);
  patch(104, 128);
  EXPECT_EQ(refusal_of_file(),
            "p.las: is compressed (LAZ) (Talus reads LAS). Unpack it: pdal translate p.las p_unpacked.las");
}

TEST_F(LasFileTest, RefusesCountsThatDoNotFitTheFile) {
  LasSpec spec = six_points();
  spec.declared = 7;
  EXPECT_EQ(refusal(spec),
            "p.las: declares 7 points of 20 bytes from byte 227 (it has 347 bytes). Copy it again from its source");
  spec.minor = 4;
  spec.declared = std::uint64_t{1} << 60;
  EXPECT_EQ(
      refusal(spec),
      "p.las: declares 1152921504606846976 points (Talus reads fewer than 1073741824). Thin it, cut it to the slope, "
      "or make a raster from it");
  spec = six_points();
  spec.points.clear();
  EXPECT_EQ(refusal(spec), "p.las: has no points (its header says so)");
  spec = six_points();
  spec.scale = 0.01;
  LasBytes(spec).write(file_);
  patch(105, 10);
  EXPECT_EQ(refusal_of_file(), "p.las: has points of 10 bytes (those of format 0 have 20 or more)");
}

TEST_F(LasFileTest, RefusesImpossibleScalesAndHeights) {
  LasSpec spec = six_points();
  LasBytes(spec).write(file_);
  {
    std::fstream bytes(file_, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(131);
    const double zero = 0;
    bytes.write(reinterpret_cast<const char*>(&zero), 8);
  }
  EXPECT_EQ(refusal_of_file(),
            "p.las: has the scales 0, 0.01, 0.01 and the offsets 600000, 5.2e+06, 0 (scales must be more than 0, and "
            "all must be finite)");
  spec.points[0].at.z() = -9999;
  EXPECT_EQ(
      refusal(spec),
      "p.las: has heights such as -9999 m (1 of 4 points are below -9000 m or above 100000 m). Choose the ground with "
      "point_classes, or filter the file");
}

// With any byte damaged, a file is read or refused, but nothing worse.
TEST_F(LasFileTest, AnyByteMayBeWrong) {
  LasSpec spec = six_points(4, 6);
  spec.geo_keys = {{1024, 1}, {3072, 31287}};
  spec.wkt = "PROJCRS[\"x\"]";
  // Sizes, counts and scales; the positions of records; their contents.
  std::size_t refused = 0;
  for (const auto& [from, to] : {std::pair{94, 155}, {235, 255}, {375, 460}}) {
    for (int at = from; at < to; ++at) {
      for (const int value : {1, 255}) {
        LasBytes(spec).write(file_);
        patch(at, value);
        refused += refusal_of_file() != "was read";
      }
    }
  }
  EXPECT_GT(refused, 20U);
}

TEST_F(LasFileTest, RefusesCoordinatesTooFarFromTheOrigin) {
  LasSpec spec = six_points();
  spec.offset.x() = 1e12;
  for (LasPoint& point : spec.points) point.at.x() = 1e12;
  EXPECT_EQ(refusal(spec),
            "p.las: has coordinates such as 1e+12 (4 of 4 points are further than 1e+09 m from the origin). Its scales "
            "or offsets are wrong; copy it again from where it comes from");
}

TEST_F(LasFileTest, RefusesScalesThatGiveInfiniteCoordinates) {
  LasSpec spec = six_points();
  spec.scale = 1e305;
  spec.offset = Vec3{};
  EXPECT_EQ(
      refusal(spec),
      "p.las: has the scales 1e+305, 1e+305, 1e+305 and the offsets 0, 0, 0 (its coordinates would not be finite)");
}

}  // namespace
}  // namespace talus
