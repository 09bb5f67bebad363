#pragma once
// Paths of a run as arrays for drawing, and what is known of their rocks.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "results/run_summary.hpp"
#include "talus/campaign/model.hpp"
#include "talus/core/vec.hpp"

namespace talus::server {

struct DrawnPaths {
  Vec3 origin = Vec3::Zero();  // to which positions are relative [m]
  std::uint64_t total = 0;     // rocks with a path in the table

  // Of each rock.
  std::vector<std::uint32_t> rocks;
  std::vector<std::uint32_t> starts;  // its first point, and one more at the end
  std::vector<std::uint16_t> sources, seeders;
  std::vector<std::uint8_t> reasons;
  std::vector<float> masses;        // [kg]
  std::vector<float> max_energies;  // [kJ]
  std::vector<float> max_heights;   // [m]
  std::vector<std::uint32_t> barriers;  // bit k: it hit the k-th

  // Of each point.
  std::vector<float> times;      // [s]
  std::vector<float> positions;  // three each [m]
  std::vector<float> speeds;     // [m/s]
  std::vector<float> energies;   // kinetic [kJ]
  std::vector<float> heights;    // of the centre above the ground below it [m]; NaN: not known
  std::vector<std::uint8_t> states;

  Names source_names, seeder_names;
  std::vector<std::string> barrier_names;
};

/// So many paths of a finished run, evenly spread over those in its table. `model` (may be null): for the heights.
/// Throws BadInput where a table is damaged.
[[nodiscard]] DrawnPaths drawn_paths(const std::filesystem::path& folder, const Json& summary, std::uint64_t rocks,
                                     const Model* model);

}  // namespace talus::server
