#include "talus/project/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "talus/core/check.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/seeding/release_height.hpp"

namespace talus::project {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The most rocks of one seeder, and of all: far beyond any campaign, far below where 64-bit sums overflow.
constexpr double most_rocks = 1e12;

// Numbers beyond what any engineer meets, and so far inside what a double holds that no product of them overflows: the
// energies, times and ways that follow from them stay numbers.
constexpr double least_mass_kg = 1e-9, most_mass_kg = 1e12;
constexpr double least_volume_m3 = 1e-12, most_volume_m3 = 1e9;
constexpr double least_diameter_m = 1e-4, most_diameter_m = 1e5;
constexpr double most_speed_m_s = 1e4;
constexpr double most_rotation_deg_s = 1e6;
constexpr double least_gravity_m_s2 = 1e-6, most_gravity_m_s2 = 1e3;
constexpr double most_time_s = 1e6;
constexpr double most_height_m = 1e4;  // of what stands on the ground
constexpr double most_energy_kJ = 1e20;
constexpr double most_drag_kg_s = 1e12;
constexpr double most_factor = 1e6;  // of what has no unit, and of drags of the ground
constexpr double most_exponent = 100;
constexpr std::size_t most_percentiles = 20;  // each is a map a quantity, or a column

constexpr std::string_view within_places = "places are given in metres";
constexpr std::string_view too_fast = "no rock falls so fast";
constexpr std::string_view too_heavy = "no rock is so heavy";

template <class Struct, class Member>
std::function<Slot(Row)> member(Member Struct::*pointer) {
  return [pointer](Row row) -> Slot { return &(std::get<Struct*>(row)->*pointer); };
}

std::function<Slot(Row)> position_slot() {
  return [](Row row) -> Slot { return PositionSlot{std::get<Seeder*>(row)}; };
}
std::function<Slot(Row)> points_slot() {
  return [](Row row) -> Slot { return PointsSlot{std::get<Seeder*>(row)}; };
}
std::function<Slot(Row)> direction_slot() {
  return [](Row row) -> Slot { return DirectionSlot{&std::get<Seeder*>(row)->direction}; };
}
template <class Struct>
std::function<Slot(Row)> plan_polygon_slot() {
  return [](Row row) -> Slot { return PlanPolygonSlot{&std::get<Struct*>(row)->polygon}; };
}
std::function<Slot(Row)> library_slot() {
  return [](Row row) -> Slot { return LibrarySlot{std::get<Material*>(row)}; };
}
std::function<Slot(Row)> plan_line_slot() {
  return [](Row row) -> Slot { return PlanLineSlot{std::get<Barrier*>(row)}; };
}
std::function<Slot(Row)> rock_limit_slot(std::optional<std::int64_t> Output::*limit) {
  return [limit](Row row) -> Slot { return RockLimitSlot{&(std::get<Output*>(row)->*limit)}; };
}
std::function<Slot(Row)> map_cell_slot() {
  return [](Row row) -> Slot { return MapCellSlot{&std::get<Output*>(row)->raster_cell_m}; };
}

constexpr Range at_least(double least, std::string_view why = {}) { return {.least = least, .too_low = why}; }
constexpr Range between(double least, double most) { return {.least = least, .most = most}; }
/// From nothing, or from more than nothing, up to what no engineer meets.
constexpr Range up_to(double most, std::string_view too_low = {}, std::string_view too_high = {}) {
  return {.least = 0, .most = most, .too_low = too_low, .too_high = too_high};
}
constexpr Range above_0_up_to(double most, std::string_view too_low = {}, std::string_view too_high = {}) {
  return {.least = 0, .most = most, .least_excluded = true, .too_low = too_low, .too_high = too_high};
}
constexpr Range within(double size, std::string_view why = {}) {
  return {.least = -size, .most = size, .too_low = why, .too_high = why};
}
/// Coordinates, as those of terrains. (Those of lines and polygons on plan are looked at where they are read,
/// places.cpp: where such a list is missing, a range of numbers says nothing.)
constexpr Range place = within(largest_coordinate_m, within_places);

constexpr Range restitution{.least = 0,
                            .most = 1,
                            .too_low = "a restitution cannot turn a velocity round twice",
                            .too_high = "a rebound cannot gain energy"};

/// A restitution given in percent, or with its point one place off.
std::optional<double> restitution_slip(double value) {
  if (value > 1 && value < 10) return value / 10;
  if (value >= 10 && value <= 100) return value / 100;
  return std::nullopt;
}

std::optional<double> sign_slip(double value) { return value < 0 ? std::optional(-value) : std::nullopt; }

/// A density in t/m3 or g/cm3.
std::optional<double> density_slip(double value) {
  return value >= 0.5 && value <= 20 ? std::optional(value * 1000) : std::nullopt;
}

std::optional<Doubt> radians_doubt(double value) {
  if (value <= 0 || value > std::numbers::pi / 2) return std::nullopt;
  return Doubt{"this is an angle in degrees, and such a ground would be almost frictionless",
               fmt::format("If it is in radians, write {:.4g}", value * 180 / std::numbers::pi)};
}

std::optional<Doubt> tonnes_doubt(double value) {
  constexpr double pebble = 5;  // kg
  if (value > pebble) return std::nullopt;
  return Doubt{"this is a mass in kilograms, of a stone that can be held in a hand",
               fmt::format("If it is in tonnes, write {}", value * 1000)};
}

/// What is larger than any that was documented, or built.
std::function<std::optional<Doubt>(double)> beyond(double usual, std::string why, std::string hint) {
  return [=](double value) { return value > usual ? std::optional(Doubt{why, hint}) : std::nullopt; };
}

constexpr double largest_block_m = 20;  // of 8000 m3 by volume, 11,000 t by mass at 2700 kg/m3
constexpr const char* beyond_blocks =
    "this is more than a rockfall has; rock masses of this size move as rock avalanches";

std::optional<Doubt> mass_doubt(double value) {
  constexpr double usual_kg = 1.2e7;  // of the largest block
  if (const auto hand = tonnes_doubt(value)) return hand;
  return beyond(usual_kg, beyond_blocks, "mass_kg is in kilograms")(value);
}

/// A share or a confidence given in percent.
std::optional<double> percent_slip(double value) {
  return value > 1 && value < 100 ? std::optional(value / 100) : std::nullopt;
}

template <class Struct>
auto one_row(Struct Project::*table) {
  return std::pair{[table](Project& project) -> Row { return &(project.*table); },
                   [table](Project& project) { return std::vector<Row>{&(project.*table)}; }};
}

template <class Struct>
Row added(std::vector<Struct>& list) {
  return &list.emplace_back();
}

template <class Struct>
std::vector<Row> all(std::vector<Struct>& list) {
  std::vector<Row> rows;
  for (Struct& item : list) rows.push_back(&item);
  return rows;
}

Row added_barrier(Project& project, bool is_collector) {
  Barrier& barrier = project.barriers.emplace_back();
  barrier.is_collector = is_collector;
  return &barrier;
}

std::vector<Row> all_barriers(Project& project, bool are_collectors) {
  std::vector<Row> rows;
  for (Barrier& barrier : project.barriers) {
    if (barrier.is_collector == are_collectors) rows.push_back(&barrier);
  }
  return rows;
}

Table head() {
  return {
      .key = "",
      .meaning = "Stands before the first table.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Project::name),
               .without_it = "the name of the file, without `.toml`",
               .meaning = "What the project is called in the report, and the name of the folder with its results.",
               .source = "Talus"},
          },
      .add = [](Project& project) -> Row { return &project; },
      .rows = [](Project& project) { return std::vector<Row>{&project}; },
  };
}

Table analysis() {
  auto [add, rows] = one_row(&Project::analysis);
  return {
      .key = "analysis",
      .meaning = "How rocks move.",
      .settings =
          {
              {.key = "model",
               .slot = member(&Analysis::model),
               .meaning = "A rock is a point with mass and spin (`lumped_mass`, the law of CRSP) or a sphere with a "
                          "radius (`rigid_sphere`).",
               .source = "the manual, sections 2 and 7"},
              {.key = "rotation",
               .slot = member(&Analysis::rotation),
               .only_for = RockModel::lumped_mass,
               .meaning = "impacts couple spin and velocity; without it they are plain restitution.",
               .source = "RocFall: \"consider rotational velocity\""},
              {.key = "gravity_m_s2",
               .slot = member(&Analysis::gravity_m_s2),
               .unit = "m/s2",
               .range = {.least = least_gravity_m_s2,
                         .most = most_gravity_m_s2,
                         .too_low = "gravity is given as a magnitude, it points down by itself"},
               .meaning = "Acceleration of gravity.",
               .source = "standard gravity, as in the tables of RocFall2 and RocFall3; the manual's hand calculations "
                         "use 9.81",
               .slip = sign_slip},
              {.key = "sliding",
               .slot = member(&Analysis::sliding),
               .only_for = RockModel::lumped_mass,
               .meaning = "sliding is integrated in time steps as RocFall3 does (`stepped`) or solved exactly facet by "
                          "facet as RocFall2 does (`closed_form`).",
               .source = "the manual, section 3"},
              {.key = "max_timestep_s",
               .slot = member(&Analysis::max_timestep_s),
               .unit = "s",
               .range = {.least = 1e-4,
                         .most = most_time_s,
                         .too_low = "one slide would take billions of shorter steps"},
               .meaning = "Time step of stepped sliding and of rolling.",
               .source = "RocFall3"},
              {.key = "normal_velocity_cutoff_m_s",
               .slot = member(&Analysis::normal_velocity_cutoff_m_s),
               .unit = "m/s",
               .range = up_to(most_speed_m_s),
               .meaning = "A rock that leaves an impact with a smaller normal velocity stays on the ground and slides "
                          "or rolls.",
               .source = "RocFall2 and RocFall3"},
              {.key = "grazing_angle_deg",
               .slot = member(&Analysis::grazing_angle_deg),
               .unit = "deg",
               .range = up_to(45),
               .only_for = RockModel::lumped_mass,
               .meaning =
                   "a rock that slides is not struck by ground that it meets at a smaller angle: it slides "
                   "on, with the friction of what it presses with. The default is for rounded heights; take 1 to "
                   "5 for fine grids of smooth ground, 0 for an impact at every bend, as in RocFall.",
               .source = "Talus"},
              {.key = "stopped_velocity_m_s",
               .slot = member(&Analysis::stopped_velocity_m_s),
               .unit = "m/s",
               .range = up_to(most_speed_m_s),
               .meaning = "A slower rock is at rest where friction can hold it.",
               .source = "RocFall2 and RocFall3"},
              {.key = "max_steps",
               .slot = member(&Analysis::max_steps),
               .range = between(1, 1e9),
               .meaning =
                   "A rock with more flights, impacts and stretches along the ground than this, counted together, is "
                   "ended and counted as such.",
               .source = "Talus"},
              {.key = "max_time_s",
               .slot = member(&Analysis::max_time_s),
               .unit = "s",
               .range = above_0_up_to(most_time_s),
               .meaning = "A rock that moves longer than this is ended and counted as such.",
               .source = "Talus"},
              {.key = "energy_datum_m",
               .slot = member(&Analysis::energy_datum_m),
               .unit = "m",
               .range = place,
               .without_it = "the lowest point of the terrain",
               .meaning = "Height at which potential energy is zero.",
               .source = "the manual: 0 in sections 2, 3 and 7, the lowest vertex in sections 1 and 6"},
              {.key = "friction_angle",
               .slot = member(&Analysis::friction_angle),
               .only_for = RockModel::lumped_mass,
               .meaning = "the friction angle of sliding is the material's, follows from its tangential restitution, "
                          "phi = arctan((1 - Rt) / Rt), or is zero.",
               .source = "RocFall"},
              {.key = "scale_rn_by_velocity",
               .slot = member(&Analysis::scale_rn_by_velocity),
               .meaning = "Faster impacts rebound less: Rn / (1 + (vn / K)^2), K being `rn_velocity_scale_m_s`.",
               .source = "Pfeiffer and Bowen 1989 (CRSP)"},
              {.key = "rn_velocity_scale_m_s",
               .slot = member(&Analysis::rn_velocity_scale_m_s),
               .unit = "m/s",
               .range = above_0_up_to(most_speed_m_s),
               .meaning = "Normal velocity at which scaling by velocity halves the normal restitution.",
               .source = "30 ft/s, Pfeiffer and Bowen 1989 (CRSP)"},
              {.key = "scale_rn_by_mass",
               .slot = member(&Analysis::scale_rn_by_mass),
               .meaning = "Heavier rocks rebound less: Rn / (1 + (m / K)^2), K being `rn_mass_scale_kg`.",
               .source = "RocFall"},
              {.key = "rn_mass_scale_kg",
               .slot = member(&Analysis::rn_mass_scale_kg),
               .unit = "kg",
               .range = above_0_up_to(most_mass_kg),
               .meaning = "Mass at which scaling by mass halves the normal restitution.",
               .source = "RocFall"},
              {.key = "tangential_crsp_damping",
               .slot = member(&Analysis::tangential_crsp_damping),
               .only_for = RockModel::rigid_sphere,
               .meaning = "the tangential velocity after an impact is damped as by CRSP.",
               .source = "RocFall3"},
          },
      .add = add,
      .rows = rows,
  };
}

Table sampling() {
  auto [add, rows] = one_row(&Project::sampling);
  return {
      .key = "sampling",
      .meaning = "How random properties are drawn.",
      .settings =
          {
              {.key = "seed",
               .slot = member(&Sampling::seed),
               .range = at_least(0),
               .meaning = "A rock's path depends on nothing but the project, this number and the rock's number.",
               .source = "Talus"},
              {.key = "method",
               .slot = member(&Sampling::method),
               .meaning = "Independent draws, or draws stratified over the rocks of the campaign.",
               .source = "McKay, Beckman and Conover 1979 for `latin_hypercube`"},
              {.key = "materials",
               .slot = member(&Sampling::materials),
               .meaning = "Material properties are drawn afresh at every impact, or once for each rock.",
               .source = "Talus; the manual does not say which its programs do"},
          },
      .add = add,
      .rows = rows,
  };
}

constexpr std::string_view one_terrain =
    "one of section, mesh, triangles, raster, points, lines, polylines and polygons is required";

Table terrain() {
  auto [add, rows] = one_row(&Project::terrain);
  return {
      .key = "terrain",
      .required = true,
      .meaning =
          "The slope: exactly one of `section`, `mesh`, `triangles`, `raster`, a survey (`points`, `lines` or both), "
          "`polylines` and `polygons`. z points up.",
      .settings =
          {
              {.key = "section",
               .slot = member(&Terrain::section),
               .unit = "m",
               .without_it = one_terrain,
               .excludes = {"mesh", "vertices", "triangles", "raster", "points", "lines", "polylines", "polygons"},
               .meaning = "Vertices [x, z] of a slope in section, along the slope: two or more.",
               .source = "Talus"},
              {.key = "section_std_dev_m",
               .slot = member(&Terrain::section_std_dev_m),
               .unit = "m",
               .range = up_to(largest_coordinate_m),
               .without_it = "the vertices are certain",
               .excludes = {"width_m"},
               .meaning = "2D: standard deviations [of x, of z] of the vertices, one pair for each vertex; every rock "
                          "falls down its own slope. "
                          "Vertices move by up to 3 of them, and keep their order in x.",
               .source = "RocFall2"},
              {.key = "width_m",
               .slot = member(&Terrain::width_m),
               .unit = "m",
               .range = above_0_up_to(largest_coordinate_m),
               .without_it = "the analysis is 2D",
               .excludes = {"section_std_dev_m"},
               .meaning = "Extrudes the section along y, from y = 0 to this width, to a 3D terrain.",
               .source = "Talus"},
              {.key = "mesh",
               .slot = member(&Terrain::mesh),
               .without_it = one_terrain,
               .excludes = {"section", "vertices", "triangles", "raster", "points", "lines", "polylines", "polygons"},
               .meaning = "A file of triangles in metres (.obj, .stl or .ply); its path is relative to the project "
                          "file.",
               .source = "Talus"},
              {.key = "vertices",
               .slot = member(&Terrain::vertices),
               .unit = "m",
               .without_it = "required beside triangles",
               .excludes = {"section", "mesh", "raster", "points", "lines", "polylines", "polygons"},
               .meaning = "Vertices [x, y, z] of an inline mesh.",
               .source = "Talus"},
              {.key = "triangles",
               .slot = member(&Terrain::triangles),
               .range = at_least(0),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "raster", "points", "lines", "polylines", "polygons"},
               .meaning = "Triangles of an inline mesh: the numbers of three vertices each, counted from 0, in either "
                          "winding.",
               .source = "Talus"},
              {.key = "raster",
               .slot = member(&Terrain::raster),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "points", "lines", "polylines", "polygons"},
               .meaning =
                   "A file of elevations in metres, on a grid in a projected coordinate system in metres: band 1 "
                   "of a GeoTIFF, an Esri grid (.asc, .flt, .bil), an Erdas Imagine or a VRT; its path is relative to "
                   "the project file.",
               .source = "Talus"},
              {.key = "points",
               .slot = member(&Terrain::points),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "raster", "polylines", "polygons"},
               .meaning = "A file of surveyed points in metres, which are triangulated: text (.csv, .xyz, .txt, .pts, "
                          ".dat), .las, or points of a GeoPackage, Shapefile, GeoJSON or DXF; alone or with `lines`; "
                          "its path is relative to the project file.",
               .source = "Talus"},
              {.key = "point_classes",
               .slot = member(&Terrain::point_classes),
               .range = between(0, 255),
               .without_it = "all but noise (7 and 18)",
               .meaning = "LAS: of which classes points are taken; 2 is the ground.",
               .source = "ASPRS LAS 1.4"},
              {.key = "points_layer",
               .slot = member(&Terrain::points_layer),
               .without_it = "the only layer",
               .meaning = "Which layer of a vector file `points` are in.",
               .source = "Talus"},
              {.key = "lines",
               .slot = member(&Terrain::lines),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "raster", "polylines", "polygons"},
               .meaning = "A vector file (GeoPackage, Shapefile, DXF, ...) of contours or breaklines with heights: "
                          "their vertices are points and no triangle crosses them; alone or with `points`; its path is "
                          "relative to the project file.",
               .source = "Talus"},
              {.key = "lines_layer",
               .slot = member(&Terrain::lines_layer),
               .without_it = "the only layer",
               .meaning = "Which layer `lines` are in.",
               .source = "Talus"},
              {.key = "elevation_attribute",
               .slot = member(&Terrain::elevation_attribute),
               .without_it = "the geometry's own z",
               .meaning = "Attribute of lines, or of points in a vector file, that holds the height of all their "
                          "vertices in metres, as that of contours mostly is.",
               .source = "Talus"},
              {.key = "boundary",
               .slot = member(&Terrain::boundary),
               .without_it = "the convex hull of the survey",
               .meaning =
                   "A vector file of polygons: triangles whose middle lies beyond them are left out; its path is "
                   "relative to the project file.",
               .source = "Talus"},
              {.key = "boundary_layer",
               .slot = member(&Terrain::boundary_layer),
               .without_it = "the only layer",
               .meaning = "Which layer `boundary` is in.",
               .source = "Talus"},
              {.key = "max_edge_m",
               .slot = member(&Terrain::max_edge_m),
               .unit = "m",
               .range = above_0_up_to(largest_coordinate_m),
               .without_it = "no limit",
               .meaning = "Triangles of a survey with a longer side at the rim are left out, from the rim inwards.",
               .source = "after Duckham et al. 2008"},
              {.key = "remove_spikes_m",
               .slot = member(&Terrain::remove_spikes_m),
               .unit = "m",
               .range = above_0_up_to(largest_coordinate_m),
               .without_it = "all points stay",
               .meaning = "Points of a survey further than this above or below the plane of their neighbours are left "
                          "out.",
               .source = "Talus"},
              {.key = "polylines",
               .slot = member(&Terrain::polylines),
               .unit = "m",
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "raster", "points", "lines", "polygons"},
               .meaning = "Closed polylines [[x, y, z], ...], each made a polygon and cut into triangles; the last "
                          "vertex repeats the first.",
               .source = "the manual, section 2"},
              {.key = "polygons",
               .slot = member(&Terrain::polygons),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "raster", "points", "lines", "polylines"},
               .meaning =
                   "The same from a vector file (DXF, GeoPackage, ...): closed lines or polygons with heights; its "
                   "path is relative to the project file.",
               .source = "the manual, section 2"},
              {.key = "polygons_layer",
               .slot = member(&Terrain::polygons_layer),
               .without_it = "the only layer",
               .meaning = "Which layer `polygons` are in.",
               .source = "Talus"},
              {.key = "merge_tolerance_m",
               .slot = member(&Terrain::merge_tolerance_m),
               .unit = "m",
               .range = up_to(largest_coordinate_m),
               .meaning =
                   "Vertices of `polylines` or `polygons` as near as this become one, and sides lead through vertices "
                   "as near as this, which makes one surface of them.",
               .source = "the manual, section 2"},
              {.key = "crs",
               .slot = member(&Terrain::crs),
               .without_it = "that of the files",
               .meaning = "Coordinate system of a mesh, a raster or a survey whose files name none, for example "
                          "\"EPSG:31287\"; vector files in others are brought to it; \"local\" says that coordinates "
                          "are metres of no map.",
               .source = "Talus"},
              {.key = "rotate_deg",
               .slot = member(&Terrain::rotate_deg),
               .unit = "deg",
               .range = between(-360, 360),
               .meaning = "3D: turns the terrain about the vertical, counter-clockwise seen from above; seeders and "
                          "barriers stay.",
               .source = "the manual, section 5"},
              {.key = "rotate_about",
               .slot = member(&Terrain::rotate_about),
               .unit = "m",
               .range = place,
               .meaning = "A point [x, y, z] on the vertical axis of that turn.",
               .source = "the manual, section 5"},
          },
      .add = add,
      .rows = rows,
  };
}

Table material() {
  return {
      .key = "material",
      .repeated = true,
      .required = true,
      .meaning = "What the ground is made of; one entry for each kind.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Material::name),
               .required = true,
               .meaning = "The name by which `[ground]` calls it; no other material has it.",
               .source = "Talus"},
              {.key = "like",
               .slot = library_slot(),
               .without_it = "the defaults below hold",
               .meaning = "A material of the library (docs/materials.md, `talus materials`), whose values hold where "
                          "this entry gives none.",
               .source = "the publications that the library names"},
              {.key = "normal_restitution",
               .slot = member(&Material::normal_restitution),
               .range = restitution,
               .meaning = "Rn, the part of the velocity normal to the ground that an impact gives back.",
               .source = "the manual, table 1-2, for how it is given; the default is a choice of Talus",
               .slip = restitution_slip},
              {.key = "tangential_restitution",
               .slot = member(&Material::tangential_restitution),
               .range = restitution,
               .meaning =
                   "Rt, the part of the velocity along the ground that an impact leaves; of a rigid sphere, of its "
                   "contact point's, as far as friction can (docs/laws.md).",
               .source = "the manual, table 1-2, for how it is given; the default is a choice of Talus",
               .slip = restitution_slip},
              {.key = "friction_angle_deg",
               .slot = member(&Material::friction_angle_deg),
               .unit = "deg",
               .range = {.least = 0,
                         .most = 89.9,  // the tangent of 90 is none, and draws keep to this range
                         .too_low = "friction cannot push",
                         .too_high = "no rock could slide"},
               .only_for = RockModel::lumped_mass,
               .meaning = "phi, the friction angle of sliding.",
               .source = "the manual, table 1-2",
               .doubt = radians_doubt},
              {.key = "roughness_deg",
               .slot = member(&Material::roughness_deg),
               .unit = "deg",
               .range = {.least = 0, .most = 90, .most_excluded = true},
               .meaning = "Standard deviation of the angle by which an impact finds the ground tilted; 0 is smooth.",
               .source = "RocFall: slope roughness"},
              {.key = "roughness_spacing_m",
               .slot = member(&Material::roughness_spacing_m),
               .unit = "m",
               .range = up_to(most_diameter_m),
               .only_for = RockModel::rigid_sphere,
               .meaning = "distance of the bumps of a rough ground.",
               .source = "RocFall: slope roughness"},
              {.key = "roughness_amplitude_m",
               .slot = member(&Material::roughness_amplitude_m),
               .unit = "m",
               .range = up_to(most_diameter_m),
               .only_for = RockModel::rigid_sphere,
               .meaning = "height of the bumps of a rough ground.",
               .source = "RocFall: slope roughness"},
              {.key = "dynamic_friction",
               .slot = member(&Material::dynamic_friction),
               .range = up_to(most_factor, "friction cannot push"),
               .only_for = RockModel::rigid_sphere,
               .meaning = "mu, the coefficient of friction while the contact slips.",
               .source = "the manual, section 7; the default is a choice of Talus"},
              {.key = "rolling_friction",
               .slot = member(&Material::rolling_friction),
               .range = up_to(most_factor, "friction cannot push"),
               .only_for = RockModel::rigid_sphere,
               .meaning = "mu_r, the moment against rolling over weight and radius.",
               .source = "RocFall; the default is a choice of Talus"},
              {.key = "forest",
               .slot = member(&Material::forest),
               .excludes = {"forest_drag_kg_s"},
               .meaning = "A forest on this ground, by its density: `open` brakes with a drag of 250 kg/s, `medium` "
                          "500 kg/s, `dense` 750 kg/s.",
               .source = "the densities: RocFall; the drags: as quoted for RAMMS::ROCKFALL, see docs/laws.md"},
              {.key = "forest_drag_kg_s",
               .slot = member(&Material::forest_drag_kg_s),
               .unit = "kg/s",
               .range = above_0_up_to(most_drag_kg_s, "trees cannot push"),
               .without_it = "that of `forest`",
               .excludes = {"forest"},
               .meaning = "b, the force on a rock among the trees over its velocity.",
               .source = "RocFall, after Leine et al. 2014 and Bartelt et al. 2016 (RAMMS::ROCKFALL)"},
              {.key = "forest_height_m",
               .slot = member(&Material::forest_height_m),
               .unit = "m",
               .range = above_0_up_to(most_height_m, "a forest stands on the ground"),
               .without_it = "required beside forest or forest_drag_kg_s",
               .meaning = "Effective height of the forest: it brakes rocks whose centre is less than this above the "
                          "ground.",
               .source = "RocFall, after Leine et al. 2014"},
              {.key = "ground_drag_per_s",
               .slot = member(&Material::ground_drag_per_s),
               .unit = "1/s",
               .range = up_to(most_factor, "ground cannot push"),
               .meaning = "Viscoplastic drag of soft ground: beside friction, a rock that slides or rolls on it is "
                          "braked by this times its velocity.",
               .source = "RAMMS::ROCKFALL (Bartelt et al. 2016): 0.3 on bedrock to 0.9 on a moor, see docs/laws.md"},
          },
      .add = [](Project& project) { return added(project.materials); },
      .rows = [](Project& project) { return all(project.materials); },
  };
}

Table ground() {
  auto [add, rows] = one_row(&Project::ground);
  return {
      .key = "ground",
      .meaning = "Which part of the terrain is made of which material.",
      .settings =
          {
              {.key = "default",
               .slot = member(&Ground::default_material),
               .without_it = "the only material",
               .meaning = "Name of the material wherever nothing else is said; required where there are several "
                          "materials and none of `segments`, `triangles`, `raster` and `polygons`.",
               .source = "Talus"},
              {.key = "segments",
               .slot = member(&Ground::segments),
               .without_it = "default everywhere",
               .excludes = {"triangles", "raster", "polygons"},
               .meaning = "Section: names of materials, one for each segment, in the order of the vertices.",
               .source = "Talus"},
              {.key = "triangles",
               .slot = member(&Ground::triangles),
               .range = at_least(0),
               .without_it = "default everywhere",
               .excludes = {"segments", "raster", "polygons"},
               .meaning = "Mesh: numbers of materials, counted from 0 in the order of the file, one for each triangle.",
               .source = "Talus"},
              {.key = "raster",
               .slot = member(&Ground::raster),
               .without_it = "default everywhere",
               .excludes = {"segments", "triangles", "polygons"},
               .meaning =
                   "Raster and mesh: a file of classes, in any coordinate system and with cells of any size; the "
                   "class at the middle of a cell or triangle of the terrain is that of its ground. Its path is "
                   "relative to the project file.",
               .source = "Talus"},
              {.key = "classes",
               .slot = member(&Ground::classes),
               .without_it = "required beside raster",
               .meaning = "Which class of the raster is which material, for example `{ 1 = \"Rock\", 2 = \"Scree\" }`; "
                          "where there is no class, the default holds.",
               .source = "Talus"},
              {.key = "polygons",
               .slot = member(&Ground::polygons),
               .without_it = "default everywhere",
               .excludes = {"segments", "triangles", "raster"},
               .meaning =
                   "Raster and mesh: a file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate "
                   "system; the polygon at the middle of a cell or triangle of the terrain says its ground, the "
                   "later one where there are several. Its path is relative to the project file.",
               .source = "Talus"},
              {.key = "layer",
               .slot = member(&Ground::layer),
               .without_it = "the file's only layer",
               .meaning = "Which layer of the file of polygons.",
               .source = "Talus"},
              {.key = "attribute",
               .slot = member(&Ground::attribute),
               .without_it = "required beside polygons",
               .meaning = "Which attribute of the polygons says their material.",
               .source = "Talus"},
              {.key = "values",
               .slot = member(&Ground::values),
               .without_it = "the attribute is the name of the material",
               .meaning = "Which value of that attribute is which material, for example `{ Fels = \"Rock\", Schutt = "
                          "\"Scree\" }`; where there is no polygon, the default holds.",
               .source = "Talus"},
          },
      .add = add,
      .rows = rows,
  };
}

Table area() {
  return {
      .key = "area",
      .repeated = true,
      .meaning =
          "3D: a part of the ground that is of another material than `[ground]` says, drawn on plan; any number "
          "of entries. Where several hold a place, the later one is its ground.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Area::name),
               .without_it = "`area N`, N counted from 1",
               .meaning = "Its name in messages; no other area has it.",
               .source = "Talus"},
              {.key = "material",
               .slot = member(&Area::material),
               .required = true,
               .meaning = "Name of the material of its ground.",
               .source = "Talus"},
              {.key = "polygon",
               .slot = plan_polygon_slot<Area>(),
               .unit = "m",
               .required = true,
               .meaning = "Its corners [x, y] on plan, three or more, in the coordinates of the terrain. A cell or "
                          "triangle of the terrain belongs to it where its middle does.",
               .source = "Talus"},
          },
      .add = [](Project& project) { return added(project.areas); },
      .rows = [](Project& project) { return all(project.areas); },
  };
}

Table seeder() {
  constexpr std::string_view one_size = "one of mass_kg, volume_m3 and diameter_m is required";
  return {
      .key = "seeder",
      .repeated = true,
      .required = true,
      .meaning = "Where rocks start, how many, how large and how fast; any number of entries.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Seeder::name),
               .without_it = "`seeder N`, N counted from 1",
               .meaning = "What results call it; no other seeder has it.",
               .source = "Talus"},
              {.key = "source",
               .slot = member(&Seeder::source),
               .without_it = "the seeder's name",
               .meaning = "Where its rocks come from, for results split by source; several seeders may share one.",
               .source = "Talus"},
              {.key = "type",
               .slot = member(&Seeder::type),
               .meaning =
                   "Rocks start at one `position`, spread evenly at random along lines (`points` or `lines`), or "
                   "from the cells within polygons (`polygons` or `polygon`) or of a raster (those of a `mask`, "
                   "or as steep as `min_slope_deg`).",
               .source = "RocFall3 for points and lines"},
              {.key = "position",
               .slot = position_slot(),
               .unit = "m",
               .range = place,
               .without_it = "required for a point",
               .excludes = {"points"},
               .meaning = "[x, z] in 2D, [x, y, z] in 3D; z may be `\"surface\"`, or left out with `height_above_m` "
                          "given.",
               .source = "Talus"},
              {.key = "points",
               .slot = points_slot(),
               .unit = "m",
               .range = place,
               .without_it = "required for a line",
               .excludes = {"position", "lines"},
               .meaning =
                   "Two or more positions, each as for a point. Rocks start evenly along the line: by its length in "
                   "space where z is given, by its length on plan where z is the surface or `height_above_m` is "
                   "given.",
               .source = "Talus"},
              {.key = "lines",
               .slot = member(&Seeder::lines),
               .without_it = "points say them",
               .excludes = {"points"},
               .meaning = "3D: a file of lines (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system; with "
                          "heights of their own, or laid on the terrain where they have none or `height_above_m` is "
                          "given; rocks start evenly by its length in space or, laid on the terrain, on plan. Its path "
                          "is relative to "
                          "the project file.",
               .source = "Talus"},
              {.key = "polygons",
               .slot = member(&Seeder::polygons),
               .without_it = "polygon says it",
               .excludes = {"polygon"},
               .meaning =
                   "3D: a file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system; rocks "
                   "start from the cells whose middle is within one. Its path is relative to the project file.",
               .source = "Talus"},
              {.key = "polygon",
               .slot = plan_polygon_slot<Seeder>(),
               .unit = "m",
               .without_it = "polygons say it",
               .excludes = {"polygons"},
               .meaning = "3D: the corners [x, y] of one polygon on plan, three or more, in the coordinates of the "
                          "terrain.",
               .source = "Talus"},
              {.key = "layer",
               .slot = member(&Seeder::layer),
               .without_it = "the file's only layer",
               .meaning = "Which layer of the file of lines or polygons.",
               .source = "Talus"},
              {.key = "source_attribute",
               .slot = member(&Seeder::source_attribute),
               .without_it = "source holds for all",
               .meaning = "An attribute of the lines or polygons whose value is the source of their rocks, for results "
                          "split by source; where it is empty, `source` holds.",
               .source = "Talus"},
              {.key = "min_slope_deg",
               .slot = member(&Seeder::min_slope_deg),
               .unit = "deg",
               .range = {.least = 0, .most = 90, .most_excluded = true},
               .without_it = "cells of any slope",
               .meaning = "Polygon and raster: rocks start only from cells at least as steep; the slope of a cell is "
                          "that of its elevation and those of its eight neighbours.",
               .source = "Horn 1981, as gdaldem and QGIS compute it"},
              {.key = "max_slope_deg",
               .slot = member(&Seeder::max_slope_deg),
               .unit = "deg",
               .range = {.least = 0, .most = 90, .least_excluded = true},
               .without_it = "cells of any slope",
               .meaning = "Polygon and raster: rocks start only from cells at most as steep.",
               .source = "Horn 1981, as gdaldem and QGIS compute it"},
              {.key = "mask",
               .slot = member(&Seeder::mask),
               .without_it = "cells are not masked",
               .meaning =
                   "Polygon and raster: a raster of whole numbers, in any coordinate system and with cells of any "
                   "size; rocks start only from cells at whose middle it has data other than 0. Its path is "
                   "relative to the project file.",
               .source = "Talus"},
              {.key = "mask_value",
               .slot = member(&Seeder::mask_value),
               .range = between(-2147483648.0, 2147483647.0),
               .without_it = "all but 0",
               .meaning = "The value of the mask from whose cells rocks start.",
               .source = "Talus"},
              {.key = "cell_m",
               .slot = member(&Seeder::cell_m),
               .unit = "m",
               .range = {.least = 0.01,
                         .most = largest_coordinate_m,
                         .too_low = "nothing is known of the ground on that scale"},
               .without_it =
                   "required for a polygon or raster seeder where the terrain is no raster, which has its own",
               .meaning = "Side of a cell from which rocks start; the cells' borders are at multiples of it.",
               .source = "Talus"},
              {.key = "place",
               .slot = member(&Seeder::place),
               .meaning = "Where in its cell a rock starts: anywhere with equal chance, or in the middle.",
               .source = "Talus"},
              {.key = "height_above_m",
               .slot = member(&Seeder::height_above_m),
               .unit = "m",
               .range = up_to(largest_coordinate_m, "a rock starts on the ground or above it", within_places),
               .without_it = "z says it",
               .meaning = "Height above the terrain, instead of z.",
               .source = "Talus",
               .doubt = beyond(highest_release_m, "a rock is released far above the ground",
                               "It is a height above the ground, not an elevation")},
              {.key = "rocks",
               .slot = member(&Seeder::rocks),
               .range = {.least = 1, .most = most_rocks, .too_low = "a seeder without rocks does nothing"},
               .excludes = {"rocks_per_cell"},
               .meaning = "How many rocks start here, in all; cells get equally many, or one more.",
               .source = "Talus"},
              {.key = "rocks_per_cell",
               .slot = member(&Seeder::rocks_per_cell),
               .range = {.least = 1, .most = most_rocks, .too_low = "a seeder without rocks does nothing"},
               .without_it = "rocks holds",
               .excludes = {"rocks"},
               .meaning = "Polygon and raster: how many rocks start from each cell.",
               .source = "Talus"},
              {.key = "mass_kg",
               .slot = member(&Seeder::mass_kg),
               .unit = "kg",
               .range =
                   {.least = least_mass_kg, .most = most_mass_kg, .too_low = "a rock has mass", .too_high = too_heavy},
               .without_it = one_size,
               .excludes = {"volume_m3", "diameter_m"},
               .meaning = "Mass of a rock.",
               .source = "the manual, table 1-1",
               .doubt = mass_doubt},
              {.key = "volume_m3",
               .slot = member(&Seeder::volume_m3),
               .unit = "m3",
               .range = {.least = least_volume_m3,
                         .most = most_volume_m3,
                         .too_low = "a rock has a volume",
                         .too_high = "no rock is so large"},
               .without_it = one_size,
               .excludes = {"mass_kg", "diameter_m"},
               .meaning = "Volume of a rock; its mass follows from the density.",
               .source = "Talus",
               .doubt = beyond(8000, beyond_blocks, "volume_m3 is in cubic metres")},
              {.key = "diameter_m",
               .slot = member(&Seeder::diameter_m),
               .unit = "m",
               .range = {.least = least_diameter_m,
                         .most = most_diameter_m,
                         .too_low = "a rock has a size",
                         .too_high = "no rock is so large"},
               .without_it = one_size,
               .excludes = {"mass_kg", "volume_m3"},
               .meaning = "Diameter of the sphere with the rock's volume; its mass follows from the density.",
               .source = "Talus",
               .doubt = beyond(largest_block_m, beyond_blocks, "diameter_m is in metres")},
              {.key = "density_kg_m3",
               .slot = member(&Seeder::density_kg_m3),
               .unit = "kg/m3",
               .range = {.least = 100,
                         .most = 20000,
                         .too_low = "rock weighs about 2000 to 3300 kg/m3",
                         .too_high = "rock weighs about 2000 to 3300 kg/m3"},
               .meaning = "Density of the rock; with its mass, it gives the radius.",
               .source = "the manual, table 1-1",
               .slip = density_slip},
              {.key = "horizontal_velocity_m_s",
               .slot = member(&Seeder::horizontal_velocity_m_s),
               .unit = "m/s",
               .range = within(most_speed_m_s, too_fast),
               .excludes = {"speed_m_s"},
               .meaning = "Horizontal velocity at the start, along `direction`.",
               .source = "the manual, table 1-1"},
              {.key = "vertical_velocity_m_s",
               .slot = member(&Seeder::vertical_velocity_m_s),
               .unit = "m/s",
               .range = within(most_speed_m_s, too_fast),
               .excludes = {"speed_m_s"},
               .meaning = "Vertical velocity at the start, positive up.",
               .source = "the manual, table 1-1"},
              {.key = "speed_m_s",
               .slot = member(&Seeder::speed_m_s),
               .unit = "m/s",
               .range = up_to(most_speed_m_s, "the direction says where to", too_fast),
               .without_it = "horizontal_velocity_m_s and vertical_velocity_m_s hold",
               .excludes = {"horizontal_velocity_m_s", "vertical_velocity_m_s"},
               .meaning = "Velocity at the start along a full, not only horizontal, `direction`.",
               .source = "Talus"},
              {.key = "rotational_velocity_deg_s",
               .slot = member(&Seeder::rotational_velocity_deg_s),
               .unit = "deg/s",
               .range = within(most_rotation_deg_s, "no rock spins so fast"),
               .meaning = "Spin at the start, positive where the rock rolls forwards along `direction`.",
               .source = "the manual, table 1-1"},
              {.key = "direction",
               .slot = direction_slot(),
               .range = within(largest_coordinate_m),
               .meaning = "[x, z] in 2D, [x, y, z] in 3D, of any length: of the horizontal velocity (then z is 0), or "
                          "of `speed_m_s`. Or `\"downslope\"`: down the ground below the place where the rock starts, "
                          "`speed_m_s` along it; [1, 0, 0] where that is level.",
               .source = "Talus"},
          },
      .add = [](Project& project) { return added(project.seeders); },
      .rows = [](Project& project) { return all(project.seeders); },
  };
}

/// What barriers and collectors have in common.
std::vector<Setting> line_settings(std::string_view unnamed) {
  return {
      {.key = "name",
       .slot = member(&Barrier::name),
       .without_it = unnamed,
       .meaning = "What results call it; no other barrier or collector has it.",
       .source = "Talus"},
      {.key = "line",
       .slot = plan_line_slot(),
       .unit = "m",
       .required = true,
       .meaning = "Where it stands: x in 2D; two or more points [x, y] on plan in 3D.",
       .source = "Talus"},
      {.key = "height_m",
       .slot = member(&Barrier::height_m),
       .unit = "m",
       .range = above_0_up_to(most_height_m, "it could not be hit", "nothing is built so high"),
       .required = true,
       .meaning = "Height along it, from the ground at its foot.",
       .source = "the manual, section 4"},
      {.key = "inclination_deg",
       .slot = member(&Barrier::inclination_deg),
       .unit = "deg",
       .range = {.least = -90,
                 .most = 90,
                 .least_excluded = true,
                 .most_excluded = true,
                 .too_low = "it would lie on the ground",
                 .too_high = "it would lie on the ground"},
       .meaning = "Lean from the vertical, positive towards the right of the line's direction (2D: towards +x).",
       .source = "Talus"},
  };
}

Table barrier() {
  Table table{
      .key = "barrier",
      .repeated = true,
      .meaning = "Something that stops rocks; any number of entries.",
      .settings = line_settings("`barrier N`, N counted from 1"),
      .add = [](Project& project) { return added_barrier(project, false); },
      .rows = [](Project& project) { return all_barriers(project, false); },
  };
  // Nets are up to 10 m high, embankments up to some 25 m. (A collector may be as high as it takes.)
  const auto height =
      std::ranges::find_if(table.settings, [](const Setting& setting) { return setting.key == "height_m"; });
  height->doubt = beyond(30, "no barrier was built so high", "A line that only records is a [[collector]]");
  table.settings.push_back({.key = "capacity_kJ",
                            .slot = member(&Barrier::capacity_kJ),
                            .unit = "kJ",
                            .range = {.least = 0,
                                      .most = most_energy_kJ,
                                      .least_excluded = true,
                                      .infinite_allowed = true,
                                      .too_low = "it could stop nothing, and a [[collector]] is what only counts",
                                      .too_high = "what stops every rock has the capacity inf"},
                            .meaning = "Kinetic energy that it takes; a rock with more breaks through with the excess.",
                            .source = "the manual, section 4, has barriers of infinite capacity"});
  table.settings.push_back({.key = "normal_restitution",
                            .slot = member(&Barrier::normal_restitution),
                            .range = restitution,
                            .without_it = "it holds what it stops",
                            .meaning = "Rn of a rock that bounces off it; given with `tangential_restitution`.",
                            .source = "Talus",
                            .slip = restitution_slip});
  table.settings.push_back({.key = "tangential_restitution",
                            .slot = member(&Barrier::tangential_restitution),
                            .range = restitution,
                            .without_it = "it holds what it stops",
                            .meaning = "Rt of a rock that bounces off it; given with `normal_restitution`.",
                            .source = "Talus",
                            .slip = restitution_slip});
  return table;
}

Table collector() {
  return {
      .key = "collector",
      .repeated = true,
      .meaning = "Something that records the rocks that pass it and does not touch them; any number of entries.",
      .settings = line_settings("`collector N`, N counted from 1"),
      .add = [](Project& project) { return added_barrier(project, true); },
      .rows = [](Project& project) { return all_barriers(project, true); },
  };
}

Range factor_of_safety() {
  return {.least = 1, .most = most_factor, .too_low = "a factor of safety takes nothing away"};
}

Table design() {
  return {
      .key = "design",
      .meaning =
          "Design of barriers: what rocks ask of a barrier along lines on plan, and which kit would catch the "
          "wanted share of them at the least cost (docs/barrier-design.md). Without this table nothing of it is "
          "computed.",
      .settings =
          {
              {.key = "lines",
               .slot = member(&Design::lines),
               .without_it = "all barriers and collectors",
               .meaning = "Names of the barriers and collectors that are candidates; a collector lets rocks go on to "
                          "the next line.",
               .source = "Talus"},
              {.key = "protect",
               .slot = member(&Design::protect),
               .without_it = "each line is judged by the rocks that reach it",
               .meaning = "Name of a collector that stands for what is to be protected: all lines are judged by the "
                          "rocks that reach this one, and a rock that goes past a line is not caught.",
               .source = "Talus"},
              {.key = "section_m",
               .slot = member(&Design::section_m),
               .unit = "m",
               .range = above_0_up_to(largest_coordinate_m, "a line is cut into pieces of it"),
               .meaning = "3D: length of the sections of a line, on plan, from where it first stands on the terrain "
                          "on; the last one has half as much to one and a half times as much.",
               .source = "Talus"},
              {.key = "percentiles",
               .slot = member(&Design::percentiles),
               .range = between(0, 100),
               .most_entries = most_percentiles,
               .meaning = "Which percentiles of energy, velocity and height are given along the lines, 20 at most.",
               .source = "Talus"},
              {.key = "confidence",
               .slot = member(&Design::confidence),
               .range = {.least = 0,
                         .most = 1,
                         .least_excluded = true,
                         .most_excluded = true,
                         .too_low = "it is a probability",
                         .too_high = "it is a probability"},
               .meaning = "Confidence of the intervals of percentiles and shares.",
               .source = "Talus",
               .slip = percent_slip},
              {.key = "standard",
               .slot = member(&Design::standard),
               .meaning = "How the percentiles become what a kit must be able to do; with `\"none\"` no factor and no "
                          "clearance is added.",
               .source = "UNI 11211-4"},
              {.key = "design_percentile",
               .slot = member(&Design::design_percentile),
               .range = between(0, 100),
               .meaning = "The percentile of velocity or energy, and of height, that the check begins with.",
               .source = "UNI 11211-4: 95"},
              {.key = "trajectory_factor",
               .slot = member(&Design::trajectory_factor),
               .range = factor_of_safety(),
               .meaning = "gamma_Tr, on velocities and heights: 1.02 where restitutions come from back analysis, 1.10 "
                          "where they come from literature.",
               .source = "UNI 11211-4, after others"},
              {.key = "topography_factor",
               .slot = member(&Design::topography_factor),
               .range = factor_of_safety(),
               .meaning = "gamma_Dp, on velocities and heights: 1.02 for a good survey of the terrain, 1.10 for a poor "
                          "one.",
               .source = "UNI 11211-4, after others"},
              {.key = "volume_factor",
               .slot = member(&Design::volume_factor),
               .range = factor_of_safety(),
               .meaning = "gamma_VolF1, on the mass: 1.02 for a good survey of the block, 1.10 for a poor one.",
               .source = "UNI 11211-4, after others"},
              {.key = "density_factor",
               .slot = member(&Design::density_factor),
               .range = factor_of_safety(),
               .meaning = "gamma_gamma, on the mass.",
               .source = "UNI 11211-4, after others"},
              {.key = "risk_factor",
               .slot = member(&Design::risk_factor),
               .range = factor_of_safety(),
               .meaning = "gamma_R, on the energy: 1.00 where little is at stake, up to 1.20 where much is.",
               .source = "UNI 11211-4, after others"},
              {.key = "energy_level",
               .slot = member(&Design::energy_level),
               .meaning =
                   "Which of its energies a kit must have: the maximum energy level of one impact, or the service "
                   "energy level, a third of it, of two.",
               .source = "EAD 340059-00-0106"},
              {.key = "energy_factor",
               .slot = member(&Design::energy_factor),
               .range = factor_of_safety(),
               .without_it = "1.2 for `\"MEL\"`, 1 for `\"SEL\"`",
               .meaning = "gamma_E, by which the kit's energy is divided.",
               .source = "UNI 11211-4, after others"},
              {.key = "energy",
               .slot = member(&Design::energy),
               .meaning =
                   "The energy that is compared with the kit's: of translation, as in the standard, or with that "
                   "of rotation.",
               .source = "UNI 11211-4"},
              {.key = "block_mass_kg",
               .slot = member(&Design::block_mass_kg),
               .unit = "kg",
               .range = {.least = least_mass_kg,
                         .most = most_mass_kg,
                         .too_low = "a block weighs something",
                         .too_high = too_heavy},
               .without_it = "each rock has its own mass",
               .meaning = "Mass of the design block: energy and size in the check are then its own, at the rocks' "
                          "velocities and density.",
               .source = "UNI 11211-4",
               .doubt = tonnes_doubt},
              {.key = "upper_clearance_m",
               .slot = member(&Design::upper_clearance_m),
               .unit = "m",
               .range = up_to(most_height_m),
               .meaning = "f, the least that a kit is higher than the design height; at least half the block, too.",
               .source = "UNI 11211-4"},
              {.key = "catch_share",
               .slot = member(&Design::catch_share),
               .range = {.least = 0,
                         .most = 1,
                         .least_excluded = true,
                         .too_low = "a kit that catches nothing need not be built",
                         .too_high = "there are no more than all rocks"},
               .meaning = "The share of rocks that a kit must catch to be ranked by its cost.",
               .source = "Talus",
               .slip = percent_slip},
              {.key = "heights_m",
               .slot = member(&Design::heights_m),
               .unit = "m",
               .range = above_0_up_to(most_height_m, "it could not be hit", "nothing is built so high"),
               .meaning = "Nominal heights of the kits to choose from.",
               .source = "Talus"},
              {.key = "energies_kJ",
               .slot = member(&Design::energies_kJ),
               .unit = "kJ",
               .range = above_0_up_to(most_energy_kJ, "it could stop nothing"),
               .meaning = "Maximum energy levels of the kits to choose from.",
               .source = "EAD 340059-00-0106, classes 0 to 7"},
              {.key = "cost_height_exponent",
               .slot = member(&Design::cost_height_exponent),
               .range = up_to(most_exponent, "a higher kit is not cheaper"),
               .meaning = "a of the cost index: length x height^a x energy^b, in m and kJ.",
               .source = "Talus; an input"},
              {.key = "cost_energy_exponent",
               .slot = member(&Design::cost_energy_exponent),
               .range = up_to(most_exponent, "a stronger kit is not cheaper"),
               .meaning = "b of the cost index.",
               .source = "Talus; an input"},
          },
      .add = [](Project& project) -> Row { return &project.design.emplace(); },
      .rows = [](Project& project) { return project.design ? std::vector<Row>{&*project.design} : std::vector<Row>{}; },
  };
}

Table output() {
  auto [add, rows] = one_row(&Project::output);
  return {
      .key = "output",
      .meaning = "What is written beside the summary and the barrier hits.",
      .settings =
          {
              {.key = "endpoints",
               .slot = rock_limit_slot(&Output::endpoint_limit),
               .range = between(0, most_rocks),
               .meaning = "Of which rocks `endpoints.csv` has the end: `\"all\"`, `\"none\"`, or so many, evenly "
                          "spread. A rock whose path is written has its end there, too.",
               .source = "Talus"},
              {.key = "paths",
               .slot = rock_limit_slot(&Output::path_limit),
               .range = between(0, most_rocks),
               .meaning = "Of which rocks `paths.csv` has the whole path: `\"all\"`, `\"none\"`, or so many, "
                          "evenly spread.",
               .source = "Talus"},
              {.key = "maps",
               .slot = member(&Output::maps),
               .most_entries = io::map_subject_names.size(),
               .meaning = "Writes where rocks pass, how fast, how high and with how much energy: in 3D maps, as "
                          "GeoTIFFs in the folder `maps`; in 2D the same along the section, `envelopes.csv`. `true` "
                          "stands for all; of a list only what it names is gathered and written; an empty one is "
                          "`false`.",
               .source = "Talus"},
              {.key = "maps_by_source",
               .slot = member(&Output::maps_by_source),
               .meaning = "Writes maps of each source's rocks, too, in folders of `maps/by_source`.",
               .source = "Talus"},
              {.key = "raster_cell_m",
               .slot = map_cell_slot(),
               .unit = "m",
               .range = {.least = 0.01,
                         .most = largest_coordinate_m,
                         .too_low = "nothing is known of the ground on that scale"},
               .without_it = "`\"terrain\"` on a raster, else 1",
               .meaning =
                   "Side of a map's cell, or length of an envelope's, whose borders are at multiples of it; with "
                   "`\"terrain\"` the cells are those of the terrain's raster.",
               .source = "Talus"},
              {.key = "percentiles",
               .slot = member(&Output::percentiles),
               .range = between(0, 100),
               .most_entries = most_percentiles,
               .meaning =
                   "Which percentiles of energies, velocity and bounce height are mapped beside the greatest and "
                   "the mean, 20 at most.",
               .source = "Talus"},
              {.key = "geopackage",
               .slot = rock_limit_slot(&Output::geopackage_limit),
               .range = between(0, most_rocks),
               .meaning = "3D: of which rocks `results.gpkg` holds end points and paths, beside the barriers: "
                          "`\"all\"`, or of so many; with `\"none\"` there is no such file.",
               .source = "Talus"},
              {.key = "vtk",
               .slot = member(&Output::vtk),
               .meaning = "Writes `paths.vtp`, the paths for ParaView, of the rocks that `paths` names.",
               .source = "Talus"},
              {.key = "report",
               .slot = member(&Output::report),
               .meaning = "Writes `report.html`, a page of figures that opens without a network.",
               .source = "Talus"},
          },
      .add = add,
      .rows = rows,
  };
}

Table distribution() {
  return {
      .key = "distribution",
      .meaning = "A random property. A plain number n is short for `{ mean = n, distribution = \"none\" }`.",
      .settings =
          {
              {.key = "mean",
               .slot = member(&Distribution::mean),
               .required = true,
               .meaning =
                   "The mean before truncation, in the property's unit. Limits that are not even about it move the "
                   "mean of the draws, of `uniform` and `triangular` too; a warning then gives both numbers.",
               .source = "the manual, tables 1-1 and 1-2"},
              {.key = "distribution",
               .slot = member(&Distribution::kind),
               .meaning = "The kind; with `\"none\"` every draw is the mean, whatever the other keys say.",
               .source = "the manual, tables 1-1 and 1-2"},
              {.key = "std_dev",
               .slot = member(&Distribution::std_dev),
               .range = at_least(0, "a standard deviation is a width"),
               .without_it = "required, except for `exponential` (the mean), and for `uniform` and `triangular` with "
                             "limits",
               .meaning = "Standard deviation before truncation, in the property's unit.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "rel_min",
               .slot = member(&Distribution::rel_min),
               .range = at_least(0, "it is a distance below the mean"),
               .without_it = "no limit but the property's own",
               .meaning = "No draw is below mean - rel_min.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "rel_max",
               .slot = member(&Distribution::rel_max),
               .range = at_least(0, "it is a distance above the mean"),
               .without_it = "no limit but the property's own",
               .meaning = "No draw is above mean + rel_max.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
          },
      .add = nullptr,
      .rows = nullptr,
  };
}

template <std::size_t count>
using Words = std::array<std::string_view, count>;

/// 1e12 and 1e-9 for a power of ten whose zeros nobody counts; others as they are.
std::string limit_text(double limit) {
  const double size = std::abs(limit);
  if (size == 0 || !std::isfinite(size) || (size > 1e-3 && size < 1e6)) return fmt::format("{}", limit);
  const double power = std::round(std::log10(size));
  if (size != std::pow(10, power)) return fmt::format("{}", limit);
  return fmt::format("{}1e{}", limit < 0 ? "-" : "", power);
}

}  // namespace

bool Range::contains(double value) const {
  if (std::isnan(value)) return false;
  if (std::isinf(value)) return infinite_allowed && value > 0;
  return (least_excluded ? value > least : value >= least) && (most_excluded ? value < most : value <= most);
}

bool Range::is_everything() const { return least == -infinity && most == infinity; }

std::string Range::text() const {
  if (is_everything()) return "any number";
  const std::string from = limit_text(least), to = limit_text(most);
  if (most == infinity) return least_excluded ? fmt::format("more than {}", from) : fmt::format("{} or more", from);
  if (!least_excluded && !most_excluded) return fmt::format("{} to {}", from, to);
  if (!least_excluded) return fmt::format("{} to less than {}", from, to);
  return fmt::format("more than {}, {} {}", from, most_excluded ? "less than" : "up to", to);
}

std::span<const std::string_view> words(RockModel) {
  static constexpr Words<2> list{"lumped_mass", "rigid_sphere"};
  return list;
}
std::span<const std::string_view> words(SlidingMethod) {
  static constexpr Words<2> list{"stepped", "closed_form"};
  return list;
}
std::span<const std::string_view> words(FrictionSource) {
  static constexpr Words<3> list{"material", "tangential_restitution", "zero"};
  return list;
}
std::span<const std::string_view> words(MaterialSampling) {
  static constexpr Words<2> list{"per_impact", "per_rock"};
  return list;
}
std::span<const std::string_view> words(SamplingMethod) {
  static constexpr Words<2> list{"monte_carlo", "latin_hypercube"};
  return list;
}
std::span<const std::string_view> words(SeederType) {
  static constexpr Words<4> list{"point", "line", "polygon", "raster"};
  return list;
}
std::span<const std::string_view> words(PlaceInCell) {
  static constexpr Words<2> list{"random", "centre"};
  return list;
}
std::span<const std::string_view> words(Forest) {
  static constexpr Words<4> list{"none", "open", "medium", "dense"};
  return list;
}
std::span<const std::string_view> words(DistributionKind) {
  static constexpr Words<8> list{"none", "normal",      "uniform",   "triangular",
                                 "beta", "exponential", "lognormal", "gamma"};
  return list;
}

std::span<const std::string_view> words(DesignStandard) {
  static constexpr Words<2> list{"UNI 11211-4", "none"};
  return list;
}
std::span<const std::string_view> words(DesignLevel) {
  static constexpr Words<2> list{"MEL", "SEL"};
  return list;
}
std::span<const std::string_view> words(DesignEnergy) {
  static constexpr Words<2> list{"translational", "total"};
  return list;
}
std::span<const std::string_view> words(io::MapSubject) { return io::map_subject_names; }

std::string meaning_of(const Setting& setting) {
  if (!setting.only_for) return std::string(setting.meaning);
  const bool is_sphere = *setting.only_for == RockModel::rigid_sphere;
  return fmt::format("{}: {}", is_sphere ? "Rigid sphere" : "Lumped mass", setting.meaning);
}

const Setting* Table::find(std::string_view setting) const {
  const auto found = std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.key == setting; });
  return found == settings.end() ? nullptr : &*found;
}

std::string Table::heading() const { return fmt::format(fmt::runtime(repeated ? "[[{}]]" : "[{}]"), key); }

const std::vector<Table>& tables() {
  static const std::vector<Table> list{head(), analysis(), sampling(), terrain(),   material(), ground(),
                                       area(), seeder(),   barrier(),  collector(), design(),   output()};
  return list;
}

const Table& distribution_table() {
  static const Table table = distribution();
  return table;
}

const Setting& setting(std::string_view table, std::string_view key) {
  for (const Table& candidate : tables()) {
    if (candidate.key != table) continue;
    if (const Setting* found = candidate.find(key)) return *found;
  }
  TALUS_PROMISE(false, "only declared settings are asked for");
  throw std::logic_error(fmt::format("no setting {}.{} is declared", table, key));
}

Bounds bounds(const Range& range) {
  const Bounds widest;
  return {std::max(range.least, widest.least), std::min(range.most, widest.most)};
}

Bounds bounds(std::string_view table, std::string_view key) { return bounds(setting(table, key).range); }

}  // namespace talus::project
