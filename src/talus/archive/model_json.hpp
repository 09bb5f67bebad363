#pragma once
// The parts of summary.json that describe the model, known before any rock is run.

#include <nlohmann/json.hpp>

#include "talus/archive/run_summary.hpp"
#include "talus/campaign/model.hpp"

namespace talus {

/// The keys `seed`, `energy_datum_m`, `origin_m` (of the local frame), `terrain` (the vertices of a section, or a
/// coarse relief), `barriers` (a list of name, kind and foot), `sources` (how many rocks each has) and
/// `releases` (the places of each seeder, in the order in which they release rocks).
[[nodiscard]] nlohmann::ordered_json model_json(const Model& model);

/// The terrain alone.
[[nodiscard]] TerrainSummary terrain_summary(const Model& model);

}  // namespace talus
