#pragma once
// Rocks that take minutes: a stop must take effect during their simulation.

#include <fmt/format.h>

#include <string>

namespace talus::testing_tools {

/// A project with rocks that come to rest at once, then some that slide for days of simulated time and take minutes to
/// compute, then again some that come to rest at once.
inline std::string endless_slope(int short_rocks, int long_rocks, int short_rocks_after = 0) {
  std::string text = R"(name = "Endless"
[analysis]
rotation = false
max_timestep_s = 1e-4
max_time_s = 1e6
max_steps = 1000000000
[terrain]
section = [[-1000, 100], [1e6, -100000]]
[[material]]
name = "Rock"
normal_restitution = 0
tangential_restitution = 1
friction_angle_deg = 5.7105932
)";
  const auto add = [&](const char* name, int rocks, double velocity_m_s) {
    if (rocks == 0) return;
    text += fmt::format(
        "[[seeder]]\nname = \"{}\"\nposition = [0, \"surface\"]\nhorizontal_velocity_m_s = {}\nrocks = {}\n"
        "mass_kg = 100\n",
        name, velocity_m_s, rocks);
  };
  add("short", short_rocks, 0);
  add("long", long_rocks, 1);
  add("after", short_rocks_after, 0);
  return text;
}

}  // namespace talus::testing_tools
