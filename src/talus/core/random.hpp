#pragma once
// Counter-based random numbers: each is a pure function of (seed, rock, stream, index), so that a trajectory depends
// only on the project, the seed and the rock's number. Generator: Philox 4x32-10, Salmon et al., "Parallel random
// numbers: as easy as 1, 2, 3", SC11.

#include <array>
#include <cstdint>

namespace talus {

/// The purpose of a random number. Each purpose has its own stream, so that one more number of one kind changes no
/// other. Results for a given `seed` depend on these values: append, never renumber.
enum class Stream : std::uint32_t {
  release_position = 0,
  horizontal_velocity = 1,
  vertical_velocity = 2,
  spin = 3,
  size = 4,
  density = 5,
  restitution = 6,  // first number: normal, second: tangential
  friction = 7,     // first number: friction angle, second: dynamic friction
  rolling_friction = 8,
  roughness = 9,
  slope_vertex = 10,  // first number: x, second: z
  met_face = 11,      // of rough ground: pairs of proposals (ground/rough_ground.hpp)
  bump = 12,          // the way along rough ground to the next bump
  shape = 13,         // pairs: which kind and which of its hulls; b/a and c/b
  orientation = 14,   // of release: two numbers, and the first of the next pair
};

/// The generator: four words, a pure function of the arguments.
[[nodiscard]] std::array<std::uint32_t, 4> philox(std::uint64_t key, std::uint64_t counter, std::uint32_t high,
                                                  std::uint32_t highest);

/// Two independent uniform numbers in the open interval (0, 1), with 52 random bits each.
[[nodiscard]] std::array<double, 2> uniform_pair(std::uint64_t seed, std::uint64_t rock, Stream stream,
                                                 std::uint32_t index);

/// The place of `i` in the random permutation of 0 ... count-1 given by `key`. The permutation is not stored (a
/// four-round Feistel network over Philox, repeated until the result is in the range).
[[nodiscard]] std::uint64_t permuted(std::uint64_t i, std::uint64_t count, std::array<std::uint32_t, 2> key);

}  // namespace talus
