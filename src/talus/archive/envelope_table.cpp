#include "talus/archive/envelope_table.hpp"

#include <optional>
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

std::string envelope_table(const Maps& maps, const MapSelection& selection, bool has_heights) {
  MapSelection shown = selection;
  if (!has_heights) shown.subjects = without(MapQuantity::bounce_height, shown.subjects);
  const std::vector<MapGroup> groups = map_groups(maps.rocks(), shown);
  std::vector<MapKind> kinds;
  for (const MapGroup& group : groups) kinds.insert(kinds.end(), group.kinds.begin(), group.kinds.end());
  std::vector<std::string> names;
  for (const MapKind& kind : kinds) names.push_back(kind.name);
  std::string text = header_of<EnvelopeRow>(names);

  const auto extent = maps.extent();
  if (!extent) return text;
  std::vector<std::optional<MapTally>> cells(static_cast<std::size_t>(extent->last.column - extent->first.column) + 1);
  for (const Maps::Tile* tile : maps.tiles()) {
    for (std::int32_t k = 0; k < Maps::tile_side; ++k) {
      const auto tally = tile->find(k, extent->first.row - tile->first().row);
      if (tally) cells[static_cast<std::size_t>(tile->first().column + k - extent->first.column)] = tally;
    }
  }
  EnvelopeRow row;
  std::vector<double> values;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    row.x_m = maps.grid().origin().x() + (extent->first.column + static_cast<double>(k) + 0.5) * maps.grid().cell().x();
    row.values.clear();
    if (cells[k]) {
      for (const MapGroup& group : groups) {
        values.assign(group.kinds.size(), 0);
        group.values(*cells[k], values);
        row.values.insert(row.values.end(), values.begin(), values.end());
      }
    } else {
      for (const MapKind& kind : kinds) row.values.push_back(kind.is_count ? std::optional(0.0) : std::nullopt);
    }
    append_row(text, row);
  }
  return text;
}

void write_envelopes(const std::filesystem::path& folder, const Maps& maps, const MapSelection& selection,
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
