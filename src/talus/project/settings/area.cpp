#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {

Table area_table() {
  return {
      .key = "area",
      .repeated = true,
      .meaning =
          "3D: a part of the ground, drawn on plan, with another material than `[ground]` gives it; any number of "
          "entries. Where areas overlap, the last one applies.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Area::name),
               .without_it = "`area N`, numbered from 1",
               .meaning = "Name in messages; must be unique.",
               .source = "Talus"},
              {.key = "material",
               .slot = member(&Area::material),
               .required = true,
               .meaning = "Name of its material.",
               .source = "Talus"},
              {.key = "polygon",
               .slot = [](const Row& row) -> Slot { return PlanPolygonSlot{&row.as<Area>().polygon}; },
               .unit = "m",
               .required = true,
               .meaning = "Three or more corners [x, y] on plan, in terrain coordinates. A cell or triangle of the "
                          "terrain belongs to the area if its centre does.",
               .source = "Talus"},
          },
      .topic = topics::areas,
      .add = [](Project& project) { return added(project.areas); },
      .rows = [](Project& project) { return all(project.areas); },
  };
}

}  // namespace talus::project::declared
