#pragma once
// Turns trajectories into maps.

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "talus/results/maps.hpp"
#include "talus/results/record.hpp"
#include "talus/trajectory/piece_maxima.hpp"
#include "talus/trajectory/scene.hpp"

namespace talus {

/// The maximum bounce height [m] of a rock in each part of a piece between consecutive `borders` of its parameter
/// (trajectory/piece_maxima.hpp). The piece is not a glide.
using MaxHeights = std::function<void(const Rock& rock, const PathPiece& piece, std::span<const double> borders,
                                      std::span<double> heights)>;

template <class Surface>
[[nodiscard]] MaxHeights max_height_over(const Surface& surface, RockModel model) {
  return [&surface, model](const Rock& rock, const PathPiece& piece, std::span<const double> borders,
                           std::span<double> heights) {
    max_heights(surface, piece, has_extent(model), borders, heights);
    for (double& height : heights) height = lowest_point(height, reach_of(model, rock));
  };
}

/// A rock's values in a cell are the maxima of trajectory/piece_maxima.hpp over its stays there. So the maximum over
/// all cells equals the run's own maximum for the rock.
///
/// The maps of all rocks are one set. If maps are split by source there is one set for each, and those of all rocks are
/// their sum, made when it is asked for. The run does the same work, but cells that rocks of several sources touch take
/// memory for each.
///
/// Each ensemble may have maps of its own, with other contents: the same as a run of its rocks alone would have.
class MapObserver : public SummingObserver {
 public:
  /// `heights` is called by many threads at the same time. `sources`: the number of sources to split the maps by;
  /// nullopt for maps that are not split. `ensembles`: maps of each are kept, unless it is 0.
  MapObserver(const MapGrid& grid, MaxHeights heights, std::optional<std::size_t> sources = {},
              const MapContents& contents = {}, std::size_t ensembles = 0,
              const MapContents& contents_of_ensembles = {});
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] bool wants_pieces() const override { return true; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void save(ByteWriter& out) override;
  void merge_saved(ByteReader& in) override;
  [[nodiscard]] bool is_split() const { return is_split_; }
  /// Memory that the maps may take, including the visits that wait to be added to them [bytes]. The less remains, the
  /// fewer visits wait. Beyond that the caller of commit() has to check lacks_memory() and end the run cleanly.
  void limit_memory(std::size_t bytes);
  [[nodiscard]] std::size_t memory_limit() const { return memory_limit_; }
  /// Memory taken [bytes]; split maps count twice, because those of all rocks are made of them in the end.
  [[nodiscard]] std::size_t memory_taken() const { return memory_taken_; }
  [[nodiscard]] bool lacks_memory() const { return memory_taken_ > memory_limit_; }
  /// Maps of all rocks committed so far; valid until the next commit.
  [[nodiscard]] const Maps& maps();
  /// The same for each source, by its number; empty if maps are not split.
  [[nodiscard]] std::span<const Maps> by_source();
  /// The same for each ensemble, by its number.
  [[nodiscard]] std::span<const Maps> by_ensemble();

 private:
  class Part;

  void add_waiting();
  void settle();
  /// Updates the memory taken, and how much may wait, after the maps have changed.
  void update_memory();
  [[nodiscard]] std::span<const Maps> of_sources() const { return std::span(maps_).first(sources_); }
  [[nodiscard]] std::span<const Maps> of_ensembles() const { return std::span(maps_).subspan(sources_); }

  MaxHeights heights_;
  bool is_split_;
  std::size_t sources_;         // sets of maps that have all rocks together
  std::vector<Maps> maps_;      // of these, then of the ensembles
  std::optional<Maps> total_;   // of split maps, once asked for
  mutable VisitMemory memory_;  // outlives parts and waiting blocks
  // Blocks that are committed but not yet in the maps: going through all tiles pays only for many of them.
  std::vector<VisitBlock> waiting_;
  std::size_t waiting_bytes_ = 0, waiting_limit_ = least_waiting;
  static constexpr std::size_t least_waiting = std::size_t{16} << 20;
  static constexpr std::size_t waiting_part = 8;  // visits that wait take at most this part of the bytes of the maps
  // A visit of 20 bytes to a cell not yet touched becomes a cell of up to 400 bytes.
  static constexpr std::size_t most_growth = 20;
  std::size_t bytes_of_maps_ = 0;
  std::size_t memory_limit_ = std::numeric_limits<std::size_t>::max();
  std::size_t memory_taken_ = 0;
};

}  // namespace talus
