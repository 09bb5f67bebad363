#pragma once
// Rocks of a campaign by their numbers: each is a pure function of (model, number). Replay and campaign share it.

#include <functional>
#include <memory>

#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/core/stop.hpp"
#include "talus/results/record.hpp"

namespace talus {

/// Which rocks to simulate, what of their paths to keep, and who gets them.
struct SimulationOrder {
  RockRange rocks;
  std::function<bool(std::uint64_t rock)> keep_rows;
  bool keep_pieces = false;
  /// Called in the order of the rocks; the log is good until it returns.
  std::function<void(const RockRecord&, const RockLog&)> see;
  const StopScope* stop = nullptr;  // once it is asked to end, rocks on their way are left; null: nobody asks
};

/// Where the centre of a rock is when it is released, for pictures of where rocks start; local [m]. Of a section whose
/// vertices vary, on the one that is given.
[[nodiscard]] Vec3 start_of(const Model& model, std::uint64_t rock);

/// Simulates rocks of one model; each thread has its own.
class Simulator {
 public:
  explicit Simulator(const Model& model);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) = delete;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  /// Several rocks side by side, which is faster than one after the other and gives the same bits. Gives the number
  /// that follows the last rock seen: any of the order's, where it was stopped.
  std::uint64_t simulate(const SimulationOrder& order);
  /// One rock. Rows and pieces of the path are kept only if asked for; the log is good until the next rock. Throws
  /// Stopped at the request of the thread's StopScope.
  RockRecord simulate(std::uint64_t rock, bool keep_rows, bool keep_pieces = false);
  [[nodiscard]] const RockLog& log() const { return log_; }

 private:
  class Rocks;

  RockLog log_{false};
  std::unique_ptr<Rocks> rocks_;
};

}  // namespace talus
