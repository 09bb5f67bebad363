#include "talus/archive/uncertainty_table.hpp"

#include <system_error>

#include "talus/files/output_file.hpp"

namespace talus {

std::string uncertainty_table(const Uncertainty& uncertainty) {
  std::string text = header_of<UncertaintyRow>();
  for (const FigureUncertainty& each : uncertainty.figures) {
    const FigureQuantity& quantity = quantity_of(each.figure.of);
    UncertaintyRow row{.figure = std::string(quantity.word),
                       .line = each.line,
                       .unit = std::string(quantity.unit),
                       .ensembles = each.ensembles,
                       .value = each.total.value,
                       .low = each.total.low,
                       .high = each.total.high,
                       .parameters_low = each.parameters.low,
                       .parameters_high = each.parameters.high,
                       .rocks_low = each.rocks.low,
                       .rocks_high = each.rocks.high,
                       .parameter_part = each.parameter_share};
    if (each.figure.of != FigureOf::share) row.percentile = each.figure.percentile;
    append_row(text, row);
  }
  return text;
}

void write_uncertainty(const std::filesystem::path& folder, const Uncertainty& uncertainty) {
  OutputFile file(folder / UncertaintyRow::file_name);
  file.write(uncertainty_table(uncertainty));
  file.commit();
}

void remove_uncertainty(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder / UncertaintyRow::file_name, ignored);
}

}  // namespace talus
