#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {
namespace {

Need not_on_a_section() {
  return {.any_of = {absent("terrain.section")},
          .otherwise = Otherwise::refused,
          .what = "is given for a section",
          .why = "a section has segments",
          .hint = "Use segments, with one name for each segment"};
}

}  // namespace

Table ground_table() {
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
               .applies_when = {{.any_of = {absent("terrain.raster"), given("terrain.section")},
                                 .otherwise = Otherwise::refused,
                                 .what = "is given without a section",
                                 .why = "a raster has cells",
                                 .hint = "Use raster and classes"},
                                {.any_of = {given("terrain.section")},
                                 .otherwise = Otherwise::refused,
                                 .what = "is given without a section",
                                 .why = "a mesh has triangles",
                                 .hint = "Use triangles, with one number for each triangle"}},
               .meaning = "Section: names of materials, one for each segment, in the order of the vertices.",
               .source = "Talus"},
              {.key = "triangles",
               .slot = member(&Ground::triangles),
               .range = at_least(0),
               .without_it = "default everywhere",
               .applies_when = {not_on_a_section(),
                                {.any_of = {absent("terrain.raster")},
                                 .otherwise = Otherwise::refused,
                                 .what = "is given for a raster",
                                 .why = "a raster has cells",
                                 .hint = "Use raster and classes"},
                                {.any_of = {absent("terrain.points")},
                                 .otherwise = Otherwise::refused,
                                 .what = "is given for a survey",
                                 .why = "its triangles are made by Talus",
                                 .hint = "Use raster and classes, or polygons"},
                                {.any_of = {absent("terrain.lines")},
                                 .otherwise = Otherwise::refused,
                                 .what = "is given for a survey",
                                 .why = "its triangles are made by Talus",
                                 .hint = "Use raster and classes, or polygons"}},
               .meaning = "Mesh: numbers of materials, counted from 0 in the order of the file, one for each triangle.",
               .source = "Talus"},
              {.key = "raster",
               .slot = member(&Ground::raster),
               .without_it = "default everywhere",
               .applies_when = {not_on_a_section()},
               .meaning =
                   "Raster and mesh: a file of classes, in any coordinate system and with cells of any size; the "
                   "class at the middle of a cell or triangle of the terrain is that of its ground. Its path is "
                   "relative to the project file.",
               .source = "Talus"},
              {.key = "classes",
               .slot = member(&Ground::classes),
               .without_it = "required beside raster",
               .applies_when = {beside({given("raster")}, "is given without a raster")},
               .meaning = "Which class of the raster is which material, for example `{ 1 = \"Rock\", 2 = \"Scree\" }`; "
                          "where there is no class, the default holds.",
               .source = "Talus"},
              {.key = "polygons",
               .slot = member(&Ground::polygons),
               .without_it = "default everywhere",
               .applies_when = {not_on_a_section()},
               .meaning =
                   "Raster and mesh: a file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any coordinate "
                   "system; the polygon at the middle of a cell or triangle of the terrain says its ground, the "
                   "later one where there are several. Its path is relative to the project file.",
               .source = "Talus"},
              {.key = "layer",
               .slot = member(&Ground::layer),
               .without_it = "the file's only layer",
               .applies_when = {beside({given("polygons")})},
               .meaning = "Which layer of the file of polygons.",
               .source = "Talus"},
              {.key = "attribute",
               .slot = member(&Ground::attribute),
               .without_it = "required beside polygons",
               .applies_when = {beside({given("polygons")})},
               .meaning = "Which attribute of the polygons says their material.",
               .source = "Talus"},
              {.key = "values",
               .slot = member(&Ground::values),
               .without_it = "the attribute is the name of the material",
               .applies_when = {beside({given("polygons")})},
               .meaning = "Which value of that attribute is which material, for example `{ Fels = \"Rock\", Schutt = "
                          "\"Scree\" }`; where there is no polygon, the default holds.",
               .source = "Talus"},
          },
      .choices = {{{"segments"}, {"triangles"}, {"raster"}, {"polygons"}}},
      .topic = topics::ground,
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
