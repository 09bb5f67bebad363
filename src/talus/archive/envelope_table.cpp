#include "talus/archive/envelope_table.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "talus/files/output_file.hpp"
#include "talus/maps/map_list.hpp"

namespace talus {

std::vector<ColumnText> EnvelopeRow::family_texts() {
  std::vector<ColumnText> texts;
  for (MapKind& kind : map_families()) texts.push_back({std::move(kind.name), kind.unit, std::move(kind.meaning)});
  return texts;
}

EnvelopeTable envelopes_of(const MapsOfRun& maps, const MapSelection& selection, bool has_heights) {
  MapSelection shown = selection;
  if (!has_heights) {
    shown.subjects = without(MapQuantity::bounce_height, shown.subjects);
    shown.bands = without(MapQuantity::bounce_height, shown.bands);
  }
  const std::vector<MapGroup> groups = map_groups(shown);
  std::vector<MapKind> kinds;
  for (const MapGroup& group : groups) kinds.insert(kinds.end(), group.kinds.begin(), group.kinds.end());
  EnvelopeTable table;
  for (const MapKind& kind : kinds) table.names.push_back(kind.name);
  const auto extent = maps.all.extent();
  if (!extent) return table;
  if (extent->first.row != extent->last.row) throw std::logic_error("a rock has left the plane of its section");
  FamilyValues untouched;
  for (const MapKind& kind : kinds) untouched.push_back(kind.is_count ? std::optional(0.0) : std::nullopt);
  const auto place_of = [&](std::int32_t column) { return static_cast<std::size_t>(column - extent->first.column); };
  std::vector<FamilyValues> cells(place_of(extent->last.column) + 1, untouched);
  std::vector<double> values;
  MapCells reader(maps, shown.bands.any());
  for (const Maps::Tile* tile : maps.all.tiles()) {
    reader.enter(*tile);
    for (std::int32_t k = 0; k < Maps::tile_side; ++k) {
      const auto cell = reader.find(k, extent->first.row - tile->first().row);
      if (!cell) continue;
      FamilyValues& here = cells.at(place_of(tile->first().column + k));
      here.clear();
      for (const MapGroup& group : groups) {
        values.assign(group.kinds.size(), 0);
        group.values(*cell, values);
        for (const double value : values) here.push_back(std::isnan(value) ? std::nullopt : std::optional(value));
      }
    }
  }
  const MapGrid& grid = maps.all.grid();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    table.rows.push_back({grid.origin().x() + (extent->first.column + static_cast<double>(k) + 0.5) * grid.cell().x(),
                          std::move(cells[k])});
  }
  return table;
}

std::string envelope_table(const MapsOfRun& maps, const MapSelection& selection, bool has_heights) {
  const EnvelopeTable table = envelopes_of(maps, selection, has_heights);
  std::string text = header_of<EnvelopeRow>(table.names);
  for (const EnvelopeRow& row : table.rows) append_row(text, row);
  return text;
}

void write_envelopes(const std::filesystem::path& folder, const MapsOfRun& maps, const MapSelection& selection,
                     bool has_heights) {
  OutputFile file(folder / EnvelopeRow::file_name);
  file.write(envelope_table(maps, selection, has_heights));
  file.commit();
}

void remove_envelopes(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder / EnvelopeRow::file_name, ignored);
}

}  // namespace talus
