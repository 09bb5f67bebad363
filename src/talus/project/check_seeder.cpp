#include "talus/project/check_seeder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "talus/files/file_formats.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

std::string_view SeederRules::refuse(std::string_view key, std::string what, std::string why, std::string hint) const {
  const toml::node* node = row.get(key);
  report(node || key.empty() ? Spot(node ? node : &row) : Spot(&row, &row, key), std::move(what), std::move(why),
         std::move(hint), Severity::error);
  return key;
}

bool SeederRules::misses(std::string_view key) const { return !has(key) && !is_mistyped(table("seeder"), row, key); }

void SeederRules::check() const {
  if (type_is_known && seeder.is_of_cells()) check_cells();
  check_files();
  if (seeder.type != SeederType::table && misses("mass_kg") && misses("volume_m3") && misses("diameter_m")) {
    refuse("mass_kg", "the size of the rocks is missing", "expected one of mass_kg, volume_m3 and diameter_m");
  }
}

std::string_view SeederRules::check_place() const {
  if (!type_is_known) return "type";
  const bool has_position = has("position"), has_points = has("points"), has_lines = has("lines");
  const std::string_view polygon = has("polygons") ? "polygons" : has("polygon") ? "polygon" : "";
  if (is_2d && seeder.is_of_cells()) {
    return refuse("type", fmt::format("type is \"{}\" in 2D", word(seeder.type)), "a section has no area",
                  "Use a point or a line, or give terrain.width_m for 3D");
  }
  switch (seeder.type) {
    case SeederType::point:
      if (has_position) return "";
      if (has("table")) {
        return refuse("table", "a table is given for a point", "every row of a table is a place",
                      "Write type = \"table\"");
      }
      if (has_points || has_lines) {
        const std::string_view key = has_points ? "points" : "lines";
        return refuse(key, fmt::format("{} are given for a point", key), "they belong to a line",
                      "Write type = \"line\"");
      }
      if (!polygon.empty()) {
        return refuse(polygon, "a polygon is given for a point", "a polygon is an area", "Write type = \"polygon\"");
      }
      if (!misses("position")) return "";
      return refuse("position", "position is missing", "a point seeder needs it");
    case SeederType::line:
      if (has_points || has_lines) return "";
      if (has_position) {
        return refuse("position", "position is given for a line", "a line seeder needs two or more points",
                      "Write points = [..., ...]");
      }
      if (!misses("points") || !misses("lines")) return "";
      return refuse("points", "points is missing", "a line seeder needs two or more points",
                    "Or name a file: lines = \"cliff.gpkg\"");
    case SeederType::polygon:
      if (!polygon.empty()) return "";
      if (!misses("polygons") || !misses("polygon")) return "";
      return refuse("polygons", "polygons is missing", "a polygon seeder needs polygons or polygon",
                    "Write polygons = \"cliffs.gpkg\", or polygon = [[x, y], ...]");
    case SeederType::table:
      if (has("table") || !misses("table")) return "";
      return refuse("table", "table is missing", "a table seeder needs the file of its releases",
                    "Write table = \"releases.csv\"");
    case SeederType::raster:
      break;
  }
  if (!polygon.empty()) {
    return refuse(polygon, "a polygon is given for a raster", "slope limits and masks also apply to polygons",
                  "Write type = \"polygon\"");
  }
  if (!misses("mask") || !misses("min_slope_deg") || !misses("max_slope_deg")) return "";
  return refuse("", "the cells are not specified", "a raster seeder needs a slope or a mask",
                "Write min_slope_deg = 45, or mask = \"release.tif\"");
}

void SeederRules::check_cells() const {
  const InCells& cells = seeder.in_cells;
  if (accepted("min_slope_deg") && accepted("max_slope_deg") && *cells.min_slope_deg > *cells.max_slope_deg) {
    refuse("max_slope_deg", fmt::format("max_slope_deg is {:g}", *cells.max_slope_deg),
           fmt::format("min_slope_deg is {:g}, so no cell can meet both", *cells.min_slope_deg));
  }
  if (!has_grid && !is_2d && misses("cell_m")) {
    refuse("cell_m", "cell_m is missing", "the terrain is not a raster, so it has no cells of its own",
           "Give the size of the cells from which rocks start, in metres");
  }
}

void SeederRules::check_files() const {
  const std::filesystem::path& table = seeder.from_table.file;
  const auto check_file = [&](std::string_view key, const std::filesystem::path& file) {
    if (!accepted(key)) return;
    const std::string why = why_unreadable(project, file);
    if (why.empty()) return;
    refuse(key, fmt::format("{} is \"{}\"", key, file.string()), why, "The path is relative to the project file");
  };
  check_file("lines", seeder.along_lines.file);
  check_file("polygons", seeder.in_cells.polygons);
  check_file("mask", seeder.in_cells.mask);
  check_file("table", table);
  if (!accepted("table") || seeder.type != SeederType::table) return;
  const bool is_text = is_of_kind(table, FileKind::point_text);
  if (!is_text && is_2d) {
    refuse("table", fmt::format("table is \"{}\" in 2D", table.string()), "a section has no position on a map",
           "Name a text file (" + endings_in_words(FileKind::point_text) + ") with columns x_m and z_m");
  }
  if (is_text && accepted("layer"))
    refuse("layer", "layer is given for a text file", "it has no layers", "Leave it out");
}

}  // namespace talus::project
