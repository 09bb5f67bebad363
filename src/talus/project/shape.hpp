#pragma once
// [[shape]] of a project, and the shapes that a seeder can name without one.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/sampling/distribution.hpp"

namespace talus::project {

enum class ShapeStyle { rounded, angular, box };

enum class Solid { none, tetrahedron, cube, octahedron, dodecahedron, icosahedron, icosphere_32, icosphere_80 };

/// One of: `of`, a scan, a polygon, sides, axes, ratios, a solid.
struct Shape {
  std::string name;
  std::optional<std::vector<double>> axes_m{};         // a, b, c in any order; only their ratios count
  std::optional<Distribution> b_over_a{}, c_over_b{};  // in 2D the first alone
  ShapeStyle style = ShapeStyle::rounded;
  std::optional<std::int64_t> corners{};  // of rounded and angular blocks
  std::optional<double> power{};          // of a super-ellipse in 2D
  Solid solid = Solid::none;
  std::optional<std::int64_t> sides{};          // of a regular polygon
  std::vector<std::array<double, 2>> polygon;   // x, z; the rock is its hull
  std::optional<double> length_ratio{};         // of a prism in 3D: length over the square root of the area
  std::filesystem::path scan;                   // as written in the file, relative to the project file
  std::vector<std::string> of;                  // names of other shapes
  std::optional<std::vector<double>> shares{};  // of the rocks, in the order of `of`; nullopt: equal
  int line = 0;                                 // in the project file, for later messages

  [[nodiscard]] bool has_ratios() const { return b_over_a || c_over_b || axes_m; }
};

/// The word for rocks without a shape of their own.
inline constexpr std::string_view sphere_word = "sphere";

/// A shape that needs no table; docs/shapes.md says what each is.
struct BuiltInShape {
  Shape shape;           // with its word as its name
  bool is_for_sections;  // also in 2D
};

/// All but the sphere.
[[nodiscard]] std::span<const BuiltInShape> built_in_shapes();
[[nodiscard]] const BuiltInShape* built_in_shape(std::string_view word);

}  // namespace talus::project
