#pragma once
// Answers to what if for people and programs: what_if.csv and JSON (docs/ask-the-line.md describes both).

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "talus/files/csv_table.hpp"
#include "talus/lines/what_if.hpp"

namespace talus::what_if {

/// A row of what_if.csv: the project's own values, or a variation. What is not known, for too few rocks, is empty.
struct WhatIfRow {
  static constexpr const char* file_name = "what_if.csv";

  std::string factor{}, changes{}, clipped{};
  std::optional<double> step_percent{};
  std::uint64_t rocks = 0, crossing = 0;
  std::optional<std::uint64_t> gained{}, lost{};
  FamilyValues figures{};  // by figure: value and interval, and the change with its interval
  std::optional<double> needs_mel_kJ{};
  std::optional<std::uint64_t> needs_class{};
  std::optional<double> needs_height_m{};
  std::optional<double> runout_median_m{}, runout_m{}, left{};

  static constexpr auto columns() {
    using R = WhatIfRow;
    return std::tuple(
        word("factor", "what is varied; `base`: the project's own values", &R::factor),
        quantity("step_percent", "%", "by how much", &R::step_percent),
        word("changes", "the values before and after, by material or seeder, in the units of the project file",
             &R::changes),
        word("clipped", "values that end at the limit of their range", &R::clipped),
        quantity("rocks", "", "rocks of each set", &R::rocks),
        quantity("crossing", "", "rocks that cross the line, or enter the polygon", &R::crossing),
        quantity("gained", "", "rocks that cross with the variation and not without it", &R::gained),
        quantity("lost", "", "rocks that cross without the variation and not with it", &R::lost), family(&R::figures),
        quantity("needs_mel_kJ", "kJ", "maximum energy level that the check asks for at the line, with all factors",
                 &R::needs_mel_kJ),
        quantity("needs_class", "", "energy class that it asks for", &R::needs_class),
        quantity("needs_height_m", "m", "nominal height that it asks for", &R::needs_height_m),
        quantity("runout_median_m", "m", "median of the runout on plan, of all rocks", &R::runout_median_m),
        quantity("runout_m", "m", "its design percentile", &R::runout_m),
        quantity("left", "", "share of the rocks that leave the model", &R::left));
  }
  [[nodiscard]] static std::vector<ColumnText> family_texts();
};

[[nodiscard]] std::string table_of(const WhatIf& what_if, const Answer& answer);
[[nodiscard]] nlohmann::ordered_json json_of(const WhatIf& what_if, const Answer& answer);

}  // namespace talus::what_if
