#pragma once
// [[seeder]] of a project: a struct for each way to place releases, with the settings that it alone has; and the size
// of the rocks. A project that was read has the way of the seeder's type. Paths are as written in the file, relative to
// the project file.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "talus/project/shape.hpp"
#include "talus/sampling/distribution.hpp"
#include "talus/seeding/release_cells.hpp"
#include "talus/seeding/seeder.hpp"

namespace talus::project {

/// A property with a fixed value.
[[nodiscard]] inline Distribution constant(double value) {
  Distribution distribution;
  distribution.mean = value;
  return distribution;
}

/// `position`, or `points` of a line.
struct AtPoints {
  std::vector<std::array<double, 3>> points;  // one for a point, two or more for a line; 2D: y = 0
  bool z_is_surface = false;                  // their z was given as "surface"
};

/// `lines`: a file.
struct AlongLines {
  std::filesystem::path file;
};

/// The cells of a raster or, if they are given, those inside polygons.
struct InCells {
  std::filesystem::path polygons;
  std::vector<std::array<double, 2>> polygon;  // on plan, instead of polygons
  std::optional<double> min_slope_deg, max_slope_deg;
  std::filesystem::path mask;              // a raster that selects cells
  std::optional<std::int64_t> mask_value;  // the selected value; without it, all but 0
  std::optional<double> cell_m;            // size of a cell if the terrain is not a raster
  PlaceInCell place = PlaceInCell::random;
  std::optional<std::int64_t> rocks_per_cell;  // instead of rocks

  [[nodiscard]] bool has_polygons() const { return !polygons.empty() || !polygon.empty(); }
};

/// `table`: a file with a release in each row.
struct FromTable {
  std::filesystem::path file;
  std::string name_attribute;                 // empty: `name`, if there is one
  std::optional<std::int64_t> rocks_per_row;  // instead of rocks; without either: 1
};

/// The way that a seeder has, of those in its Seeder.
using ReleaseWay = std::variant<std::reference_wrapper<const AtPoints>, std::reference_wrapper<const AlongLines>,
                                std::reference_wrapper<const InCells>, std::reference_wrapper<const FromTable>>;

/// `mass_kg`, `volume_m3` or `diameter_m`.
struct RockSize {
  SizeOf of = SizeOf::mass;
  Distribution distribution;

  [[nodiscard]] std::string_view key() const {
    return of == SizeOf::mass ? "mass_kg" : of == SizeOf::volume ? "volume_m3" : "diameter_m";
  }
};

enum class SeederType { point, line, polygon, raster, table };

/// Has a place for every setting, so that one with two ways is read to its end and refused with all its problems.
struct Seeder {
  std::string name;    // default: "seeder N"
  std::string source;  // default: the name
  SeederType type = SeederType::point;
  AtPoints at_points;
  AlongLines along_lines;
  InCells in_cells;
  FromTable from_table;
  std::optional<double> height_above_m;  // above the surface, instead of z
  std::string layer;                     // of the file of lines, polygons or points
  std::string source_attribute;          // of its features or rows: its values are the sources of the rocks
  std::int64_t rocks = 1;
  std::optional<RockSize> size;  // nullopt: the rows of the table give it
  Distribution density_kg_m3 = constant(2700);
  Distribution horizontal_velocity_m_s = constant(0);
  Distribution vertical_velocity_m_s = constant(0);           // positive up
  std::optional<Distribution> speed_m_s;                      // along the full `direction`, instead of the two above
  Distribution rotational_velocity_deg_s = constant(0);       // positive: rolling forwards, about up x direction
  std::optional<std::array<double, 3>> direction{{1, 0, 0}};  // nullopt: downslope
  std::string shape{sphere_word};                             // of a rigid body
  std::optional<std::vector<double>> orientation_deg;         // of release: three turns, in 2D one; nullopt: random
  int line = 0;                                               // in the project file, for later messages

  /// What the releases are made from. Valid as long as the seeder.
  [[nodiscard]] ReleaseWay way() const;
  [[nodiscard]] bool is_of_cells() const { return type == SeederType::polygon || type == SeederType::raster; }
};

}  // namespace talus::project
