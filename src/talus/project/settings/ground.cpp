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

Need not_on_a_survey(std::string_view key) {
  return {.any_of = {absent(key)},
          .otherwise = Otherwise::refused,
          .what = "is given for a survey",
          .why = "Talus generates its triangles",
          .hint = "Use raster and classes, or polygons"};
}

}  // namespace

Table ground_table() {
  auto [add, rows] = one_row(&Project::ground);
  return {
      .key = "ground",
      .meaning = "The material of each part of the terrain.",
      .settings =
          {
              {.key = "default",
               .slot = member(&Ground::default_material),
               .without_it = "the only material",
               .meaning = "Name of the material where nothing else is given; required if there are several materials "
                          "and none of `segments`, `triangles`, `raster` and `polygons`.",
               .source = "Talus"},
              {.key = "segments",
               .slot = member(&Ground::segments),
               .without_it = "the default everywhere",
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
               .meaning = "Section: material names, one for each segment, in the order of the vertices.",
               .source = "Talus"},
              {.key = "triangles",
               .slot = member(&Ground::triangles),
               .range = at_least(0),
               .without_it = "the default everywhere",
               .applies_when = {not_on_a_section(),
                                {.any_of = {absent("terrain.raster")},
                                 .otherwise = Otherwise::refused,
                                 .what = "is given for a raster",
                                 .why = "a raster has cells",
                                 .hint = "Use raster and classes"},
                                not_on_a_survey("terrain.points"),
                                not_on_a_survey("terrain.lines")},
               .meaning =
                   "Mesh: material numbers, one for each triangle; the materials of the file are numbered from 0.",
               .source = "Talus"},
              {.key = "raster",
               .slot = member(&Ground::raster),
               .without_it = "the default everywhere",
               .applies_when = {not_on_a_section()},
               .meaning =
                   "Raster and mesh: a file of classes, in any coordinate system and with cells of any size. A cell or "
                   "triangle of the terrain has the class at its centre. The path is relative to the project file.",
               .source = "Talus"},
              {.key = "classes",
               .slot = member(&Ground::classes),
               .without_it = "required with `raster`",
               .applies_when = {together_with({given("raster")}, "is given without a raster")},
               .meaning = "Material of each class of the raster, for example `{ 1 = \"Rock\", 2 = \"Scree\" }`; where "
                          "there is no class, the default applies.",
               .source = "Talus"},
              {.key = "polygons",
               .slot = member(&Ground::polygons),
               .without_it = "the default everywhere",
               .applies_when = {not_on_a_section()},
               .meaning = "Raster and mesh: a file of polygons (GeoPackage, Shapefile, GeoJSON, ...), in any "
                          "coordinate system. A cell or triangle of the terrain takes its material from the polygon at "
                          "its centre, the last one if there are several. The path is relative to the project file.",
               .source = "Talus"},
              {.key = "layer",
               .slot = member(&Ground::layer),
               .without_it = "the file's only layer",
               .applies_when = {together_with({given("polygons")})},
               .meaning = "Layer of the file of polygons.",
               .source = "Talus"},
              {.key = "attribute",
               .slot = member(&Ground::attribute),
               .without_it = "required with `polygons`",
               .applies_when = {together_with({given("polygons")})},
               .meaning = "Attribute of the polygons that gives their material.",
               .source = "Talus"},
              {.key = "values",
               .slot = member(&Ground::values),
               .without_it = "the attribute is the name of the material",
               .applies_when = {together_with({given("polygons")})},
               .meaning = "Material for each value of that attribute, for example `{ Fels = \"Rock\", Schutt = "
                          "\"Scree\" }`; where there is no polygon, the default applies.",
               .source = "Talus"},
          },
      .choices = {{{"segments"}, {"triangles"}, {"raster"}, {"polygons"}}},
      .topic = topics::ground,
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
