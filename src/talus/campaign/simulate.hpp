#pragma once
// Simulates the rocks of a campaign by their numbers: each trajectory is a pure function of (model, number). Replay and
// campaign share it.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/core/stop.hpp"
#include "talus/results/record.hpp"

namespace talus {

/// Which rocks to simulate, what to keep of their paths, and who receives them.
struct SimulationOrder {
  RockRange rocks;
  std::span<const std::uint64_t> numbers{};  // `rocks` are places in this list; empty: numbers of rocks
  std::function<bool(std::uint64_t rock)> keep_rows;
  std::function<bool(std::uint64_t rock)> keep_impacts;  // empty: of no rock
  bool keep_pieces = false;
  /// Called in this order; the log is valid until it returns.
  std::function<void(const RockRecord&, const RockLog&)> see;
  const StopScope* stop = nullptr;  // when a stop is requested, rocks in progress are dropped; null: never
};

/// The centre of a rock at its release, for pictures of release points; local [m]. In a section whose vertices vary: on
/// the given one.
[[nodiscard]] Vec3 start_of(const Model& model, std::uint64_t rock);

/// A rock with a shape, in its own frame: its principal axes through its centre, the longest along x.
struct RockBlock {
  std::vector<Vec3> corners;                            // [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  // of the hull, counter-clockwise from outside; none in 2D
  Vec3 inertia;                                         // principal moments [kg m2]
};

/// The block of a rock, as it is drawn for its release; nullopt: it has no shape.
[[nodiscard]] std::optional<RockBlock> block_of(const Model& model, std::uint64_t rock);

/// Whether rocks of the model have shapes.
[[nodiscard]] bool has_blocks(const Model& model);

/// Simulates rocks of one model; each thread needs its own.
class Simulator {
 public:
  explicit Simulator(const Model& model);
  /// On the surface of another model; that of `model` is not used. So models that differ in materials, laws or sizes of
  /// rocks can share one surface.
  Simulator(const Model& model, const ModelSurface& surface);
  ~Simulator();
  Simulator(Simulator&&) noexcept;
  Simulator& operator=(Simulator&&) = delete;
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  /// Several rocks at the same time, which is faster than one after the other and gives the same bits. Returns the
  /// end of the range of rocks passed to `see`, which is smaller than that of the order if it was stopped.
  std::uint64_t simulate(const SimulationOrder& order);
  /// One rock. Rows, pieces and impacts of the path are kept only on request; the log is valid until the next rock.
  /// Throws Stopped at the request of the thread's StopScope.
  RockRecord simulate(std::uint64_t rock, bool keep_rows, bool keep_pieces = false, bool keep_impacts = false);
  [[nodiscard]] const RockLog& log() const { return log_; }

 private:
  class Rocks;

  RockLog log_{false};
  std::unique_ptr<Rocks> rocks_;
};

}  // namespace talus
