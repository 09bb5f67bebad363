#pragma once
// Projects that together give every key a value other than its default, and helpers to compare them.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/dxf.hpp"
#include "talus/project/document.hpp"
#include "talus/project/read.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

inline constexpr const char* in_2d = R"(
name = "Other"
[report]
client = "Bergheim"
project = "Road K12"
number = "2026-117"
author = "A. Meier"
checked = "B. Rossi"
revision = "B"
date = "May 2026"
text = "For approval"
logo = "logo.png"
paper = "A3"
units = "us"
[analysis]
laws = "rocfall"
model = "rigid_sphere"
rotation = true
gravity_m_s2 = 9.81
sliding = "closed_form"
max_timestep_s = 0.02
normal_velocity_cutoff_m_s = 0.2
grazing_angle_deg = 2
stopped_velocity_m_s = 0.3
max_steps = 20000
max_time_s = 700.5
energy_datum_m = -25
friction_angle = "tangential_restitution"
roughness_law = "tilts"
scale_rn_by_velocity = true
rn_velocity_scale_m_s = 9
scale_rn_by_mass = true
rn_mass_scale_kg = 2000
tangential_crsp_damping = true
rolling_resistance_in_impacts = false
[sampling]
seed = 77
parameters = "posterior.csv"
parameters_site = "North"
ensembles = 20
method = "latin_hypercube"
materials = "per_rock"
[terrain]
section = [[0, 0.1], [10, -10], [20, -12]]
section_std_dev_m = [[0, 0.5], [0.25, 0.5], [0, 0]]
[[material]]
name = "Rock"
normal_restitution = { mean = 0.4, distribution = "normal", std_dev = 0.03, rel_min = 0.1, rel_max = 0.2 }
tangential_restitution = { mean = 0.8, distribution = "uniform", rel_min = 0.1, rel_max = 0.1 }
friction_angle_deg = { mean = 31, distribution = "lognormal", std_dev = 2 }
roughness_deg = { mean = 2, distribution = "none" }
roughness_spacing_m = 0.5
roughness_amplitude_m = 0.05
dynamic_friction = { mean = 0.6, distribution = "gamma", std_dev = 0.1 }
rolling_friction = { mean = 0.2, distribution = "triangular", rel_min = 0.1, rel_max = 0.1 }
[[material]]
name = "Talus"
[ground]
default = "Talus"
segments = ["Rock", "Talus"]
[[seeder]]
name = "Crest"
type = "point"
position = [1]
height_above_m = 2.5
rocks = 12
mass_kg = { mean = 500, distribution = "exponential" }
density_kg_m3 = { mean = 2600, distribution = "beta", std_dev = 20, rel_min = 100, rel_max = 100 }
horizontal_velocity_m_s = { mean = 1.5, distribution = "normal", std_dev = 0.2 }
vertical_velocity_m_s = { mean = -1, distribution = "none" }
rotational_velocity_deg_s = { distribution = "empirical", file = "spins.csv", column = "w", weight_column = "n" }
direction = [-1, 0]
[[barrier]]
name = "Fence"
line = 15
height_m = 3.5
inclination_deg = 10
capacity_kJ = 500
normal_restitution = 0.1
tangential_restitution = 0.2
[[collector]]
name = "Track"
line = 17
height_m = 5
inclination_deg = -5
[[kit]]
name = "Net"
heights_m = [3, 3.5]
mel_kJ = 1000
sel_kJ = 330
tested_height_m = 3
elongation_m = 4.5
residual_height = "B"
cost_per_m = 900
[design]
lines = ["Fence"]
protect = "Track"
section_m = 25
percentiles = [10, 97.5]
confidence = 0.9
standard = "none"
design_percentile = 99
trajectory_factor = 1.02
topography_factor = 1.05
volume_factor = 1.02
density_factor = 1.01
risk_factor = 1.2
energy_level = "SEL"
energy_factor = 1.5
energy = "total"
upper_clearance_m = 1
catch_share = 0.99
heights_m = [3, 6]
energies_kJ = [500, 8500.5]
cost_height_exponent = 2
cost_energy_exponent = 0
[output]
endpoints = 30
trajectories = 12
trajectories_MB = 12
impacts = "all"
runout_from = [3]
bands = ["reach_share", "velocity"]
paths = 3
report = false
)";

inline constexpr const char* inline_mesh = R"(
[[layer]]
name = "Roads"
file = "roads.gpkg"
layer = "axis"
name_attribute = "label"
colour = "#1f78b4"
opacity = 0.5
visible = false
[analysis]
rotation = false
scale_rn_by_velocity = false
tangential_crsp_damping = false
[terrain]
vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0.1]]
triangles = [[0, 1, 2]]
rotate_deg = 30
rotate_about = [0, 25, 0]
[[material]]
name = "Rock"
forest_drag_kg_s = 400
forest_height_m = 12
[[material]]
name = "Talus"
forest = "dense"
forest_height_m = 20
ground_drag_per_s = 0.5
[ground]
triangles = [1]
[[seeder]]
type = "line"
points = [[1, 1, "surface"], [1, 2, "surface"]]
volume_m3 = { mean = 0.5, distribution = "none" }
speed_m_s = { mean = 2, distribution = "none" }
direction = [0, 1, -1]
[[seeder]]
position = [1, 1, 5]
diameter_m = { mean = 0.5, distribution = "none" }
[[barrier]]
line = [[15, 0], [15, 50]]
height_m = 3.5
[design]
block_mass_kg = 1200
standard_file = "canton.toml"
action_energy_factor = 1.1
action_height_factor = 1.2
elongation_factor = 1.3
clearance_m = 6
free_end_m = 3
pairs = true
[output]
paths = "none"
runout_along = [[0, 10], [40, 10]]
maps = false
maps_by_source = true
raster_cell_m = 2.5
percentiles = [25, 99.9]
means = true
geopackage = "all"
vtk = true
)";

inline constexpr const char* mesh_file = R"(
[terrain]
mesh = "bowl.obj"
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 1
)";

inline constexpr const char* extruded = R"(
[terrain]
section = [[0, 0], [10, -10]]
width_m = 50
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
)";

inline constexpr const char* raster_file = R"(
[terrain]
raster = "dem.tif"
[[material]]
name = "Rock"
[[material]]
name = "Scree"
[ground]
default = "Scree"
raster = "ground.tif"
classes = { 1 = "Rock", -2 = "Scree" }
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
[output]
maps = ["reach_share", "energy_total", "velocity"]
raster_cell_m = "terrain"
)";

inline constexpr const char* survey = R"(
[terrain]
points = "ground.las"
point_classes = [2, 8]
points_layer = "spots"
lines = "lines.gpkg"
lines_layer = "contours"
elevation_attribute = "elev"
boundary = "area.gpkg"
boundary_layer = "slope"
max_edge_m = 25
remove_spikes_m = 4
crs = "EPSG:31287"
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
)";

inline constexpr const char* inline_polylines = R"(
[terrain]
polylines = [[[0, 0, 0], [10, 0, -5], [0, 10, 0.5], [0, 0, 0]]]
merge_tolerance_m = 0.5
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
)";

inline constexpr const char* polygon_file = R"(
[terrain]
polygons = "faces.dxf"
polygons_layer = "entities"
[[material]]
name = "Rock"
[[seeder]]
position = [1, 1, 5]
mass_kg = 10
)";

inline constexpr const char* from_gis = R"(
[terrain]
mesh = "bowl.obj"
up = "y"
[[material]]
name = "Rock"
like = "bedrock_outcrops"
[[material]]
name = "Scree"
[ground]
polygons = "ground.gpkg"
layer = "2024"
attribute = "kind"
values = { Fels = "Rock", "Schutt, grob" = "Scree" }
[[area]]
name = "fan"
material = "Scree"
polygon = [[0, 0], [5, 0], [5, 5.5]]
[[forest]]
name = "spruce"
density = "dense"
height_m = 22.5
polygon = [[0, 0], [5, 0], [5, 5.5]]
[[forest]]
drag_kg_s = 333
height_m = 12
polygons = "stands.gpkg"
layer = "2024"
attribute = "species"
values = ["beech", "oak"]
[[seeder]]
type = "line"
source = "north face"
lines = "cliff.gpkg"
layer = "edges"
source_attribute = "name"
mass_kg = 10
[[seeder]]
type = "polygon"
polygons = "cliffs.gpkg"
min_slope_deg = 45
cell_m = 5
rocks_per_cell = 3
place = "centre"
mass_kg = 10
[[seeder]]
type = "polygon"
polygon = [[0, 0], [10, 0], [10, 10.5]]
cell_m = 5
mass_kg = 10
[[seeder]]
type = "raster"
max_slope_deg = 60.5
mask = "release.tif"
mask_value = -2
cell_m = 2.5
mass_kg = 10
[[seeder]]
type = "table"
table = "releases.gpkg"
layer = "scars"
name_attribute = "scar"
rocks_per_row = 4
)";

/// The section of a drawing, which is read with the project.
inline const std::string section_file = [] {
  const auto drawing = std::filesystem::path(testing::TempDir()) / fmt::format("talus_section_{}.dxf", getpid());
  std::ofstream(drawing) << testing_tools::Drawing().unit(6).polyline("GROUND", false, {"0 20", "10 5", "30 0"}).text();
  return fmt::format(R"(
[terrain]
section = "{}"
section_layer = "GROUND"
section_tolerance_m = 0.25
[[material]]
name = "Rock"
[[seeder]]
position = [1, 25]
mass_kg = 10
)",
                     drawing.string());
}();

inline constexpr const char* blocks_in_3d = R"(
[analysis]
model = "rigid_body"
[terrain]
section = [[0, 20], [10, 5], [30, 0]]
width_m = 20
[[material]]
name = "Rock"
max_friction = 1.3
friction_rise_per_m = 0.7
friction_decay_per_s = 20
[[shape]]
name = "Slabs"
b_over_a = { mean = 0.8, distribution = "normal", std_dev = 0.1, rel_min = 0.2, rel_max = 0.2 }
c_over_b = 0.4
style = "angular"
corners = 16
[[shape]]
name = "One"
axes_m = [1.2, 0.9, 0.6]
[[shape]]
name = "Ball"
solid = "icosphere_80"
[[shape]]
name = "Column"
sides = 6
length_ratio = 3
[[shape]]
name = "Scan"
scan = "block.obj"
[[shape]]
name = "All"
of = ["Slabs", "flat"]
shares = [2, 1]
[[seeder]]
position = [1, 10, 25]
mass_kg = 10
shape = "All"
orientation_deg = [30, 20, 10]
)";

inline constexpr const char* blocks_in_2d = R"(
[analysis]
model = "rigid_body"
[terrain]
section = [[0, 20], [10, 5], [30, 0]]
[[material]]
name = "Rock"
[[shape]]
name = "Superellipse"
b_over_a = 0.8
power = 4
[[shape]]
name = "Section"
polygon = [[0, 0], [1, 0], [0.8, 0.7]]
[[seeder]]
position = [1, 25]
mass_kg = 10
shape = "Section"
)";

inline const std::vector<const char*> samples{
    survey,   inline_polylines, polygon_file,         in_2d,        inline_mesh, mesh_file, raster_file,
    from_gis, extruded,         section_file.c_str(), blocks_in_3d, blocks_in_2d};

inline nlohmann::ordered_json as_json(const char* toml_text) {
  const toml::table parsed = toml::parse(std::string_view(toml_text));
  std::ostringstream text;
  text << toml::json_formatter(parsed);
  return nlohmann::ordered_json::parse(text.str());
}

inline Project read_sample(const std::string& text) { return read_project_text(text, "slope.toml").project; }

/// `table.key` of a setting.
inline std::string row_name(const Table& table, const Setting& setting) {
  return std::string(table.key) + '.' + std::string(setting.key);
}

}  // namespace talus::project
