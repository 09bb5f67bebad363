#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/seeding/release_height.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> position_slot() {
  return [](Row row) -> Slot { return PositionSlot{std::get<Seeder*>(row)}; };
}
std::function<Slot(Row)> points_slot() {
  return [](Row row) -> Slot { return PointsSlot{std::get<Seeder*>(row)}; };
}
std::function<Slot(Row)> direction_slot() {
  return [](Row row) -> Slot { return DirectionSlot{&std::get<Seeder*>(row)->direction}; };
}

}  // namespace

Table seeder_table() {
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

}  // namespace talus::project::declared
