#include "talus/model/release_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

#include "talus/core/nearest.hpp"
#include "talus/files/data_table.hpp"
#include "talus/files/mesh_problems.hpp"
#include "talus/files/mistyped_column.hpp"
#include "talus/files/names_in_words.hpp"

namespace talus::project {

namespace {

constexpr std::string_view given_place = "position", given_speed = "speed_m_s",
                           given_velocity = "horizontal_velocity_m_s";

using enum ReleaseColumn;

const std::array<ReleaseColumnFacts, release_column_count>& columns() {
  static const std::array<ReleaseColumnFacts, release_column_count> list = [] {
    const double most_spin = setting("seeder", "rotational_velocity_deg_s").range.most * std::numbers::pi / 180;
    const Range spin_range{.least = -most_spin, .most = most_spin};
    Range radius_range = setting("seeder", "diameter_m").range;
    radius_range.least /= 2;
    radius_range.most /= 2;
    const Range& axis_range = setting("shape", "axes_m").range;
    return std::array<ReleaseColumnFacts, release_column_count>{{
        {x, "x", "m", "m", given_place, {}, "x of the release; required, except in a file of points"},
        {y, "y", "m", "m", given_place, {}, "y; required in 3D, except in a file of points"},
        {z,
         "z",
         "m",
         "m",
         given_place,
         {},
         "z of the rock's centre; without it, or where it is empty, the setting "
         "`height_above_m` or else the surface"},
        {height_above, "height_above", "m", "m", "height_above_m", {}, "height above the terrain, instead of z"},
        {mass, "mass", "kg", "kg", "mass_kg", {}, "mass"},
        {volume, "volume", "m3", "m³", "volume_m3", {}, "volume"},
        {diameter, "diameter", "m", "m", "diameter_m", {}, "diameter of the sphere with the rock's volume"},
        {radius, "radius", "m", "m", "", radius_range, "its radius"},
        {density,
         "density",
         "kg_m3",
         "kg/m³",
         "density_kg_m3",
         {},
         "density; not together with both mass and size, "
         "from which it follows"},
        {vx, "vx", "m_s", "m/s", given_velocity, {}, "x of the velocity"},
        {vy, "vy", "m_s", "m/s", given_velocity, {}, "y of the velocity; 3D"},
        {vz, "vz", "m_s", "m/s", given_velocity, {}, "z of the velocity, upwards"},
        {speed, "speed", "m_s", "m/s", given_speed, {}, "velocity along the direction in space"},
        {horizontal, "horizontal_velocity", "m_s", "m/s", given_velocity, {}, "velocity along the direction on plan"},
        {vertical, "vertical_velocity", "m_s", "m/s", given_velocity, {}, "velocity upwards"},
        {azimuth,
         "azimuth",
         "deg",
         "°",
         "",
         {.least = -360, .most = 360},
         "direction on plan, clockwise from the y "
         "axis (north); 3D"},
        {plunge,
         "plunge",
         "deg",
         "°",
         "",
         {.least = -90, .most = 90},
         "angle of the direction below the horizontal; "
         "3D, with azimuth"},
        {wx, "wx", "rad_s", "rad/s", "", spin_range, "x of the spin, about the axes of the coordinates; 3D"},
        {wy, "wy", "rad_s", "rad/s", "", spin_range, "y of the spin: rolling towards +x is positive"},
        {wz, "wz", "rad_s", "rad/s", "", spin_range, "z of the spin; 3D"},
        {spin,
         "rotational_velocity",
         "deg_s",
         "°/s",
         "rotational_velocity_deg_s",
         {},
         "spin, positive if the rock "
         "rolls forwards"},
        {axis_a, "a", "m", "m", "", axis_range,
         "longest axis of a block; rigid bodies in 3D, with b and c: only their "
         "ratios count"},
        {axis_b, "b", "m", "m", "", axis_range, "intermediate axis"},
        {axis_c, "c", "m", "m", "", axis_range, "shortest axis"},
    }};
  }();
  return list;
}

bool is_axis(ReleaseColumn column) { return column == axis_a || column == axis_b || column == axis_c; }
bool is_coordinate(ReleaseColumn column) { return column == x || column == y || column == z; }

class Finder {
 public:
  Finder(std::span<const std::string> names, const ColumnRequest& request, FirstProblems& problems)
      : names_(names), request_(request), problems_(problems) {
    for (const std::string& name : names) plain_.push_back(plain_column_name(name));
  }

  FoundColumns find() {
    found_.name = named(request_.name_column, "name_attribute");
    found_.source = named(request_.source_column, "source_attribute");
    if (!found_.name && request_.name_column.empty()) found_.name = place_of("name");
    for (std::size_t k = 0; k < plain_.size(); ++k) {
      if (k == found_.name || k == found_.source) continue;
      if (const auto column = meaning_of(plain_[k])) take(*column, k);
    }
    refuse_units();
    refuse_missing_place();
    refuse_exclusive();
    list();
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::optional<std::size_t> place_of(std::string_view plain) const {
    const auto at = std::find(plain_.begin(), plain_.end(), plain);
    return at == plain_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - plain_.begin()));
  }

  std::optional<std::size_t> named(const std::string& name, const char* key) {
    if (name.empty()) return std::nullopt;
    const auto exact = std::find(names_.begin(), names_.end(), name);
    if (exact != names_.end()) return static_cast<std::size_t>(exact - names_.begin());
    if (const auto at = place_of(plain_column_name(name))) return at;
    problems_.add(0, fmt::format("has no column \"{}\"", name),
                  fmt::format("{} names it; it has {}", key, talus::listed({names_.begin(), names_.end()})),
                  meant(name, {names_.begin(), names_.end()}));
    return std::nullopt;
  }

  [[nodiscard]] bool is_read(ReleaseColumn column) const { return !is_axis(column) || request_.has_axes; }

  [[nodiscard]] std::optional<ReleaseColumn> meaning_of(std::string_view plain) const {
    for (const ReleaseColumnFacts& facts : columns()) {
      if (!is_read(facts.column)) continue;
      const std::string name = facts.name();
      if (plain == name || (is_coordinate(facts.column) && plain == facts.stem)) return facts.column;
      constexpr std::size_t longest = 10;
      if (request_.are_cut && name.size() > longest && plain == plain_column_name(name.substr(0, longest)))
        return facts.column;
    }
    return std::nullopt;
  }

  void take(ReleaseColumn column, std::size_t place) {
    if (request_.has_geometry && (column == x || column == y)) return;
    auto& taken = found_.places[static_cast<std::size_t>(column)];
    if (taken) {
      problems_.add(0,
                    fmt::format("columns {} and {} mean the same", in_quotes(names_[*taken]), in_quotes(names_[place])),
                    "it is not clear which one to read", "Rename one of them");
    } else {
      taken = place;
    }
  }

  /// A known quantity in another unit, or without one, that no other column gives.
  void refuse_units() {
    for (const ReleaseColumnFacts& facts : columns()) {
      if (!is_read(facts.column) || found_.has(facts.column)) continue;
      if (request_.has_geometry && (facts.column == x || facts.column == y)) continue;
      for (std::size_t k = 0; k < plain_.size(); ++k) {
        if (k == found_.name || k == found_.source || meaning_of(plain_[k])) continue;
        const std::string_view plain = plain_[k];
        if (!plain.starts_with(facts.stem)) continue;
        const std::string_view rest = plain.substr(facts.stem.size());
        if (rest.empty()) {
          problems_.add(0, fmt::format("column {} has no unit", in_quotes(names_[k])),
                        "units are in the names of columns",
                        fmt::format("Name it {} if it is in {}", facts.name(), facts.unit_text));
        } else if (rest.starts_with('_') && is_unit_of_column(rest.substr(1))) {
          problems_.add(0, fmt::format("column {} is in another unit", in_quotes(names_[k])),
                        fmt::format("expected {}", facts.unit_text),
                        fmt::format("Convert it to {} and name it {}", facts.unit_text, facts.name()));
        }
      }
    }
  }

  void refuse_missing_place() {
    if (request_.has_geometry) return;
    for (const ReleaseColumn column : {x, y}) {
      if (found_.has(column) || (request_.is_2d && column == y)) continue;
      if (problems_.any()) return;  // a unit
      const bool in_degrees = std::ranges::any_of(plain_, [](std::string_view name) {
        return name.starts_with("lat") || name.starts_with("lon") || name == "lng";
      });
      problems_.add(0, fmt::format("has no column {}", facts_of(column).name()),
                    fmt::format("it has {}", talus::listed({names_.begin(), names_.end()})),
                    in_degrees ? "Degrees are read from points of a GeoPackage, Shapefile or GeoJSON"
                               : "Name the columns in the first line: x_m, y_m and z_m");
      return;
    }
  }

  [[nodiscard]] std::string name_in_file(ReleaseColumn column) const {
    return names_[*found_.places[static_cast<std::size_t>(column)]];
  }

  void refuse_together(std::initializer_list<ReleaseColumn> ones, std::initializer_list<ReleaseColumn> others) {
    for (const ReleaseColumn one : ones) {
      for (const ReleaseColumn other : others) {
        if (!found_.has(one) || !found_.has(other)) continue;
        problems_.add(0, fmt::format("columns {} and {} are given together", name_in_file(one), name_in_file(other)),
                      "they exclude each other", "Remove or rename one of them");
        return;
      }
    }
  }

  void refuse_in_2d() {
    for (const ReleaseColumn column : {azimuth, plunge}) {
      if (!found_.has(column)) continue;
      problems_.add(0, fmt::format("column {} is given in 2D", name_in_file(column)), "a section has no plan",
                    "Give vx_m_s and vz_m_s");
    }
  }

  void refuse_exclusive() {
    refuse_together({vx, vy, vz}, {speed, horizontal, vertical});
    refuse_together({speed}, {horizontal, vertical});
    refuse_together({vx, vy, vz}, {azimuth, plunge});
    refuse_together({wx, wy, wz}, {spin});
    refuse_together({volume}, {diameter, radius});
    refuse_together({diameter}, {radius});
    const bool has_size = found_.has(volume) || found_.has(diameter) || found_.has(radius);
    if (found_.has(mass) && has_size) refuse_together({density}, {volume, diameter, radius});
    if (request_.is_2d) refuse_in_2d();
    if (found_.has(plunge) && !found_.has(azimuth) && !request_.is_2d) {
      problems_.add(0, fmt::format("column {} is given without azimuth_deg", name_in_file(plunge)),
                    "the direction on plan is missing");
    }
  }

  void list() {
    std::vector<bool> is_used(names_.size());
    for (const auto& place : found_.places)
      if (place) is_used[*place] = true;
    for (const auto& place : {found_.name, found_.source})
      if (place) is_used[*place] = true;
    std::vector<std::string> free_names, free_words;
    for (const ReleaseColumnFacts& facts : columns()) {
      if (!is_read(facts.column) || found_.has(facts.column)) continue;
      free_names.push_back(facts.name());
      constexpr std::size_t longest_symbol = 2;  // vx: another letter makes another symbol
      if (facts.stem.size() > longest_symbol) free_words.push_back(facts.name());
    }
    const std::vector<std::string_view> known(free_names.begin(), free_names.end());
    const std::vector<std::string_view> words(free_words.begin(), free_words.end());
    for (std::size_t k = 0; k < names_.size(); ++k) {
      (is_used[k] ? found_.used : found_.unused).push_back(names_[k]);
      if (is_used[k]) continue;
      if (const auto meant = mistyped_column(plain_[k], words)) {
        problems_.add(0, fmt::format("column {} is not known", in_quotes(names_[k])),
                      fmt::format("it would not be read, and there is no column {}", *meant),
                      fmt::format("Name it {}, or otherwise if it is something else", *meant));
        continue;
      }
      // One wrong letter in five: other columns of people's tables may well be similar.
      const auto near = nearest(plain_[k], known);
      if (near && edit_distance(plain_[k], *near) * 5 <= near->size())
        found_.doubtful.push_back(fmt::format("{} ({})", names_[k], *near));
    }
  }

  std::span<const std::string> names_;
  const ColumnRequest& request_;
  FirstProblems& problems_;
  std::vector<std::string> plain_;
  FoundColumns found_;
};

}  // namespace

const Range& ReleaseColumnFacts::permitted() const {
  return setting.empty() ? range : project::setting("seeder", setting).range;
}

std::span<const ReleaseColumnFacts> release_columns() { return columns(); }

const ReleaseColumnFacts& facts_of(ReleaseColumn column) { return columns()[static_cast<std::size_t>(column)]; }

std::vector<ColumnText> release_column_texts() {
  std::vector<ColumnText> texts;
  for (const ReleaseColumnFacts& facts : columns())
    texts.push_back({facts.name(), std::string(facts.unit_text), std::string(facts.meaning), ColumnKind::quantity});
  texts.push_back(
      {"name", "", "name of the row, kept with the run; or the column that `name_attribute` names", ColumnKind::word});
  return texts;
}

FoundColumns find_release_columns(std::span<const std::string> names, const ColumnRequest& request,
                                  FirstProblems& problems) {
  return Finder(names, request, problems).find();
}

}  // namespace talus::project
