#include "talus/project/check_terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "talus/files/file_formats.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/meshing/plan_polygon.hpp"
#include "talus/project/check_survey.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"
#include "talus/project/varied_section.hpp"

namespace talus::project {

namespace {

/// Whether an unknown key was probably meant to define the terrain: then only that key is reported.
bool is_mistyped(const toml::table& row) {
  const Table& terrain = table("terrain");
  return std::ranges::any_of(terrain.keys_of_ways(),
                             [&](std::string_view key) { return project::is_mistyped(terrain, row, key); });
}

}  // namespace

void TerrainRules::refuse(const Spot& at, std::string what, std::string why, std::string hint) const {
  report(at, std::move(what), std::move(why), std::move(hint), Severity::error);
}

void TerrainRules::check() const {
  const auto given =
      std::ranges::count_if(table("terrain").keys_of_ways(), [&](std::string_view key) { return row.contains(key); });
  if (given == 0 && !is_mistyped(row)) {
    refuse(&row, "there is no terrain",
           "expected one of section, mesh, triangles, raster, points, lines, polylines and polygons");
  }
  const bool has_triangles = row.contains("triangles");
  if (given == 1 && (has_triangles || row.contains("vertices"))) {
    const std::string_view missing = has_triangles ? "vertices" : "triangles";
    refuse({&row, &row, missing}, fmt::format("{} is missing", missing), "an inline mesh needs vertices and triangles");
  }
  if (const Node section = accepted("section")) check_section(section);
  if (const Node deviations = accepted("section_std_dev_m"); deviations && accepted("section")) {
    check_deviations(deviations);
  }
  if (const Node mesh = accepted("mesh")) check_mesh_files(mesh);
  if (const Node raster = accepted("raster")) {
    if (const std::string why = why_unreadable(project, project.terrain.raster.file); !why.empty()) {
      refuse(raster, fmt::format("raster is {}", quoted(*raster)), why, "The path is relative to the project file");
    }
  }
  if (accepted("vertices") && accepted("triangles")) check_inline_mesh();
  SurveyRules{project, row, accepted, report}.check();
}

void TerrainRules::check_section(Node section) const {
  const auto& vertices = project.terrain.section.vertices;
  const bool is_in_file = !project.terrain.section.file.empty();
  if (is_in_file && vertices.empty()) return;  // it could not be read
  for (const std::string_view key : {"section_layer", "section_tolerance_m"}) {
    const Node only_of_file = is_in_file ? nullptr : accepted(key);
    if (only_of_file)
      refuse(only_of_file, fmt::format("{} is given", key), "the section is not in a file", "Leave it out");
  }
  if (vertices.size() < 2) {
    refuse(section, fmt::format("section has {}", counted(vertices.size(), "vertex", "vertices")),
           "a slope has two or more");
  }
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Node node = entry(section, i);
    const std::string vertex = fmt::format("[{}, {}]", number_text(vertices[i][0]), number_text(vertices[i][1]));
    if (std::max(std::abs(vertices[i][0]), std::abs(vertices[i][1])) > largest_coordinate_m) {
      refuse(node, fmt::format("section[{}] is {}", i, vertex),
             fmt::format("coordinates lie within {:g} m", largest_coordinate_m));
    } else if (i > 0 && vertices[i] == vertices[i - 1]) {
      refuse(node, fmt::format("section[{}] is {}", i, vertex), "it repeats the previous vertex", "Leave it out");
    } else {
      continue;
    }
    if (++wrong == most_reported) break;
  }
  if (wrong > 0) return;
  std::vector<Vec2> line;
  for (const auto& [x, z] : vertices) line.emplace_back(x, z);
  if (const auto at = line_crossing(line)) {
    refuse(section, "section crosses or touches itself",
           fmt::format("at or near x = {:.10g}, z = {:.10g}", at->x(), at->y()),
           "Give its vertices in order along the slope");
  }
}

void TerrainRules::check_deviations(Node deviations) const {
  const auto& vertices = project.terrain.section.vertices;
  const auto& std_devs = project.terrain.section.std_dev_m;
  if (std_devs.size() != vertices.size()) {
    refuse(deviations, fmt::format("section_std_dev_m has {}", counted(std_devs.size(), "entry", "entries")),
           fmt::format("expected one for each of the {} vertices of the section", vertices.size()));
    return;
  }
  const bool is_leftward = project.terrain.section.runs_leftwards();
  std::size_t wrong = 0;
  for (std::size_t i = 0; i + 1 < vertices.size() && wrong < most_reported; ++i) {
    const std::size_t left = is_leftward ? i + 1 : i, right = is_leftward ? i : i + 1;
    if (vertices[left][0] >= vertices[right][0]) continue;  // the section itself is an overhang there
    const double left_end = vertices[left][0] + most_deviations_of_vertex * std_devs[left][0];
    const double right_end = vertices[right][0] - most_deviations_of_vertex * std_devs[right][0];
    if (left_end < right_end || (std_devs[left][0] == 0 && std_devs[right][0] == 0)) continue;
    refuse(entry(deviations, i + 1),
           fmt::format("section_std_dev_m lets section[{}] and section[{}] swap places", i, i + 1),
           fmt::format("vertices move by up to {:g} standard deviations: the left one to x = {:.10g}, the right one to "
                       "x = {:.10g}",
                       most_deviations_of_vertex, left_end, right_end),
           "Reduce their standard deviations in x, or leave out one of the vertices");
    ++wrong;
  }
}

void TerrainRules::check_mesh_files(Node mesh) const {
  const auto& files = project.terrain.mesh.files;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const Node node = entry(mesh, k);
    const auto first = std::find(files.begin(), files.end(), files[k]);
    if (static_cast<std::size_t>(first - files.begin()) < k) {
      refuse(node, fmt::format("mesh[{}] is {}", k, quoted(*node)), "it is listed twice", "Leave it out");
    } else {
      check_mesh_file(node, files[k], mesh->is_array() ? fmt::format("mesh[{}]", k) : "mesh");
    }
  }
  if (const Node tolerance = accepted("merge_tolerance_m"); tolerance && files.size() == 1) {
    report(tolerance, "merge_tolerance_m has no effect", "there is one mesh, in which only equal vertices are merged",
           "Leave it out", Severity::warning);
  }
}

void TerrainRules::check_mesh_file(Node mesh, const std::filesystem::path& file, const std::string& name) const {
  if (!is_of_kind(file, FileKind::mesh)) {
    refuse(mesh, fmt::format("{} is {}", name, quoted(*mesh)),
           "expected a file that ends in " + endings_in_words(FileKind::mesh));
    return;
  }
  // A project without a file has no folder that could hold its mesh.
  std::error_code error;
  const std::filesystem::path path = project.file.parent_path() / file;
  std::string why = why_unreadable(project, file);
  if (why.empty() && std::filesystem::exists(project.file, error) && !std::filesystem::is_regular_file(path, error)) {
    const bool is_folder = std::filesystem::is_directory(path, error);
    why = is_folder ? "it is a folder" : "it is not an ordinary file";
  }
  if (why.empty()) return;
  refuse(mesh, fmt::format("{} is {}", name, quoted(*mesh)), why, "The path is relative to the project file");
}

void TerrainRules::check_inline_mesh() const {
  const Node node = row.get("triangles");
  const auto& [vertices, triangles] = project.terrain.inline_mesh;
  const auto count = static_cast<std::int64_t>(vertices.size());
  if (triangles.empty()) refuse(node, "triangles is empty", "a terrain has at least one");
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const Node triangle = entry(node, i);
    if (std::max({a, b, c}) >= count) {
      refuse(triangle, fmt::format("triangles[{}] is {}", i, quoted(*triangle)),
             count == 0 ? "there are no vertices"
                        : fmt::format("there are {} vertices; expected 0 to {}", count, count - 1),
             std::max({a, b, c}) == count ? "Vertices are numbered from 0" : "");
    } else if (a == b || b == c || c == a) {
      refuse(triangle, fmt::format("triangles[{}] is {}", i, quoted(*triangle)),
             "a triangle has three different vertices");
    }
  }
}

}  // namespace talus::project
