#pragma once
// What a run is made of: a checked project and the model built from it.

#include "talus/archive/run_summary.hpp"
#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"

namespace talus::python {

struct Site {
  project::Project project;
  Model model;
  Problems warnings;    // of both
  ReportInputs inputs;  // as they were when the project was read
};

}  // namespace talus::python
