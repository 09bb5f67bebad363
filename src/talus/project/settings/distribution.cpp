#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"

namespace talus::project::declared {

Table distribution_table() {
  return {
      .key = "distribution",
      .meaning = "A random property. A plain number n is short for `{ mean = n, distribution = \"none\" }`.",
      .settings =
          {
              {.key = "mean",
               .slot = member(&Distribution::mean),
               .required = true,
               .meaning =
                   "The mean before truncation, in the property's unit. Limits that are not even about it move the "
                   "mean of the draws, of `uniform` and `triangular` too; a warning then gives both numbers.",
               .source = "the manual, tables 1-1 and 1-2"},
              {.key = "distribution",
               .slot = member(&Distribution::kind),
               .meaning = "The kind; with `\"none\"` every draw is the mean, whatever the other keys say.",
               .source = "the manual, tables 1-1 and 1-2"},
              {.key = "std_dev",
               .slot = member(&Distribution::std_dev),
               .range = at_least(0, "a standard deviation is a width"),
               .without_it = "required, except for `exponential` (the mean), and for `uniform` and `triangular` with "
                             "limits",
               .title = "Standard deviation",
               .meaning = "Standard deviation before truncation, in the property's unit.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "rel_min",
               .slot = member(&Distribution::rel_min),
               .range = at_least(0, "it is a distance below the mean"),
               .without_it = "no limit but the property's own",
               .title = "Relative minimum",
               .meaning = "No draw is below mean - rel_min.",
               .source = "the manual, tables 1-1 and 1-2",
               .slip = sign_slip},
              {.key = "rel_max",
               .slot = member(&Distribution::rel_max),
               .range = at_least(0, "it is a distance above the mean"),
               .without_it = "no limit but the property's own",
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
