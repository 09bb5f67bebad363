// Errors in seeders, barriers and collectors: the exact text of each.

#include <gtest/gtest.h>

#include <vector>

#include "project/bad_project.hpp"

namespace talus::project {
namespace {

class BadPlaces : public BadProjectTest {};

TEST_P(BadPlaces, AreRefusedWithThisText) {
  EXPECT_EQ(refusal_of_reading(changed(GetParam().replacements)), GetParam().message);
}

const std::vector<BadProject> bad_places{
    {"PositionTooHigh",
     {{"position = [1, 5]", "position = [1, 5e99]"}},
     "slope.toml:23: seeder \"Crest\": position[1] is 5e+99 (coordinates are in metres; expected -1e9 to 1e9)"},
    {"DirectionTooShort",
     {{"mass_kg = 1000", "mass_kg = 1000\ndirection = [1e-200, 0]"}},
     "slope.toml:26: seeder \"Crest\": direction is [1e-200, 0] (expected a direction whose length is not 0)"},
    {"BarrierTooFarAway",
     {{"line = 15", "line = 15e200"}},
     "slope.toml:29: barrier \"Fence\": line is 1.5e+201 (coordinates lie within 1e+09 m)"},
    {"SeederMissing",
     {{R"([[seeder]]
name = "Crest"
position = [1, 5]
rocks = 10
mass_kg = 1000
)",
       ""}},
     "slope.toml: [[seeder]] is missing (a project needs at least one)"},
    {"SeederFromPolygon",
     {{"position = [1, 5]",
       R"(type = "polygon"
position = [1, 5])"}},
     "slope.toml:23: seeder \"Crest\": type is \"polygon\" in 2D (a section has no area). Use a point or a line, or "
     "give terrain.width_m for 3D"},
    {"SeederWithoutPosition",
     {{R"(position = [1, 5]
)",
       ""}},
     "slope.toml:21: seeder \"Crest\": position is missing (a point seeder needs it)"},
    {"PointsForAPoint",
     {{"position = [1, 5]", "points = [[1, 5], [2, 5]]"}},
     "slope.toml:23: seeder \"Crest\": points are given for a point (they belong to a line). Write type = \"line\""},
    {"PositionForALine",
     {{"position = [1, 5]",
       R"(type = "line"
position = [1, 5])"}},
     "slope.toml:24: seeder \"Crest\": position is given for a line (a line seeder needs two or more points). Write "
     "points = [..., ...]"},
    {"LineWithOnePoint",
     {{"position = [1, 5]",
       R"(type = "line"
points = [[1, 5]])"}},
     "slope.toml:24: seeder \"Crest\": points is [[1, 5]] (expected a list of two or more positions)"},
    {"LineRepeatsAPoint",
     {{"position = [1, 5]",
       R"(type = "line"
points = [[1, 5], [1, 5]])"}},
     "slope.toml:24: seeder \"Crest\": points[1] is [1, 5] (it repeats the previous point). Leave it out"},
    {"LineHalfOnTheSurface",
     {{"position = [1, 5]",
       R"(type = "line"
points = [[1, 5], [2, "surface"]])"}},
     "slope.toml:24: seeder \"Crest\": points[1] is [2, \"surface\"] (z is either \"surface\" for all points of a line "
     "or a number for all)"},
    {"PositionOfThreeIn2D",
     {{"position = [1, 5]", "position = [1, 0, 5]"}},
     "slope.toml:23: seeder \"Crest\": position is [1, 0, 5] (expected [x, z] in a 2D analysis). Leave out y, or give "
     "terrain.width_m for 3D"},
    {"PositionWithoutZ",
     {{"position = [1, 5]", "position = [1]"}},
     "slope.toml:23: seeder \"Crest\": position is [1] (expected [x, z] in a 2D analysis). For a height above the "
     "terrain, leave out z and give height_above_m"},
    {"PositionUnknownWord",
     {{"position = [1, 5]", R"(position = [1, "ground"])"}},
     "slope.toml:23: seeder \"Crest\": position[1] is \"ground\" (expected a number or \"surface\")"},
    {"PositionWithZAndHeight",
     {{"position = [1, 5]",
       R"(position = [1, 5]
height_above_m = 2)"}},
     "slope.toml:23: seeder \"Crest\": position has z, and height_above_m is given (both give the height). Leave one "
     "of them out"},
    {"ReleaseBelowTheGround",
     {{"position = [1, 5]",
       R"(position = [1]
height_above_m = -2)"}},
     "slope.toml:24: seeder \"Crest\": height_above_m is -2 (a rock starts on the ground or above it; expected 0 to "
     "1e9)"},
    {"SpeedAndHorizontalVelocity",
     {{"rocks = 10",
       R"(rocks = 10
speed_m_s = 3
horizontal_velocity_m_s = 1)"}},
     "slope.toml:25: seeder \"Crest\": horizontal_velocity_m_s and speed_m_s are given together (they exclude each "
     "other)"},
    {"DirectionWithoutLength",
     {{"rocks = 10",
       R"(rocks = 10
direction = [0, 0])"}},
     "slope.toml:25: seeder \"Crest\": direction is [0, 0] (expected a direction whose length is not 0)"},
    {"DirectionUpWithoutSpeed",
     {{"rocks = 10",
       R"(rocks = 10
direction = [1, 1])"}},
     "slope.toml:25: seeder \"Crest\": direction is [1, 1] (it is the direction of the horizontal velocity; expected z "
     "to be 0). For a velocity that points up or down, give speed_m_s"},
    {"DirectionAcrossIn2D",
     {{"rocks = 10",
       R"(rocks = 10
direction = [1, 1, 0])"}},
     "slope.toml:25: seeder \"Crest\": direction is [1, 1, 0] (expected y to be 0 in a 2D analysis)"},
    {"SeederTwice",
     {{"[[barrier]]",
       R"([[seeder]]
name = "Crest"
position = [2, 5]
mass_kg = 10

[[barrier]])"}},
     "slope.toml:28: two seeders are named \"Crest\" (the first begins in line 21). Give each its own name"},
    {"SeedersWithTooManyRocks",
     {{"rocks = 10", "rocks = 1000000000000"},
      {"[[barrier]]",
       R"([[seeder]]
position = [2, 5]
mass_kg = 10

[[barrier]])"}},
     "slope.toml:24: warning: seeder \"Crest\": its 1000000000000 rocks are identical (nothing about them or the "
     "ground is random, so they all follow one path). Give restitution or friction a distribution, or the ground a "
     "roughness\n"
     "slope.toml:27: all seeders together have 1000000000001 rocks (expected at most 1000000000000)"},
    {"BarrierWithoutHeight",
     {{R"(height_m = 3
)",
       ""}},
     "slope.toml:27: barrier \"Fence\": height_m is missing (expected more than 0, up to 10000)"},
    {"BarrierOfHeightZero",
     {{"height_m = 3", "height_m = 0"}},
     "slope.toml:30: barrier \"Fence\": height_m is 0 (nothing could hit it; expected more than 0, up to 10000)"},
    {"BarrierLyingDown",
     {{"height_m = 3",
       R"(height_m = 3
inclination_deg = 90)"}},
     "slope.toml:31: barrier \"Fence\": inclination_deg is 90 (it would lie on the ground; expected more than -90, "
     "less than 90)"},
    {"BarrierWithoutLine",
     {{R"(line = 15
)",
       ""}},
     "slope.toml:27: barrier \"Fence\": line is missing"},
    {"BarrierAcrossIn2D",
     {{"line = 15", "line = [[15, 0], [16, 50]]"}},
     "slope.toml:29: barrier \"Fence\": line is [[15, 0], [16, 50]] (expected x in a 2D analysis; these points differ "
     "in x)"},
    {"BarrierOfOnePointIn3D",
     {{section,
       R"(section = [[0, 0], [10, -10], [20, -10]]
width_m = 50)"},
      {"position = [1, 5]", "position = [1, 1, 5]"}},
     "slope.toml:30: barrier \"Fence\": line is 15 (expected two or more points on plan, [[x, y], [x, y]])"},
    {"BarrierRepeatsAPoint",
     {{section,
       R"(section = [[0, 0], [10, -10], [20, -10]]
width_m = 50)"},
      {"position = [1, 5]", "position = [1, 1, 5]"},
      {"line = 15", "line = [[15, 0], [15, 0]]"}},
     "slope.toml:30: barrier \"Fence\": line[1] is [15, 0] (it repeats the previous point). Leave it out"},
    {"BarrierWithHalfARestitution",
     {{"height_m = 3",
       R"(height_m = 3
normal_restitution = 0.5)"}},
     "slope.toml:31: barrier \"Fence\": tangential_restitution is missing (a barrier has both restitutions, or neither "
     "if it holds the rocks it stops)"},
    {"CollectorWithCapacity",
     {{"[[barrier]]", "[[collector]]"},
      {"height_m = 3",
       R"(height_m = 3
capacity_kJ = 100)"}},
     "slope.toml:31: collector \"Fence\": unknown key \"capacity_kJ\". It belongs to [[barrier]]"},
    {"CollectorNamedLikeABarrier",
     {{"height_m = 3",
       R"(height_m = 3

[[collector]]
name = "Fence"
line = 16
height_m = 5)"}},
     "slope.toml:33: two barriers or collectors are named \"Fence\" (the first begins in line 27). Give each its own "
     "name"},
};

INSTANTIATE_TEST_SUITE_P(All, BadPlaces, testing::ValuesIn(bad_places), name_of_case<BadProject>);

}  // namespace
}  // namespace talus::project
