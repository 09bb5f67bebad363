#include "talus/project/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "talus/core/nearest.hpp"
#include "talus/project/check_design.hpp"
#include "talus/project/check_seeder.hpp"
#include "talus/project/check_survey.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"
#include "talus/terrain/mend.hpp"
#include "talus/terrain/plan_polygon.hpp"

namespace talus::project {
namespace {

constexpr std::size_t most_complaints = 10;  // of one list; more would only hide the others

/// What the rules look at, and how they complain.
class Rules {
 public:
  Rules(const Project& project, const Document& document, const std::unordered_set<const toml::node*>& refused,
        Problems& problems)
      : project_(project), document_(document), refused_(refused), problems_(problems) {}

  void run() {
    about_name();
    about_analysis();
    about_terrain();
    about_materials();
    about_ground();
    about_seeders();
    about_barriers();
    about_design();
    about_output();
  }

 private:
  using Node = const toml::node*;

  void complain(const Spot& spot, std::string where, std::string what, std::string why, std::string hint = {},
                Severity severity = Severity::error) {
    Problem problem = document_.at(spot, severity);
    problem.where = std::move(where);
    problem.what = std::move(what);
    problem.why = std::move(why);
    problem.hint = std::move(hint);
    problems_.add(std::move(problem));
  }

  [[nodiscard]] const toml::table* table(std::string_view key) const { return document_.root()[key].as_table(); }

  /// The value of a key, where the file has it and it was not refused.
  [[nodiscard]] Node good(const toml::table* row, std::string_view key) const {
    const Node node = row ? row->get(key) : nullptr;
    return node && !refused_.contains(node) ? node : nullptr;
  }

  [[nodiscard]] static Node entry(Node list, std::size_t index) {
    const toml::array* array = list->as_array();
    return array && index < array->size() ? array->get(index) : list;
  }

  /// The rows of [[key]] as they stand in the file; null for an entry that is no table.
  [[nodiscard]] std::vector<const toml::table*> rows(std::string_view key) const {
    std::vector<const toml::table*> list;
    if (const toml::array* array = document_.root()[key].as_array()) {
      for (const toml::node& node : *array) list.push_back(node.as_table());
    }
    return list;
  }

  void about_name() {
    const Node node = good(&document_.root(), "name");
    const std::string& name = project_.name;
    const bool is_control = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 127; });
    if (node && (name.find('/') != std::string::npos || is_control || name == "." || name == "..")) {
      complain(node, "", fmt::format("name is {}", quoted(*node)), "the folder of the results is called by it",
               "Use a name without slashes, line breaks and the like");
    }
  }

  void about_analysis() {
    const toml::table* row = table("analysis");
    const Analysis& analysis = project_.analysis;
    const auto idle = [&](std::string_view key, bool has_effect, std::string_view needs) {
      const Node node = good(row, key);
      if (!node || has_effect) return;
      complain(node, "[analysis]", fmt::format("{} has no effect", key), fmt::format("it needs {}", needs), "",
               Severity::warning);
    };
    idle("rn_velocity_scale_m_s", analysis.scale_rn_by_velocity, "scale_rn_by_velocity = true");
    idle("rn_mass_scale_kg", analysis.scale_rn_by_mass, "scale_rn_by_mass = true");
    idle("tangential_crsp_damping", analysis.model == RockModel::rigid_sphere || !analysis.tangential_crsp_damping,
         "model = \"rigid_sphere\"");
    idle("rotation", analysis.model == RockModel::lumped_mass || analysis.rotation, "model = \"lumped_mass\"");
  }

  void about_terrain() {
    const std::string where = "[terrain]";
    const toml::table* row = table("terrain");
    if (!row) return;
    const bool has_section = row->contains("section"), has_mesh = row->contains("mesh");
    const bool has_triangles = row->contains("triangles"), has_vertices = row->contains("vertices");
    const bool has_raster = row->contains("raster");
    const bool is_surveyed =
        row->contains("points") || row->contains("lines") || row->contains("polylines") || row->contains("polygons");
    if (!has_section && !has_mesh && !has_triangles && !has_vertices && !has_raster && !is_surveyed) {
      complain(row, where, "there is no terrain",
               "expected one of section, mesh, triangles, raster, points, lines, polylines and polygons");
    }
    if (has_triangles != has_vertices && !has_section && !has_mesh && !has_raster && !is_surveyed) {
      const std::string_view missing = has_triangles ? "vertices" : "triangles";
      complain({row, row, missing}, where, fmt::format("{} is missing", missing),
               "an inline mesh needs vertices and triangles");
    }
    if (!has_section) {
      for (const std::string_view key : {"width_m", "section_std_dev_m"}) {
        if (const Node node = good(row, key)) {
          complain(node, where, fmt::format("{} is given without a section", key), "it would have no effect");
        }
      }
    }
    if (const Node section = good(row, "section")) about_section(where, section);
    if (const Node deviations = good(row, "section_std_dev_m"); deviations && good(row, "section")) {
      const std::size_t found = project_.terrain.section_std_dev_m.size(), wanted = project_.terrain.section.size();
      if (found != wanted) {
        complain(deviations, where, fmt::format("section_std_dev_m has {}", counted(found, "entry", "entries")),
                 fmt::format("expected one for each of the {} vertices of the section", wanted));
      }
    }
    if (is_2d(document_.root()) == true) {
      for (const std::string_view key : {"rotate_deg", "rotate_about"}) {
        const Node node = good(row, key);
        if (!node || (key == "rotate_deg" && project_.terrain.rotate_deg == 0)) continue;
        if (key == "rotate_about" && project_.terrain.rotate_deg == 0) continue;
        complain(node, where, fmt::format("{} is given in 2D", key), "a section cannot be turned",
                 "Give width_m for 3D");
      }
    }
    if (const Node turn = good(row, "rotate_deg"); turn && has_raster && project_.terrain.rotate_deg != 0) {
      complain(turn, where, "rotate_deg is given with a raster",
               "a raster stands where its coordinate system says, in rows from west to east", "Leave it out");
    }
    if (const Node about = good(row, "rotate_about"); about && !row->contains("rotate_deg")) {
      complain(about, where, "rotate_about has no effect", "it needs rotate_deg", "", Severity::warning);
    }
    if (const Node mesh = good(row, "mesh")) about_mesh_file(where, mesh);
    if (const Node raster = good(row, "raster")) about_gis_file(where, "raster", raster, project_.terrain.raster);
    if (good(row, "vertices") && good(row, "triangles")) about_inline_mesh(where, row);
    SurveyRules{project_, *row, [&](std::string_view key) { return good(row, key); },
                [&](const Spot& at, std::string what, std::string why, std::string hint, Severity severity) {
                  complain(at, where, std::move(what), std::move(why), std::move(hint), severity);
                }}
        .check();
  }

  void about_section(const std::string& where, Node section) {
    const auto& vertices = project_.terrain.section;
    if (vertices.size() < 2) {
      complain(section, where, fmt::format("section has {}", counted(vertices.size(), "vertex", "vertices")),
               "a slope has two or more");
    }
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Node node = entry(section, i);
      if (std::max(std::abs(vertices[i][0]), std::abs(vertices[i][1])) > largest_coordinate_m) {
        complain(node, where, fmt::format("section[{}] is {}", i, quoted(*node)),
                 fmt::format("coordinates lie within {:g} m", largest_coordinate_m));
      } else if (i > 0 && vertices[i] == vertices[i - 1]) {
        complain(node, where, fmt::format("section[{}] is {}", i, quoted(*node)), "it repeats the vertex before it",
                 "Leave it out");
      } else {
        continue;
      }
      if (++wrong == most_complaints) break;
    }
    if (wrong > 0) return;
    std::vector<Vec2> line;
    for (const auto& [x, z] : vertices) line.emplace_back(x, z);
    if (const auto at = line_crossing(line)) {
      complain(section, where, "section crosses or touches itself",
               fmt::format("at or near x = {:.10g}, z = {:.10g}", at->x(), at->y()),
               "Give its vertices in order along the slope");
    }
  }

  void about_mesh_file(const std::string& where, Node mesh) {
    std::string ending = project_.terrain.mesh.extension().string();
    for (char& letter : ending)
      letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    if (ending != ".obj" && ending != ".stl" && ending != ".ply") {
      complain(mesh, where, fmt::format("mesh is {}", quoted(*mesh)),
               "expected a file that ends in .obj, .stl or .ply");
      return;
    }
    // A project that is only a text has no folder in which its mesh could lie.
    std::error_code error;
    const std::filesystem::path path = project_.file.parent_path() / project_.terrain.mesh;
    if (std::filesystem::exists(project_.file, error) && !std::filesystem::is_regular_file(path, error)) {
      const bool is_folder = std::filesystem::is_directory(path, error);
      const bool is_there = std::filesystem::exists(path, error);
      complain(mesh, where, fmt::format("mesh is {}", quoted(*mesh)),
               is_folder  ? fmt::format("{} is a folder", path.string())
               : is_there ? fmt::format("{} is not an ordinary file", path.string())
                          : fmt::format("there is no file {}", path.string()),
               "Its path is relative to the project file");
    }
  }

  void about_gis_file(const std::string& where, std::string_view key, Node node, const std::filesystem::path& file) {
    // What GDAL opens may be a folder, or lie in a file system of its own.
    std::error_code error;
    const std::filesystem::path path = project_.file.parent_path() / file;
    if (std::filesystem::exists(project_.file, error) && !std::filesystem::exists(path, error) &&
        !path.string().starts_with("/vsi")) {
      complain(node, where, fmt::format("{} is {}", key, quoted(*node)),
               fmt::format("there is no file {}", path.string()), "Its path is relative to the project file");
    }
  }

  void about_inline_mesh(const std::string& where, const toml::table* row) {
    const Node node = row->get("triangles");
    const auto count = static_cast<std::int64_t>(project_.terrain.vertices.size());
    if (project_.terrain.triangles.empty()) complain(node, where, "triangles is empty", "a terrain has at least one");
    for (std::size_t i = 0; i < project_.terrain.triangles.size(); ++i) {
      const auto& [a, b, c] = project_.terrain.triangles[i];
      const Node triangle = entry(node, i);
      if (std::max({a, b, c}) >= count) {
        complain(triangle, where, fmt::format("triangles[{}] is {}", i, quoted(*triangle)),
                 count == 0 ? "there are no vertices"
                            : fmt::format("there are {} vertices; expected 0 to {}", count, count - 1),
                 std::max({a, b, c}) == count ? "Vertices are counted from 0" : "");
      } else if (a == b || b == c || c == a) {
        complain(triangle, where, fmt::format("triangles[{}] is {}", i, quoted(*triangle)),
                 "a triangle has three different vertices");
      }
    }
  }

  void about_materials() {
    std::vector<std::string_view> names;
    for (const Material& material : project_.materials) names.push_back(material.name);
    const auto list = rows("material");
    about_unique("materials", list, names);
    for (std::size_t i = 0; i < list.size() && i < project_.materials.size(); ++i) {
      if (list[i]) about_forest(project_.materials[i], *list[i], name_of_row(declaration("material"), *list[i], i));
    }
  }

  void about_forest(const Material& material, const toml::table& row, const std::string& where) {
    const bool has_forest = material.forest != Forest::none || material.forest_drag_kg_s;
    if (const Node height = good(&row, "forest_height_m"); height && !has_forest) {
      complain(height, where, "forest_height_m has no effect", "there is no forest",
               "Write forest = \"medium\", or give forest_drag_kg_s", Severity::warning);
    }
    if (has_forest && !row.contains("forest_height_m")) {
      const Node forest = row.get(material.forest_drag_kg_s ? "forest_drag_kg_s" : "forest");
      complain({forest, &row, "forest_height_m"}, where, "forest_height_m is missing",
               "a forest brakes rocks up to its effective height only",
               "Write how high above the ground its trunks and branches hold rocks up");
    }
  }

  /// Entries that are called by name must not share it. An empty name is one that is missing or was refused.
  void about_unique(std::string_view kinds, const std::vector<const toml::table*>& list,
                    const std::vector<std::string_view>& names) {
    std::unordered_map<std::string_view, std::size_t> first;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].empty() || first.emplace(names[i], i).second || !list[i]) continue;
      const toml::table* earlier = list[first.at(names[i])];
      const Node node = list[i]->contains("name") ? list[i]->get("name") : list[i];
      const int line = earlier ? document_.at(*earlier).line : 0;
      complain(node, "", fmt::format("two {} are called \"{}\"", kinds, names[i]),
               line > 0 ? fmt::format("the other begins in line {}", line) : "", "Give each its own name");
    }
  }

  [[nodiscard]] bool materials_are_known() const {
    const auto list = rows("material");
    return !list.empty() &&
           std::all_of(list.begin(), list.end(), [&](const toml::table* row) { return good(row, "name"); });
  }

  void about_material_name(const std::string& where, Node node, const std::string& key, const std::string& name) {
    std::vector<std::string_view> names;
    for (const Material& material : project_.materials) names.push_back(material.name);
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    std::string known;
    for (const std::string_view material : names) known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", material);
    const auto near = nearest(name, names);
    complain(node, where, fmt::format("{} is {}", key, quoted(*node)),
             fmt::format("there is no material of this name; there {} {}", names.size() == 1 ? "is" : "are", known),
             near ? fmt::format("Did you mean \"{}\"?", *near) : "");
  }

  void about_ground() {
    const std::string where = "[ground]";
    const toml::table* row = table("ground");
    const Ground& ground = project_.ground;
    if (!materials_are_known()) return;
    if (const Node node = good(row, "default")) about_material_name(where, node, "default", ground.default_material);
    const bool is_told = row && (row->contains("default") || row->contains("segments") || row->contains("triangles") ||
                                 row->contains("raster") || row->contains("polygons"));
    if (!is_told && project_.materials.size() > 1) {
      complain({row, row, "default"}, where, "default is missing",
               fmt::format("there are {} materials", project_.materials.size()),
               fmt::format("Write default = \"{}\", or segments with one name for each segment",
                           project_.materials.front().name));
    }
    const toml::table* terrain = table("terrain");
    if (const Node node = good(row, "segments")) {
      if (is_2d(document_.root()) && terrain && !terrain->contains("section")) {
        const bool on_raster = terrain->contains("raster");
        complain(node, where, "segments is given without a section",
                 on_raster ? "a raster has cells" : "a mesh has triangles",
                 on_raster ? "Use raster and classes" : "Use triangles, with one number for each triangle");
      } else if (good(terrain, "section") && project_.terrain.section.size() >= 2) {
        const std::size_t wanted = project_.terrain.section.size() - 1;
        if (ground.segments.size() != wanted) {
          complain(node, where, fmt::format("segments has {}", counted(ground.segments.size(), "entry", "entries")),
                   fmt::format("expected {}: the section has {}", wanted,
                               counted(project_.terrain.section.size(), "vertex", "vertices")));
        }
      }
      for (std::size_t i = 0; i < ground.segments.size(); ++i) {
        about_material_name(where, entry(node, i), fmt::format("segments[{}]", i), ground.segments[i]);
      }
    }
    if (const Node node = good(row, "triangles")) about_ground_triangles(where, node, terrain);
    about_ground_raster(where, row, terrain);
    if (row) about_ground_polygons(where, row, terrain);
  }

  void about_ground_raster(const std::string& where, const toml::table* row, const toml::table* terrain) {
    const Node raster = good(row, "raster"), classes = good(row, "classes");
    if (raster) {
      if (terrain && terrain->contains("section")) {
        complain(raster, where, "raster is given for a section", "a section has segments",
                 "Use segments, with one name for each segment");
      } else {
        about_gis_file(where, "raster", raster, project_.ground.raster);
      }
      if (!row->contains("classes")) {
        complain({raster, row, "classes"}, where, "classes is missing",
                 "nothing says which class of the raster is which material",
                 fmt::format("Write classes = {{ 1 = \"{}\" }}, with one entry for each class",
                             project_.materials.front().name));
      }
    }
    if (!classes) return;
    if (!row->contains("raster")) {
      complain(classes, where, "classes is given without a raster", "it would have no effect");
    }
    for (const auto& [key, node] : *classes->as_table()) {
      const std::string name = fmt::format("classes.{}", std::string_view(key.str()));
      if (const auto material = node.value<std::string>()) about_material_name(where, &node, name, *material);
    }
  }

  void about_ground_polygons(const std::string& where, const toml::table* row, const toml::table* terrain) {
    const Node polygons = good(row, "polygons");
    if (!polygons) {
      for (const std::string_view key : {"layer", "attribute", "values"}) {
        if (const Node node = good(row, key); node && !row->contains("polygons")) {
          complain(node, where, fmt::format("{} is given without polygons", key), "it would have no effect");
        }
      }
      return;
    }
    if (terrain && terrain->contains("section")) {
      complain(polygons, where, "polygons is given for a section", "a section has segments",
               "Use segments, with one name for each segment");
    } else {
      about_gis_file(where, "polygons", polygons, project_.ground.polygons);
    }
    if (!row->contains("attribute")) {
      complain({polygons, row, "attribute"}, where, "attribute is missing",
               "nothing says which polygon is of which material",
               "Write attribute = \"...\"; ogrinfo -so lists what there is");
    }
    if (const Node values = good(row, "values")) {
      for (const auto& [key, node] : *values->as_table()) {
        const std::string name = fmt::format("values.{}", std::string_view(key.str()));
        if (const auto material = node.value<std::string>()) about_material_name(where, &node, name, *material);
      }
    }
  }

  void about_ground_triangles(const std::string& where, Node node, const toml::table* terrain) {
    const Ground& ground = project_.ground;
    if (terrain && terrain->contains("section")) {
      complain(node, where, "triangles is given for a section", "a section has segments",
               "Use segments, with one name for each segment");
    } else if (terrain && terrain->contains("raster")) {
      complain(node, where, "triangles is given for a raster", "a raster has cells", "Use raster and classes");
    } else if (terrain && (terrain->contains("points") || terrain->contains("lines"))) {
      complain(node, where, "triangles is given for a survey", "its triangles are made by Talus",
               "Use raster and classes, or polygons");
    } else if (good(terrain, "triangles") && ground.triangles.size() != project_.terrain.triangles.size()) {
      complain(node, where, fmt::format("triangles has {}", counted(ground.triangles.size(), "entry", "entries")),
               fmt::format("expected {}, one for each triangle of the terrain", project_.terrain.triangles.size()));
    }
    const auto count = static_cast<std::int64_t>(project_.materials.size());
    for (std::size_t i = 0; i < ground.triangles.size(); ++i) {
      if (ground.triangles[i] < count) continue;
      complain(entry(node, i), where, fmt::format("triangles[{}] is {}", i, ground.triangles[i]),
               fmt::format("there {} {}, counted from 0; expected {}", count == 1 ? "is" : "are",
                           counted(static_cast<std::size_t>(count), "material", "materials"),
                           count == 1 ? "0" : fmt::format("0 to {}", count - 1)));
    }
  }

  void about_seeders() {
    const Table& declared = declaration("seeder");
    const auto list = rows("seeder");
    std::vector<std::string_view> names;
    double rocks = 0;
    for (std::size_t i = 0; i < project_.seeders.size(); ++i) {
      const Seeder& seeder = project_.seeders[i];
      names.push_back(seeder.name);
      rocks += static_cast<double>(seeder.rocks);
      if (list[i]) about_seeder(seeder, *list[i], name_of_row(declared, *list[i], i));
    }
    about_unique("seeders", list, names);
    const double most = setting("seeder", "rocks").range.most;
    if (rocks > most) {
      complain(list.back(), "", fmt::format("all seeders together have {} rocks", number_text(rocks)),
               fmt::format("expected at most {}", number_text(most)));
    }
  }

  void about_seeder(const Seeder& seeder, const toml::table& row, const std::string& where) {
    SeederRules{project_,
                seeder,
                row,
                !row.contains("type") || good(&row, "type"),
                is_2d(document_.root()) == true,
                table("terrain") && table("terrain")->contains("raster"),
                [&](std::string_view key) { return good(&row, key); },
                [&](const Spot& at, std::string what, std::string why, std::string hint, Severity severity) {
                  complain(at, where, std::move(what), std::move(why), std::move(hint), severity);
                }}
        .check();
  }

  void about_barriers() {
    std::vector<const toml::table*> all;
    std::vector<std::string_view> names;
    for (const std::string_view key : {"barrier", "collector"}) {
      const Table& declared = declaration(key);
      const auto list = rows(key);
      all.insert(all.end(), list.begin(), list.end());
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i]) about_restitution(*list[i], name_of_row(declared, *list[i], i), key);
      }
    }
    for (const Barrier& barrier : project_.barriers) names.push_back(barrier.name);
    about_unique("barriers or collectors", all, names);
  }

  void about_restitution(const toml::table& row, const std::string& where, std::string_view kind) {
    if (kind != "barrier" || row.contains("normal_restitution") == row.contains("tangential_restitution")) return;
    const bool has_normal = row.contains("normal_restitution");
    const std::string_view given = has_normal ? "normal_restitution" : "tangential_restitution";
    const std::string_view missing = has_normal ? "tangential_restitution" : "normal_restitution";
    complain({row.get(given), &row, missing}, where, fmt::format("{} is missing", missing),
             "a barrier has both restitutions, or neither and holds what it stops");
  }

  void about_design() {
    const toml::table* row = table("design");
    if (!row || !project_.design) return;
    DesignRules{project_,
                *project_.design,
                *row,
                rows("barrier"),
                rows("collector"),
                is_2d(document_.root()),
                [&](const toml::table* of, std::string_view key) { return good(of, key); },
                [&](Node at, std::string what, std::string why, std::string hint, Severity severity) {
                  complain(at, "[design]", std::move(what), std::move(why), std::move(hint), severity);
                }}
        .check();
  }

  void about_output() {
    const toml::table* row = table("output");
    const Output& output = project_.output;
    const auto has_no_effect = [&](std::string_view key, std::string why, std::string hint) {
      complain(row->get(key), "[output]", fmt::format("{} has no effect", key), std::move(why), std::move(hint),
               Severity::warning);
    };
    if (is_2d(document_.root()) == true) {
      if (good(row, "maps") && output.maps) {
        has_no_effect("maps", "a section has no area to map", "Give terrain.width_m for 3D");
      }
      if (good(row, "maps_by_source") && output.maps_by_source) {
        has_no_effect("maps_by_source", "a section has no area to map", "Give terrain.width_m for 3D");
      }
      if (good(row, "geopackage") && output.geopackage_limit != 0) {
        has_no_effect("geopackage", "a section lies nowhere on a map", "Give terrain.width_m for 3D");
      }
    }
    if (is_2d(document_.root()) == false && good(row, "maps_by_source") && output.maps_by_source && !output.maps) {
      has_no_effect("maps_by_source", "maps is false", "Let maps be true");
    }
    if (good(row, "vtk") && output.vtk && output.path_limit == 0) {
      has_no_effect("vtk", "paths is \"none\"", "Let paths be a number of rocks");
    }
    const toml::table* terrain = table("terrain");
    if (const Node cell = good(row, "raster_cell_m");
        cell && !output.raster_cell_m && terrain && !terrain->contains("raster")) {
      complain(cell, "[output]", "raster_cell_m is \"terrain\"", "the terrain is no raster, so it has no cells",
               "Give the side of a cell in metres");
    }
  }

  static std::string counted(std::size_t count, std::string_view one, std::string_view several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
  }

  static const Table& declaration(std::string_view key) {
    return *std::find_if(tables().begin(), tables().end(), [&](const Table& table) { return table.key == key; });
  }

  const Project& project_;
  const Document& document_;
  const std::unordered_set<const toml::node*>& refused_;
  Problems& problems_;
};

}  // namespace

void check(const Project& project, const Document& document, const std::unordered_set<const toml::node*>& refused,
           Problems& problems) {
  Rules(project, document, refused, problems).run();
}

}  // namespace talus::project
