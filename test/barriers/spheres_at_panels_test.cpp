// Where a sphere meets a panel, compared to closed forms and to the distance from the panel.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/dice.hpp"
#include "support/scenes.hpp"
#include "talus/barriers/crossing.hpp"
#include "talus/terrain/facet_contact.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::spheres_at_panels_test {
namespace {

using namespace testing_tools;

constexpr double infinite = std::numeric_limits<double>::infinity();

Barrier standing(const std::vector<Vec3>& foot, double height, double inclination) {
  Barrier barrier;
  barrier.capacity = infinite;
  barrier.set_panels(panels_over(foot, height, inclination));
  return barrier;
}

// ---- in a section ----

// A panel of two metres would touch it with its sides, which a section does not have.
TEST(SphereInASection, ThatBeginsWithinABarrierMeetsItsFaceInThePlane) {
  std::vector<Barrier> barriers(1);
  barriers[0].set_panels({panel_in_section({0, 0, 0}, 1000, 0)});
  for (const double radius : {2.5, 3.0, 30.0}) {
    const Parabola path{{-2, 0, 2}, {2, 0, 0}, Vec3{}};
    const auto crossing = first_crossing(barriers, path, radius, 0, 10, {});
    ASSERT_TRUE(crossing);
    EXPECT_DOUBLE_EQ(crossing->t, 1);
    EXPECT_EQ(crossing->normal, Vec3(-1, 0, 0));
  }
}

TEST(SphereInASection, IsTouchedInThePlaneByATop) {
  Dice dice(31);
  int touched = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<Barrier> barriers(1);
    barriers[0].set_panels({panel_in_section({dice.between(-3, 3), 0, 0}, dice.between(1, 5), dice.between(-1, 1))});
    const Parabola path{{-20, 0, dice.between(0, 9)}, {dice.between(1, 20), 0, dice.between(-5, 5)}, {0, 0, -9.81}};
    const auto crossing = first_crossing(barriers, path, dice.magnitude(0.1, 10), 0, 10, {});
    if (!crossing) continue;
    EXPECT_EQ(crossing->normal.y(), 0);
    touched += crossing->normal != crossing->across ? 1 : 0;
  }
  EXPECT_GT(touched, 100);
}

// ---- rolling on a slope ----

/// A slope that falls towards +x, with a barrier at the origin.
struct Slope {
  double angle;
  [[nodiscard]] Vec3 down() const { return {std::cos(angle), 0, -std::sin(angle)}; }
  [[nodiscard]] Vec3 normal() const { return {std::sin(angle), 0, std::cos(angle)}; }
  [[nodiscard]] Profile surface() const {
    const double fall = std::tan(angle);
    return Profile(std::vector<Vec2>{{-200, 200 * fall}, {200, -200 * fall}});
  }
};

Barrier across(double height, double inclination) { return standing({{0, -50, 0}, {0, 50, 0}}, height, inclination); }

/// A sphere that rolls towards the barrier from 20 m above it, or from 20 m below.
Followed roll(const Slope& slope, const Rock& rock, bool downhill, const std::vector<Barrier>& barriers) {
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  const double side = downhill ? 1 : -1;
  Release release;
  release.rock = rock;
  release.motion.position = -20 * side * slope.down() + rock.radius * slope.normal();
  release.motion.velocity = (downhill ? 5.0 : -40.0) * slope.down();
  release.motion.spin = slope.normal().cross(release.motion.velocity) / rock.radius;
  return follow(slope.surface(), ground_of({.rn = 0, .mu = 5, .rolling = 0}), laws, release, barriers);
}

/// The position along the slope of a rolling sphere's centre when it first touches a segment from the origin. The
/// distance from a convex set is a convex function of the position.
double first_touch(const Slope& slope, double radius, bool downhill, const Vec3& top) {
  const auto distance = [&](double s) {
    const Vec3 centre = s * slope.down() + radius * slope.normal();
    const double share = std::clamp(centre.dot(top) / top.squared_norm(), 0.0, 1.0);
    return (centre - share * top).norm();
  };
  double outside = downhill ? -20 : 20, inside = outside;
  while (distance(inside) > radius) inside += downhill ? 1e-3 : -1e-3;  // to within a millimetre of the touch
  outside = inside - (downhill ? 1e-3 : -1e-3);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (outside + inside);
    (distance(middle) > radius ? outside : inside) = middle;
  }
  return inside;
}

TEST(SphereAtAPanel, IsStoppedWhereItTouchesThePanelWhileRolling) {
  int at_the_top = 0;
  for (const double degrees : {5.0, 20.0, 35.0, 50.0, 65.0}) {
    const Slope slope{degrees * std::numbers::pi / 180};
    for (const double radius : {0.4, 1.0}) {
      const Rock rock = sphere_of_diameter(2 * radius, 2700);
      for (const double height : {0.3, 0.8, 1.4, 2.7, 4.0, 9.0}) {
        for (const double inclination : {-0.4, -0.1, 0.0, 0.2, 0.5}) {
          for (const bool downhill : {true, false}) {
            const Vec3 top = height * Vec3(std::sin(inclination), 0, std::cos(inclination));
            if (top.dot(slope.normal()) < 0.05) continue;  // a panel that lies on the slope
            const Followed path = roll(slope, rock, downhill, {across(height, inclination)});
            SCOPED_TRACE(::testing::Message() << degrees << " degrees, radius " << radius << ", height " << height
                                              << ", inclination " << inclination << (downhill ? ", down" : ", up"));
            ASSERT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
            EXPECT_TRUE(path.log.passed_above.empty());
            ASSERT_EQ(path.log.hits.size(), 1U);
            const double s = first_touch(slope, radius, downhill, top);
            const Vec3 centre = s * slope.down() + radius * slope.normal();
            EXPECT_LT((path.outcome.end.position - centre).norm(), 1e-6);
            const double expected = std::clamp(centre.dot(top) / height, 0.0, height);
            EXPECT_NEAR(path.log.hits[0].height, expected, 1e-6);
            at_the_top += expected == height ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(at_the_top, 50);
}

// A reported case: the sphere touched the extended plane of the fence 2.75 m above its foot.
TEST(SphereAtAPanel, IsStoppedByAFenceLowerThanWhereItTouchesItsPlane) {
  const Slope slope{50 * std::numbers::pi / 180};
  const double radius = 1, height = 2.7;
  ASSERT_GT(radius * (1 + std::sin(slope.angle)) / std::cos(slope.angle), height);
  const Followed path = roll(slope, sphere_of_diameter(2 * radius, 2700), true, {across(height, 0)});
  EXPECT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
  ASSERT_EQ(path.log.hits.size(), 1U);
  EXPECT_DOUBLE_EQ(path.log.hits[0].height, height);
}

TEST(SphereAtACollector, ARollingSphereIsRecordedAtTheHeightOfItsCentre) {
  for (const double degrees : {0.0, 20.0, 35.0, 50.0, 65.0}) {
    const Slope slope{degrees * std::numbers::pi / 180};
    for (const double radius : {0.4, 1.0}) {
      for (const double height :
           {10.0, 0.5 * radius}) {  // of the collector: a sphere that reaches into a low one is recorded
        for (const bool downhill : {true, false}) {
          std::vector<Barrier> barriers{across(height, 0)};
          barriers[0].is_collector = true;
          const Followed path = roll(slope, sphere_of_diameter(2 * radius, 2700), downhill, barriers);
          ASSERT_FALSE(path.log.hits.empty()) << degrees << ' ' << radius << ' ' << height << downhill;
          EXPECT_TRUE(!downhill || path.log.hits.size() == 1);  // uphill, it rolls back through the collector
          EXPECT_TRUE(path.log.passed_above.empty());
          EXPECT_NEAR(path.log.hits[0].motion.position.x(), 0, 1e-9);
          EXPECT_NEAR(path.log.hits[0].height, radius / std::cos(slope.angle), 1e-6);
        }
      }
    }
  }
}

// A collector less than a radius before a barrier records the arrival, even if the centre never reaches it.
TEST(SphereAtACollector, IsRecordedIfABarrierStopsItThere) {
  const Slope slope{0.3};
  const Rock rock = sphere_of_diameter(1, 2700);
  for (const double distance : {0.0, 0.1, 0.4, 0.49}) {
    for (const double capacity : {infinite, 1.0}) {
      for (const bool rebounds : {false, true}) {
        std::vector<Barrier> barriers{across(9, 0), across(9, 0)};
        const Vec3 before = -distance / std::cos(slope.angle) * slope.down();
        barriers[0].set_panels(
            panels_over(std::vector<Vec3>{Vec3(before + Vec3(0, -50, 0)), Vec3(before + Vec3(0, 50, 0))}, 9, 0));
        barriers[0].is_collector = true;
        barriers[1].capacity = capacity;
        if (rebounds) barriers[1].restitution = Restitution{0.01, 0.01};
        const Followed path = roll(slope, rock, true, barriers);
        const auto count =
            std::ranges::count_if(path.log.hits, [](const Passage& hit) { return hit.barrier.index == 0; });
        EXPECT_GE(count, 1) << distance << ' ' << capacity;
        ASSERT_FALSE(path.log.hits.empty());
        EXPECT_EQ(path.log.hits[0].barrier.index, 0U);
        if (!rebounds || capacity == 1) {
          ASSERT_EQ(path.log.hits.size(), 2U) << distance << ' ' << capacity;
          EXPECT_EQ(path.log.hits[0].motion.velocity, path.log.hits[1].motion.velocity);
        }
      }
    }
  }
}

// ---- grazing ----

TEST(SphereAtAPanel, TouchesTheTopOrPassesAboveIt) {
  const double radius = 0.5, height = 4, near = 1e-6;
  for (const double inclination : {-0.4, 0.0, 0.4}) {
    const std::vector<Barrier> barriers{standing({{10, -5, 1}, {10, 5, 1}}, height, inclination)};
    const Vec3 top(10 + height * std::sin(inclination), 0, 1 + height * std::cos(inclination));
    for (const double fall : {-0.5, 0.0, 1.0}) {
      for (const double side : {1.0, -1.0}) {
        // A straight path that passes the top at a distance.
        const Vec3 way = Vec3(side, 0, -fall).normalized(), aside = Vec3(side * fall, 0, 1).normalized();
        const auto crossing_at = [&](double distance) {
          const Parabola path{top + distance * aside - 3 * way, way, Vec3{}};
          RecentCrossings met;
          auto crossing = first_crossing(barriers, path, radius, 0, 6, met);
          if (!crossing || !crossing->above || distance > radius) return crossing;
          // On a steep path, the centre is over the top before the sphere touches it.
          met.record_passage(*crossing, crossing->t, crossing->t + radius / std::abs(way.x()));
          crossing = first_crossing(barriers, path, radius, 0, 6, met);
          EXPECT_TRUE(crossing && met.is_over(crossing->barrier, crossing->t));
          return crossing;
        };
        const auto touched = crossing_at(radius - near);
        ASSERT_TRUE(touched);
        EXPECT_FALSE(touched->above);
        EXPECT_DOUBLE_EQ(touched->height, height);
        EXPECT_NEAR(touched->t, 3 - std::sqrt(2 * radius * near - near * near), 1e-9);
        EXPECT_LT((touched->normal - aside).norm(), 0.01);
        const auto passed = crossing_at(radius + near);
        ASSERT_TRUE(passed);
        EXPECT_TRUE(passed->above);
        // Vertically above the top.
        EXPECT_NEAR(passed->clearance, (radius + near) / aside.z() - radius, 1e-9);
        EXPECT_NEAR(passed->height, height + (radius + near) / aside.z() * std::cos(inclination), 1e-9);
      }
    }
  }
}

TEST(SphereAtAPanel, TouchesItsEndPostsOrPassesNextToThem) {
  const double radius = 0.5, near = 1e-6;
  for (const double inclination : {-0.4, 0.0, 0.4}) {
    const std::vector<Barrier> barriers{standing({{10, -5, 0}, {10, 5, 0}}, 4, inclination)};
    for (const double end : {-1.0, 1.0}) {
      for (const double way : {-1.0, 1.0}) {
        const auto crossing_at = [&](double offset) {
          const Parabola path{{10 - 9 * way, end * (5 + offset), 2}, {9 * way, 0, 0}, Vec3{}};
          return first_crossing(barriers, path, radius, 0, 2, {});
        };
        const auto touched = crossing_at(radius - near);
        ASSERT_TRUE(touched);
        EXPECT_FALSE(touched->above);
        EXPECT_NEAR(touched->height, 2 / std::cos(inclination), 0.01);
        EXPECT_DOUBLE_EQ(touched->station, end > 0 ? 10 : 0);
        EXPECT_LT((touched->normal - Vec3(0, end, 0)).norm(), 0.01);
        EXPECT_FALSE(crossing_at(radius + near));
      }
    }
  }
}

// ---- panels that lean ----

// The plane of a panel that leans uphill continues above its top: a rock that bounces through it there does not meet
// the panel.
TEST(Crossing, OfTheExtendedPlaneOfALeaningPanelIsNone) {
  const std::vector<Barrier> barriers{standing({{0, -5, 0}, {0, 5, 0}}, 4, -0.9)};
  const Panel& panel = barriers[0].panels()[0];
  const Parabola path{{-15, 0, 5}, {3, 0, 14}, {0, 0, -9.81}};
  const auto above_plane = [&](double t) { return path.at(t).dot(panel.normal) * panel.normal.z() > 0; };
  ASSERT_TRUE(!above_plane(0) && above_plane(1.4) && !above_plane(3));
  for (const double radius : {0.0, 0.4}) EXPECT_FALSE(first_crossing(barriers, path, radius, 0, 3, {}));
}

TEST(BarrierOnAPath, ARockThatPassesTheTopOfALeaningPanelAndComesDownOnItIsStopped) {
  // Its top is 3.1 m before its foot; the rock falls steeply, just beyond the top.
  const std::vector<Barrier> barriers{standing({{0, -5, 0}, {0, 5, 0}}, 4, -0.9)};
  const Profile level(std::vector<Vec2>{{-100, 0}, {100, 0}});
  const Vec3 top(4 * std::sin(-0.9), 0, 4 * std::cos(-0.9));
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    Laws laws;
    set_model(laws, model);
    Release release;
    release.rock = sphere_of_diameter(0.2, 2700);
    release.motion.position = top + Vec3(-0.1, 0, 2);
    release.motion.velocity = {2, 0, -6};
    const Followed path = follow(level, ground_of({}), laws, release, barriers);
    EXPECT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
    ASSERT_EQ(path.log.hits.size(), 1U);
    EXPECT_LT(path.log.hits[0].height, 3.9);
    EXPECT_TRUE(path.log.passed_above.empty());
    // Faster, it flies beyond the foot.
    release.motion.velocity = {30, 0, -3};
    const Followed beyond = follow(level, ground_of({}), laws, release, barriers);
    EXPECT_TRUE(beyond.log.hits.empty());
    EXPECT_EQ(beyond.log.passed_above.size(), 1U);
  }
}

// ---- compared to the distance ----

/// The distance from the panels.
double distance_from(const Barrier& barrier, const Vec3& p) {
  double nearest = infinite;
  for (const Panel& panel : barrier.panels()) {
    const auto point = [&](double along, double up) { return panel.foot + along * panel.along + up * panel.up; };
    const Vec3 a = point(0, 0), b = point(panel.length, 0), c = point(panel.end_at(panel.height), panel.height),
               d = point(panel.start_at(panel.height), panel.height);
    for (const Triangle& half : {Triangle{a, b, c}, Triangle{a, c, d}}) {
      nearest = std::min(nearest, (p - closest_point(half, p)).norm());
    }
  }
  return nearest;
}

TEST(SphereAtAPanel, ComesNoNearerThanItsRadius) {
  Dice dice(77);
  int hits = 0, above = 0, past = 0;
  for (int k = 0; k < 20000; ++k) {
    std::vector<Vec3> foot{{dice.between(-2, 2), -10, dice.between(0, 2)}};
    for (std::size_t bends = dice.below(3); bends-- > 0;)
      foot.emplace_back(dice.between(-4, 4), foot.back().y() + dice.between(3, 7), dice.between(0, 2));
    foot.emplace_back(dice.between(-2, 2), 10, dice.between(0, 2));
    const double inclination = dice.chance(0.3) ? 0 : dice.between(-0.6, 0.6);
    const std::vector<Barrier> barriers{standing(foot, dice.between(1, 6), inclination)};
    const double radius = dice.magnitude(0.1, 2);
    const double side = dice.chance(0.5) ? 1 : -1;
    const Parabola path{{side * dice.between(4, 12), dice.between(-14, 14), dice.between(3, 12)},
                        {-side * dice.between(2, 20), dice.between(-6, 6), dice.between(-6, 4)},
                        dice.chance(0.5) ? Vec3(0, 0, -9.81) : Vec3{}};
    if (distance_from(barriers[0], path.p) < radius + 1e-3) continue;
    double t_end = 2;
    // Only above the foot: below it is ground.
    while (path.z(t_end) < 2 + radius + 0.1 && t_end > 0.02) t_end -= 0.02;
    if (path.z(0.5 * t_end) < 2 + radius + 0.1) continue;

    RecentCrossings met;
    auto crossing = first_crossing(barriers, path, radius, 0, t_end, met);
    bool has_passed = false;
    if (crossing && crossing->above) {
      has_passed = true;
      EXPECT_GE(crossing->clearance, 0);
      EXPECT_GT(crossing->height, barriers[0].panels()[0].height);
      met.record_passage(*crossing, crossing->t, crossing->t);
      crossing = first_crossing(barriers, path, radius, 0, t_end, met);
      if (crossing && crossing->above) continue;  // above it again, around a corner
    }
    const double last = crossing ? crossing->t : t_end;
    for (int i = 0; i < 400; ++i) {
      const double t = last * i / 400;
      ASSERT_GT(distance_from(barriers[0], path.at(t)), radius - 1e-6) << k << ' ' << t << ' ' << last;
    }
    if (crossing) {
      ++hits;
      ASSERT_NEAR(distance_from(barriers[0], path.at(crossing->t)), radius, 1e-6) << k;
      ASSERT_NEAR(crossing->normal.norm(), 1, 1e-9);
      ASSERT_NEAR(distance_from(barriers[0], path.at(crossing->t) - radius * crossing->normal), 0, 1e-6) << k;
      ASSERT_LE(crossing->height, barriers[0].panels()[0].height * (1 + 1e-12));
    } else {
      ++(has_passed ? above : past);
    }

    // The same, rotated about the vertical and shifted.
    const double turn = dice.between(0, 6.28);
    const Map3 turned = turn_about(unit_z, turn);
    const Vec3 moved(dice.between(-500, 500), dice.between(-500, 500), dice.between(-500, 500));
    std::vector<Vec3> elsewhere;
    for (const Vec3& point : foot) elsewhere.push_back(turned * point + moved);
    const std::vector<Barrier> others{standing(elsewhere, barriers[0].panels()[0].height, inclination)};
    const Parabola other_path{turned * path.p + moved, turned * path.v, path.a};
    RecentCrossings other_met;
    auto other = first_crossing(others, other_path, radius, 0, t_end, other_met);
    if (has_passed) {
      ASSERT_TRUE(other && other->above) << k;
      other_met.record_passage(*other, other->t, other->t);
      other = first_crossing(others, other_path, radius, 0, t_end, other_met);
    }
    ASSERT_EQ(other.has_value(), crossing.has_value()) << k;
    if (!crossing) continue;
    // The time of a tangential touch varies with the square root of rounding.
    ASSERT_NEAR(other->t, crossing->t, 1e-5) << k;
    ASSERT_NEAR(other->height, crossing->height, 1e-4) << k;
    ASSERT_NEAR(other->station, crossing->station, 1e-4) << k;
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(above, 500);
  EXPECT_GT(past, 200);
}

}  // namespace
}  // namespace talus::spheres_at_panels_test
