#pragma once
// A slope of scree for calibrations, in parts that projects are made of.

#include <string>

namespace talus::calibration {

/// 45 degrees, then flatter; to x = 300.
inline const std::string scree_slope = R"(
[terrain]
section = [[0, 0], [40, -40], [70, -55], [300, -60]]
[[material]]
name = "Scree"
normal_restitution = { mean = 0.3, distribution = "normal", std_dev = 0.04 }
tangential_restitution = { mean = 0.8, distribution = "normal", std_dev = 0.04 }
friction_angle_deg = 30
roughness_deg = 5
)";

inline const std::string cliff_release = R"(
[[seeder]]
name = "Cliff"
type = "point"
position = [1, 3]
mass_kg = 300
rocks = 40
horizontal_velocity_m_s = 2
)";

inline const std::string road_collector = R"(
[[collector]]
name = "Road"
line = 60
height_m = 20
)";

}  // namespace talus::calibration
