#include "talus/project/check_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "talus/core/nearest.hpp"
#include "talus/files/file_formats.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/row_keys.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

namespace {

constexpr std::array ways{"b_over_a", "axes_m", "solid", "sides", "polygon", "scan", "of"};

}  // namespace

void ShapeRules::refuse(const toml::table& row, std::string_view of, std::size_t number, std::string_view key,
                        std::string what, std::string why, std::string hint) const {
  const toml::node* node = row.get(key);
  report(node ? Spot(node) : Spot(&row, &row, key), name_of_row(table(of), row, number), std::move(what),
         std::move(why), std::move(hint), Severity::error);
}

void ShapeRules::check() const {
  for (std::size_t i = 0; i < shapes.size() && i < project.shapes.size(); ++i) {
    if (shapes[i]) check_shape(i);
  }
  for (std::size_t i = 0; i < seeders.size() && i < project.seeders.size(); ++i) {
    if (seeders[i]) check_seeder(i);
  }
  warn_of_spheres();
}

/// A table may give the axes of blocks.
void ShapeRules::warn_of_spheres() const {
  if (project.analysis.model != RockModel::rigid_body || seeders.empty() || !seeders.front()) return;
  const bool all_spheres = std::ranges::all_of(project.seeders, [](const Seeder& seeder) {
    return seeder.shape == sphere_word && seeder.type != SeederType::table;
  });
  const bool is_chosen = std::ranges::any_of(seeders, [](const auto* row) { return row && row->contains("shape"); });
  if (!all_spheres || is_chosen) return;
  report(Spot(seeders.front(), seeders.front(), "shape"), "", "no seeder has a shape",
         "with model = \"rigid_body\" rocks have the shapes of their seeders; without one they are spheres",
         "Give shape = \"block\", \"equant\", \"flat\", \"long\" or that of a [[shape]] (docs/shapes.md)",
         Severity::warning);
}

void ShapeRules::check_shape(std::size_t i) const {
  const toml::table& row = *shapes[i];
  const Shape& shape = project.shapes[i];
  const auto refuse_key = [&](std::string_view key, std::string what, std::string why, std::string hint = "") {
    refuse(row, "shape", i, key, std::move(what), std::move(why), std::move(hint));
  };
  if (accepted(&row, "name") && (shape.name == sphere_word || built_in_shape(shape.name))) {
    refuse_key("name", fmt::format("name is \"{}\"", shape.name), "that word has a meaning of its own",
               "Choose another name");
  }
  const Table& declared = table("shape");
  const bool has_way =
      std::ranges::any_of(ways, [&](const char* key) { return row.contains(key) || is_mistyped(declared, row, key); });
  if (!has_way && !row.contains("c_over_b")) {
    refuse_key("b_over_a", "the form is missing",
               "expected one of b_over_a with c_over_b, axes_m, solid, sides, polygon, scan and of");
  }
  if (accepted(&row, "solid") && shape.solid == Solid::none)
    refuse_key("solid", "solid is \"none\"", "the rock has a form", "Name a solid, or leave it out");
  if (accepted(&row, "scan")) {
    if (const std::string why = why_unreadable(project, shape.scan); !why.empty()) {
      refuse_key("scan", fmt::format("scan is \"{}\"", shape.scan.string()), why,
                 "The path is relative to the project file");
    } else if (!is_of_kind(shape.scan, FileKind::mesh) && !is_of_kind(shape.scan, FileKind::point_text)) {
      refuse_key("scan", fmt::format("scan is \"{}\"", shape.scan.string()),
                 fmt::format("expected a mesh ({}) or points ({})", endings_in_words(FileKind::mesh),
                             endings_in_words(FileKind::point_text)));
    }
  }
  check_block(i);
  check_group(i);
  if (is_2d) check_in_section(i);
}

void ShapeRules::check_block(std::size_t i) const {
  const toml::table& row = *shapes[i];
  const Shape& shape = project.shapes[i];
  if (!is_2d && row.contains("b_over_a") && !row.contains("c_over_b") &&
      !is_mistyped(table("shape"), row, "c_over_b")) {
    refuse(row, "shape", i, "c_over_b", "c_over_b is missing", "a block has three axes",
           "Give the shortest axis over the intermediate one; 1 if they are equal");
  }
  if (accepted(&row, "axes_m")) {
    const std::size_t expected = is_2d ? 2 : 3;
    if (shape.axes_m->size() != expected) {
      refuse(row, "shape", i, "axes_m", fmt::format("axes_m has {} numbers", shape.axes_m->size()),
             fmt::format("expected {}", is_2d ? "two in 2D" : "three"));
    } else {
      const auto [least, most] = std::ranges::minmax(*shape.axes_m);
      const Range& ratio = setting("shape", "b_over_a").range;
      if (least < ratio.least * most) {
        refuse(row, "shape", i, "axes_m", fmt::format("the shortest axis is {:.2g} of the longest", least / most),
               fmt::format("expected at least {:g}", ratio.least), "Compare their units");
      }
    }
  }
  if (accepted(&row, "corners") && shape.style == ShapeStyle::box)
    refuse(row, "shape", i, "corners", "corners is given for a box", "a box has eight", "Leave it out");
  if (accepted(&row, "power") && (shape.style != ShapeStyle::rounded || !is_2d)) {
    refuse(row, "shape", i, "power",
           is_2d ? fmt::format("power is given for style = \"{}\"", word(shape.style)) : "power is given in 3D",
           "it belongs to a rounded block in 2D", "Leave it out");
  }
}

void ShapeRules::check_group(std::size_t i) const {
  const toml::table& row = *shapes[i];
  const Shape& shape = project.shapes[i];
  if (!accepted(&row, "of")) return;
  if (shape.of.empty()) refuse(row, "shape", i, "of", "of is empty", "a group has shapes");
  for (std::size_t k = 0; k < shape.of.size(); ++k) {
    const std::string& name = shape.of[k];
    const auto refuse_name = [&](std::string why, std::string hint = "") {
      refuse(row, "shape", i, "of", fmt::format("of[{}] is \"{}\"", k, name), std::move(why), std::move(hint));
    };
    if (name == sphere_word) continue;
    const Shape* const named = project.shape_named(name);
    if (!named) {
      refuse_name("no shape has this name", hint_for(name));
    } else if (!named->of.empty()) {
      refuse_name("it is a group itself", "Name its shapes");
    } else if (const std::string why = why_unusable(name); !why.empty()) {
      refuse_name(why);
    }
  }
  if (!accepted(&row, "shares")) return;
  if (shape.shares->size() != shape.of.size()) {
    refuse(row, "shape", i, "shares", fmt::format("shares has {} numbers", shape.shares->size()),
           fmt::format("of has {} shapes", shape.of.size()));
  } else if (std::ranges::all_of(*shape.shares, [](double share) { return share == 0; })) {
    refuse(row, "shape", i, "shares", "all shares are 0", "no shape could be drawn");
  }
}

void ShapeRules::check_in_section(std::size_t i) const {
  const toml::table& row = *shapes[i];
  for (const std::string_view key : {"c_over_b", "solid", "scan", "corners"}) {
    if (!accepted(&row, key)) continue;
    refuse(
        row, "shape", i, key, fmt::format("{} is given in 2D", key), "rocks in a section have a section as shape",
        key == "c_over_b" ? "b_over_a alone is the ratio of its two axes" : "Use sides, polygon, axes_m or b_over_a");
  }
  if (accepted(&row, "style") && project.shapes[i].style == ShapeStyle::angular)
    refuse(row, "shape", i, "style", "style is \"angular\" in 2D", "expected \"rounded\" or \"box\"",
           "Or use sides or polygon");
}

void ShapeRules::check_seeder(std::size_t i) const {
  const toml::table& row = *seeders[i];
  const Seeder& seeder = project.seeders[i];
  if (accepted(&row, "shape") && seeder.shape != sphere_word) {
    if (!project.shape_named(seeder.shape)) {
      refuse(row, "seeder", i, "shape", fmt::format("shape is \"{}\"", seeder.shape), "no shape has this name",
             hint_for(seeder.shape));
    } else if (const std::string why = why_unusable(seeder.shape); !why.empty()) {
      refuse(row, "seeder", i, "shape", fmt::format("shape is \"{}\"", seeder.shape), why,
             "Use a section: \"square\", \"hexagon\" or a [[shape]] with polygon, sides or b_over_a");
    }
  }
  if (!accepted(&row, "orientation_deg")) return;
  const std::size_t expected = is_2d ? 1 : 3;
  if (seeder.orientation_deg->size() != expected) {
    refuse(row, "seeder", i, "orientation_deg",
           fmt::format("orientation_deg has {} numbers", seeder.orientation_deg->size()),
           is_2d ? "expected one in 2D, the angle about y" : "expected three: about z, about y, about x");
  }
}

std::string ShapeRules::why_unusable(std::string_view shape) const {
  if (!is_2d) return "";
  const BuiltInShape* const built_in = built_in_shape(shape);
  return built_in && !built_in->is_for_sections ? "it is a solid, and a section has no room for one" : "";
}

std::string ShapeRules::hint_for(std::string_view mistyped) const {
  std::vector<std::string_view> known{sphere_word};
  for (const BuiltInShape& each : built_in_shapes()) known.push_back(each.shape.name);
  for (const Shape& each : project.shapes) known.push_back(each.name);
  const auto near = nearest(mistyped, known);
  return near ? fmt::format("Did you mean \"{}\"?", *near)
              : fmt::format("Add a [[shape]] of this name, or use one of {}", plain_list(known, " or "));
}

}  // namespace talus::project
