#include "talus/terrain/plan_polygon.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace talus {

namespace {

// Which side of the line from a to b a place is on: positive to the left, exactly 0 only as far as rounding goes.
double side(const Vec2& a, const Vec2& b, const Vec2& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool lies_between(const Vec2& a, const Vec2& b, const Vec2& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) && std::min(a.y(), b.y()) <= p.y() &&
         p.y() <= std::max(a.y(), b.y());
}

// A common point of two segments.
std::optional<Vec2> meeting(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double sc = side(a, b, c), sd = side(a, b, d), sa = side(c, d, a), sb = side(c, d, b);
  if (sc * sd < 0 && sa * sb < 0) return Vec2(a + sa / (sa - sb) * (b - a));
  if (sc == 0 && lies_between(a, b, c)) return c;
  if (sd == 0 && lies_between(a, b, d)) return d;
  if (sa == 0 && lies_between(c, d, a)) return a;
  if (sb == 0 && lies_between(c, d, b)) return b;
  return std::nullopt;
}

}  // namespace

PlanPolygon::PlanPolygon(std::span<const std::vector<Vec3>> rings)
    : low_(Vec2::Constant(std::numeric_limits<double>::infinity())), high_(-low_) {
  double heights = 0;
  for (const std::vector<Vec3>& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 a = ring[k].head(2), b = ring[k + 1 < ring.size() ? k + 1 : 0].head(2);
      low_ = low_.cwiseMin(a);
      high_ = high_.cwiseMax(a);
      if (a.y() == b.y()) continue;  // a line along x does not cross it
      edges_.push_back(a.y() < b.y() ? Edge{a, b} : Edge{b, a});
      heights += std::abs(b.y() - a.y());
    }
  }
  // So many bands that no more than four entries an edge are needed: an edge of height h reaches into h / band + 1.
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
  if (!(y >= low_.y() && y < high_.y())) return;
  const std::size_t band = band_of(y);
  for (std::uint32_t k = first_[band]; k < first_[band + 1]; ++k) {
    const auto& [from, to] = edges_[entries_[k]];
    if (y < from.y() || y >= to.y()) continue;
    x.push_back(from.x() + (y - from.y()) * ((to.x() - from.x()) / (to.y() - from.y())));
  }
  std::sort(x.begin(), x.end());
}

bool PlanPolygon::contains(const Vec2& place) const {
  const double y = place.y();
  if (!(y >= low_.y() && y < high_.y() && place.x() >= low_.x() && place.x() < high_.x())) return false;
  const std::size_t band = band_of(y);
  bool within = false;
  for (std::uint32_t k = first_[band]; k < first_[band + 1]; ++k) {
    const auto& [from, to] = edges_[entries_[k]];
    if (y < from.y() || y >= to.y()) continue;
    if (from.x() + (y - from.y()) * ((to.x() - from.x()) / (to.y() - from.y())) <= place.x()) within = !within;
  }
  return within;
}

std::optional<Vec2> self_crossing(std::span<const Vec2> ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % n];
    for (std::size_t j = i + 1; j < n; ++j) {
      const Vec2 &c = ring[j], &d = ring[(j + 1) % n];
      const bool follows = j == i + 1, leads = (j + 1) % n == i;
      if (follows || leads) {
        // Neighbours share a vertex; they may not run back over each other.
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
  // Pieces in the order in which they begin along x: those that can meet a piece begin before it ends.
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
