#pragma once
// A rock on its way, which a test takes from one state to the next.

#include "support/scenes.hpp"
#include "talus/trajectory/tracked_rock.hpp"

namespace talus::testing_tools {

/// Everything that a TrackedRock refers to. Its ground has one material.
template <class Surface>
class RockOn {
 public:
  RockOn(const Surface& surface, const Soil& soil, const Laws& laws, const Motion& motion,
         const Rock& rock = sphere_of_mass(1000, 2700))
      : laws_(laws), ground_(ground_of(soil)), moving_({surface, ground_, {}, laws_}, {motion, rock}, draws_, log_) {}

  TrackedRock<Surface, RockLog>& operator*() { return moving_; }
  TrackedRock<Surface, RockLog>* operator->() { return &moving_; }
  [[nodiscard]] const RockLog& log() const { return log_; }

 private:
  Laws laws_;
  Ground ground_;
  Draws draws_{SamplingPlan{}, 0};
  RockLog log_{true};
  TrackedRock<Surface, RockLog> moving_;
};

[[nodiscard]] inline Laws laws_of(RockModel model, double timestep = 0.01) {
  Laws laws;
  set_model(laws, model);
  laws.timestep = timestep;
  return laws;
}

}  // namespace talus::testing_tools
