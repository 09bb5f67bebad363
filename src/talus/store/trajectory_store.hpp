#pragma once
// Reads the store of a run's trajectories, trajectories.bin (docs/trajectories.md describes the file).

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "talus/store/path_code.hpp"
#include "talus/store/store_facts.hpp"

namespace talus {

inline constexpr const char* trajectories_name = "trajectories.bin";

/// Several threads may use one at the same time: reading a rock changes nothing.
class TrajectoryStore {
 public:
  /// Reads the head and the index. Throws BadInput if the file cannot be read or is damaged.
  explicit TrajectoryStore(const std::filesystem::path& file);
  ~TrajectoryStore();
  TrajectoryStore(TrajectoryStore&&) noexcept;
  TrajectoryStore& operator=(TrajectoryStore&&) = delete;
  TrajectoryStore(const TrajectoryStore&) = delete;
  TrajectoryStore& operator=(const TrajectoryStore&) = delete;

  [[nodiscard]] const StoreFacts& facts() const;
  /// The rocks that the run had simulated when the file was written.
  [[nodiscard]] std::uint64_t rocks_done() const;
  /// The rows of paths.csv of all rocks in the store.
  [[nodiscard]] std::uint64_t row_count() const;
  /// Of these rocks [m]: a sphere touches what its centre is this far from.
  [[nodiscard]] double largest_radius() const;
  /// The numbers of the rocks in the store, ascending. If these are not all, they are a fair sample: each had the same
  /// chance, whatever its path.
  [[nodiscard]] std::span<const std::uint64_t> rocks() const;
  [[nodiscard]] bool has_all() const { return rocks().size() == rocks_done(); }
  /// The place of a rock in rocks(); nullopt if the store does not have it.
  [[nodiscard]] std::optional<std::size_t> find(std::uint64_t rock) const;

  /// The places in rocks() of all rocks whose centre was in the box, and of some that were near, ascending.
  [[nodiscard]] std::vector<std::size_t> rocks_near(const PlanBounds& box) const;
  /// The same for a line on plan, within `reach` of it [m].
  [[nodiscard]] std::vector<std::size_t> rocks_near(std::span<const Vec2> line, double reach) const;

  /// The trajectory of rocks()[place]. Throws BadInput if its bytes are damaged. The second form reuses memory.
  [[nodiscard]] StoredTrajectory read(std::size_t place) const;
  void read(std::size_t place, StoredTrajectory& into) const;

 private:
  class ReadFile;
  struct Content;
  [[nodiscard]] std::vector<std::size_t> rocks_in(const CellSet& cells) const;

  std::unique_ptr<const Content> content_;
};

}  // namespace talus
