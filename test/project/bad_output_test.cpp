// Errors in [output]: the exact text of each.

#include <gtest/gtest.h>

#include <vector>

#include "project/bad_project.hpp"

namespace talus::project {
namespace {

class BadOutput : public BadProjectTest {};

TEST_P(BadOutput, AreRefusedWithThisText) {
  EXPECT_EQ(refusal_of_reading(changed(GetParam().replacements)), GetParam().message);
}

const std::vector<BadProject> bad_output{
    {"PathsUnknownWord",
     {{"[terrain]",
       R"([output]
paths = "some"

[terrain])"}},
     "slope.toml:7: [output]: paths is \"some\" (expected \"all\", \"none\" or a number of rocks)"},
    {"StoreWithoutSize",
     {{"[terrain]",
       R"([output]
trajectories_MB = "some"

[terrain])"}},
     "slope.toml:7: [output]: trajectories_MB is \"some\" (expected \"all\", \"none\" or a number of MB)"},
    {"StoreTooLarge",
     {{"[terrain]",
       R"([output]
trajectories_MB = 2000000

[terrain])"}},
     "slope.toml:7: [output]: trajectories_MB is 2000000 (expected 0 to 1e6)"},
    {"PathsNegative",
     {{"[terrain]",
       R"([output]
paths = -1

[terrain])"}},
     "slope.toml:7: [output]: paths is -1 (expected 0 to 1e12)"},
    {"GeoPackageIsABoolean",
     {{"[terrain]",
       R"([output]
geopackage = true

[terrain])"}},
     "slope.toml:7: [output]: geopackage is true (expected \"all\", \"none\" or a number of rocks)"},
    {"MapPercentileTwice",
     {{"[terrain]",
       R"([output]
percentiles = [50, 0.0, -0.0]

[terrain])"}},
     "slope.toml:7: [output]: percentiles[2] is 0 (it is listed twice). Leave it out"},
    {"TooManyPercentiles",
     {{"[terrain]",
       R"([output]
percentiles = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21]

[terrain])"}},
     "slope.toml:7: [output]: percentiles has 21 entries (expected at most 20)"},
    {"MapsAsOneName",
     {{"[terrain]",
       R"([output]
maps = "velocity"

[terrain])"}},
     "slope.toml:7: [output]: maps is \"velocity\" (expected true, false or a list of \"passages\", \"reach_share\", "
     "\"deposits\", \"impacts\", \"energy_total\", \"energy_translational\", \"velocity\" and \"bounce_height\"). "
     "Write [\"velocity\"]"},
    {"MapsInQuotes",
     {{"[terrain]",
       R"([output]
maps = "true"

[terrain])"}},
     "slope.toml:7: [output]: maps is \"true\" (expected true, false or a list of \"passages\", \"reach_share\", "
     "\"deposits\", \"impacts\", \"energy_total\", \"energy_translational\", \"velocity\" and \"bounce_height\"). "
     "Leave out the quotes"},
    {"MapsUnknown",
     {{"[terrain]",
       R"([output]
maps = ["velocity", "energy_totl", 7, "velocity_max_m_s"]

[terrain])"}},
     "slope.toml:7: [output]: maps[1] is \"energy_totl\" (expected \"passages\", \"reach_share\", \"deposits\", "
     "\"impacts\", \"energy_total\", \"energy_translational\", \"velocity\" or \"bounce_height\"). Did you mean "
     "\"energy_total\"?\n"
     "slope.toml:7: [output]: maps[2] is 7 (expected \"passages\", \"reach_share\", \"deposits\", \"impacts\", "
     "\"energy_total\", \"energy_translational\", \"velocity\" or \"bounce_height\")\n"
     "slope.toml:7: [output]: maps[3] is \"velocity_max_m_s\" (expected \"passages\", \"reach_share\", \"deposits\", "
     "\"impacts\", \"energy_total\", \"energy_translational\", \"velocity\" or \"bounce_height\"). Did you mean "
     "\"velocity\"?"},
    {"MapTwice",
     {{"[terrain]",
       R"([output]
maps = ["velocity", "impacts", "velocity"]

[terrain])"}},
     "slope.toml:7: [output]: maps[2] is \"velocity\" (it is listed twice). Leave it out"},
    {"TooManyMaps",
     {{"[terrain]",
       R"([output]
maps = [1, 2, 3, 4, 5, 6, 7, 8, 9]

[terrain])"}},
     "slope.toml:7: [output]: maps has 9 entries (expected at most 8)"},
    {"MapCellsUnknownWord",
     {{"[terrain]",
       R"([output]
raster_cell_m = "fine"

[terrain])"}},
     "slope.toml:7: [output]: raster_cell_m is \"fine\" (expected a number or \"terrain\")"},
    {"MapCellsOfATerrainThatIsNotARaster",
     {{"[terrain]",
       R"([output]
raster_cell_m = "terrain"

[terrain])"}},
     "slope.toml:7: [output]: raster_cell_m is \"terrain\" (the terrain is not a raster, so it has no cells). Give the "
     "cell size in metres"},
};

INSTANTIATE_TEST_SUITE_P(All, BadOutput, testing::ValuesIn(bad_output), name_of_case<BadProject>);

}  // namespace
}  // namespace talus::project
