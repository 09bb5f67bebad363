#pragma once
// Rough ground: the small faces that stand on a facet of the terrain, each tilted against it, and which of them a rock
// meets.
//
//   n, h       unit normal of the facet; unit heading of the rock along it
//   psi, chi   tilt of a face [rad]: ahead, positive where the ground rises against the rock, and aside
//   n'         normal of the face, (n - tan(psi) h + tan(chi) n x h) / |...|
//   f          distribution of tilts among the faces: what a survey of slope angles gives. psi has it as it is; chi has
//              it with either sign, each with probability 1/2. In a section chi = 0.
//   a          angle between the rock's velocity v and the facet, 0 for a rock that moves along it
//
// A rock meets a face with a probability in proportion to the area that the face shows it (Talus' own law,
// docs/laws.md):
//   p(psi, chi) ~ f(psi) f(chi) max(0, -v . n' / |v|),   -v . n' / |v| = sin(a + psi) cos(chi'),
//   cos(chi') = sqrt((1 + tan^2 psi) / (1 + tan^2 psi + tan^2 chi))
// So a rock that falls steeply meets all faces, and one that moves along the ground only those that rise against it.
// Left out: faces in the shadow of others; the size of the rock (tilts are those over a length of its size).
//
// Sampling is exact, by rejection. The quantiles of f are cut into cells; in a cell, sin(a + psi) is at most
// sin(a) C + cos(a) S with C and S the maxima of cos(psi) and sin(psi) there. Sums of C and S over the cells do not
// depend on a, so a cell is found by bisection in the distribution of these bounds. Four in five proposals are
// accepted.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "talus/sampling/distribution.hpp"

namespace talus {

/// Tilts of one face of rough ground [rad].
struct FaceTilt {
  double ahead = 0, aside = 0;
};

class RoughGround {
 public:
  /// Smooth.
  RoughGround() = default;
  /// `tilt`: f [rad]. `spacing`: mean way along the ground between two faces that a rock strikes [m]; 0: none.
  RoughGround(const Sampler& tilt, double spacing = 0);  // NOLINT: a distribution of tilts is rough ground
  /// f from heights: two points of the ground, `spacing` apart [m], have independent, normally distributed heights
  /// above the facet with the standard deviation `amplitude` [m], so that psi = atan((a2 - a1) / spacing). If `tilt` is
  /// not constant, the law of faces uses that alone, and the law of tilts (below) the sum of both.
  RoughGround(const Sampler& tilt, double spacing, double amplitude);

  [[nodiscard]] bool is_smooth() const { return !has_tilt() && !has_heights(); }
  [[nodiscard]] const Sampler& tilt() const { return tilt_; }
  /// The mean way along the ground from bump to bump [m]; infinite if no face rises against a rock.
  [[nodiscard]] double bump_spacing() const { return bump_spacing_; }

  /// The face that a rock meets at sin(a), cos(a), both at least 0; nullopt if it meets none. `pair(k)` gives the k-th
  /// pair of independent uniform numbers, k < 2 max_proposals. (After as many rejected proposals, of which less than
  /// one in 10^9 impacts has to do on the grounds of the library, the result is nullopt, too.)
  template <class Pair>
  [[nodiscard]] std::optional<FaceTilt> met_face(double sin_a, double cos_a, bool in_section, Pair&& pair) const;
  static constexpr std::uint32_t max_proposals = 16;

  /// Tilts at an impact by RocFall's law, which does not ask how the rock comes in: psi and chi drawn from f and from
  /// the heights, added.
  template <class Pair>
  [[nodiscard]] FaceTilt tilt_at_impact(Pair&& pair) const;

 private:
  /// Of the quantiles of f: from `u` to the u of the next cell.
  struct Cell {
    double u = 0;
    double cos = 0, sin = 0;          // maxima in the cell
    double cos_sum = 0, sin_sum = 0;  // of maxima times widths, over the cells before
  };
  [[nodiscard]] bool has_tilt() const { return !tilt_.is_constant(); }
  [[nodiscard]] bool has_heights() const { return spacing_ > 0 && amplitude_ > 0; }
  [[nodiscard]] double slope_of_heights(double u) const;
  /// The tilt of which the share u of the faces has less, within the limits of tilts.
  [[nodiscard]] double quantile(double u) const;
  [[nodiscard]] std::size_t first_shown(double sin_a, double cos_a) const;
  void make_cells();

  Sampler tilt_;
  double spacing_ = 0, amplitude_ = 0;  // [m]
  double bump_spacing_ = std::numeric_limits<double>::infinity();
  std::vector<Cell> cells_;  // the last one only ends the one before; empty on smooth ground
};

/// Either sign with equal probability, and a uniform number that is independent of it.
struct SignedUniform {
  double sign, u;
  explicit SignedUniform(double both) : sign(both < 0.5 ? -1 : 1), u(both < 0.5 ? 2 * both : 2 * both - 1) {
    u = std::clamp(u, 0x1p-53, 1 - 0x1p-53);
  }
};

template <class Pair>
std::optional<FaceTilt> RoughGround::met_face(double sin_a, double cos_a, bool in_section, Pair&& pair) const {
  if (cells_.empty()) return std::nullopt;
  const auto shown_before = [&](const Cell& cell) { return sin_a * cell.cos_sum + cos_a * cell.sin_sum; };
  const std::size_t first = first_shown(sin_a, cos_a), last = cells_.size() - 1;
  if (first == last) return std::nullopt;
  const double start = shown_before(cells_[first]), all = shown_before(cells_[last]) - start;
  for (std::uint32_t proposal = 0; proposal < max_proposals; ++proposal) {
    const auto [place, acceptance] = pair(2 * proposal);
    const double target = start + place * all;
    const auto found = std::partition_point(cells_.begin() + static_cast<std::ptrdiff_t>(first + 1),
                                            cells_.begin() + static_cast<std::ptrdiff_t>(last),
                                            [&](const Cell& cell) { return shown_before(cell) <= target; });
    const Cell& cell = *(found - 1);
    const double bound = sin_a * cell.cos + cos_a * cell.sin;
    const double psi = quantile(cell.u + (target - shown_before(cell)) / bound);
    const double shown = sin_a * std::cos(psi) + cos_a * std::sin(psi);
    if (!(acceptance * bound < shown)) continue;
    if (in_section) return FaceTilt{psi, 0};
    const auto [side, turned] = pair(2 * proposal + 1);
    const SignedUniform aside(side);
    const double chi = aside.sign * quantile(aside.u);
    const double ahead = 1 + std::tan(psi) * std::tan(psi), square = std::tan(chi) * std::tan(chi);
    if (turned * turned * (ahead + square) < ahead) return FaceTilt{psi, chi};
  }
  return std::nullopt;
}

template <class Pair>
FaceTilt RoughGround::tilt_at_impact(Pair&& pair) const {
  const auto u = pair(0);
  FaceTilt tilt;
  if (has_tilt()) {
    // Ahead, the mean angle may be positive or negative; aside, both sides are equally likely.
    const SignedUniform aside(u[1]);
    tilt = {tilt_.draw(u[0]), aside.sign * tilt_.draw(aside.u)};
  }
  if (has_heights()) {
    const auto heights = pair(1);
    tilt.ahead += std::atan(slope_of_heights(heights[0]));
    tilt.aside += std::atan(slope_of_heights(heights[1]));
  }
  return tilt;
}

}  // namespace talus
