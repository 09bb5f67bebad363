#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/forest_words.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {

Table forest_table() {
  return {
      .key = "forest",
      .repeated = true,
      .meaning =
          "3D: a forest over the ground, drawn on plan or from a file; any number of entries. The ground below "
          "keeps its material, whose own forest it replaces. Where forests overlap, the last one applies.",
      .settings =
          {
              {.key = "name",
               .slot = member(&ForestArea::name),
               .without_it = "`forest N`, numbered from 1",
               .meaning = "Name in messages and in the names of materials in results (`Scree, in forest 1`); must be "
                          "unique.",
               .source = "Talus"},
              {.key = "density",
               .slot = member(&ForestArea::density),
               .without_it = "required without `drag_kg_s`",
               .meaning = "Density of the forest: the drag is 250 kg/s for `open`, 500 kg/s for `medium`, 750 kg/s for "
                          "`dense`; `none` is a clearing.",
               .source = forest_words::density_source},
              {.key = "drag_kg_s",
               .slot = member(&ForestArea::drag_kg_s),
               .unit = "kg/s",
               .range = forest_words::drag_range(),
               .without_it = "given by `density`",
               .meaning = forest_words::drag_meaning,
               .source = forest_words::drag_source},
              {.key = "height_m",
               .slot = member(&ForestArea::height_m),
               .unit = "m",
               .range = forest_words::height_range(),
               .without_it = "required, except for a clearing",
               .meaning = forest_words::height_meaning,
               .source = forest_words::height_source},
              {.key = "polygon",
               .slot = [](const Row& row) -> Slot { return PlanPolygonSlot{&row.as<ForestArea>().polygon}; },
               .unit = "m",
               .without_it = "given by `polygons`",
               .meaning = "Three or more corners [x, y] on plan, in terrain coordinates. A cell or triangle of the "
                          "terrain belongs to the forest if its centre does.",
               .source = "Talus"},
              {.key = "polygons",
               .slot = member(&ForestArea::polygons),
               .without_it = "given by `polygon`",
               .meaning = "A file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate system. The "
                          "path is relative to the project file.",
               .source = "Talus"},
              {.key = "layer",
               .slot = member(&ForestArea::layer),
               .without_it = "the file's only layer",
               .applies_when = {together_with({given("polygons")})},
               .meaning = "Layer of the file of polygons.",
               .source = "Talus"},
              {.key = "attribute",
               .slot = member(&ForestArea::attribute),
               .without_it = "all polygons of the file are this forest",
               .applies_when = {together_with({given("polygons")}), together_with({given("values")})},
               .meaning = "Attribute of the polygons that tells which of them are this forest.",
               .source = "Talus"},
              {.key = "values",
               .slot = member(&ForestArea::values),
               .without_it = "all polygons of the file are this forest",
               .applies_when = {together_with({given("attribute")})},
               .meaning = "Values of that attribute, for example `[\"spruce\", \"mixed\"]`.",
               .source = "Talus"},
          },
      .choices = {{{"polygon"}, {"polygons"}}, {{"density"}, {"drag_kg_s"}}},
      .topic = topics::forest,
      .add = [](Project& project) { return added(project.forests); },
      .rows = [](Project& project) { return all(project.forests); },
  };
}

}  // namespace talus::project::declared
