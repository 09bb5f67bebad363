#include "folder_tables.hpp"

#include <algorithm>
#include <limits>

#include "talus/core/stop.hpp"
#include "talus/maps/map_reading.hpp"

namespace talus::python {

template <TableRow Row>
PackedRows rows_of_folder(const std::filesystem::path& folder) {
  TableReader<Row> reader(folder / Row::file_name);
  std::vector<Row> rows;
  std::size_t width = 1;  // of all texts
  while (reader.next()) {
    stop_point(rows.size());
    const Row& row = rows.emplace_back(reader.whole());
    for_values<Row>(row, [&]<class Value>(const Value& value) {
      if constexpr (std::is_same_v<Value, std::string>) width = std::max(width, width_of(std::span(&value, 1)));
    });
  }
  PackedRows table{layout_of<Row>([&](std::string_view) { return width; }), {}};
  table.bytes.reserve(rows.size() * table.layout.size);
  for (const Row& row : rows) pack(row, table.layout, table.bytes);
  return table;
}

template PackedRows rows_of_folder<EndpointRow>(const std::filesystem::path&);
template PackedRows rows_of_folder<HitRow>(const std::filesystem::path&);
template PackedRows rows_of_folder<PathEventRow>(const std::filesystem::path&);
template PackedRows rows_of_folder<ImpactRow>(const std::filesystem::path&);

PackedRows packed(const EnvelopeTable& table) {
  PackedRows rows{layout_of<EnvelopeRow>([](std::string_view) { return 1; }, table.names), {}};
  for (const EnvelopeRow& row : table.rows) pack(row, rows.layout, rows.bytes);
  return rows;
}

PackedRows envelopes_of_folder(const std::filesystem::path& folder) {
  TableReader<EnvelopeRow> reader(folder / EnvelopeRow::file_name);
  EnvelopeTable table;
  for (const std::string& name : reader.family_names()) table.names.push_back(name);
  while (reader.next()) table.rows.push_back({reader.get<&EnvelopeRow::x_m>(), reader.get<&EnvelopeRow::values>()});
  return packed(table);
}

std::vector<std::string> maps_of_folder(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (MapFile& map : maps_of_run(folder)) names.push_back(std::move(map.name));
  return names;
}

std::optional<MapArray> read_map_of_folder(const std::filesystem::path& folder, const std::string& name) {
  const std::vector<MapFile> maps = maps_of_run(folder);
  const auto file = std::ranges::find(maps, name, &MapFile::name);
  if (file == maps.end()) return std::nullopt;
  MapValues from_south = read_map(folder, *file, std::numeric_limits<int>::max());
  const std::vector<MapKind> kinds = map_kinds({.percentiles = {}, .bands = banded_map_subjects});
  const std::string plain = name.substr(name.rfind('/') + 1);
  const auto kind = std::ranges::find(kinds, plain, &MapKind::name);
  MapArray map{.unit = file->unit,
               .meaning = file->meaning,
               .is_count = kind != kinds.end() && kind->is_count,
               .limits = file->limits};
  map.columns = from_south.columns;
  map.rows = from_south.rows;
  map.cell = from_south.cell;
  map.corner = {from_south.origin[0], from_south.origin[1] + from_south.rows * from_south.cell[1]};
  map.values.reserve(from_south.values.size());
  for (int row = map.rows; row-- > 0;) {
    const auto line = from_south.values.begin() + static_cast<std::ptrdiff_t>(row) * map.columns;
    map.values.insert(map.values.end(), line, line + map.columns);
  }
  return map;
}

}  // namespace talus::python
