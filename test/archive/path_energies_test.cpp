#include "talus/archive/path_energies.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

using enum PathState;

constexpr double g = 9.80665, rock_mass = 800, datum = -30, rotational = 120;

PathEventRow row(PathState state, double time, double x, double z, double vx, double vz) {
  return {.state = state,
          .time_s = time,
          .position_m = {x, 0, z},
          .velocity_m_s = {vx, 0, vz},
          .ke_translational_J = 0.5 * rock_mass * (vx * vx + vz * vz),
          .ke_rotational_J = rotational,
          .pe_J = rock_mass * g * (z - datum)};
}

/// A flight from (0, 0), then a level slide from its end.
Path flight_and_slide(double seconds) {
  const double vx = 7, x = vx * seconds, z = 3 * seconds - g / 2 * seconds * seconds;
  return {5,
          {row(projectile, 0, 0, 0, vx, 3), row(impact, seconds, x, z, vx, 3 - g * seconds),
           row(sliding, seconds, x, z, 6, 0), row(ended, seconds + 2, x + 6, z, 0, 0)}};
}

TEST(EnergiesAlongAPath, HaveAConstantSumInFlight) {
  const Path path = flight_and_slide(2.5);
  const double total = path.rows[0].total_J();
  const auto energies = energies_along(path, 0.01);
  ASSERT_GT(energies.size(), 20U);
  for (std::size_t k = 0; k + 2 < energies.size(); ++k) {
    const auto& [time, translational, rotation, potential] = energies[k];
    EXPECT_NEAR(translational + rotation + potential, total, 1e-9 * total) << time;
    EXPECT_EQ(rotation, rotational);
    const double z = 3 * time - g / 2 * time * time;
    EXPECT_NEAR(potential, rock_mass * g * (z - datum), 1e-9 * total);
    if (k > 0) {
      EXPECT_GT(time, energies[k - 1].time_s);
    }
  }
}

TEST(EnergiesAlongAPath, EqualThoseOfTheTableAtItsRows) {
  const Path path = flight_and_slide(2.5);
  const auto energies = energies_along(path, 0.01);
  std::size_t next = 0;
  for (const PathEventRow& at : path.rows) {
    while (next < energies.size() && energies[next].time_s != at.time_s) ++next;
    ASSERT_LT(next, energies.size()) << at.time_s;
    EXPECT_EQ(energies[next].ke_translational_J, at.ke_translational_J);
    EXPECT_EQ(energies[next].pe_J, at.pe_J);
    ++next;
  }
  EXPECT_EQ(next, energies.size()) << "there are points between the rows of a slide";
}

TEST(EnergiesAlongAPath, OfALevelPathEqualThoseOfItsRows) {
  const auto energies = energies_along({1, {row(sliding, 0, 0, 0, 4, 0), row(ended, 3, 6, 0, 0, 0)}}, 0.01);
  ASSERT_EQ(energies.size(), 2U);
  EXPECT_EQ(energies[1].pe_J, rock_mass * g * -datum);
  EXPECT_TRUE(energies_along({1, {}}, 0.01).empty());
}

}  // namespace
}  // namespace talus
