#pragma once
// Models whose rocks fly, slide, roll, meet forests and barriers, and the logs of their rocks.

#include <string>
#include <vector>

#include "support/places.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::store_test {

struct NamedModel {
  std::string name;
  std::string file;                   // of examples
  std::vector<std::string> settings;  // in addition
  double most_bytes = 40;             // for each row of paths.csv: more where rocks curve along the ground for long
                                      // between two rows. With the parts of these curves, 40 is enough for all
};

inline const std::vector<NamedModel> models{
    {"Tutorial2d", "tutorial-1/tutorial-1-2d.toml", {}},
    {"Tutorial2dSphere", "tutorial-1/tutorial-1-2d.toml", {"analysis.model=rigid_sphere"}},
    {"Tutorial3d", "tutorial-1/tutorial-1-3d.toml", {}},
    {"Sliding", "sliding/sliding.toml", {}},
    {"SlidingInClosedForm", "sliding/sliding.toml", {"analysis.sliding=closed_form"}},
    {"Barrier", "barrier/barrier.toml", {}},
    {"Bowl", "bowl/bowl.toml", {}},
    {"BowlSphere", "bowl/bowl.toml", {"analysis.model=rigid_sphere"}, 55},
    {"Crater", "maungawhau/crater.toml", {}, 84},
    {"CraterLumpedMass", "maungawhau/crater.toml", {"analysis.model=lumped_mass"}, 75},
    {"CraterForest",
     "maungawhau/crater.toml",
     {"material.0.forest_drag_kg_s=400", "material.0.forest_height_m=10"},
     120},
    {"Blocks", "blocks/blocks.toml", {}, 120},
};

inline Model model_of(const NamedModel& named) {
  const std::string file = std::string(talus::places::source_dir) + "/examples/" + named.file;
  const project::Reading reading = project::read_project(file, {named.settings, {}, {}});
  Problems warnings;
  return project::build_model(reading.project, warnings);
}

}  // namespace talus::store_test
