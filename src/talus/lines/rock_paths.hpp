#pragma once
// The paths of rocks that have been simulated, wherever they are kept.

#include <cstdint>
#include <span>
#include <vector>

#include "talus/barriers/plan_index.hpp"
#include "talus/results/record.hpp"

namespace talus {

struct RockPath {
  RockRecord record;
  std::vector<PathPiece> pieces;  // none is a glide
  std::vector<PathRow> rows;      // of paths.csv
};

/// Reading changes nothing, so that several threads can read at the same time.
class RockPaths {
 public:
  virtual ~RockPaths() = default;
  /// Rocks of the whole run that were planned, and that were simulated.
  [[nodiscard]] virtual std::uint64_t planned() const = 0;
  [[nodiscard]] virtual std::uint64_t simulated() const = 0;
  /// The numbers of the rocks whose paths are kept, ascending: all, or a sample in which every rock has the same
  /// chance.
  [[nodiscard]] virtual std::span<const std::uint64_t> rocks() const = 0;
  /// The largest radius of these rocks [m].
  [[nodiscard]] virtual double largest_radius() const = 0;
  /// The places in rocks(), ascending, of at least all rocks whose centre was within a rectangle on plan; local.
  [[nodiscard]] virtual std::vector<std::size_t> near(const PlanBounds& bounds) const = 0;
  /// The same within `reach` of a line on plan [m].
  [[nodiscard]] virtual std::vector<std::size_t> near(std::span<const Vec2> line, double reach) const = 0;
  /// The path of rocks()[place]; memory of `into` is used again.
  virtual void read(std::size_t place, RockPath& into) const = 0;
};

}  // namespace talus
