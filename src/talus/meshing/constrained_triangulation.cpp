#include "talus/meshing/constrained_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "talus/core/check.hpp"

namespace talus {
namespace {

constexpr Triangulation::Vertex infinity = Triangulation::infinity;

// Whether `c`, on the line through `a` and `b`, is on b's side of a.
bool is_ahead(GridPoint a, GridPoint b, GridPoint c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - a.x) + (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - a.y) >
         0;
}

}  // namespace

void ConstrainedTriangulation::add(Vertex a, Vertex b) {
  if (a == b) {
    ++report_.zero_length;
    return;
  }
  ++report_.segments;
  waiting_.push_back(between(a, b));
  while (!waiting_.empty()) {
    const Segment segment = waiting_.back();
    waiting_.pop_back();
    if (segment.a != segment.b) lay(segment);
  }
}

void ConstrainedTriangulation::lay(const Segment& segment) {
  Meeting meeting = way_of(segment);
  if (meeting.blocked) {
    cross(segment, *meeting.blocked);
    return;
  }
  if (meeting.reached == segment.b) {
    flip_out_of_the_way(segment, std::move(meeting.crossed));
    return;
  }
  const double z = height_on(segment, triangulation_.point(meeting.reached));
  note_beside(meeting.reached, z);
  waiting_.push_back({meeting.reached, segment.b, z, segment.z_b});
  waiting_.push_back({segment.a, meeting.reached, segment.z_a, z});
}

ConstrainedTriangulation::Meeting ConstrainedTriangulation::way_of(const Segment& segment) const {
  const Triangulation& t = triangulation_;
  const GridPoint a = t.point(segment.a), b = t.point(segment.b);
  // Positive for vertices to the left of the segment's line.
  const auto side_of = [&](Vertex v) { return doubled_area(a, b, t.point(v)); };
  const auto passes = [&](Vertex v) { return is_on_way(a, b, t.point(v)); };
  Meeting meeting;

  // Find the triangle around the start through which the segment leaves.
  const Triangulation::Side first = t.side_from(segment.a);
  Triangulation::Side leaving = first;
  for (;; leaving = t.next_around(leaving)) {
    const Vertex right = t.to(leaving), left = t.apex(leaving);
    if (right != infinity) {
      const std::int64_t to_right = side_of(right);
      if (to_right == 0 && is_ahead(a, b, t.point(right))) {
        meeting.reached = right;
        return meeting;
      }
      if (left != infinity && to_right < 0 && side_of(left) > 0) break;
    }
    TALUS_PROMISE(t.next_around(leaving).triangle != first.triangle,
                  "the end is finite, so the segment leaves through some triangle");
  }

  for (const Vertex beside : {t.to(leaving), t.apex(leaving)}) {
    if (!passes(beside)) continue;
    meeting.reached = beside;
    return meeting;
  }

  // Walk from triangle to triangle, always across the side between a vertex to the right and one to the left.
  Triangulation::Side across = t.next_side(leaving);
  for (;;) {
    if (t.is_fixed(across)) {
      meeting.blocked = between(t.from(across), t.to(across));
      return meeting;
    }
    meeting.crossed.push_back({t.from(across), t.to(across)});
    const Triangulation::Side beyond = t.twin(across);
    const Vertex ahead = t.apex(beyond);
    if (passes(ahead)) {
      meeting.reached = ahead;
      return meeting;
    }
    across = t.next_side(beyond);
    if (side_of(ahead) < 0) across = t.next_side(across);
  }
}

void ConstrainedTriangulation::flip_out_of_the_way(const Segment& segment, std::vector<std::array<Vertex, 2>> crossed) {
  Triangulation& t = triangulation_;
  const GridPoint a = t.point(segment.a), b = t.point(segment.b);
  std::deque<std::array<Vertex, 2>> waiting(crossed.begin(), crossed.end());
  std::vector<std::array<Vertex, 2>> flipped;
  while (!waiting.empty()) {
    const std::array<Vertex, 2> ends = waiting.front();
    waiting.pop_front();
    const auto side = t.side(ends[0], ends[1]);
    TALUS_PROMISE(side.has_value(), "a side stays until it is flipped");
    if (!t.can_flip(*side)) {
      waiting.push_back(ends);
      continue;
    }
    const Vertex c = t.apex(*side), d = t.apex(t.twin(*side));
    t.flip(*side);
    const bool is_beside = c == segment.a || c == segment.b || d == segment.a || d == segment.b ||
                           (doubled_area(a, b, t.point(c)) > 0) == (doubled_area(a, b, t.point(d)) > 0);
    (is_beside ? static_cast<void>(flipped.push_back({c, d})) : static_cast<void>(waiting.push_back({c, d})));
  }
  const auto side = t.side(segment.a, segment.b);
  TALUS_PROMISE(side.has_value(), "all sides in the way have been flipped");
  if (t.is_fixed(*side)) {
    ++report_.overlapping;
  } else {
    t.fix(*side);
  }
  t.flip_until_delaunay(std::move(flipped));
}

// Both segments are inserted again in pieces that meet at the grid point next to the crossing, or at an end of the
// segment that lies on the fixed one within rounding. That point is in the bounding boxes of both, so |dx| + |dy| of a
// segment is the sum over its pieces: however often pieces cross again, each ends up a single step long, and the
// recursion terminates. It terminates soon, because overlapping pieces meet at their vertices and cross nowhere else.
void ConstrainedTriangulation::cross(const Segment& segment, const Segment& fixed) {
  Triangulation& t = triangulation_;
  GridPoint at = crossing(t.point(segment.a), t.point(segment.b), t.point(fixed.a), t.point(fixed.b));
  for (const Vertex end : {segment.a, segment.b}) {
    if (is_on_way(t.point(fixed.a), t.point(fixed.b), t.point(end))) at = t.point(end);
  }
  const double z = height_on(segment, at);
  double low = z, high = height_on(fixed, at);
  if (low > high) std::swap(low, high);

  const bool meets_fixed_end = at == t.point(fixed.a) || at == t.point(fixed.b);
  if (!meets_fixed_end) {
    t.fix(*t.side(fixed.a, fixed.b), false);
    t.flip_until_delaunay({{fixed.a, fixed.b}});
  }
  const auto [vertex, is_new, on_third] = t.insert(at);
  if (is_new) {
    if (on_third) {
      const double height = height_on(between((*on_third)[0], (*on_third)[1]), at);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    heights_.push_back(0.5 * (low + high));
  } else {
    low = std::min(low, heights_[vertex]);
    high = std::max(high, heights_[vertex]);
  }
  report_.crossings.add(place(vertex));
  if (high - low >= same_height_m) {
    report_.crossings_at_odds.add(place(vertex));
    report_.largest_difference_m = std::max(report_.largest_difference_m, high - low);
  }
  if (!meets_fixed_end) waiting_.insert(waiting_.end(), {between(fixed.a, vertex), between(vertex, fixed.b)});
  waiting_.push_back({vertex, segment.b, z, segment.z_b});
  waiting_.push_back({segment.a, vertex, segment.z_a, z});
}

double ConstrainedTriangulation::height_on(const Segment& segment, GridPoint at) const {
  const GridPoint a = triangulation_.point(segment.a), b = triangulation_.point(segment.b);
  const double dx = double{1} * b.x - a.x, dy = double{1} * b.y - a.y;
  const double share = ((double{1} * at.x - a.x) * dx + (double{1} * at.y - a.y) * dy) / (dx * dx + dy * dy);
  return std::lerp(segment.z_a, segment.z_b, std::clamp(share, 0.0, 1.0));
}

Vec3 ConstrainedTriangulation::place(Vertex v) const {
  const Vec2 plan = grid_.place(triangulation_.point(v));
  return {plan.x(), plan.y(), heights_[v]};
}

void ConstrainedTriangulation::note_beside(Vertex v, double line_height) {
  const double apart = std::abs(heights_[v] - line_height);
  if (apart < same_height_m) return;
  report_.vertices_at_odds.add(place(v));
  report_.largest_vertex_difference_m = std::max(report_.largest_vertex_difference_m, apart);
}

}  // namespace talus
