// What a run tells its sink is one story: in the order of time, each event where the last one has left the rock.

#include "talus/trajectory/event.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus::event_test {
namespace {

using namespace testing_tools;

/// A rough slope that falls along x, with a fence that rebounds rocks and a collector.
class Slope {
 public:
  explicit Slope(std::uint64_t number)
      : number_(number),
        dice_(number + 1),
        mesh_(random_slope(dice_, 16, 60, 0.7, 0.6).mesh()),
        ground_(ground_of(soil())) {
    set_model(laws_, number % 2 == 0 ? RockModel::rigid_sphere : RockModel::lumped_mass);
    release_.rock = sphere_of_diameter(dice_.between(0.4, 1.5), 2700);
    const double x = dice_.between(5, 12), y = dice_.between(10, 50);
    release_.motion.position = {x, y, mesh_.elevation(x, y).value() + release_.rock.radius * 1.5 + dice_.between(0, 4)};
    release_.motion.velocity = {dice_.between(0, 3), dice_.between(-1, 1), 0};
    for (const double at : {25.0, 35.0}) {
      Barrier& barrier = barriers_.emplace_back();
      barrier.set_panels(panels_over(std::vector<Vec3>{{at, 0, -0.7 * at}, {at, 60, -0.7 * at}}, at > 30 ? 3 : 1, 0));
      barrier.is_collector = at > 30;
      barrier.capacity = 2e4;
      barrier.restitution = Restitution{0.3, 0.8};
    }
  }

  template <class Sink>
  RockOutcome tell(Sink& sink) const {
    const Draws draws(SamplingPlan{}, number_);
    return RockRun<TriangleMesh, Sink>({mesh_, ground_, barriers_, laws_}, release_, draws, sink).follow();
  }

 private:
  [[nodiscard]] Soil soil() const {
    Soil soil{.rn = 0.4, .rt = 0.85, .phi = 0.45, .mu = 0.6, .rolling = 0.05};
    if (number_ % 3 == 0) {
      soil.roughness = 0.1;
      soil.bump_spacing = 2;
    }
    return soil;
  }

  std::uint64_t number_;
  Dice dice_;
  TriangleMesh mesh_;
  Ground ground_;
  Laws laws_;
  Release release_;
  std::vector<Barrier> barriers_;
};

/// Checks the order of what it is told.
class Story {
 public:
  int moves = 0, contacts = 0, impacts = 0, barriers = 0, collectors = 0, above = 0, ends = 0;

  void operator()(const event::Release& release) {
    EXPECT_FALSE(is_released_);
    is_released_ = true;
    at_ = release.motion;
  }
  void operator()(const event::Flight& flight) {
    begins(flight.before);
    at_.position = flight.path.at(flight.duration);
    at_.time += flight.duration;
    ++moves;
  }
  void operator()(const event::Leg& leg) { covers(leg.before, leg.after); }
  void operator()(const event::Glide& glide) { covers(glide.before, glide.after); }
  void operator()(const event::Turn& turn) { EXPECT_EQ(turn.motion.velocity, Vec3{}); }
  void operator()(const event::Contact& contact) {
    begins(contact.before);
    EXPECT_EQ(contact.before.position, contact.after.position);
    EXPECT_EQ(contact.before.time, contact.after.time);
    EXPECT_TRUE(contact.then == PathState::projectile || contact.then == PathState::sliding ||
                contact.then == PathState::rolling);
    ++contacts;
    if (contact.impact == nullptr) return;
    ++impacts;
    EXPECT_EQ(contact.impact->before.velocity, contact.before.velocity);
    EXPECT_LT(contact.impact->before.velocity.dot(contact.impact->struck_normal), 1e-9);
    EXPECT_GE(contact.impact->after.velocity.dot(contact.impact->normal), -1e-9);
  }
  void operator()(const event::AtBarrier& at) {
    ++barriers;
    EXPECT_EQ(at.after == nullptr, at.passage.outcome == BarrierOutcome::stopped);
    if (at.after == nullptr) return;
    EXPECT_EQ(at.after->time, at.passage.motion.time);
  }
  void operator()(const event::AtCollector& at) {
    ++collectors;
    EXPECT_EQ(at.passage.outcome, BarrierOutcome::passed);
  }
  void operator()(const event::PassedAbove&) { ++above; }
  void operator()(const event::NotPassedAbove&) {
    --above;
    EXPECT_GE(above, 0);
  }
  void operator()(const event::End& end) {
    begins(end.motion);
    ++ends;
  }

 private:
  void begins(const Motion& motion) {
    EXPECT_TRUE(is_released_ && ends == 0);
    EXPECT_LE((motion.position - at_.position).norm(), 1e-3);  // rounding on the ground is corrected between legs
    EXPECT_NEAR(motion.time, at_.time, 1e-9);
  }
  void covers(const Motion& before, const Motion& after) {
    begins(before);
    EXPECT_GE(after.time, before.time);
    at_ = after;
    ++moves;
  }

  bool is_released_ = false;
  Motion at_;
};

void expect_same(const RockOutcome& a, const RockOutcome& b) {
  EXPECT_EQ(a.end.position, b.end.position);
  EXPECT_EQ(a.end.spin, b.end.spin);
  EXPECT_EQ(a.end.time, b.end.time);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.events, b.events);
  EXPECT_EQ(a.max_kinetic_energy, b.max_kinetic_energy);
  EXPECT_EQ(a.max_bounce, b.max_bounce);
}

TEST(Events, AreOneStoryFromTheReleaseToTheEnd) {
  Story all;
  for (std::uint64_t number = 0; number < 200; ++number) {
    Story story;
    const RockOutcome outcome = Slope(number).tell(story);
    EXPECT_EQ(story.ends, 1) << number;
    EXPECT_EQ(story.contacts + story.barriers, outcome.events) << number;
    all.moves += story.moves;
    all.impacts += story.impacts;
    all.barriers += story.barriers;
    all.collectors += story.collectors;
    all.above += story.above;
  }
  EXPECT_GT(all.moves, 2000);
  EXPECT_GT(all.impacts, 500);
  EXPECT_GT(all.barriers, 30);
  EXPECT_GT(all.collectors, 30);
  EXPECT_GT(all.above, 5);
}

/// Listens to one kind of event.
struct Impacts {
  std::vector<Vec3> places;
  void operator()(const event::Contact& contact) {
    if (contact.impact != nullptr) places.push_back(contact.before.position);
  }
};

TEST(Events, DoNotDependOnWhoListens) {
  for (std::uint64_t number = 0; number < 60; ++number) {
    const Slope slope(number);
    RockLog log(true, true);
    event::NoSink nobody;
    Impacts impacts;
    const RockOutcome outcome = slope.tell(log);
    expect_same(slope.tell(nobody), outcome);
    expect_same(slope.tell(impacts), outcome);
    EXPECT_EQ(impacts.places, log.impact_places) << number;
  }
}

}  // namespace
}  // namespace talus::event_test
