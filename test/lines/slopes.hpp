#pragma once
// Slopes of which lines are asked.

#include <string>

namespace talus {

/// Rough, with a bench; rocks of different mass.
inline const std::string bouncing_slope = R"([analysis]
laws = "rocfall"
model = "lumped_mass"

[terrain]
section = [[0, 0], [12, -14], [18, -14.5], [30, -27], [70, -34]]
width_m = 60

[[material]]
name = "Rock"
normal_restitution = { mean = 0.45, distribution = "normal", std_dev = 0.06, rel_min = 0.2, rel_max = 0.2 }
tangential_restitution = { mean = 0.85, distribution = "normal", std_dev = 0.04, rel_min = 0.1, rel_max = 0.1 }
friction_angle_deg = 34
roughness_deg = 12
dynamic_friction = 0.5
rolling_friction = 0.35

[[seeder]]
type = "line"
points = [[1, 10], [1, 50]]
height_above_m = 1
rocks = 400
mass_kg = { mean = 900, distribution = "lognormal", std_dev = 500, rel_min = 700, rel_max = 3000 }
horizontal_velocity_m_s = 2
)";

/// One bend; equal rocks.
inline const std::string plain_slope = R"([terrain]
section = [[0, 0], [30, -30], [80, -35]]
width_m = 60

[[material]]
name = "Rock"
normal_restitution = 0.4
tangential_restitution = 0.85
friction_angle_deg = 33
roughness_deg = 10

[[seeder]]
type = "line"
points = [[1, 10], [1, 50]]
height_above_m = 1
rocks = 150
mass_kg = 900
horizontal_velocity_m_s = 2
)";

/// In section: a face of 20 m, and flat ground on which rocks stay where they land. Five rocks leave the crest with
/// horizontal velocities of 1 to 5 m/s.
inline const std::string vertical_face = [] {
  std::string slope = R"([terrain]
section = [[0, 20], [10, 20], [10, 0], [60, 0]]

[[material]]
name = "Sand"
normal_restitution = 0
tangential_restitution = 0
friction_angle_deg = 40
)";
  for (const char* velocity : {"1", "2", "3", "4", "5"})
    slope += std::string("[[seeder]]\nposition = [9.9, 20.5]\nmass_kg = 100\nhorizontal_velocity_m_s = ") + velocity + "\n";
  return slope;
}();

}  // namespace talus
