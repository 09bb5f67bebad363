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
  check_default();
  if (const Node segments = accepted(row, "segments")) check_segments(segments);
  if (const Node triangles = accepted(row, "triangles")) check_triangles(triangles);
  check_raster();
  check_polygons();
  check_areas();
  check_forests();
}

void GroundRules::check_default() const {
  if (const Node node = accepted(row, "default")) {
    check_material("[ground]", node, "default", project.ground.default_material);
  }
  const auto has = [&](std::string_view key) { return row->contains(key); };
  const bool is_reported = row && (has("default") || std::ranges::any_of(table("ground").keys_of_ways(), has));
  if (is_reported || project.materials.size() < 2) return;
  refuse({row, row, "default"}, "default is missing", fmt::format("there are {} materials", project.materials.size()),
         fmt::format("Write default = \"{}\"{}", project.materials.front().name,
                     is_on("section") ? ", or segments with one name for each segment" : ""));
}

void GroundRules::check_segments(Node segments) const {
  const auto& given = project.ground.segments;
  if (accepted(terrain, "section") && project.terrain.section.vertices.size() >= 2) {
    const std::size_t vertices = project.terrain.section.vertices.size();
    if (given.size() != vertices - 1) {
      refuse(segments, fmt::format("segments has {}", counted(given.size(), "entry", "entries")),
             fmt::format("expected {}: the section has {}", vertices - 1, counted(vertices, "vertex", "vertices")));
    }
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    check_material("[ground]", entry(segments, i), fmt::format("segments[{}]", i), given[i]);
  }
}

void GroundRules::check_triangles(Node triangles) const {
  const auto& given = project.ground.triangles;
  if (accepted(terrain, "triangles") && given.size() != project.terrain.inline_mesh.triangles.size()) {
    refuse(
        triangles, fmt::format("triangles has {}", counted(given.size(), "entry", "entries")),
        fmt::format("expected {}, one for each triangle of the terrain", project.terrain.inline_mesh.triangles.size()));
  }
  const auto count = static_cast<std::int64_t>(project.materials.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (given[i] < count) continue;
    refuse(entry(triangles, i), fmt::format("triangles[{}] is {}", i, given[i]),
           fmt::format("there {} {}, numbered from 0; expected {}", count == 1 ? "is" : "are",
                       counted(static_cast<std::size_t>(count), "material", "materials"),
                       count == 1 ? "0" : fmt::format("0 to {}", count - 1)));
  }
}

void GroundRules::check_raster() const {
  const Node raster = accepted(row, "raster"), classes = accepted(row, "classes");
  if (raster) {
    check_file("[ground]", "raster", raster, project.ground.raster);
    if (!row->contains("classes")) {
      refuse({raster, row, "classes"}, "classes is missing", "the materials of its classes are not given",
             fmt::format("Write classes = {{ 1 = \"{}\" }}, with one entry for each class",
                         project.materials.front().name));
    }
  }
  if (!classes) return;
  check_materials_in("classes", classes);
}

void GroundRules::check_polygons() const {
  const Node polygons = accepted(row, "polygons");
  if (!polygons) return;
  check_file("[ground]", "polygons", polygons, project.ground.polygons);
  if (!row->contains("attribute")) {
    refuse({polygons, row, "attribute"}, "attribute is missing", "the materials of the polygons are not given",
           "Write attribute = \"...\"; ogrinfo -so lists the attributes");
  }
  if (const Node values = accepted(row, "values")) check_materials_in("values", values);
}

void GroundRules::check_areas() const {
  for (std::size_t i = 0; i < areas.size() && i < project.areas.size(); ++i) {
    if (!areas[i]) continue;
    const std::string where = name_of_row(table("area"), *areas[i], i);
    if (const Node material = accepted(areas[i], "material")) {
      check_material(where, material, "material", project.areas[i].material);
    }
    if (is_2d == true) {
      report({areas[i]}, where, "an area is given in 2D", "a section has segments",
             "Use ground.segments, with one name for each segment");
    }
  }
}

void GroundRules::check_forests() const {
  for (std::size_t i = 0; i < forests.size() && i < project.forests.size(); ++i) {
    if (!forests[i]) continue;
    const std::string where = name_of_row(table("forest"), *forests[i], i);
    if (is_2d == true) {
      report({forests[i]}, where, "a [[forest]] is given in 2D", "it is drawn on plan",
             "Give the materials of the section a forest, with forest and forest_height_m");
    } else {
      check_forest(project.forests[i], *forests[i], where);
    }
  }
}

void GroundRules::check_forest(const ForestArea& forest, const toml::table& given, const std::string& where) const {
  const auto missing = [&](std::string what, std::string why, std::string hint) {
    report({&given}, where, std::move(what), std::move(why), std::move(hint));
  };
  if (!given.contains("polygon") && !given.contains("polygons")) {
    missing("polygon is missing", "nothing says where the forest stands",
            "Give polygon = [[x, y], ...], or polygons = a file of them");
  }
  const bool is_clearing = given.contains("density") && forest.density == Forest::none;
  if (!given.contains("density") && !given.contains("drag_kg_s")) {
    missing("density is missing", "nothing says how much the forest slows rocks",
            "Write density = \"open\", \"medium\" or \"dense\", or give drag_kg_s");
  }
  if (!is_clearing && !given.contains("height_m")) {
    missing("height_m is missing", "a forest slows rocks only up to its effective height",
            "Give the height above the ground up to which trunks and branches slow rocks");
  }
  if (given.contains("attribute") && !given.contains("values")) {
    report({given.get("attribute"), &given, "values"}, where, "values is missing",
           "attribute tells which polygons are this forest by its values",
           "Write values = [\"...\"], or leave out attribute for all polygons of the file");
  }
  if (const Node polygons = accepted(&given, "polygons")) check_file(where, "polygons", polygons, forest.polygons);
}

void GroundRules::check_file(const std::string& where, std::string_view key, Node node,
                             const std::filesystem::path& file) const {
  if (is_on("section")) return;  // reported as having no effect
  if (const std::string why = why_unreadable(project, file); !why.empty()) {
    report(node, where, fmt::format("{} is {}", key, quoted(*node)), why, "The path is relative to the project file");
  }
}

void GroundRules::check_materials_in(std::string_view key, Node names) const {
  for (const auto& [name, node] : *names->as_table()) {
    if (const auto material = node.value<std::string>()) {
      check_material("[ground]", &node, fmt::format("{}.{}", key, std::string_view(name.str())), *material);
    }
  }
}

void GroundRules::check_material(const std::string& where, Node node, const std::string& key,
                                 const std::string& name) const {
  std::vector<std::string_view> names;
  for (const Material& material : project.materials) names.push_back(material.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  std::string known;
  for (const std::string_view material : names) known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", material);
  const auto near = nearest(name, names);
  report(node, where, fmt::format("{} is {}", key, quoted(*node)),
         fmt::format("no material has this name; the project has {}", known),
         near ? fmt::format("Did you mean \"{}\"?", *near) : "");
}

}  // namespace talus::project
