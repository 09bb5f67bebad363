#include "talus/project/shape.hpp"

#include <algorithm>

#include "talus/project/project.hpp"

namespace talus::project {

namespace {

Distribution measured_ratio(double mean, double std_dev) {
  Distribution distribution = constant(mean);
  distribution.kind = DistributionKind::normal;
  distribution.std_dev = std_dev;
  return distribution;
}

BuiltInShape block(const char* word, Distribution b_over_a, Distribution c_over_b) {
  return {{.name = word, .b_over_a = std::move(b_over_a), .c_over_b = std::move(c_over_b)}, false};
}

BuiltInShape solid(const char* word, Solid kind) { return {{.name = word, .solid = kind}, false}; }

BuiltInShape regular(const char* word, std::int64_t sides) { return {{.name = word, .sides = sides}, true}; }

BuiltInShape rectangle(const char* word, double short_side, double long_side) {
  const double x = long_side / 2, z = short_side / 2;
  return {{.name = word, .polygon = {{-x, -z}, {x, -z}, {x, z}, {-x, z}}}, true};
}

}  // namespace

std::span<const BuiltInShape> built_in_shapes() {
  static const std::vector<BuiltInShape> list{
      block("equant", constant(0.9), constant(0.9)),
      block("flat", constant(0.95), constant(0.5)),
      block("long", constant(0.55), constant(0.9)),
      // As measured on 89 blocks of a limestone quarry.
      block("block", measured_ratio(0.78, 0.13), measured_ratio(0.82, 0.11)),
      solid("tetrahedron", Solid::tetrahedron),
      solid("cube", Solid::cube),
      solid("octahedron", Solid::octahedron),
      solid("dodecahedron", Solid::dodecahedron),
      solid("icosahedron", Solid::icosahedron),
      solid("icosphere_32", Solid::icosphere_32),
      solid("icosphere_80", Solid::icosphere_80),
      regular("triangle", 3),
      regular("square", 4),
      regular("pentagon", 5),
      regular("hexagon", 6),
      regular("octagon", 8),
      rectangle("rectangle_5_6", 5, 6),
      rectangle("rectangle_2_3", 2, 3),
      rectangle("rectangle_1_2", 1, 2),
  };
  return list;
}

const BuiltInShape* built_in_shape(std::string_view word) {
  const auto list = built_in_shapes();
  const auto found = std::ranges::find(list, word, [](const BuiltInShape& each) { return each.shape.name; });
  return found == list.end() ? nullptr : &*found;
}

const Shape* Project::shape_named(std::string_view shape) const {
  const auto found = std::ranges::find(shapes, shape, &Shape::name);
  if (found != shapes.end()) return &*found;
  const BuiltInShape* const built_in = built_in_shape(shape);
  return built_in == nullptr ? nullptr : &built_in->shape;
}

}  // namespace talus::project
