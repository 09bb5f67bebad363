#include "talus/lines/release_spots.hpp"

#include <algorithm>
#include <iterator>
#include <variant>

#include "talus/seeding/even_share.hpp"

namespace talus {

namespace {

class Spots {
 public:
  Spots(const Model& model, std::vector<ReleaseSpot>& spots) : model_(model), spots_(spots) {}

  void add(const Seeder& seeder, SeederId number) {
    seeder_ = &seeder;
    number_ = number;
    if (const auto* cells = std::get_if<ReleaseCells>(&*seeder.where)) {
      for_entries(cells->cells.size(), [&](std::size_t entry, std::uint64_t first, std::uint64_t rocks) {
        const Vec2 middle = cells->centre_of(entry);
        add(first, rocks, cells->source_of(entry), on_ground({middle.x(), middle.y(), 0}), {cells->dx, cells->dy});
      });
    } else if (const auto* table = std::get_if<ReleaseTable>(&*seeder.where)) {
      for_entries(table->count(), [&](std::size_t row, std::uint64_t first, std::uint64_t rocks) {
        const bool is_above_surface = ReleaseRow::has(table->given(row).above_surface);
        const Vec3& place = table->place(row);
        add(first, rocks, table->source_of(row), is_above_surface ? on_ground(place) : place);
      });
    } else {
      const auto* lines = std::get_if<ReleaseLines>(&*seeder.where);
      for (const SourceRun& run : source_runs(seeder, model_.seed, model_.sampling)) {
        const Vec3 place = lines ? middle_of(*lines, run.source) : std::get<Vec3>(*seeder.where);
        add(run.first_rock - seeder.first_rock, run.rocks, run.source, seeder.above_surface ? on_ground(place) : place);
      }
    }
  }

 private:
  template <class Visit>
  void for_entries(std::size_t entries, Visit&& visit) const {
    for (std::size_t entry = 0; entry < entries; ++entry) {
      const std::uint64_t first = first_at_share(entry, seeder_->rocks, entries);
      const std::uint64_t after = first_at_share(entry + 1, seeder_->rocks, entries);
      if (after > first) visit(entry, first, after - first);
    }
  }
  /// The middle of the line of a source, or of the first of several.
  static Vec3 middle_of(const ReleaseLines& lines, SourceId source) {
    for (std::size_t line = 0; line < lines.count(); ++line) {
      if (lines.source_of(line) == source) return lines.at(line, 0.5).point;
    }
    return lines.at(0.5).point;
  }
  [[nodiscard]] Vec3 on_ground(Vec3 place) const {
    const auto z =
        std::visit([&](const auto& surface) { return surface.elevation(place.x(), place.y()); }, *model_.surface);
    if (z) place.z() = *z;
    return place;
  }
  /// `first`: of the seeder's rocks.
  void add(std::uint64_t first, std::uint64_t rocks, SourceId source, const Vec3& place,
           const Vec2& size = Vec2::Zero()) {
    spots_.push_back({seeder_->first_rock + first, rocks, number_, source, place, size});
  }

  const Model& model_;
  std::vector<ReleaseSpot>& spots_;
  const Seeder* seeder_ = nullptr;
  SeederId number_;
};

}  // namespace

ReleaseSpots::ReleaseSpots(const Model& model) {
  Spots spots(model, spots_);
  for (std::uint32_t k = 0; k < model.seeders.size(); ++k) {
    if (model.seeders[k].rocks > 0) spots.add(model.seeders[k], SeederId{k});
  }
}

std::size_t ReleaseSpots::of_rock(std::uint64_t rock) const {
  const auto after = std::ranges::upper_bound(spots_, rock, {}, &ReleaseSpot::first_rock);
  return static_cast<std::size_t>(std::prev(after) - spots_.begin());
}

StoredSources::StoredSources(const Model& model, std::span<const std::uint64_t> rocks)
    : spots(model), stored(spots.list().size()) {
  for (const std::uint64_t rock : rocks) ++stored[spots.of_rock(rock)];
}

}  // namespace talus
