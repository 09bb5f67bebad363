#include "talus/run/run_results.hpp"

#include <gtest/gtest.h>

#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::project {
namespace {

// Cells of maps are numbered with 32 bits.
TEST(Maps, WithTooManyCellsAreRefused) {
  Problems warnings;
  const Project project = read_project_text(R"(
[terrain]
section = [[0, 0], [10, -10]]
width_m = 1e8
[[material]]
name = "Rock"
[[seeder]]
position = [1, 99999999, 5]
mass_kg = 100
[output]
raster_cell_m = 0.01
)",
                                            "slope.toml")
                              .project;
  const Model model = build_model(project, warnings);
  try {
    (void)map_observer(project, model);
    ADD_FAILURE() << "was not refused";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.problems().text(),
              "slope.toml: [output]: raster_cell_m is 0.01 (the terrain is 1e+10 such cells wide; expected fewer than "
              "2e+09). Choose larger cells");
  }
}

}  // namespace
}  // namespace talus::project
