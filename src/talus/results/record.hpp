#pragma once
// One rock's result, and the interface of all observers of rocks.

#include <cstdint>
#include <memory>
#include <optional>

#include "talus/core/bytes.hpp"
#include "talus/core/id.hpp"
#include "talus/trajectory/rock_path.hpp"

namespace talus {

/// Of a rock with a shape.
struct BlockRecord {
  Vec3 axes;                    // lengths along its principal axes, the longest first; in 2D the last is 0 [m]
  Vec3 inertia;                 // principal moments, along its axes x, y and z [kg m2]
  double short_axis_share = 0;  // SpinAxis::share(), over its trajectory

  [[nodiscard]] bool is_section() const { return axes.z() == 0; }
};

/// In local coordinates (terrain/local_frame.hpp).
struct RockRecord {
  std::uint64_t rock = 0;
  SeederId seeder;
  SourceId source;
  Rock body;
  RockOutcome outcome;
  std::optional<BlockRecord> block;
  bool was_lifted = false;  // its release was in the ground, and was lifted, lowered from a ceiling or caught
};

/// One observer's results of one block of rocks. Parts of different blocks are filled at the same time, each by one
/// thread.
class ObserverPart {
 public:
  virtual ~ObserverPart() = default;
  virtual void see(const RockRecord& record, const RockLog& log) = 0;
};

/// Observes every rock of a campaign. Parts are committed one at a time, in the order of the rocks.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Whether it needs this rock's trajectory, row by row.
  [[nodiscard]] virtual bool wants_rows(std::uint64_t rock) const = 0;
  /// Whether it needs the impacts of this rock.
  [[nodiscard]] virtual bool wants_impacts(std::uint64_t) const { return false; }
  /// Whether it needs the pieces of trajectories, and the places of impacts.
  [[nodiscard]] virtual bool wants_pieces() const { return false; }
  [[nodiscard]] virtual std::unique_ptr<ObserverPart> new_part() const = 0;
  virtual void commit(ObserverPart& part) = 0;
};

/// An observer of sums over rocks, which merge to the same bits from any split. Its content can be saved to disk, sent
/// elsewhere and added to another of its kind for the same model.
class SummingObserver : public Observer {
 public:
  /// Saves its content over all rocks committed so far. Equal content gives equal bytes, however it was reached.
  virtual void save(ByteWriter& out) = 0;
  /// Adds the saved content of another observer; into one that has seen no rock it restores the other. Throws BadBytes
  /// on anything that save() cannot have written, after which it may have a part of it.
  virtual void merge_saved(ByteReader& in) = 0;
};

}  // namespace talus
