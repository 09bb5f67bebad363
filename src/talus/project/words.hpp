#pragma once
// The words of enumerations in the project file, in the order of the enumerators. They are listed only here.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "talus/maps/map_subjects.hpp"
#include "talus/project/project.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::project {

template <std::size_t count>
using Words = std::array<std::string_view, count>;

/// The words of each enumeration; an enumeration without words cannot be a setting.
template <class Enumeration>
inline constexpr auto words_of = nullptr;

template <>
inline constexpr Words<2> words_of<RockModel>{"lumped_mass", "rigid_sphere"};
template <>
inline constexpr Words<2> words_of<SlidingMethod>{"stepped", "closed_form"};
template <>
inline constexpr Words<3> words_of<FrictionSource>{"material", "tangential_restitution", "zero"};
template <>
inline constexpr Words<2> words_of<MaterialSampling>{"per_impact", "per_rock"};
template <>
inline constexpr Words<2> words_of<SamplingMethod>{"monte_carlo", "latin_hypercube"};
template <>
inline constexpr Words<4> words_of<SeederType>{"point", "line", "polygon", "raster"};
template <>
inline constexpr Words<2> words_of<PlaceInCell>{"random", "centre"};
template <>
inline constexpr Words<4> words_of<Forest>{"none", "open", "medium", "dense"};
template <>
inline constexpr Words<8> words_of<DistributionKind>{"none", "normal",      "uniform",   "triangular",
                                                     "beta", "exponential", "lognormal", "gamma"};
template <>
inline constexpr Words<2> words_of<DesignStandard>{"UNI 11211-4", "none"};
template <>
inline constexpr Words<2> words_of<DesignLevel>{"MEL", "SEL"};
template <>
inline constexpr Words<2> words_of<DesignEnergy>{"translational", "total"};
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
