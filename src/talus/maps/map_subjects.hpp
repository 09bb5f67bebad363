#pragma once
// The subjects of maps, with the names that users choose from.

#include <array>
#include <bitset>
#include <cstddef>
#include <string_view>

namespace talus {

/// Counts, with one map each, then quantities, with maps of the maximum, the mean and the percentiles.
enum class MapSubject {
  passages,
  reach_share,
  deposits,
  impacts,
  energy_total,
  energy_translational,
  velocity,
  bounce_height
};

/// By MapSubject: the file names of counts, and the beginnings of the file names of quantities.
inline constexpr std::array<std::string_view, 8> map_subject_names{"passages", "reach_share",  "deposits",
                                                                   "impacts",  "energy_total", "energy_translational",
                                                                   "velocity", "bounce_height"};

/// A set of subjects, by MapSubject.
using MapSubjects = std::bitset<map_subject_names.size()>;

inline constexpr MapSubjects all_map_subjects{(1U << map_subject_names.size()) - 1};

[[nodiscard]] inline bool holds(const MapSubjects& subjects, MapSubject subject) {
  return subjects[static_cast<std::size_t>(subject)];
}

[[nodiscard]] constexpr std::string_view name_of(MapSubject subject) {
  return map_subject_names[static_cast<std::size_t>(subject)];
}

}  // namespace talus
