#pragma once
// Short ways to write the conditions of settings.

#include "talus/project/settings.hpp"

namespace talus::project::declared {

inline Condition given(std::string_view key) { return {key, Condition::Kind::given}; }
inline Condition absent(std::string_view key) { return {key, Condition::Kind::absent}; }
inline Condition is(std::string_view key, std::vector<std::string_view> values) {
  return {key, Condition::Kind::one_of, std::move(values)};
}
inline Condition is_not(std::string_view key, std::vector<std::string_view> values) {
  return {key, Condition::Kind::none_of, std::move(values)};
}

/// For properties of one rock model.
inline Need of_model(RockModel model, Otherwise otherwise) {
  return {.any_of = {is("analysis.model", {word(model)})}, .otherwise = otherwise};
}

/// For properties of rocks that are more than points.
inline Need of_rigid_rocks(Otherwise otherwise) {
  return {.any_of = {is("analysis.model", {word(RockModel::rigid_sphere), word(RockModel::rigid_body)})},
          .otherwise = otherwise};
}

/// For settings that need 3D: anything but a section without a width.
inline Need in_3d(Otherwise otherwise, std::string_view what, std::string_view why, std::string_view hint = {}) {
  return {.any_of = {absent("terrain.section"), given("terrain.width_m")},
          .otherwise = otherwise,
          .what = what,
          .why = why,
          .hint = hint};
}

/// For keys that only have a meaning together with another one.
inline Need together_with(std::vector<Condition> any_of, std::string_view what = {}) {
  return {.any_of = std::move(any_of), .otherwise = Otherwise::refused, .what = what};
}

}  // namespace talus::project::declared
