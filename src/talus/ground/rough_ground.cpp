#include "talus/ground/rough_ground.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>

#include "talus/core/tolerances.hpp"

namespace talus {

namespace {

constexpr double min_u = 0x1p-53;  // of the uniform numbers that are drawn

/// Borders of the cells of quantiles: 1/64 wide and, in both tails, halved down to a millionth, because a tilt that one
/// face in a million has may be as good as a wall.
std::vector<double> borders() {
  constexpr int middle = 64, smallest = 20;
  std::vector<double> below, above;
  for (int k = smallest; std::ldexp(1, -k) < 1.0 / middle; --k) {
    below.push_back(std::ldexp(1, -k));
    above.push_back(1 - std::ldexp(1, -k));
  }
  std::vector<double> all{0};
  all.insert(all.end(), below.begin(), below.end());
  for (int k = 1; k < middle; ++k) all.push_back(static_cast<double>(k) / middle);
  all.insert(all.end(), above.rbegin(), above.rend());
  all.push_back(1);
  return all;
}

}  // namespace

RoughGround::RoughGround(const Sampler& tilt, double spacing) : RoughGround(tilt, spacing, 0) {}

RoughGround::RoughGround(const Sampler& tilt, double spacing, double amplitude)
    : tilt_(tilt), spacing_(spacing), amplitude_(amplitude) {
  if (!is_smooth()) make_cells();
}

double RoughGround::slope_of_heights(double u) const {
  // The difference of two independent heights is sqrt(2) amplitudes wide, and a normal number is -sqrt(2) erfc^-1(2u).
  return -2 * boost::math::erfc_inv(2 * u) * amplitude_ / spacing_;
}

double RoughGround::quantile(double u) const {
  const double within = std::clamp(u, min_u, 1 - min_u);
  const double tilt = has_tilt() ? tilt_.draw(within) : std::atan(slope_of_heights(within));
  return std::clamp(tilt, -tolerance::max_tilt, tolerance::max_tilt);
}

void RoughGround::make_cells() {
  constexpr double above_rounding = 1 + 1e-12;
  Cell cell;
  double from = quantile(0);
  for (const double u : borders()) {
    if (u > 0) {
      const double to = quantile(u), cosine = from <= 0 && to >= 0 ? 1 : std::max(std::cos(from), std::cos(to));
      cell.cos = cosine * above_rounding;
      cell.sin = std::sin(to) + 1e-12 * std::abs(std::sin(to));
      cells_.push_back(cell);
      cell.cos_sum += (u - cell.u) * cell.cos;
      cell.sin_sum += (u - cell.u) * cell.sin;
      from = to;
    }
    cell.u = u;
  }
  cells_.push_back(cell);
  if (from > 0 && spacing_ > 0) bump_spacing_ = spacing_;
}

/// The first cell with a face that a rock may meet. (The bound of a cell grows with its tilts up to its first face that
/// is shown.)
std::size_t RoughGround::first_shown(double sin_a, double cos_a) const {
  const auto end = cells_.end() - 1;
  const auto first = std::partition_point(cells_.begin(), end,
                                          [&](const Cell& cell) { return !(sin_a * cell.cos + cos_a * cell.sin > 0); });
  return static_cast<std::size_t>(first - cells_.begin());
}

}  // namespace talus
