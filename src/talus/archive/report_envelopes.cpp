#include "talus/archive/report_envelopes.hpp"

#include <algorithm>
#include <string_view>

#include "talus/archive/envelope_table.hpp"

namespace talus {
namespace {

constexpr std::string_view shown_columns[] = {"reach_share", "energy_total_", "velocity_", "bounce_height_"};

bool is_shown(std::string_view column) {
  return std::ranges::any_of(shown_columns, [&](std::string_view name) { return column.starts_with(name); });
}

std::uint64_t rows_of(const std::filesystem::path& file) {
  std::uint64_t rows = 0;
  for (TableReader<EnvelopeRow> row(file); row.next();) ++rows;
  return rows;
}

}  // namespace

ReportEnvelopes read_report_envelopes(const std::filesystem::path& file) {
  TableReader<EnvelopeRow> row(file);
  ReportEnvelopes out;
  const auto names = row.family_names();
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!is_shown(names[k])) continue;
    places.push_back(k);
    out.columns.push_back(names[k]);
  }
  out.cells_each = rows_of(file) / (most_report_envelope_cells + 1) + 1;
  for (std::uint64_t k = 0; row.next(); ++k) {
    const double x_m = row.get<&EnvelopeRow::x_m>();
    if (k % out.cells_each == 0)
      out.cells.push_back({.from_x_m = x_m, .values = decltype(out.cells[0].values)(places.size())});
    auto& cell = out.cells.back();
    cell.to_x_m = x_m;
    const FamilyValues values = row.get<&EnvelopeRow::values>();
    // An empty optional compares less than any value.
    for (std::size_t n = 0; n < places.size(); ++n) cell.values[n] = std::max(cell.values[n], values[places[n]]);
  }
  return out;
}

}  // namespace talus
