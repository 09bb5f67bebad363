// Impacts of bodies at one and several contacts, against computed and published ones.

#include "talus/impact/rigid_body.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "support/dice.hpp"
#include "talus/core/degrees.hpp"
#include "talus/core/orientation.hpp"
#include "talus/impact/rigid_sphere.hpp"

namespace talus::rigid_body_test {
namespace {

using namespace testing_tools;

constexpr double unlimited = 1e9;  // friction

/// A homogeneous box.
struct Box {
  Vec3 size;  // [m]
  double mass;
  Orientation orientation;

  [[nodiscard]] Vec3 inertia() const {
    const Vec3 s = size.times(size);
    return mass / 12 * Vec3{s[1] + s[2], s[0] + s[2], s[0] + s[1]};
  }
  [[nodiscard]] BodyInertia body() const {
    const Vec3 i = inertia();
    return {mass, in_world(orientation, {1 / i[0], 1 / i[1], 1 / i[2]})};
  }
  [[nodiscard]] Vec3 arm(double x, double y, double z) const {
    return orientation.to_world(0.5 * size.times({x, y, z}));
  }
  [[nodiscard]] Vec3 lowest_corner() const {
    Vec3 lowest(0, 0, std::numeric_limits<double>::infinity());
    for (const double x : {-1, 1}) {
      for (const double y : {-1, 1}) {
        for (const double z : {-1, 1}) {
          if (const Vec3 corner = arm(x, y, z); corner.z() < lowest.z()) lowest = corner;
        }
      }
    }
    return lowest;
  }
  /// The corners of the face below, in the body's frame.
  [[nodiscard]] ContactSet lower_face(std::size_t corners, const Vec3& normal) const {
    constexpr std::array<std::array<double, 2>, 4> order{{{1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
    ContactSet contacts;
    for (std::size_t i = 0; i < corners; ++i) contacts.add({arm(order[i][0], order[i][1], -1), normal});
    return contacts;
  }
  [[nodiscard]] double energy(const Vec3& velocity, const Vec3& spin) const {
    const Vec3 w = orientation.to_body(spin);
    return 0.5 * mass * velocity.squared_norm() + 0.5 * inertia().dot(w.times(w));
  }
  [[nodiscard]] double energy(const Rebound& rebound) const { return energy(rebound.velocity, rebound.spin); }
};

Vec3 velocity_at(const Rebound& rebound, const Vec3& arm) { return rebound.velocity + rebound.spin.cross(arm); }

void expect_near(const Vec3& value, const Vec3& expected, double tolerance) {
  EXPECT_LT((value - expected).abs().largest(), tolerance) << value << " expected " << expected;
}

// One corner of a box of 1000 kg, turned by 30 degrees about y and then by 20 about x. Impulses were computed once from
// section 7.3 of the manual and from Coulomb's law, by another program.
struct CornerImpact {
  const char* name;
  Vec3 size;
  double tangential_restitution, friction;
  Vec3 impulse, velocity, spin;
  double energy;
};
class ACorner : public testing::TestWithParam<CornerImpact> {};

TEST_P(ACorner, IsStruckAsComputedElsewhere) {
  const CornerImpact& c = GetParam();
  const Orientation turned = Orientation::of_turn({20 * radians, 0, 0}) * Orientation::of_turn({0, 30 * radians, 0});
  const Box box{c.size, 1000, turned};
  const Vec3 v(4, 1, -6), w(1, 2, -0.5);
  const auto result = rigid_body_impact(v, w, box.body(), ContactPoint{box.lowest_corner(), unit_z},
                                        {0.3, c.tangential_restitution}, c.friction);
  EXPECT_FALSE(result.is_limited);
  EXPECT_TRUE(result.has_settled);
  expect_near(result.by.at[0], c.impulse, 2e-6);
  expect_near(result.rebound.velocity, c.velocity, 1e-9);
  expect_near(result.rebound.spin, c.spin, 1e-9);
  EXPECT_NEAR(box.energy(result.rebound), c.energy, 1e-5);
}
INSTANTIATE_TEST_SUITE_P(RigidBody, ACorner,
                         testing::Values(CornerImpact{"with_tangential_restitution",
                                                      {1, 1, 1},
                                                      0.7,
                                                      unlimited,
                                                      {-1516.300392, 1704.567781, 7748.441896},
                                                      {2.483699608, 2.704567781, 1.748441896},
                                                      {-1.669890021, 0.886605776, -0.777539587},
                                                      8618.51403},
                                         CornerImpact{"sticking",
                                                      {1, 1, 1},
                                                      0,
                                                      0.5,
                                                      {-1804.330728, 1486.620399, 7752.331359},
                                                      {2.195669272, 2.486620399, 1.752331359},
                                                      {-2.738330878, 2.287056608, -1.425131957},
                                                      8267.46196},
                                         CornerImpact{"slipping",
                                                      {1.2, 0.9, 0.5},
                                                      0,
                                                      0.5,
                                                      {-2587.719131, 1168.218548, 5678.388812},
                                                      {1.412280869, 2.168218548, -0.321611188},
                                                      {-5.488862438, -2.738998946, -0.172818589},
                                                      5458.0798},
                                         CornerImpact{"held",
                                                      {1.2, 0.9, 0.5},
                                                      0,
                                                      unlimited,
                                                      {-3955.260100, 1862.513012, 7035.784455},
                                                      {0.044739900, 2.862513012, 1.035784455},
                                                      {-3.958748933, -0.253863415, -0.840865502},
                                                      5700.14219}),
                         [](const auto& test) { return test.param.name; });

// Table 7-1 of the manual is tested with rigid_sphere.hpp; both are one law.
TEST(RigidBody, WithTheArmOfASphereIsTheLawOfTheSphere) {
  Dice dice(1);
  const Rock rock = sphere_of_diameter(1, 2700);
  const BodyInertia body{rock.mass, Mat3::diagonal(Vec3::all(1 / rock.inertia))};
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 n = dice.direction(), v = dice.in_cube(10), w = dice.in_cube(10);
    const Restitution restitution{dice.between(0, 1), dice.between(0, 1)};
    const double friction = dice.between(0, 2);
    const Rebound general =
        rigid_body_impact(v, w, body, ContactPoint{-rock.radius * n, n}, restitution, friction).rebound;
    const Rebound sphere = rigid_sphere_rebound(v, w, n, rock, restitution, {friction, 0});
    expect_near(general.velocity, sphere.velocity, 1e-12);
    expect_near(general.spin, sphere.spin, 1e-12);
  }
}

// Where the contact sticks, the moment acts for the push as it does in the sphere's law.
TEST(RigidBody, ResistsRollingAsTheLawOfTheSphereDoes) {
  Dice dice(2);
  const Rock rock = sphere_of_diameter(1, 2700);
  const BodyInertia body{rock.mass, Mat3::diagonal(Vec3::all(1 / rock.inertia))};
  for (int i = 0; i < 1000; ++i) {
    const Vec3 n = dice.direction(), v = dice.in_cube(10), w = dice.in_cube(10);
    const Restitution restitution{dice.between(0, 1), 0};
    const double rolling = dice.between(0, 0.5), friction = 1000;
    const Rebound general = rigid_body_impact(v, w, body, ContactPoint{-rock.radius * n, n}, restitution, friction,
                                              {rolling * rock.radius, 0})
                                .rebound;
    const Rebound sphere = rigid_sphere_rebound(v, w, n, rock, restitution, {friction, rolling});
    expect_near(general.velocity, sphere.velocity, 1e-6);
    expect_near(general.spin, sphere.spin, 1e-6);
  }
}

// On all corners of a face, on an edge or on a corner below its centre, a cube bounces as a point does.
TEST(RigidBody, ACubeDroppedOnAFaceAnEdgeOrACornerKeepsTheSquareOfRestitution) {
  const double e = 0.3;
  const auto expect_bounce = [&](const Box& cube, const ContactSet& contacts) {
    const auto after = rigid_body_impact({0, 0, -5}, Vec3{}, cube.body(), contacts, {e, 0}, 0.5);
    EXPECT_TRUE(after.has_settled);
    expect_near(after.rebound.velocity, {0, 0, e * 5}, 1e-7);
    expect_near(after.rebound.spin, Vec3{}, 1e-7);
  };
  const Box on_face{{1, 1, 1}, 1000, {}};
  expect_bounce(on_face, on_face.lower_face(4, unit_z));

  const Box on_edge{{1, 1, 1}, 1000, Orientation::of_turn({0, 45 * radians, 0})};
  ContactSet edge;
  for (const double y : {-1, 1}) edge.add({on_edge.arm(1, y, -1), unit_z});
  expect_bounce(on_edge, edge);

  const Vec3 diagonal = Vec3{-1, -1, -1}.normalized(), axis = diagonal.cross(-unit_z);
  const Box on_corner{{1, 1, 1}, 1000, Orientation::of_turn(std::acos(-diagonal.z()) / axis.norm() * axis)};
  expect_bounce(on_corner, ContactPoint{on_corner.lowest_corner(), unit_z});
}

// A cube that falls a little askew, without gravity: the share of energy that it keeps, computed by another program.
TEST(RigidBody, ACubeDroppedAskewKeepsWhatWasComputed) {
  const Box cube{{1, 1, 1}, 1000, Orientation::of_turn({0.05, 0.35, 0})};
  const ContactSet corner = ContactPoint{cube.lowest_corner(), unit_z};
  const Vec3 v(0, 0, -5);
  const auto kept = [&](double e, double friction) {
    return cube.energy(rigid_body_impact(v, Vec3{}, cube.body(), corner, {e, 0}, friction).rebound) /
           cube.energy(v, Vec3{});
  };
  EXPECT_NEAR(kept(0, 0), 0.648775, 1e-6);
  EXPECT_NEAR(kept(0.3, 0), 0.680386, 1e-6);
  EXPECT_NEAR(kept(0, 0.5), 0.361480, 1e-6);
  EXPECT_NEAR(kept(0.3, 0.5), 0.369085, 1e-6);
  EXPECT_NEAR(kept(0, unlimited), 0.335851, 1e-6);
  EXPECT_NEAR(kept(0.3, unlimited), 0.395624, 1e-6);
}

// A brick that rocks from one lower edge to the other: Housner (1963). Of the energy remains (1 - 1.5 sin^2 a)^2, with
// the angle a between its diagonal and its height.
TEST(RigidBody, ABrickThatRocksLosesWhatHousnerSays) {
  for (const double degrees : {10.0, 20.0, 30.0, 45.0}) {
    const double a = degrees * radians;
    const Box brick{{std::sin(a), 0.3, std::cos(a)}, 500, {}};
    const double w = 0.1;
    // It turns about its left lower edge, and the right one comes down.
    const Vec3 spin(0, w, 0);
    const Vec3 velocity = -spin.cross(brick.arm(-1, 0, -1));
    const auto after =
        rigid_body_impact(velocity, spin, brick.body(), brick.lower_face(4, unit_z), {0, 0}, unlimited).rebound;
    const double kept = 1 - 1.5 * std::sin(a) * std::sin(a);
    EXPECT_NEAR(brick.energy(after) / brick.energy(velocity, spin), kept * kept, 1e-6) << degrees;
    expect_near(velocity_at(after, brick.arm(1, 1, -1)), Vec3{}, 1e-6);
  }
}

/// A random box that comes to the ground with its lower face.
struct RandomImpact {
  Box box;
  ContactSet contacts;
  Vec3 velocity, spin;
};
RandomImpact random_impact(Dice& dice, std::size_t contacts) {
  const Box box{{dice.between(0.3, 1.3), dice.between(0.3, 1.3), dice.between(0.3, 1.3)},
                dice.between(10, 1000),
                Orientation::of_turn(dice.between(0, std::numbers::pi) * dice.direction())};
  const Vec3 normal = box.orientation.to_world(unit_z);
  Vec3 velocity = dice.in_cube(10);
  if (velocity.dot(normal) > 0) velocity = -velocity;
  return {box, box.lower_face(contacts, normal), velocity, dice.in_cube(10)};
}

TEST(RigidBody, ImpulsesAreMomentumPushAndStayInTheConeOfFriction) {
  Dice dice(2);
  for (int i = 0; i < 20'000; ++i) {
    const auto [box, contacts, velocity, spin] = random_impact(dice, 1 + i % 4);
    const double friction = dice.between(0, 1.5);
    const auto after = rigid_body_impact(velocity, spin, box.body(), contacts, {dice.between(0, 0.5), 0}, friction);
    Vec3 momentum, about_centre;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const Vec3& impulse = after.by.at[k];
      const double push = impulse.dot(contacts[k].normal);
      EXPECT_GE(push, -1e-9 * box.mass);
      EXPECT_LE(tangential(impulse, contacts[k].normal).norm(), friction * push + 1e-9 * box.mass);
      momentum += impulse;
      about_centre += contacts[k].arm.cross(impulse);
    }
    expect_near(box.mass * (after.rebound.velocity - velocity), momentum, 1e-8 * box.mass);
    const Vec3 change = box.orientation.to_body(after.rebound.spin - spin);
    expect_near(box.orientation.to_world(box.inertia().times(change)), about_centre, 1e-8 * box.mass);
  }
}

TEST(RigidBody, OneContactPartsWithItsRestitutionOrFaster) {
  Dice dice(3);
  for (int i = 0; i < 20'000; ++i) {
    const auto [box, contacts, velocity, spin] = random_impact(dice, 1);
    const double e = dice.between(0, 0.5);
    const auto after = rigid_body_impact(velocity, spin, box.body(), contacts, {e, 0}, dice.between(0, 1.5));
    ASSERT_TRUE(after.has_settled);
    if (after.is_limited) continue;
    const Vec3 &arm = contacts[0].arm, &n = contacts[0].normal;
    const double before = velocity_at({velocity, spin}, arm).dot(n);
    EXPECT_NEAR(velocity_at(after.rebound, arm).dot(n), before < 0 ? -e * before : before, 1e-9);
  }
}

TEST(RigidBody, EnergyNeverGrows) {
  Dice dice(4);
  int limited = 0, unsettled = 0;
  constexpr int impacts = 40'000;
  for (int i = 0; i < impacts; ++i) {
    auto [box, contacts, velocity, spin] = random_impact(dice, 1 + i % 4);
    const auto after = rigid_body_impact(velocity, spin, box.body(), contacts, {dice.between(0, 1), dice.between(0, 1)},
                                         dice.between(0, 1.5));
    const double before = box.energy(velocity, spin);
    EXPECT_LE(box.energy(after.rebound), before * (1 + 1e-8));
    limited += after.is_limited;
    unsettled += !after.has_settled;
  }
  EXPECT_GT(limited, 0);  // it would have grown
  EXPECT_LT(unsettled, impacts / 50);
}

// Up to a restitution of 0.67 no box gains energy without tangential restitution.
TEST(RigidBody, ModerateRestitutionIsNotLimited) {
  Dice dice(5);
  for (int i = 0; i < 20'000; ++i) {
    const auto [box, contacts, velocity, spin] = random_impact(dice, 1);
    EXPECT_FALSE(rigid_body_impact(velocity, spin, box.body(), contacts, {0.5, 0}, dice.between(0, 1.5)).is_limited);
  }
}

// A body on one contact, held by friction and by the moments that resist rolling and pivoting, stands still in spite of
// its weight: none of the impulses sets it in motion again.
TEST(RigidBody, FrictionAndMomentsHoldItTogether) {
  Dice dice(6);
  for (int i = 0; i < 1000; ++i) {
    const auto [box, contacts, velocity, spin] = random_impact(dice, 1 + i % 4);
    const Vec3 fall = -0.1 * contacts[0].normal + 0.01 * dice.direction();
    const double ample = 10 * contacts[0].arm.norm();
    const auto after =
        held_by_contacts(fall, 0.01 * dice.direction(), box.body(), contacts, 0.01, 1, {ample, ample}, {});
    ASSERT_TRUE(after.has_settled);
    EXPECT_LT(after.rebound.velocity.norm(), 1e-6);
    EXPECT_LT(after.rebound.spin.norm() * contacts[0].arm.norm(), 1e-6);
  }
}

// It slips, rolls and pivots on one contact: friction and moments have their limits, and are against what is left.
TEST(RigidBody, MomentsAreAgainstWhatIsLeftOfASpin) {
  Dice dice(7);
  int rolls = 0, pivots = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto [box, contacts, velocity, spin] = random_impact(dice, 1);
    const MomentArms arms{0.05 * contacts[0].arm.norm(), 0.01 * contacts[0].arm.norm()};
    const auto after = held_by_contacts(velocity, spin, box.body(), contacts, 0.01, 0.1, arms, {});
    ASSERT_TRUE(after.has_settled);
    const Vec3& n = contacts[0].normal;
    const double push = after.by.at[0].dot(n);
    if (push == 0) continue;
    const Vec3 rolling = tangential(after.by.moment, n), left = tangential(after.rebound.spin, n);
    EXPECT_LE(rolling.norm(), arms.rolling * push * (1 + 1e-9));
    constexpr double ended = 0.1;  // below, what is left is not settled well enough
    if (left.norm() > ended) {
      EXPECT_NEAR(rolling.norm(), arms.rolling * push, 1e-5 * arms.rolling * push);
      EXPECT_NEAR(rolling.dot(left), -rolling.norm() * left.norm(), 1e-4 * rolling.norm() * left.norm());
      ++rolls;
    }
    const double pivoting = after.by.moment.dot(n), pivot = after.rebound.spin.dot(n);
    EXPECT_LE(std::abs(pivoting), arms.pivot * push * (1 + 1e-9));
    if (std::abs(pivot) > ended) {
      EXPECT_NEAR(pivoting, -std::copysign(arms.pivot * push, pivot), 1e-5 * arms.pivot * push);
      ++pivots;
    }
  }
  EXPECT_GT(rolls, 500);
  EXPECT_GT(pivots, 500);
}

TEST(RigidBody, AContactClosesItsGapAndNoMore) {
  const Box cube{{1, 1, 1}, 1000, {}};
  ContactSet contacts;
  for (ContactPoint point : cube.lower_face(4, unit_z)) {
    point.gap = 2e-4;
    contacts.add(point);
  }
  const auto after = held_by_contacts({0, 0, -0.1}, Vec3{}, cube.body(), contacts, 0.01, 0.5, {}, {});
  expect_near(after.rebound.velocity, {0, 0, -0.02}, 1e-7);
  const auto free = held_by_contacts({0, 0, -0.01}, Vec3{}, cube.body(), contacts, 0.01, 0.5, {}, {});
  EXPECT_EQ(free.rebound.velocity, Vec3(0, 0, -0.01));
}

}  // namespace
}  // namespace talus::rigid_body_test
