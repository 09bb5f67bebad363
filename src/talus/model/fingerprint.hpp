#pragma once
// Fingerprints of a campaign, which show whether rocks simulated elsewhere or earlier belong to it.

#include <nlohmann/json.hpp>
#include <string>

#include "talus/campaign/model.hpp"

namespace talus::project {

/// The fingerprint of the echoed project, of the numbers read from its files (terrain, ground, seeders, barriers), and
/// of the program's paths_revision. It is the same on every machine, and changes with the contents of the files.
[[nodiscard]] std::string fingerprint_of(const nlohmann::ordered_json& project, const Model& model);

/// The fingerprint of the paths of up to sixteen rocks, evenly spread over all. It differs if another program,
/// compiler, processor or mathematics library gives other bits.
[[nodiscard]] std::string sample_of(const Model& model);

}  // namespace talus::project
