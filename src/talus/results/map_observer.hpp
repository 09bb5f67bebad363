#pragma once
// Turns the paths of rocks into maps.

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

/// The greatest bounce height [m] of each part of a piece, which is not a glide, between two of `borders` of its
/// parameter (trajectory/piece_maxima.hpp).
using GreatestHeights =
    std::function<void(const PathPiece& piece, std::span<const double> borders, std::span<double> heights)>;

template <class Surface>
[[nodiscard]] GreatestHeights greatest_height_over(const Surface& surface, RockModel model) {
  return [&surface, is_sphere = model == RockModel::rigid_sphere](
             const PathPiece& piece, std::span<const double> borders, std::span<double> heights) {
    greatest_heights(surface, piece, is_sphere, borders, heights);
  };
}

/// What a rock has in a cell are the maxima of trajectory/piece_maxima.hpp over its stays there: so the greatest of all
/// cells is what the run itself has for the rock.
///
/// Maps of all rocks are one set of maps. Split by source there is one for each, and that of all rocks is their sum,
/// made when it is asked for: a run does the same work, and cells that rocks of several sources touch take memory for
/// each.
class MapObserver : public SummingObserver {
 public:
  /// `heights` is called by many threads at the same time. `sources`: how many there are, to split the maps by; nothing
  /// where they are not to be split.
  MapObserver(const MapGrid& grid, GreatestHeights heights, std::optional<std::size_t> sources = {},
              const MapContents& contents = {});
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] bool wants_pieces() const override { return true; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void save(ByteWriter& out) override;
  void merge_saved(ByteReader& in) override;
  [[nodiscard]] bool is_split() const { return is_split_; }
  /// How much memory the maps may take, with the visits that wait to be added to them [bytes]. The less is left, the
  /// fewer visits wait; beyond that it is for whoever commits to look whether it is enough, and to end in good order.
  void limit_memory(std::size_t bytes);
  [[nodiscard]] std::size_t memory_limit() const { return memory_limit_; }
  /// What is taken of it; maps that are split count twice, since those of all rocks are made of them in the end.
  [[nodiscard]] std::size_t memory_taken() const { return memory_taken_; }
  [[nodiscard]] bool lacks_memory() const { return memory_taken_ > memory_limit_; }
  /// Of all rocks committed so far; good until the next commit.
  [[nodiscard]] const Maps& maps();
  /// The same by source, in the order of their numbers; empty where maps are not split.
  [[nodiscard]] std::span<const Maps> by_source();

 private:
  class Part;

  void add_waiting();
  void settle();
  /// After maps have changed: what they take, and how much may wait.
  void take_stock();

  GreatestHeights heights_;
  bool is_split_;
  std::vector<Maps> maps_;      // one, or one a source
  std::optional<Maps> total_;   // of split maps, once it was asked for
  mutable VisitMemory memory_;  // outlives what waits, and parts
  // Of committed blocks, until there are as many as make it worth the while to go through all tiles.
  std::vector<VisitBlock> waiting_;
  std::size_t waiting_bytes_ = 0, enough_bytes_ = least_waiting;
  static constexpr std::size_t least_waiting = std::size_t{16} << 20;
  static constexpr std::size_t part_that_waits = 8;  // of the bytes of the maps
  // A visit of 20 bytes to a cell where no rock was makes one of up to 400.
  static constexpr std::size_t most_growth = 20;
  std::size_t bytes_of_maps_ = 0;
  std::size_t memory_limit_ = std::numeric_limits<std::size_t>::max();
  std::size_t memory_taken_ = 0;
};

}  // namespace talus
