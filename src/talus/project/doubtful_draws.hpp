#pragma once
// Distributions whose draws are not what their mean and standard deviation say.

#include <optional>
#include <string>

#include "talus/sampling/distribution.hpp"

namespace talus::project {

struct DoubtOfDraws {
  std::string what, why, hint;
};

/// Where the limits leave little of a distribution, or move its mean; with the numbers that were given and those that
/// hold. `name` is the setting's. Expects a distribution that `why_unusable` accepts.
[[nodiscard]] std::optional<DoubtOfDraws> doubt_of_draws(const std::string& name, const Distribution& given,
                                                         Bounds bounds);

}  // namespace talus::project
