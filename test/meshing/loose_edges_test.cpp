#include "talus/meshing/loose_edges.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace talus::loose_edges_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Triangle = std::array<std::uint32_t, 3>;

const Vec3 far_away{2'600'000, 1'200'000, 500};

// Rectangles of two triangles each, which share no vertices.
class Sheets {
 public:
  Sheets& add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const Vec3& p : {a, b, c, d}) vertices_.push_back(p + far_away);
    triangles_.push_back({first, first + 1, first + 2});
    triangles_.push_back({first, first + 2, first + 3});
    return *this;
  }
  Sheets& level(double x0, double x1, double y0, double y1, double z = 0) {
    return add({x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z});
  }

  [[nodiscard]] LooseEdges find() const { return loose_edges(vertices_, triangles_, free_edges(triangles_), 0.01); }

 private:
  std::vector<Vec3> vertices_;
  std::vector<Triangle> triangles_;
};

TEST(LooseEdges, TheRimIsNotLoose) {
  const LooseEdges found = Sheets().level(0, 10, 0, 10).find();
  EXPECT_EQ(found.cracks.count, 0U);
  EXPECT_EQ(found.covered.count, 0U);
}

TEST(LooseEdges, AGapUpToTheWidthOfACrackIsOne) {
  for (const double gap : {0.0, 0.002, 0.009, 0.011, 1.0}) {
    SCOPED_TRACE(gap);
    const LooseEdges found = Sheets().level(0, 10, 0, 10).level(10 + gap, 20, 0, 10).find();
    EXPECT_EQ(found.cracks.count, gap < 0.01 ? 2U : 0U);
    EXPECT_EQ(found.covered.count, 0U);
  }
}

TEST(LooseEdges, ReportsThePlaces) {
  EXPECT_THAT(Sheets().level(0, 10, 0, 10).level(10.002, 20, 0, 10).find().cracks.examples,
              ElementsAre(far_away + Vec3{10, 5, 0}, far_away + Vec3{10.002, 5, 0}));
}

TEST(LooseEdges, ACornerOnASideIsACrack) {
  EXPECT_EQ(Sheets().level(0, 10, 0, 10).level(10, 20, 0, 5).level(10, 20, 5, 10).find().cracks.count, 3U + 2U);
}

TEST(LooseEdges, ASmallStepIsACrackAndALargeOneAnEnd) {
  EXPECT_EQ(Sheets().level(0, 10, 0, 10).level(10, 20, 0, 10, -0.004).find().cracks.count, 2U);
  EXPECT_EQ(Sheets().level(0, 10, 0, 10).level(10, 20, 0, 10, -0.1).find().cracks.count, 0U);
}

TEST(LooseEdges, AnEdgeBelowGroundIsCoveredAndOneAboveIsNot) {
  const LooseEdges found = Sheets().level(0, 10, 0, 10).level(5, 15, 0, 10, 3).find();
  EXPECT_EQ(found.cracks.count, 0U);
  EXPECT_EQ(found.covered.count, 1U);
  EXPECT_THAT(found.covered.examples, ElementsAre(far_away + Vec3{10, 5, 0}));
  // With ground below it, a rock that leaves the edge falls onto that.
  EXPECT_THAT(Sheets().level(0, 10, 0, 10).level(5, 15, 0, 10, 3).level(-5, 30, -5, 15, -3).find().covered.examples,
              IsEmpty());
}

TEST(LooseEdges, TheFootOfAWallBelowTheGroundIsCovered) {
  const LooseEdges found = Sheets().level(0, 20, 0, 10).add({10, 2, -1}, {10, 8, -1}, {6, 8, 9}, {6, 2, 9}).find();
  EXPECT_EQ(found.cracks.count, 0U);
  EXPECT_THAT(found.covered.examples, ElementsAre(far_away + Vec3{10, 5, -1}));
}

// Small steps of a rim, and a facet at the rim that is lower than a crack is wide.
TEST(LooseEdges, NarrowPartsOfTheRimAreNotCracks) {
  const std::vector<Vec3> steps{{0, 0, 0},       {0.01, 0, 0},    {0.01, 0.01, 0},
                                {0.02, 0.01, 0}, {0.02, 0.02, 0}, {-0.02, 0.02, 0}};
  const std::vector<Triangle> of_steps{{0, 1, 2}, {0, 2, 5}, {5, 2, 4}, {2, 3, 4}};
  EXPECT_EQ(loose_edges(steps, of_steps, free_edges(of_steps), 0.01).cracks.count, 0U);
  const std::vector<Vec3> low{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {5, -0.002, 0}};
  const std::vector<Triangle> of_low{{0, 1, 2}, {1, 0, 3}};
  EXPECT_EQ(loose_edges(low, of_low, free_edges(of_low), 0.01).cracks.count, 0U);
}

}  // namespace
}  // namespace talus::loose_edges_test
