#include "talus/meshing/extrude.hpp"

#include <cmath>
#include <numbers>

namespace talus {

RawMesh extruded(std::span<const Vec2> section, double width) {
  RawMesh mesh;
  for (const Vec2& v : section) {
    mesh.vertices.emplace_back(v.x(), 0, v.y());
    mesh.vertices.emplace_back(v.x(), width, v.y());
  }
  for (std::uint32_t k = 0; k + 1 < section.size(); ++k) {
    const std::uint32_t a = 2 * k;  // near left; + 1: far left, + 2: near right, + 3: far right
    mesh.triangles.push_back({a, a + 2, a + 3});
    mesh.triangles.push_back({a, a + 3, a + 1});
  }
  return mesh;
}

void turn(RawMesh& mesh, double degrees, const Vec3& about) {
  const double angle = std::remainder(degrees, 360.0);
  if (angle == 0) return;
  double cosine = std::cos(angle * std::numbers::pi / 180), sine = std::sin(angle * std::numbers::pi / 180);
  if (std::fmod(angle, 90.0) == 0) {
    cosine = std::round(cosine);
    sine = std::round(sine);
  }
  for (Vec3& v : mesh.vertices) v = about + turned(v - about, cosine, sine);
}

}  // namespace talus
