#include "talus/report/observed_stops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <span>

#include "talus/files/data_table.hpp"
#include "talus/files/first_problems.hpp"
#include "talus/import/vector_file.hpp"

namespace talus {

namespace {

constexpr double far_off_the_ground = 1;  // [m]

bool is_table(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".csv" || ending == ".txt" || ending == ".tsv";
}

[[noreturn]] void refuse(const std::filesystem::path& file, std::string what, std::string why, std::string hint) {
  throw BadInput(Problem{
      .file = file.string(), .where = {}, .what = std::move(what), .why = std::move(why), .hint = std::move(hint)});
}

/// A column by any of its usual names, in the form of plain_column_name.
std::optional<std::size_t> column_of(const DataTable& table, std::span<const std::string_view> names) {
  for (std::size_t k = 0; k < table.columns().size(); ++k) {
    if (std::ranges::find(names, plain_column_name(table.columns()[k])) != names.end()) return k;
  }
  return std::nullopt;
}

constexpr std::array<std::string_view, 4> x_names{"x", "x_m", "east", "easting"};
constexpr std::array<std::string_view, 4> y_names{"y", "y_m", "north", "northing"};
constexpr std::array<std::string_view, 5> z_names{"z", "z_m", "height", "elevation", "altitude"};
constexpr std::array<std::string_view, 4> name_names{"name", "id", "rock", "block"};
constexpr std::array<std::string_view, 2> mass_names{"mass", "mass_kg"};

std::vector<ObservedStop> stops_of_table(const std::filesystem::path& file, bool is_section) {
  DataTable table(file);
  const auto x = column_of(table, x_names), y = column_of(table, y_names), z = column_of(table, z_names),
             name = column_of(table, name_names), mass = column_of(table, mass_names);
  if (!x || (!y && !is_section)) {
    std::string columns;
    for (const std::string& each : table.columns()) columns += (columns.empty() ? "" : ", ") + each;
    refuse(
        file, fmt::format("has no column {}", x ? "y" : "x"), fmt::format("its columns are {}", columns),
        is_section ? "Name the columns in the first line: x, or x and z" : "Name the columns in the first line: x, y");
  }
  const auto number = [&](std::size_t column) -> std::optional<double> {
    const auto value = number_in_cell(table.text(column), table.comma_is_point());
    if (value && std::isfinite(*value)) return value;
    table.refuse(fmt::format("{} is \"{}\"", table.columns()[column], table.text(column)), "expected a number",
                 table.text(column).empty() ? "Leave out the row" : "");
    return std::nullopt;
  };
  const auto number_if_any = [&](std::optional<std::size_t> column) -> std::optional<double> {
    return column && !table.text(*column).empty() ? number(*column) : std::nullopt;
  };
  std::vector<ObservedStop> stops;
  while (table.next()) {
    ObservedStop& stop = stops.emplace_back();
    stop.x_m = number(*x).value_or(0);
    if (!is_section) stop.y_m = number(*y).value_or(0);
    stop.z_m = number_if_any(z);
    stop.mass_kg = number_if_any(mass);
    if (name) stop.name = table.text(*name);
    stop.origin = table.line();
  }
  table.throw_if_any();
  return stops;
}

std::vector<ObservedStop> stops_of_points(const std::filesystem::path& file, const RunSummary& run,
                                          Problems& warnings) {
  VectorRequest request;
  request.kinds = {ShapeKind::point};
  request.heights_are_used = true;
  request.terrain_crs_wkt = run.terrain.crs_wkt;
  const VectorLayer layer = read_vector_file(file, request, warnings);
  std::vector<ObservedStop> stops;
  for (const VectorFeature& feature : layer.features) {
    for (const VectorShape& part : feature.parts) {
      const Vec3& p = part.lists.front().front();
      ObservedStop& stop = stops.emplace_back();
      stop.x_m = p.x();
      stop.y_m = p.y();
      if (feature.has_z) stop.z_m = p.z();
      stop.origin = static_cast<int>(feature.id);
    }
  }
  return stops;
}

/// The lowest and highest ground at and around a place, as far as the summary has it.
struct GroundRange {
  double low, high;
};

std::optional<GroundRange> ground_at(const TerrainSummary& terrain, double x, double y) {
  std::optional<GroundRange> range;
  const auto add = [&](double z) {
    range = range ? GroundRange{std::min(range->low, z), std::max(range->high, z)} : GroundRange{z, z};
  };
  for (std::size_t k = 0; k + 1 < terrain.section.size(); ++k) {
    const auto& [x0, z0] = terrain.section[k];
    const auto& [x1, z1] = terrain.section[k + 1];
    if (x < std::min(x0, x1) || x > std::max(x0, x1)) continue;
    if (x0 == x1) {
      add(z0);
      add(z1);
    } else {
      add(z0 + (z1 - z0) * (x - x0) / (x1 - x0));
    }
  }
  if (!terrain.relief) return range;
  const Relief& relief = *terrain.relief;
  const double i = std::floor((x - relief.x0) / relief.cell_m), j = std::floor((y - relief.y0) / relief.cell_m);
  for (const double column : {i, i + 1}) {
    for (const double row : {j, j + 1}) {
      if (column < 0 || row < 0 || column >= static_cast<double>(relief.columns) ||
          row >= static_cast<double>(relief.rows))
        continue;
      const auto at = static_cast<std::size_t>(row) * relief.columns + static_cast<std::size_t>(column);
      if (relief.z_m[at]) add(*relief.z_m[at]);
    }
  }
  return range;
}

void check_places(const std::filesystem::path& file, bool are_features, const std::vector<ObservedStop>& stops,
                  const TerrainSummary& terrain) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> low{infinity, infinity}, high{-infinity, -infinity};
  for (const auto& [x, z] : terrain.section) low[0] = std::min(low[0], x), high[0] = std::max(high[0], x);
  for (const auto& corner : terrain.bounds) {
    for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], corner[k]), high[k] = std::max(high[k], corner[k]);
  }
  if (low[0] > high[0]) return;  // the summary does not say where the terrain is
  const bool is_section = terrain.bounds.empty();
  FirstProblems problems(file.string(), are_features ? "features" : "rows");
  for (const ObservedStop& stop : stops) {
    const bool is_inside =
        stop.x_m >= low[0] && stop.x_m <= high[0] && (is_section || (stop.y_m >= low[1] && stop.y_m <= high[1]));
    if (is_inside) continue;
    const bool may_be_degrees = std::abs(stop.x_m) <= 180 && std::abs(stop.y_m) <= 90 && !is_section &&
                                std::max(std::abs(low[0]), std::abs(high[0])) > 1000;
    problems.add(are_features ? 0 : stop.origin,
                 is_section ? fmt::format("a stop at x = {:.10g} is outside the terrain", stop.x_m)
                            : fmt::format("a stop at ({:.10g}, {:.10g}) is outside the terrain", stop.x_m, stop.y_m),
                 is_section ? fmt::format("which reaches from x = {:.10g} to {:.10g}", low[0], high[0])
                            : fmt::format("which reaches from ({:.10g}, {:.10g}) to ({:.10g}, {:.10g})", low[0], low[1],
                                          high[0], high[1]),
                 may_be_degrees ? "These look like degrees; give coordinates in the system of the terrain, in metres"
                                : "Check the coordinate system, and the order of x and y");
  }
  problems.throw_if_any();
}

void warn_of_heights(const std::filesystem::path& file, const std::vector<ObservedStop>& stops,
                     const TerrainSummary& terrain, Problems& warnings) {
  std::size_t count = 0, with_z = 0;
  double most = 0;
  for (const ObservedStop& stop : stops) {
    if (!stop.z_m) continue;
    ++with_z;
    const auto ground = ground_at(terrain, stop.x_m, stop.y_m);
    if (!ground) continue;
    const double off = std::max({0.0, ground->low - *stop.z_m, *stop.z_m - ground->high});
    count += off > far_off_the_ground ? 1 : 0;
    most = std::max(most, off);
  }
  if (count == 0) return;
  warnings.add({.severity = Severity::warning,
                .file = file.string(),
                .where = {},
                .what = fmt::format("{} of {} stops with a height are more than {:g} m off the terrain, up to {:.1f} m",
                                    count, with_z, far_off_the_ground, most),
                .why = "another datum, or another state of the terrain",
                .hint = "Only their places on plan are compared; check these if x and y come from the same source"});
}

}  // namespace

ObservedStops read_observed_stops(const std::filesystem::path& file, const RunSummary& run, Problems& warnings) {
  const bool is_section = run.terrain.kind == "section", is_text = is_table(file);
  if (is_section && !is_text) {
    refuse(file, "is not a table", "a section has x, but no coordinates on plan",
           "Give a table (.csv) with a column x, and z if you like");
  }
  ObservedStops observed{file, is_text ? stops_of_table(file, is_section) : stops_of_points(file, run, warnings)};
  if (observed.stops.empty()) refuse(file, "has no stops", "it has no rows", "Write one row for each stop");
  if (observed.stops.size() > most_observed_stops) {
    refuse(file, fmt::format("has {} stops", observed.stops.size()),
           fmt::format("a report compares at most {}", most_observed_stops), "Choose some of them");
  }
  check_places(file, !is_text, observed.stops, run.terrain);
  warn_of_heights(file, observed.stops, run.terrain, warnings);
  return observed;
}

}  // namespace talus
