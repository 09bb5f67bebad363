#include "talus/seeding/seeder.hpp"

#include <algorithm>

namespace talus {

namespace {

/// The lines are divided into as many equal parts as there are rocks, one rock per part, in order: the line's number
/// never decreases with the rock's.
std::size_t line_of(const Seeder& seeder, const ReleaseLines& lines, const Draws& draws) {
  const double number = static_cast<double>(draws.rock() - seeder.first_rock);
  return lines.line_at((number + draws.pair(Stream::release_position)[1]) / static_cast<double>(seeder.rocks));
}

/// The first of a seeder's rocks, zero-based, for which is_there(rock) is true, as it is for all after it; the number
/// of rocks if there is none.
template <class IsThere>
std::uint64_t first_rock_where(const Seeder& seeder, IsThere&& is_there) {
  std::uint64_t first = 0, last = seeder.rocks;
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

std::vector<SourceRun> source_runs(const Seeder& seeder, std::uint64_t seed, SamplingMethod method) {
  std::vector<SourceRun> runs;
  const auto begins = [&](std::uint64_t first, SourceId source) {
    if (!runs.empty()) runs.back().rocks = first - (runs.back().first_rock - seeder.first_rock);
    if (!runs.empty() && runs.back().rocks == 0) runs.pop_back();
    if (runs.empty() || runs.back().source != source) runs.push_back({seeder.first_rock + first, 0, source});
  };
  if (const auto* lines = std::get_if<ReleaseLines>(&*seeder.where); lines != nullptr && lines->count() > 1) {
    const SamplingPlan plan{seed, method, seeder.first_rock, seeder.rocks};
    for (std::size_t line = 0; line < lines->count(); ++line) {
      begins(first_rock_where(
                 seeder,
                 [&](std::uint64_t k) { return line_of(seeder, *lines, Draws(plan, seeder.first_rock + k)) >= line; }),
             lines->source_of(line));
    }
  } else if (const auto* cells = std::get_if<ReleaseCells>(&*seeder.where)) {
    for (const ReleaseCells::Run& run : cells->sources) {
      begins(first_rock_where(seeder, [&](std::uint64_t k) { return cells->entry_of(k, seeder.rocks) >= run.first; }),
             run.source);
    }
  } else if (const auto* table = std::get_if<ReleaseTable>(&*seeder.where)) {
    for (const ReleaseTable::Run& run : table->sources()) {
      begins(first_rock_where(seeder, [&](std::uint64_t k) { return table->row_of(k, seeder.rocks) >= run.first; }),
             run.source);
    }
  } else {
    begins(0, lines != nullptr ? lines->source_of(0) : seeder.source);
  }
  if (!runs.empty()) runs.back().rocks = seeder.rocks - (runs.back().first_rock - seeder.first_rock);
  if (!runs.empty() && runs.back().rocks == 0) runs.pop_back();
  return runs;
}

ReleasePlace place_of(const Seeder& seeder, const Draws& draws) {
  if (const auto* lines = std::get_if<ReleaseLines>(&*seeder.where)) {
    const double u = draws.one(Stream::release_position);
    const ReleaseLines::Place place = lines->count() > 1 ? lines->at(line_of(seeder, *lines, draws), u) : lines->at(u);
    return {.point = place.point, .source = place.source, .above_surface = seeder.above_surface};
  }
  if (const auto* cells = std::get_if<ReleaseCells>(&*seeder.where)) {
    const std::size_t entry = cells->entry_of(draws.rock() - seeder.first_rock, seeder.rocks);
    const Vec2 middle = cells->centre_of(entry);
    const Vec2 place =
        cells->place == PlaceInCell::centre ? middle : cells->at(entry, draws.pair(Stream::release_position));
    return {.point = Vec3(place.x(), place.y(), 0),
            .source = cells->source_of(entry),
            .middle = middle,
            .above_surface = seeder.above_surface};
  }
  if (const auto* table = std::get_if<ReleaseTable>(&*seeder.where)) {
    const std::size_t row = table->row_of(draws.rock() - seeder.first_rock, seeder.rocks);
    ReleasePlace place{.point = table->place(row), .source = table->source_of(row), .given = table->given(row)};
    if (ReleaseRow::has(place.given.above_surface)) place.above_surface = place.given.above_surface;
    return place;
  }
  return {.point = std::get<Vec3>(*seeder.where), .source = seeder.source, .above_surface = seeder.above_surface};
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
  const bool moves_on_plan = has_velocity && given.velocity.head<2>().norm() > 0;
  const Vec3& forwards = moves_on_plan ? given.velocity : direction;
  const Vec3 plan = Vec3(forwards.x(), forwards.y(), 0);
  const Vec3 heading = plan.norm() > 0 ? Vec3(plan.normalized()) : Vec3(Vec3::UnitX());
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
        given_or_drawn(given.vertical, seeder.vertical, draws, Stream::vertical_velocity) * Vec3::UnitZ();
  }
  release.motion.spin =
      ReleaseRow::has(given.spin_vector)
          ? given.spin_vector
          : Vec3(given_or_drawn(given.spin, seeder.spin, draws, Stream::spin) * Vec3::UnitZ().cross(heading));
  return release;
}

}  // namespace talus
