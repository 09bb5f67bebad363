#include "talus/seeding/seeder.hpp"

namespace talus {

Vec3 place_on(const Seeder& seeder, double u) {
  const auto& points = seeder.points;
  double length = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) length += (points[k + 1] - points[k]).norm();
  double left = u * length;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double piece = (points[k + 1] - points[k]).norm();
    if (left <= piece && piece > 0) return points[k] + left / piece * (points[k + 1] - points[k]);
    left -= piece;
  }
  return points.back();
}

static double drawn(const Sampler& sampler, const Draws& draws, Stream stream) {
  return sampler.is_constant() ? sampler.draw(0.5) : sampler.draw(draws.one(stream));
}

Release release_at(const Seeder& seeder, const Vec3& place, const Draws& draws) {
  const double density = drawn(seeder.density, draws, Stream::density);
  const double size = drawn(seeder.size, draws, Stream::size);
  Release release;
  switch (seeder.size_of) {
    case SizeOf::mass:
      release.rock = sphere_of_mass(size, density);
      break;
    case SizeOf::volume:
      release.rock = sphere_of_mass(size * density, density);
      break;
    case SizeOf::diameter:
      release.rock = sphere_of_diameter(size, density);
      break;
  }
  const Vec3 plan = Vec3(seeder.direction.x(), seeder.direction.y(), 0);
  const Vec3 heading = plan.norm() > 0 ? Vec3(plan.normalized()) : Vec3(Vec3::UnitX());
  release.motion.position = place;
  if (seeder.speed) {
    release.motion.velocity = drawn(*seeder.speed, draws, Stream::horizontal_velocity) * seeder.direction;
  } else {
    release.motion.velocity = drawn(seeder.horizontal, draws, Stream::horizontal_velocity) * heading +
                              drawn(seeder.vertical, draws, Stream::vertical_velocity) * Vec3::UnitZ();
  }
  release.motion.spin = drawn(seeder.spin, draws, Stream::spin) * Vec3::UnitZ().cross(heading);
  return release;
}

}  // namespace talus
