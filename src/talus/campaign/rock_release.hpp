#pragma once
// The release of one rock of a model, by its number.

#include <algorithm>
#include <iterator>

#include "talus/campaign/model.hpp"
#include "talus/results/record.hpp"
#include "talus/seeding/fall_line.hpp"
#include "talus/seeding/lift.hpp"
#include "talus/seeding/release.hpp"

namespace talus {

/// A rock's release; fills in what the record contains before the rock moves. `own`: as for give_shape().
template <class Surface>
Release release_of(const Model& model, const Surface& surface, const Draws& draws, const Seeder& seeder,
                   RockRecord& record, RockShape& own) {
  const ReleasePlace start =
      place_of(seeder, {model.seed, model.sampling, seeder.first_rock, seeder.rocks}, draws.rock());
  record.seeder = SeederId{static_cast<std::uint32_t>(&seeder - model.seeders.data())};
  record.source = start.source;
  Vec3 place = start.point;
  if (start.above_surface) {
    auto z = surface.elevation(place.x(), place.y());
    if (!z && start.middle) {
      place = Vec3(*start.middle, place.z());
      z = surface.elevation(place.x(), place.y());
    }
    place.z() = z.value_or(place.z()) + *start.above_surface;
  }
  const Vec3 direction = ReleaseRow::has(start.given.direction) ? start.given.direction
                         : seeder.direction                     ? *seeder.direction
                                                                : fall_line(surface, place);
  Release release = release_at(seeder, place, direction, draws, start.given);
  if (has_extent(model.laws.model)) give_shape(release, seeder, draws, start.given, own);
  ClearPlace clear;
  if (release.shape != nullptr) {
    const Body body = body_of(*release.shape, release.rock);
    record.block = BlockRecord{axes_of(body), body.inertia};
    clear = clear_place(surface, place, body, release.orientation);
  } else {
    clear = clear_place(surface, place, reach_of(model.laws.model, release.rock));
  }
  if (clear.fit != Fit::as_given) {
    release.motion.position.z() = clear.z;
    // A sphere placed at a height above the surface is meant to touch it when lifted: no cause for a warning.
    record.was_lifted = !start.above_surface;
  }
  if (clear.fit == Fit::no_room) {
    release.has_room = false;
    release.motion.velocity = {};
    release.motion.spin = {};
  }
  record.body = release.rock;
  return release;
}

inline const Seeder& seeder_of(const Model& model, std::uint64_t rock) {
  const auto after = std::upper_bound(model.seeders.begin(), model.seeders.end(), rock,
                                      [](std::uint64_t r, const Seeder& s) { return r < s.first_rock; });
  return *std::prev(after);
}

}  // namespace talus
