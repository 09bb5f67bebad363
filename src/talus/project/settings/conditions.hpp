#pragma once
// When settings apply, in few words.

#include "talus/project/settings.hpp"

namespace talus::project::declared {

inline Condition given(std::string_view key) { return {key, Condition::Asks::given}; }
inline Condition absent(std::string_view key) { return {key, Condition::Asks::absent}; }
inline Condition is(std::string_view key, std::vector<std::string_view> values) {
  return {key, Condition::Asks::one_of, std::move(values)};
}
inline Condition is_not(std::string_view key, std::vector<std::string_view> values) {
  return {key, Condition::Asks::none_of, std::move(values)};
}

/// What a rock of one model has.
inline Need of_model(RockModel model, Otherwise otherwise) {
  return {.any_of = {is("analysis.model", {word(model)})}, .otherwise = otherwise};
}

/// What a section has none of, unless it is extruded.
inline Need in_3d(Otherwise otherwise, std::string_view what, std::string_view why, std::string_view hint = {}) {
  return {.any_of = {absent("terrain.section"), given("terrain.width_m")},
          .otherwise = otherwise,
          .what = what,
          .why = why,
          .hint = hint};
}

/// What another key makes sense of.
inline Need beside(std::vector<Condition> any_of, std::string_view what = {}) {
  return {.any_of = std::move(any_of), .otherwise = Otherwise::refused, .what = what};
}

}  // namespace talus::project::declared
