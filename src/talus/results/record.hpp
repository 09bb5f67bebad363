#pragma once
// One rock's result, and the interface of everything that observes rocks.

#include <cstdint>
#include <memory>

#include "talus/core/bytes.hpp"
#include "talus/core/id.hpp"
#include "talus/trajectory/rock_path.hpp"

namespace talus {

/// In local coordinates (terrain/local_frame.hpp).
struct RockRecord {
  std::uint64_t rock = 0;
  SeederId seeder;
  SourceId source;
  Rock body;
  RockOutcome outcome;
  bool was_lifted = false;  // it was to start in the ground: lifted, lowered from a ceiling or caught
};

/// What one observer makes of one block of rocks. Parts of different blocks are made at the same time, each by one
/// thread.
class ObserverPart {
 public:
  virtual ~ObserverPart() = default;
  virtual void see(const RockRecord& record, const RockLog& log) = 0;
};

/// Sees every rock of a campaign. Parts are committed one at a time, in the order of the rocks.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Whether it wants this rock's path, row by row.
  [[nodiscard]] virtual bool wants_rows(std::uint64_t rock) const = 0;
  /// Whether it wants the pieces of which paths are made, and the impacts.
  [[nodiscard]] virtual bool wants_pieces() const { return false; }
  [[nodiscard]] virtual std::unique_ptr<ObserverPart> new_part() const = 0;
  virtual void commit(ObserverPart& part) = 0;
};

/// An observer that holds sums over rocks, of which every split merges to the same bits. What it holds can be kept on
/// disk, sent elsewhere and added to another of its kind that was made for the same model.
class SummingObserver : public Observer {
 public:
  /// What it holds of all rocks committed so far. The same content gives the same bytes, however it came about.
  virtual void save(ByteWriter& out) = 0;
  /// Adds what another saved to what is here; into one that has seen no rock it restores the other. Throws BadBytes on
  /// what save() cannot have written, and may then hold a part of it.
  virtual void merge_saved(ByteReader& in) = 0;
};

}  // namespace talus
