#include "talus/model/build_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "talus/core/degrees.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/model/drawn.hpp"
#include "talus/model/scanned_block.hpp"

namespace talus::project {

namespace {

constexpr int corners_of_rounded = 24, corners_of_angular = 12;

/// The axes of a block, descending.
std::vector<double> sorted_axes(const Shape& shape) {
  std::vector<double> axes = *shape.axes_m;
  std::ranges::sort(axes, std::greater{});
  return axes;
}

Distribution b_over_a_of(const Shape& shape) {
  if (!shape.axes_m) return *shape.b_over_a;
  const std::vector<double> axes = sorted_axes(shape);
  return constant(axes[1] / axes[0]);
}

Distribution c_over_b_of(const Shape& shape) {
  if (!shape.axes_m) return *shape.c_over_b;
  const std::vector<double> axes = sorted_axes(shape);
  return constant(axes[2] / axes[1]);
}

RockShape solid_shape(Solid solid) {
  switch (solid) {
    case Solid::tetrahedron:
      return regular_shape(RegularSolid::tetrahedron);
    case Solid::octahedron:
      return regular_shape(RegularSolid::octahedron);
    case Solid::dodecahedron:
      return regular_shape(RegularSolid::dodecahedron);
    case Solid::icosahedron:
      return regular_shape(RegularSolid::icosahedron);
    case Solid::icosphere_32:
      return icosphere_shape(RegularSolid::octahedron);
    case Solid::icosphere_80:
      return icosphere_shape(RegularSolid::icosahedron);
    case Solid::none:
    case Solid::cube:
      break;
  }
  return regular_shape(RegularSolid::cube);
}

std::vector<Vec2> outline_of(const Shape& shape) {
  if (shape.sides) return regular_outline(static_cast<int>(*shape.sides));
  std::vector<Vec2> outline;
  for (const auto& [x, z] : shape.polygon) outline.push_back({x, z});
  return outline;
}

/// Sections whose ratio is random are a list of so many quantiles.
constexpr int section_quantiles = 64;

std::vector<RockShape> sections_of_ratio(const Shape& shape) {
  std::vector<RockShape> sections;
  const Sampler ratio = sampler_of("b_over_a", b_over_a_of(shape));
  const int count = ratio.is_constant() ? 1 : section_quantiles;
  for (int k = 0; k < count; ++k) {
    const double b_over_a = ratio.draw((k + 0.5) / count);
    sections.push_back(section_shape(shape.style == ShapeStyle::box
                                         ? rectangle_outline(b_over_a)
                                         : superellipse_outline(b_over_a, shape.power.value_or(2))));
  }
  return sections;
}

AxisRatios ratios_of(const Shape& shape) {
  return {sampler_of("b_over_a", b_over_a_of(shape)), sampler_of("c_over_b", c_over_b_of(shape))};
}

RockKind block_kind(const Shape& shape) {
  const bool is_angular = shape.style == ShapeStyle::angular;
  const auto corners = shape.corners.value_or(is_angular ? corners_of_angular : corners_of_rounded);
  RockKind kind;
  kind.stretch = ratios_of(shape);
  kind.hulls = shape.style == ShapeStyle::box ? std::vector{regular_shape(RegularSolid::cube)}
                                              : irregular_balls(static_cast<int>(corners));
  return kind;
}

/// A shape, or one of a group; null for a sphere.
struct ShapePart {
  const Shape* shape;
  double share;  // of the rocks
};

/// None if all rocks are spheres.
std::vector<ShapePart> parts_of_shape(const Project& project, const std::string& name) {
  const Shape* const shape = project.shape_named(name);
  if (shape == nullptr) return {};
  if (shape->of.empty()) return {{shape, 1}};
  const std::vector<double> equal(shape->of.size(), 1), shares = shape->shares.value_or(equal);
  const double all = std::accumulate(shares.begin(), shares.end(), 0.0);
  std::vector<ShapePart> parts;
  for (std::size_t k = 0; k < shape->of.size(); ++k) {
    if (shares[k] / all > 0) parts.push_back({project.shape_named(shape->of[k]), shares[k] / all});
  }
  return parts;
}

class ShapeBuilder {
 public:
  ShapeBuilder(const Project& project, std::string& report, Problems& warnings)
      : project_(project), report_(report), warnings_(warnings) {}

  [[nodiscard]] RockShapes build(const std::string& name) {
    RockShapes shapes;
    for (const auto& [shape, share] : parts_of_shape(project_, name)) {
      RockKind kind = shape == nullptr ? RockKind{} : kind_of(*shape);
      kind.share = share;
      shapes.kinds.push_back(std::move(kind));
    }
    return shapes;
  }

 private:
  [[nodiscard]] RockKind kind_of(const Shape& shape) {
    try {
      if (shape.has_ratios() && !project_.is_2d()) return block_kind(shape);
      RockKind kind;
      if (shape.has_ratios()) {
        kind.hulls = sections_of_ratio(shape);
      } else if (project_.is_2d()) {
        kind.hulls.push_back(section_shape(outline_of(shape)));
      } else if (!shape.scan.empty()) {
        kind.hulls.push_back(scanned_block(project_, shape, report_, warnings_));
      } else if (shape.solid != Solid::none) {
        kind.hulls.push_back(solid_shape(shape.solid));
      } else {
        kind.hulls.push_back(prism_shape(outline_of(shape), shape.length_ratio.value_or(1)));
      }
      return kind;
    } catch (const BadInput& bad) {
      Problems located;
      for (Problem problem : bad.problems().list()) {
        if (problem.file.empty()) problem.file = project_.file.string();
        if (problem.line == 0 && problem.file == project_.file.string()) problem.line = shape.line;
        if (problem.where.empty()) problem.where = fmt::format("shape \"{}\"", shape.name);
        located.add(std::move(problem));
      }
      throw BadInput(std::move(located));
    }
  }

  const Project& project_;
  std::string& report_;
  Problems& warnings_;
};

}  // namespace

RockShapes build_shapes(const Project& project, const std::string& name, std::string& report, Problems& warnings) {
  return ShapeBuilder(project, report, warnings).build(name);
}

RockShapes with_ratios(const Project& project, const std::string& name, RockShapes shapes) {
  const std::vector<ShapePart> parts = parts_of_shape(project, name);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Shape* const shape = parts[k].shape;
    if (shape == nullptr || !shape->has_ratios()) continue;
    RockKind& kind = shapes.kinds[k];
    if (project.is_2d()) {
      kind.hulls = sections_of_ratio(*shape);
    } else {
      kind.stretch = ratios_of(*shape);
    }
  }
  return shapes;
}

ReleaseTurn release_turn(const Project& project, const Seeder& seeder) {
  const auto& deg = seeder.orientation_deg;
  const auto about = [](const Vec3& axis, double angle) { return Orientation::of_turn(angle * radians * axis); };
  if (project.is_2d()) {
    if (!deg) return {InitialTurn::in_section, {}};
    return {InitialTurn::given, about(unit_y, (*deg)[0])};
  }
  if (!deg) return {};
  return {InitialTurn::given, about(unit_z, (*deg)[0]) * about(unit_y, (*deg)[1]) * about(unit_x, (*deg)[2])};
}

}  // namespace talus::project
