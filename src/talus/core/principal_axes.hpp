#pragma once
// Eigenvalues and eigenvectors of a symmetric matrix of three rows.

#include <array>
#include <cmath>
#include <utility>

#include "talus/core/matrix.hpp"

namespace talus {

struct PrincipalAxes {
  Vec3 values;  // descending
  Mat3 axes;    // the rows are the unit vectors of the values, right-handed
};

/// By Jacobi's rotations, which leave a diagonal matrix as it is: axes that are given are found again.
[[nodiscard]] inline PrincipalAxes principal_axes(Mat3 m) {
  constexpr int max_sweeps = 32;
  Mat3 axes = Mat3::diagonal({1, 1, 1});
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    const double off = std::abs(m.rows[0][1]) + std::abs(m.rows[0][2]) + std::abs(m.rows[1][2]);
    const double on = std::abs(m.rows[0][0]) + std::abs(m.rows[1][1]) + std::abs(m.rows[2][2]);
    if (off <= 1e-17 * on) break;
    for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
      if (m.rows[p][q] == 0) continue;
      const double theta = (m.rows[q][q] - m.rows[p][p]) / (2 * m.rows[p][q]);
      const double t = std::copysign(1 / (std::abs(theta) + std::sqrt(theta * theta + 1)), theta);
      const double c = 1 / std::sqrt(t * t + 1), s = t * c;
      Mat3 turn = Mat3::diagonal({1, 1, 1});
      turn.rows[p][p] = turn.rows[q][q] = c;
      turn.rows[p][q] = -s;
      turn.rows[q][p] = s;
      m = turn * m * turn.transposed();
      m.rows[p][q] = m.rows[q][p] = 0;
      axes = turn * axes;
    }
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto descend = [&](std::size_t a, std::size_t b) {
    if (m.rows[order[b]][order[b]] > m.rows[order[a]][order[a]]) std::swap(order[a], order[b]);
  };
  descend(0, 1);
  descend(1, 2);
  descend(0, 1);
  const auto value = [&](std::size_t k) { return m.rows[order[k]][order[k]]; };
  const Vec3 &first = axes.rows[order[0]], &second = axes.rows[order[1]];
  return {{value(0), value(1), value(2)}, {{first, second, first.cross(second)}}};
}

}  // namespace talus
