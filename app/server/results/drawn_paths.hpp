#pragma once
// Paths of a run as arrays for drawing.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "results/end_points.hpp"
#include "talus/archive/run_folder.hpp"
#include "talus/campaign/model.hpp"

namespace talus::server {

struct DrawnPaths {
  EndPoints rocks;                    // of these paths; its origin is that of the points
  std::vector<std::uint32_t> starts;  // index of each path's first point, and the number of points at the end

  // Of each point.
  std::vector<float> times;      // [s]
  std::vector<float> positions;  // three each [m]
  std::vector<float> speeds;     // [m/s]
  std::vector<float> energies;   // kinetic [kJ]
  std::vector<float> heights;    // of the centre above the ground below it [m]; NaN: unknown
  std::vector<std::uint8_t> states;
};

/// Appends the points of a path. Its rock must be the next one of `paths.rocks`, whose origin the first path sets.
/// `model`: for the heights; may be null.
void add_path(DrawnPaths& paths, const Path& path, const Model* model);

/// `rocks` paths of a finished run, evenly spread over those in its table that pass the test (empty: all), whose number
/// is `DrawnPaths::rocks.total`. `model`: for the heights; may be null. Throws BadInput if a table is damaged.
///
/// The table has an even choice of the planned rocks, of which a run that was stopped early did few. If that run stored
/// its trajectories, as many of them as the table was to have are taken instead.
[[nodiscard]] DrawnPaths drawn_paths(const std::filesystem::path& folder, const RunFacts& facts, std::uint64_t rocks,
                                     const Model* model, const RockTest& passes = {});

}  // namespace talus::server
