#pragma once
// The cells on plan from which rocks can start, with the elevations of the terrain at and around them.

#include <array>
#include <optional>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/meshing/plan_polygon.hpp"

namespace talus::project {

/// On a raster terrain, its cells, each centred on a node. Elsewhere, squares with edges at multiples of their size.
/// Only cells are used for which the terrain has data at the centres of the cell and its eight neighbours: their slope
/// is known, and every place in them is on the terrain, except for holes smaller than a cell.
class CellHeights {
 public:
  /// `cell` is the size of the squares [m], used if the terrain is not a raster. Expects count() below 2^32.
  CellHeights(const Model& model, double cell);
  /// The number of cells that there would be.
  [[nodiscard]] static double count(const Model& model, double cell);

  /// The centres of the cells, in the user's coordinates, numbered row by row from the south-west.
  [[nodiscard]] const PlanGrid& grid() const { return grid_; }
  /// The elevations around a cell, in the order of horn_gradient_squared(); nullopt if one is missing. Call it row by
  /// row: elevations of a mesh are cached for three rows.
  [[nodiscard]] std::optional<std::array<double, 9>> around(std::uint32_t column, std::uint32_t row);

 private:
  [[nodiscard]] double at(std::uint32_t column, std::uint32_t row);

  const Model& model_;
  const RasterGrid* raster_ = nullptr;
  PlanGrid grid_;
  struct Row {
    std::optional<std::uint32_t> number;
    std::vector<double> z;  // infinity: not yet computed; NaN: no ground
  };
  std::array<Row, 3> rows_;
};

}  // namespace talus::project
