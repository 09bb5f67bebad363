#include "talus/model/scanned_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "talus/files/file_formats.hpp"
#include "talus/import/mesh_file.hpp"
#include "talus/import/point_file.hpp"
#include "talus/meshing/rock_hull.hpp"
#include "talus/rocks/solid.hpp"

namespace talus::project {

namespace {

constexpr std::size_t max_corners_of_scan = 48;
/// Share of the hull's volume that a block fills. Rocks are calculated as their hulls: below the first a warning is
/// given, below the second the hull is another body.
constexpr double convex = 0.9, too_hollow = 0.6;

/// Of a closed mesh; triangles without their neighbours have no volume.
struct MeshVolume {
  std::optional<double> volume;  // negative: inside out; nullopt: open
  std::size_t open_edges = 0;
};

/// Vertices in the same place are one: in an STL file every triangle has its own.
MeshVolume volume_of(const RawMesh& mesh) {
  std::map<std::array<double, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> number;
  for (const Vec3& v : mesh.vertices) {
    number.push_back(
        places.try_emplace({v.x(), v.y(), v.z()}, static_cast<std::uint32_t>(places.size())).first->second);
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::vector<Vec3> corners;
  for (const Vec3& v : mesh.vertices) corners.push_back(v - mesh.vertices.front());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < t.size(); ++k) {
      const std::uint32_t a = number[t[k]], b = number[t[(k + 1) % t.size()]];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  MeshVolume found;
  found.open_edges =
      static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto& e) { return e.second != 0; }));
  if (found.open_edges == 0) found.volume = moments_of(corners, mesh.triangles).volume;
  return found;
}

class ScanReader {
 public:
  ScanReader(const Project& project, const Shape& shape, Problems& warnings)
      : shape_(shape), path_(project.file.parent_path() / shape.scan), warnings_(warnings) {}

  RockShape read(std::string& report) {
    const bool is_mesh = is_of_kind(shape_.scan, FileKind::mesh);
    RawMesh mesh;
    if (is_mesh) {
      mesh = read_mesh_file(path_, warnings_);
    } else {
      mesh.vertices = read_point_file(path_);
    }
    const auto corners = static_cast<std::size_t>(shape_.corners.value_or(max_corners_of_scan));
    Hull whole, thinned;
    try {
      whole = hull_of(mesh.vertices);
      thinned = thinned_hull_of(mesh.vertices, corners);
    } catch (const BadInput& bad) {
      Problem problem = bad.problems().list().front();
      problem.file = path_.string();
      throw BadInput(std::move(problem));
    }
    const std::string convexity = is_mesh ? convexity_of(mesh, whole.volume) : "convexity not known (points)";
    const Vec3 axes = std::cbrt(whole.volume) * extent_of(whole.shape);
    const Vec3& k = thinned.shape.gyration;
    if (!report.empty()) report += '\n';
    report += fmt::format(
        "shape \"{}\": {} points of \"{}\"; hull of {:.4g} in the cube of their unit, {}; axes {:.3g}, {:.3g}, {:.3g} "
        "(b/a {:.2f}, c/b {:.2f}) along its principal axes of inertia; {} corners kept, {:.3g} % of the hull; moments "
        "of "
        "inertia {:.4f}, {:.4f}, {:.4f} m2 for 1 kg and 1 m3",
        shape_.name, mesh.vertices.size(), shape_.scan.string(), whole.volume, convexity, axes[0], axes[1], axes[2],
        axes[1] / axes[0], axes[2] / axes[1], thinned.shape.corners.size(), 100 * thinned.volume / whole.volume, k[0],
        k[1], k[2]);
    return std::move(thinned.shape);
  }

 private:
  static Vec3 extent_of(const RockShape& shape) {
    Vec3 low = shape.corners.front(), high = low;
    for (const Vec3& corner : shape.corners) {
      low = low.min(corner);
      high = high.max(corner);
    }
    return high - low;
  }

  void warn(std::string what, std::string why, std::string hint) {
    warnings_.add({.severity = Severity::warning,
                   .file = path_.string(),
                   .where = {},
                   .what = std::move(what),
                   .why = std::move(why),
                   .hint = std::move(hint)});
  }

  std::string convexity_of(const RawMesh& mesh, double hull) {
    const MeshVolume found = volume_of(mesh);
    if (!found.volume) {
      warn(fmt::format("is not closed: {} of its edges have no second triangle", found.open_edges),
           "its convex hull is used, and how much of it the block fills is not known", "");
      return "convexity not known (open)";
    }
    if (*found.volume < 0)
      warn("is inside out", "its triangles are clockwise from outside; its convex hull is used", "");
    const double share = std::abs(*found.volume) / hull;
    if (share < too_hollow) {
      throw BadInput(Problem{.file = path_.string(),
                             .where = {},
                             .what = fmt::format("fills {:.2g} of its convex hull", share),
                             .why = fmt::format("rocks are calculated as convex; expected at least {:g}", too_hollow),
                             .hint = "Divide it into convex blocks, or give b_over_a and c_over_b"});
    }
    if (share < convex) {
      warn(fmt::format("fills {:.2g} of its convex hull", share), "rocks are calculated as convex",
           "Its volume and mass are those of the seeder; its moments of inertia are those of the hull");
    }
    return fmt::format("convexity {:.2f}", share);
  }

  const Shape& shape_;
  std::filesystem::path path_;
  Problems& warnings_;
};

}  // namespace

RockShape scanned_block(const Project& project, const Shape& shape, std::string& report, Problems& warnings) {
  return ScanReader(project, shape, warnings).read(report);
}

}  // namespace talus::project
