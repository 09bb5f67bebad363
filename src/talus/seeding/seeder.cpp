#include "talus/seeding/seeder.hpp"

namespace talus {

ReleasePlace place_of(const Seeder& seeder, const Draws& draws) {
  if (const auto* lines = std::get_if<ReleaseLines>(&seeder.where)) {
    const ReleaseLines::Place place = lines->at(draws.one(Stream::release_position));
    return {place.point, place.source, {}};
  }
  if (const auto* cells = std::get_if<ReleaseCells>(&seeder.where)) {
    const std::size_t entry = cells->entry_of(draws.rock() - seeder.first_rock, seeder.rocks);
    const Vec2 middle = cells->centre_of(entry);
    const Vec2 place =
        cells->place == PlaceInCell::centre ? middle : cells->at(entry, draws.pair(Stream::release_position));
    return {Vec3(place.x(), place.y(), 0), cells->source_of(entry), middle};
  }
  return {std::get<Vec3>(seeder.where), seeder.source, {}};
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
