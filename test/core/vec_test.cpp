#include "talus/core/vec.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "support/print_vec.hpp"

namespace talus::vec_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

static_assert(std::is_trivially_copyable_v<Vec3> && sizeof(Vec3) == 3 * sizeof(double));
static_assert(Vec3(1, 2, 3).cross({-2, 0.5, 4}) == Vec3(6.5, -10, 4.5));
static_assert(Vec3(Vec2(1, 2), 3) == Vec3(1, 2, 3) && Vec3(1, 2, 3).xy() == Vec2(1, 2));

TEST(Vec, AddsTheLastTwoProductsFirst) {
  // 1e16 + (1 + 1), which is not (1e16 + 1) + 1.
  const Vec3 a(1e8, 1, 1), b(1e8, 1, 1);
  EXPECT_EQ(a.dot(b), 1e16 + 2);
  EXPECT_EQ(Vec3(1e16, 1, 1).sum(), 1e16 + 2);
}

TEST(Vec, OfNoLengthHasNoDirection) {
  EXPECT_EQ(Vec3{}.normalized(), Vec3{});
  EXPECT_EQ(Vec3(0, 3, -4).normalized(), Vec3(0, 3.0 / 5, -4.0 / 5));
  EXPECT_EQ(Vec2(3, 4).norm(), 5);
}

TEST(Vec, ComparesCoordinateByCoordinate) {
  const Vec3 a(1, -2, 3), b(0, 5, 3);
  EXPECT_EQ(a.min(b), Vec3(0, -2, 3));
  EXPECT_EQ(a.max(b), Vec3(1, 5, 3));
  EXPECT_EQ(a.abs().largest(), 3);
  EXPECT_EQ(b.place_of_largest(), 1U);
  EXPECT_EQ(Vec3(7, 7, 1).place_of_largest(), 0U);
  EXPECT_FALSE(a.is_at_most(b));
  EXPECT_TRUE(a.min(b).is_at_most(b));
  EXPECT_EQ(Vec2(-2.5, 2.5).rounded(), Vec2(-3, 3));
}

TEST(Vec, NoticesWhatIsNotANumber) {
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3 v(1, 2, 3);
    v[k] = nan;
    EXPECT_FALSE(v.is_finite());
    EXPECT_FALSE(v.is_at_most(v));
    EXPECT_EQ(Vec3(1, 2, 3).min(v), Vec3(1, 2, 3));
    v[k] = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(v.is_finite());
  }
  EXPECT_TRUE(Vec3(1, 2, 3).is_finite());
}

}  // namespace
}  // namespace talus::vec_test
