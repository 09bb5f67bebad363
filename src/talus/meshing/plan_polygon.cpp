#include "talus/meshing/plan_polygon.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "talus/core/stop.hpp"

namespace talus {

namespace {

// Positive if p is to the left of the line from a to b; 0 on it, within rounding.
double side(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool lies_between(const Vec2& a, const Vec2& b, const Vec2& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= p.y() &&
         p.y() <= std::max(a.y(), b.y());
}

// A common point of two segments, if there is one.
std::optional<Vec2> meeting(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double sc = side(a, b, c), sd = side(a, b, d), sa = side(c, d, a), sb = side(c, d, b);
  if (sc * sd < 0 && sa * sb < 0) return a + sa / (sa - sb) * (b - a);
  if (sc == 0 && lies_between(a, b, c)) return c;
  if (sd == 0 && lies_between(a, b, d)) return d;
  if (sa == 0 && lies_between(c, d, a)) return a;
  if (sb == 0 && lies_between(c, d, b)) return b;
  return std::nullopt;
}

}  // namespace

PlanPolygon::PlanPolygon(std::span<const std::vector<Vec3>> rings)
    : low_(Vec2::all(std::numeric_limits<double>::infinity())), high_(-low_) {
  double heights = 0;
  for (const std::vector<Vec3>& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 a = ring[k].xy(), b = ring[k + 1 < ring.size() ? k + 1 : 0].xy();
      low_ = low_.min(a);
      high_ = high_.max(a);
      if (a.y() == b.y()) continue;  // parallel to the lines along x that are intersected with it
      edges_.push_back(a.y() < b.y() ? Edge(a, b) : Edge(b, a));
      heights += std::abs(b.y() - a.y());
    }
  }
  // An edge of height h has entries in h / band + 1 bands; this number of bands keeps the mean at four an edge or less.
  const double height = edges_.empty() ? 0 : high_.y() - low_.y();
  const double wanted = edges_.empty() ? 1 : 3 * static_cast<double>(edges_.size()) * height / heights;
  const std::size_t bands = std::max<std::size_t>(1, static_cast<std::size_t>(wanted));
  bands_per_metre_ = height > 0 ? static_cast<double>(bands) / height : 0;
  first_.assign(bands + 1, 0);
  for (const Edge& edge : edges_) {
    for (std::size_t b = band_of(edge.from.y()); b <= band_of(edge.to.y()); ++b) ++first_[b + 1];
  }
  for (std::size_t b = 0; b < bands; ++b) first_[b + 1] += first_[b];
  entries_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    for (std::size_t b = band_of(edges_[e].from.y()); b <= band_of(edges_[e].to.y()); ++b) {
      entries_[next[b]++] = static_cast<std::uint32_t>(e);
    }
  }
}

std::size_t PlanPolygon::band_of(double y) const {
  const double band = (y - low_.y()) * bands_per_metre_;
  return std::min(first_.size() - 2, static_cast<std::size_t>(std::max(0.0, band)));
}

void PlanPolygon::crossings(double y, std::vector<double>& x) const {
  x.clear();
  visit_crossings(y, [&](double at) { x.push_back(at); });
  std::sort(x.begin(), x.end());
}

bool PlanPolygon::contains(const Vec2& place) const {
  if (!(place.x() >= low_.x() && place.x() < high_.x())) return false;
  bool within = false;
  visit_crossings(place.y(), [&](double x) { within = within != (x <= place.x()); });
  return within;
}

namespace {

/// The smallest n from 0 to count for which first + n * step is at or beyond `limit`.
std::uint32_t first_at(double first, double step, std::uint32_t count, double limit) {
  const double guess = std::ceil((limit - first) / step);
  std::uint32_t n = guess <= 0 ? 0 : guess >= count ? count : static_cast<std::uint32_t>(guess);
  while (n > 0 && first + (n - 1) * step >= limit) --n;
  while (n < count && first + n * step < limit) ++n;
  return n;
}

}  // namespace

std::pair<std::uint32_t, std::uint32_t> PointsWithin::rows() const {
  const std::uint32_t first = first_at(grid_.first.y(), grid_.dy, grid_.rows, polygon_.low().y());
  return {first, std::max(first, first_at(grid_.first.y(), grid_.dy, grid_.rows, polygon_.high().y()))};
}

void PointsWithin::runs_in(std::uint32_t row, std::vector<Run>& runs) const {
  runs.clear();
  // The first point east of each crossing: there a run begins or ends.
  std::vector<std::uint32_t> turns;
  polygon_.visit_crossings(grid_.y(row),
                           [&](double x) { turns.push_back(first_at(grid_.first.x(), grid_.dx, grid_.columns, x)); });
  if (turns.size() <= grid_.columns) {
    std::sort(turns.begin(), turns.end());
    for (std::size_t k = 0; k + 1 < turns.size(); k += 2) {
      if (turns[k] < turns[k + 1]) runs.push_back({turns[k], turns[k + 1]});
    }
    return;
  }
  // More crossings than points: a point is within if an odd number of crossings precede it.
  std::vector<bool> is_odd(std::size_t{grid_.columns} + 1);
  for (const std::uint32_t turn : turns) is_odd[turn] = !is_odd[turn];
  bool within = false;
  for (std::uint32_t column = 0; column <= grid_.columns; ++column) {
    if (!is_odd[column]) continue;
    if (within) {
      runs.back().last = column;
    } else {
      runs.push_back({column, grid_.columns});
    }
    within = !within;
  }
  if (!runs.empty() && runs.back().first == grid_.columns) runs.pop_back();
}

void runs_in_rows(const PointsWithin& points, std::uint32_t first, std::size_t work_a_row,
                  std::span<std::vector<PointsWithin::Run>> runs) {
  const StopScope* const here = StopScope::current();
  const auto find = [&](std::size_t k) {
    const StopScope there(here);
    stop_point();
    points.runs_in(first + static_cast<std::uint32_t>(k), runs[k]);
  };
  constexpr std::size_t worth_threads = std::size_t{1} << 20;  // edges to visit: a millisecond or more
  if (work_a_row * runs.size() > worth_threads) {
    tbb::parallel_for(std::size_t{0}, runs.size(), find);
  } else {
    for (std::size_t k = 0; k < runs.size(); ++k) find(k);
  }
}

std::optional<Vec2> self_crossing(std::span<const Vec2> ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % n];
    for (std::size_t j = i + 1; j < n; ++j) {
      const Vec2 &c = ring[j], &d = ring[(j + 1) % n];
      const bool follows = j == i + 1, leads = (j + 1) % n == i;
      if (follows || leads) {
        // Neighbours share a vertex, but must not double back over each other.
        const Vec2 &common = follows ? b : a, &before = follows ? a : b, &after = follows ? d : c;
        if (side(before, common, after) == 0 && (after - common).dot(before - common) > 0) return common;
      } else if (const auto at = meeting(a, b, c, d)) {
        return at;
      }
    }
  }
  return std::nullopt;
}

std::optional<Vec2> line_crossing(std::span<const Vec2> line) {
  if (line.size() < 3) return std::nullopt;
  // Pieces sorted by where they begin along x: only those that begin before a piece ends can meet it.
  std::vector<std::size_t> pieces(line.size() - 1);
  std::iota(pieces.begin(), pieces.end(), std::size_t{0});
  const auto begin = [&](std::size_t k) { return std::min(line[k].x(), line[k + 1].x()); };
  const auto end = [&](std::size_t k) { return std::max(line[k].x(), line[k + 1].x()); };
  std::stable_sort(pieces.begin(), pieces.end(), [&](std::size_t a, std::size_t b) { return begin(a) < begin(b); });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces.size() && begin(pieces[j]) <= end(pieces[i]); ++j) {
      const std::size_t first = std::min(pieces[i], pieces[j]), second = std::max(pieces[i], pieces[j]);
      if (second == first + 1) {
        const Vec2 &before = line[first], &common = line[second], &after = line[second + 1];
        if (side(before, common, after) == 0 && (after - common).dot(before - common) > 0) return common;
      } else if (const auto at = meeting(line[first], line[first + 1], line[second], line[second + 1])) {
        return at;
      }
    }
  }
  return std::nullopt;
}

}  // namespace talus
