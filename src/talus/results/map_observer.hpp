#pragma once
// Turns the paths of rocks into maps.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "talus/results/maps.hpp"
#include "talus/results/record.hpp"
#include "talus/trajectory/piece_maxima.hpp"
#include "talus/trajectory/scene.hpp"

namespace talus {

/// The greatest bounce height [m] of a piece, which is no glide, from `from` to `to` of its parameter, if that is above
/// `known`; else `known` (trajectory/piece_maxima.hpp).
using GreatestHeight = std::function<double(const PathPiece& piece, double from, double to, double known)>;

template <class Surface>
[[nodiscard]] GreatestHeight greatest_height_over(const Surface& surface, RockModel model) {
  return [&surface, is_sphere = model == RockModel::rigid_sphere](const PathPiece& piece, double from, double to,
                                                                  double known) {
    return greatest_height(surface, piece, is_sphere, from, to, known);
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
  MapObserver(const MapGrid& grid, GreatestHeight heights, std::optional<std::size_t> sources = {});
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] bool wants_pieces() const override { return true; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  void save(ByteWriter& out) override;
  void merge_saved(ByteReader& in) override;
  /// Of all rocks committed so far; good until the next commit.
  [[nodiscard]] const Maps& maps();
  /// The same by source, in the order of their numbers; empty where maps are not split.
  [[nodiscard]] std::span<const Maps> by_source();

 private:
  /// Rocks one after the other that belong to the same maps, and which of a block's visits are theirs.
  struct Stretch {
    std::size_t map = 0;
    std::uint64_t rocks = 0;
    std::size_t first_visit = 0, end_visit = 0;
  };
  struct Block {
    std::vector<MapVisit> visits;
    std::vector<Stretch> stretches;
  };
  class Part;

  void add_waiting();
  void settle();

  GreatestHeight heights_;
  bool is_split_;
  std::vector<Maps> maps_;     // one, or one a source
  std::optional<Maps> total_;  // of split maps, once it was asked for
  // Committed blocks, until there are enough of them to share the work of adding them between threads.
  std::vector<Block> waiting_;
  static constexpr std::size_t enough_visits = 1U << 20;  // 32 MB
  std::size_t waiting_visits_ = 0;
};

}  // namespace talus
