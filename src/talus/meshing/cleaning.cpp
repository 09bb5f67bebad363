#include "talus/meshing/cleaning.hpp"

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/meshing/loose_edges.hpp"
#include "talus/meshing/mesh_edges.hpp"
#include "talus/meshing/side_corners.hpp"
#include "talus/meshing/weld.hpp"

namespace talus {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// ---- input that cannot be cleaned ----

// Collects the problems of one file. A bad mesh may have one at every vertex, so only the first few are reported.
class Refusals {
 public:
  explicit Refusals(std::string source) : source_(std::move(source)) {}

  void add(std::string where, std::string what, std::string why, std::string hint = "") {
    constexpr std::size_t most_reported = 10;
    if (++count_ > most_reported) return;
    problems_.add(problem(std::move(where), std::move(what), std::move(why), std::move(hint)));
  }

  void throw_if_any() {
    if (count_ == 0) return;
    const std::size_t reported = problems_.list().size();
    if (count_ > reported) problems_.add(problem("", fmt::format("{} more of this kind", count_ - reported), "", ""));
    throw BadInput(problems_);
  }

 private:
  [[nodiscard]] Problem problem(std::string where, std::string what, std::string why, std::string hint) const {
    Problem out;
    out.file = source_;
    out.where = std::move(where);
    out.what = std::move(what);
    out.why = std::move(why);
    out.hint = std::move(hint);
    return out;
  }

  std::string source_;
  Problems problems_;
  std::size_t count_ = 0;
};

void check(const RawMesh& mesh, Refusals& refusals) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max() - 1;
  if (mesh.vertices.empty()) refusals.add("terrain", "the mesh has no vertices", "expected at least three");
  if (mesh.triangles.empty()) refusals.add("terrain", "the mesh has no triangles", "expected at least one");
  if (mesh.vertices.size() > most || mesh.triangles.size() > most) {
    refusals.add("terrain", "the mesh is too large",
                 fmt::format("Talus numbers up to {} vertices and triangles", most));
  }
  refusals.throw_if_any();
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& v = mesh.vertices[i];
    const auto where = [&] { return fmt::format("vertex {} (zero-based)", i); };
    if (!v.is_finite()) {
      refusals.add(where(), fmt::format("({}, {}, {}) is not a position", v.x(), v.y(), v.z()),
                   "expected finite coordinates in metres");
    } else if (v.abs().largest() >= largest_coordinate_m) {
      refusals.add(where(), fmt::format("({}, {}, {}) is too far from the origin", v.x(), v.y(), v.z()),
                   fmt::format("coordinates must be smaller than {:g} m", largest_coordinate_m), "Are they in metres?");
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners& t = mesh.triangles[i];
    const auto missing = std::find_if(t.begin(), t.end(), [&](auto v) { return v >= mesh.vertices.size(); });
    if (missing == t.end()) continue;
    refusals.add(fmt::format("triangle {} (zero-based)", i), fmt::format("vertex {} does not exist", *missing),
                 fmt::format("the mesh has {}, numbered from 0", counted(mesh.vertices.size(), "vertex", "vertices")));
  }
  refusals.throw_if_any();
}

// ---- vertices and facets to drop ----

Vec3 area_vector(const std::vector<Vec3>& vertices, const Corners& t) {
  return 0.5 * (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
}

Vec3 centre(const std::vector<Vec3>& vertices, const Corners& t) {
  return (vertices[t[0]] + vertices[t[1]] + vertices[t[2]]) / 3;
}

double height(const std::vector<Vec3>& vertices, const Corners& t) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    longest = std::max(longest, (vertices[t[(k + 1) % 3]] - vertices[t[k]]).norm());
  }
  return longest > 0 ? 2 * area_vector(vertices, t).norm() / longest : 0;
}

void drop_degenerate(CleanMesh& mesh) {
  double largest = 0;
  for (const Vec3& v : mesh.vertices) largest = std::max(largest, v.abs().largest());
  const double least = std::max(smallest_facet_height_m, 8 * std::numeric_limits<double>::epsilon() * largest);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners t = mesh.triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || height(mesh.vertices, t) < least) {
      mesh.report.degenerate.add(centre(mesh.vertices, t));
    } else {
      mesh.triangles[kept] = t;
      mesh.original[kept] = mesh.original[i];
      ++kept;
    }
  }
  mesh.triangles.resize(kept);
  mesh.original.resize(kept);
}

void drop_duplicates(CleanMesh& mesh) {
  struct Sorted {
    Corners corners;
    std::uint32_t triangle;
    bool operator<(const Sorted& o) const { return corners != o.corners ? corners < o.corners : triangle < o.triangle; }
  };
  std::vector<Sorted> sorted;
  sorted.reserve(mesh.triangles.size());
  for (Corners t : mesh.triangles) {
    std::sort(t.begin(), t.end());
    sorted.push_back({t, static_cast<std::uint32_t>(sorted.size())});
  }
  tbb::parallel_sort(sorted);
  std::vector<bool> repeats(mesh.triangles.size());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    repeats[sorted[i].triangle] = sorted[i].corners == sorted[i - 1].corners;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (repeats[i]) {
      mesh.report.duplicates.add(centre(mesh.vertices, mesh.triangles[i]));
    } else {
      mesh.triangles[kept] = mesh.triangles[i];
      mesh.original[kept] = mesh.original[i];
      ++kept;
    }
  }
  mesh.triangles.resize(kept);
  mesh.original.resize(kept);
}

// ---- corners on the sides of other facets ----

void join_along_sides(CleanMesh& mesh, double tolerance) {
  CutFacets facets{std::move(mesh.triangles), std::move(mesh.original)};
  mesh.report.corners_in_sides = put_corners_into_sides(mesh.vertices, facets, tolerance);
  mesh.triangles = std::move(facets.triangles);
  mesh.original = std::move(facets.original);
  if (mesh.report.corners_in_sides.count == 0) return;
  drop_degenerate(mesh);
  drop_duplicates(mesh);
}

// A vertex that is not its own `representative` was welded to another; it counts as welded, not as unused.
void drop_unused_vertices(CleanMesh& mesh, const std::vector<std::uint32_t>& representative) {
  std::vector<bool> used(mesh.vertices.size());
  for (const Corners& t : mesh.triangles) {
    for (const std::uint32_t v : t) used[v] = true;
  }
  std::vector<std::uint32_t> renumbered(mesh.vertices.size());
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    if (used[i]) {
      renumbered[i] = kept;
      mesh.vertices[kept++] = mesh.vertices[i];
    } else if (representative[i] == i) {
      ++mesh.report.unused_vertices;
    }
  }
  mesh.vertices.resize(kept);
  for (Corners& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = renumbered[v];
  }
}

// ---- neighbours ----

// An edge shared by more than two facets is reported as non-manifold, and none of them gets a neighbour there.
// Returns the boundary edges.
std::vector<MeshEdge> find_neighbours(CleanMesh& mesh) {
  mesh.neighbours.assign(mesh.triangles.size(), {});
  std::vector<MeshEdge> boundary;
  each_shared(sorted_edges(mesh.triangles), [&](std::span<const MeshEdge> shared) {
    const MeshEdge& first = shared.front();
    if (shared.size() == 1) {
      boundary.push_back(first);
    } else if (shared.size() == 2) {
      const MeshEdge& second = shared.back();
      mesh.neighbours[first.triangle][first.edge] = Neighbour{FacetId{second.triangle}};
      mesh.neighbours[second.triangle][second.edge] = Neighbour{FacetId{first.triangle}};
    } else {
      const Vec3& a = mesh.vertices[first.ends >> 32];
      const Vec3& b = mesh.vertices[first.ends & 0xFFFFFFFF];
      mesh.report.non_manifold_edges.add((a + b) / 2);
    }
  });
  mesh.report.boundary_edges = boundary.size();
  return boundary;
}

// ---- orientation: every facet faces out of the ground ----

// Finds the triangles to flip. A flood fill from facet to facet makes the winding of each component consistent; then
// each component is flipped as a whole if it faces into the ground.
class WindingRepair {
 public:
  explicit WindingRepair(CleanMesh& mesh) : mesh_(mesh), turned_(mesh.triangles.size()), seen_(mesh.triangles.size()) {}

  void find() {
    for (std::uint32_t seed = 0; seed < mesh_.triangles.size(); ++seed) {
      if (seen_[seed]) continue;
      flood(seed);
      ++mesh_.report.components;
      if (closed_) ++mesh_.report.closed_components;
      if (one_sided_) {
        turn_each_up();
      } else {
        turn_as_a_whole();
      }
    }
  }

  void apply() {
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (!turned_[i]) continue;
      Corners& t = mesh_.triangles[i];
      mesh_.report.flipped.add(centre(mesh_.vertices, t));
      std::swap(t[1], t[2]);
      std::swap(mesh_.neighbours[i][0], mesh_.neighbours[i][2]);
    }
  }

 private:
  [[nodiscard]] bool has_edge(std::uint32_t triangle, std::uint32_t from, std::uint32_t to) const {
    const Corners& t = mesh_.triangles[triangle];
    return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) || (t[2] == from && t[0] == to);
  }

  void flood(std::uint32_t seed) {
    component_.assign(1, seed);
    seen_[seed] = 1;
    closed_ = true;
    one_sided_ = false;
    for (std::size_t next = 0; next < component_.size(); ++next) {
      stop_point(next);
      const std::uint32_t i = component_[next];
      for (std::size_t k = 0; k < 3; ++k) {
        const Neighbour neighbour = mesh_.neighbours[i][k];
        if (!neighbour) {
          closed_ = false;
          continue;
        }
        // Two facets agree if they traverse their common edge in opposite directions.
        const std::uint32_t j = (*neighbour).index;
        const bool agree = !has_edge(j, mesh_.triangles[i][k], mesh_.triangles[i][(k + 1) % 3]);
        const std::uint8_t wanted = agree ? turned_[i] : !turned_[i];
        if (!seen_[j]) {
          seen_[j] = 1;
          turned_[j] = wanted;
          component_.push_back(j);
        } else if (turned_[j] != wanted) {
          one_sided_ = true;
        }
      }
    }
  }

  [[nodiscard]] Vec3 oriented_area(std::uint32_t i) const {
    const Vec3 area = area_vector(mesh_.vertices, mesh_.triangles[i]);
    return turned_[i] ? Vec3{-area} : area;
  }

  void turn_each_up() {
    for (const std::uint32_t i : component_) {
      if (oriented_area(i).z() < 0) turned_[i] = !turned_[i];
    }
    mesh_.report.one_sided_components.add(centre(mesh_.vertices, mesh_.triangles[component_.front()]));
  }

  void turn_as_a_whole() {
    // Relative to their largest possible value, sums below this are rounding and have no meaningful sign.
    constexpr double relative_rounding = 1e-9;
    double area = 0;
    double plan_area = 0;
    double volume = 0;
    const Vec3 origin = mesh_.vertices[mesh_.triangles[component_.front()][0]];
    for (const std::uint32_t i : component_) {
      const Vec3 a = oriented_area(i);
      area += a.norm();
      plan_area += a.z();
      volume += a.dot(mesh_.vertices[mesh_.triangles[i][0]] - origin) / 3;  // of the cone from the origin to the facet
    }
    const double outward = closed_ ? volume / std::pow(area, 1.5) : plan_area / area;
    if (std::abs(outward) > relative_rounding) {
      if (outward < 0) turn_component();
      return;
    }
    const auto turned = std::count_if(component_.begin(), component_.end(), [&](auto i) { return turned_[i] != 0; });
    if (2 * static_cast<std::size_t>(turned) > component_.size()) turn_component();
    mesh_.report.undecided_components.add(centre(mesh_.vertices, mesh_.triangles[component_.front()]));
  }

  void turn_component() {
    for (const std::uint32_t i : component_) turned_[i] = !turned_[i];
  }

  CleanMesh& mesh_;
  std::vector<std::uint8_t> turned_;
  std::vector<std::uint8_t> seen_;
  std::vector<std::uint32_t> component_;  // triangles of the component flooded last
  bool closed_ = true;
  bool one_sided_ = false;
};

void count_steep_facets(CleanMesh& mesh) {
  for (const Corners& t : mesh.triangles) {
    const double n_z = area_vector(mesh.vertices, t).normalized().z();
    if (std::abs(n_z) <= vertical_n_z) {
      mesh.report.vertical.add(centre(mesh.vertices, t));
    } else if (n_z < 0) {
      mesh.report.overhanging.add(centre(mesh.vertices, t));
    }
  }
}

}  // namespace

CleanMesh clean(RawMesh raw, const CleaningOptions& options) {
  Refusals refusals{options.source};
  check(raw, refusals);

  CleanMesh mesh;
  mesh.vertices = std::move(raw.vertices);
  mesh.triangles = std::move(raw.triangles);
  mesh.original.resize(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.original.size(); ++i) mesh.original[i] = i;

  const std::vector<std::uint32_t> representative = welded(mesh.vertices, options.weld_tolerance_m);
  for (std::uint32_t i = 0; i < representative.size(); ++i) mesh.report.welded_vertices += representative[i] != i;
  for (Corners& t : mesh.triangles) {
    for (std::uint32_t& v : t) v = representative[v];
  }
  drop_degenerate(mesh);
  if (mesh.triangles.empty()) {
    refusals.add("terrain", "the mesh has no facet with an area",
                 fmt::format("all {} repeat a corner or are lower than {:g} m", mesh.report.degenerate.count,
                             smallest_facet_height_m),
                 "Are its coordinates in metres?");
    refusals.throw_if_any();
  }
  drop_duplicates(mesh);
  stop_point();
  if (options.weld_tolerance_m > 0) join_along_sides(mesh, options.weld_tolerance_m);
  drop_unused_vertices(mesh, representative);
  const std::vector<MeshEdge> boundary = find_neighbours(mesh);
  mesh.report.crack_m = std::max(widest_crack_m, options.weld_tolerance_m);
  mesh.report.loose_edges = loose_edges(mesh.vertices, mesh.triangles, boundary, mesh.report.crack_m);
  stop_point();
  WindingRepair orientation{mesh};
  orientation.find();
  orientation.apply();
  count_steep_facets(mesh);
  mesh.report.vertices = mesh.vertices.size();
  mesh.report.facets = mesh.triangles.size();
  return mesh;
}

}  // namespace talus
