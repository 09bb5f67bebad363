#include "talus/model/cell_heights.hpp"

#include <cmath>
#include <limits>

namespace talus::project {

namespace {

struct Squares {
  double first_column, first_row, columns, rows;
};

Squares squares(const Model& model, double cell) {
  const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *model.surface);
  const Vec3 low = model.frame.global_from_local(box.low), high = model.frame.global_from_local(box.high);
  const double column = std::floor(low.x() / cell), row = std::floor(low.y() / cell);
  return {column, row, std::ceil(high.x() / cell) - column, std::ceil(high.y() / cell) - row};
}

}  // namespace

double CellHeights::count(const Model& model, double cell) {
  if (const auto* raster = std::get_if<RasterSurface>(&*model.surface)) {
    return static_cast<double>(raster->grid().z.size());
  }
  const Squares all = squares(model, cell);
  return all.columns * all.rows;
}

CellHeights::CellHeights(const Model& model, double cell) : model_(model) {
  const Vec2 origin = model.frame.origin.xy();
  if (const auto* raster = std::get_if<RasterSurface>(&*model.surface)) {
    raster_ = &raster->grid();
    grid_ = {Vec2(raster_->x0, raster_->y0) + origin, raster_->dx, raster_->dy, raster_->columns, raster_->rows};
  } else {
    const Squares all = squares(model, cell);
    grid_ = {Vec2((all.first_column + 0.5) * cell, (all.first_row + 0.5) * cell), cell, cell,
             static_cast<std::uint32_t>(all.columns), static_cast<std::uint32_t>(all.rows)};
  }
}

double CellHeights::at(std::uint32_t column, std::uint32_t row) {
  if (raster_) return raster_->z[raster_->index(column, row)];
  Row& kept = rows_[row % rows_.size()];
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (kept.number != row) {
    kept.number = row;
    kept.z.assign(grid_.columns, unknown);
  }
  double& z = kept.z[column];
  if (z == unknown) {
    const double x = grid_.x(column) - model_.frame.origin.x(), y = grid_.y(row) - model_.frame.origin.y();
    const auto found = std::visit([&](const auto& surface) { return surface.elevation(x, y); }, *model_.surface);
    z = found.value_or(std::numeric_limits<double>::quiet_NaN());
  }
  return z;
}

std::optional<std::array<double, 9>> CellHeights::around(std::uint32_t column, std::uint32_t row) {
  if (column == 0 || row == 0 || column + 1 >= grid_.columns || row + 1 >= grid_.rows) return std::nullopt;
  std::array<double, 9> z{};
  for (std::uint32_t k = 0; k < 9; ++k) {
    z[k] = at(column + k % 3 - 1, row + k / 3 - 1);
    if (std::isnan(z[k])) return std::nullopt;
  }
  return z;
}

}  // namespace talus::project
