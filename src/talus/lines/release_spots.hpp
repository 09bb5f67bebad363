#pragma once
// Where the rocks of a run are released: the cells of a release area, the rows of a table, lines and points.

#include <cstdint>
#include <span>
#include <vector>

#include "talus/campaign/model.hpp"

namespace talus {

struct ReleaseSpot {
  std::uint64_t rocks = 0;  // at least one
  SeederId seeder;
  std::uint64_t first_place = 0;  // of the seeder's ReleaseOrder; up to that of the next spot
  SourceId source;
  Vec3 place;  // its middle, on the ground if its rocks are placed above it; local [m]
  Vec2 size;   // of a cell [m]; 0: not a cell
};

class ReleaseSpots {
 public:
  explicit ReleaseSpots(const Model& model);
  /// Seeder by seeder, in the order of their places. Cells and rows that release no rock are left out.
  [[nodiscard]] const std::vector<ReleaseSpot>& list() const { return spots_; }
  /// The number in the list of the place that releases a rock.
  [[nodiscard]] std::size_t of_rock(std::uint64_t rock) const;

 private:
  struct OfSeeder {
    ReleaseOrder order;
    std::size_t first, last;  // of its spots
  };
  std::vector<ReleaseSpot> spots_;
  std::vector<OfSeeder> seeders_;
};

/// The places of release, with how many of the rocks of each have stored paths.
struct StoredSources {
  StoredSources(const Model& model, std::span<const std::uint64_t> rocks);

  ReleaseSpots spots;
  std::vector<std::uint64_t> stored;  // by spot
};

}  // namespace talus
