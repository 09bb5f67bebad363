#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {

Table kit_table() {
  return {
      .key = "kit",
      .repeated = true,
      .meaning =
          "A barrier kit to choose from, as its assessment describes it; any number of entries. With kits, "
          "`design.heights_m` and `design.energies_kJ` are not used.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Kit::name),
               .required = true,
               .meaning = "Name in the results; must be unique.",
               .source = "Talus"},
              {.key = "heights_m",
               .slot = member(&Kit::heights_m),
               .unit = "m",
               .range = above_0_up_to(most_height_m, "nothing could hit it", "nothing is built that high"),
               .required = true,
               .most_entries = 100,
               .meaning = "Nominal heights that the assessment covers.",
               .source = "the kit's assessment"},
              {.key = "mel_kJ",
               .slot = member(&Kit::mel_kJ),
               .unit = "kJ",
               .range = above_0_up_to(most_energy_kJ, "it would stop nothing"),
               .required = true,
               .meaning = "Maximum energy level, of which it stops one impact.",
               .source = "the kit's assessment"},
              {.key = "sel_kJ",
               .slot = member(&Kit::sel_kJ),
               .unit = "kJ",
               .range = above_0_up_to(most_energy_kJ, "it would stop nothing"),
               .without_it = "a third of the MEL",
               .meaning = "Service energy level, of which it stops two impacts without repair.",
               .source = "the kit's assessment"},
              {.key = "tested_height_m",
               .slot = member(&Kit::tested_height_m),
               .unit = "m",
               .range = above_0_up_to(most_height_m, "nothing could hit it", "nothing is built that high"),
               .without_it = "no height is refused",
               .meaning = "Nominal height of the kit in its test: no lower one is chosen from.",
               .source = "the kit's assessment"},
              {.key = "elongation_m",
               .slot = member(&Kit::elongation_m),
               .unit = "m",
               .range = up_to(most_height_m),
               .without_it = "its elongation is not checked",
               .topic = topics::elongation,
               .meaning = "Maximum elongation of the net in the test at the MEL; needs `design.clearance_m` or "
                          "`design.protect`.",
               .source = "the kit's assessment"},
              {.key = "residual_height",
               .slot = member(&Kit::residual_height),
               .meaning = "Category of the height that remains after an impact at the MEL: A at least half, B at least "
                          "30 %, C less.",
               .source = "EAD 340059-00-0106, after others"},
              {.key = "cost_per_m",
               .slot = member(&Kit::cost_per_m),
               .unit = "1/m",
               .range = above_0_up_to(1e12, "kits would be ordered at random"),
               .without_it = "the cost index",
               .topic = topics::ranking,
               .meaning = "Price per metre of line, in any currency; of all kits or of none.",
               .source = "an input"},
          },
      .topic = topics::kits,
      .add = [](Project& project) { return added(project.kits); },
      .rows = [](Project& project) { return all(project.kits); },
  };
}

}  // namespace talus::project::declared
