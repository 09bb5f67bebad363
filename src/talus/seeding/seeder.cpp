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
  if (const auto* lines = std::get_if<ReleaseLines>(&seeder.where); lines != nullptr && lines->count() > 1) {
    const SamplingPlan plan{seed, method, seeder.first_rock, seeder.rocks};
    for (std::size_t line = 0; line < lines->count(); ++line) {
      begins(first_rock_where(
                 seeder,
                 [&](std::uint64_t k) { return line_of(seeder, *lines, Draws(plan, seeder.first_rock + k)) >= line; }),
             lines->source_of(line));
    }
  } else if (const auto* cells = std::get_if<ReleaseCells>(&seeder.where)) {
    for (const ReleaseCells::Run& run : cells->sources) {
      begins(first_rock_where(seeder, [&](std::uint64_t k) { return cells->entry_of(k, seeder.rocks) >= run.first; }),
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
  if (const auto* lines = std::get_if<ReleaseLines>(&seeder.where)) {
    const double u = draws.one(Stream::release_position);
    const ReleaseLines::Place place = lines->count() > 1 ? lines->at(line_of(seeder, *lines, draws), u) : lines->at(u);
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

Release release_at(const Seeder& seeder, const Vec3& place, const Vec3& direction, const Draws& draws) {
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
  const Vec3 plan = Vec3(direction.x(), direction.y(), 0);
  const Vec3 heading = plan.norm() > 0 ? Vec3(plan.normalized()) : Vec3(Vec3::UnitX());
  release.motion.position = place;
  if (seeder.speed) {
    release.motion.velocity = drawn(*seeder.speed, draws, Stream::horizontal_velocity) * direction;
  } else {
    release.motion.velocity = drawn(seeder.horizontal, draws, Stream::horizontal_velocity) * heading +
                              drawn(seeder.vertical, draws, Stream::vertical_velocity) * Vec3::UnitZ();
  }
  release.motion.spin = drawn(seeder.spin, draws, Stream::spin) * Vec3::UnitZ().cross(heading);
  return release;
}

}  // namespace talus
