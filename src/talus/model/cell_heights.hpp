#pragma once
// The cells on plan from which rocks can start, and how high the terrain is at and around them.

#include <array>
#include <optional>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/meshing/plan_polygon.hpp"

namespace talus::project {

/// On a raster terrain, its own cells: each about the node that is its middle. Elsewhere squares whose borders are at
/// multiples of their side. A cell counts where the terrain has data at its middle and at those of its eight
/// neighbours, so that the slope is known and every place in it is on the terrain, but for holes smaller than a cell.
class CellHeights {
 public:
  /// `cell` is the side of the squares [m], used where the terrain is not a raster. Expects count() below 2^32.
  CellHeights(const Model& model, double cell);
  /// How many cells there would be.
  [[nodiscard]] static double count(const Model& model, double cell);

  /// The middles of the cells, in the user's coordinates; numbered row by row from the south-west.
  [[nodiscard]] const PlanGrid& grid() const { return grid_; }
  /// The elevations around a cell, as horn_gradient_squared() takes them; nothing where one is missing. Ask row by row:
  /// what was found out of a mesh is kept for three rows.
  [[nodiscard]] std::optional<std::array<double, 9>> around(std::uint32_t column, std::uint32_t row);

 private:
  [[nodiscard]] double at(std::uint32_t column, std::uint32_t row);

  const Model& model_;
  const RasterGrid* raster_ = nullptr;
  PlanGrid grid_;
  struct Row {
    std::optional<std::uint32_t> number;
    std::vector<double> z;  // infinite: not asked for yet; not a number: no ground
  };
  std::array<Row, 3> rows_;
};

}  // namespace talus::project
