#pragma once
// What summary.json says of a run's model, before any rock is thrown.

#include <nlohmann/json.hpp>

#include "talus/campaign/model.hpp"

namespace talus {

/// The keys `seed`, `energy_datum_m`, `origin_m` (of the local frame), `terrain` (a section's vertices, or a coarse
/// relief), `barriers` (a list of name, kind and foot) and `sources` (which rocks come from which).
[[nodiscard]] nlohmann::ordered_json model_json(const Model& model);

}  // namespace talus
