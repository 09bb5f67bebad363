#include "talus/sampling/draws.hpp"

#include <algorithm>

namespace talus {

std::array<double, 2> Draws::pair(Stream stream, std::uint32_t index) const {
  std::array<double, 2> u = uniform_pair(plan_.seed, rock_, stream, index);
  if (plan_.method == SamplingMethod::latin_hypercube) {
    for (std::uint32_t part = 0; part < 2; ++part) {
      const std::uint32_t which = static_cast<std::uint32_t>(stream) * 2 + part;
      // A different permutation for every number of every stream of every seeder.
      const auto words = philox(plan_.seed, plan_.first, which, index);
      const std::uint64_t rank = (rock_ - plan_.first) % plan_.count;
      const auto cell = static_cast<double>(permuted(rank, plan_.count, {words[0], words[1]}));
      // The sum may round up to the edge of the next cell; 1 is not a valid argument of a quantile function.
      u[part] = std::min((cell + u[part]) / static_cast<double>(plan_.count), 1.0 - 0x1p-53);
    }
  }
  return u;
}

}  // namespace talus
