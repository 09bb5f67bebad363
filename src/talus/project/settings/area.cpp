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
      .topic = topics::areas,
      .add = [](Project& project) { return added(project.areas); },
      .rows = [](Project& project) { return all(project.areas); },
  };
}

}  // namespace talus::project::declared
