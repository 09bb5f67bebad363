// Follows one rock on a slope that this program makes, and listens to what happens to it: no files, no campaign.

#include <cstdio>
#include <vector>

#include "talus/trajectory/rock_run.hpp"

namespace {

/// Hears impacts, how the rock goes on from them, and its end. Other events are not for it.
struct Listener {
  int impacts = 0;
  double flown = 0;  // [m]

  void operator()(const talus::event::Flight& flight) {
    flown += (flight.path.at(flight.duration) - flight.path.at(0)).norm();
  }
  void operator()(const talus::event::Contact& contact) {
    if (contact.impact == nullptr) return;
    ++impacts;
    const talus::Motion &before = contact.impact->before, &after = contact.impact->after;
    std::printf("impact at t = %6.3f s, x = %7.3f m: %6.3f m/s before, %6.3f m/s after, then %s\n", before.time,
                before.position.x(), before.velocity.norm(), after.velocity.norm(), talus::name(contact.then));
  }
  void operator()(const talus::event::End& end) {
    std::printf("ended at t = %6.3f s, x = %7.3f m\n", end.motion.time, end.motion.position.x());
  }
};

}  // namespace

int main() {
  const std::vector<talus::Vec2> vertices{{0, 0}, {20, -25}, {40, -40}, {80, -42}};  // x, z [m]
  const talus::Profile slope(vertices);

  talus::Material cover;
  cover.normal_restitution = talus::Sampler(0.32);
  cover.tangential_restitution = talus::Sampler(0.8);
  cover.friction_angle = talus::Sampler(0.61);  // [rad]
  const talus::Ground ground(cover);

  talus::Laws laws;
  laws.in_section = true;

  talus::Release release;
  release.rock = talus::sphere_of_mass(800, 2700);
  release.motion.position = {1, 0, 5};
  release.motion.velocity = {1, 0, 0};

  Listener listener;
  const talus::Draws draws(talus::SamplingPlan{}, 0);
  talus::RockRun<talus::Profile, Listener> run({slope, ground, {}, laws}, release, draws, listener);
  const talus::RockOutcome outcome = run.follow();
  std::printf("%d impacts, %.1f m in flight: %s\n", listener.impacts, listener.flown, talus::name(outcome.reason));
}
