#include "talus/project/starter.hpp"

namespace talus::project {

std::string starter() {
  // Geometry, materials and rocks: the manual, section 1, scenario 2.
  return R"(# A project of Talus. Every key, its unit, range and default: docs/project-file.md, or `talus schema`.
# Keys that are not given have their defaults; a mistyped key is an error.
name = "Tutorial 1"

[analysis]
laws = "talus"          # or "rocfall": those of RocFall2 and RocFall3
model = "lumped_mass"   # or "rigid_sphere", or "rigid_body": blocks with a shape (docs/shapes.md)
sliding = "stepped"     # or "closed_form"

[sampling]
seed = 1                # the same seed gives the same rocks, on any computer and any number of threads

[terrain]
# The slope in section: x, z in metres.
section = [[0, 0], [3.1, -12.2], [6.7, -12.2], [9.8, -24.4], [13.4, -25], [26, -22.5]]
# width_m = 50          # extrudes it along y to a 3D terrain; positions then are [x, y, z]

# A property is a number or a distribution: mean, kind, standard deviation, and maximum distances from the mean.
[[material]]
name = "Type One"
normal_restitution     = { mean = 0.5, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
tangential_restitution = { mean = 0.9, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
friction_angle_deg     = 30
roughness_deg          = 10    # tilts of small faces of the ground; 0 is smooth, where rocks slide

[[material]]
name = "Type Two"
normal_restitution     = { mean = 0.4, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
tangential_restitution = { mean = 0.9, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
friction_angle_deg     = 30
roughness_deg          = 10

[[material]]
name = "Type Three"
normal_restitution     = { mean = 0.3, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
tangential_restitution = { mean = 0.9, distribution = "normal", std_dev = 0.03, rel_min = 0.09, rel_max = 0.09 }
friction_angle_deg     = 30
roughness_deg          = 10

[ground]
# The material of each segment of the section, from left to right.
segments = ["Type One", "Type Two", "Type One", "Type Three", "Type Three"]

[[seeder]]
name = "Crest"
position = [0.5, 0]     # x, z; or [0.5, "surface"]
rocks = 50
mass_kg = 1000
density_kg_m3 = 2700
horizontal_velocity_m_s = { mean = 1.5, distribution = "normal", std_dev = 0.15, rel_min = 0.45, rel_max = 0.45 }

# A fence, to see what it would stop:
# [[barrier]]
# name = "Fence"
# line = 15
# height_m = 3.5
# capacity_kJ = 500

# [output]
# paths = "all"         # the paths of all rocks, not only 300
)";
}

}  // namespace talus::project
