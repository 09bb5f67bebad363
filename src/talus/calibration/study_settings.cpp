// The declaration of every setting of a study file.

#include "talus/calibration/study.hpp"

#include "talus/project/settings/slots.hpp"

namespace talus::calibration {

namespace {

using project::Table;
using project::declared::member;

constexpr double most_draws = 1e6, most_rocks = 1e6, most_rounds = 20, most_folds = 1000;
constexpr double most_accuracy_m = 1e3, most_weight = 1e3, most_blocks = 1e6, most_relative_accuracy = 3;

Table head_table() {
  return {
      .key = "",
      .meaning = "The study.",
      .settings = {
          {.key = "name",
           .slot = member<Study>(&Study::name),
           .without_it = "the file's name",
           .meaning = "Title of the report.",
           .source = "Talus"},
          {.key = "seed",
           .slot = member<Study>(&Study::seed),
           .range = {.least = 0},
           .meaning = "Number that determines the sets of parameters and the draws of rocks. All sets have the same "
                      "draws of rocks; the projects' own seeds are not used.",
           .source = "Talus"},
          {.key = "rocks",
           .slot = member<Study>(&Study::rocks),
           .range = {.least = 20, .most = most_rocks, .too_low = "fewer say too little about a distribution"},
           .meaning = "Rocks simulated with each set of parameters at each site; its seeders share them in "
                      "proportion to their own numbers.",
           .source = "Talus"},
          {.key = "draws",
           .slot = member<Study>(&Study::draws),
           .range = {.least = 50, .most = most_draws, .too_low = "fewer cannot represent a posterior"},
           .meaning = "Sets of parameters in all rounds together. Half of them are in the first round.",
           .source = "Talus"},
          {.key = "most_draws",
           .slot = member<Study>(&Study::most_draws),
           .range = {.least = 50, .most = most_draws, .too_low = "fewer cannot represent a posterior"},
           .without_it = "three times `draws`",
           .meaning =
               "Where the posterior is as accurate as fewer than 40 sets after all rounds, further rounds follow, "
               "up to this number of sets.",
           .source = "Talus"},
          {.key = "rounds",
           .slot = member<Study>(&Study::rounds),
           .range = {.least = 1, .most = most_rounds, .too_low = "the first round draws from the prior"},
           .meaning = "The first round draws from the prior, each later one near what the earlier ones found.",
           .source = "Beaumont, Cornuet, Marin and Robert 2009"},
          {.key = "folds",
           .slot = member<Study>(&Study::folds),
           .range = {.least = 0, .most = most_folds},
           .meaning = "Parts into which the observations are divided to be predicted from the others; 0: none.",
           .source = "cross-validation"},
          {.key = "hold_out_sites",
           .slot = member<Study>(&Study::hold_out_sites),
           .meaning = "Predict each site from the other sites, instead of some rocks from other rocks.",
           .source = "Talus"},
      }};
}

Table observations_table() {
  return {
      .key = "observations",
      .repeated = true,
      .required = true,
      .meaning = "What was observed at a site; one entry for each file.",
      .settings =
          {
              {.key = "name",
               .slot = member<StudyObservations>(&StudyObservations::name),
               .without_it = "the file's name",
               .meaning = "Name in tables and figures.",
               .source = "Talus"},
              {.key = "site",
               .slot = member<StudyObservations>(&StudyObservations::site),
               .without_it = "the only site",
               .meaning = "The site's name.",
               .source = "Talus"},
              {.key = "stops",
               .slot = member<StudyObservations>(&StudyObservations::stops),
               .meaning = "File of the places where rocks came to rest: CSV with the columns x_m and y_m (2D: x_m "
                          "alone), or points for a GIS. A column `release` names each rock's seeder, or its row in a "
                          "seeder's table; `mass_kg` is its mass.",
               .source = "Talus"},
              {.key = "marks",
               .slot = member<StudyObservations>(&StudyObservations::marks),
               .meaning = "File of the places where rocks struck the ground, as for `stops`. A column `rock` names the "
                          "rock that left each mark.",
               .source = "Talus"},
              {.key = "values",
               .slot = member<StudyObservations>(&StudyObservations::values),
               .meaning = "CSV file of rocks that arrived at a line, a row each, with one or more of the columns "
                          "height_m, velocity_m_s and energy_kJ (translational and rotational).",
               .source = "Talus"},
              {.key = "zones",
               .slot = member<StudyObservations>(&StudyObservations::zones),
               .meaning =
                   "File of areas and what came to rest in each: polygons for a GIS with the attributes zone and "
                   "volume_m3, count or share; or CSV with a row for each vertex (zone, x_m, y_m; 2D: a row for "
                   "each zone with zone, from_m, to_m) and one of these columns.",
               .source = "Talus"},
              {.key = "released",
               .slot = member<StudyObservations>(&StudyObservations::released),
               .range = {.least = 0, .least_excluded = true},
               .without_it = "only shares among the zones are compared",
               .meaning =
                   "Volume [m3] or count of all rocks that were released: what the zones do not hold came to rest "
                   "elsewhere. With `zones`.",
               .source = "Talus"},
              {.key = "blocks",
               .slot = member<StudyObservations>(&StudyObservations::blocks),
               .range = {.least = 1, .most = most_blocks},
               .without_it = "from the volume, by the volumes of simulated rocks",
               .meaning = "Number of rocks that the volumes or shares consist of; required with shares. With `zones`.",
               .source = "Talus"},
              {.key = "relative_accuracy",
               .slot = member<StudyObservations>(&StudyObservations::relative_accuracy),
               .range = {.least = 0, .most = most_relative_accuracy, .too_low = "it is a standard deviation"},
               .meaning = "Standard deviation of the error of an observed volume or share, over itself. With `zones`.",
               .source = "Talus"},
              {.key = "at",
               .slot = member<StudyObservations>(&StudyObservations::at),
               .without_it = "required with `values`",
               .meaning = "The collector or barrier of the project at which the values were observed.",
               .source = "Talus"},
              {.key = "layer",
               .slot = member<StudyObservations>(&StudyObservations::layer),
               .without_it = "the only layer",
               .meaning = "Layer of the GIS file.",
               .source = "Talus"},
              {.key = "accuracy_m",
               .slot = member<StudyObservations>(&StudyObservations::accuracy_m),
               .unit = "m",
               .range = {.least = 0, .most = most_accuracy_m, .too_low = "it is a standard deviation"},
               .meaning = "Standard deviation of the error of an observed place or height.",
               .source = "Talus"},
              {.key = "weight",
               .slot = member<StudyObservations>(&StudyObservations::weight),
               .range = {.least = 0, .most = most_weight, .least_excluded = true},
               .meaning = "Factor of the logarithm of the likelihood: less than 1 where rocks were not independent.",
               .source = "Talus"},
          },
      .choices = {{{"stops"}, {"marks"}, {"values"}, {"zones"}}}};
}

Table model_table() {
  return {.key = "model",
          .repeated = true,
          .meaning = "A variant of the projects; two or more are compared by how well they predict.",
          .settings = {
              {.key = "name",
               .slot = member<StudyModel>(&StudyModel::name),
               .required = true,
               .meaning = "Name in tables.",
               .source = "Talus"},
              {.key = "set",
               .slot = member<StudyModel>(&StudyModel::set),
               .most_entries = 100,
               .meaning = "Settings that override those of all projects: `[\"analysis.model=rigid_sphere\"]`.",
               .source = "Talus"},
          }};
}

}  // namespace

const std::vector<Table>& study_tables() {
  static const std::vector<Table> tables{head_table(), study::site_table(), observations_table(),
                                         study::parameter_table(), model_table()};
  return tables;
}

}  // namespace talus::calibration
