#include "talus/campaign/release_survey.hpp"

#include "talus/campaign/rock_release.hpp"

namespace talus {

ReleaseSurvey survey_releases(const Model& model, std::uint64_t most) {
  const std::uint64_t all = model.rocks();
  ReleaseSurvey found{.rocks = std::min(all, most)};
  found.diameters.resize(model.seeders.size());
  std::visit(
      [&](const auto& surface) {
        for (std::uint64_t k = 0; k < found.rocks; ++k) {
          const auto share = static_cast<long double>(k) / static_cast<long double>(found.rocks);
          const auto rock = static_cast<std::uint64_t>(share * static_cast<long double>(all));
          const Seeder& seeder = seeder_of(model, rock);
          const Draws draws({model.seed, model.sampling, seeder.first_rock, seeder.rocks}, rock);
          RockRecord record;
          RockShape shape;
          const Vec3 place = release_of(model, surface, draws, seeder, record, shape).motion.position;
          found.diameters[record.seeder.index].push_back(2 * record.body.radius);
          if (record.was_lifted) found.in_ground.push_back(rock);
          const auto ground = surface.elevation(place.x(), place.y(), place.z());
          if (!ground || place.z() - *ground <= found.highest_m) continue;
          found.highest_m = place.z() - *ground;
          found.highest = rock;
        }
      },
      *model.surface);
  return found;
}

}  // namespace talus
