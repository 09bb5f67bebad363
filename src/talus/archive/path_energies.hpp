#pragma once
// A path's energies over time, for a graph.

#include <vector>

#include "talus/archive/run_folder.hpp"

namespace talus {

struct PathEnergies {
  double time_s = 0;
  double ke_translational_J = 0, ke_rotational_J = 0, pe_J = 0;
};

/// At each row what it says, and of flights some points between, on which the kinetic energy is that of the arc
/// (path_arcs.hpp) and the potential energy, which is linear in z, follows from the path's highest and lowest row.
/// `tolerance_m`: of the arc, which says how many points there are.
[[nodiscard]] std::vector<PathEnergies> energies_along(const Path& path, double tolerance_m);

}  // namespace talus
