#include "results/drawn_blocks.hpp"

#include <algorithm>
#include <optional>
#include <system_error>

#include "results/end_points.hpp"
#include "talus/campaign/simulate.hpp"
#include "talus/results/poses.hpp"
#include "talus/store/trajectory_store.hpp"

namespace talus::server {

namespace {

/// The paths of single rocks, from the store of a run if it has them.
class BlockPaths {
 public:
  BlockPaths(const std::filesystem::path& folder, const Model& model) : simulator_(model) {
    const std::filesystem::path file = folder / trajectories_name;
    std::error_code no_store;
    if (exists(file, no_store)) store_.emplace(file);
  }

  /// Valid until the next rock.
  const StoredTrajectory& of(std::uint64_t rock) {
    const std::optional<std::size_t> place = store_ ? store_->find(rock) : std::nullopt;
    if (place) {
      store_->read(*place, path_);
      return path_;
    }
    path_.record = simulator_.simulate(rock, false, true);
    path_.pieces.clear();
    simulator_.log().for_each_piece([&](const PathPiece& piece) { path_.pieces.push_back(piece); });
    path_.attitudes = simulator_.log().attitudes;
    return path_;
  }

 private:
  std::optional<TrajectoryStore> store_;
  Simulator simulator_;
  StoredTrajectory path_;
};

void add_numbers(std::vector<float>& list, const Vec3& vector) {
  for (std::size_t axis = 0; axis < 3; ++axis) list.push_back(static_cast<float>(vector[axis]));
}

std::uint32_t size_of(const std::vector<float>& list, std::size_t each) {
  return static_cast<std::uint32_t>(list.size() / each);
}

void add_block(DrawnBlocks& blocks, std::uint64_t rock, const RockBlock& block) {
  blocks.rocks.push_back(static_cast<std::uint32_t>(rock));
  for (const Vec3& corner : block.corners) add_numbers(blocks.corners, corner);
  for (const auto& triangle : block.triangles)
    blocks.triangles.insert(blocks.triangles.end(), triangle.begin(), triangle.end());
  blocks.corner_starts.push_back(size_of(blocks.corners, 3));
  blocks.triangle_starts.push_back(static_cast<std::uint32_t>(blocks.triangles.size() / 3));
}

void add_poses(DrawnBlocks& blocks, const LocalFrame& frame, std::span<const Pose> poses) {
  if (blocks.times.empty()) blocks.origin = origin_near(frame.global_from_local(poses.front().position));
  for (const auto& [time, position, orientation] : poses) {
    blocks.times.push_back(static_cast<float>(time));
    add_numbers(blocks.positions, frame.global_from_local(position) - blocks.origin);
    add_numbers(blocks.turns, orientation.xyz());
    blocks.turns.push_back(static_cast<float>(orientation.w()));
  }
  blocks.pose_starts.push_back(size_of(blocks.times, 1));
}

}  // namespace

DrawnBlocks drawn_blocks(const std::filesystem::path& folder, const Model& model,
                         std::span<const std::uint64_t> rocks) {
  const std::size_t max_poses = DrawnBlocks::max_poses_of_all / std::max<std::size_t>(1, rocks.size());
  DrawnBlocks blocks;
  BlockPaths paths(folder, model);
  for (const std::uint64_t rock : rocks) {
    const std::optional<RockBlock> block = block_of(model, rock);
    if (!block) continue;
    const StoredTrajectory& path = paths.of(rock);
    if (path.pieces.empty() || path.attitudes.empty()) continue;
    add_block(blocks, rock, *block);
    add_poses(blocks, model.frame, poses_along(path.pieces, path.attitudes, block->inertia, {}, max_poses));
  }
  return blocks;
}

}  // namespace talus::server
