// Ten million rocks aimed at edges and vertices, where they must be stopped: none gets through.
//
// A closed body here is star-shaped about every point of a small cube inside it (checked). A rock aimed at a place on
// its surface, and flying towards a point of that cube, is inside the body right after that place: it has to be stopped
// there or before. Similarly, a rock that falls on a height field more steeply than its steepest facet is below the
// surface right after the place at which it is aimed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/dice.hpp"
#include "support/meshes.hpp"

namespace talus::watertight_test {
namespace {

using namespace testing_tools;

constexpr double late = 1e-6;  // maximum delay of a contact after the aim [s]

// The maximum gap at a contact [m]: the slack of contacts and its growth at grazing incidence.
constexpr double deep = 2e-5;

struct Target {
  Vec3 place;
  bool is_vertex;
};

Target random_target(Dice& dice, const Shape& shape) {
  const auto& corners = shape.triangles[dice.below(shape.triangles.size())];
  const std::size_t k = dice.below(3);
  const Vec3 &a = shape.vertices[corners[k]], &b = shape.vertices[corners[(k + 1) % 3]];
  if (dice.chance(0.3)) return {a, true};
  // Along the edge, often close to one of its ends.
  const double s = dice.chance(0.2) ? dice.magnitude(1e-12, 0.1) : dice.unit();
  return {a + s * (b - a), false};
}

// The flight that arrives at `place` with `velocity` at time `t`.
Parabola flight_to(const Vec3& place, const Vec3& velocity, double t, double gravity) {
  const Vec3 a(0, 0, -gravity);
  return {place - t * velocity + 0.5 * t * t * a, velocity - t * a, a};
}

struct Body {
  Shape shape;
  Vec3 centre;
  double largest = 0;  // distance of a vertex from the centre
  double cube = 0;     // half the side of the cube about the centre from which the whole surface is visible
};

Body body_of(Shape shape, const Vec3& centre, double cube) {
  Body body{std::move(shape), centre, 0, cube};
  for (const Vec3& v : body.shape.vertices) body.largest = std::max(body.largest, (v - centre).norm());
  return body;
}

bool is_seen_from_its_cube(const Body& body) {
  for (std::size_t i = 0; i < body.shape.triangles.size(); ++i) {
    const Vec3 n = body.shape.normal(i), a = body.shape.vertices[body.shape.triangles[i][0]];
    if (n.dot(a - body.centre) <= body.cube * n.abs().sum()) return false;
  }
  return true;
}

Body random_body(Dice& dice, int number) {
  const double size = dice.magnitude(0.5, 200);
  const Vec3 shift = number % 3 == 0 ? Vec3{} : dice.in_cube(50'000);
  const auto placed = [&](const Shape& shape) { return shape.moved([&](const Vec3& v) { return v + shift; }); };
  switch (number % 4) {
    case 0: {
      const Vec3 half = 0.5 * size * Vec3(dice.between(0.1, 1), dice.between(0.1, 1), dice.between(0.1, 1));
      return body_of(placed(box(-half, half)), shift, 0.2 * std::min({half.x(), half.y(), half.z()}));
    }
    case 1: {  // stretched into slivers
      const Vec3 stretch(dice.magnitude(0.02, 20), dice.magnitude(0.02, 20), 1);
      const Shape shape =
          random_boulder(dice, 2, 1.0, 0.05).moved([&](const Vec3& v) { return size * v.times(stretch); });
      return body_of(placed(shape), shift, 0.1 * size * std::min({stretch.x(), stretch.y(), 1.0}));
    }
    default:
      return body_of(placed(random_boulder(dice, 1 + static_cast<int>(dice.below(3)), size, 0.06)), shift, 0.1 * size);
  }
}

TEST(Watertight, PointsAtClosedBodies) {
  Dice dice(51);
  int launched = 0;
  for (int number = 0; launched < 4'000'000; ++number) {
    const Body body = random_body(dice, number);
    ASSERT_TRUE(is_seen_from_its_cube(body)) << number;
    const TriangleMesh mesh = body.shape.mesh();
    for (int i = 0; i < 40'000; ++i) {
      const Target target = random_target(dice, body.shape);
      const Vec3 inner = body.centre + dice.in_cube(body.cube);
      const Vec3 velocity = dice.magnitude(0.1, 50) * (inner - target.place).normalized();
      const double gravity = dice.chance(0.5) ? 0.0 : standard_gravity;
      double t = dice.between(1.1, 3) * 2 * body.largest / velocity.norm();
      if (gravity > 0) t = std::min(t, dice.magnitude(0.01, 10));
      const Parabola path = flight_to(target.place, velocity, t, gravity);
      if ((path.p - body.centre).norm() < 1.0001 * body.largest) continue;  // may start inside
      ++launched;
      const auto contact = mesh.first_contact(path, 0, 1e6);
      ASSERT_TRUE(contact) << "body " << number << " rock " << i << (target.is_vertex ? " at a vertex" : " at an edge");
      ASSERT_LE(contact->t, t + late) << "body " << number << " rock " << i
                                      << (target.is_vertex ? " at a vertex" : " at an edge");
    }
  }
}

TEST(Watertight, SpheresAtClosedBodies) {
  Dice dice(52);
  int launched = 0;
  for (int number = 0; launched < 1'000'000; ++number) {
    const Body body = random_body(dice, number);
    const TriangleMesh mesh = body.shape.mesh();
    for (int i = 0; i < 10'000; ++i) {
      const double radius = dice.magnitude(1e-3, 1) * body.largest;
      const Target target = random_target(dice, body.shape);
      const Vec3 inner = body.centre + dice.in_cube(body.cube);
      const Vec3 velocity = dice.magnitude(0.1, 50) * (inner - target.place).normalized();
      const double gravity = dice.chance(0.5) ? 0.0 : standard_gravity;
      double t = dice.between(1.1, 3) * 2 * (body.largest + radius) / velocity.norm();
      if (gravity > 0) t = std::min(t, dice.magnitude(0.01, 10));
      const Parabola path = flight_to(target.place, velocity, t, gravity);
      if ((path.p - body.centre).norm() < 1.0001 * (body.largest + radius)) continue;
      ++launched;
      const auto contact = mesh.first_contact(path, radius, 1e6);
      ASSERT_TRUE(contact) << "body " << number << " rock " << i;
      ASSERT_LT(contact->t, t) << "body " << number << " rock " << i;
      // It touches, and has not sunk in.
      int touching = 0, inside = 0;
      const Vec3 centre = path.at(contact->t);
      mesh.supports(centre, radius, deep, [&](auto&&...) { ++touching; });
      mesh.supports(centre, radius, -deep, [&](auto&&...) { ++inside; });
      ASSERT_GT(touching, 0) << "body " << number << " rock " << i;
      ASSERT_EQ(inside, 0) << "body " << number << " rock " << i;
    }
  }
}

struct Field {
  Shape shape;
  double steepest = 0;  // slope, as a tangent
  double width = 0;
};

Field random_field(Dice& dice, int number) {
  Field field;
  field.width = dice.magnitude(1, 1000);
  const double relief = field.width * dice.magnitude(1e-4, 0.2), grade = dice.between(0, 1.5);
  field.shape = random_slope(dice, 24, field.width, grade, relief);
  if (number % 3 != 0) {
    const Vec3 shift = dice.in_cube(50'000);
    field.shape = field.shape.moved([&](const Vec3& v) { return v + shift; });
  }
  for (std::size_t i = 0; i < field.shape.triangles.size(); ++i) {
    const Vec3 n = field.shape.normal(i);
    field.steepest = std::max(field.steepest, std::hypot(n.x(), n.y()) / n.z());
  }
  return field;
}

// A velocity steeper than every facet, so that it leads below the surface anywhere.
Vec3 falling(Dice& dice, const Field& field) {
  Vec3 plan = dice.direction();
  plan.z() = 0;
  const double lean = dice.unit() * 0.999 / std::max(field.steepest, 1e-6);
  return dice.magnitude(0.1, 50) * (Vec3(0, 0, -1) + std::min(lean, 10.0) * plan).normalized();
}

TEST(Watertight, PointsOnHeightFields) {
  Dice dice(53);
  int launched = 0;
  for (int number = 0; launched < 4'000'000; ++number) {
    const Field field = random_field(dice, number);
    const TriangleMesh mesh = field.shape.mesh();
    for (int i = 0; i < 40'000; ++i) {
      const Target target = random_target(dice, field.shape);
      const Vec3 velocity = falling(dice, field);
      // Short enough to start above: backwards in time, the rock climbs faster than any facet.
      const double t = dice.magnitude(1e-6, 1) * std::abs(velocity.z()) / standard_gravity;
      const Parabola path = flight_to(target.place, velocity, dice.chance(0.5) ? t : 0.1 * t, 0);
      ++launched;
      const auto contact = mesh.first_contact(path, 0, 1e6);
      const bool at_rim = target.place.x() <= mesh.bounds().low.x() || target.place.x() >= mesh.bounds().high.x() ||
                          target.place.y() <= mesh.bounds().low.y() || target.place.y() >= mesh.bounds().high.y();
      if (at_rim && !contact) continue;  // beyond the model's edge by rounding
      ASSERT_TRUE(contact) << "field " << number << " rock " << i
                           << (target.is_vertex ? " at a vertex" : " at an edge");
      ASSERT_LE(contact->t, t + late) << "field " << number << " rock " << i;
    }
  }
}

TEST(Watertight, SpheresOnHeightFields) {
  Dice dice(54);
  int launched = 0;
  for (int number = 0; launched < 1'000'000; ++number) {
    const Field field = random_field(dice, number);
    const TriangleMesh mesh = field.shape.mesh();
    for (int i = 0; i < 10'000; ++i) {
      const double radius = dice.magnitude(1e-4, 0.1) * field.width;
      const Target target = random_target(dice, field.shape);
      const Vec3 velocity = falling(dice, field);
      // From where the sphere is clear of everything: where its lowest point passes the elevation of the highest
      // ground.
      const double clear = (mesh.bounds().high.z() + radius - target.place.z()) / -velocity.z() + 1e-3;
      const Parabola path = flight_to(target.place, velocity, clear, 0);
      ++launched;
      const auto contact = mesh.first_contact(path, radius, 1e6);
      ASSERT_TRUE(contact) << "field " << number << " rock " << i;
      ASSERT_LT(contact->t, clear) << "field " << number << " rock " << i;
      int inside = 0;
      mesh.supports(path.at(contact->t), radius, -deep, [&](auto&&...) { ++inside; });
      ASSERT_EQ(inside, 0) << "field " << number << " rock " << i;
    }
  }
}

// Grazing flights, which may or may not have a contact: without one, the rock must be above the ground.
TEST(Watertight, GrazingPointsAreNeverBelowTheGround) {
  Dice dice(55);
  for (int number = 0; number < 20; ++number) {
    const Field field = random_field(dice, number);
    const TriangleMesh mesh = field.shape.mesh();
    for (int i = 0; i < 10'000; ++i) {
      const Target target = random_target(dice, field.shape);
      Vec3 velocity = dice.direction();
      velocity *= dice.magnitude(0.1, 50);
      const double t = dice.magnitude(1e-5, 0.1) * field.width / velocity.norm();
      const Parabola path = flight_to(target.place, velocity, t, standard_gravity);
      const auto under = [&](const Vec3& p) {
        const auto z = mesh.elevation(p.x(), p.y());
        return z && p.z() < *z - 1e-7 * (1 + field.steepest);
      };
      // From outside the model a rock may arrive below its rim.
      if (under(path.p) || !mesh.elevation(path.p.x(), path.p.y())) continue;
      const auto contact = mesh.first_contact(path, 0, 1e6);
      const double end = contact ? contact->t : 2 * t;
      for (int k = 1; k <= 8; ++k) {
        ASSERT_FALSE(under(path.at(end * k / 8))) << "field " << number << " rock " << i << " at " << k << "/8";
      }
    }
  }
}

}  // namespace
}  // namespace talus::watertight_test
