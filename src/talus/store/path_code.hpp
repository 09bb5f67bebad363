#pragma once
// The path of a rock as bytes, and back. docs/trajectories.md describes the bytes.
//
// A flight follows from its departure and duration; where a piece begins is where the one before ends, unless it says
// otherwise; rows of paths.csv are marks between pieces. Flights are kept with all their bits, motion along the ground
// in parts of constant acceleration (ground_parts.hpp), in whole numbers of small steps.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "talus/results/record.hpp"
#include "talus/store/path_bytes.hpp"
#include "talus/store/store_grid.hpp"

namespace talus {

/// A rock of the store.
///
/// With the same bits as in the run: `record`; flights with their place, velocity, spin, time and duration; rows that
/// begin or end a flight, or the path.
///
/// Within StoreTolerance (ground_parts.hpp): motion along the ground between two rows of paths.csv. A part is one piece
/// with on_ground, never a glide: its path gives positions, and velocity and spin are linear between its ends, as in
/// RockLog. Rows on the ground are within StoreStep. Facets are not kept.
///
/// The pieces join end to end as those of RockLog do; a piece may have no duration.
struct StoredTrajectory {
  RockRecord record;
  std::vector<PathPiece> pieces;
  std::vector<PathRow> rows;        // of paths.csv
  std::vector<Attitude> attitudes;  // of a rock with a shape, with the bits of the run
};

/// Attitudes that a free turn from the one before tells within this angle are not stored [rad]: most of those on the
/// ground.
inline constexpr double max_turn_left_out = 0.02;

/// Makes the bytes of rocks, one after the other. Expects logs with rows and pieces.
class PathEncoder {
 public:
  /// `grid` must outlive the encoder.
  PathEncoder(const Vec3& gravity, const StoreGrid& grid) : gravity_(gravity), grid_(grid), cells_(grid.count()) {}

  /// Appends the rock's bytes. The cells that its centre visits are in cells() until the next rock.
  void encode(const RockRecord& record, const RockLog& log, std::string& out);
  [[nodiscard]] const CellSet& cells() const { return cells_; }

 private:
  void put_facts(const RockRecord& record);
  void put_attitudes(const BlockRecord& block, const RockLog& log);
  void put_path(const RockRecord& record, const RockLog& log);
  void put_row(const PathRow& row, int where);
  void put_flight(const PathPiece& flight);
  void add_ground(const RockLog& log, const PathPiece& piece, double end_time);
  void put_ground();
  void put_part(const Motion& from, const Motion& to);

  Vec3 gravity_;
  const StoreGrid& grid_;
  CellSet cells_;
  ByteBuffer facts_, attitudes_, items_;  // of the present rock
  bool is_planar_ = false;                // it moves in a plane y = 0, and spins about y
  Motion now_;                            // as a reader has it after these items
  double spin_step_ = 0;                  // [rad/s]
  double rate_ = 0;                       // of the last flight with a path of its own
  std::vector<Motion> ground_;            // of legs not yet put
  std::vector<std::size_t> ends_;
  std::vector<std::size_t> kept_;  // of attitudes
};

/// The radius in a rock's bytes [m]. Throws BadBytes.
[[nodiscard]] double radius_in(std::string_view bytes);

/// Reads the bytes of a rock into `rock`, which keeps its memory; its number is not among them. Throws BadBytes.
void decode_path(std::string_view bytes, const Vec3& gravity, StoredTrajectory& rock);

}  // namespace talus
