// Results must not depend on the position, rotation or handedness of the model, on how a plane is cut into facets, or
// on whether a slope is given as a section or extruded.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::invariance_test {
namespace {

using namespace testing_tools;

// Rounding grows at every bounce on rough ground, up to a hundredfold: rows are compared, each with ten times the
// tolerance, until the comparison becomes meaningless.
double tolerance(std::size_t row, double first) { return first * std::pow(10.0, static_cast<double>(row)); }
constexpr double too_loose = 1e-3;

struct Launch {
  Laws laws;
  Soil soil;
  Release release;
};

Launch random_launch(Dice& dice, const TriangleMesh& mesh) {
  Launch it;
  const RockModel model = dice.chance(0.5) ? RockModel::lumped_mass : RockModel::rigid_sphere;
  set_model(it.laws, model, dice.chance(0.7));
  it.laws.sliding = dice.chance(0.5) ? SlidingMethod::stepped : SlidingMethod::closed_form;
  it.soil = {dice.between(0.1, 0.6), dice.between(0.3, 1), dice.between(0.2, 0.7), dice.between(0.1, 0.8), 0.1, 0};
  it.release.rock = sphere_of_diameter(dice.between(0.2, 2), 2700);
  const double x = dice.between(10, 30), y = dice.between(10, 50);
  it.release.motion.position = {x, y, *mesh.elevation(x, y) + 3};
  it.release.motion.velocity = dice.in_cube(4);
  if (dice.chance(0.5)) it.release.motion.spin = dice.in_cube(8);
  return it;
}

// Compares two paths row by row; `point`, `vector` and `axial` transform the first into the second's frame.
template <class Point, class Vector, class Axial>
void expect_alike(const Followed& first, const Followed& second, Point&& point, Vector&& vector, Axial&& axial,
                  double tight, const std::string& label) {
  const std::size_t rows = std::min(first.log.rows.size(), second.log.rows.size());
  ASSERT_GE(rows, 2U);
  for (std::size_t i = 0; i < rows; ++i) {
    const PathState state = first.log.rows[i].state, other_state = second.log.rows[i].state;
    const Motion &a = first.log.rows[i].motion, &b = second.log.rows[i].motion;
    const double allowed = tolerance(i, tight);
    if (allowed > too_loose) break;
    ASSERT_LT((point(a.position) - b.position).norm(), allowed)
        << label << " row " << i << rows_up_to(first, i) << rows_up_to(second, i);
    ASSERT_LT((vector(a.velocity) - b.velocity).norm(), 10 * allowed) << label << " row " << i;
    ASSERT_LT((axial(a.spin) - b.spin).norm(), 100 * allowed) << label << " row " << i;
    ASSERT_NEAR(a.time, b.time, 10 * allowed) << label << " row " << i;
    ASSERT_EQ(name(state), name(other_state)) << label << " row " << i;
  }
}

TEST(Invariance, UnderRotationAboutTheVertical) {
  Dice dice(91);
  const Shape shape = random_slope(dice, 20, 60, 0.8, 0.8);
  const TriangleMesh mesh = shape.mesh();
  for (int number = 0; number < 120; ++number) {
    const Launch it = random_launch(dice, mesh);
    const double angle = number < 12 ? number * std::numbers::pi / 6 : dice.between(0, 2 * std::numbers::pi);
    const Map3 turn = turn_about(unit_z, angle);
    const TriangleMesh turned_mesh = shape.moved([&](const Vec3& v) { return turn * v; }).mesh();
    Release release = it.release;
    release.motion.position = turn * release.motion.position;
    release.motion.velocity = turn * release.motion.velocity;
    release.motion.spin = turn * release.motion.spin;
    const auto carry = [&](const Vec3& v) { return turn * v; };
    expect_alike(follow(mesh, ground_of(it.soil), it.laws, it.release),
                 follow(turned_mesh, ground_of(it.soil), it.laws, release), carry, carry, carry, 1e-12,
                 "rock " + std::to_string(number));
    if (HasFatalFailure()) return;
  }
}

TEST(Invariance, UnderReflection) {
  Dice dice(92);
  const Shape shape = random_slope(dice, 20, 60, 0.8, 0.8);
  const TriangleMesh mesh = shape.mesh();
  const Map3 mirror = mirror_across(unit_x);
  const TriangleMesh mirrored_mesh = shape.mirrored().mesh();
  for (int number = 0; number < 120; ++number) {
    const Launch it = random_launch(dice, mesh);
    Release release = it.release;
    release.motion.position = mirror * release.motion.position;
    release.motion.velocity = mirror * release.motion.velocity;
    release.motion.spin = -(mirror * release.motion.spin);
    expect_alike(
        follow(mesh, ground_of(it.soil), it.laws, it.release),
        follow(mirrored_mesh, ground_of(it.soil), it.laws, release), [&](const Vec3& v) { return mirror * v; },
        [&](const Vec3& v) { return mirror * v; }, [&](const Vec3& w) { return -(mirror * w); }, 1e-12,
        "rock " + std::to_string(number));
    if (HasFatalFailure()) return;
  }
}

// Shifted within the width of a local frame. Coordinates such as 2,600,000 m are made local first, which is exact for
// coordinates with few digits (next test).
TEST(Invariance, UnderTranslationWithinTheLocalFrame) {
  Dice dice(93);
  const Shape shape = random_slope(dice, 20, 60, 0.8, 0.8);
  const TriangleMesh mesh = shape.mesh();
  const Vec3 shift(31'234.5, -27'890.25, 2'345.125);
  const TriangleMesh moved_mesh = shape.moved([&](const Vec3& v) { return v + shift; }).mesh();
  for (int number = 0; number < 120; ++number) {
    const Launch it = random_launch(dice, mesh);
    Release release = it.release;
    release.motion.position += shift;
    const auto same = [](const Vec3& v) { return v; };
    expect_alike(
        follow(mesh, ground_of(it.soil), it.laws, it.release), follow(moved_mesh, ground_of(it.soil), it.laws, release),
        [&](const Vec3& v) { return v + shift; }, same, same, 1e-9, "rock " + std::to_string(number));
    if (HasFatalFailure()) return;
  }
}

TEST(Invariance, CoordinatesOfMillionsOfMetresKeepTheirDigits) {
  // A survey in millimetres, at 2.6 and 1.2 million metres: subtracting the origin gives the same numbers.
  Dice dice(94);
  const Vec3 origin(2'600'000, 1'200'000, 500);
  Shape shape = random_slope(dice, 20, 60, 0.8, 0.8);
  for (Vec3& v : shape.vertices) v = (v * 1024).rounded() / 1024;
  Shape global = shape.moved([&](const Vec3& v) { return v + origin; });
  const Shape local = global.moved([&](const Vec3& v) { return v - origin; });
  const TriangleMesh a = shape.mesh(), b = local.mesh();
  for (int number = 0; number < 40; ++number) {
    const Launch it = random_launch(dice, a);
    const Followed first = follow(a, ground_of(it.soil), it.laws, it.release);
    const Followed second = follow(b, ground_of(it.soil), it.laws, it.release);
    ASSERT_EQ(first.outcome.end.position, second.outcome.end.position);
    ASSERT_EQ(first.outcome.end.time, second.outcome.end.time);
  }
}

// Users may number vertices and triangles in any order.
TEST(Invariance, UnderTheOrderOfTriangles) {
  Dice dice(95);
  const Shape shape = random_slope(dice, 20, 60, 0.8, 0.8);
  Shape shuffled = shape;
  for (std::size_t i = shuffled.triangles.size(); i > 1; --i) {
    std::swap(shuffled.triangles[i - 1], shuffled.triangles[dice.below(i)]);
  }
  for (auto& corners : shuffled.triangles) std::rotate(corners.begin(), corners.begin() + dice.below(3), corners.end());
  const TriangleMesh a = shape.mesh(), b = shuffled.mesh();
  const auto same = [](const Vec3& v) { return v; };
  for (int number = 0; number < 120; ++number) {
    const Launch it = random_launch(dice, a);
    expect_alike(follow(a, ground_of(it.soil), it.laws, it.release), follow(b, ground_of(it.soil), it.laws, it.release),
                 same, same, same, 1e-12, "rock " + std::to_string(number));
    if (HasFatalFailure()) return;
  }
}

// A plane of two facets, and of hundreds of irregular ones: rocks bounce on it, and slide and roll over its seams.
TEST(Invariance, UnderTheDivisionOfAPlane) {
  Dice dice(96);
  for (int k = 0; k < 6; ++k) {
    const double grade = dice.between(0.1, 1.0), cross = dice.between(-0.3, 0.3);
    const auto height = [&](double x, double y) { return -grade * x + cross * y; };
    const TriangleMesh whole = irregular_field(dice, 1, 1, 200, 200, height).mesh();
    const TriangleMesh split = irregular_field(dice, 30, 30, 200, 200, height).mesh();
    for (int number = 0; number < 40; ++number) {
      Launch it = random_launch(dice, whole);
      it.release.motion.position = {60, 100, height(60, 100) + 3};
      const Followed a = follow(whole, ground_of(it.soil), it.laws, it.release);
      const Followed b = follow(split, ground_of(it.soil), it.laws, it.release);
      const std::string label = "plane " + std::to_string(k) + " rock " + std::to_string(number) +
                                (it.laws.model == RockModel::rigid_sphere ? " sphere" : " lumped") +
                                (it.laws.sliding == SlidingMethod::stepped ? " stepped" : " closed form");
      ASSERT_EQ(name(a.outcome.reason), name(b.outcome.reason)) << label;
      ASSERT_EQ(a.outcome.events, b.outcome.events) << label;
      ASSERT_LT((a.outcome.end.position - b.outcome.end.position).norm(), 1e-6) << label;
      ASSERT_NEAR(a.outcome.end.time, b.outcome.end.time, 1e-6) << label;
    }
  }
}

// A random slope as a section and extruded, with the same draws.
TEST(Invariance, OfASectionUnderExtrusion) {
  Dice dice(97);
  for (int slope = 0; slope < 12; ++slope) {
    std::vector<Vec2> section{{0, 0}};
    for (int k = 0; k < 10; ++k) section.emplace_back(section.back() + Vec2(dice.between(2, 8), dice.between(-6, 1)));
    const Profile profile(section);
    const Shape shape = extruded(section, 60, 5, dice);
    const TriangleMesh mesh = shape.mesh();
    Material hard = material_of({0.5, 0.9, 0.4, 0.5, 0.1, 0}), soft = material_of({0.3, 0.7, 0.6, 0.6, 0.3, 0});
    Distribution rn;
    rn.kind = DistributionKind::normal;
    rn.mean = 0.4;
    rn.std_dev = 0.05;
    hard.normal_restitution = Sampler(rn, Bounds{0, 1});
    std::vector<MaterialId> of_segment, of_triangle;
    for (std::uint32_t i = 0; i + 1 < section.size(); ++i) of_segment.push_back(MaterialId{i % 2});
    for (std::size_t i = 0; i < shape.triangles.size(); ++i)
      of_triangle.push_back(of_segment[(i / 2) % of_segment.size()]);
    const Ground ground2({hard, soft}, of_segment), ground3({hard, soft}, of_triangle);
    int alike = 0;
    for (int number = 0; number < 40; ++number) {
      Laws laws;
      set_model(laws, number % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere, number % 3 != 0);
      laws.sliding = number % 5 < 2 ? SlidingMethod::stepped : SlidingMethod::closed_form;
      laws.in_section = true;
      Release release;
      release.rock = sphere_of_diameter(dice.between(0.2, 1.5), 2700);
      const double x = dice.between(1, 10);
      release.motion.position = {x, 0, *profile.elevation(x) + 4};
      release.motion.velocity = {dice.between(0, 5), 0, 0};
      const auto rock_number = static_cast<std::uint64_t>(number);
      const Followed flat = follow(profile, ground2, laws, release, {}, rock_number);
      release.motion.position.y() = 31.4;
      const Followed wide = follow(mesh, ground3, laws, release, {}, rock_number);
      const Vec3 end = wide.outcome.end.position - Vec3(0, 31.4, 0);
      if ((flat.outcome.end.position - end).norm() > 1e-6) {
        std::size_t parted = 0;
        while (parted + 1 < std::min(flat.log.rows.size(), wide.log.rows.size()) &&
               std::abs(flat.log.rows[parted].motion.position.x() - wide.log.rows[parted].motion.position.x()) < 1e-6) {
          ++parted;
        }
        ADD_FAILURE() << "slope " << slope << " rock " << number
                      << (laws.model == RockModel::rigid_sphere ? " sphere " : " lumped ") << release.rock.radius
                      << rows_up_to(flat, parted) << rows_up_to(wide, parted);
        continue;
      }
      ++alike;
      EXPECT_EQ(flat.outcome.reason, wide.outcome.reason);
      EXPECT_NEAR(flat.outcome.end.time, wide.outcome.end.time, 1e-6);
      EXPECT_NEAR(flat.outcome.max_bounce, wide.outcome.max_bounce, 1e-6);
    }
    EXPECT_EQ(alike, 40) << "slope " << slope;
  }
}

}  // namespace
}  // namespace talus::invariance_test
