#pragma once
// The subjects of maps: one row for each count and each quantity, with the name that users choose.

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string_view>

#include "talus/maps/map_style.hpp"
#include "talus/results/map_quantity.hpp"

namespace talus {

/// Values of a cell that are one map each; map_list.cpp computes them.
enum class MapCount { passages, reach_share, deposits, impacts };

/// A map of a count; or the maps of a quantity: maximum, mean and percentiles.
struct MapSubjectRow {
  std::string_view name;     // in the setting; the files' names are it, or begin with it
  std::string_view meaning;  // one phrase
  std::string_view title;    // of its figure along a section
  ClassLimits limits;        // in its unit
  std::optional<MapCount> count{};
  std::optional<MapQuantity> quantity{};
  // Of a quantity:
  std::string_view unit{}, unit_in_name{};
  double per = 1;  // the unit, in that of MapQuantity
};

namespace map_limits {

inline constexpr ClassLimits counts{10, 100, 1000, 10'000, 100'000}, shares{1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
inline constexpr ClassLimits energies{30, 100, 300, 1000, 3000};  // [kJ]

}  // namespace map_limits

/// Counts first, then quantities, in the order of their files and settings.
inline constexpr auto map_subjects = std::to_array<MapSubjectRow>({
    {.name = "passages",
     .meaning = "rocks that were in the cell",
     .title = "Passages",
     .limits = map_limits::counts,
     .count = MapCount::passages},
    {.name = "reach_share",
     .meaning = "share of all rocks that were in the cell",
     .title = "Reach probability",
     .limits = map_limits::shares,
     .count = MapCount::reach_share},
    {.name = "deposits",
     .meaning = "rocks that came to rest in the cell",
     .title = "Deposits",
     .limits = map_limits::counts,
     .count = MapCount::deposits},
    {.name = "impacts",
     .meaning = "impacts on the ground of the cell",
     .title = "Impacts",
     .limits = map_limits::counts,
     .count = MapCount::impacts},
    {.name = "energy_total",
     .meaning = "total kinetic energy",
     .title = "Total kinetic energy",
     .limits = map_limits::energies,
     .quantity = MapQuantity::energy_total,
     .unit = "kJ",
     .unit_in_name = "kJ",
     .per = 1000},
    {.name = "energy_translational",
     .meaning = "translational kinetic energy",
     .title = "Translational kinetic energy",
     .limits = map_limits::energies,
     .quantity = MapQuantity::energy_translational,
     .unit = "kJ",
     .unit_in_name = "kJ",
     .per = 1000},
    {.name = "velocity",
     .meaning = "velocity",
     .title = "Velocity",
     .limits = {5, 10, 15, 20, 30},
     .quantity = MapQuantity::velocity,
     .unit = "m/s",
     .unit_in_name = "m_s"},
    {.name = "bounce_height",
     .meaning = "bounce height of the lowest point",
     .title = "Bounce height (lowest point)",
     .limits = {0.5, 1, 2, 5, 10},
     .quantity = MapQuantity::bounce_height,
     .unit = "m",
     .unit_in_name = "m"},
});

/// The place of a row in `map_subjects`.
enum class MapSubject : std::size_t {};

/// By MapSubject.
inline constexpr auto map_subject_names = [] {
  std::array<std::string_view, map_subjects.size()> names;
  std::ranges::transform(map_subjects, names.begin(), &MapSubjectRow::name);
  return names;
}();

/// Some of them, by MapSubject.
using MapSubjects = std::bitset<map_subjects.size()>;

inline constexpr MapSubjects all_map_subjects{(1U << map_subjects.size()) - 1};

/// Whether its maps can show a range between ensembles: counts of ensembles of other sizes cannot be compared.
[[nodiscard]] constexpr bool has_band(const MapSubjectRow& row) {
  return row.quantity || row.count == MapCount::reach_share;
}
inline constexpr MapSubjects banded_map_subjects = [] {
  unsigned bits = 0;
  for (std::size_t k = 0; k < map_subjects.size(); ++k) bits |= has_band(map_subjects[k]) ? 1U << k : 0U;
  return MapSubjects(bits);
}();
[[nodiscard]] constexpr MapSubjects only(MapCount count) {
  unsigned bits = 0;
  for (std::size_t k = 0; k < map_subjects.size(); ++k) bits |= map_subjects[k].count == count ? 1U << k : 0U;
  return MapSubjects(bits);
}

/// `subjects` without the maps of a quantity.
[[nodiscard]] inline MapSubjects without(MapQuantity quantity, MapSubjects subjects) {
  for (std::size_t k = 0; k < map_subjects.size(); ++k) {
    if (map_subjects[k].quantity == quantity) subjects.reset(k);
  }
  return subjects;
}

}  // namespace talus
