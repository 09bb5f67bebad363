#include "talus/meshing/side_corners.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "talus/meshing/mesh_edges.hpp"
#include "talus/terrain/bvh.hpp"

namespace talus {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// A facet, or a part of one, that is being split.
struct Piece {
  Corners corners;
  std::array<bool, 3> is_free;  // whether edge k is one of the boundary
};

class FacetCut {
 public:
  FacetCut(const std::vector<Vec3>& vertices, double tolerance) : vertices_(vertices), tolerance_(tolerance) {}

  // Calls take(corners) for each piece of a facet whose sides pass these vertices.
  template <class Take>
  void into_pieces(const Piece& piece, const std::vector<std::uint32_t>& passed, Take&& take) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = k, to = (k + 1) % 3, apex = (k + 2) % 3;
      const std::vector<std::uint32_t> row = row_on(piece, k, passed);
      if (row.empty()) continue;
      Piece part = piece;
      part.is_free[k] = part.is_free[to] = false;
      for (const std::uint32_t v : row) {
        found_.add(vertices_[v]);
        part.corners[to] = v;
        into_pieces(part, passed, take);
        part.corners[from] = v;
        part.is_free[apex] = false;
      }
      part.corners[to] = piece.corners[to];
      part.is_free[to] = piece.is_free[to];
      into_pieces(part, passed, take);
      return;
    }
    take(piece.corners);
  }

  // How far along the edge a vertex lies (0 to 1), if it is within the tolerance of the edge and between its ends.
  [[nodiscard]] std::optional<double> place_on(std::uint32_t a, std::uint32_t b, std::uint32_t v) const {
    const Vec3 along = vertices_[b] - vertices_[a], to_v = vertices_[v] - vertices_[a];
    const double share = to_v.dot(along) / along.squared_norm();
    if (!(share > 0 && share < 1) || (to_v - share * along).norm() > tolerance_) return std::nullopt;
    return share;
  }

  [[nodiscard]] const Findings& found() const { return found_; }

 private:
  // The vertices that edge k passes, in order along it, without those that would turn a piece over.
  [[nodiscard]] std::vector<std::uint32_t> row_on(const Piece& piece, std::size_t k,
                                                  const std::vector<std::uint32_t>& passed) const {
    if (!piece.is_free[k]) return {};
    const std::uint32_t a = piece.corners[k], b = piece.corners[(k + 1) % 3], c = piece.corners[(k + 2) % 3];
    std::vector<std::pair<double, std::uint32_t>> places;
    for (const std::uint32_t v : passed) {
      if (v == a || v == b || v == c) continue;
      if (const auto share = place_on(a, b, v)) places.emplace_back(*share, v);
    }
    std::sort(places.begin(), places.end());
    const Vec3 area = area_vector(a, b, c);
    std::vector<std::uint32_t> row;
    for (const auto& [share, v] : places) {
      const std::uint32_t before = row.empty() ? a : row.back();
      if (v != before && area_vector(before, v, c).dot(area) > 0 && area_vector(v, b, c).dot(area) > 0)
        row.push_back(v);
    }
    return row;
  }

  [[nodiscard]] Vec3 area_vector(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return (vertices_[b] - vertices_[a]).cross(vertices_[c] - vertices_[a]);
  }

  const std::vector<Vec3>& vertices_;
  double tolerance_;
  Findings found_;
};

}  // namespace

Findings put_corners_into_sides(const std::vector<Vec3>& vertices, CutFacets& facets, double tolerance_m) {
  FacetCut cut{vertices, tolerance_m};
  const std::vector<MeshEdge> edges = free_edges(facets.triangles);
  if (edges.empty()) return {};
  const Vec3 origin = vertices[edges.front().ends >> 32];  // boxes are coarse far from it
  std::vector<Box> boxes;
  std::vector<std::uint32_t> corners;
  for (const MeshEdge& edge : edges) {
    const auto a = static_cast<std::uint32_t>(edge.ends >> 32), b = static_cast<std::uint32_t>(edge.ends);
    Box& box = boxes.emplace_back();
    box.grow(vertices[a] - origin);
    box.grow(vertices[b] - origin);
    corners.insert(corners.end(), {a, b});
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());

  struct Passing {
    Piece facet;
    std::vector<std::uint32_t> vertices;
  };
  std::map<std::uint32_t, Passing> passings;  // by facet
  const Bvh tree{boxes};
  for (const std::uint32_t v : corners) {
    const Vec3 place = vertices[v] - origin, reach = Vec3::all(tolerance_m);
    tree.visit_box(place - reach, place + reach, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t k = first; k < last; ++k) {
        const MeshEdge& edge = edges[tree.order()[k]];
        const Corners& t = facets.triangles[edge.triangle];
        if (std::find(t.begin(), t.end(), v) != t.end()) continue;
        if (!cut.place_on(t[edge.edge], t[(edge.edge + 1) % 3], v)) continue;
        Passing& passing = passings.try_emplace(edge.triangle, Passing{{t, {}}, {}}).first->second;
        passing.vertices.push_back(v);
      }
    });
  }
  if (passings.empty()) return {};
  for (const MeshEdge& edge : edges) {
    const auto passing = passings.find(edge.triangle);
    if (passing != passings.end()) passing->second.facet.is_free[edge.edge] = true;
  }

  CutFacets out;
  for (std::uint32_t i = 0; i < facets.triangles.size(); ++i) {
    const auto keep = [&](const Corners& t) {
      out.triangles.push_back(t);
      out.original.push_back(facets.original[i]);
    };
    const auto passing = passings.find(i);
    if (passing == passings.end()) {
      keep(facets.triangles[i]);
    } else {
      cut.into_pieces(passing->second.facet, passing->second.vertices, keep);
    }
  }
  facets = std::move(out);
  return cut.found();
}

}  // namespace talus
