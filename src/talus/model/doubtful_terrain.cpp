#include "talus/model/doubtful_terrain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "talus/core/overloaded.hpp"
#include "talus/model/coarse_raster.hpp"

namespace talus::project {

namespace {

// Quarry faces and cliffs are this steep, but no terrain is on half of its area on plan.
constexpr double steepest_deg = 75;

double degrees(double tangent) { return std::atan(tangent) * 180 / std::numbers::pi; }

/// For messages: its file or files, or "the terrain".
std::string name_of(const Terrain& terrain) {
  const auto file_or_terrain = [](const std::filesystem::path& file) {
    return file.empty() ? std::string("the terrain") : fmt::format("\"{}\"", file.string());
  };
  return std::visit(Overloaded{
                        [&](const SectionTerrain& section) { return file_or_terrain(section.file); },
                        [&](const MeshTerrain& meshes) {
                          return fmt::format("\"{}\"", fmt::join(names_of_meshes(meshes), "\" with \""));
                        },
                        [&](const InlineTerrain&) { return file_or_terrain({}); },
                        [&](const RasterTerrain& raster) { return file_or_terrain(raster.file); },
                        [&](const SurveyTerrain& survey) {
                          return file_or_terrain(survey.lines.empty() ? survey.points : survey.lines);
                        },
                        [&](const PolygonTerrain& polygons) { return file_or_terrain(polygons.file); },
                    },
                    terrain.kind());
}

void warn_of_terrain(const Project& project, std::string what, std::string why, std::string hint, Problems& warnings) {
  warnings.add({.severity = Severity::warning,
                .file = project.file.string(),
                .where = "[terrain]",
                .what = fmt::format("{} {}", name_of(project.terrain), what),
                .why = std::move(why),
                .hint = std::move(hint)});
}

std::string hint_to_turn(const Project& project, const char* axis) {
  if (project.terrain.mesh.up == UpAxis::y) return "Leave out up = \"y\" if z points up in the file";
  return *axis == 'y' ? "If y points up in the file, write up = \"y\" in [terrain]"
                      : "If x points up in the file, turn it so that z does";
}

}  // namespace

std::vector<std::string> names_of_meshes(const MeshTerrain& meshes) {
  std::vector<std::string> names;
  for (const std::filesystem::path& file : meshes.files) names.push_back(file.string());
  return names;
}

void warn_of_steep_raster(const RasterGrid& grid, const Project& project, Problems& warnings) {
  // A sample of rows and columns is enough for a large raster.
  const std::uint32_t stride = std::max<std::uint32_t>(1, grid.rows / 500);
  std::vector<double> slopes;  // tangents
  for (std::uint32_t row = 0; row + 1 < grid.rows; row += stride) {
    for (std::uint32_t column = 0; column + 1 < grid.columns; column += stride) {
      const double z = grid.z[grid.index(column, row)];
      const double east = (grid.z[grid.index(column + 1, row)] - z) / grid.dx;
      const double north = (grid.z[grid.index(column, row + 1)] - z) / grid.dy;
      if (std::isfinite(east) && std::isfinite(north)) slopes.push_back(std::hypot(east, north));
    }
  }
  constexpr std::size_t few = 100;  // so few cells that half may be a cliff
  if (slopes.size() < few) return;
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::ranges::nth_element(slopes, middle);
  if (degrees(*middle) <= steepest_deg) return;
  warn_of_terrain(project, fmt::format("is steeper than {:.3g} degrees on half of its area", degrees(*middle)),
                  fmt::format("its elevations seem not to be in metres; as centimetres they would make {:.2g} degrees",
                              degrees(*middle / 100)),
                  "Convert the elevations to metres", warnings);
}

void warn_of_coarse_raster(const RasterGrid& grid, const Project& project, Problems& warnings) {
  const double cell = std::min(grid.dx, grid.dy);
  if (const auto from = interpolated_from(grid)) {
    constexpr double alike = 0.1;
    const bool is_square = std::abs(from->x() - from->y()) < alike * from->norm();
    warn_of_terrain(
        project,
        fmt::format("has cells of {:.3g} m, but its elevations seem to be interpolated from cells of about {}", cell,
                    is_square ? fmt::format("{:.2g} m", 0.5 * (from->x() + from->y()))
                              : fmt::format("{:.2g} x {:.2g} m", from->x(), from->y())),
        "they bend at regular distances; interpolation adds no detail, and bends or steps that the ground does not "
        "have",
        "Use the original cells", warnings);
  }
  const auto step = elevation_step(grid);
  constexpr double steepest_bend_deg = 8;  // about half of the default of grazing_angle_deg
  if (!step || degrees(*step / cell) <= steepest_bend_deg) return;
  warn_of_terrain(
      project, fmt::format("has elevations in steps of {:g} m", *step),
      fmt::format("with cells of {:.3g} m a step bends the ground by {:.0f} degrees", cell, degrees(*step / cell)),
      "Use a file with decimals, or average the elevations over several cells", warnings);
}

void warn_of_steep_mesh(const RawMesh& mesh, const Project& project, Problems& warnings) {
  // The sum of the facets' area vectors is the same for all surfaces with this rim: it gives the orientation of the
  // mesh as a whole, whatever its hills. (With inconsistent winding it is small and has no meaning.)
  Vec3 area;
  for (const auto& [a, b, c] : mesh.triangles) {
    if (std::max({a, b, c}) >= mesh.vertices.size()) return;  // refused later
    area += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
  }
  constexpr double steepest_tilt_deg = 60;
  const double tilt = degrees(area.xy().norm() / std::abs(area.z()));
  if (!area.is_finite() || area.norm() == 0 || !(tilt > steepest_tilt_deg)) return;
  const char* axis = std::abs(area.y()) > std::abs(area.x()) ? "y" : "x";
  warn_of_terrain(project, "seems to lie on its side",
                  fmt::format("as a whole it is {:.0f} degrees steep and faces along {}; z points up", tilt, axis),
                  hint_to_turn(project, axis), warnings);
}

void warn_of_high_terrain(const Vec3& size, const Project& project, Problems& warnings) {
  constexpr double highest_m = 9000;  // from the sea to the highest summit
  if (size.z() <= highest_m) return;
  constexpr double km = 1000, millimetres = 1e-3;
  warn_of_terrain(
      project, fmt::format("is {:.3g} km high and {:.3g} km wide", size.z() / km, size.xy().largest() / km),
      fmt::format(
          "no slope is that high, so its coordinates seem not to be in metres; as millimetres it would be {:.3g} m "
          "high",
          size.z() * millimetres),
      "Convert the coordinates to metres", warnings);
}

void warn_of_overhangs(const CleanMesh& mesh, const Project& project, Problems& warnings) {
  constexpr double least_share = 1.0 / 3;
  double all = 0, overhanging = 0;
  bool is_closed = true;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& [a, b, c] = mesh.triangles[k];
    const Vec3 area = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    all += area.norm();
    if (area.z() < -vertical_n_z * area.norm()) overhanging += area.norm();
    for (const Neighbour& beyond : mesh.neighbours[k]) is_closed = is_closed && beyond.has_value();
  }
  if (is_closed || overhanging <= least_share * all) return;
  warn_of_terrain(
      project, "overhangs on much of its area",
      fmt::format("{:.0f} % of the area of its facets faces downwards; z points up", 100 * overhanging / all),
      hint_to_turn(project, "y"), warnings);
}

}  // namespace talus::project
