#include "talus/files/file_formats.hpp"
#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"

namespace talus::project::declared {

namespace {

Need of_a_sample() { return {.any_of = {is("distribution", {word(DistributionKind::empirical)})}}; }
Need of_parameters() { return {.any_of = {is_not("distribution", {word(DistributionKind::empirical)})}}; }

}  // namespace

Table distribution_table() {
  static const std::string file_meaning =
      "Text with the names of its columns in the first line (" + endings_in_words(FileKind::point_text) +
      "), a value of the sample in each row. Every draw is one of the values, with equal probability or by "
      "`weight_column`; nothing is interpolated. The path is relative to the project file.";
  return {
      .key = "distribution",
      .meaning = "Kind of distribution; with `\"none\"`, every draw is the mean, whatever the other keys say.",
      .settings =
          {
              {.key = "mean",
               .slot = member(&Distribution::mean),
               .without_it = "required, except for `empirical`",
               .applies_when = {of_parameters()},
               .meaning =
                   "Mean before truncation, in the unit of the property. Limits that are not symmetric about it shift "
                   "the mean of the draws, also of `uniform` and `triangular`; a warning then gives both numbers.",
               .source = "the manual, tables 1-1 and 1-2"},
              {.key = "distribution",
               .slot = member(&Distribution::kind),
               .meaning = "The kind; with `\"none\"` every draw is the mean, whatever the other keys say.",
               .source = "the manual, tables 1-1 and 1-2"},
              {.key = "std_dev",
               .slot = member(&Distribution::std_dev),
               .range = at_least(0, "a standard deviation cannot be negative"),
               .without_it = "required, except for `exponential` (where it is the mean) and for `uniform` and "
                             "`triangular` with limits",
               .applies_when = {of_parameters()},
               .title = "Standard deviation",
               .meaning = "Standard deviation before truncation, in the unit of the property.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "rel_min",
               .slot = member(&Distribution::rel_min),
               .range = at_least(0, "it is a distance below the mean"),
               .without_it = "only the limit of the property",
               .applies_when = {of_parameters()},
               .title = "Relative minimum",
               .meaning = "No draw is below mean - rel_min.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "rel_max",
               .slot = member(&Distribution::rel_max),
               .range = at_least(0, "it is a distance above the mean"),
               .without_it = "only the limit of the property",
               .applies_when = {of_parameters()},
               .title = "Relative maximum",
               .meaning = "No draw is above mean + rel_max.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "file",
               .slot = member(&Distribution::file),
               .without_it = "required for `empirical`",
               .applies_when = {of_a_sample()},
               .title = "File of the sample",
               .meaning = file_meaning,
               .source = "Talus"},
              {.key = "column",
               .slot = member(&Distribution::column),
               .without_it = "the key of the property, for example `mass_kg`",
               .applies_when = {of_a_sample()},
               .meaning = "Column of the file with the values, in the unit of the property.",
               .source = "Talus"},
              {.key = "weight_column",
               .slot = member(&Distribution::weight_column),
               .without_it = "equal weights",
               .applies_when = {of_a_sample()},
               .meaning = "Column of the file with the weights of the values, such as the number of blocks of each "
                          "size; of any sum.",
               .source = "Talus"},
          },
      .add = nullptr,
      .rows = nullptr,
  };
}

}  // namespace talus::project::declared
