#include "talus/archive/path_energies.hpp"

#include <algorithm>
#include <utility>

#include "talus/archive/path_arcs.hpp"

namespace talus {

std::vector<PathEnergies> energies_along(const Path& path, double tolerance_m) {
  std::vector<PathEnergies> energies;
  if (path.rows.empty()) return energies;
  const auto by_height = [](const PathEventRow& a, const PathEventRow& b) { return a.position_m[2] < b.position_m[2]; };
  const auto [lowest, highest] = std::minmax_element(path.rows.begin(), path.rows.end(), by_height);
  const double fall = highest->position_m[2] - lowest->position_m[2];
  const double weight = fall > 0 ? (highest->pe_J - lowest->pe_J) / fall : 0;  // m g [N]

  for (std::size_t k = 0; k < path.rows.size(); ++k) {
    const PathEventRow& row = path.rows[k];
    energies.push_back({row.time_s, row.ke_translational_J, row.ke_rotational_J, row.pe_J});
    if (row.state != PathState::projectile || k + 1 == path.rows.size()) continue;
    bool is_row = true;
    const Path flight{path.rock, {row, path.rows[k + 1]}};
    for_points_along(flight, tolerance_m, [&](const PathPoint& point) {
      if (!std::exchange(is_row, false) && point.time_s < flight.rows[1].time_s)
        energies.push_back({point.time_s, point.ke_total_J - row.ke_rotational_J, row.ke_rotational_J,
                            row.pe_J + weight * (point.position_m[2] - row.position_m[2])});
    });
  }
  return energies;
}

}  // namespace talus
