#pragma once
// uncertainty.csv: the figures of a run with uncertain parameters, with their ranges.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>

#include "talus/archive/uncertainty.hpp"
#include "talus/files/csv_table.hpp"

namespace talus {

/// A row of uncertainty.csv: a figure of the whole run, or at a line.
struct UncertaintyRow {
  static constexpr const char* file_name = "uncertainty.csv";

  std::string figure{};
  std::optional<double> percentile{};
  std::string line{}, unit{};
  std::uint64_t ensembles = 0;
  double value = 0;
  std::optional<double> low{}, high{}, parameters_low{}, parameters_high{}, rocks_low{}, rocks_high{};
  double parameter_part = 0;

  static constexpr auto columns() {
    using R = UncertaintyRow;
    return std::tuple(
        word("figure",
             "`runout`, `max_energy`, `max_bounce` of each rock; at a line the `share` of rocks that reach it, and "
             "their "
             "`energy`, `velocity` and `height`",
             &R::figure),
        quantity("percentile", "%", "which percentile of the rocks it is; empty for a share", &R::percentile),
        word("line", "barrier or collector; empty: of the whole run", &R::line),
        word("figure_unit", "unit of the following values: m, J, m/s; empty for a share", &R::unit),
        quantity("ensembles", "", "ensembles that have a value", &R::ensembles),
        quantity("value", "", "figure of all rocks", &R::value),
        quantity("low", "", "5 % of the ensembles have less: lower end of both parts together", &R::low),
        quantity("high", "", "5 % of the ensembles have more: upper end", &R::high),
        quantity("parameters_low", "", "lower end if only the parameters varied", &R::parameters_low),
        quantity("parameters_high", "", "upper end", &R::parameters_high),
        quantity("rocks_low", "", "lower end if only the rocks of an ensemble varied", &R::rocks_low),
        quantity("rocks_high", "", "upper end", &R::rocks_high),
        quantity("parameter_part", "", "part of the parameters in the variance between ensembles, 0 to 1",
                 &R::parameter_part));
  }
};

[[nodiscard]] std::string uncertainty_table(const Uncertainty& uncertainty);

/// Writes the table into a run's folder; throws BadInput if that fails.
void write_uncertainty(const std::filesystem::path& folder, const Uncertainty& uncertainty);
void remove_uncertainty(const std::filesystem::path& folder);

}  // namespace talus
