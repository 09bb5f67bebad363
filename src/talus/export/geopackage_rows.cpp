#include "talus/export/geopackage_rows.hpp"

#include <fmt/format.h>

#include "talus/archive/design_tables.hpp"

namespace talus {

std::string BarrierLayerRow::column(const HitQuantity& quantity, std::string_view part) {
  return fmt::format("{}_{}_{}", quantity.name, part, quantity.unit_in_name);
}

std::vector<ColumnText> BarrierLayerRow::family_texts() {
  std::vector<ColumnText> texts;
  for (const HitQuantity& quantity : hit_quantities)
    texts.push_back({column(quantity, "…"), std::string(quantity.unit),
                     fmt::format("{}: `p95`, `p99` and `max`; null without a hit", quantity.meaning)});
  return texts;
}

std::vector<ColumnText> DesignLayerRow::family_texts() {
  std::vector<ColumnText> texts;
  for (const DesignQuantity& quantity : design_quantities)
    texts.push_back({design_column(quantity, "…"), std::string(quantity.unit),
                     fmt::format("{}: each of `percentiles`", quantity.meaning)});
  texts.push_back({"needs_energy_J", "J", "maximum energy level that the check asks for"});
  texts.push_back({"needs_class", "", "energy class that it asks for"});
  texts.push_back({"needs_height_m", "m", "nominal height that it asks for: at least that of the block's top"});
  return texts;
}

}  // namespace talus
