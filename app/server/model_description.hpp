#pragma once
// The overview of a model for the page: where everything is, in the user's coordinates.

#include "http/answer.hpp"
#include "model_shelf.hpp"

namespace talus::server {

/// The member `model` of the answer to POST /api/model.
[[nodiscard]] Json description_of(const ShelvedModel& shelved);

/// [x, y, z]
[[nodiscard]] Json as_json(const Vec3& p);

}  // namespace talus::server
