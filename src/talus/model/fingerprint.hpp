#pragma once
// What tells one campaign from another: whether rocks that were thrown elsewhere, or earlier, belong together.

#include <nlohmann/json.hpp>
#include <string>

#include "talus/campaign/model.hpp"

namespace talus::project {

/// Of the whole project as it is echoed and of the numbers that were read from its files: terrain, ground, seeders,
/// barriers. The same on every machine; files that were changed since give another one.
[[nodiscard]] std::string fingerprint_of(const nlohmann::ordered_json& project, const Model& model);

/// Of the paths of up to sixteen rocks, spread over all: it differs where another program, compiler, processor or
/// library of mathematics gives other bits.
[[nodiscard]] std::string sample_of(const Model& model);

}  // namespace talus::project
