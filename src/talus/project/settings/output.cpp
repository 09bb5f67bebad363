#include "talus/maps/map_subjects.hpp"
#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> rock_limit_slot(std::optional<std::int64_t> Output::*limit) {
  return [limit](Row row) -> Slot { return RockLimitSlot{&(std::get<Output*>(row)->*limit)}; };
}
std::function<Slot(Row)> map_cell_slot() {
  return [](Row row) -> Slot { return MapCellSlot{&std::get<Output*>(row)->raster_cell_m}; };
}

}  // namespace

Table output_table() {
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
               .title = "Rocks with paths",
               .topic = topics::paths,
               .meaning = "Of which rocks `paths.csv` has the whole path: `\"all\"`, `\"none\"`, or so many, "
                          "evenly spread.",
               .source = "Talus"},
              {.key = "maps",
               .slot = member(&Output::maps),
               .most_entries = map_subject_names.size(),
               .group = "Maps",
               .topic = topics::maps,
               .meaning = "Writes where rocks pass, how fast, how high and with how much energy: in 3D maps, as "
                          "GeoTIFFs in the folder `maps`; in 2D the same along the section, `envelopes.csv`. `true` "
                          "stands for all; of a list only what it names is gathered and written; an empty one is "
                          "`false`.",
               .source = "Talus"},
              {.key = "maps_by_source",
               .slot = member(&Output::maps_by_source),
               .applies_when =
                   {in_3d(Otherwise::warned, {}, "a section has no area to map", "Give terrain.width_m for 3D"),
                    {.any_of = {is_not("maps", {"false", "[]"})}, .why = "maps is false", .hint = "Let maps be true"}},
               .asks_nothing = {"false"},
               .group = "Maps",
               .topic = topics::maps,
               .meaning = "Writes maps of each source's rocks, too, in folders of `maps/by_source`.",
               .source = "Talus"},
              {.key = "raster_cell_m",
               .slot = map_cell_slot(),
               .unit = "m",
               .range = {.least = 0.01,
                         .most = largest_coordinate_m,
                         .too_low = "nothing is known of the ground on that scale"},
               .without_it = "`\"terrain\"` on a raster, else 1",
               .title = "Cell of the maps",
               .group = "Maps",
               .topic = topics::maps,
               .meaning =
                   "Side of a map's cell, or length of an envelope's, whose borders are at multiples of it; with "
                   "`\"terrain\"` the cells are those of the terrain's raster.",
               .source = "Talus"},
              {.key = "percentiles",
               .slot = member(&Output::percentiles),
               .range = between(0, 100),
               .most_entries = most_percentiles,
               .group = "Maps",
               .topic = topics::maps,
               .meaning =
                   "Which percentiles of energies, velocity and bounce height are mapped beside the greatest and "
                   "the mean, 20 at most.",
               .source = "Talus"},
              {.key = "geopackage",
               .slot = rock_limit_slot(&Output::geopackage_limit),
               .range = between(0, most_rocks),
               .applies_when = {in_3d(Otherwise::warned, {}, "a section lies nowhere on a map",
                                      "Give terrain.width_m for 3D")},
               .asks_nothing = {"none", "0"},
               .title = "Rocks in the GeoPackage",
               .topic = topics::geopackage,
               .meaning = "3D: of which rocks `results.gpkg` holds end points and paths, beside the barriers: "
                          "`\"all\"`, or of so many; with `\"none\"` there is no such file.",
               .source = "Talus"},
              {.key = "vtk",
               .slot = member(&Output::vtk),
               .applies_when = {{.any_of = {is_not("paths", {"none", "0"})},
                                 .why = "paths is \"none\"",
                                 .hint = "Let paths be a number of rocks"}},
               .asks_nothing = {"false"},
               .title = "Paths for ParaView",
               .topic = topics::vtk,
               .meaning = "Writes `paths.vtp`, the paths for ParaView, of the rocks that `paths` names.",
               .source = "Talus"},
              {.key = "report",
               .slot = member(&Output::report),
               .meaning = "Writes `report.html`, a page of figures that opens without a network.",
               .source = "Talus"},
          },
      .groups = {{""}, {"Maps"}},
      .topic = topics::output,
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
