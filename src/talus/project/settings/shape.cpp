#include "talus/project/settings/conditions.hpp"
#include "talus/project/settings/limits.hpp"
#include "talus/project/settings/slots.hpp"
#include "talus/project/settings/tables.hpp"
#include "talus/project/settings/topics.hpp"

namespace talus::project::declared {
namespace {

std::function<Slot(Row)> outline_slot() {
  return [](const Row& row) -> Slot { return PlanPolygonSlot{&row.as<Shape>().polygon}; };
}

constexpr Range ratio{.least = 0.05,
                      .most = 1,
                      .too_low = "it would be a plate or a needle",
                      .too_high = "a is the longest axis, c the shortest"};

Need of_block() {
  return {.any_of = {given("b_over_a"), given("axes_m")},
          .otherwise = Otherwise::refused,
          .why = "it belongs to a block given by its ratios or axes"};
}

}  // namespace

Table shape_table() {
  constexpr std::string_view one_way =
      "one of `of`, `scan`, `polygon`, `sides`, `axes_m`, `b_over_a` and `solid` is required";
  return {
      .key = "shape",
      .repeated = true,
      .meaning = "A shape of rocks, for `shape` of a seeder; any number of entries. Rocks are convex.",
      .settings =
          {
              {.key = "name",
               .slot = member(&Shape::name),
               .required = true,
               .meaning = "Name, for seeders; must be unique, and none of the words that a seeder's `shape` has.",
               .source = "Talus"},
              {.key = "b_over_a",
               .slot = member(&Shape::b_over_a),
               .range = ratio,
               .without_it = one_way,
               .title = "b/a",
               .group = "Block",
               .meaning = "Intermediate axis over the longest, drawn for each rock; in 2D, the shorter axis over the "
                          "longer.",
               .source = "Zingg 1935"},
              {.key = "c_over_b",
               .slot = member(&Shape::c_over_b),
               .range = ratio,
               .without_it = "required with `b_over_a` in 3D",
               .applies_when = {together_with({given("b_over_a")})},
               .title = "c/b",
               .group = "Block",
               .meaning = "3D: shortest axis over the intermediate, drawn for each rock.",
               .source = "Zingg 1935"},
              {.key = "axes_m",
               .slot = member(&Shape::axes_m),
               .unit = "m",
               .range = {.least = least_diameter_m, .most = most_diameter_m, .too_low = "a rock has a size"},
               .without_it = one_way,
               .most_entries = 3,
               .title = "Axes",
               .group = "Block",
               .meaning = "The axes of a block, three in 3D and two in 2D, in any order. Only their ratios count: the "
                          "size is the seeder's.",
               .source = "Talus"},
              {.key = "style",
               .slot = member(&Shape::style),
               .applies_when = {of_block()},
               .always_accepted = {word(ShapeStyle::rounded)},
               .group = "Block",
               .meaning = "`rounded`: the hull of points near an ellipsoid, no two blocks alike (2D: an ellipse); "
                          "`angular`: of fewer points (3D); `box`: a box (2D: a rectangle).",
               .source = "Talus"},
              {.key = "corners",
               .slot = member(&Shape::corners),
               .range = between(6, 200),
               .without_it = "24, or 12 of an angular block; of a scan at most 48",
               .applies_when = {{.any_of = {given("b_over_a"), given("axes_m"), given("scan")},
                                 .otherwise = Otherwise::refused,
                                 .why = "it belongs to a block or a scan"}},
               .group = "Block",
               .meaning = "3D: number of corners of a rounded or angular block; most corners of a scan.",
               .source = "Talus"},
              {.key = "power",
               .slot = member(&Shape::power),
               .range = {.least = 1.5, .most = 20, .too_low = "it would have the corners of a rhombus"},
               .without_it = "2, an ellipse",
               .applies_when = {of_block()},
               .group = "Block",
               .meaning = "2D: the power p of a super-ellipse |x/a|^p + |z/b|^p = 1.",
               .source = "RocFall2: smooth shapes"},
              {.key = "solid",
               .slot = member(&Shape::solid),
               .group = "Other forms",
               .meaning = "3D: a regular solid, or a ball of 32 or 80 triangles.",
               .source = "RocFall3: rock shapes"},
              {.key = "sides",
               .slot = member(&Shape::sides),
               .range = between(3, 48),
               .without_it = one_way,
               .group = "Other forms",
               .meaning = "A regular polygon with so many sides; in 3D a prism over it.",
               .source = "RocFall3: extruded polygons"},
              {.key = "polygon",
               .slot = outline_slot(),
               .unit = "m",
               .without_it = one_way,
               .group = "Other forms",
               .meaning = "Three or more corners [x, z] of a section; in 3D a prism over it. The rock is their convex "
                          "hull, scaled to its volume.",
               .source = "RocFall2"},
              {.key = "length_ratio",
               .slot = member(&Shape::length_ratio),
               .range = between(0.05, 20),
               .without_it = "1",
               .applies_when = {{.any_of = {given("sides"), given("polygon")},
                                 .otherwise = Otherwise::refused,
                                 .why = "it is the length of a prism"},
                                in_3d(Otherwise::warned, "has no effect in 2D",
                                      "in a section the length of a prism plays no part")},
               .group = "Other forms",
               .meaning = "3D: length of the prism over the square root of the area of its section.",
               .source = "Talus"},
              {.key = "scan",
               .slot = member(&Shape::scan),
               .without_it = one_way,
               .group = "Other forms",
               .meaning = "3D: a file of a measured block: a mesh (OBJ, STL, PLY) or points (text), in any unit. The "
                          "rock is its convex hull, scaled to its volume. The path is relative to the project file.",
               .source = "Talus"},
              {.key = "of",
               .slot = member(&Shape::of),
               .without_it = one_way,
               .most_entries = 100,
               .title = "Shapes of the group",
               .group = "Group",
               .meaning = "Names of other shapes, one of which is drawn for each rock.",
               .source = "RocFall3: rock groups"},
              {.key = "shares",
               .slot = member(&Shape::shares),
               .range = up_to(most_factor, "a share is not negative"),
               .without_it = "equal",
               .most_entries = 100,
               .applies_when = {together_with({given("of")})},
               .group = "Group",
               .meaning = "Shares of the rocks, in the order of `of`; any positive numbers.",
               .source = "Talus"},
          },
      .choices = {{{"b_over_a", "c_over_b"}, {"axes_m"}, {"solid"}, {"sides"}, {"polygon"}, {"scan"}, {"of"}}},
      .groups = {{""}, {"Block"}, {"Other forms"}, {"Group"}},
      .topic = topics::shapes,
      .add = [](Project& project) { return added(project.shapes); },
      .rows = [](Project& project) { return all(project.shapes); },
  };
}

}  // namespace talus::project::declared
