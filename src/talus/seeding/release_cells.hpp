#pragma once
// Grid cells on plan from which rocks are released: millions of them, at four bytes each.

#include <array>
#include <cstdint>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/core/vec.hpp"

namespace talus {

enum class PlaceInCell { random, centre };

struct ReleaseCells {
  /// The first cell of a source.
  struct Run {
    std::uint32_t first;  // entry of `cells`
    SourceId source;
  };

  Vec2 corner;                // south-west, of cell 0; local [m]
  double dx = 1, dy = 1;      // of a cell [m]
  std::uint32_t columns = 1;  // of the grid
  /// Numbers of cells, row by row from the south-west; unique, and along Hilbert's curve, within a source.
  std::vector<std::uint32_t> cells;
  std::vector<Run> sources;  // in ascending order; the first begins at 0
  PlaceInCell place = PlaceInCell::random;

  [[nodiscard]] SourceId source_of(std::size_t entry) const;
  /// The middle of a cell; the place in a cell for two uniform numbers.
  [[nodiscard]] Vec2 centre_of(std::size_t entry) const { return at(entry, {0.5, 0.5}); }
  [[nodiscard]] Vec2 at(std::size_t entry, const std::array<double, 2>& u) const;
  [[nodiscard]] std::size_t bytes() const {
    return cells.size() * sizeof(std::uint32_t) + sources.size() * sizeof(Run);
  }
};

}  // namespace talus
