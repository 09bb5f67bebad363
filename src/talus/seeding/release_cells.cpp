#include "talus/seeding/release_cells.hpp"

#include <algorithm>

namespace talus {

SourceId ReleaseCells::source_of(std::size_t entry) const {
  const auto after = std::upper_bound(sources.begin(), sources.end(), entry,
                                      [](std::size_t e, const Run& run) { return e < run.first; });
  return std::prev(after)->source;
}

Vec2 ReleaseCells::at(std::size_t entry, const std::array<double, 2>& u) const {
  const std::uint32_t cell = cells[entry], column = cell % columns, row = cell / columns;
  return {corner.x() + (column + u[0]) * dx, corner.y() + (row + u[1]) * dy};
}

}  // namespace talus
