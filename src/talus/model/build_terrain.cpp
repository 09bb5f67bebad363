#include "talus/model/build_terrain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "talus/core/overloaded.hpp"
#include "talus/import/mesh_file.hpp"
#include "talus/import/raster_file.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/meshing/extrude.hpp"
#include "talus/model/build_survey.hpp"
#include "talus/model/doubtful_terrain.hpp"
#include "talus/model/mesh_surface.hpp"
#include "talus/project/varied_section.hpp"

namespace talus::project {

namespace {

std::vector<Vec2> vertices_of(const SectionTerrain& section) {
  std::vector<Vec2> vertices;
  for (const auto& [x, z] : section.vertices) vertices.emplace_back(x, z);
  // A section from left to right has the ground on its right.
  if (section.runs_leftwards()) std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

BuiltTerrain section_terrain(const SectionTerrain& section) {
  std::vector<Vec2> vertices = vertices_of(section);
  Box box;
  for (const Vec2& v : vertices) box.grow(Vec3(v.x(), 0, v.y()));
  BuiltTerrain built;
  built.frame = LocalFrame::near(0.5 * (box.low + box.high));
  for (Vec2& v : vertices) v -= Vec2(built.frame.origin.x(), built.frame.origin.z());
  built.parts = vertices.size() - 1;
  built.surface = Profile(vertices);
  if (!section.std_dev_m.empty()) {
    auto deviations = section.std_dev_m;
    if (section.runs_leftwards()) std::reverse(deviations.begin(), deviations.end());
    VaryingSection varying{vertices, {}};
    for (const auto& [sx, sz] : deviations) {
      const auto shift = [](double s) {
        if (s == 0) return Sampler(0.0);
        const double furthest = most_deviations_of_vertex * s;
        return Sampler(Distribution{0, DistributionKind::normal, s, furthest, furthest}, Bounds{});
      };
      varying.shifts.push_back({shift(sx), shift(sz)});
    }
    built.varying = std::move(varying);
  }
  return built;
}

/// A mesh has no coordinate system, but with degrees on plan and metres in height it becomes a wall: no terrain is ten
/// times as high as it is wide.
void refuse_degrees(const RawMesh& mesh, const std::filesystem::path& file) {
  constexpr double steepest = 10;
  constexpr double widest = 10;  // degrees
  Box box;
  for (const Vec3& v : mesh.vertices) box.grow(v);
  const Vec3 size = box.high - box.low;
  const bool may_be_degrees = box.low.x() >= -180 && box.high.x() <= 180 && box.low.y() >= -90 && box.high.y() <= 90;
  if (!may_be_degrees || size.xy().largest() > widest || size.z() < steepest * size.xy().largest()) return;
  throw BadInput(
      Problem{.file = file.string(),
              .what = "seems to be in degrees",
              .why = fmt::format("it lies within x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g} and is {:.4g} m high",
                                 box.low.x(), box.high.x(), box.low.y(), box.high.y(), size.z()),
              .hint = "Project it to metres; or, if it is in metres, set crs = \"local\""});
}

/// Heights beyond those of any ground, as in rasters.
void refuse_heights(const RawMesh& mesh, const std::filesystem::path& file, UpAxis up) {
  const std::size_t axis = up == UpAxis::y ? 1 : 2;
  std::size_t impossible = 0;
  double farthest_from_0 = 0;
  for (const Vec3& v : mesh.vertices) {
    if (v[axis] >= lowest_elevation_m && v[axis] <= highest_elevation_m) continue;
    ++impossible;
    if (!(std::abs(v[axis]) <= std::abs(farthest_from_0))) farthest_from_0 = v[axis];
  }
  if (impossible == 0) return;
  throw BadInput(Problem{.file = file.string(),
                         .what = fmt::format("has heights such as {:.10g} m", farthest_from_0),
                         .why = fmt::format("{} of {} vertices are below {:g} m or above {:g} m", impossible,
                                            mesh.vertices.size(), lowest_elevation_m, highest_elevation_m),
                         .hint = "Convert the coordinates to metres, or remove what is not ground"});
}

/// With y upwards: a quarter turn about x, which keeps left and right.
void turn_up(RawMesh& mesh) {
  for (Vec3& v : mesh.vertices) v = Vec3(v.x(), -v.z(), v.y());
}

/// The triangles of all files, in their order.
GivenMesh meshes_of_files(const MeshTerrain& meshes, const Project& project, Problems& warnings) {
  const bool are_several = meshes.files.size() > 1;
  GivenMesh out;
  out.is_of_mesh_files = true;
  if (are_several) out.weld_tolerance_m = project.terrain.merge_tolerance_m;
  RawMesh& all = out.mesh;
  Problems problems;
  for (const std::filesystem::path& file : meshes.files) {
    try {
      RawMesh mesh = read_mesh_file(project.file.parent_path() / file, warnings);
      refuse_heights(mesh, file, meshes.up);
      const std::size_t vertices = all.vertices.size(), triangles = all.triangles.size();
      constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
      if (vertices + mesh.vertices.size() > most || triangles + mesh.triangles.size() > most)
        throw BadInput(Problem{.file = file.string(), .what = "is too large", .why = "together with those before it"});
      if (!are_several) {
        all = std::move(mesh);
        break;
      }
      // An index that does not exist stays one: it must not become a vertex of the next file.
      for (auto& corners : mesh.triangles) {
        for (std::uint32_t& corner : corners)
          corner = corner < mesh.vertices.size() ? corner + static_cast<std::uint32_t>(vertices)
                                                 : std::numeric_limits<std::uint32_t>::max();
      }
      out.report += fmt::format("{}{}: triangles {} to {}", out.report.empty() ? "" : "\n", file.string(), triangles,
                                triangles + mesh.triangles.size() - 1);
      all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
      all.triangles.insert(all.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  }
  if (problems.has_errors()) throw BadInput(problems);
  if (meshes.up == UpAxis::y) turn_up(all);
  if (project.terrain.crs.empty()) refuse_degrees(all, meshes.files.front());
  warn_of_steep_mesh(all, project, warnings);
  out.source = fmt::format("{}", fmt::join(names_of_meshes(meshes), ", "));
  out.crs_wkt = crs_wkt_of(project, warnings);
  return out;
}

GivenMesh extruded_section(const SectionTerrain& section, const Project& project, Problems& warnings) {
  GivenMesh out = own_mesh(project, warnings);
  out.mesh = extruded(vertices_of(section), *section.width_m);
  out.triangles_per_part = 2;
  return out;
}

GivenMesh inline_triangles(const InlineTerrain& given, const Project& project, Problems& warnings) {
  GivenMesh out = own_mesh(project, warnings);
  for (const auto& [x, y, z] : given.vertices) out.mesh.vertices.emplace_back(x, y, z);
  for (const auto& [a, b, c] : given.triangles) {
    out.mesh.triangles.push_back(
        {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  }
  return out;
}

BuiltTerrain mesh_terrain(GivenMesh given, const Project& project, Problems& warnings) {
  const auto& [about_x, about_y, about_z] = project.terrain.rotate_about;
  turn(given.mesh, project.terrain.rotate_deg, {about_x, about_y, about_z});
  const std::uint32_t per_part = given.triangles_per_part;
  BuiltTerrain built;
  built.parts = given.mesh.triangles.size() / per_part;
  built.crs_wkt = std::move(given.crs_wkt);
  const CleanMesh mesh =
      clean(std::move(given.mesh), {.source = given.source, .weld_tolerance_m = given.weld_tolerance_m});
  if (given.is_of_mesh_files) warn_of_overhangs(mesh, project, warnings);
  built.report = given.report + (given.report.empty() ? "" : "\n") + mesh.report.text();
  std::vector<std::uint32_t> part_of_facet;
  for (const std::uint32_t original : mesh.original) part_of_facet.push_back(original / per_part);
  built.part_of_facet = std::move(part_of_facet);

  if (!project.ground.raster.empty() || !project.ground.polygons.empty() || !project.areas.empty() ||
      !project.forests.empty()) {
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 centre = (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]) / 3;
      built.facet_centres.emplace_back(centre.x(), centre.y());
      if (project.ground.polygons.empty()) continue;
      const Vec3 area = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
      built.facet_areas.push_back(0.5 * std::abs(area.z()));
    }
  }

  Box box;
  for (const Vec3& v : mesh.vertices) box.grow(v);
  built.frame = LocalFrame::near(0.5 * (box.low + box.high));
  built.surface = mesh_surface(mesh, built.frame);
  return built;
}

BuiltTerrain raster_terrain(const RasterTerrain& raster, const Project& project, Problems& warnings) {
  RasterFile file = read_raster_file(project.file.parent_path() / raster.file, warnings, crs_of_project(project));
  RasterGrid& grid = file.grid;
  warn_of_steep_raster(grid, project, warnings);
  warn_of_coarse_raster(grid, project, warnings);
  BuiltTerrain built;
  const std::uint64_t cells = (std::uint64_t{grid.columns} - 1) * (grid.rows - 1);
  built.report = fmt::format("{}: {} x {} nodes, {:.6g} x {:.6g} m apart, {}, {} without data", raster.file.string(),
                             grid.columns, grid.rows, grid.dx, grid.dy,
                             file.crs_name.empty() ? "no coordinate system" : file.crs_name, file.without_data);
  built.parts = cells;
  built.crs_wkt = std::move(file.crs_wkt);
  // On plan only, so that elevations keep the exact numbers of the file.
  built.frame =
      LocalFrame::near({grid.x0 + 0.5 * grid.dx * (grid.columns - 1), grid.y0 + 0.5 * grid.dy * (grid.rows - 1), 0});
  grid.x0 -= built.frame.origin.x();
  grid.y0 -= built.frame.origin.y();
  built.surface = RasterSurface(std::move(grid));
  return built;
}

}  // namespace

BuiltTerrain build_terrain(const Project& project, Problems& warnings) {
  const auto meshed = [&](GivenMesh given) { return mesh_terrain(std::move(given), project, warnings); };
  BuiltTerrain built = std::visit(
      Overloaded{
          [&](const SectionTerrain& section) {
            return section.width_m ? meshed(extruded_section(section, project, warnings)) : section_terrain(section);
          },
          [&](const MeshTerrain& meshes) { return meshed(meshes_of_files(meshes, project, warnings)); },
          [&](const InlineTerrain& given) { return meshed(inline_triangles(given, project, warnings)); },
          [&](const RasterTerrain& raster) { return raster_terrain(raster, project, warnings); },
          [&](const SurveyTerrain& survey) { return meshed(survey_mesh(survey, project, warnings)); },
          [&](const PolygonTerrain& polygons) { return meshed(polygon_mesh(polygons, project, warnings)); },
      },
      project.terrain.kind());
  if (std::holds_alternative<RasterSurface>(*built.surface)) return built;  // its reader checks heights
  const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *built.surface);
  warn_of_high_terrain(box.high - box.low, project, warnings);
  return built;
}

}  // namespace talus::project
