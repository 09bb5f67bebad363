#pragma once
// The words of enumerations in the project file, in the order of the enumerators. They are listed only here.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "talus/maps/map_subjects.hpp"
#include "talus/project/project.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::project {

/// An enumeration and its words, in the order of its enumerators.
template <class Enum, std::size_t count>
struct Worded {
  using Enumeration = Enum;
  std::array<std::string_view, count> words;
};

template <class Enumeration, class... Text>
[[nodiscard]] consteval Worded<Enumeration, sizeof...(Text)> worded(Text... words) {
  return {{words...}};
}

/// Every enumeration that a setting can be. Readers, schema and echo of a setting (`Slot` in settings.hpp) follow from
/// this list.
inline constexpr std::tuple enumerations{
    worded<LawSet>("talus", "rocfall"),
    worded<RockModel>("lumped_mass", "rigid_sphere", "rigid_body"),
    worded<SlidingMethod>("stepped", "closed_form"),
    worded<FrictionSource>("material", "tangential_restitution", "zero"),
    worded<RoughnessLaw>("faces", "tilts"),
    worded<MaterialSampling>("per_impact", "per_rock"),
    worded<SamplingMethod>("monte_carlo", "latin_hypercube"),
    worded<UpAxis>("z", "y"),
    worded<SeederType>("point", "line", "polygon", "raster", "table"),
    worded<PlaceInCell>("random", "centre"),
    worded<ShapeStyle>("rounded", "angular", "box"),
    worded<Solid>("none", "tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron", "icosphere_32",
                  "icosphere_80"),
    worded<Forest>("none", "open", "medium", "dense"),
    worded<DistributionKind>("none", "normal", "uniform", "triangular", "beta", "exponential", "lognormal", "gamma",
                             "empirical"),
    worded<DesignStandard>("UNI 11211-4", "ONR 24810", "none"),
    worded<ResidualHeight>("unknown", "A", "B", "C"),
    worded<DesignLevel>("MEL", "SEL"),
    worded<DesignEnergy>("translational", "total"),
    worded<Paper>("A4", "A3"),
    worded<ReportUnits>("metric", "us"),
};

template <class Enumeration, class... Listed>
[[nodiscard]] consteval std::size_t place_in_list(const std::tuple<Listed...>&) {
  std::size_t place = 0;
  static_cast<void>(((std::is_same_v<Enumeration, typename Listed::Enumeration> || (++place, false)) || ...));
  return place;
}

/// The words of an enumeration of the list.
template <class Enumeration>
inline constexpr auto words_of = std::get<place_in_list<Enumeration>(enumerations)>(enumerations).words;

/// A setting is a set of these, never one of them.
template <>
inline constexpr auto words_of<MapSubject> = map_subject_names;

/// All words of an enumeration.
template <class Enumeration>
requires std::is_enum_v<Enumeration>
[[nodiscard]] constexpr std::span<const std::string_view> words() { return words_of<Enumeration>; }

/// The word of one value.
template <class Enumeration>
requires std::is_enum_v<Enumeration>
[[nodiscard]] constexpr std::string_view word(Enumeration value) {
  return words_of<Enumeration>[static_cast<std::size_t>(value)];
}

/// The value that a word stands for; nullopt if there is none.
template <class Enumeration>
requires std::is_enum_v<Enumeration>
[[nodiscard]] constexpr std::optional<Enumeration> value_of(std::string_view text) {
  const auto found = std::ranges::find(words_of<Enumeration>, text);
  if (found == words_of<Enumeration>.end()) return std::nullopt;
  return static_cast<Enumeration>(found - words_of<Enumeration>.begin());
}

}  // namespace talus::project
