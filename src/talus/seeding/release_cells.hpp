#pragma once
// Cells of a grid on plan from which rocks start: millions of them, at four bytes each.

#include <array>
#include <cstdint>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/core/vec.hpp"

namespace talus {

enum class PlaceInCell { random, centre };

/// Rocks are dealt out evenly: rock k of n goes to entry floor(k c / n) of the c cells, so that each cell gets
/// floor(n / c) rocks or one more, whatever the seed.
struct ReleaseCells {
  /// Where the rocks of a source begin.
  struct Run {
    std::uint32_t first;  // entry of `cells`
    SourceId source;
  };

  Vec2 corner = Vec2::Zero();  // south-west, of cell 0; local [m]
  double dx = 1, dy = 1;       // of a cell [m]
  std::uint32_t columns = 1;   // of the grid
  /// Numbers of cells, row by row from the south-west; ascending within a source, each once.
  std::vector<std::uint32_t> cells;
  std::vector<Run> sources;  // ascending; the first begins at 0
  PlaceInCell place = PlaceInCell::random;

  /// The entry of `cells` from which the k-th of n rocks starts.
  [[nodiscard]] std::size_t entry_of(std::uint64_t k, std::uint64_t n) const;
  [[nodiscard]] SourceId source_of(std::size_t entry) const;
  /// The middle of a cell, or the place in it that belongs to two uniform numbers.
  [[nodiscard]] Vec2 centre_of(std::size_t entry) const { return at(entry, {0.5, 0.5}); }
  [[nodiscard]] Vec2 at(std::size_t entry, const std::array<double, 2>& u) const;
  [[nodiscard]] std::size_t bytes() const {
    return cells.size() * sizeof(std::uint32_t) + sources.size() * sizeof(Run);
  }
};

}  // namespace talus
