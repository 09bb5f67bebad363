#include "talus/meshing/survey_rim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "talus/core/stop.hpp"

namespace talus {
namespace {

using Side = Triangulation::Side;

// Removes triangles from the rim until none there is too long or too flat. Whether one is removed depends only on its
// shape and its side at the rim, so that the order makes no difference.
class Rim {
 public:
  Rim(const Triangulation& t, const ExactGrid& grid, const SurveyOptions& options, std::vector<std::uint8_t>& kept,
      SurveyReport& report)
      : t_(t), step_(grid.spacing_m()), options_(options), kept_(kept), report_(report) {}

  void peel() {
    for (std::uint32_t i = 0; i < kept_.size(); ++i) {
      stop_point(i);
      for (std::uint32_t k = 0; k < 3; ++k) waiting_.push_back({i, k});
      remove_pending();
    }
  }

 private:
  void remove_pending() {
    while (!waiting_.empty()) {
      const Side side = waiting_.back();
      waiting_.pop_back();
      if (!kept_[side.triangle] || kept_[t_.twin(side).triangle] || t_.is_fixed(side)) continue;
      const bool is_long = options_.max_edge_m && length(side) > *options_.max_edge_m;
      if (!is_long && !is_flat(side)) continue;
      ++(is_long ? report_.with_long_sides : report_.flat_at_rim);
      kept_[side.triangle] = 0;
      for (const Side other : {t_.next_side(side), t_.next_side(t_.next_side(side))})
        waiting_.push_back(t_.twin(other));
    }
  }

  [[nodiscard]] Vec2 step(Triangulation::Vertex from, Triangulation::Vertex to) const {
    const GridPoint a = t_.point(from), b = t_.point(to);
    return {double{1} * b.x - a.x, double{1} * b.y - a.y};
  }
  [[nodiscard]] double length(Side side) const { return step_ * step(t_.from(side), t_.to(side)).norm(); }
  [[nodiscard]] bool is_flat(Side side) const {
    static const double slope = std::tan((180 - flattest_rim_angle_deg) * std::numbers::pi / 180);
    const auto apex = t_.apex(side);
    const Vec2 a = step(apex, t_.from(side)), b = step(apex, t_.to(side));
    return a.x() * b.y() - a.y() * b.x() < -slope * a.dot(b);
  }

  const Triangulation& t_;
  double step_;
  const SurveyOptions& options_;
  std::vector<std::uint8_t>& kept_;
  SurveyReport& report_;
  std::vector<Side> waiting_;
};

}  // namespace

std::vector<std::uint8_t> kept_triangles(const Triangulation& t, const ExactGrid& grid, const SurveyOptions& options,
                                         SurveyReport& report) {
  std::vector<std::uint8_t> kept(t.triangles().size());
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    kept[i] = t.is_real(i);
    if (!kept[i] || options.boundary.empty()) continue;
    const auto& [a, b, c] = t.triangles()[i].corner;
    const Vec2 middle = (grid.place(t.point(a)) + grid.place(t.point(b)) + grid.place(t.point(c))) / 3;
    const auto& within = options.boundary;
    if (std::any_of(within.begin(), within.end(), [&](const PlanPolygon& p) { return p.contains(middle); })) continue;
    kept[i] = 0;
    ++report.beyond_boundary;
  }
  Rim(t, grid, options, kept, report).peel();
  return kept;
}

void report_rim(const Triangulation& t, const SurveyPlaces& places, const std::vector<std::uint8_t>& kept,
                SurveyReport& report) {
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Side side{i, k};
      if (!kept[i] || kept[t.triangles()[i].neighbour[k]] || t.is_fixed(side)) continue;
      const Vec3 from = places.place(t.from(side)), to = places.place(t.to(side));
      const double length = (to - from).xy().norm();
      if (length <= report.longest_rim_m) continue;
      report.longest_rim_m = length;
      report.longest_rim_at = 0.5 * (from + to);
    }
  }
}

std::size_t holes_in(const Triangulation& t, const std::vector<std::uint8_t>& kept) {
  std::vector<std::uint8_t> seen(kept.size());  // a bit per side at the rim; the highest bit for the triangle itself
  constexpr std::uint8_t reached = 1U << 7U;
  std::size_t pieces = 0, loops = 0;
  std::vector<std::uint32_t> waiting;
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) continue;
    if ((seen[i] & reached) == 0) {
      ++pieces;
      seen[i] |= reached;
      for (waiting.assign(1, i); !waiting.empty();) {
        const std::uint32_t at = waiting.back();
        waiting.pop_back();
        for (const std::uint32_t beyond : t.triangles()[at].neighbour) {
          if (!kept[beyond] || (seen[beyond] & reached) != 0) continue;
          seen[beyond] |= reached;
          waiting.push_back(beyond);
        }
      }
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (kept[t.triangles()[i].neighbour[k]] || (seen[i] >> k & 1U) != 0) continue;
      ++loops;
      for (Side side{i, k}; (seen[side.triangle] >> side.k & 1U) == 0;) {
        seen[side.triangle] = static_cast<std::uint8_t>(seen[side.triangle] | 1U << side.k);
        // The next side of the rim: turn around the end of this one through the kept triangles.
        side = t.next_side(side);
        while (kept[t.twin(side).triangle]) side = t.next_side(t.twin(side));
      }
    }
  }
  return loops - pieces;
}

}  // namespace talus
