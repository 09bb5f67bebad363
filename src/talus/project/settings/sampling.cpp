#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"
#include "talus/results/ensemble.hpp"

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
              {.key = "parameters",
               .slot = member(&Sampling::parameters),
               .without_it = "all rocks have the project's values",
               .meaning =
                   "CSV file with a sample of uncertain parameters, such as the posterior of a calibration: a row "
                   "a set, a column `weight`, and a column for each parameter, named by its path "
                   "(`material.Scree.normal_restitution`). The rocks are divided into ensembles, each with a "
                   "set drawn by weight.",
               .source = "Talus"},
              {.key = "parameters_site",
               .slot = member(&Sampling::parameters_site),
               .without_it = "the only site whose columns name numbers of this project",
               .applies_when = {{.any_of = {given("parameters")}, .otherwise = Otherwise::warned}},
               .meaning = "Site of the study whose columns `PATH@SITE` apply, where a posterior of several sites has a "
                          "column of each.",
               .source = "Talus"},
              {.key = "ensembles",
               .slot = member(&Sampling::ensembles),
               .range = {.least = 2,
                         .most = static_cast<double>(most_ensembles),
                         .too_low = "one set shows no uncertainty"},
               .applies_when = {{.any_of = {given("parameters")}, .otherwise = Otherwise::warned}},
               .meaning = "Ensembles of rocks with different parameters; rock n belongs to ensemble n modulo this "
                          "number.",
               .source = "Talus"},
          },
      .topic = topics::sampling,
      .add = add,
      .rows = rows,
  };
}

}  // namespace talus::project::declared
