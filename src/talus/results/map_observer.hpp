#pragma once
// Turns the paths of rocks into maps.

#include <functional>

#include "talus/results/maps.hpp"
#include "talus/results/record.hpp"
#include "talus/trajectory/scene.hpp"

namespace talus {

/// The height of the ground at (x, y), of what lies below `below`; all local [m]. Nothing where there is none.
using GroundHeight = std::function<std::optional<double>(double x, double y, double below)>;

/// Energies and velocities are exact: along a piece of a path they are greatest where it enters or leaves a cell. Of
/// the height above the ground, which need not be smooth, samples are taken: where a flight enters and leaves the cell,
/// halfway between in time, and at its top if that is over the cell. On the ground a lumped mass has height 0; of a
/// sphere's legs the ends are sampled.
class MapObserver : public Observer {
 public:
  /// `ground` is called by many threads at the same time.
  MapObserver(const MapGrid& grid, RockModel model, GroundHeight ground)
      : model_(model), ground_(std::move(ground)), maps_(grid) {}
  [[nodiscard]] bool wants_rows(std::uint64_t) const override { return false; }
  [[nodiscard]] bool wants_pieces() const override { return true; }
  [[nodiscard]] std::unique_ptr<ObserverPart> new_part() const override;
  void commit(ObserverPart& part) override;
  /// Of all rocks committed so far.
  [[nodiscard]] const Maps& maps();

 private:
  void add_waiting();

  RockModel model_;
  GroundHeight ground_;
  Maps maps_;
  // Committed blocks, until there are enough of them to share the work of adding them between threads.
  std::vector<std::vector<MapVisit>> waiting_;
  std::uint64_t waiting_rocks_ = 0;
  std::size_t waiting_visits_ = 0;
};

}  // namespace talus
