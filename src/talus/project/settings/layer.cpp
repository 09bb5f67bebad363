#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {

Table layer_table() {
  return {
      .key = "layer",
      .repeated = true,
      .meaning =
          "3D: a raster or vector file that the workbench draws over the terrain, for reference; any number of "
          "entries, of which later ones are drawn over earlier ones. Layers change no result, and a run does "
          "not read them: it can be resumed after a change.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Layer::name),
               .without_it = "the file's name, without its ending",
               .meaning = "Name in the workbench and in messages; must be unique.",
               .source = "Talus"},
              {.key = "file",
               .slot = member(&Layer::file),
               .required = true,
               .applies_when = {in_3d(Otherwise::warned, "has no effect in 2D", "a section has no position on a map")},
               .meaning =
                   "An orthophoto or another raster (GeoTIFF, PNG or JPEG with a world file, VRT, ...), or lines, "
                   "polygons or points (GeoPackage, Shapefile, GeoJSON, DXF), in any coordinate system. The path "
                   "is relative to the project file.",
               .source = "Talus"},
              {.key = "layer",
               .slot = member(&Layer::layer),
               .without_it = "the only one",
               .meaning = "Layer of a vector file with several; of a DXF the name of a CAD layer.",
               .source = "Talus"},
              {.key = "name_attribute",
               .slot = member(&Layer::name_attribute),
               .without_it = "`name`, if there is one",
               .meaning = "Attribute that gives the names of the features of a vector file.",
               .source = "Talus"},
              {.key = "colour",
               .slot = member(&Layer::colour),
               .meaning = "Colour of the lines and points of a vector file, as `#rrggbb`.",
               .source = "Talus"},
              {.key = "opacity",
               .slot = member(&Layer::opacity),
               .range = between(0, 1),
               .meaning = "From 0, which is invisible, to 1, which hides what is below.",
               .source = "Talus"},
              {.key = "visible",
               .slot = member(&Layer::visible),
               .meaning = "Whether it is drawn until it is switched on or off in the workbench.",
               .source = "Talus"},
          },
      .topic = topics::layers,
      .add = [](Project& project) { return added(project.layers); },
      .rows = [](Project& project) { return all(project.layers); },
  };
}

}  // namespace talus::project::declared
