#include "talus/campaign/simulate.hpp"

#include <algorithm>

#include "talus/seeding/lift.hpp"

namespace talus {

Simulator::Simulator(const Model& model) : model_(model) {
  if (model.varying) {
    own_vertices_ = model.varying->vertices;
    own_profile_.emplace(own_vertices_);
  }
}

RockRecord Simulator::simulate(std::uint64_t rock, bool keep_rows, bool keep_pieces) {
  log_.keep_rows(keep_rows);
  log_.keep_pieces(keep_pieces);
  if (own_profile_) {
    const VaryingSection& section = *model_.varying;
    const SamplingPlan plan{model_.seed, model_.sampling, 0, model_.rocks()};
    const Draws draws(plan, rock);
    for (std::uint32_t k = 0; k < own_vertices_.size(); ++k) {
      const auto u = draws.pair(Stream::slope_vertex, k);
      own_vertices_[k] = section.vertices[k] + Vec2(section.shifts[k][0].draw(u[0]), section.shifts[k][1].draw(u[1]));
    }
    own_profile_->move_vertices(own_vertices_);
    return simulate_on(*own_profile_, rock);
  }
  return std::visit([&](const auto& surface) { return simulate_on(surface, rock); }, model_.surface);
}

template <class Surface>
RockRecord Simulator::simulate_on(const Surface& surface, std::uint64_t rock) {
  const auto after = std::upper_bound(model_.seeders.begin(), model_.seeders.end(), rock,
                                      [](std::uint64_t r, const Seeder& s) { return r < s.first_rock; });
  const Seeder& seeder = *std::prev(after);
  const Draws draws({model_.seed, model_.sampling, seeder.first_rock, seeder.rocks}, rock);

  RockRecord record;
  record.rock = rock;
  record.seeder = SeederId{static_cast<std::uint32_t>(&seeder - model_.seeders.data())};
  const ReleasePlace start = place_of(seeder, draws);
  record.source = start.source;
  Vec3 place = start.point;
  if (seeder.above_surface) {
    auto z = surface.elevation(place.x(), place.y());
    if (!z && start.middle) {
      place.head(2) = *start.middle;
      z = surface.elevation(place.x(), place.y());
    }
    place.z() = z.value_or(place.z()) + *seeder.above_surface;
  }
  Release release = release_at(seeder, place, draws);
  const double reach = model_.laws.model == RockModel::rigid_sphere ? release.rock.radius : 0;
  if (const auto z = lifted(surface, place, reach)) {
    release.motion.position.z() = *z;
    // A sphere put on the surface by its z or by its height above it is meant to touch it: no cause for a warning.
    record.was_lifted = !seeder.above_surface;
  }
  record.body = release.rock;
  record.outcome =
      follow_rock(Scene<Surface>{surface, model_.ground, model_.barriers, model_.laws}, release, draws, log_);
  return record;
}

}  // namespace talus
