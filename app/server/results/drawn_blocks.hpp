#pragma once
// Blocks of a run as arrays for drawing: their hulls, and where they are and how they are turned over time.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/vec.hpp"

namespace talus::server {

struct DrawnBlocks {
  // The bounds of one answer. Of a block with more poses, fewer are given, farther apart.
  static constexpr std::size_t max_rocks = 1000;
  static constexpr std::size_t max_poses_of_all = 600'000;

  Vec3 origin;  // of the positions [m]
  std::vector<std::uint32_t> rocks;
  // Of each block, the first of its corners, triangles and poses, and the number of all at the end.
  std::vector<std::uint32_t> corner_starts{0}, triangle_starts{0}, pose_starts{0};

  std::vector<float> corners;  // in the frame of the block, three each [m]
  std::vector<std::uint32_t>
      triangles;  // three corners of their block each, counter-clockwise from outside; none in 2D

  // Of each pose. Until the next, a block moves straight and turns evenly, the shorter way.
  std::vector<float> times;      // since release [s]
  std::vector<float> positions;  // of the centre, three each [m]
  std::vector<float> turns;      // unit quaternions x, y, z, w, from the frame of the block to that of the project
};

/// The blocks of these rocks, which are below `model.rocks()`, from the stored trajectories of the run; a rock that is
/// not stored is simulated again. Rocks without a shape are left out. Throws BadInput if the store is damaged.
[[nodiscard]] DrawnBlocks drawn_blocks(const std::filesystem::path& folder, const Model& model,
                                       std::span<const std::uint64_t> rocks);

}  // namespace talus::server
