// The declaration of every key of a set of factors.

#include "talus/project/factor_set.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"

namespace talus::project {

namespace {

Table head() {
  return {.key = "",
          .meaning = "The set.",
          .settings = {
              {.key = "name",
               .slot = declared::member(&FactorSet::name),
               .required = true,
               .meaning = "Name in the results.",
               .source = "Talus"},
              {.key = "title",
               .slot = declared::member(&FactorSet::title),
               .required = true,
               .meaning = "What it is, with its edition.",
               .source = "Talus"},
              {.key = "not_read",
               .slot = declared::member(&FactorSet::not_read),
               .without_it = "nothing",
               .meaning = "What could not be read of the standard.",
               .source = "Talus"},
              {.key = "design_percentile",
               .slot = declared::member(&FactorSet::design_percentile),
               .unit = "%",
               .range = declared::between(0, 100),
               .without_it = "the project gives it",
               .meaning = "Percentile of velocity or energy, and of height, that the check is based on.",
               .source = "Talus"},
              {.key = "upper_clearance_m",
               .slot = declared::member(&FactorSet::upper_clearance_m),
               .unit = "m",
               .range = declared::up_to(declared::most_height_m),
               .meaning = "Minimum clearance of a kit above the design height.",
               .source = "Talus"},
              {.key = "clears_half_the_block",
               .slot = declared::member(&FactorSet::clears_half_the_block),
               .meaning = "Whether the clearance is also at least half the block.",
               .source = "Talus"},
              {.key = "clearance_source",
               .slot = declared::member(&FactorSet::clearance_source),
               .without_it = "none",
               .meaning = "Source of the clearance.",
               .source = "Talus"},
              {.key = "clearance_not_read",
               .slot = declared::member(&FactorSet::clearance_not_read),
               .without_it = "nothing",
               .meaning = "What could not be read of it.",
               .source = "Talus"},
          }};
}

Table source() {
  return {.key = "source",
          .repeated = true,
          .required = true,
          .meaning = "Where values are from.",
          .settings = {
              {.key = "key",
               .slot = declared::member(&FactorSource::key),
               .required = true,
               .meaning = "By which factors refer to it.",
               .source = "Talus"},
              {.key = "text",
               .slot = declared::member(&FactorSource::text),
               .required = true,
               .meaning = "The publication.",
               .source = "Talus"},
              {.key = "checked",
               .slot = declared::member(&FactorSource::checked),
               .required = true,
               .meaning = "What of it was read.",
               .source = "Talus"},
          }};
}

Table factor() {
  return {.key = "factor",
          .repeated = true,
          .required = true,
          .meaning = "A partial factor.",
          .settings = {
              {.key = "key",
               .slot = declared::member(&Factor::key),
               .required = true,
               .meaning = "Its name. If [design] has the same key, the project may give another value.",
               .source = "Talus"},
              {.key = "symbol",
               .slot = declared::member(&Factor::symbol),
               .required = true,
               .meaning = "Its symbol in the source.",
               .source = "Talus"},
              {.key = "multiplies",
               .slot = declared::member(&Factor::multiplies),
               .required = true,
               .most_entries = multiplied_quantities.size(),
               .meaning = "What it multiplies.",
               .source = "Talus"},
              {.key = "value",
               .slot = declared::member(&Factor::value),
               .range = declared::factor_of_safety,
               .without_it = "the project gives it",
               .meaning = "Its value.",
               .source = "Talus"},
              {.key = "value_with_sel",
               .slot = declared::member(&Factor::value_with_sel),
               .range = declared::factor_of_safety,
               .without_it = "`value`",
               .meaning = "Its value if the check is of the SEL.",
               .source = "Talus"},
              {.key = "meaning",
               .slot = declared::member(&Factor::meaning),
               .required = true,
               .meaning = "What it stands for.",
               .source = "Talus"},
              {.key = "usual",
               .slot = declared::member(&Factor::usual),
               .without_it = "unknown",
               .meaning = "Its usual values, and when they hold.",
               .source = "Talus"},
              {.key = "source",
               .slot = declared::member(&Factor::source),
               .required = true,
               .meaning = "Key of the source of its values.",
               .source = "Talus"},
              {.key = "not_read",
               .slot = declared::member(&Factor::not_read),
               .without_it = "nothing",
               .meaning = "What could not be read in the source.",
               .source = "Talus"},
          }};
}

}  // namespace

const std::vector<Table>& factor_set_tables() {
  static const std::vector<Table> all{head(), source(), factor()};
  return all;
}

}  // namespace talus::project
