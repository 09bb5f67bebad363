#pragma once
// The paths in the store of a run's trajectories (room `store`).

#include <filesystem>

#include "talus/lines/rock_paths.hpp"
#include "talus/store/trajectory_store.hpp"

namespace talus {

class StoredPaths : public RockPaths {
 public:
  /// Throws BadInput if the store cannot be read.
  explicit StoredPaths(const std::filesystem::path& file) : store_(file) {}

  [[nodiscard]] std::uint64_t planned() const override { return store_.facts().planned; }
  [[nodiscard]] std::uint64_t simulated() const override { return store_.rocks_done(); }
  [[nodiscard]] std::span<const std::uint64_t> rocks() const override { return store_.rocks(); }
  [[nodiscard]] double largest_radius() const override { return store_.largest_radius(); }
  [[nodiscard]] std::vector<std::size_t> near(const PlanBounds& bounds) const override {
    return store_.rocks_near(bounds);
  }
  [[nodiscard]] std::vector<std::size_t> near(std::span<const Vec2> line, double reach) const override {
    return store_.rocks_near(line, reach);
  }
  void read(std::size_t place, RockPath& into) const override;

 private:
  TrajectoryStore store_;
};

}  // namespace talus
