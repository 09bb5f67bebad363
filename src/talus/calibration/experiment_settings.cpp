// The declaration of every setting of an experiment file.

#include "talus/calibration/experiment.hpp"
#include "talus/project/settings/slots.hpp"

namespace talus::validation {

namespace {

using project::Table;
using project::declared::member;

constexpr double most_runout_m = 1e6;
constexpr std::size_t most_sentences = 50;

Table head() {
  return {.key = "",
          .meaning = "The experiment.",
          .settings = {
              {.key = "title",
               .slot = member(&Experiment::title),
               .required = true,
               .meaning = "Title of the report.",
               .source = "Talus"},
              {.key = "summary",
               .slot = member(&Experiment::summary),
               .required = true,
               .meaning = "What was done in the field.",
               .source = "Talus"},
              {.key = "licence",
               .slot = member(&Experiment::licence),
               .required = true,
               .meaning = "Licence of the data.",
               .source = "Talus"},
              {.key = "citations",
               .slot = member(&Experiment::citations),
               .required = true,
               .most_entries = most_sentences,
               .meaning = "Where the data were published.",
               .source = "Talus"},
              {.key = "limits",
               .slot = member(&Experiment::limits),
               .most_entries = most_sentences,
               .meaning = "What the data do not say; shown wherever results are.",
               .source = "Talus"},
              {.key = "split",
               .slot = member(&Experiment::split),
               .required = true,
               .meaning = "How the runs were divided into the sites of the studies.",
               .source = "Talus"},
              {.key = "sought",
               .slot = member(&Experiment::sought),
               .required = true,
               .most_entries = most_sentences,
               .meaning = "What was sought, with the sources of the ranges.",
               .source = "Talus"},
              {.key = "not_sought",
               .slot = member(&Experiment::not_sought),
               .required = true,
               .most_entries = most_sentences,
               .meaning = "What was not.",
               .source = "Talus"},
          }};
}

Table model() {
  return {.key = "model",
          .repeated = true,
          .required = true,
          .meaning = "A way to calculate the experiment.",
          .settings = {
              {.key = "name",
               .slot = member(&ExperimentModel::name),
               .required = true,
               .meaning = "Name in tables and figures.",
               .source = "Talus"},
              {.key = "study",
               .slot = member(&ExperimentModel::study),
               .required = true,
               .meaning = "A study file in the same folder. Its sites are predicted from each other.",
               .source = "Talus"},
          }};
}

Table published() {
  return {.key = "published",
          .repeated = true,
          .meaning = "What another program reached on this experiment.",
          .settings = {
              {.key = "name",
               .slot = member(&PublishedResult::name),
               .required = true,
               .meaning = "The program, and how it was used.",
               .source = "Talus"},
              {.key = "source",
               .slot = member(&PublishedResult::source),
               .required = true,
               .meaning = "Where this was published.",
               .source = "Talus"},
              {.key = "observed_mean_m",
               .slot = member(&PublishedResult::observed_mean_m),
               .unit = "m",
               .range = {.least = 0, .most = most_runout_m},
               .required = true,
               .meaning = "Mean observed runout of the runs that it was compared with.",
               .source = "Talus"},
              {.key = "predicted_mean_m",
               .slot = member(&PublishedResult::predicted_mean_m),
               .unit = "m",
               .range = {.least = 0, .most = most_runout_m},
               .required = true,
               .meaning = "Its mean runout.",
               .source = "Talus"},
              {.key = "mean_abs_error_m",
               .slot = member(&PublishedResult::mean_abs_error_m),
               .unit = "m",
               .range = {.least = 0, .most = most_runout_m},
               .without_it = "not shown",
               .meaning = "Mean magnitude of the errors of single runs.",
               .source = "Talus"},
          }};
}

}  // namespace

const std::vector<project::Table>& experiment_tables() {
  static const std::vector<Table> all{head(), model(), published()};
  return all;
}

}  // namespace talus::validation
