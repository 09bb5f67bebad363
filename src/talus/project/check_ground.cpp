#include "talus/project/check_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "talus/core/nearest.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

void GroundRules::refuse(const Spot& at, std::string what, std::string why, std::string hint) const {
  report(at, "[ground]", std::move(what), std::move(why), std::move(hint));
}

void GroundRules::check() const {
  about_default();
  if (const Node segments = good(row, "segments")) about_segments(segments);
  if (const Node triangles = good(row, "triangles")) about_triangles(triangles);
  about_raster();
  about_polygons();
  about_areas();
}

void GroundRules::about_default() const {
  if (const Node node = good(row, "default")) {
    about_material("[ground]", node, "default", project.ground.default_material);
  }
  const auto has = [&](std::string_view key) { return row->contains(key); };
  const bool is_reported = row && (has("default") || std::ranges::any_of(table("ground").keys_of_ways(), has));
  if (is_reported || project.materials.size() < 2) return;
  refuse({row, row, "default"}, "default is missing", fmt::format("there are {} materials", project.materials.size()),
         fmt::format("Write default = \"{}\"{}", project.materials.front().name,
                     is_on("section") ? ", or segments with one name for each segment" : ""));
}

void GroundRules::about_segments(Node segments) const {
  const auto& given = project.ground.segments;
  if (good(terrain, "section") && project.terrain.section.size() >= 2) {
    const std::size_t vertices = project.terrain.section.size();
    if (given.size() != vertices - 1) {
      refuse(segments, fmt::format("segments has {}", counted(given.size(), "entry", "entries")),
             fmt::format("expected {}: the section has {}", vertices - 1, counted(vertices, "vertex", "vertices")));
    }
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    about_material("[ground]", entry(segments, i), fmt::format("segments[{}]", i), given[i]);
  }
}

void GroundRules::about_triangles(Node triangles) const {
  const auto& given = project.ground.triangles;
  if (good(terrain, "triangles") && given.size() != project.terrain.triangles.size()) {
    refuse(triangles, fmt::format("triangles has {}", counted(given.size(), "entry", "entries")),
           fmt::format("expected {}, one for each triangle of the terrain", project.terrain.triangles.size()));
  }
  const auto count = static_cast<std::int64_t>(project.materials.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i] < count) continue;
    refuse(entry(triangles, i), fmt::format("triangles[{}] is {}", i, given[i]),
           fmt::format("there {} {}, counted from 0; expected {}", count == 1 ? "is" : "are",
                       counted(static_cast<std::size_t>(count), "material", "materials"),
                       count == 1 ? "0" : fmt::format("0 to {}", count - 1)));
  }
}

void GroundRules::about_raster() const {
  const Node raster = good(row, "raster"), classes = good(row, "classes");
  if (raster) {
    about_file("raster", raster, project.ground.raster);
    if (!row->contains("classes")) {
      refuse({raster, row, "classes"}, "classes is missing", "nothing says which class of the raster is which material",
             fmt::format("Write classes = {{ 1 = \"{}\" }}, with one entry for each class",
                         project.materials.front().name));
    }
  }
  if (!classes) return;
  about_materials_in("classes", classes);
}

void GroundRules::about_polygons() const {
  const Node polygons = good(row, "polygons");
  if (!polygons) return;
  about_file("polygons", polygons, project.ground.polygons);
  if (!row->contains("attribute")) {
    refuse({polygons, row, "attribute"}, "attribute is missing", "nothing says which polygon is of which material",
           "Write attribute = \"...\"; ogrinfo -so lists what there is");
  }
  if (const Node values = good(row, "values")) about_materials_in("values", values);
}

void GroundRules::about_areas() const {
  for (std::size_t i = 0; i < areas.size() && i < project.areas.size(); ++i) {
    if (!areas[i]) continue;
    const std::string where = name_of_row(table("area"), *areas[i], i);
    if (const Node material = good(areas[i], "material")) {
      about_material(where, material, "material", project.areas[i].material);
    }
    if (is_flat == true) {
      report({areas[i]}, where, "an area is given in 2D", "a section has segments",
             "Use ground.segments, with one name for each segment");
    }
  }
}

void GroundRules::about_file(std::string_view key, Node node, const std::filesystem::path& file) const {
  if (is_on("section")) return;  // then it has no effect at all
  if (const std::string why = why_unreadable(project, file); !why.empty()) {
    refuse(node, fmt::format("{} is {}", key, quoted(*node)), why, "Its path is relative to the project file");
  }
}

void GroundRules::about_materials_in(std::string_view key, Node names) const {
  for (const auto& [name, node] : *names->as_table()) {
    if (const auto material = node.value<std::string>()) {
      about_material("[ground]", &node, fmt::format("{}.{}", key, std::string_view(name.str())), *material);
    }
  }
}

void GroundRules::about_material(const std::string& where, Node node, const std::string& key,
                                 const std::string& name) const {
  std::vector<std::string_view> names;
  for (const Material& material : project.materials) names.push_back(material.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  std::string known;
  for (const std::string_view material : names) known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", material);
  const auto near = nearest(name, names);
  report(node, where, fmt::format("{} is {}", key, quoted(*node)),
         fmt::format("there is no material of this name; there {} {}", names.size() == 1 ? "is" : "are", known),
         near ? fmt::format("Did you mean \"{}\"?", *near) : "");
}

}  // namespace talus::project
