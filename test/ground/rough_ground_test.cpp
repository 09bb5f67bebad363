#include "talus/ground/rough_ground.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "sampling/goodness_of_fit.hpp"
#include "support/dice.hpp"
#include "talus/core/tolerances.hpp"

namespace talus::ground_rough_ground_test {
namespace {

using namespace testing_tools;

constexpr double degree = std::numbers::pi / 180;

Distribution tilts(DistributionKind kind, double mean, double std_dev, std::optional<double> limit = {}) {
  return {mean, kind, std_dev, limit, limit};
}

struct Ground {
  const char* name;
  Distribution tilt;                      // [deg]
  std::function<double(double)> density;  // of f, up to a factor; of an angle [rad]
};

std::vector<Ground> grounds() {
  const auto normal = [](double mean, double sd) {
    return [=](double psi) { return std::exp(-0.5 * std::pow((psi / degree - mean) / sd, 2)); };
  };
  const auto uniform = [](double low, double high) {
    return [=](double psi) { return psi >= low * degree && psi <= high * degree ? 1.0 : 0.0; };
  };
  return {{"N(0, 10)", tilts(DistributionKind::normal, 0, 10), normal(0, 10)},
          {"N(0, 1)", tilts(DistributionKind::normal, 0, 1), normal(0, 1)},
          {"N(4, 20)", tilts(DistributionKind::normal, 4, 20), normal(4, 20)},
          {"U(-11, 11)", tilts(DistributionKind::uniform, 0, 5, 11), uniform(-11, 11)},
          {"U(0, 16)", tilts(DistributionKind::uniform, 8, 5, 8), uniform(0, 16)}};
}

RoughGround rough(const Distribution& tilt, double spacing = 5) {
  return RoughGround(Sampler(tilt, Bounds{-90, 90}, degree), spacing);
}

/// Faces met at an angle to the ground [rad].
std::vector<FaceTilt> met(const RoughGround& ground, double angle, bool in_section, int count, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<FaceTilt> faces;
  const auto pair = [&](std::uint32_t) {
    return std::array<double, 2>{std::max(dice.unit(), 0x1p-53), std::max(dice.unit(), 0x1p-53)};
  };
  for (int k = 0; k < count; ++k) {
    if (const auto face = ground.met_face(std::sin(angle), std::max(0.0, std::cos(angle)), in_section, pair))
      faces.push_back(*face);
  }
  return faces;
}

std::vector<double> ahead(const std::vector<FaceTilt>& faces) {
  std::vector<double> angles;
  for (const FaceTilt& face : faces) angles.push_back(face.ahead);
  return angles;
}

/// The distribution function of a density on (-tolerance::max_tilt, tolerance::max_tilt), by the midpoint rule.
std::function<double(double)> integrated(const std::function<double(double)>& density) {
  constexpr int steps = 200'000;
  constexpr double width = 2 * tolerance::max_tilt / steps;
  auto sums = std::make_shared<std::vector<double>>(1, 0.0);
  for (int k = 0; k < steps; ++k) sums->push_back(sums->back() + density(-tolerance::max_tilt + (k + 0.5) * width));
  return [sums](double x) {
    const double place = (x + tolerance::max_tilt) / width;
    const auto k = static_cast<std::size_t>(std::clamp(place, 0.0, steps - 1.0));
    const double between = (*sums)[k] + (place - static_cast<double>(k)) * ((*sums)[k + 1] - (*sums)[k]);
    return std::clamp(between / sums->back(), 0.0, 1.0);
  };
}

std::function<double(double)> met_density(const Ground& ground, double angle) {
  return [f = ground.density, angle](double psi) { return f(psi) * std::max(0.0, std::sin(angle + psi)); };
}

double probability(const std::vector<double>& draws, const std::function<double(double)>& F) {
  return kolmogorov_probability(kolmogorov_distance(draws, F), draws.size());
}

// p(psi) ~ f(psi) max(0, sin(a + psi)), from grazing to vertical.
TEST(RoughGround, AFaceIsMetInProportionToTheAreaItShows) {
  for (const Ground& ground : grounds()) {
    const RoughGround faces = rough(ground.tilt);
    for (const double angle : {0.0, 1e-3, 0.1, 0.5, 1.2, std::numbers::pi / 2}) {
      const auto angles = ahead(met(faces, angle, true, 20'000, 11));
      ASSERT_EQ(angles.size(), 20'000U) << ground.name << " at " << angle;
      EXPECT_GT(probability(angles, integrated(met_density(ground, angle))), 0.003) << ground.name << " at " << angle;
    }
  }
}

// The test above sees a law that is slightly wrong: faces by their frequency, or for a rock that comes in two degrees
// flatter.
TEST(RoughGround, TheTestOfMetFacesCanFail) {
  const Ground ground = grounds().front();
  const auto angles = ahead(met(rough(ground.tilt), 0.3, true, 20'000, 11));
  EXPECT_LT(probability(angles, integrated(ground.density)), 1e-6);
  EXPECT_LT(probability(angles, integrated(met_density(ground, 0.3 - 2 * degree))), 1e-6);
}

// Along ground with small, normally distributed tilts: density psi exp(-psi^2 / 2 sd^2) / sd^2.
TEST(RoughGround, AlongTheGroundSmallTiltsAreRayleighDistributed) {
  const double sd = 1 * degree;
  const auto angles = ahead(met(rough(tilts(DistributionKind::normal, 0, 1)), 0, true, 50'000, 3));
  EXPECT_GT(probability(angles, [sd](double psi) { return psi <= 0 ? 0 : 1 - std::exp(-0.5 * psi * psi / sd / sd); }),
            0.01);
}

// In 3D over both tilts: means under f(psi) f(chi) max(0, -v . n'), by integration.
TEST(RoughGround, In3dOverBothTilts) {
  const Ground ground = grounds()[2];
  const RoughGround faces = rough(ground.tilt);
  for (const double angle : {0.0, 0.4, std::numbers::pi / 2}) {
    double all = 0, psi_sum = 0, psi_squares = 0, chi_squares = 0, chi_fourth = 0;
    constexpr int steps = 600;
    constexpr double width = 2 * tolerance::max_tilt / steps;
    for (int i = 0; i < steps; ++i) {
      const double psi = -tolerance::max_tilt + (i + 0.5) * width;
      for (int k = 0; k < steps; ++k) {
        const double chi = -tolerance::max_tilt + (k + 0.5) * width;
        const double length = std::sqrt(1 + std::pow(std::tan(psi), 2) + std::pow(std::tan(chi), 2));
        const double shown = std::max(0.0, (std::sin(angle) + std::tan(psi) * std::cos(angle)) / length);
        const double weight = ground.density(psi) * (ground.density(chi) + ground.density(-chi)) * shown;
        all += weight;
        psi_sum += weight * psi;
        psi_squares += weight * psi * psi;
        chi_squares += weight * chi * chi;
        chi_fourth += weight * std::pow(chi, 4);
      }
    }
    const double mean = psi_sum / all, variance = psi_squares / all - mean * mean, square = chi_squares / all;
    constexpr int count = 40'000;
    const auto drawn = met(faces, angle, false, count, 5);
    ASSERT_EQ(drawn.size(), static_cast<std::size_t>(count));
    double drawn_mean = 0, drawn_aside = 0, drawn_square = 0;
    for (const FaceTilt& face : drawn) {
      drawn_mean += face.ahead / count;
      drawn_aside += face.aside / count;
      drawn_square += face.aside * face.aside / count;
    }
    EXPECT_NEAR(drawn_mean, mean, 4 * std::sqrt(variance / count)) << angle;
    EXPECT_NEAR(drawn_aside, 0, 4 * std::sqrt(square / count)) << angle;
    EXPECT_NEAR(drawn_square, square, 4 * std::sqrt((chi_fourth / all - square * square) / count)) << angle;
  }
}

// Tilts from heights: tan(psi) is normal with standard deviation sqrt(2) amplitude / spacing.
TEST(RoughGround, TiltsFollowFromHeights) {
  const RoughGround ground(Sampler(0.0), 0.5, 0.05);
  const double sd = std::numbers::sqrt2 * 0.1;
  const auto density = [sd](double psi) {
    const double slope = std::tan(psi);
    return std::exp(-0.5 * slope * slope / sd / sd) * (1 + slope * slope) * std::max(0.0, std::sin(0.2 + psi));
  };
  EXPECT_GT(probability(ahead(met(ground, 0.2, true, 20'000, 9)), integrated(density)), 0.01);
  EXPECT_EQ(ground.bump_spacing(), 0.5);
}

TEST(RoughGround, WithoutRisingFacesThereIsNoBump) {
  const RoughGround falling = rough(tilts(DistributionKind::uniform, -5, 1, 4));
  EXPECT_FALSE(falling.is_smooth());
  EXPECT_TRUE(std::isinf(falling.bump_spacing()));
  EXPECT_TRUE(met(falling, 0, true, 100, 1).empty());
  EXPECT_TRUE(met(falling, 0.5 * degree, true, 100, 1).empty());
  EXPECT_EQ(met(falling, 5 * degree, true, 100, 1).size(), 100U);
}

TEST(RoughGround, SmoothGroundHasNoFaces) {
  for (const RoughGround& smooth : {RoughGround(), RoughGround(Sampler(0.0), 5), RoughGround(Sampler(0.1), 5)}) {
    EXPECT_TRUE(smooth.is_smooth());
    EXPECT_TRUE(std::isinf(smooth.bump_spacing()));
    EXPECT_TRUE(met(smooth, 0.5, true, 10, 1).empty());
  }
}

// The work of an impact is bounded and small: of a million impacts none runs out of proposals.
TEST(RoughGround, FewProposalsAreRejected) {
  for (const Ground& ground : grounds()) {
    const RoughGround faces = rough(ground.tilt);
    Dice dice(17);
    int pairs = 0, found = 0;
    constexpr int count = 200'000;
    for (int k = 0; k < count; ++k) {
      const double angle = 0.5 * std::numbers::pi * dice.unit() * dice.unit();
      found += faces
                   .met_face(std::sin(angle), std::cos(angle), true,
                             [&](std::uint32_t) {
                               ++pairs;
                               return std::array<double, 2>{std::max(dice.unit(), 0x1p-53), dice.unit()};
                             })
                   .has_value();
    }
    EXPECT_EQ(found, count) << ground.name;
    EXPECT_LT(pairs, 1.3 * count) << ground.name;
  }
}

}  // namespace
}  // namespace talus::ground_rough_ground_test
