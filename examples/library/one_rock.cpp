// Simulates one rock on a slope in section and prints its path: a minimal program that uses Talus as a library.

#include <cstdio>
#include <iostream>

#include "talus/campaign/simulate.hpp"
#include "talus/core/problems.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace {

constexpr const char* slope = R"(
[terrain]
section = [[0, 0], [20, -25], [40, -40], [80, -42]]  # x, z [m]

[[material]]
name = "Talus cover"
normal_restitution = 0.32
tangential_restitution = 0.8
friction_angle_deg = 35

[ground]
default = "Talus cover"

[[seeder]]
type = "point"
position = [1, 5]
rocks = 1
mass_kg = 800
horizontal_velocity_m_s = 1
)";

}  // namespace

int main() {
  try {
    const talus::project::Reading reading = talus::project::read_project_text(slope, "slope.toml");
    talus::Problems warnings;
    const talus::Model model = talus::project::build_model(reading.project, warnings);
    talus::Simulator simulator(model);
    const talus::RockRecord record = simulator.simulate(0, true);
    for (const talus::PathRow& row : simulator.log().rows) {
      const talus::Vec3 p = model.frame.global_from_local(row.motion.position);
      std::printf("%-11s t = %6.3f s   x = %7.3f m   z = %7.3f m   v = %6.3f m/s\n", talus::name(row.state),
                  row.motion.time, p.x(), p.z(), row.motion.velocity.norm());
    }
    std::printf("%s\n", talus::name(record.outcome.reason));
  } catch (const talus::BadInput& bad) {
    std::cerr << bad.what() << '\n';
    return 2;
  }
}
