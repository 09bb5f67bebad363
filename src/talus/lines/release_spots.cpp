#include "talus/lines/release_spots.hpp"

#include <algorithm>
#include <iterator>
#include <variant>

namespace talus {

namespace {

class Spots {
 public:
  Spots(const Model& model, std::vector<ReleaseSpot>& spots) : model_(model), spots_(spots) {}

  void add(const Seeder& seeder, SeederId number, const ReleaseOrder& order) {
    number_ = number;
    order_ = order;
    if (const auto* cells = std::get_if<ReleaseCells>(&*seeder.where)) {
      for (std::uint64_t place = 0; place < order.places; ++place) {
        const Vec2 middle = cells->centre_of(place);
        add(place, place + 1, cells->source_of(place),
            [&] {
              return on_ground({middle.x(), middle.y(), 0});
            },
            {cells->dx, cells->dy});
      }
    } else if (const auto* table = std::get_if<ReleaseTable>(&*seeder.where)) {
      for (std::uint64_t entry = 0; entry < order.places; ++entry) {
        const std::size_t row = table->row_at(entry);
        const bool is_above_surface = ReleaseRow::has(table->given(row).above_surface);
        const Vec3& place = table->place(row);
        add(entry, entry + 1, table->source_of(row), [&] { return is_above_surface ? on_ground(place) : place; });
      }
    } else {
      const auto* lines = std::get_if<ReleaseLines>(&*seeder.where);
      const std::vector<SourceRun> runs = source_runs(seeder, model_.seed);
      for (std::size_t k = 0; k < runs.size(); ++k) {
        const std::uint64_t end = k + 1 < runs.size() ? runs[k + 1].first_place : order.places;
        const Vec3 place = lines ? middle_of(*lines, runs[k].source) : std::get<Vec3>(*seeder.where);
        add(runs[k].first_place, end, runs[k].source, [&] { return seeder.above_surface ? on_ground(place) : place; });
      }
    }
  }

 private:
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
  /// A spot with the places `begin` to `end` - 1, if any rock starts there.
  template <class Middle>
  void add(std::uint64_t begin, std::uint64_t end, SourceId source, Middle&& middle, const Vec2& size = Vec2{}) {
    const std::uint64_t rocks = order_.rocks_from(begin, end, order_.rocks);
    if (rocks > 0) spots_.push_back({rocks, number_, begin, source, middle(), size});
  }

  const Model& model_;
  std::vector<ReleaseSpot>& spots_;
  SeederId number_;
  ReleaseOrder order_;
};

}  // namespace

ReleaseSpots::ReleaseSpots(const Model& model) {
  Spots spots(model, spots_);
  for (std::uint32_t k = 0; k < model.seeders.size(); ++k) {
    const ReleaseOrder order = release_order(model.seeders[k], model.seed);
    const std::size_t first = spots_.size();
    spots.add(model.seeders[k], SeederId{k}, order);
    seeders_.push_back({order, first, spots_.size()});
  }
}

std::size_t ReleaseSpots::of_rock(std::uint64_t rock) const {
  const auto after =
      std::ranges::upper_bound(seeders_, rock, {}, [](const OfSeeder& of) { return of.order.first_rock; });
  const OfSeeder& of = *std::prev(after);
  const auto spots = std::span(spots_).subspan(of.first, of.last - of.first);
  const auto next = std::ranges::upper_bound(spots, of.order.place_of(rock), {}, &ReleaseSpot::first_place);
  return of.first + static_cast<std::size_t>(std::prev(next) - spots.begin());
}

StoredSources::StoredSources(const Model& model, std::span<const std::uint64_t> rocks)
    : spots(model), stored(spots.list().size()) {
  for (const std::uint64_t rock : rocks) ++stored[spots.of_rock(rock)];
}

}  // namespace talus
