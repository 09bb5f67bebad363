#include "talus/meshing/survey_diagonals.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "talus/core/stop.hpp"
#include "talus/terrain/cell_diagonal.hpp"

namespace talus {
namespace {

using Vertex = Triangulation::Vertex;
using Side = Triangulation::Side;

constexpr double least_twist_m = 1e-9;
/// A vertex continues the side of a square if it is off the place on the other side of the corner by at most this share
/// of the side.
constexpr double continues_share = 0.1;

// The distance of `d` from the circle through a, b and c, as a share of its radius.
double off_circle(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  const auto from_a = [&](GridPoint p) { return Vec2(double{1} * p.x - a.x, double{1} * p.y - a.y); };
  const Vec2 u = from_a(b), v = from_a(c);
  const double area = 2 * (u.x() * v.y() - u.y() * v.x());
  const Vec2 centre =
      Vec2(v.y() * u.squared_norm() - u.y() * v.squared_norm(), u.x() * v.squared_norm() - v.x() * u.squared_norm()) /
      area;
  return std::abs((from_a(d) - centre).norm() / centre.norm() - 1);
}

// A square of four vertices, counter-clockwise; a triangle's side leads from `a` to `b`.
struct Square {
  Vertex a, d, b, c;
};

class DiagonalFlips {
 public:
  DiagonalFlips(Triangulation& t, const SurveyPlaces& places) : t_(t), places_(places) {}

  // What is to be flipped is found first: then one flip cannot change the next, and this terminates.
  std::size_t run() {
    std::vector<Square> found;
    for (std::uint32_t i = 0; i < t_.triangles().size(); ++i) {
      stop_point(i);
      for (std::uint32_t k = 0; k < 3; ++k) {
        const Side side{i, k};
        if (t_.from(side) >= t_.to(side) || t_.is_fixed(side)) continue;
        const Square square = square_of(side);
        if (should_flip(side, square)) found.push_back(square);
      }
    }
    std::size_t flipped = 0;
    for (const Square& square : found) {
      const auto side = t_.side(square.a, square.b);
      if (!side || t_.apex(*side) != square.c || t_.apex(t_.twin(*side)) != square.d) continue;
      t_.flip(*side);
      ++flipped;
    }
    return flipped;
  }

 private:
  [[nodiscard]] Square square_of(Side side) const {
    return {t_.from(side), t_.apex(t_.twin(side)), t_.to(side), t_.apex(side)};
  }
  [[nodiscard]] bool is_off_lines(Vertex v) const { return v != Triangulation::infinity && places_.is_on_line[v] == 0; }

  [[nodiscard]] bool should_flip(Side side, const Square& square) const {
    const auto [a, d, b, c] = square;
    if (!is_off_lines(a) || !is_off_lines(b) || !is_off_lines(c) || !is_off_lines(d)) return false;
    const auto& z = places_.height;
    if (std::abs(z[a] + z[b] - (z[c] + z[d])) < least_twist_m || !t_.can_flip(side)) return false;
    const GridPoint at_a = t_.point(a), at_b = t_.point(b), at_c = t_.point(c), at_d = t_.point(d);
    if (off_circle(at_a, at_b, at_c, at_d) > cocircular_share) return false;
    if (off_circle(at_a, at_b, at_d, at_c) > cocircular_share) return false;
    const double bend = bend_of(a, d) + bend_of(c, b) + (bend_of(a, c) + bend_of(d, b));
    return !is_edge_north_east({.sw = z[a], .se = z[d], .nw = z[c], .ne = z[b]}, bend);
  }
  [[nodiscard]] double bend_of(Vertex first, Vertex second) const {
    return bend_along(height_beyond(first, second), places_.height[first], places_.height[second],
                      height_beyond(second, first));
  }
  // The height of the neighbour of a vertex that continues the side from another one; NaN without one.
  [[nodiscard]] double height_beyond(Vertex v, Vertex other) const {
    const auto way = [&](Vertex from, Vertex to) {
      const GridPoint p = t_.point(from), q = t_.point(to);
      return Vec2(double{1} * q.x - p.x, double{1} * q.y - p.y);
    };
    const Vec2 on = way(other, v);
    const Side first = t_.side_from(v);
    Side side = first;
    do {
      const Vertex next = t_.to(side);
      if (next != Triangulation::infinity && (way(v, next) - on).norm() <= continues_share * on.norm()) {
        return places_.height[next];
      }
      side = t_.next_around(side);
    } while (t_.to(side) != t_.to(first));
    return std::numeric_limits<double>::quiet_NaN();
  }

  Triangulation& t_;
  const SurveyPlaces& places_;
};

}  // namespace

std::size_t choose_diagonals(Triangulation& triangulation, const SurveyPlaces& places) {
  return DiagonalFlips(triangulation, places).run();
}

}  // namespace talus
