#include "talus/seeding/release_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace talus::release_lines_test {
namespace {

ReleaseLines along(const std::vector<Vec3>& points) { return ReleaseLines(points); }

TEST(ReleaseLines, HaveEqualProbabilityPerMetre) {
  const ReleaseLines line = along({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 3, 0}});  // one metre, zero, three metres
  EXPECT_EQ(line.length(), 4);
  EXPECT_LT((line.at(0.125).point - Vec3(0.5, 0, 0)).norm(), 1e-15);
  EXPECT_LT((line.at(0.25).point - Vec3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((line.at(0.5).point - Vec3(1, 1, 0)).norm(), 1e-15);
  EXPECT_LT((line.at(1 - 1e-16).point - Vec3(1, 3, 0)).norm(), 1e-12);
}

TEST(ReleaseLines, EqualSharesAreEquallyLong) {
  const ReleaseLines line = along({{0, 0, 10}, {4, 0, 7}, {4, 12, 2}, {-3, 12, 2}});
  const double length = 5 + 13 + 7;
  EXPECT_NEAR(line.length(), length, 1e-12);
  double travelled = 0;
  Vec3 previous = line.at(1e-9).point;
  for (int k = 1; k <= 5000; ++k) {
    const Vec3 here = line.at(std::min(k / 5000.0, 1 - 1e-16)).point;
    const double step = (here - previous).norm();
    ASSERT_LE(step, length / 5000 + 1e-9);  // shorter only across a corner
    travelled += step;
    previous = here;
  }
  EXPECT_NEAR(travelled, length, 2 * length / 5000);
}

TEST(ReleaseLines, SeveralShareTheRocksByTheirLengths) {
  const std::vector<Vec3> near{{0, 0, 0}, {1, 0, 0}}, far{{100, 0, 5}, {100, 2, 5}, {100, 3, 5}};
  ReleaseLines lines;
  lines.add(near, SourceId{7});
  lines.add(far, SourceId{2});
  EXPECT_EQ(lines.length(), 4);
  int on_near = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto [point, source] = lines.at((k + 0.5) / 1000);
    if (point.x() <= 1) {
      ++on_near;
      EXPECT_EQ(source, SourceId{7});
      EXPECT_EQ(point.y(), 0);
    } else {
      EXPECT_EQ(source, SourceId{2});
      EXPECT_EQ(point.x(), 100);
      EXPECT_EQ(point.z(), 5);
    }
  }
  EXPECT_EQ(on_near, 250);
}

TEST(ReleaseLines, MayHaveManyVertices) {
  std::vector<Vec3> points;
  for (int k = 0; k <= 100'000; ++k) points.emplace_back(0.25 * k, 0, 0);
  const ReleaseLines line = along(points);
  for (int k = 0; k < 100'000; ++k) {
    const double u = (k + 0.5) / 100'000;
    ASSERT_NEAR(line.at(u).point.x(), u * 25'000, 1e-9);
  }
}

}  // namespace
}  // namespace talus::release_lines_test
