#include "talus/maps/map_subjects.hpp"
#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> limit_slot(std::optional<std::int64_t> Output::*limit) {
  return [limit](const Row& row) -> Slot { return LimitSlot{&(row.as<Output>().*limit)}; };
}
std::function<Slot(Row)> runout_point_slot() {
  return [](const Row& row) -> Slot { return PlanPointSlot{&row.as<Output>().runout_from}; };
}
std::function<Slot(Row)> runout_line_slot() {
  return [](const Row& row) -> Slot { return PlanLineSlot{&row.as<Output>().runout_along}; };
}
std::function<Slot(Row)> map_cell_slot() {
  return [](const Row& row) -> Slot { return MapCellSlot{&row.as<Output>().raster_cell_m}; };
}

}  // namespace

Table output_table() {
  auto [add, rows] = one_row(&Project::output);
  return {
      .key = "output",
      .meaning = "What is written in addition to the summary and the barrier hits.",
      .settings =
          {
              {.key = "endpoints",
               .slot = limit_slot(&Output::endpoint_limit),
               .range = between(0, most_rocks),
               .meaning = "Number of rocks in `endpoints.csv`: `\"all\"`, `\"none\"` or a number, evenly spread. Rocks "
                          "whose paths are written are always included.",
               .source = "Talus"},
              {.key = "paths",
               .slot = limit_slot(&Output::path_limit),
               .range = between(0, most_rocks),
               .title = "Rocks with paths",
               .topic = topics::paths,
               .meaning =
                   "Number of rocks with a path in `paths.csv`: `\"all\"`, `\"none\"` or a number, evenly spread.",
               .source = "Talus"},
              {.key = "impacts",
               .slot = limit_slot(&Output::impact_limit),
               .range = between(0, most_rocks),
               .title = "Rocks with impacts",
               .topic = topics::impacts,
               .meaning =
                   "Number of rocks whose impacts are in `impacts.csv`: `\"all\"`, `\"none\"` or a number, evenly "
                   "spread. With `\"none\"`, the file is not written.",
               .source = "Talus"},
              {.key = "trajectories",
               .slot = limit_slot(&Output::stored_limit),
               .range = between(0, most_rocks),
               .title = "Rocks in the store of trajectories",
               .topic = topics::trajectories,
               .meaning = "Number of rocks in `trajectories.bin`, from which lines are asked after the run: `\"all\"`, "
                          "`\"none\"` or a number, a fair sample. `\"all\"` if only `trajectories_MB` is given.",
               .source = "Talus"},
              {.key = "trajectories_MB",
               .slot = limit_slot(&Output::trajectories_MB),
               .unit = "MB",
               .range = between(0, most_store_MB),
               .title = "Size of the store",
               .topic = topics::trajectories,
               .meaning =
                   "Size of `trajectories.bin`, which has fewer rocks if they do not fit: `\"all\"`, `\"none\"` or "
                   "a number. `\"all\"` if only `trajectories` is given. While the run lasts, it is in memory.",
               .source = "Talus"},
              {.key = "runout_from",
               .slot = runout_point_slot(),
               .unit = "m",
               .range = place,
               .without_it = "from each rock's release",
               .applies_when = {{.any_of = {absent("runout_along")},
                                 .otherwise = Otherwise::refused,
                                 .what = "runout_from and runout_along are given",
                                 .why = "runout is counted in one way",
                                 .hint = "Leave one of them out"}},
               .group = "Runout",
               .topic = topics::runout,
               .meaning = "Point from which runout is counted, as the distance on plan: [x] in 2D, [x, y] in 3D.",
               .source = "Talus"},
              {.key = "runout_along",
               .slot = runout_line_slot(),
               .unit = "m",
               .range = place,
               .without_it = "from each rock's release",
               .applies_when = {in_3d(Otherwise::refused, "runout_along is given", "a section has no lateral direction",
                                      "Give runout_from, or terrain.width_m for 3D")},
               .group = "Runout",
               .topic = topics::runout,
               .meaning = "Line on plan along which runout is counted: two or more points [x, y]. The line goes on "
                          "straight beyond its ends; `endpoints.csv` then has the distance from it.",
               .source = "Talus"},
              {.key = "maps",
               .slot = member(&Output::maps),
               .most_entries = map_subject_names.size(),
               .group = "Maps",
               .topic = topics::maps,
               .meaning = "Writes where rocks pass, how fast, how high and with how much energy: in 3D as maps, "
                          "GeoTIFFs in the folder `maps`; in 2D along the section, in `envelopes.csv`. `true` selects "
                          "everything, a list only what it names; an empty list is `false`.",
               .source = "Talus"},
              {.key = "maps_by_source",
               .slot = member(&Output::maps_by_source),
               .applies_when =
                   {in_3d(Otherwise::warned, {}, "a section has no area to map", "Give terrain.width_m for 3D"),
                    {.any_of = {is_not("maps", {"false", "[]"})}, .why = "maps is false", .hint = "Set maps = true"}},
               .always_accepted = {"false"},
               .group = "Maps",
               .topic = topics::maps,
               .meaning = "Also writes maps of the rocks of each source, in folders of `maps/by_source`.",
               .source = "Talus"},
              {.key = "bands",
               .slot = member(&Output::bands),
               .most_entries = map_subject_names.size(),
               .applies_when =
                   {{.any_of = {given("sampling.parameters")}, .why = "all rocks have the same parameters"},
                    {.any_of = {is_not("maps", {"false", "[]"})}, .why = "maps is false", .hint = "Set maps = true"}},
               .always_accepted = {"false", "[]"},
               .title = "Maps of ranges between ensembles",
               .group = "Maps",
               .topic = topics::maps,
               .meaning = "With `sampling.parameters`: of these maps, also those below and above which 5 % of the "
                          "ensembles are (`…_low`, `…_high`). `true` selects all maps but counts; each takes memory "
                          "for every ensemble.",
               .source = "Talus"},
              {.key = "raster_cell_m",
               .slot = map_cell_slot(),
               .unit = "m",
               .range = {.least = 0.01,
                         .most = largest_coordinate_m,
                         .too_low = "the ground is not known at that scale"},
               .without_it = "`\"terrain\"` for a raster, otherwise 1",
               .title = "Map cell size",
               .group = "Maps",
               .topic = topics::maps,
               .meaning = "Size of the cells of maps and envelopes; their edges are at multiples of it. With "
                          "`\"terrain\"`, the cells are those of the terrain's raster.",
               .source = "Talus"},
              {.key = "percentiles",
               .slot = member(&Output::percentiles),
               .range = between(0, 100),
               .without_it = "`[95]`; along a section `[50, 95, 99]`",
               .most_entries = most_percentiles,
               .group = "Maps",
               .topic = topics::maps,
               .meaning = "Percentiles of energy, velocity and bounce height to map in addition to the maximum, at "
                          "most 20.",
               .source = "Talus"},
              {.key = "means",
               .slot = member(&Output::means),
               .applies_when = {in_3d(Otherwise::warned, {}, "along a section there are means without it",
                                      "Give terrain.width_m for 3D")},
               .always_accepted = {"false"},
               .group = "Maps",
               .topic = topics::maps,
               .meaning = "Also maps the means of energy, velocity and bounce height.",
               .source = "Talus"},
              {.key = "geopackage",
               .slot = limit_slot(&Output::geopackage_limit),
               .range = between(0, most_rocks),
               .applies_when = {in_3d(Otherwise::warned, {}, "a section has no position on a map",
                                      "Give terrain.width_m for 3D")},
               .always_accepted = {"none", "0"},
               .title = "Rocks in the GeoPackage",
               .topic = topics::geopackage,
               .meaning = "3D: number of rocks whose end points and paths are in `results.gpkg`, together with the "
                          "barriers: `\"all\"` or a number; with `\"none\"`, the file is not written.",
               .source = "Talus"},
              {.key = "vtk",
               .slot = member(&Output::vtk),
               .applies_when = {{.any_of = {is_not("paths", {"none", "0"})},
                                 .why = "paths is \"none\"",
                                 .hint = "Set paths to a number of rocks"}},
               .always_accepted = {"false"},
               .title = "Paths for ParaView",
               .topic = topics::vtk,
               .meaning = "Writes `paths.vtp`, the paths for ParaView, of the rocks that `paths` selects.",
               .source = "Talus"},
              {.key = "report",
               .slot = member(&Output::report),
               .meaning = "Writes `report.html`, a page of figures that needs no network.",
               .source = "Talus"},
          },
      .groups = {{""}, {"Runout"}, {"Maps"}},
      .topic = topics::output,
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
