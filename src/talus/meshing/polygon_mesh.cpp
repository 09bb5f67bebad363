#include "talus/meshing/polygon_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "talus/core/problems.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/meshing/constrained_triangulation.hpp"

namespace talus {
namespace {

constexpr std::size_t most_reported = 10;

std::string text(const Vec3& at) { return fmt::format("({:.3f}, {:.3f}, {:.3f})", at.x(), at.y(), at.z()); }

// Why a polygon cannot be triangulated.
struct Fault {
  std::string what, why, hint;
};

// Twice the area vector of a ring, computed relative to its first point.
Vec3 area_vector(const std::vector<Vec3>& ring) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += (ring[i] - ring[0]).cross(ring[i + 1] - ring[0]);
  return sum;
}

// Triangulates one polygon in its plane.
class PolygonCut {
 public:
  PolygonCut(const SpacePolygon& polygon, RawMesh& mesh, PolygonReport& report)
      : polygon_(polygon), mesh_(mesh), report_(report) {}

  [[nodiscard]] std::optional<Fault> fault() {
    for (const auto& ring : polygon_.rings) {
      for (const Vec3& p : ring) {
        if (!(p.abs().largest() < largest_coordinate_m)) {
          return Fault{"has the corner " + text(p),
                       fmt::format("coordinates must be smaller than {:g} m", largest_coordinate_m),
                       "Are they in metres?"};
        }
      }
    }
    if (polygon_.rings.empty() || polygon_.rings.front().size() < 3) {
      const std::size_t corners = polygon_.rings.empty() ? 0 : polygon_.rings.front().size();
      return Fault{fmt::format("has {}", counted(corners, "corner", "corners")), "a polygon has three or more", ""};
    }
    if (auto without_plane = find_plane()) return without_plane;
    if (auto touching = lay_out()) return touching;
    return cut();
  }

 private:
  std::optional<Fault> find_plane() {
    const std::vector<Vec3>& outer = polygon_.rings.front();
    middle_ = Vec3{};
    for (const Vec3& p : outer) middle_ += (p - outer[0]) / static_cast<double>(outer.size());
    middle_ += outer[0];
    double reach = 0;
    for (const Vec3& p : outer) reach = std::max(reach, (p - outer[0]).norm());
    const Vec3 area = area_vector(outer);
    if (area.norm() <= smallest_facet_height_m * reach) {
      return Fault{"has no area", "its corners lie on one line, its border doubles back, or its sides cross", ""};
    }
    normal_ = area.normalized();
    const std::size_t across = (-normal_.abs()).place_of_largest();
    u_ = normal_.cross(across == 0 ? unit_x : across == 1 ? unit_y : unit_z).normalized();
    v_ = normal_.cross(u_);
    return std::nullopt;
  }

  // Rounds the corners to a grid in the plane; no two may coincide.
  std::optional<Fault> lay_out() {
    Vec2 low = Vec2::all(std::numeric_limits<double>::infinity()), high = -low;
    double farthest = 0;
    std::vector<Vec2> flat;
    for (const auto& ring : polygon_.rings) {
      for (const Vec3& p : ring) {
        corners_.push_back(p);
        flat.emplace_back((p - middle_).dot(u_), (p - middle_).dot(v_));
        low = low.min(flat.back());
        high = high.max(flat.back());
        farthest = std::max(farthest, std::abs((p - middle_).dot(normal_)));
      }
    }
    if ((high - low).largest() > ExactGrid::widest_m) {
      return Fault{fmt::format("is {:.0f} m wide", (high - low).largest()),
                   fmt::format("Talus triangulates up to {:.0f} m", ExactGrid::widest_m), "Are its corners in metres?"};
    }
    grid_ = ExactGrid::over(low, high);
    for (const Vec2& p : flat) points_.push_back(grid_.snapped(p.x(), p.y()));
    std::vector<std::uint32_t> order(points_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return points_[a] != points_[b] ? points_[a] < points_[b] : a < b; });
    for (std::size_t k = 1; k < order.size(); ++k) {
      if (points_[order[k]] == points_[order[k - 1]]) return touches(corners_[order[k]]);
    }
    if (farthest > bent_m) report_.bent.add(middle_);
    report_.largest_departure_m = std::max(report_.largest_departure_m, farthest);
    return std::nullopt;
  }

  std::optional<Fault> cut() {
    if (!Triangulation::span_a_plane(points_)) return Fault{"has no area", "its corners lie on one line", ""};
    Triangulation triangulation(points_);
    std::vector<double> heights(points_.size());  // required, but not used here
    ConstrainedTriangulation sides(triangulation, heights, grid_);
    std::uint32_t first = 0;
    for (const auto& ring : polygon_.rings) {
      const auto corners = static_cast<std::uint32_t>(ring.size());
      for (std::uint32_t i = 0; i < corners; ++i) sides.add(first + i, first + (i + 1) % corners);
      first += corners;
    }
    if (sides.report().crossings.count > 0) return crosses(sides.report().crossings.examples.front().xy());
    // Every corner has two sides of its ring: more or fewer if a side passes through a corner.
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      if (fixed_sides(triangulation, v) != 2) return touches(corners_[v]);
    }
    take_inside(triangulation);
    return std::nullopt;
  }

  static std::size_t fixed_sides(const Triangulation& t, Triangulation::Vertex v) {
    std::size_t count = 0;
    const auto first = t.side_from(v);
    auto side = first;
    do {
      count += t.is_fixed(side);
      side = t.next_around(side);
    } while (side.triangle != first.triangle);
    return count;
  }

  // Flood fill from outside: each side of a ring leads in or out.
  void take_inside(const Triangulation& t) {
    enum : std::uint8_t { unknown, outside, inside };
    std::vector<std::uint8_t> where(t.triangles().size(), unknown);
    std::vector<std::uint32_t> waiting;
    for (std::uint32_t i = 0; i < where.size(); ++i) {
      if (t.is_real(i)) continue;
      where[i] = outside;
      waiting.push_back(i);
    }
    const auto base = static_cast<std::uint32_t>(mesh_.vertices.size());
    while (!waiting.empty()) {
      const std::uint32_t i = waiting.back();
      waiting.pop_back();
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t beyond = t.triangles()[i].neighbour[k];
        if (where[beyond] != unknown) continue;
        where[beyond] = t.is_fixed({i, k}) == (where[i] == inside) ? outside : inside;
        waiting.push_back(beyond);
      }
    }
    for (std::uint32_t i = 0; i < where.size(); ++i) {
      if (where[i] != inside) continue;
      const auto& [a, b, c] = t.triangles()[i].corner;
      mesh_.triangles.push_back({base + a, base + b, base + c});
      ++report_.triangles;
    }
    mesh_.vertices.insert(mesh_.vertices.end(), corners_.begin(), corners_.end());
  }

  [[nodiscard]] static Fault touches(const Vec3& at) {
    return {"touches itself at " + text(at), "a polygon may pass each place only once", "Split it in two there"};
  }
  [[nodiscard]] Fault crosses(const Vec2& at) const {
    return {"crosses itself at " + text(middle_ + at.x() * u_ + at.y() * v_), "it cannot be triangulated",
            "Are its vertices in order?"};
  }

  const SpacePolygon& polygon_;
  RawMesh& mesh_;
  PolygonReport& report_;
  Vec3 middle_, normal_, u_, v_;
  ExactGrid grid_;
  std::vector<Vec3> corners_;
  std::vector<GridPoint> points_;
};

}  // namespace

RawMesh triangulated(std::span<const SpacePolygon> polygons, const std::string& source, PolygonReport& report) {
  RawMesh mesh;
  Problems problems;
  std::size_t faults = 0;
  for (const SpacePolygon& polygon : polygons) {
    ++report.polygons;
    const auto fault = PolygonCut(polygon, mesh, report).fault();
    if (!fault || ++faults > most_reported) continue;
    problems.add(Problem{.file = source,
                         .where = "terrain",
                         .what = polygon.name + ' ' + fault->what,
                         .why = fault->why,
                         .hint = fault->hint});
  }
  if (faults > most_reported) {
    problems.add(Problem{.file = source,
                         .where = "terrain",
                         .what = fmt::format("{} more polygons have problems", faults - most_reported)});
  }
  if (faults > 0) throw BadInput(problems);
  return mesh;
}

std::string PolygonReport::text() const {
  constexpr double rounding_m = 1e-9;
  std::string out = fmt::format("polygons: {}, cut into {}; corners lie within {:.2g} m of their polygon's plane",
                                polygons, counted(triangles, "triangle", "triangles"),
                                largest_departure_m > rounding_m ? largest_departure_m : 0);
  if (bent.count > 0) {
    out += "\nwarning: " + counted(bent.count, "polygon is", "polygons are") + " not plane and bent along the cuts" +
           bent.places();
  }
  return out;
}

}  // namespace talus
