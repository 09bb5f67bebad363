#pragma once
// Cells of a map at half its resolution, as in its overviews.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "talus/maps/map_list.hpp"

namespace talus {

/// `cells`: row by row from north to south, `columns` in a row. A cell of the result has the maximum or the mean of
/// those of its four cells that have data; at the eastern and southern edge it may have only two or one.
template <class Value>
[[nodiscard]] std::vector<Value> halved_cells(std::span<const Value> cells, int columns, MapOverview what,
                                              double no_data) {
  const auto width = static_cast<std::size_t>(columns), height = cells.size() / width;
  std::vector<Value> halved;
  halved.reserve((width + 1) / 2 * ((height + 1) / 2));
  for (std::size_t row = 0; row < height; row += 2) {
    for (std::size_t column = 0; column < width; column += 2) {
      double all = no_data;
      int count = 0;
      for (std::size_t j = row; j < std::min(row + 2, height); ++j) {
        for (std::size_t i = column; i < std::min(column + 2, width); ++i) {
          const auto value = static_cast<double>(cells[j * width + i]);
          if (value == no_data) continue;
          all = count == 0 ? value : what == MapOverview::mean ? all + value : std::max(all, value);
          ++count;
        }
      }
      halved.push_back(static_cast<Value>(what == MapOverview::mean && count > 1 ? all / count : all));
    }
  }
  return halved;
}

}  // namespace talus
