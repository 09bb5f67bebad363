#include "talus/import/mesh_polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace talus {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// More corners than a face of a terrain has. Limits the time for clipping ears to about a second per face.
constexpr std::size_t most_corners = 1000;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Twice the area vector of the polygon (Newell), whose points are relative to one nearby.
Vec3 area_vector(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (std::size_t i = 0; i < points.size(); ++i) sum += points[i].cross(points[(i + 1) % points.size()]);
  return sum;
}

// The polygon projected on the coordinate plane in which it appears largest, counter-clockwise.
std::vector<Vec2> projected(const std::vector<Vec3>& points, const Vec3& normal) {
  const std::size_t axis = normal.abs().place_of_largest(), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const bool faces_away = normal[axis] < 0;
  std::vector<Vec2> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.emplace_back(faces_away ? Vec2{p[v], p[u]} : Vec2{p[u], p[v]});
  return out;
}

// Whether no other remaining corner is in the triangle that would be cut off.
bool is_empty(const std::vector<Vec2>& points, const std::vector<std::uint32_t>& remaining,
              const std::array<Vec2, 3>& ear) {
  return std::none_of(remaining.begin(), remaining.end(), [&](std::uint32_t other) {
    const Vec2& p = points[other];
    if (p == ear[0] || p == ear[1] || p == ear[2]) return false;
    return turn(ear[0], ear[1], p) >= 0 && turn(ear[1], ear[2], p) >= 0 && turn(ear[2], ear[0], p) >= 0;
  });
}

// Clips ears while there are any. Corners in line with their neighbours are cut off only if there is no other ear, so
// that they become corners of triangles with area. `flat`: the doubled area up to which a triangle counts as flat [m2].
std::optional<std::vector<Triangle>> ears(const std::vector<Vec2>& points, double flat) {
  std::vector<std::uint32_t> remaining(points.size());
  for (std::uint32_t i = 0; i < remaining.size(); ++i) remaining[i] = i;
  std::vector<Triangle> out;
  const auto cut = [&](bool with_area) {
    const std::size_t n = remaining.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Triangle ear{remaining[(i + n - 1) % n], remaining[i], remaining[(i + 1) % n]};
      const std::array<Vec2, 3> at{points[ear[0]], points[ear[1]], points[ear[2]]};
      const double doubled_area = turn(at[0], at[1], at[2]);
      if (with_area ? doubled_area > flat && is_empty(points, remaining, at) : std::abs(doubled_area) <= flat) {
        out.push_back(ear);
        remaining.erase(remaining.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
      }
    }
    return false;
  };
  while (remaining.size() > 3) {
    if (!cut(true) && !cut(false)) return std::nullopt;
  }
  if (turn(points[remaining[0]], points[remaining[1]], points[remaining[2]]) < -flat) return std::nullopt;
  out.push_back({remaining[0], remaining[1], remaining[2]});
  return out;
}

std::vector<Triangle> fan(std::uint32_t corners) {
  std::vector<Triangle> out;
  for (std::uint32_t i = 1; i + 1 < corners; ++i) out.push_back({0, i, i + 1});
  return out;
}

// Triangles of corner numbers within the face; nullopt if the face crosses itself.
std::optional<std::vector<Triangle>> cut_into_triangles(const std::vector<Vec3>& vertices,
                                                        std::span<const std::uint32_t> face) {
  const auto corners = static_cast<std::uint32_t>(face.size());
  std::vector<Vec3> points;
  points.reserve(face.size());
  for (const std::uint32_t corner : face) points.push_back(vertices[corner] - vertices[face[0]]);
  double extent = 0;
  for (const Vec3& p : points) extent = std::max(extent, p.squared_norm());
  const double flat = 1e-12 * extent;  // rounding of doubled areas: a height of 1e-12 of the face's size
  std::vector<Triangle> out = fan(corners);
  const Vec3 normal = area_vector(points);
  if (normal.norm() <= flat) {
    const auto is_flat = [&](const Triangle& t) { return points[t[1]].cross(points[t[2]]).norm() <= flat; };
    if (std::all_of(out.begin(), out.end(), is_flat)) return out;
    return std::nullopt;
  }
  const std::vector<Vec2> plane = projected(points, normal);
  const auto has_area = [&](const Triangle& t) { return turn(plane[t[0]], plane[t[1]], plane[t[2]]) > flat; };
  if (std::all_of(out.begin(), out.end(), has_area)) return out;
  return ears(plane, flat);
}

// Without corners that repeat the one before.
std::vector<std::uint32_t> without_repeats(std::span<const std::uint32_t> face) {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t corner : face) {
    if (out.empty() || out.back() != corner) out.push_back(corner);
  }
  while (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

}  // namespace

RawMesh triangulated(PolygonMesh mesh, MeshProblems& problems) {
  RawMesh out;
  out.triangles.reserve(mesh.corners.size() - 2 * std::min(mesh.ends.size(), mesh.corners.size() / 2));
  std::uint32_t begin = 0;
  for (std::size_t f = 0; f < mesh.ends.size(); ++f) {
    const std::span<const std::uint32_t> face{mesh.corners.data() + begin, mesh.ends[f] - begin};
    begin = mesh.ends[f];
    const auto place = [&]() -> MeshPlace {
      if (!mesh.lines.empty()) return {mesh.lines[f], ""};
      return {0, fmt::format("face {} of {}", f + 1, mesh.ends.size())};
    };
    const auto missing = std::find_if(face.begin(), face.end(), [&](auto v) { return v >= mesh.vertices.size(); });
    if (missing != face.end()) {
      problems.refuse(place(), fmt::format("vertex {} does not exist", std::uint64_t{*missing} + mesh.first_number),
                      fmt::format("the file has {} {}, numbered from {}", mesh.vertices.size(),
                                  mesh.vertices.size() == 1 ? "vertex" : "vertices", mesh.first_number));
    } else if (face.size() < 3) {
      problems.refuse(place(), fmt::format("a face with {} corner{}", face.size(), face.size() == 1 ? "" : "s"),
                      "expected at least 3");
    } else if (face.size() > most_corners) {
      problems.refuse(place(), fmt::format("a face with {} corners", face.size()),
                      fmt::format("Talus triangulates faces of up to {}", most_corners),
                      "Triangulate it in the program that made it");
    } else if (face.size() == 3) {
      out.triangles.push_back({face[0], face[1], face[2]});
    } else {
      const std::vector<std::uint32_t> corners = without_repeats(face);
      if (corners.size() < 3) {
        out.triangles.push_back({face[0], face[1], face[2]});
        continue;
      }
      const auto triangles = cut_into_triangles(mesh.vertices, corners);
      if (!triangles) {
        problems.refuse(place(), fmt::format("a face with {} corners crosses itself", face.size()),
                        "it cannot be triangulated", "Triangulate it in the program that made it");
        continue;
      }
      for (const Triangle& t : *triangles) out.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    }
  }
  problems.throw_if_any();
  out.vertices = std::move(mesh.vertices);
  return out;
}

}  // namespace talus
