#include "talus/rocks/solid.hpp"

#include <algorithm>
#include <cmath>

#include "talus/core/principal_axes.hpp"

namespace talus {

SolidMoments moments_of(std::span<const Vec3> corners, std::span<const std::array<std::uint32_t, 3>> triangles) {
  SolidMoments sum;
  for (const auto& t : triangles) {
    const Vec3 &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]], all = a + b + c;
    const double six_volumes = a.dot(b.cross(c));
    sum.volume += six_volumes / 6;
    sum.first += six_volumes / 24 * all;
    sum.second =
        sum.second +
        six_volumes / 120 * (outer_product(a, a) + outer_product(b, b) + outer_product(c, c) + outer_product(all, all));
  }
  return sum;
}

double settle(RockShape& shape) {
  const Vec3 centre = moments_of(shape.corners, shape.triangles).centre();
  for (Vec3& corner : shape.corners) corner -= centre;
  const SolidMoments moments = moments_of(shape.corners, shape.triangles);
  const auto [spread, axes] = principal_axes(1 / moments.volume * moments.second);
  const double to_unit = 1 / std::cbrt(moments.volume);
  shape.reach = 0;
  for (Vec3& corner : shape.corners) {
    corner = to_unit * (axes * corner);
    shape.reach = std::max(shape.reach, corner.norm());
  }
  const Vec3 q = to_unit * to_unit * spread;
  shape.gyration = {q[1] + q[2], q[0] + q[2], q[0] + q[1]};
  shape.as_given = Orientation::of_matrix(axes.transposed());
  find_faces(shape.corners, shape.triangles, shape.hull);
  return moments.volume;
}

}  // namespace talus
