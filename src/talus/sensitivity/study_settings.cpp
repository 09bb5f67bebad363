// The declaration of every setting of a sensitivity study.

#include "talus/project/settings/slots.hpp"
#include "talus/sensitivity/study.hpp"

namespace talus::sensitivity {

namespace {

using project::Table;
using project::declared::member;

constexpr double most_rocks = 1e6, most_trajectories = 1e4, most_rows = 1 << 20;

Table study_head() {
  return {.key = "",
          .meaning = "The study.",
          .settings = {
              {.key = "name",
               .slot = member<Study>(&Study::name),
               .without_it = "the file's name",
               .meaning = "Title of the report.",
               .source = "Talus"},
              {.key = "method",
               .slot = member<Study>(&Study::method_word),
               .meaning = "`morris` finds from few runs which inputs matter; `sobol` finds which share of the variance "
                          "each causes.",
               .source = "Morris 1991; Saltelli et al. 2010"},
              {.key = "seed",
               .slot = member<Study>(&Study::seed),
               .range = {.least = 0},
               .meaning = "Number that determines the values of the inputs and the draws of the rocks.",
               .source = "Talus"},
              {.key = "rocks",
               .slot = member<Study>(&Study::rocks),
               .range = {.least = 10, .most = most_rocks, .too_low = "fewer give no percentiles"},
               .meaning = "Rocks of each run at each site; the seeders of a project share them in proportion to their "
                          "own numbers.",
               .source = "Talus"},
              {.key = "trajectories",
               .slot = member<Study>(&Study::trajectories),
               .range = {.least = 4, .most = most_trajectories, .too_low = "fewer give no interval"},
               .meaning = "Of `morris`. Each takes one run more than there are inputs.",
               .source = "Campolongo, Cariboni and Saltelli 2007"},
              {.key = "rows",
               .slot = member<Study>(&Study::rows),
               .range = {.least = 16, .most = most_rows, .too_low = "fewer give no interval"},
               .meaning = "Of `sobol`, a power of two. Each takes two runs more than there are inputs.",
               .source = "Saltelli et al. 2010"},
              {.key = "confidence",
               .slot = member<Study>(&Study::confidence),
               .range = {.least = 0.5, .most = 0.999},
               .meaning = "Confidence of the intervals.",
               .source = "Talus"},
          }};
}

Table study_result() {
  return {
      .key = "result",
      .repeated = true,
      .required = true,
      .meaning = "A result of each run.",
      .settings = {
          {.key = "name",
           .slot = member<StudyResult>(&StudyResult::name),
           .without_it = "made from the other keys",
           .meaning = "Name in tables and figures.",
           .source = "Talus"},
          {.key = "quantity",
           .slot = member<StudyResult>(&StudyResult::quantity),
           .required = true,
           .meaning = "`runout` on plan, `max_energy` or `max_bounce` of each rock; at a line: `share` of the rocks "
                      "that reach it, `energy`, `velocity` or `height` (of the block's top) at their first arrival.",
           .source = "Talus"},
          {.key = "percentile",
           .slot = member<StudyResult>(&StudyResult::percentile),
           .unit = "%",
           .range = {.least = 0, .most = 100, .least_excluded = true, .most_excluded = true},
           .meaning = "Percentile over the rocks of a run; not of a share.",
           .source = "Talus"},
          {.key = "at",
           .slot = member<StudyResult>(&StudyResult::at),
           .without_it = "required at a line",
           .meaning = "The collector or barrier.",
           .source = "Talus"},
          {.key = "sites",
           .slot = member<StudyResult>(&StudyResult::sites),
           .without_it = "all sites",
           .meaning = "The sites of whose runs it is a result.",
           .source = "Talus"},
      }};
}

}  // namespace

const std::vector<Table>& study_tables() {
  static const std::vector<Table> tables{study_head(), study::site_table(), study::parameter_table(), study_result()};
  return tables;
}

}  // namespace talus::sensitivity
