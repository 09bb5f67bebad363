#include "talus/model/design_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::project {

namespace {

struct Segment {
  Vec2 begin, end;
};

/// A panel's foot on plan between two stations; nullopt if it lies outside.
std::optional<Segment> part_of_foot(const Panel& panel, double from, double to) {
  const double begin = std::max(from, panel.station), end = std::min(to, panel.station + panel.plan_length);
  if (begin > end || (begin == end && panel.plan_length > 0 && from < to)) return std::nullopt;
  const Vec2 foot = panel.foot.xy(), along = panel.along.xy() * panel.length;
  const auto at = [&](double station) -> Vec2 {
    return panel.plan_length > 0 ? foot + along * ((station - panel.station) / panel.plan_length) : foot;
  };
  return Segment{at(begin), at(end)};
}

Segment whole_foot_of(const Panel& panel) { return {panel.foot.xy(), (panel.foot + panel.along * panel.length).xy()}; }

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double distance_to(const Vec2& p, const Segment& s) {
  const Vec2 along = s.end - s.begin;
  const double size = along.squared_norm();
  const double t = size > 0 ? std::clamp((p - s.begin).dot(along) / size, 0.0, 1.0) : 0;
  return (p - s.begin - t * along).norm();
}

bool cross_each_other(const Segment& a, const Segment& b) {
  const auto side = [](const Segment& s, const Vec2& p) { return cross(s.end - s.begin, p - s.begin); };
  return side(a, b.begin) * side(a, b.end) < 0 && side(b, a.begin) * side(b, a.end) < 0;
}

double segment_distance(const Segment& a, const Segment& b) {
  if (cross_each_other(a, b)) return 0;
  return std::min({distance_to(a.begin, b), distance_to(a.end, b), distance_to(b.begin, a), distance_to(b.end, a)});
}

/// A line seen along a direction: its extent, and where it is across that direction.
class Seen {
 public:
  Seen(const talus::Barrier& barrier, const Vec2& along) : along_(along), across_(-along.y(), along.x()) {
    for (const Panel& panel : barrier.panels()) segments_.push_back(whole_foot_of(panel));
    for (const Segment& segment : segments_) {
      for (const Vec2& end : {segment.begin, segment.end}) {
        low = std::min(low, end.dot(along_));
        high = std::max(high, end.dot(along_));
      }
    }
  }

  /// Where it is across the direction, at this place along it; beyond its ends, where the end is.
  [[nodiscard]] double across_at(double place) const {
    double nearest = std::numeric_limits<double>::infinity(), across = 0;
    for (const Segment& segment : segments_) {
      const double a = segment.begin.dot(along_), b = segment.end.dot(along_);
      const double at = std::clamp(place, std::min(a, b), std::max(a, b));
      if (std::abs(at - place) >= nearest) continue;
      nearest = std::abs(at - place);
      const double t = a == b ? 0 : (at - a) / (b - a);
      across = (segment.begin + t * (segment.end - segment.begin)).dot(across_);
    }
    return across;
  }

  double low = std::numeric_limits<double>::infinity(), high = -low;

 private:
  Vec2 along_, across_;
  std::vector<Segment> segments_;
};

}  // namespace

std::vector<LinePiece> pieces_of(const talus::Barrier& barrier) {
  std::vector<LinePiece> pieces;
  for (const Panel& panel : barrier.panels()) {
    const Vec2 along = panel.along.xy();
    if (along.norm() == 0) continue;
    const Vec2 unit = along.normalized();
    // Panels between two bends of the line share its direction.
    constexpr double same = 1e-9;
    if (!pieces.empty() && std::hypot(pieces.back().along_x - unit.x(), pieces.back().along_y - unit.y()) < same)
      continue;
    pieces.push_back({panel.station, unit.x(), unit.y()});
  }
  return pieces;
}

double distance_between(const talus::Barrier& line, double from, double to, const talus::Barrier& other) {
  double least = std::numeric_limits<double>::infinity();
  for (const Panel& panel : line.panels()) {
    const auto foot = part_of_foot(panel, from, to);
    if (!foot) continue;
    for (const Panel& there : other.panels()) least = std::min(least, segment_distance(*foot, whole_foot_of(there)));
  }
  return least;
}

std::optional<Stagger> stagger_of(const talus::Barrier& one, const talus::Barrier& other) {
  const Vec2 chord = whole_foot_of(one.panels().back()).end - whole_foot_of(one.panels().front()).begin;
  if (chord.norm() == 0) return std::nullopt;
  const Vec2 along = chord.normalized();
  const Seen a(one, along), b(other, along);
  const bool is_staggered = (a.low < b.low && a.high < b.high) || (a.low > b.low && a.high > b.high);
  if (!is_staggered) return std::nullopt;
  const double from = std::max(a.low, b.low), to = std::min(a.high, b.high), middle = 0.5 * (from + to);
  return Stagger{to - from, std::abs(a.across_at(middle) - b.across_at(middle))};
}

}  // namespace talus::project
