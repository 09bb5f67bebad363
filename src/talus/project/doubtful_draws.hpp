#pragma once
// Distributions whose draws do not have the given mean and standard deviation.

#include <optional>
#include <string>

#include "talus/sampling/distribution.hpp"

namespace talus::project {

struct DoubtOfDraws {
  std::string what, why, hint;
};

/// A warning if the limits cut off most of a distribution or shift its mean, with the given and the resulting numbers.
/// `name` is the setting's. Expects a distribution that `why_unusable` accepts.
[[nodiscard]] std::optional<DoubtOfDraws> doubt_of_draws(const std::string& name, const Distribution& given,
                                                         Bounds bounds);

}  // namespace talus::project
