#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"

namespace talus::project::declared {

Table distribution_table() {
  return {
      .key = "distribution",
      .meaning = "Kind of distribution; with `\"none\"`, every draw is the mean, whatever the other keys say.",
      .settings =
          {
              {.key = "mean",
               .slot = member(&Distribution::mean),
               .required = true,
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
               .title = "Standard deviation",
               .meaning = "Standard deviation before truncation, in the unit of the property.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "rel_min",
               .slot = member(&Distribution::rel_min),
               .range = at_least(0, "it is a distance below the mean"),
               .without_it = "only the limit of the property",
               .title = "Relative minimum",
               .meaning = "No draw is below mean - rel_min.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "rel_max",
               .slot = member(&Distribution::rel_max),
               .range = at_least(0, "it is a distance above the mean"),
               .without_it = "only the limit of the property",
               .title = "Relative maximum",
               .meaning = "No draw is above mean + rel_max.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
          },
      .add = nullptr,
      .rows = nullptr,
  };
}

}  // namespace talus::project::declared
