#include "talus/archive/envelope_table.hpp"

#include <optional>
#include <system_error>
#include <vector>

#include "talus/files/csv_text.hpp"
#include "talus/files/output_file.hpp"
#include "talus/maps/map_list.hpp"

namespace talus::io {

std::string envelope_table(const Maps& maps, const MapSelection& selection, bool has_heights) {
  MapSelection shown = selection;
  if (!has_heights) shown.subjects.reset(static_cast<std::size_t>(MapSubject::bounce_height));
  const std::vector<MapGroup> groups = map_groups(maps.rocks(), shown);
  std::string text;
  CsvRow heading(text);
  heading << "x_m";
  for (const MapGroup& group : groups) {
    for (const MapKind& kind : group.kinds) heading << kind.name;
  }
  heading.end();

  const auto extent = maps.extent();
  if (!extent) return text;
  std::vector<std::optional<MapTally>> cells(static_cast<std::size_t>(extent->last.column - extent->first.column) + 1);
  for (const Maps::Tile* tile : maps.tiles()) {
    for (std::int32_t k = 0; k < Maps::tile_side; ++k) {
      const auto tally = tile->find(k, extent->first.row - tile->first().row);
      if (tally) cells[static_cast<std::size_t>(tile->first().column + k - extent->first.column)] = tally;
    }
  }
  std::vector<double> values;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    CsvRow row(text);
    row << maps.grid().origin().x() + (extent->first.column + static_cast<double>(k) + 0.5) * maps.grid().cell().x();
    for (const MapGroup& group : groups) {
      values.assign(group.kinds.size(), 0);
      if (cells[k]) group.values(*cells[k], values);
      for (std::size_t n = 0; n < values.size(); ++n) {
        if (cells[k]) {
          row << values[n];
        } else {
          row << (group.kinds[n].is_count ? "0" : "");
        }
      }
    }
    row.end();
  }
  return text;
}

void write_envelopes(const std::filesystem::path& folder, const Maps& maps, const MapSelection& selection,
                     bool has_heights) {
  OutputFile file(folder / envelopes_name);
  file.write(envelope_table(maps, selection, has_heights));
  file.commit();
}

void remove_envelopes(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder / envelopes_name, ignored);
}

}  // namespace talus::io
