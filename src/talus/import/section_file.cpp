#include "talus/import/section_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "talus/files/file_formats.hpp"
#include "talus/import/point_file.hpp"
#include "talus/import/vector_file.hpp"
#include "talus/meshing/simplified_line.hpp"

namespace talus {

namespace {

using SectionVertices = std::vector<std::array<double, 2>>;

[[noreturn]] void refuse_section(const SectionSource& source, std::string what, std::string why, std::string hint) {
  throw BadInput(Problem{.file = source.file.string(),
                         .where = {},
                         .what = std::move(what),
                         .why = std::move(why),
                         .hint = std::move(hint)});
}

/// Along the line itself, by the distance on plan.
SectionVertices section_along_line(const std::vector<Vec3>& line) {
  SectionVertices section;
  double distance = 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (k > 0) distance += (line[k] - line[k - 1]).xy().norm();
    section.push_back({distance, line[k].z()});
  }
  return section;
}

SectionVertices drawn_section(const std::vector<Vec3>& line) {
  SectionVertices section;
  for (const Vec3& p : line) section.push_back({p.x(), p.y()});
  return section;
}

SectionVertices section_of_text(const SectionSource& source) {
  const auto [points, has_y] = read_section_points(source.file);
  if (has_y) return section_along_line(points);
  SectionVertices section;
  for (const Vec3& p : points) section.push_back({p.x(), p.z()});
  return section;
}

SectionVertices section_of_line(const SectionSource& source, Problems& warnings) {
  VectorRequest request;
  request.layer = source.layer;
  request.layer_key = "section_layer";
  request.kinds = {ShapeKind::line};
  request.heights_are_used = true;
  request.level_lines_are_drawn = true;
  const VectorLayer layer = read_vector_file(source.file, request, warnings);
  std::size_t parts = 0;
  for (const VectorFeature& feature : layer.features) parts += feature.parts.size();
  if (parts > 1) {
    refuse_section(source, fmt::format("has {} lines", parts), "a section is one line",
                   "Put it on a layer of its own, and name that: section_layer = \"...\"");
  }
  const VectorFeature& feature = layer.features.front();
  const std::vector<Vec3>& line = feature.parts.front().lists.front();
  const auto is_level = [&](const Vec3& p) { return p.z() == line.front().z(); };
  if (feature.has_z && !std::ranges::all_of(line, is_level)) return section_along_line(line);
  if (!layer.crs_wkt.empty()) {
    refuse_section(source, "has a line without heights", fmt::format("it lies on plan, in {}", layer.crs_name),
                   "Cut the section from a terrain along it: talus section DEM --line FILE");
  }
  return drawn_section(line);
}

SectionVertices simplified_section(const SectionVertices& section, double tolerance) {
  std::vector<Vec2> line;
  for (const auto& [x, z] : section) line.emplace_back(x, z);
  SectionVertices out;
  for (const std::size_t k : vertices_to_keep(line, tolerance)) out.push_back(section[k]);
  return out;
}

}  // namespace

SectionVertices read_section_file(const SectionSource& source, Problems& warnings) {
  const bool is_text = is_of_kind(source.file, FileKind::point_text);
  if (is_text && !source.layer.empty())
    refuse_section(source, "has no layers", "it is a text file", "Leave section_layer out");
  SectionVertices section = is_text ? section_of_text(source) : section_of_line(source, warnings);
  section.erase(std::unique(section.begin(), section.end()), section.end());
  return source.tolerance_m > 0 ? simplified_section(section, source.tolerance_m) : section;
}

}  // namespace talus
