#include "talus/meshing/loose_edges.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

#include "talus/core/stop.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/terrain/bvh.hpp"

namespace talus {
namespace {

// A facet in local coordinates, close to the origin.
struct Facet {
  std::array<Vec3, 3> corner;

  [[nodiscard]] Vec3 area_vector() const { return (corner[1] - corner[0]).cross(corner[2] - corner[0]); }

  [[nodiscard]] bool is_within(double reach, const Vec3& place) const {
    const Vec3 normal = area_vector().normalized();
    bool is_inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 along = corner[(k + 1) % 3] - corner[k], to_place = place - corner[k];
      const double share = std::clamp(to_place.dot(along) / along.squared_norm(), 0.0, 1.0);
      if ((to_place - share * along).norm() <= reach) return true;
      is_inside = is_inside && along.cross(to_place).dot(normal) >= 0;
    }
    return is_inside && std::abs((place - corner[0]).dot(normal)) <= reach;
  }

  // The elevation of its plane straight above or below a place; nullopt if it is vertical or to the side.
  [[nodiscard]] std::optional<double> height_at(const Vec3& place) const {
    const Vec3 normal = area_vector().normalized();
    if (std::abs(normal.z()) <= vertical_n_z) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 along = corner[(k + 1) % 3] - corner[k], to_place = place - corner[k];
      if ((along.x() * to_place.y() - along.y() * to_place.x()) * normal.z() < 0) return std::nullopt;
    }
    return place.z() + (corner[0] - place).dot(normal) / normal.z();
  }
};

// A place just in front of a boundary edge, and how near another facet must be to make a crack.
struct Probe {
  Vec3 place;
  double reach;
};

Probe probe_of(const Facet& facet, std::size_t k, double crack) {
  const Vec3 along = facet.corner[(k + 1) % 3] - facet.corner[k];
  const double reach = std::min(0.5 * crack, 0.125 * along.norm());
  const Vec3 out = along.cross(facet.area_vector()).normalized();
  return {facet.corner[k] + 0.5 * along + reach * out, reach};
}

}  // namespace

LooseEdges loose_edges(const std::vector<Vec3>& vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                       std::span<const MeshEdge> boundary, double crack_m) {
  if (boundary.empty()) return {};
  const Vec3 origin = vertices[triangles[boundary.front().triangle][0]];  // boxes are coarse far from it
  const auto facet = [&](std::uint32_t i) {
    const auto& [a, b, c] = triangles[i];
    return Facet{{vertices[a] - origin, vertices[b] - origin, vertices[c] - origin}};
  };
  std::vector<Probe> probes;
  std::vector<Box> boxes;
  for (const MeshEdge& edge : boundary) {
    const Probe& probe = probes.emplace_back(probe_of(facet(edge.triangle), edge.edge, crack_m));
    boxes.push_back({probe.place - Vec3::all(probe.reach), probe.place + Vec3::all(probe.reach)});
  }

  const Bvh tree{boxes};
  std::vector<std::atomic<bool>> is_crack(boundary.size()), is_below(boundary.size()), is_above(boundary.size());
  const StopScope* const here = StopScope::current();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size()), [&](const auto& range) {
    const StopScope there(here);
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      stop_point(i);
      const Facet other = facet(static_cast<std::uint32_t>(i));
      Box column;
      for (const Vec3& p : other.corner) column.grow(p);
      column.low.z() = -std::numeric_limits<double>::infinity();
      column.high.z() = std::numeric_limits<double>::infinity();
      tree.visit_box(column.low, column.high, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t place = first; place < last; ++place) {
          const std::uint32_t k = tree.order()[place];
          if (boundary[k].triangle == i) continue;
          if (other.is_within(probes[k].reach, probes[k].place)) is_crack[k].store(true, std::memory_order_relaxed);
          if (const auto height = other.height_at(probes[k].place))
            (*height > probes[k].place.z() ? is_below : is_above)[k].store(true, std::memory_order_relaxed);
        }
      });
    }
  });

  LooseEdges found;
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const Vec3 middle = 0.5 * (vertices[boundary[k].ends >> 32] + vertices[boundary[k].ends & 0xFFFFFFFF]);
    if (is_crack[k]) {
      found.cracks.add(middle);
    } else if (is_below[k] && !is_above[k]) {
      found.covered.add(middle);
    }
  }
  return found;
}

}  // namespace talus
