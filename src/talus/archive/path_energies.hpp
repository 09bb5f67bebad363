#pragma once
// The energies of a path over time, for a figure.

#include <vector>

#include "talus/archive/run_folder.hpp"

namespace talus {

struct PathEnergies {
  double time_s = 0;
  double ke_translational_J = 0, ke_rotational_J = 0, pe_J = 0;
};

/// The energies of each row, and of some points between the rows of flights. There the kinetic energy is that of the
/// arc (path_arcs.hpp), and the potential energy, which is linear in z, follows from the path's highest and lowest row.
/// `tolerance_m` of the arc determines the number of points.
[[nodiscard]] std::vector<PathEnergies> energies_along(const Path& path, double tolerance_m);

}  // namespace talus
