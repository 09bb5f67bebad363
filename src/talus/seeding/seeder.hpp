#pragma once
// The releases of rocks: how many, where, how large, how fast.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "talus/core/id.hpp"
#include "talus/core/shared.hpp"
#include "talus/sampling/distribution.hpp"
#include "talus/sampling/draws.hpp"
#include "talus/seeding/release.hpp"
#include "talus/seeding/release_cells.hpp"
#include "talus/seeding/release_lines.hpp"
#include "talus/seeding/release_order.hpp"
#include "talus/seeding/release_table.hpp"
#include "talus/seeding/rock_shapes.hpp"

namespace talus {

enum class SizeOf { mass, volume, diameter };

using ReleasePlaces = std::variant<Vec3, ReleaseLines, ReleaseCells, ReleaseTable>;

struct Seeder {
  std::string name;
  SourceId source;  // of rocks from a point, for results by source; lines, cells and rows have their own
  std::uint64_t first_rock = 0;
  std::uint64_t rocks = 1;
  std::uint64_t rocks_at_once = 1;  // as in ReleaseOrder: the number of ensembles
  std::uint64_t step = 1;           // as in ReleaseOrder, for the number of places of this seeder
  /// A point, lines, cells or the rows of a table; local coordinates.
  Shared<ReleasePlaces> where = Vec3(0, 0, 0);
  /// Rocks are released this far above the surface [m], not at the places' own z; always given for cells, and not used
  /// for tables, whose rows give it.
  std::optional<double> above_surface;
  SizeOf size_of = SizeOf::mass;
  Sampler size;     // of the mass [kg], the volume [m3] or the diameter [m]
  Sampler density;  // [kg/m3]
  /// With `speed`, the velocity is along `direction`; without, `horizontal` is along its projection on plan, and
  /// `vertical` upwards. Unit; nullopt: the fall line (fall_line.hpp) at the place of release.
  std::optional<Vec3> direction = unit_x;
  std::optional<Sampler> speed;  // [m/s]
  Sampler horizontal, vertical;  // [m/s]
  Sampler spin;                  // about up x direction [rad/s]: positive rolls forwards
  Shared<RockShapes> shapes = RockShapes{};
  ReleaseTurn turn;  // of rocks with a shape
};

/// Where one rock is released, before it is moved to fit (lift.hpp).
struct ReleasePlace {
  Vec3 point;
  SourceId source;
  /// The middle of its cell, which is known to be on the terrain; `point` may be over a small hole.
  std::optional<Vec2> middle;
  std::optional<double> above_surface;  // [m]; instead of the point's z
  ReleaseRow given;                     // what its row of a table gives
};

/// The number of places that take turns: cells, rows, equal parts of all lines, or one point.
[[nodiscard]] std::uint64_t count_places(const Seeder& seeder);
[[nodiscard]] ReleaseOrder release_order(const Seeder& seeder, std::uint64_t seed);

/// The first of consecutive places of one source.
struct SourceRun {
  std::uint64_t first_place;
  SourceId source;
};

/// The sources of all places of a seeder, in their order; the same as in ReleasePlace::source.
[[nodiscard]] std::vector<SourceRun> source_runs(const Seeder& seeder, std::uint64_t seed);

/// `plan`: of the seeder's rocks.
[[nodiscard]] ReleasePlace place_of(const Seeder& seeder, const SamplingPlan& plan, std::uint64_t rock);

/// The rock and its motion at `place`. `direction`: that of the row or the seeder, or the fall line there. What the row
/// of a table gives replaces what the seeder would.
[[nodiscard]] Release release_at(const Seeder& seeder, const Vec3& place, const Vec3& direction, const Draws& draws,
                                 const ReleaseRow& given = {});

/// Gives the rock its shape and turns it. `own`: the place for a shape that only this rock has; it must live as long as
/// the release is used.
void give_shape(Release& release, const Seeder& seeder, const Draws& draws, const ReleaseRow& given, RockShape& own);

}  // namespace talus
