#include "talus/meshing/survey_diagonals.hpp"

#include <array>
#include <cmath>

#include "talus/core/stop.hpp"

namespace talus {
namespace {

using Vertex = Triangulation::Vertex;
using Side = Triangulation::Side;

constexpr double least_gain_m = 1e-9;

// The distance of `d` from the circle through a, b and c, as a share of its radius.
double off_circle(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  const auto from_a = [&](GridPoint p) { return Vec2(double{1} * p.x - a.x, double{1} * p.y - a.y); };
  const Vec2 u = from_a(b), v = from_a(c);
  const double area = 2 * (u.x() * v.y() - u.y() * v.x());
  const Vec2 centre =
      Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(), u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) / area;
  return std::abs((from_a(d) - centre).norm() / centre.norm() - 1);
}

class DiagonalFlips {
 public:
  DiagonalFlips(Triangulation& t, const SurveyPlaces& places) : t_(t), places_(places) {}

  // Every flip reduces the sum of the height differences along all sides, so this terminates.
  std::size_t run() {
    for (std::uint32_t i = 0; i < t_.triangles().size(); ++i) {
      stop_point(i);
      for (std::uint32_t k = 0; k < 3; ++k) {
        const Side side{i, k};
        if (t_.from(side) < t_.to(side) && should_flip(side)) flip(side);
      }
      while (!waiting_.empty()) {
        const auto [a, b] = waiting_.back();
        waiting_.pop_back();
        const auto side = t_.side(a, b);
        if (side && should_flip(*side)) flip(*side);
      }
    }
    return flipped_;
  }

 private:
  [[nodiscard]] bool is_off_lines(Vertex v) const { return v != Triangulation::infinity && places_.is_on_line[v] == 0; }

  [[nodiscard]] bool should_flip(Side side) const {
    const Vertex a = t_.from(side), b = t_.to(side), c = t_.apex(side);
    if (!is_off_lines(a) || !is_off_lines(b) || !is_off_lines(c)) return false;
    const Vertex d = t_.apex(t_.twin(side));
    if (!is_off_lines(d)) return false;
    const auto& z = places_.height;
    if (std::abs(z[c] - z[d]) >= std::abs(z[a] - z[b]) - least_gain_m) return false;
    if (t_.is_fixed(side) || !t_.can_flip(side)) return false;
    const GridPoint at_a = t_.point(a), at_b = t_.point(b), at_c = t_.point(c), at_d = t_.point(d);
    return off_circle(at_a, at_b, at_c, at_d) <= cocircular_share &&
           off_circle(at_a, at_b, at_d, at_c) <= cocircular_share;
  }

  void flip(Side side) {
    const Vertex a = t_.from(side), b = t_.to(side), c = t_.apex(side), d = t_.apex(t_.twin(side));
    t_.flip(side);
    ++flipped_;
    waiting_.insert(waiting_.end(), {{a, d}, {d, b}, {b, c}, {c, a}});
  }

  Triangulation& t_;
  const SurveyPlaces& places_;
  std::vector<std::array<Vertex, 2>> waiting_;
  std::size_t flipped_ = 0;
};

}  // namespace

std::size_t choose_diagonals(Triangulation& triangulation, const SurveyPlaces& places) {
  return DiagonalFlips(triangulation, places).run();
}

}  // namespace talus
