#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {

Table sampling_table() {
  auto [add, rows] = one_row(&Project::sampling);
  return {
      .key = "sampling",
      .meaning = "How random properties are drawn.",
      .settings =
          {
              {.key = "seed",
               .slot = member(&Sampling::seed),
               .range = at_least(0),
               .meaning = "A trajectory depends only on the project, this number and the rock's number.",
               .source = "Talus"},
              {.key = "method",
               .slot = member(&Sampling::method),
               .meaning = "Independent draws, or draws stratified over the rocks of the campaign.",
               .source = "McKay, Beckman and Conover 1979 for `latin_hypercube`"},
              {.key = "materials",
               .slot = member(&Sampling::materials),
               .meaning = "Material properties are drawn at every impact, or once for each rock.",
               .source = "Talus; the manual does not say which its programs do"},
          },
      .topic = topics::sampling,
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
