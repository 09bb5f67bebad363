#include "talus/project/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "talus/core/bytes.hpp"
#include "talus/files/file_formats.hpp"
#include "talus/files/picture_file.hpp"
#include "talus/maps/map_list.hpp"
#include "talus/project/applies.hpp"
#include "talus/project/check_design.hpp"
#include "talus/project/check_ground.hpp"
#include "talus/project/check_materials.hpp"
#include "talus/project/check_seeder.hpp"
#include "talus/project/check_shapes.hpp"
#include "talus/project/check_terrain.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {
namespace {

/// Whether a property of the row is a distribution.
bool is_random(const Table& declared, const Row& row) {
  return std::any_of(declared.settings.begin(), declared.settings.end(), [&](const Setting& setting) {
    const Distribution* const property = distribution_in(setting.slot(row));
    return property != nullptr && property->kind != DistributionKind::none;
  });
}

/// The rules, with the data they check and the list they report to.
class Rules {
 public:
  Rules(const Project& project, const Document& document, const std::unordered_set<const toml::node*>& refused,
        bool asks_a_line, Problems& problems)
      : project_(project), document_(document), refused_(refused), asks_a_line_(asks_a_line), problems_(problems) {}

  void run() {
    check_name();
    for (const Table& declared : tables()) {
      if (declared.key != "seeder") check_needs(declared);
    }
    if (const toml::table* terrain = table("terrain")) {
      TerrainRules{project_, *terrain, [&](std::string_view key) { return accepted(terrain, key); },
                   [&](const Spot& at, std::string what, std::string why, std::string hint, Severity severity) {
                     report(at, "[terrain]", std::move(what), std::move(why), std::move(hint), severity);
                   }}
          .check();
    }
    check_materials();
    check_samples();
    if (materials_are_known()) {
      GroundRules{project_,
                  table("ground"),
                  table("terrain"),
                  rows("area"),
                  rows("forest"),
                  is_2d(document_.root()),
                  [&](const toml::table* of, std::string_view key) { return accepted(of, key); },
                  [&](const Spot& at, std::string where, std::string what, std::string why, std::string hint) {
                    report(at, std::move(where), std::move(what), std::move(why), std::move(hint));
                  }}
          .check();
    }
    check_areas_and_forests();
    check_shapes();
    check_seeders();
    check_chance();
    check_barriers();
    check_design();
    check_output();
    check_logo();
    check_layers();
  }

 private:
  using Node = const toml::node*;

  void report(const Spot& spot, std::string where, std::string what, std::string why, std::string hint = {},
              Severity severity = Severity::error) {
    Problem problem = document_.at(spot, severity);
    problem.where = std::move(where);
    problem.what = std::move(what);
    problem.why = std::move(why);
    problem.hint = std::move(hint);
    problems_.add(std::move(problem));
  }

  [[nodiscard]] const toml::table* table(std::string_view key) const { return document_.root()[key].as_table(); }

  /// The value of a key; null if the file does not give it or it was refused.
  [[nodiscard]] Node accepted(const toml::table* row, std::string_view key) const {
    const Node node = row ? row->get(key) : nullptr;
    return node && !refused_.contains(node) ? node : nullptr;
  }

  /// The rows of [[key]] in the file; null for an entry that is not a table.
  [[nodiscard]] std::vector<const toml::table*> rows(std::string_view key) const {
    std::vector<const toml::table*> list;
    if (const toml::array* array = document_.root()[key].as_array()) {
      for (const toml::node& node : *array) list.push_back(node.as_table());
    }
    return list;
  }

  void check_name() {
    const Node node = accepted(&document_.root(), "name");
    const std::string& name = project_.name;
    if (node && (name.find('/') != std::string::npos || name == "." || name == "..")) {
      report(node, "", fmt::format("name is {}", quoted(*node)), "the folder of the results has the same name",
             "Use a name without slashes");
    }
  }

  /// `reported` is a key about which another rule has reported already.
  void check_needs(const Table& declared, const toml::table& row, const std::string& where, std::string_view reported) {
    for (const Setting& setting : declared.settings) {
      if (setting.key == reported) continue;
      if (const auto not_met = conditions_.unmet(declared, row, setting)) {
        report(row.get(setting.key), where, not_met->what, not_met->why, not_met->hint, not_met->severity);
      }
    }
  }

  void check_needs(const Table& declared) {
    if (declared.key.empty()) return;
    if (!declared.repeated) {
      if (const toml::table* row = table(declared.key)) check_needs(declared, *row, declared.heading(), "");
      return;
    }
    const auto list = rows(declared.key);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i]) check_needs(declared, *list[i], name_of_row(declared, *list[i], i), "");
    }
  }

  void check_materials() {
    std::vector<std::string_view> names;
    for (const Material& material : project_.materials) names.push_back(material.name);
    const auto list = rows("material");
    check_unique("materials", list, names);
    const toml::table* terrain = table("terrain");
    const auto has = [&](std::string_view key) { return terrain && terrain->contains(key); };
    MaterialRules{
        project_, list, has("raster") || has("mesh") || has("points") || has("lines"),
        [&](const toml::table* of, std::string_view key) { return accepted(of, key); },
        [&](const Spot& at, std::string where, std::string what, std::string why, std::string hint, Severity severity) {
          report(at, std::move(where), std::move(what), std::move(why), std::move(hint), severity);
        }}
        .check();
  }

  /// The files of empirical distributions.
  void check_samples() {
    for (const NamedFile& named : project_.named_files) {
      const bool is_of_sample = named.key.ends_with(" file");  // a part of a random property: "mass_kg file"
      if (!is_of_sample) continue;
      const auto refuse = [&](std::string why, std::string hint) {
        problems_.add({.file = named.named_in,
                       .line = named.line,
                       .where = named.where,
                       .what = fmt::format("{} is \"{}\"", named.key, named.file.string()),
                       .why = std::move(why),
                       .hint = std::move(hint),
                       .path = named.path});
      };
      if (const std::string why = why_unreadable(project_, named.file); !why.empty()) {
        refuse(why, "The path is relative to the project file");
      } else if (!is_of_kind(named.file, FileKind::point_text)) {
        refuse("expected a text file that ends in " + endings_in_words(FileKind::point_text), "");
      }
    }
  }

  /// Names must be unique. An empty name is missing or was refused.
  void check_unique(std::string_view kinds, const std::vector<const toml::table*>& list,
                    const std::vector<std::string_view>& names) {
    std::unordered_map<std::string_view, std::size_t> first;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].empty() || first.emplace(names[i], i).second || !list[i]) continue;
      const toml::table* earlier = list[first.at(names[i])];
      const Node node = list[i]->contains("name") ? list[i]->get("name") : list[i];
      const int line = earlier ? document_.at(*earlier).line : 0;
      report(node, "", fmt::format("two {} are named \"{}\"", kinds, names[i]),
             line > 0 ? fmt::format("the first begins in line {}", line) : "", "Give each its own name");
    }
  }

  [[nodiscard]] bool materials_are_known() const {
    const auto list = rows("material");
    return !list.empty() &&
           std::all_of(list.begin(), list.end(), [&](const toml::table* row) { return accepted(row, "name"); });
  }

  void check_areas_and_forests() {
    std::vector<std::string_view> areas, forests;
    for (const Area& area : project_.areas) areas.push_back(area.name);
    for (const ForestArea& forest : project_.forests) forests.push_back(forest.name);
    check_unique("areas", rows("area"), areas);
    check_unique("forests", rows("forest"), forests);
  }

  void check_shapes() {
    std::vector<std::string_view> names;
    for (const Shape& shape : project_.shapes) names.push_back(shape.name);
    check_unique("shapes", rows("shape"), names);
    ShapeRules{
        project_,
        rows("shape"),
        rows("seeder"),
        is_2d(document_.root()) == true,
        [&](const toml::table* of, std::string_view key) { return accepted(of, key); },
        [&](const Spot& at, std::string where, std::string what, std::string why, std::string hint, Severity severity) {
          report(at, std::move(where), std::move(what), std::move(why), std::move(hint), severity);
        }}
        .check();
  }

  void check_seeders() {
    const Table& declared = project::table("seeder");
    const auto list = rows("seeder");
    std::vector<std::string_view> names;
    double rocks = 0;
    for (std::size_t i = 0; i < project_.seeders.size(); ++i) {
      const Seeder& seeder = project_.seeders[i];
      names.push_back(seeder.name);
      rocks += static_cast<double>(seeder.rocks);
      if (list[i]) check_seeder(seeder, *list[i], name_of_row(declared, *list[i], i));
    }
    check_unique("seeders", list, names);
    const double most = setting("seeder", "rocks").range.most;
    if (rocks > most) {
      report(list.back(), "", fmt::format("all seeders together have {} rocks", number_text(rocks)),
             fmt::format("expected at most {}", number_text(most)));
    }
  }

  /// Whether a value of the entry was refused, so that its meaning is unknown.
  [[nodiscard]] bool has_refused(const toml::table* row) const {
    return !row ||
           std::any_of(row->begin(), row->end(), [&](const auto& part) { return refused_.contains(&part.second); });
  }

  /// Warns of many rocks of a seeder that would all follow the same path.
  void check_chance() {
    const auto materials = rows("material");
    if (std::any_of(materials.begin(), materials.end(), [&](const toml::table* row) { return has_refused(row); }))
      return;
    Project copy = project_;  // slots are not const
    if (!copy.terrain.section.std_dev_m.empty()) return;
    for (Material& material : copy.materials) {
      const bool is_rough = material.roughness_deg.mean > 0 || material.roughness_amplitude_m > 0;
      if (is_rough || is_random(project::table("material"), &material)) return;
    }
    constexpr std::int64_t many = 100;  // enough that the user expects statistics
    const auto list = rows("seeder");
    for (std::size_t i = 0; i < copy.seeders.size(); ++i) {
      Seeder& seeder = copy.seeders[i];
      const bool is_one_rock = seeder.type == SeederType::point && !is_random(project::table("seeder"), &seeder);
      if (!is_one_rock || seeder.rocks < many || has_refused(list[i])) continue;
      report(list[i]->get("rocks"), name_of_row(project::table("seeder"), *list[i], i),
             fmt::format("its {} rocks are identical", seeder.rocks),
             "nothing about them or the ground is random, so they all follow one path",
             "Give restitution or friction a distribution, or the ground a roughness", Severity::warning);
    }
  }

  void check_seeder(const Seeder& seeder, const toml::table& row, const std::string& where) {
    const SeederRules rules{
        project_,
        seeder,
        row,
        !row.contains("type") || accepted(&row, "type"),
        is_2d(document_.root()) == true,
        table("terrain") && table("terrain")->contains("raster"),
        [&](std::string_view key) { return accepted(&row, key); },
        [&](const Spot& at, std::string what, std::string why, std::string hint, Severity severity) {
          report(at, where, std::move(what), std::move(why), std::move(hint), severity);
        }};
    const std::string_view reported = rules.check_place();
    if (reported != "type") check_needs(project::table("seeder"), row, where, reported);
    rules.check();
  }

  void check_barriers() {
    std::vector<const toml::table*> all;
    std::vector<std::string_view> names;
    for (const std::string_view key : {"barrier", "collector"}) {
      const Table& declared = project::table(key);
      const auto list = rows(key);
      all.insert(all.end(), list.begin(), list.end());
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i]) check_restitution(*list[i], name_of_row(declared, *list[i], i), key);
      }
    }
    for (const Barrier& barrier : project_.barriers) names.push_back(barrier.name);
    check_unique("barriers or collectors", all, names);
  }

  void check_restitution(const toml::table& row, const std::string& where, std::string_view kind) {
    if (kind != "barrier" || row.contains("normal_restitution") == row.contains("tangential_restitution")) return;
    const bool has_normal = row.contains("normal_restitution");
    const std::string_view given = has_normal ? "normal_restitution" : "tangential_restitution";
    const std::string_view missing = has_normal ? "tangential_restitution" : "normal_restitution";
    report({row.get(given), &row, missing}, where, fmt::format("{} is missing", missing),
           "a barrier has both restitutions, or neither if it holds the rocks it stops");
  }

  void check_design() {
    const toml::table* row = table("design");
    std::vector<std::string_view> names;
    for (const Kit& kit : project_.kits) names.push_back(kit.name);
    check_unique("kits", rows("kit"), names);
    if (!project_.kits.empty() && !row) {
      report(document_.root().get("kit"), "", "[[kit]] has no effect", "kits are chosen from by [design]",
             "Add [design]", Severity::warning);
    }
    if (!row || !project_.design) return;
    DesignRules{project_,
                *project_.design,
                *row,
                rows("barrier"),
                rows("collector"),
                rows("kit"),
                is_2d(document_.root()),
                asks_a_line_,
                [&](const toml::table* of, std::string_view key) { return accepted(of, key); },
                [&](Node at, std::string what, std::string why, std::string hint, Severity severity) {
                  report(at, "[design]", std::move(what), std::move(why), std::move(hint), severity);
                },
                [&](std::size_t kit, Node at, std::string what, std::string why, std::string hint, Severity severity) {
                  report(at, name_of_row(project::table("kit"), *rows("kit")[kit], kit), std::move(what),
                         std::move(why), std::move(hint), severity);
                },
                [&](const Problems& of_file) { problems_.append(located_in_project(of_file, project_, "[design]")); }}
        .check();
  }

  void check_bands(const toml::array& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto name = list[i].value<std::string_view>().value_or("");
      const auto found = std::ranges::find(map_subject_names, name);
      if (found == map_subject_names.end()) continue;
      const auto place = static_cast<std::size_t>(found - map_subject_names.begin());
      if (!banded_map_subjects[place]) {
        report(list.get(i), "[output]", fmt::format("bands[{}] is \"{}\"", i, name),
               "counts of ensembles depend on their number of rocks", "Choose \"reach_share\"");
      } else if (project_.output.maps.any() && !project_.output.maps[place]) {
        report(list.get(i), "[output]", fmt::format("bands: \"{}\" has no effect", name), "maps does not list it",
               "Add it there", Severity::warning);
      }
    }
  }

  void check_logo() {
    const Node node = accepted(table("report"), "logo");
    std::error_code error;
    if (!node || !std::filesystem::exists(project_.file, error)) return;  // without a file there is no folder
    std::string why = why_unreadable(project_, project_.title_block.logo);
    try {
      if (why.empty()) (void)data_address_of_picture(project_.file.parent_path() / project_.title_block.logo);
    } catch (const BadBytes& bad) {
      why = bad.what();
    }
    if (why.empty()) return;
    report(node, "[report]", fmt::format("logo is {}", quoted(*node)), std::move(why),
           "Name a PNG or JPEG picture; the path is relative to the project file");
  }

  /// Their files are checked where they are drawn, and by `talus check`: a run does without them.
  void check_layers() {
    const auto list = rows("layer");
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < project_.layers.size(); ++i) {
      names.push_back(project_.layers[i].name);
      const Node colour = accepted(list[i], "colour");
      if (!colour || is_colour(project_.layers[i].colour)) continue;
      report(colour, name_of_row(project::table("layer"), *list[i], i), fmt::format("colour is {}", quoted(*colour)),
             "expected red, green and blue as hexadecimal numbers: \"#d95f02\"");
    }
    check_unique("layers", list, names);
  }

  static bool is_colour(std::string_view text) {
    return text.size() == 7 && text.front() == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
  }

  void check_output() {
    const toml::table* row = table("output");
    const Output& output = project_.output;
    const bool has_only_counts = output.maps.any() && contents_of({output.maps, {}}).quantities() == 0;
    const auto warn_if_in_vain = [&](const char* key, bool asks) {
      if (!has_only_counts || !asks || !accepted(row, key) || !accepted(row, "maps")) return;
      report(row->get(key), "[output]", fmt::format("{} has no effect", key), "maps lists only counts",
             "Add a quantity, such as \"energy_total\"", Severity::warning);
    };
    warn_if_in_vain("percentiles", output.percentiles && !output.percentiles->empty());
    warn_if_in_vain("means", output.means);
    if (const Node list = accepted(row, "bands"); list && list->is_array()) check_bands(*list->as_array());
    if (const Node list = accepted(row, "percentiles")) {
      const std::vector<double> percentiles = output.percentiles.value_or(std::vector<double>());
      for (const std::size_t i : repeated(percentiles)) {
        report(list->as_array()->get(i), "[output]",
               fmt::format("percentiles[{}] is {}", i, number_text(percentiles[i])), "it is listed twice",
               "Leave it out");
      }
    }
    const toml::table* terrain = table("terrain");
    if (const Node cell = accepted(row, "raster_cell_m");
        cell && !output.raster_cell_m && terrain && !terrain->contains("raster")) {
      report(cell, "[output]", "raster_cell_m is \"terrain\"", "the terrain is not a raster, so it has no cells",
             "Give the cell size in metres");
    }
  }

  const Project& project_;
  const Document& document_;
  const std::unordered_set<const toml::node*>& refused_;
  bool asks_a_line_;
  Problems& problems_;
  const ConditionCheck conditions_{document_.root(), refused_};
};

}  // namespace

void check(const Project& project, const Document& document, const std::unordered_set<const toml::node*>& refused,
           bool asks_a_line, Problems& problems) {
  Rules(project, document, refused, asks_a_line, problems).run();
}

}  // namespace talus::project
