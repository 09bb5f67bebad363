#pragma once
// Paths of a run as arrays for drawing.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "results/end_points.hpp"
#include "talus/campaign/model.hpp"

namespace talus::server {

struct DrawnPaths {
  EndPoints rocks;                    // those whose paths these are; the origin is that of the points
  std::vector<std::uint32_t> starts;  // the first point of each, and one more at the end

  // Of each point.
  std::vector<float> times;      // [s]
  std::vector<float> positions;  // three each [m]
  std::vector<float> speeds;     // [m/s]
  std::vector<float> energies;   // kinetic [kJ]
  std::vector<float> heights;    // of the centre above the ground below it [m]; NaN: not known
  std::vector<std::uint8_t> states;
};

/// So many paths of a finished run, evenly spread over those in its table, of which `rocks.total` says how many there
/// are. `model` (may be null): for the heights. Throws BadInput where a table is damaged.
[[nodiscard]] DrawnPaths drawn_paths(const std::filesystem::path& folder, const RunFacts& facts, std::uint64_t rocks,
                                     const Model* model);

}  // namespace talus::server
