#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"
#include "talus/seeding/release_height.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> position_slot() {
  return [](const Row& row) -> Slot { return PositionSlot{&row.as<Seeder>()}; };
}
std::function<Slot(Row)> points_slot() {
  return [](const Row& row) -> Slot { return PointsSlot{&row.as<Seeder>()}; };
}
std::function<Slot(Row)> polygon_slot() {
  return [](const Row& row) -> Slot { return PlanPolygonSlot{&row.as<Seeder>().in_cells.polygon}; };
}
std::function<Slot(Row)> size_slot(SizeOf of) {
  return [of](const Row& row) -> Slot { return SizeSlot{&row.as<Seeder>().size, of}; };
}
std::function<Slot(Row)> direction_slot() {
  return [](const Row& row) -> Slot { return DirectionSlot{&row.as<Seeder>().direction}; };
}

/// For keys that give the position of one type of seeder.
Need of_type(SeederType type) {
  return {.any_of = {is("type", {word(type)})},
          .otherwise = Otherwise::refused,
          .what = "is given for a {}",
          .why = "it belongs to another type of seeder",
          .hint = "Leave it out"};
}

Need of_cells() {
  return {.any_of = {is("type", {word(SeederType::polygon), word(SeederType::raster)})},
          .why = "a {} seeder has no cells"};
}

Need of_types_with_files() {
  return {.any_of = {is("type", {word(SeederType::line), word(SeederType::polygon), word(SeederType::table)})},
          .why = "a {} seeder has no file of lines, polygons or rows"};
}

Need of_a_file() {
  return {.any_of = {given("lines"), given("polygons"), given("table")},
          .why = "it belongs to a file of lines, polygons or rows"};
}

Need on_a_map() {
  return in_3d(Otherwise::refused, "is given in 2D", "a section has no position on a map", "Use points");
}

}  // namespace

Table seeder_table() {
  constexpr std::string_view one_size =
      "one of `mass_kg`, `volume_m3` and `diameter_m` is required, unless a table gives it";
  return {
      .key = "seeder",
      .repeated = true,
      .required = true,
      .meaning = "Where rocks start, how many, how large and how fast; any number of entries.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Seeder::name),
               .without_it = "`seeder N`, numbered from 1",
               .meaning = "Name in the results; must be unique.",
               .source = "Talus"},
              {.key = "source",
               .slot = member(&Seeder::source),
               .without_it = "the seeder's name",
               .meaning = "Source area of its rocks, for results split by source; several seeders may share one.",
               .source = "Talus"},
              {.key = "type",
               .slot = member(&Seeder::type),
               .group = "Where rocks start",
               .meaning =
                   "Rocks start at one `position`, at random along lines (`points` or `lines`), from the cells inside "
                   "polygons (`polygons` or `polygon`) or of a raster (selected by `mask` or `min_slope_deg`), or from "
                   "the rows of a `table`.",
               .source = "RocFall3 for points and lines"},
              {.key = "position",
               .slot = position_slot(),
               .unit = "m",
               .range = place,
               .without_it = "required for a point",
               .applies_when = {of_type(SeederType::point)},
               .group = "Where rocks start",
               .meaning =
                   "[x, z] in 2D, [x, y, z] in 3D; z may be `\"surface\"`, or left out if `height_above_m` is given.",
               .source = "Talus"},
              {.key = "points",
               .slot = points_slot(),
               .unit = "m",
               .range = place,
               .without_it = "required for a line",
               .applies_when = {of_type(SeederType::line)},
               .title = "Points of a line",
               .group = "Where rocks start",
               .meaning =
                   "Two or more positions, each as for a point. Rocks start evenly along the line: along its length in "
                   "space if z is given, along its length on plan if z is the surface or `height_above_m` is given.",
               .source = "Talus"},
              {.key = "lines",
               .slot = member(&Seeder::along_lines, &AlongLines::file),
               .without_it = "given by `points`",
               .applies_when = {of_type(SeederType::line), on_a_map()},
               .title = "Lines of a file",
               .group = "Where rocks start",
               .topic = topics::lines,
               .meaning =
                   "3D: a file of lines (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system. Lines without "
                   "heights, or all lines if `height_above_m` is given, are laid on the terrain. Rocks start evenly "
                   "along the length in space or, on the terrain, on plan. The path is relative to the project file.",
               .source = "Talus"},
              {.key = "polygons",
               .slot = member(&Seeder::in_cells, &InCells::polygons),
               .without_it = "given by `polygon`",
               .applies_when = {of_type(SeederType::polygon), on_a_map()},
               .title = "Polygons of a file",
               .group = "Where rocks start",
               .topic = topics::cells,
               .meaning =
                   "3D: a file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system; rocks "
                   "start from the cells whose centre is inside one. The path is relative to the project file.",
               .source = "Talus"},
              {.key = "polygon",
               .slot = polygon_slot(),
               .unit = "m",
               .without_it = "given by `polygons`",
               .applies_when = {of_type(SeederType::polygon), on_a_map()},
               .title = "Polygon",
               .group = "Where rocks start",
               .topic = topics::cells,
               .meaning = "3D: three or more corners [x, y] of one polygon on plan, in terrain coordinates.",
               .source = "Talus"},
              {.key = "table",
               .slot = member(&Seeder::from_table, &FromTable::file),
               .without_it = "required for a table",
               .applies_when = {of_type(SeederType::table)},
               .title = "Table of releases",
               .group = "Where rocks start",
               .topic = topics::release_table,
               .meaning =
                   "A file with a release in each row: text with columns such as `x_m`, `y_m`, `z_m`, `vx_m_s` "
                   "and `mass_kg`; or, in 3D, points of a vector file (GeoPackage, Shapefile, GeoJSON, ...), in "
                   "any coordinate system, with such attributes. What a row does not give follows from the other "
                   "settings of the seeder. The path is relative to the project file.",
               .source = "Talus"},
              {.key = "name_attribute",
               .slot = member(&Seeder::from_table, &FromTable::name_attribute),
               .without_it = "the column `name`, if there is one",
               .applies_when = {of_type(SeederType::table)},
               .title = "Column of names",
               .group = "Where rocks start",
               .topic = topics::release_table,
               .meaning = "Column of the table with the names of its rows.",
               .source = "Talus"},
              {.key = "layer",
               .slot = member(&Seeder::layer),
               .without_it = "the file's only layer",
               .applies_when = {of_types_with_files(), of_a_file()},
               .group = "Where rocks start",
               .topic = topics::vector_files,
               .meaning = "Layer of the file of lines, polygons or points.",
               .source = "Talus"},
              {.key = "source_attribute",
               .slot = member(&Seeder::source_attribute),
               .without_it = "`source` applies to all",
               .applies_when = {of_types_with_files(), of_a_file()},
               .group = "Where rocks start",
               .meaning = "Attribute of the lines or polygons, or column of the table, that gives the source of their "
                          "rocks, for results split by source; where it is empty, `source` applies.",
               .source = "Talus"},
              {.key = "min_slope_deg",
               .slot = member(&Seeder::in_cells, &InCells::min_slope_deg),
               .unit = "deg",
               .range = {.least = 0, .most = 90, .most_excluded = true},
               .without_it = "cells of any slope",
               .applies_when = {of_cells()},
               .title = "Minimum slope",
               .group = "Where rocks start",
               .topic = topics::cells,
               .meaning = "Polygon and raster: rocks start only from cells at least this steep; the slope of a cell "
                          "follows from its elevation and those of its eight neighbours.",
               .source = "Horn 1981, as gdaldem and QGIS compute it"},
              {.key = "max_slope_deg",
               .slot = member(&Seeder::in_cells, &InCells::max_slope_deg),
               .unit = "deg",
               .range = {.least = 0, .most = 90, .least_excluded = true},
               .without_it = "cells of any slope",
               .applies_when = {of_cells()},
               .title = "Maximum slope",
               .group = "Where rocks start",
               .topic = topics::cells,
               .meaning = "Polygon and raster: rocks start only from cells at most this steep.",
               .source = "Horn 1981, as gdaldem and QGIS compute it"},
              {.key = "mask",
               .slot = member(&Seeder::in_cells, &InCells::mask),
               .without_it = "no cell is masked",
               .applies_when = {of_cells()},
               .group = "Where rocks start",
               .topic = topics::cells,
               .meaning = "Polygon and raster: a raster of whole numbers, in any coordinate system and with cells of "
                          "any size; rocks start only from cells with a value other than 0 at their centre. The path "
                          "is relative to the project file.",
               .source = "Talus"},
              {.key = "mask_value",
               .slot = member(&Seeder::in_cells, &InCells::mask_value),
               .range = between(-2147483648.0, 2147483647.0),
               .without_it = "any value but 0",
               .applies_when = {of_cells(), together_with({given("mask")}, "is given without a mask")},
               .group = "Where rocks start",
               .meaning = "Value of the mask in the cells from which rocks start.",
               .source = "Talus"},
              {.key = "cell_m",
               .slot = member(&Seeder::in_cells, &InCells::cell_m),
               .unit = "m",
               .range = {.least = 0.01,
                         .most = largest_coordinate_m,
                         .too_low = "the ground is not known at that scale"},
               .without_it = "required for polygon and raster seeders, unless the terrain is a raster",
               .applies_when = {of_cells(),
                                {.any_of = {absent("terrain.raster")},
                                 .why = "the cells are those of the terrain's raster"}},
               .group = "Where rocks start",
               .topic = topics::cells,
               .meaning = "Size of the cells from which rocks start; their edges are at multiples of it.",
               .source = "Talus"},
              {.key = "place",
               .slot = member(&Seeder::in_cells, &InCells::place),
               .applies_when = {of_cells()},
               .always_accepted = {word(PlaceInCell::random)},
               .title = "Place in the cell",
               .group = "Where rocks start",
               .topic = topics::cells,
               .meaning = "Where in its cell a rock starts: anywhere with equal probability, or at the centre.",
               .source = "Talus"},
              {.key = "height_above_m",
               .slot = member(&Seeder::height_above_m),
               .unit = "m",
               .range = up_to(largest_coordinate_m, "a rock starts on the ground or above it", within_places),
               .without_it = "0 for the cells of an area, else given by z",
               .group = "Where rocks start",
               .meaning = "Height above the terrain, instead of z.",
               .source = "Talus",
               .doubt = beyond(highest_release_m, "rocks would start far above the ground",
                               "It is a height above the ground, not an elevation")},
              {.key = "rocks",
               .slot = member(&Seeder::rocks),
               .range = {.least = 1, .most = most_rocks, .too_low = "a seeder without rocks does nothing"},
               .group = "How many",
               .meaning =
                   "Total number of rocks; cells and rows get equal numbers, to within one. A table without it has "
                   "one rock for each row.",
               .source = "Talus"},
              {.key = "rocks_per_cell",
               .slot = member(&Seeder::in_cells, &InCells::rocks_per_cell),
               .range = {.least = 1, .most = most_rocks, .too_low = "a seeder without rocks does nothing"},
               .without_it = "given by `rocks`",
               .applies_when = {of_cells()},
               .group = "How many",
               .topic = topics::cells,
               .meaning = "Polygon and raster: number of rocks from each cell.",
               .source = "Talus"},
              {.key = "rocks_per_row",
               .slot = member(&Seeder::from_table, &FromTable::rocks_per_row),
               .range = {.least = 1, .most = most_rocks, .too_low = "a seeder without rocks does nothing"},
               .without_it = "1, or given by `rocks`",
               .applies_when = {{.any_of = {is("type", {word(SeederType::table)})}, .why = "a {} seeder has no rows"}},
               .group = "How many",
               .topic = topics::release_table,
               .meaning = "Table: number of rocks from each row.",
               .source = "Talus"},
              {.key = "mass_kg",
               .slot = size_slot(SizeOf::mass),
               .unit = "kg",
               .range =
                   {.least = least_mass_kg, .most = most_mass_kg, .too_low = "a rock has mass", .too_high = too_heavy},
               .without_it = one_size,
               .group = "How large",
               .meaning = "Mass of a rock.",
               .source = "the manual, table 1-1",
               .doubt = mass_doubt},
              {.key = "volume_m3",
               .slot = size_slot(SizeOf::volume),
               .unit = "m3",
               .range = {.least = least_volume_m3,
                         .most = most_volume_m3,
                         .too_low = "a rock has a volume",
                         .too_high = "no rock is that large"},
               .without_it = one_size,
               .group = "How large",
               .meaning = "Volume of a rock; its mass follows from the density.",
               .source = "Talus",
               .doubt = beyond(8000, beyond_blocks, "volume_m3 is in cubic metres")},
              {.key = "diameter_m",
               .slot = size_slot(SizeOf::diameter),
               .unit = "m",
               .range = {.least = least_diameter_m,
                         .most = most_diameter_m,
                         .too_low = "a rock has a size",
                         .too_high = "no rock is that large"},
               .without_it = one_size,
               .group = "How large",
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
               .group = "How large",
               .meaning = "Density of the rock; mass and density give the radius.",
               .source = "the manual, table 1-1",
               .slip = density_slip},
              {.key = "shape",
               .slot = member(&Seeder::shape),
               .applies_when = {of_model(RockModel::rigid_body, Otherwise::warned)},
               .always_accepted = {sphere_word},
               .group = "Shape",
               .topic = topics::shapes,
               .meaning = "shape of the rocks: the name of a `[[shape]]`, or one of the words of docs/shapes.md, such "
                          "as `\"equant\"`, `\"flat\"`, `\"long\"`, `\"cube\"`, `\"hexagon\"`. Mass and density give "
                          "the volume.",
               .source = "RocFall3: rock shapes"},
              {.key = "orientation_deg",
               .slot = member(&Seeder::orientation_deg),
               .unit = "deg",
               .range = within(360),
               .without_it = "random, every orientation equally likely",
               .most_entries = 3,
               .applies_when = {of_model(RockModel::rigid_body, Otherwise::warned)},
               .title = "Orientation",
               .group = "Shape",
               .topic = topics::shapes,
               .meaning = "how the rocks are turned at release. 3D: [about z, about y, about x], the last first; a "
                          "block's longest axis is along x, its shortest along z. 2D: [angle], about y, from z to x.",
               .source = "Talus"},
              {.key = "horizontal_velocity_m_s",
               .slot = member(&Seeder::horizontal_velocity_m_s),
               .unit = "m/s",
               .range = within(most_speed_m_s, too_fast),
               .group = "How fast",
               .meaning = "Horizontal velocity of release, along `direction`.",
               .source = "the manual, table 1-1"},
              {.key = "vertical_velocity_m_s",
               .slot = member(&Seeder::vertical_velocity_m_s),
               .unit = "m/s",
               .range = within(most_speed_m_s, too_fast),
               .group = "How fast",
               .meaning = "Vertical velocity of release, positive upwards.",
               .source = "the manual, table 1-1"},
              {.key = "speed_m_s",
               .slot = member(&Seeder::speed_m_s),
               .unit = "m/s",
               .range = up_to(most_speed_m_s, "direction gives the sign", too_fast),
               .without_it = "given by `horizontal_velocity_m_s` and `vertical_velocity_m_s`",
               .group = "How fast",
               .meaning = "Velocity of release along `direction` in space, not only on plan.",
               .source = "Talus"},
              {.key = "rotational_velocity_deg_s",
               .slot = member(&Seeder::rotational_velocity_deg_s),
               .unit = "deg/s",
               .range = within(most_rotation_deg_s, "no rock spins that fast"),
               .group = "How fast",
               .meaning = "Spin at release, positive if the rock rolls forwards along `direction`.",
               .source = "the manual, table 1-1"},
              {.key = "direction",
               .slot = direction_slot(),
               .range = within(largest_coordinate_m),
               .without_it = "`\"downslope\"` for the cells of an area, else `[1, 0, 0]`",
               .group = "How fast",
               .meaning = "[x, z] in 2D, [x, y, z] in 3D, of any length: of the horizontal velocity (then z is 0) or "
                          "of `speed_m_s`. Or `\"downslope\"`: down the ground below the release, with `speed_m_s` "
                          "along it; [1, 0, 0] where the ground is level.",
               .source = "Talus"},
          },
      .choices = {{{"position"}, {"points"}},
                  {{"points"}, {"lines"}},
                  {{"polygon"}, {"polygons"}},
                  {{"rocks"}, {"rocks_per_cell"}, {"rocks_per_row"}},
                  {{"mass_kg"}, {"volume_m3"}, {"diameter_m"}},
                  {{"horizontal_velocity_m_s", "vertical_velocity_m_s"}, {"speed_m_s"}}},
      .groups = {{""}, {"Where rocks start"}, {"How many"}, {"How large"}, {"Shape"}, {"How fast"}},
      .topic = topics::seeders,
      .add = [](Project& project) { return added(project.seeders); },
      .rows = [](Project& project) { return all(project.seeders); },
  };
}

}  // namespace talus::project::declared
