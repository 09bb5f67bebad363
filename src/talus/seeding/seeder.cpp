#include "talus/seeding/seeder.hpp"

#include <array>

namespace talus {

namespace {

/// A purpose of its own (core/random.hpp); the numbers of rocks are those of seeders' first rocks.
constexpr auto order_stream = static_cast<Stream>(100);

/// Two uniform numbers of all rocks of a seeder: for the first place, and for the lines of parts that contain several.
std::array<double, 2> draws_of_seeder(const Seeder& seeder, std::uint64_t seed) {
  return uniform_pair(seed, seeder.first_rock, order_stream, 0);
}

/// The first of so many places for which is_there(place) is true, as it is for all after it; their number if there is
/// none.
template <class IsThere>
std::uint64_t first_place_where(std::uint64_t places, IsThere&& is_there) {
  std::uint64_t first = 0, last = places;
  while (first < last) {
    const std::uint64_t middle = first + (last - first) / 2;
    if (is_there(middle)) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

}  // namespace

std::uint64_t count_places(const Seeder& seeder) {
  if (const auto* cells = std::get_if<ReleaseCells>(&*seeder.where)) return cells->cells.size();
  if (const auto* table = std::get_if<ReleaseTable>(&*seeder.where)) return table->count();
  if (std::holds_alternative<ReleaseLines>(*seeder.where))
    return ReleaseOrder{.rocks = seeder.rocks, .rocks_at_once = seeder.rocks_at_once}.turns();
  return 1;
}

ReleaseOrder release_order(const Seeder& seeder, std::uint64_t seed) {
  ReleaseOrder order{.first_rock = seeder.first_rock,
                     .rocks = seeder.rocks,
                     .rocks_at_once = seeder.rocks_at_once,
                     .places = count_places(seeder),
                     .step = seeder.step};
  order.start = static_cast<std::uint64_t>(draws_of_seeder(seeder, seed)[0] * static_cast<double>(order.places));
  return order;
}

std::vector<SourceRun> source_runs(const Seeder& seeder, std::uint64_t seed) {
  std::vector<SourceRun> runs;
  if (const auto* lines = std::get_if<ReleaseLines>(&*seeder.where)) {
    const std::uint64_t parts = count_places(seeder);
    const double v = draws_of_seeder(seeder, seed)[1];
    for (std::size_t line = 0; line < lines->count(); ++line) {
      const std::uint64_t first =
          first_place_where(parts, [&](std::uint64_t part) { return lines->line_of(part, parts, v) >= line; });
      if (first == parts) break;
      if (!runs.empty() && runs.back().first_place == first) runs.pop_back();  // of a line without a part
      if (runs.empty() || runs.back().source != lines->source_of(line)) runs.push_back({first, lines->source_of(line)});
    }
  } else if (const auto* cells = std::get_if<ReleaseCells>(&*seeder.where)) {
    for (const ReleaseCells::Run& run : cells->sources) runs.push_back({run.first, run.source});
  } else if (const auto* table = std::get_if<ReleaseTable>(&*seeder.where)) {
    for (const ReleaseTable::Run& run : table->sources()) runs.push_back({run.first, run.source});
  } else {
    runs.push_back({0, seeder.source});
  }
  return runs;
}

ReleasePlace place_of(const Seeder& seeder, const SamplingPlan& plan, std::uint64_t rock) {
  if (const auto* point = std::get_if<Vec3>(&*seeder.where))
    return {.point = *point, .source = seeder.source, .above_surface = seeder.above_surface};
  const ReleaseOrder order = release_order(seeder, plan.seed);
  const std::uint64_t turn = order.turn_of(rock), entry = order.place_of_turn(turn);
  // Draws of the turn, which are the same for its rocks.
  const auto u =
      Draws({plan.seed, plan.method, plan.first, order.turns()}, plan.first + turn).pair(Stream::release_position);
  if (const auto* lines = std::get_if<ReleaseLines>(&*seeder.where)) {
    const ReleaseLines::Place place = lines->in_part(entry, order.places, draws_of_seeder(seeder, plan.seed)[1], u[0]);
    return {.point = place.point, .source = place.source, .above_surface = seeder.above_surface};
  }
  if (const auto* cells = std::get_if<ReleaseCells>(&*seeder.where)) {
    const Vec2 middle = cells->centre_of(entry);
    const Vec2 place = cells->place == PlaceInCell::centre ? middle : cells->at(entry, u);
    return {.point = Vec3(place.x(), place.y(), 0),
            .source = cells->source_of(entry),
            .middle = middle,
            .above_surface = seeder.above_surface};
  }
  const auto& table = std::get<ReleaseTable>(*seeder.where);
  const std::size_t row = table.row_at(entry);
  ReleasePlace place{.point = table.place(row), .source = table.source_of(row), .given = table.given(row)};
  if (ReleaseRow::has(place.given.above_surface)) place.above_surface = place.given.above_surface;
  return place;
}

static double drawn(const Sampler& sampler, const Draws& draws, Stream stream) {
  return sampler.is_constant() ? sampler.draw(0.5) : sampler.draw(draws.one(stream));
}

/// The value of a row, or a draw if the row has none.
static double given_or_drawn(double given, const Sampler& sampler, const Draws& draws, Stream stream) {
  return ReleaseRow::has(given) ? given : drawn(sampler, draws, stream);
}

static Rock rock_of(const Seeder& seeder, const Draws& draws, const ReleaseRow& given) {
  const double density = given_or_drawn(given.density, seeder.density, draws, Stream::density);
  if (ReleaseRow::has(given.mass)) return sphere_of_mass(given.mass, density);
  if (ReleaseRow::has(given.volume)) return sphere_of_mass(given.volume * density, density);
  const double size = drawn(seeder.size, draws, Stream::size);
  switch (seeder.size_of) {
    case SizeOf::mass:
      return sphere_of_mass(size, density);
    case SizeOf::volume:
      return sphere_of_mass(size * density, density);
    case SizeOf::diameter:
      break;
  }
  return sphere_of_diameter(size, density);
}

Release release_at(const Seeder& seeder, const Vec3& place, const Vec3& direction, const Draws& draws,
                   const ReleaseRow& given) {
  Release release;
  release.rock = rock_of(seeder, draws, given);
  const bool has_velocity = ReleaseRow::has(given.velocity);
  const bool has_parts = ReleaseRow::has(given.horizontal) || ReleaseRow::has(given.vertical);
  const bool moves_on_plan = has_velocity && given.velocity.xy().norm() > 0;
  const Vec3& forwards = moves_on_plan ? given.velocity : direction;
  const Vec3 plan = Vec3(forwards.x(), forwards.y(), 0);
  const Vec3 heading = plan.norm() > 0 ? plan.normalized() : unit_x;
  release.motion.position = place;
  if (has_velocity) {
    release.motion.velocity = given.velocity;
  } else if (ReleaseRow::has(given.speed) || (seeder.speed && !has_parts)) {
    const double speed =
        ReleaseRow::has(given.speed) ? given.speed : drawn(*seeder.speed, draws, Stream::horizontal_velocity);
    release.motion.velocity = speed * direction;
  } else {
    release.motion.velocity =
        given_or_drawn(given.horizontal, seeder.horizontal, draws, Stream::horizontal_velocity) * heading +
        given_or_drawn(given.vertical, seeder.vertical, draws, Stream::vertical_velocity) * unit_z;
  }
  release.motion.spin = ReleaseRow::has(given.spin_vector)
                            ? given.spin_vector
                            : given_or_drawn(given.spin, seeder.spin, draws, Stream::spin) * unit_z.cross(heading);
  return release;
}

void give_shape(Release& release, const Seeder& seeder, const Draws& draws, const ReleaseRow& given, RockShape& own) {
  const std::optional<Vec3> axes = ReleaseRow::has(given.axes) ? std::optional(given.axes) : std::nullopt;
  release.shape = seeder.shapes->draw(draws, axes, own);
  if (release.shape != nullptr) release.orientation = seeder.turn.draw(draws, *release.shape);
}

}  // namespace talus
