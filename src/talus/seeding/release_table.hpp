#pragma once
// Releases from a table: a row is a place, with what the table gives about its rocks.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/core/vec.hpp"

namespace talus {

/// What a row gives; NaN: nothing, so that the seeder's own setting applies.
struct ReleaseRow {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  [[nodiscard]] static bool has(double value) { return value == value; }
  [[nodiscard]] static bool has(const Vec3& value) { return has(value.x()); }

  double above_surface = none;                // [m]; the place's z does not count
  double mass = none, volume = none;          // [kg], [m3]; one of them at most
  double density = none;                      // [kg/m3]
  double speed = none;                        // along the direction [m/s]
  double horizontal = none, vertical = none;  // [m/s]
  double spin = none;                         // about up x direction [rad/s]
  Vec3 velocity = Vec3::all(none);            // [m/s]; instead of speed, horizontal and vertical
  Vec3 spin_vector = Vec3::all(none);         // [rad/s]; instead of spin
  Vec3 direction = Vec3::all(none);           // unit
  Vec3 axes = Vec3::all(none);                // of the block, descending [m]; only their ratios count
};

/// The rows, with a column for everything that at least one of them gives.
class ReleaseTable {
 public:
  /// The first row of a source.
  struct Run {
    std::uint32_t first;
    SourceId source;
  };

  /// Adds a row; those of one source follow each other. `place`: local; `number`: of the row in its file, from 1.
  void add(const Vec3& place, const ReleaseRow& given, SourceId source, std::uint32_t number);

  [[nodiscard]] std::size_t count() const { return places_.size(); }
  [[nodiscard]] const Vec3& place(std::size_t row) const { return places_[row]; }
  [[nodiscard]] ReleaseRow given(std::size_t row) const;
  /// The number of the row in its file, from 1.
  [[nodiscard]] std::uint32_t number(std::size_t row) const { return numbers_[row]; }
  [[nodiscard]] const std::vector<Run>& sources() const { return sources_; }
  [[nodiscard]] SourceId source_of(std::size_t row) const;
  /// Orders the rows of each source along Hilbert's curve. Expects all rows.
  void order_by_place();
  /// The row at a place of that order.
  [[nodiscard]] std::size_t row_at(std::size_t place) const { return by_place_[place]; }

  /// Names of rows, by their numbers in the file; empty if the table has none.
  std::vector<std::string> names;

  /// Whether a row gives the axes of its block.
  [[nodiscard]] bool has_axes() const { return !vectors_given_.back().empty(); }
  [[nodiscard]] std::size_t bytes() const;

  /// Calls visit(values) with each list of numbers, for checksums.
  template <class Visit>
  void visit_columns(Visit&& visit) const {
    for (const auto& column : numbers_given_) visit(column);
    for (const auto& column : vectors_given_) visit(column);
    visit(places_);
  }

 private:
  std::vector<Vec3> places_;
  std::vector<std::uint32_t> numbers_, by_place_;
  std::vector<Run> sources_;
  // In the order of the members of ReleaseRow; empty if no row gives any.
  std::array<std::vector<double>, 8> numbers_given_;
  std::array<std::vector<Vec3>, 4> vectors_given_;
};

}  // namespace talus
