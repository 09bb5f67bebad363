#pragma once
// The random numbers of one rock, by plain Monte Carlo or by Latin hypercube.

#include <array>
#include <cstdint>

#include "talus/core/random.hpp"

namespace talus {

enum class SamplingMethod { monte_carlo, latin_hypercube };

/// The sampling of one seeder's rocks, over which a Latin hypercube stratifies.
struct SamplingPlan {
  std::uint64_t seed = 1;
  SamplingMethod method = SamplingMethod::monte_carlo;
  std::uint64_t first = 0;  // the number of the seeder's first rock
  std::uint64_t count = 1;  // number of the seeder's rocks
};

/// One rock's draws. With Latin hypercube sampling, the k-th number of a stream is stratified over the rocks of the
/// seeder: exactly one rock is in each of `count` equal cells of (0, 1) (McKay, Beckman, Conover 1979).
class Draws {
 public:
  Draws(const SamplingPlan& plan, std::uint64_t rock) : plan_(plan), rock_(rock) {}

  [[nodiscard]] std::array<double, 2> pair(Stream stream, std::uint32_t index = 0) const;
  [[nodiscard]] double one(Stream stream, std::uint32_t index = 0) const { return pair(stream, index)[0]; }
  [[nodiscard]] std::uint64_t rock() const { return rock_; }

 private:
  SamplingPlan plan_;
  std::uint64_t rock_;
};

}  // namespace talus
