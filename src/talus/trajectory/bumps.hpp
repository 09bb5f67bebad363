#pragma once
// Bumps along the way: where a rock that slides or rolls over rough ground strikes a face of it. The way from bump to
// bump is exponentially distributed, its mean the spacing of the ground (RoughGround::bump_spacing). It is counted in
// spacings, from a stream of random numbers of its own, so that it depends on the rock, the materials and the way along
// the ground, and not on facets, legs or flights between.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "talus/flight/parabola.hpp"
#include "talus/sampling/draws.hpp"

namespace talus {

class Bumps {
 public:
  /// The way to the next bump on ground of this spacing [m].
  [[nodiscard]] double way(const Draws& draws, double spacing) {
    if (!left_) left_ = -std::log(draws.one(Stream::bump, number_));
    return *left_ * spacing;
  }
  /// The rock has moved along ground of this spacing, not beyond the next bump [m].
  void cover(double way, double spacing) {
    if (left_) left_ = std::max(0.0, *left_ - way / spacing);
  }
  /// The rock has met the bump.
  void pass() {
    left_.reset();
    ++number_;
  }

 private:
  std::optional<double> left_;  // to the next bump, in spacings; drawn when it is first asked for
  std::uint32_t number_ = 0;    // of bumps met
};

/// The length of a path until `t` [m]. Exact on a straight line; curved legs turn by little.
[[nodiscard]] inline double arc_length(const Parabola& path, double t) {
  // Gauss-Legendre with three points: exact for a speed that is a polynomial of degree 5 in time.
  static constexpr double place = 0.77459666924148338;  // sqrt(3/5)
  const double half = 0.5 * t;
  const auto speed = [&](double x) { return path.velocity(half * (1 + x)).norm(); };
  return half * (5 * (speed(-place) + speed(place)) + 8 * speed(0)) / 9;
}

/// When a path has the length `way` [s]; nullopt if not before `t`. Expects a path that does not turn back before `t`.
[[nodiscard]] inline std::optional<double> time_at_length(const Parabola& path, double way, double t) {
  if (std::isfinite(t) && arc_length(path, t) < way) return std::nullopt;
  const double speed = path.v.norm();
  const double gain = speed > 0 ? path.a.dot(path.v) / speed : path.a.norm();
  const double square = speed * speed + 2 * gain * way;
  if (!(square > 0)) return std::nullopt;  // it stands still before, or never moves
  double at = std::min(t, 2 * way / (speed + std::sqrt(square)));
  constexpr int corrections = 3;  // of the straight line's time, for curved legs
  for (int k = 0; k < corrections; ++k) {
    const double error = arc_length(path, at) - way;
    if (error == 0) break;
    at = std::clamp(at - error / path.velocity(at).norm(), 0.0, t);
  }
  return at;
}

}  // namespace talus
