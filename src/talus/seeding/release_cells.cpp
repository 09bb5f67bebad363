#include "talus/seeding/release_cells.hpp"

#include <algorithm>

#include "talus/seeding/even_share.hpp"

namespace talus {

std::size_t ReleaseCells::entry_of(std::uint64_t k, std::uint64_t n) const {
  return place_of_share(k, n, cells.size());
}

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
