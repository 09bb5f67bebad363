#include "talus/model/cut_section.hpp"

#include <fmt/format.h>

#include <variant>

#include "talus/core/problems.hpp"
#include "talus/meshing/simplified_line.hpp"
#include "talus/terrain/section_along.hpp"

namespace talus {

namespace {

constexpr std::size_t most_vertices = 1'000'000;

[[noreturn]] void refuse_cut(std::string_view where, std::string what, std::string why, std::string hint) {
  throw BadInput(
      Problem{.where = std::string(where), .what = std::move(what), .why = std::move(why), .hint = std::move(hint)});
}

std::vector<SectionPoint> ground_along(const ModelSurface& surface, std::span<const Vec2> line,
                                       std::string_view where) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&surface)) return section_along(*mesh, line, most_vertices);
  if (const auto* raster = std::get_if<RasterSurface>(&surface)) return section_along(*raster, line, most_vertices);
  refuse_cut(where, "no section can be cut", "the terrain is itself a section", "Use its vertices");
}

void refuse_gaps(const std::vector<SectionPoint>& section, std::string_view where) {
  for (std::size_t k = 0; k < section.size(); ++k) {
    if (section[k].z) continue;
    const bool is_last = k + 1 == section.size();
    refuse_cut(where, "the line leaves the ground",
               is_last ? fmt::format("there is none beyond {:.6g} m along the line", section[k].distance)
                       : fmt::format("there is none from {:.6g} to {:.6g} m along the line", section[k].distance,
                                     section[k + 1].distance),
               "Draw it over the terrain, without holes");
  }
}

}  // namespace

std::vector<SectionVertex> cut_section(const ModelSurface& surface, const LocalFrame& frame,
                                       std::span<const std::array<double, 2>> line, double tolerance,
                                       std::string_view where) {
  std::vector<Vec2> local;
  for (const auto& [x, y] : line) local.push_back(frame.local_from_global({x, y, 0}).xy());
  const std::vector<SectionPoint> ground = ground_along(surface, local, where);
  refuse_gaps(ground, where);
  if (ground.empty() || !(ground.back().distance > 0))
    refuse_cut(where, "the line has no length", "a section leads from one place to another", "");
  if (ground.size() >= most_vertices) {
    refuse_cut(where, "the section is too large", fmt::format("it has more than {} bends", most_vertices),
               "Cut it into parts");
  }
  std::vector<Vec2> drawn;
  for (const SectionPoint& point : ground) drawn.emplace_back(point.distance, *point.z);
  std::vector<SectionVertex> section;
  for (const std::size_t k : vertices_to_keep(drawn, tolerance)) {
    const SectionPoint& point = ground[k];
    section.push_back({point.distance, frame.global_from_local({point.place.x(), point.place.y(), *point.z})});
  }
  return section;
}

std::string section_table(std::span<const SectionVertex> section) {
  std::string table(section_header);
  for (const SectionVertex& vertex : section) {
    table += fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}\n", vertex.distance, vertex.place.z(), vertex.place.x(),
                         vertex.place.y());
  }
  return table;
}

}  // namespace talus
