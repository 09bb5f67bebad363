#pragma once
// What the random properties of materials and rocks are drawn from.

#include <optional>
#include <string_view>

#include "talus/sampling/distribution.hpp"

namespace talus::project {

struct Drawn {
  Distribution distribution;  // in the unit of the setting
  Bounds bounds;              // that no draw leaves, whatever the distribution says
};

/// Of a setting of [[material]] or [[seeder]] that is a distribution, by its key; nothing where there is no such one.
[[nodiscard]] std::optional<Drawn> drawn(std::string_view key, const Distribution& given);

/// The sampler of a setting that is known to be one; `scale` leads from its unit to SI.
[[nodiscard]] Sampler sampler_of(std::string_view key, const Distribution& given, double scale = 1);

}  // namespace talus::project
