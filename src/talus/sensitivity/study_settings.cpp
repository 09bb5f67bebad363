// The declaration of every setting of a sensitivity study.

#include "talus/sensitivity/study.hpp"

namespace talus::sensitivity {

namespace {

using project::Row;
using project::RowElsewhere;
using project::Slot;
using project::Table;

template <class Struct, class Member>
std::function<Slot(Row)> slot_of(Member Struct::*pointer) {
  return [pointer](Row row) -> Slot { return &(std::get<RowElsewhere>(row).of<Struct>()->*pointer); };
}

constexpr double most_rocks = 1e6, most_trajectories = 1e4, most_rows = 1 << 20;

Table study_head() {
  return {
      .key = "",
      .meaning = "The study.",
      .settings = {
          {.key = "name",
           .slot = slot_of(&Study::name),
           .without_it = "the file's name",
           .meaning = "Title of the report.",
           .source = "Talus"},
          {.key = "project",
           .slot = slot_of(&Study::project),
           .required = true,
           .meaning = "The project file, relative to the study file.",
           .source = "Talus"},
          {.key = "set",
           .slot = slot_of(&Study::set),
           .most_entries = 100,
           .meaning = "Settings that override the project's, as `--set` does: `[\"analysis.grazing_angle_deg=5\"]`.",
           .source = "Talus"},
          {.key = "method",
           .slot = slot_of(&Study::method_word),
           .meaning = "`morris` finds from few runs which inputs matter; `sobol` finds which share of the variance "
                      "each causes.",
           .source = "Morris 1991; Saltelli et al. 2010"},
          {.key = "seed",
           .slot = slot_of(&Study::seed),
           .range = {.least = 0},
           .meaning = "Number that determines the values of the inputs and the draws of the rocks.",
           .source = "Talus"},
          {.key = "rocks",
           .slot = slot_of(&Study::rocks),
           .range = {.least = 10, .most = most_rocks, .too_low = "fewer give no percentiles"},
           .meaning = "Rocks of each run; the project's seeders share them in proportion to their own numbers.",
           .source = "Talus"},
          {.key = "trajectories",
           .slot = slot_of(&Study::trajectories),
           .range = {.least = 4, .most = most_trajectories, .too_low = "fewer give no interval"},
           .meaning = "Of `morris`. Each takes one run more than there are inputs.",
           .source = "Campolongo, Cariboni and Saltelli 2007"},
          {.key = "rows",
           .slot = slot_of(&Study::rows),
           .range = {.least = 16, .most = most_rows, .too_low = "fewer give no interval"},
           .meaning = "Of `sobol`, a power of two. Each takes two runs more than there are inputs.",
           .source = "Saltelli et al. 2010"},
          {.key = "confidence",
           .slot = slot_of(&Study::confidence),
           .range = {.least = 0.5, .most = 0.999},
           .meaning = "Confidence of the intervals.",
           .source = "Talus"},
      }};
}

Table study_input() {
  return {
      .key = "parameter",
      .repeated = true,
      .required = true,
      .meaning = "A number of the project that varies.",
      .settings =
          {
              {.key = "path",
               .slot = slot_of(&StudyInput::path),
               .required = true,
               .meaning = "Its path in the project, as in `--set`: `material.Scree.normal_restitution`; `*` for all "
                          "names.",
               .source = "Talus"},
              {.key = "range",
               .slot = slot_of(&StudyInput::range),
               .most_entries = 2,
               .meaning = "Least and greatest value; all between are equally probable.",
               .source = "Talus"},
              {.key = "prior",
               .slot = slot_of(&StudyInput::prior),
               .without_it = "given by `range`",
               .meaning = "Its distribution: `{ mean = 0.4, distribution = \"normal\", std_dev = 0.1 }`.",
               .source = "Talus"},
          },
      .choices = {{{"range"}, {"prior"}}}};
}

Table study_result() {
  return {
      .key = "result",
      .repeated = true,
      .required = true,
      .meaning = "A result of each run.",
      .settings = {
          {.key = "name",
           .slot = slot_of(&StudyResult::name),
           .without_it = "made from the other keys",
           .meaning = "Name in tables and figures.",
           .source = "Talus"},
          {.key = "quantity",
           .slot = slot_of(&StudyResult::quantity),
           .required = true,
           .meaning = "`runout` on plan, `max_energy` or `max_bounce` of each rock; at a line: `share` of the rocks "
                      "that reach it, `energy`, `velocity` or `height` at their first arrival.",
           .source = "Talus"},
          {.key = "percentile",
           .slot = slot_of(&StudyResult::percentile),
           .unit = "%",
           .range = {.least = 0, .most = 100, .least_excluded = true, .most_excluded = true},
           .meaning = "Percentile over the rocks of a run; not of a share.",
           .source = "Talus"},
          {.key = "at",
           .slot = slot_of(&StudyResult::at),
           .without_it = "required at a line",
           .meaning = "The collector or barrier.",
           .source = "Talus"},
      }};
}

}  // namespace

const std::vector<Table>& study_tables() {
  static const std::vector<Table> tables{study_head(), study_input(), study_result()};
  return tables;
}

}  // namespace talus::sensitivity
