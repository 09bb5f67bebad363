#include "talus/store/store_grid.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

constexpr std::uint32_t most_columns = 128, most_columns_of_section = 64;
// Stored paths differ by less than this from those that the run computed [m] (store/ground_parts.hpp).
constexpr double margin = 1e-3;

}  // namespace

StoreGrid StoreGrid::over(const PlanBounds& terrain, bool is_section) {
  const double most = is_section ? most_columns_of_section : most_columns;
  const Vec2 extent = terrain.high - terrain.low;
  const double longest = is_section ? extent.x() : extent.largest();
  StoreGrid grid;
  grid.size_ = std::exp2(std::ceil(std::log2(std::max(longest, 1e-3) / most)));
  grid.low_ = terrain.low;
  const auto count = [&](double length) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(length / grid.size_), 1.0, most));
  };
  grid.columns_ = count(extent.x());
  grid.rows_ = is_section ? 1 : count(extent.y());
  return grid;
}

std::uint32_t StoreGrid::clamped(double place, std::uint32_t count) {
  if (!(place > 0)) return 0;
  return place < count ? static_cast<std::uint32_t>(place) : count - 1;
}

void StoreGrid::add_range(const Vec2& low, const Vec2& high, CellSet& cells) const {
  const std::uint32_t first = clamped(low.x(), columns_), last = clamped(high.x(), columns_);
  const std::uint32_t top = clamped(high.y(), rows_);
  for (std::uint32_t row = clamped(low.y(), rows_); row <= top; ++row) {
    cells.add(row * columns_ + first, row * columns_ + last);
  }
}

void StoreGrid::add_box(const PlanBounds& box, CellSet& cells) const {
  add_range((box.low - low_) / size_, (box.high - low_) / size_, cells);
}

void StoreGrid::add_line(const Vec2& from, const Vec2& to, double reach, CellSet& cells) const {
  const Vec2 by = Vec2::all(reach / size_);
  Vec2 a = (from - low_) / size_, b = (to - low_) / size_;
  if (a.x() > b.x()) std::swap(a, b);
  const std::uint32_t first = clamped(a.x() - by.x(), columns_), last = clamped(b.x() + by.x(), columns_);
  if (first == last || rows_ == 1) return add_range(a.min(b) - by, a.max(b) + by, cells);
  const double slope = b.x() > a.x() ? (b.y() - a.y()) / (b.x() - a.x()) : 0;
  // The part of the line over one column, and `reach` to both sides, after the other. Places beside the grid count to
  // the columns at its border.
  for (std::uint32_t column = first; column <= last; ++column) {
    const double left = column == first ? a.x() : std::max(a.x(), column - by.x());
    const double right = column == last ? b.x() : std::min(b.x(), column + 1 + by.x());
    double low = a.y() + slope * (left - a.x()), high = a.y() + slope * (right - a.x());
    if (b.x() == a.x()) low = a.y(), high = b.y();
    const double middle = column + 0.5;
    add_range({middle, std::min(low, high) - by.y()}, {middle, std::max(low, high) + by.y()}, cells);
  }
}

void StoreGrid::add_piece(const PathPiece& piece, CellSet& cells) const {
  const double t = piece.duration;
  const Vec2 start = piece.path.p.xy(), end = piece.path.at(t).xy();
  // On plan a piece is a Bezier curve of second degree; of a flight, a straight line.
  const Vec2 control = start + 0.5 * t * piece.path.v.xy();
  const Vec2 chord = end - start, aside = control - start;
  const double bend = std::abs(chord.x() * aside.y() - chord.y() * aside.x());
  const double along = aside.dot(chord);
  if (bend <= margin * chord.norm() && along >= 0 && along <= chord.squared_norm())
    return add_line(start, end, 2 * margin, cells);
  constexpr int parts = 8;
  Vec2 from = start;
  for (int k = 1; k <= parts; ++k) {
    const double s0 = t * (k - 1) / parts, s1 = t * k / parts;
    const Vec2 to = piece.path.at(s1).xy(), bent = from + 0.5 * (s1 - s0) * piece.path.velocity(s0).xy();
    const Vec2 by = Vec2::all(margin);
    add_box({from.min(to).min(bent) - by, from.max(to).max(bent) + by}, cells);
    from = to;
  }
}

void StoreGrid::save(ByteWriter& out) const {
  out.put(low_.x());
  out.put(low_.y());
  out.put(size_);
  out.put(columns_);
  out.put(rows_);
}

StoreGrid StoreGrid::read(ByteReader& in) {
  StoreGrid grid;
  grid.low_.x() = in.get<double>();
  grid.low_.y() = in.get<double>();
  grid.size_ = in.get<double>();
  grid.columns_ = in.get<std::uint32_t>();
  grid.rows_ = in.get<std::uint32_t>();
  const auto is_count = [](std::uint32_t n) { return n >= 1 && n <= most_columns; };
  expect_bytes(grid.low_.is_finite() && std::isfinite(grid.size_) && grid.size_ > 0 && is_count(grid.columns_) &&
                   is_count(grid.rows_),
               "the index has no valid grid");
  return grid;
}

}  // namespace talus
