#pragma once
// The distributions of the random properties of materials and rocks.

#include <optional>
#include <string_view>

#include "talus/sampling/distribution.hpp"

namespace talus::project {

struct Drawn {
  Distribution distribution;  // in the unit of the setting
  Bounds bounds;              // limits of all draws, whatever the distribution
};

/// The distribution of a setting of [[material]], [[seeder]] or [[shape]], by its key; nullopt if it is not a random
/// property.
[[nodiscard]] std::optional<Drawn> drawn(std::string_view key, const Distribution& given);

/// The sampler of a random property; `scale` converts its unit to SI. Expects the key of a random property.
[[nodiscard]] Sampler sampler_of(std::string_view key, const Distribution& given, double scale = 1);

}  // namespace talus::project
