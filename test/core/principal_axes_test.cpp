// Eigenvalues and eigenvectors of symmetric matrices that were made from them.

#include "talus/core/principal_axes.hpp"

#include <gtest/gtest.h>

#include "support/dice.hpp"
#include "talus/core/orientation.hpp"

namespace talus {
namespace {

TEST(PrincipalAxes, AreThoseThatTheMatrixWasMadeFrom) {
  testing_tools::Dice dice(9);
  for (int round = 0; round < 200; ++round) {
    const Vec3 values(3, round % 3 == 0 ? 3 : 2, round % 5 == 0 ? 1e-6 : 1);  // two are equal in a third of them
    const Mat3 made = in_world(Orientation::of_turn(3 * dice.direction()), values);
    const auto [found, axes] = principal_axes(made);
    EXPECT_LT((found - values).abs().largest(), 1e-14);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_LT((made * axes.rows[k] - found[k] * axes.rows[k]).norm(), 1e-14);
      EXPECT_NEAR(axes.rows[k].norm(), 1, 1e-14);
    }
    EXPECT_LT((axes.rows[0].cross(axes.rows[1]) - axes.rows[2]).norm(), 1e-14);
  }
}

TEST(PrincipalAxes, LeavesADiagonalMatrixAsItIs) {
  const auto [values, axes] = principal_axes(Mat3::diagonal({3, 2, 1}));
  EXPECT_EQ(values, Vec3(3, 2, 1));
  EXPECT_EQ(axes, Mat3::diagonal({1, 1, 1}));
}

}  // namespace
}  // namespace talus
