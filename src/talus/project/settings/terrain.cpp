#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"

namespace talus::project::declared {
namespace {

constexpr std::string_view one_terrain =
    "one of section, mesh, triangles, raster, points, lines, polylines and polygons is required";

}  // namespace

Table terrain_table() {
  auto [add, rows] = one_row(&Project::terrain);
  return {
      .key = "terrain",
      .required = true,
      .meaning =
          "The slope: exactly one of `section`, `mesh`, `triangles`, `raster`, a survey (`points`, `lines` or both), "
          "`polylines` and `polygons`. z points up.",
      .settings =
          {
              {.key = "section",
               .slot = member(&Terrain::section),
               .unit = "m",
               .without_it = one_terrain,
               .excludes = {"mesh", "vertices", "triangles", "raster", "points", "lines", "polylines", "polygons"},
               .meaning = "Vertices [x, z] of a slope in section, along the slope: two or more.",
               .source = "Talus"},
              {.key = "section_std_dev_m",
               .slot = member(&Terrain::section_std_dev_m),
               .unit = "m",
               .range = up_to(largest_coordinate_m),
               .without_it = "the vertices are certain",
               .excludes = {"width_m"},
               .meaning = "2D: standard deviations [of x, of z] of the vertices, one pair for each vertex; every rock "
                          "falls down its own slope. "
                          "Vertices move by up to 3 of them, and keep their order in x.",
               .source = "RocFall2"},
              {.key = "width_m",
               .slot = member(&Terrain::width_m),
               .unit = "m",
               .range = above_0_up_to(largest_coordinate_m),
               .without_it = "the analysis is 2D",
               .excludes = {"section_std_dev_m"},
               .meaning = "Extrudes the section along y, from y = 0 to this width, to a 3D terrain.",
               .source = "Talus"},
              {.key = "mesh",
               .slot = member(&Terrain::mesh),
               .without_it = one_terrain,
               .excludes = {"section", "vertices", "triangles", "raster", "points", "lines", "polylines", "polygons"},
               .meaning = "A file of triangles in metres (.obj, .stl or .ply); its path is relative to the project "
                          "file.",
               .source = "Talus"},
              {.key = "vertices",
               .slot = member(&Terrain::vertices),
               .unit = "m",
               .without_it = "required beside triangles",
               .excludes = {"section", "mesh", "raster", "points", "lines", "polylines", "polygons"},
               .meaning = "Vertices [x, y, z] of an inline mesh.",
               .source = "Talus"},
              {.key = "triangles",
               .slot = member(&Terrain::triangles),
               .range = at_least(0),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "raster", "points", "lines", "polylines", "polygons"},
               .meaning = "Triangles of an inline mesh: the numbers of three vertices each, counted from 0, in either "
                          "winding.",
               .source = "Talus"},
              {.key = "raster",
               .slot = member(&Terrain::raster),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "points", "lines", "polylines", "polygons"},
               .meaning =
                   "A file of elevations in metres, on a grid in a projected coordinate system in metres: band 1 "
                   "of a GeoTIFF, an Esri grid (.asc, .flt, .bil), an Erdas Imagine or a VRT; its path is relative to "
                   "the project file.",
               .source = "Talus"},
              {.key = "points",
               .slot = member(&Terrain::points),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "raster", "polylines", "polygons"},
               .meaning = "A file of surveyed points in metres, which are triangulated: text (.csv, .xyz, .txt, .pts, "
                          ".dat), .las, or points of a GeoPackage, Shapefile, GeoJSON or DXF; alone or with `lines`; "
                          "its path is relative to the project file.",
               .source = "Talus"},
              {.key = "point_classes",
               .slot = member(&Terrain::point_classes),
               .range = between(0, 255),
               .without_it = "all but noise (7 and 18)",
               .meaning = "LAS: of which classes points are taken; 2 is the ground.",
               .source = "ASPRS LAS 1.4"},
              {.key = "points_layer",
               .slot = member(&Terrain::points_layer),
               .without_it = "the only layer",
               .meaning = "Which layer of a vector file `points` are in.",
               .source = "Talus"},
              {.key = "lines",
               .slot = member(&Terrain::lines),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "raster", "polylines", "polygons"},
               .meaning = "A vector file (GeoPackage, Shapefile, DXF, ...) of contours or breaklines with heights: "
                          "their vertices are points and no triangle crosses them; alone or with `points`; its path is "
                          "relative to the project file.",
               .source = "Talus"},
              {.key = "lines_layer",
               .slot = member(&Terrain::lines_layer),
               .without_it = "the only layer",
               .meaning = "Which layer `lines` are in.",
               .source = "Talus"},
              {.key = "elevation_attribute",
               .slot = member(&Terrain::elevation_attribute),
               .without_it = "the geometry's own z",
               .meaning = "Attribute of lines, or of points in a vector file, that holds the height of all their "
                          "vertices in metres, as that of contours mostly is.",
               .source = "Talus"},
              {.key = "boundary",
               .slot = member(&Terrain::boundary),
               .without_it = "the convex hull of the survey",
               .meaning =
                   "A vector file of polygons: triangles whose middle lies beyond them are left out; its path is "
                   "relative to the project file.",
               .source = "Talus"},
              {.key = "boundary_layer",
               .slot = member(&Terrain::boundary_layer),
               .without_it = "the only layer",
               .meaning = "Which layer `boundary` is in.",
               .source = "Talus"},
              {.key = "max_edge_m",
               .slot = member(&Terrain::max_edge_m),
               .unit = "m",
               .range = above_0_up_to(largest_coordinate_m),
               .without_it = "no limit",
               .meaning = "Triangles of a survey with a longer side at the rim are left out, from the rim inwards.",
               .source = "after Duckham et al. 2008"},
              {.key = "remove_spikes_m",
               .slot = member(&Terrain::remove_spikes_m),
               .unit = "m",
               .range = above_0_up_to(largest_coordinate_m),
               .without_it = "all points stay",
               .meaning = "Points of a survey further than this above or below the plane of their neighbours are left "
                          "out.",
               .source = "Talus"},
              {.key = "polylines",
               .slot = member(&Terrain::polylines),
               .unit = "m",
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "raster", "points", "lines", "polygons"},
               .meaning = "Closed polylines [[x, y, z], ...], each made a polygon and cut into triangles; the last "
                          "vertex repeats the first.",
               .source = "the manual, section 2"},
              {.key = "polygons",
               .slot = member(&Terrain::polygons),
               .without_it = one_terrain,
               .excludes = {"section", "mesh", "vertices", "triangles", "raster", "points", "lines", "polylines"},
               .meaning =
                   "The same from a vector file (DXF, GeoPackage, ...): closed lines or polygons with heights; its "
                   "path is relative to the project file.",
               .source = "the manual, section 2"},
              {.key = "polygons_layer",
               .slot = member(&Terrain::polygons_layer),
               .without_it = "the only layer",
               .meaning = "Which layer `polygons` are in.",
               .source = "Talus"},
              {.key = "merge_tolerance_m",
               .slot = member(&Terrain::merge_tolerance_m),
               .unit = "m",
               .range = up_to(largest_coordinate_m),
               .meaning =
                   "Vertices of `polylines` or `polygons` as near as this become one, and sides lead through vertices "
                   "as near as this, which makes one surface of them.",
               .source = "the manual, section 2"},
              {.key = "crs",
               .slot = member(&Terrain::crs),
               .without_it = "that of the files",
               .meaning = "Coordinate system of a mesh, a raster or a survey whose files name none, for example "
                          "\"EPSG:31287\"; vector files in others are brought to it; \"local\" says that coordinates "
                          "are metres of no map.",
               .source = "Talus"},
              {.key = "rotate_deg",
               .slot = member(&Terrain::rotate_deg),
               .unit = "deg",
               .range = between(-360, 360),
               .meaning = "3D: turns the terrain about the vertical, counter-clockwise seen from above; seeders and "
                          "barriers stay.",
               .source = "the manual, section 5"},
              {.key = "rotate_about",
               .slot = member(&Terrain::rotate_about),
               .unit = "m",
               .range = place,
               .meaning = "A point [x, y, z] on the vertical axis of that turn.",
               .source = "the manual, section 5"},
          },
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
