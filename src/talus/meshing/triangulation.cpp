#include "talus/meshing/triangulation.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "talus/core/check.hpp"
#include "talus/core/stop.hpp"

namespace talus {
namespace {

// The position of a point along the Hilbert curve over the grid (Skilling 2004, in two dimensions).
std::uint64_t along_hilbert_curve(GridPoint p) {
  auto x = static_cast<std::uint32_t>(p.x), y = static_cast<std::uint32_t>(p.y);
  std::uint64_t way = 0;
  for (std::uint32_t half = 1U << ExactGrid::bits; half > 0; half >>= 1) {
    const std::uint32_t right = (x & half) != 0, upper = (y & half) != 0;
    way = way << 2 | ((3 * right) ^ upper);
    if (upper == 0) {
      if (right != 0) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return way;
}

// The insertion round of a point: half of them are in round 0, a quarter in round 1 and so on. It is a hash of the
// number, so that the order is always the same (SplitMix64: Steele, Lea and Flood 2014).
std::uint64_t round_of(std::uint64_t number) {
  std::uint64_t z = number + 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return static_cast<std::uint64_t>(std::min(std::countr_zero(z ^ (z >> 31U)), 31));
}

std::vector<std::uint32_t> order_of_insertion(std::span<const GridPoint> points) {
  struct Place {
    std::uint64_t way;
    std::uint32_t round, vertex;
    bool operator<(const Place& o) const {
      if (round != o.round) return round > o.round;  // the round with the fewest points first
      return way != o.way ? way < o.way : vertex < o.vertex;
    }
  };
  std::vector<Place> places(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    places[i] = {along_hilbert_curve(points[i]), static_cast<std::uint32_t>(round_of(i)), i};
  }
  tbb::parallel_sort(places);
  std::vector<std::uint32_t> order;
  order.reserve(points.size());
  for (const Place& place : places) order.push_back(place.vertex);
  return order;
}

// The first point that is not on the line through the first two.
std::optional<std::uint32_t> off_the_line(std::span<const GridPoint> points) {
  for (std::uint32_t i = 2; i < points.size(); ++i) {
    if (doubled_area(points[0], points[1], points[i]) != 0) return i;
  }
  return std::nullopt;
}

}  // namespace

bool Triangulation::span_a_plane(std::span<const GridPoint> points) { return off_the_line(points).has_value(); }

Triangulation::Triangulation(std::vector<GridPoint> points) : points_(std::move(points)) {
  const auto third = off_the_line(points_);
  TALUS_PROMISE(third.has_value(), "the points span a plane");
  triangles_.reserve(2 * points_.size());
  fixed_.reserve(2 * points_.size());
  triangle_of_.resize(points_.size());
  if (doubled_area(points_[0], points_[1], points_[*third]) > 0) {
    begin(0, 1, *third);
  } else {
    begin(0, *third, 1);
  }
  std::size_t done = 0;
  for (const std::uint32_t v : order_of_insertion(points_)) {
    stop_point(++done);
    if (v > 1 && v != *third) insert_vertex(v);
  }
}

bool Triangulation::is_real(std::uint32_t triangle) const {
  const auto& corner = triangles_[triangle].corner;
  return corner[0] != infinity && corner[1] != infinity && corner[2] != infinity;
}

std::uint32_t Triangulation::corner_number(std::uint32_t triangle, Vertex v) const {
  const auto& corner = triangles_[triangle].corner;
  return corner[0] == v ? 0 : corner[1] == v ? 1 : 2;
}

Triangulation::Side Triangulation::twin(Side s) const {
  const std::uint32_t beyond = triangles_[s.triangle].neighbour[s.k];
  return {beyond, corner_number(beyond, to(s))};
}

std::optional<Triangulation::Side> Triangulation::side(Vertex a, Vertex b) const {
  const Side first = side_from(a);
  Side s = first;
  do {
    if (to(s) == b) return s;
    s = next_around(s);
  } while (s.triangle != first.triangle);
  return std::nullopt;
}

void Triangulation::fix(Side s, bool fixed) {
  for (const Side side : {s, twin(s)}) {
    const auto bit = static_cast<std::uint8_t>(1U << side.k);
    std::uint8_t& bits = fixed_[side.triangle];
    bits = static_cast<std::uint8_t>(fixed ? bits | bit : bits & ~bit);
  }
}

void Triangulation::set(std::uint32_t t, const std::array<Vertex, 3>& corner,
                        const std::array<std::uint32_t, 3>& neighbour, std::uint32_t fixed) {
  triangles_[t] = {corner, neighbour};
  fixed_[t] = static_cast<std::uint8_t>(fixed);
  for (const Vertex v : corner) {
    if (v != infinity) triangle_of_[v] = t;
  }
}

void Triangulation::replace_neighbour(std::uint32_t of, std::uint32_t old, std::uint32_t now, Vertex from) {
  std::uint32_t& neighbour = triangles_[of].neighbour[corner_number(of, from)];
  TALUS_PROMISE(neighbour == old, "both triangles of a side link to each other");
  static_cast<void>(old);
  neighbour = now;
}

void Triangulation::begin(Vertex a, Vertex b, Vertex c) {
  triangles_.resize(4);
  fixed_.resize(4);
  set(0, {a, b, c}, {1, 2, 3}, 0);
  set(1, {b, a, infinity}, {0, 3, 2}, 0);
  set(2, {c, b, infinity}, {0, 1, 3}, 0);
  set(3, {a, c, infinity}, {0, 2, 1}, 0);
}

// Walks from triangle to triangle towards the point. In a triangulation that is not Delaunay such a walk can cycle,
// unless the sides are tested in random order (Devillers, Pion and Teillaud 2002).
Triangulation::Located Triangulation::locate(GridPoint p) {
  std::uint32_t t = last_;
  while (is_real(t)) {
    const Triangle& triangle = triangles_[t];
    random_ ^= random_ << 13U;
    random_ ^= random_ >> 17U;
    random_ ^= random_ << 5U;
    std::uint32_t k = random_ % 3, on_sides = 0;
    bool found = true;
    for (int side = 0; side < 3; ++side, k = next(k)) {
      const std::int64_t area = doubled_area(points_[triangle.corner[k]], points_[triangle.corner[next(k)]], p);
      if (area < 0) {
        t = triangle.neighbour[k];
        found = false;
        break;
      }
      if (area == 0) on_sides |= 1U << k;
    }
    if (found) return {t, on_sides};
  }
  return {t, 0};
}

Triangulation::Inserted Triangulation::insert(GridPoint p) {
  const Located at = locate(p);
  if (std::popcount(at.on_sides) == 2) {  // at the corner where the two sides meet
    const std::uint32_t k = at.on_sides == 0b011 ? 1 : at.on_sides == 0b110 ? 2 : 0;
    return {triangles_[at.triangle].corner[k], false, std::nullopt};
  }
  points_.push_back(p);
  triangle_of_.push_back(at.triangle);
  last_ = at.triangle;
  return insert_vertex(static_cast<Vertex>(points_.size() - 1));
}

Triangulation::Inserted Triangulation::insert_vertex(Vertex v) {
  const Located at = locate(points_[v]);
  Inserted result{v, true, std::nullopt};
  if (at.on_sides == 0) {
    split_triangle(at.triangle, v);
  } else {
    const Side on{at.triangle, static_cast<std::uint32_t>(std::countr_zero(at.on_sides))};
    if (is_fixed(on)) result.on_fixed = {from(on), to(on)};
    split_side(on, v);
  }
  flip_around(v);
  last_ = triangle_of_[v];
  // The next search must start in a finite triangle.
  if (!is_real(last_)) last_ = triangles_[last_].neighbour[next(corner_number(last_, infinity))];
  return result;
}

void Triangulation::split_triangle(std::uint32_t t, Vertex v) {
  const auto [a, b, c] = triangles_[t].corner;
  const auto [ab, bc, ca] = triangles_[t].neighbour;
  const std::uint32_t fixed = fixed_[t];
  const auto u = static_cast<std::uint32_t>(triangles_.size()), w = u + 1;
  triangles_.resize(triangles_.size() + 2);
  fixed_.resize(triangles_.size());
  set(t, {a, b, v}, {ab, u, w}, fixed & 1U);
  set(u, {b, c, v}, {bc, w, t}, fixed >> 1U & 1U);
  set(w, {c, a, v}, {ca, t, u}, fixed >> 2U & 1U);
  replace_neighbour(bc, t, u, c);
  replace_neighbour(ca, t, w, a);
  waiting_.insert(waiting_.end(), {t, u, w});
}

void Triangulation::split_side(Side s, Vertex v) {
  const Side other = twin(s);
  const std::uint32_t t = s.triangle, u = other.triangle;
  const Vertex a = from(s), b = to(s), c = apex(s), d = apex(other);
  const std::uint32_t bc = triangles_[t].neighbour[next(s.k)], ca = triangles_[t].neighbour[before(s.k)];
  const std::uint32_t ad = triangles_[u].neighbour[next(other.k)], db = triangles_[u].neighbour[before(other.k)];
  const auto bit = [&](Side side) { return std::uint32_t{is_fixed(side)}; };
  const std::uint32_t on = bit(s), fixed_bc = bit({t, next(s.k)}), fixed_ca = bit({t, before(s.k)});
  const std::uint32_t fixed_ad = bit({u, next(other.k)}), fixed_db = bit({u, before(other.k)});
  const auto t2 = static_cast<std::uint32_t>(triangles_.size()), u2 = t2 + 1;
  triangles_.resize(triangles_.size() + 2);
  fixed_.resize(triangles_.size());
  set(t, {c, a, v}, {ca, u, t2}, fixed_ca | on << 1U);
  set(t2, {b, c, v}, {bc, t, u2}, fixed_bc | on << 2U);
  set(u, {a, d, v}, {ad, u2, t}, fixed_ad | on << 2U);
  set(u2, {d, b, v}, {db, t2, u}, fixed_db | on << 1U);
  replace_neighbour(bc, t, t2, c);
  replace_neighbour(db, u, u2, b);
  waiting_.insert(waiting_.end(), {t, t2, u, u2});
}

void Triangulation::flip_around(Vertex v) {
  while (!waiting_.empty()) {
    const std::uint32_t t = waiting_.back();
    waiting_.pop_back();
    const Side opposite{t, next(corner_number(t, v))};
    if (is_fixed(opposite) || !needs_flip(opposite)) continue;
    const std::uint32_t other = twin(opposite).triangle;
    flip(opposite);
    waiting_.insert(waiting_.end(), {t, other});
  }
}

// The circle of a triangle beyond the hull degenerates to the half plane outside its finite side. The common side of
// two such triangles goes to infinity; it is flipped where the hull would be concave.
bool Triangulation::needs_flip(Side s) const {
  const Vertex a = from(s), b = to(s), c = apex(s), d = apex(twin(s));
  if (c == infinity || d == infinity) return false;
  if (a == infinity) return doubled_area(points_[d], points_[b], points_[c]) > 0;
  if (b == infinity) return doubled_area(points_[c], points_[a], points_[d]) > 0;
  return in_circle(points_[a], points_[b], points_[c], points_[d]);
}

bool Triangulation::can_flip(Side s) const {
  const Vertex a = from(s), b = to(s), c = apex(s), d = apex(twin(s));
  if (a == infinity || b == infinity || c == infinity || d == infinity) return false;
  return doubled_area(points_[a], points_[d], points_[c]) > 0 && doubled_area(points_[d], points_[b], points_[c]) > 0;
}

void Triangulation::flip(Side s) {
  const Side other = twin(s);
  const std::uint32_t t = s.triangle, u = other.triangle;
  const Vertex a = from(s), b = to(s), c = apex(s), d = apex(other);
  const std::uint32_t bc = triangles_[t].neighbour[next(s.k)], ca = triangles_[t].neighbour[before(s.k)];
  const std::uint32_t ad = triangles_[u].neighbour[next(other.k)], db = triangles_[u].neighbour[before(other.k)];
  const auto bit = [&](Side side) { return std::uint32_t{is_fixed(side)}; };
  const std::uint32_t fixed_bc = bit({t, next(s.k)}), fixed_ca = bit({t, before(s.k)});
  const std::uint32_t fixed_ad = bit({u, next(other.k)}), fixed_db = bit({u, before(other.k)});
  set(t, {a, d, c}, {ad, u, ca}, fixed_ad | fixed_ca << 2U);
  set(u, {d, b, c}, {db, bc, t}, fixed_db | fixed_bc << 1U);
  replace_neighbour(ad, u, t, d);
  replace_neighbour(bc, t, u, c);
}

void Triangulation::flip_until_delaunay(std::vector<std::array<Vertex, 2>> sides) {
  while (!sides.empty()) {
    const auto [a, b] = sides.back();
    sides.pop_back();
    const auto s = side(a, b);
    if (!s || is_fixed(*s) || !needs_flip(*s)) continue;
    const Vertex c = apex(*s), d = apex(twin(*s));
    flip(*s);
    sides.insert(sides.end(), {{a, d}, {d, b}, {b, c}, {c, a}});
  }
}

}  // namespace talus
