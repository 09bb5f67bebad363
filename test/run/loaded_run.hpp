#pragma once
// A project that is ready to run, with the warnings of reading it.

#include "talus/core/problems.hpp"
#include "talus/model/model.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct LoadedRun {
  Project project;
  Problems warnings;
  Model model;
};

}  // namespace talus::project
