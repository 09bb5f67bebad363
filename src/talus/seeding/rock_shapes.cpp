#include "talus/seeding/rock_shapes.hpp"

#include <algorithm>
#include <numbers>

#include "talus/rocks/solid.hpp"

namespace talus {

namespace {

/// A ball that is stretched along its axes.
void stretch(const RockShape& ball, const Vec3& axes, RockShape& into) {
  into.corners.clear();
  for (const Vec3& corner : ball.corners) into.corners.push_back(axes.times(corner));
  into.triangles = ball.triangles;
  (void)settle(into);
}

}  // namespace

const RockShape* RockShapes::draw(const Draws& draws, const std::optional<Vec3>& axes, RockShape& own) const {
  if (kinds.empty()) return nullptr;
  const auto [which, hull] = draws.pair(Stream::shape, 0);
  const RockKind* kind = &kinds.front();
  for (double up_to = kind->share; which > up_to && kind != &kinds.back(); up_to += kind->share) ++kind;
  if (kind->hulls.empty()) return nullptr;
  const auto count = kind->hulls.size();
  const auto place = std::min(static_cast<std::size_t>(hull * static_cast<double>(count)), count - 1);
  const RockShape& drawn = kind->hulls[place];
  if (!kind->stretch) return &drawn;
  if (axes) {
    stretch(drawn, *axes, own);
  } else {
    const auto [u, v] = draws.pair(Stream::shape, 1);
    const double b = kind->stretch->b_over_a.draw(u), c = b * kind->stretch->c_over_b.draw(v);
    stretch(drawn, {1, b, c}, own);
  }
  return &own;
}

Orientation ReleaseTurn::draw(const Draws& draws, const RockShape& shape) const {
  if (kind == InitialTurn::given) return given * shape.as_given;
  const auto [u, v] = draws.pair(Stream::orientation, 0);
  if (kind == InitialTurn::in_section) return Orientation::of_turn(2 * std::numbers::pi * u * unit_y);
  return Orientation::uniform(u, v, draws.pair(Stream::orientation, 1)[0]);
}

}  // namespace talus
