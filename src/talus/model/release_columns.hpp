#pragma once
// The columns that a table of releases may have, declared once: names, units, ranges. The reader and the reference in
// docs/gis.md use this list.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/files/csv_table.hpp"
#include "talus/files/first_problems.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

enum class ReleaseColumn {
  x,
  y,
  z,
  height_above,
  mass,
  volume,
  diameter,
  radius,
  density,
  vx,
  vy,
  vz,
  speed,
  horizontal,
  vertical,
  azimuth,
  plunge,
  wx,
  wy,
  wz,
  spin,
  axis_a,
  axis_b,
  axis_c
};
inline constexpr std::size_t release_column_count = 24;

struct ReleaseColumnFacts {
  ReleaseColumn column;
  std::string_view stem, unit;  // the name is stem_unit
  std::string_view unit_text;   // as in the documentation
  std::string_view setting;     // of [[seeder]], in whose range and unit the values are; empty: `range`
  Range range;
  std::string_view meaning;

  [[nodiscard]] std::string name() const { return std::string(stem) + '_' + std::string(unit); }
  [[nodiscard]] const Range& permitted() const;
};

/// In the order of ReleaseColumn.
[[nodiscard]] std::span<const ReleaseColumnFacts> release_columns();
[[nodiscard]] const ReleaseColumnFacts& facts_of(ReleaseColumn column);

/// For the documentation.
[[nodiscard]] std::vector<ColumnText> release_column_texts();

/// Where each column is in a file: of its columns or attributes.
struct FoundColumns {
  std::array<std::optional<std::size_t>, release_column_count> places;
  std::optional<std::size_t> name, source;
  std::vector<std::string> used, unused;  // as named in the file
  std::vector<std::string> doubtful;      // unused ones that a letter or two separate from a known one: "x (y)"

  [[nodiscard]] bool has(ReleaseColumn column) const { return places[static_cast<std::size_t>(column)].has_value(); }
};

struct ColumnRequest {
  std::string name_column, source_column;  // as the project names them; empty: `name` if there is one, none
  bool is_2d = false;
  bool has_geometry = false;  // x and y are those of the points
  bool has_axes = false;      // axes of blocks are read: rocks are rigid bodies in 3D
  /// Names were cut to ten letters, as in a Shapefile.
  bool are_cut = false;
};

/// Finds the columns by their names. Problems are added: names in another unit or without one, columns that exclude
/// each other, no place, a named column that is missing.
[[nodiscard]] FoundColumns find_release_columns(std::span<const std::string> names, const ColumnRequest& request,
                                                FirstProblems& problems);

}  // namespace talus::project
