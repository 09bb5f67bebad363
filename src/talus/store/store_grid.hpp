#pragma once
// A coarse grid on plan, by which a store finds the rocks near a place.

#include <cstdint>

#include "talus/barriers/plan_index.hpp"
#include "talus/core/bytes.hpp"
#include "talus/core/vec.hpp"
#include "talus/store/cell_set.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

/// Square cells, row by row from the lowest x and y. Places beside the grid belong to the cell at its border.
class StoreGrid {
 public:
  StoreGrid() = default;
  /// Over a terrain, in cells whose size is a power of two, at most 128 across; of a section one row, of at most 64.
  [[nodiscard]] static StoreGrid over(const PlanBounds& terrain, bool is_section);

  [[nodiscard]] std::uint32_t count() const { return columns_ * rows_; }

  /// In 2D only x counts.
  void add_box(const PlanBounds& box, CellSet& cells) const;
  /// The cells within `reach` [m] of the line from `from` to `to`, and some more.
  void add_line(const Vec2& from, const Vec2& to, double reach, CellSet& cells) const;
  /// The cells that the centre of a rock is in on a piece of its path; not on a glide.
  void add_piece(const PathPiece& piece, CellSet& cells) const;

  void save(ByteWriter& out) const;
  /// Throws BadBytes.
  [[nodiscard]] static StoreGrid read(ByteReader& in);

 private:
  /// The column or row of a coordinate, given in cells from the grid's corner.
  [[nodiscard]] static std::uint32_t clamped(double place, std::uint32_t count);
  void add_range(const Vec2& low, const Vec2& high, CellSet& cells) const;

  Vec2 low_;
  double size_ = 1;
  std::uint32_t columns_ = 1, rows_ = 1;
};

}  // namespace talus
