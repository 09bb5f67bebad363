#include "talus/trajectory/kept_outlines.hpp"

#include <gtest/gtest.h>

namespace talus::kept_outlines_test {
namespace {

/// A surface that counts its queries; the point of an outline contains the facet's number.
struct CountingSurface {
  mutable int queries = 0;
  [[nodiscard]] Outline outline(FacetId facet) const {
    ++queries;
    Outline outline;
    outline.point = Vec3(facet.index, 0, 0);
    return outline;
  }
};

TEST(KeptOutlines, QueryTheSurfaceOnceForTheLastFour) {
  const CountingSurface surface;
  KeptOutlines kept;
  for (int round = 0; round < 3; ++round) {
    for (const std::uint32_t facet : {7U, 0U, 9U, 4U}) {
      EXPECT_EQ(kept.of(surface, FacetId{facet}).point.x(), facet);
    }
  }
  EXPECT_EQ(surface.queries, 4);
  EXPECT_EQ(kept.of(surface, FacetId{5}).point.x(), 5);  // replaces the oldest
  EXPECT_EQ(kept.of(surface, FacetId{0}).point.x(), 0);
  EXPECT_EQ(surface.queries, 5);
  EXPECT_EQ(kept.of(surface, FacetId{7}).point.x(), 7);
  EXPECT_EQ(surface.queries, 6);
}

TEST(KeptOutlines, AreValidUntilFourOthersAreRequested) {
  const CountingSurface surface;
  KeptOutlines kept;
  const Outline& first = kept.of(surface, FacetId{1});
  for (const std::uint32_t facet : {2U, 3U, 4U}) static_cast<void>(kept.of(surface, FacetId{facet}));
  EXPECT_EQ(first.point.x(), 1);
}

}  // namespace
}  // namespace talus::kept_outlines_test
