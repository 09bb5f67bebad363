// Errors in the terrain, the materials and the ground: the exact text of each.

#include <gtest/gtest.h>

#include <vector>

#include "project/bad_project.hpp"

namespace talus::project {
namespace {

class BadTerrain : public BadProjectTest {};

TEST_P(BadTerrain, AreRefusedWithThisText) {
  EXPECT_EQ(refusal_of_reading(changed(GetParam().replacements)), GetParam().message);
}

const std::vector<BadProject> bad_terrain{
    {"TerrainMissing",
     {{R"([terrain]
section = [[0, 0], [10, -10], [20, -10]]
)",
       ""}},
     "slope.toml: [terrain] is missing (a project needs it)"},
    {"TerrainEmpty",
     {{section, ""}},
     "slope.toml:6: [terrain]: there is no terrain (expected one of section, mesh, triangles, raster, points, lines, "
     "polylines and polygons)"},
    {"SectionAndMesh",
     {{section,
       R"(section = [[0, 0], [10, -10], [20, -10]]
mesh = "bowl.obj")"}},
     "slope.toml:8: [terrain]: section and mesh are given together (they exclude each other)"},
    {"SectionEmpty",
     {{section, "section = []"},
      {R"([ground]
segments = ["Rock", "Talus"]
)",
       R"([ground]
default = "Rock"
)"}},
     "slope.toml:7: [terrain]: section has 0 vertices (a slope has two or more)"},
    {"SectionOfOneVertex",
     {{section, "section = [[0, 0]]"},
      {R"([ground]
segments = ["Rock", "Talus"]
)",
       R"([ground]
default = "Rock"
)"}},
     "slope.toml:7: [terrain]: section has 1 vertex (a slope has two or more)"},
    {"SectionRepeatsAVertex",
     {{"[20, -10]]", "[10, -10]]"}},
     "slope.toml:7: [terrain]: section[2] is [10, -10] (it repeats the previous vertex). Leave it out"},
    {"SectionVertexOfThree",
     {{"[20, -10]]", "[20, 0, -10]]"}},
     "slope.toml:7: [terrain]: section[2] is [20, 0, -10] (expected a pair [x, z])"},
    {"SectionVertexNotANumber",
     {{"[20, -10]]", "[20, nan]]"}},
     "slope.toml:7: [terrain]: section[2][1] is nan (expected a finite number)"},
    {"SectionIsNotAList",
     {{section, "section = 5"}},
     "slope.toml:7: [terrain]: section is 5 (expected a list of vertices [x, z], or "
     "a file name in quotes)"},
    {"NegativeWidth",
     {{section,
       R"(section = [[0, 0], [10, -10], [20, -10]]
width_m = -50)"}},
     "slope.toml:8: [terrain]: width_m is -50 (expected more than 0, up to 1e9)\n"
     "slope.toml:24: seeder \"Crest\": position is [1, 5] (expected [x, y, z] in a 3D analysis). For a height above "
     "the terrain, leave out z and give height_above_m\n"
     "slope.toml:30: barrier \"Fence\": line is 15 (expected two or more points on plan, [[x, y], [x, y]])"},
    {"WidthWithoutSection",
     in_3d({{section,
             R"(mesh = "bowl.obj"
width_m = 50)"},
            {segments, R"(default = "Rock")"}}),
     "slope.toml:8: [terrain]: width_m is given without a section (it would have no effect)"},
    {"DeviationsOfTooFewVertices",
     {{section,
       R"(section = [[0, 0], [10, -10], [20, -10]]
section_std_dev_m = [[0.1, 0.1]])"}},
     "slope.toml:8: [terrain]: section_std_dev_m has 1 entry (expected one for each of the 3 vertices of the section)"},
    {"DeviationsThatSwapVertices",
     {{section,
       R"(section = [[0, 0], [10, -10], [20, -10]]
section_std_dev_m = [[0, 0.1], [2, 0], [2, 0]])"}},
     "slope.toml:8: [terrain]: section_std_dev_m lets section[1] and section[2] swap places (vertices move by up to 3 "
     "standard deviations: the left one to x = 16, the right one to x = 14). Reduce their standard deviations in x, or "
     "leave out one of the vertices"},
    {"DeviationsThatSwapVerticesFromRightToLeft",
     {{section,
       R"(section = [[20, -10], [10, -10], [0, 0]]
section_std_dev_m = [[2, 0], [2, 0], [0, 0.1]])"}},
     "slope.toml:8: [terrain]: section_std_dev_m lets section[0] and section[1] swap places (vertices move by up to 3 "
     "standard deviations: the left one to x = 16, the right one to x = 14). Reduce their standard deviations in x, or "
     "leave out one of the vertices"},
    {"DeviationsIn3D",
     in_3d({{section,
             R"(section = [[0, 0], [10, -10], [20, -10]]
section_std_dev_m = [[0.1, 0.1], [0, 0], [0, 0]]
width_m = 50)"}}),
     "slope.toml:9: [terrain]: section_std_dev_m and width_m are given together (they exclude each other)"},
    {"RotatedIn2D",
     {{section,
       R"(section = [[0, 0], [10, -10], [20, -10]]
rotate_deg = 30)"}},
     "slope.toml:8: [terrain]: rotate_deg is given in 2D (a section cannot be rotated). Give width_m for 3D"},
    {"UnknownMeshFormat", in_3d({{section, R"(mesh = "bowl.dwg")"}, {segments, R"(default = "Rock")"}}),
     "slope.toml:7: [terrain]: mesh is \"bowl.dwg\" (expected a file that ends in .obj, .stl or .ply)"},
    {"TerrainRasterAndMesh",
     in_3d({{section, R"(raster = "dem.tif"
mesh = "bowl.obj")"},
            {segments, R"(default = "Rock")"}}),
     "slope.toml:7: [terrain]: mesh and raster are given together (they exclude each other)"},
    {"RotatedRaster",
     in_3d({{section, R"(raster = "dem.tif"
rotate_deg = 30)"},
            {segments, R"(default = "Rock")"}}),
     "slope.toml:8: [terrain]: rotate_deg is given with a raster (a raster has a fixed position, with rows from west "
     "to east). Leave it out"},
    {"SegmentsOnARaster", in_3d({{section, R"(raster = "dem.tif")"}, {segments, segments}}),
     "slope.toml:19: [ground]: segments is given without a section (a raster has cells). Use raster and classes"},
    {"TrianglesOnARaster", in_3d({{section, R"(raster = "dem.tif")"}, {segments, R"(triangles = [0, 1])"}}),
     "slope.toml:19: [ground]: triangles is given for a raster (a raster has cells). Use raster and classes"},
    {"GroundRasterWithoutClasses", in_3d({{section, R"(raster = "dem.tif")"}, {segments, R"(raster = "ground.tif")"}}),
     "slope.toml:19: [ground]: classes is missing (the materials of its classes are not given). Write classes = { 1 = "
     "\"Rock\" }, with one entry for each class"},
    {"ClassesWithoutARaster", in_3d({{section, R"(raster = "dem.tif")"}, {segments, R"(default = "Rock"
classes = { 1 = "Rock" })"}}),
     "slope.toml:20: [ground]: classes is given without a raster (it would have no effect)"},
    {"ClassOfAnUnknownMaterial", in_3d({{section, R"(raster = "dem.tif")"}, {segments, R"(raster = "ground.tif"
classes = { 1 = "Rock", 2 = "Talos" })"}}),
     "slope.toml:20: [ground]: classes.2 is \"Talos\" (no material has this name; the project has \"Rock\", "
     "\"Talus\"). Did you mean \"Talus\"?"},
    {"ClassThatIsNotANumber", in_3d({{section, R"(raster = "dem.tif")"}, {segments, R"(raster = "ground.tif"
classes = { rock = "Rock", 99999999999 = "Rock" })"}}),
     "slope.toml:20: [ground]: classes has the key \"99999999999\" (a class is a whole number of at most 32 "
     "bits)\nslope.toml:20: [ground]: classes has the key \"rock\" (a class is a whole number of at most 32 bits)"},
    {"ClassNamedTwice", in_3d({{section, R"(raster = "dem.tif")"}, {segments, R"(raster = "ground.tif"
classes = { 1 = "Rock", 01 = "Talus" })"}}),
     "slope.toml:20: [ground]: classes.1 repeats class 1 (a class has one material)"},
    {"ClassesOfTheWrongKind", in_3d({{section, R"(raster = "dem.tif")"}, {segments, R"(raster = "ground.tif"
classes = ["Rock", "Talus"])"}}),
     "slope.toml:20: [ground]: classes is [\"Rock\", \"Talus\"] (expected { 1 = \"...\", 2 = \"...\" } with one entry "
     "or more)"},
    {"GroundRasterForASection",
     {{segments, R"(raster = "ground.tif"
classes = { 1 = "Rock" })"}},
     "slope.toml:19: [ground]: raster is given for a section (a section has segments). Use segments, with one name for "
     "each segment"},
    {"TriangleIndexOutOfRange",
     in_3d({{section,
             R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 3]])"},
            {segments, R"(default = "Rock")"}}),
     "slope.toml:8: [terrain]: triangles[0] is [0, 1, 3] (there are 3 vertices; expected 0 to 2). Vertices are "
     "numbered from 0"},
    {"TriangleOfTwoVertices",
     in_3d({{section,
             R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 1]])"},
            {segments, R"(default = "Rock")"}}),
     "slope.toml:8: [terrain]: triangles[0] is [0, 1, 1] (a triangle has three different vertices)"},
    {"NegativeVertexNumber",
     in_3d({{section,
             R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, -1]])"},
            {segments, R"(default = "Rock")"}}),
     "slope.toml:8: [terrain]: triangles[0][2] is -1 (expected 0 or more)"},
    {"InfiniteVertex",
     in_3d({{section,
             R"(vertices = [[0, 0, 0], [10, 0, inf], [0, 10, 0]]
triangles = [[0, 1, 2]])"},
            {segments, R"(default = "Rock")"}}),
     "slope.toml:7: [terrain]: vertices[1][2] is inf (expected a finite number)"},
    {"VerticesWithoutTriangles",
     in_3d({{section, "vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]"}, {segments, R"(default = "Rock")"}}),
     "slope.toml:6: [terrain]: triangles is missing (an inline mesh needs vertices and triangles)"},
    {"MaterialMissing",
     {{R"([[material]]
name = "Rock"
normal_restitution = 0.4
friction_angle_deg = 30

[[material]]
name = "Talus"
normal_restitution = 0.3
)",
       ""}},
     "slope.toml: [[material]] is missing (a project needs at least one)"},
    {"MaterialWithoutName",
     {{R"(name = "Rock"
)",
       ""}},
     "slope.toml:9: material 1: name is missing"},
    {"MaterialTwice",
     {{R"(name = "Talus")", R"(name = "Rock")"}, {segments, R"(segments = ["Rock", "Rock"])"}},
     "slope.toml:15: two materials are named \"Rock\" (the first begins in line 9). Give each its own name"},
    {"MaterialUnknown",
     {{segments, R"(segments = ["Rock", "Tallus"])"}},
     "slope.toml:19: [ground]: segments[1] is \"Tallus\" (no material has this name; the project has \"Rock\", "
     "\"Talus\"). Did you mean \"Talus\"?"},
    {"DefaultMaterialUnknown",
     {{segments, R"(default = "Grass")"}},
     "slope.toml:19: [ground]: default is \"Grass\" (no material has this name; the project has \"Rock\", \"Talus\")"},
    {"DefaultMaterialMissing",
     {{R"([ground]
segments = ["Rock", "Talus"]
)",
       ""}},
     "slope.toml: [ground]: default is missing (there are 2 materials). Write default = \"Rock\", or segments with one "
     "name for each segment"},
    {"SegmentMissing",
     {{segments, R"(segments = ["Rock"])"}},
     "slope.toml:19: [ground]: segments has 1 entry (expected 2: the section has 3 vertices)"},
    {"SegmentsOfAMesh",
     in_3d({{section,
             R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 2]])"}}),
     "slope.toml:20: [ground]: segments is given without a section (a mesh has triangles). Use triangles, with one "
     "number for each triangle"},
    {"GroundTrianglesOfASection",
     {{segments, "triangles = [0, 1]"}},
     "slope.toml:19: [ground]: triangles is given for a section (a section has segments). Use segments, with one name "
     "for each segment"},
    {"GroundTrianglesTooMany",
     in_3d({{section,
             R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 2]])"},
            {segments, "triangles = [0, 1]"}}),
     "slope.toml:20: [ground]: triangles has 2 entries (expected 1, one for each triangle of the terrain)"},
    {"GroundTriangleWithoutMaterial",
     in_3d({{section,
             R"(vertices = [[0, 0, 0], [10, 0, -5], [0, 10, 0]]
triangles = [[0, 1, 2]])"},
            {segments, "triangles = [2]"}}),
     "slope.toml:20: [ground]: triangles[0] is 2 (there are 2 materials, numbered from 0; expected 0 to 1)"},
    {"GroundFromPolygons",
     {{segments,
       R"(default = "Rock"
polygons = "ground.gpkg"
attribute = "material")"}},
     "slope.toml:20: [ground]: polygons is given for a section (a section has segments). Use segments, with one name "
     "for each segment"},
};

INSTANTIATE_TEST_SUITE_P(All, BadTerrain, testing::ValuesIn(bad_terrain), name_of_case<BadProject>);

}  // namespace
}  // namespace talus::project
