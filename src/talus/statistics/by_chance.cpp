#include "talus/statistics/by_chance.hpp"

#include <algorithm>

#include "talus/core/check.hpp"
#include "talus/core/random.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

void draw_members(std::uint64_t seed, std::uint64_t draw, std::size_t population, std::span<std::size_t> chosen) {
  TALUS_PROMISE(population > 0, "nothing can be drawn from nobody");
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    // The last word keeps these numbers apart from those of rocks, whose index there is small.
    constexpr std::uint32_t resampling = 0x52455341;
    const auto words = philox(seed, draw, static_cast<std::uint32_t>(k), resampling);
    const double share = (static_cast<double>(words[0]) + 0x1p-32 * static_cast<double>(words[1])) * 0x1p-32;
    chosen[k] = std::min(static_cast<std::size_t>(share * static_cast<double>(population)), population - 1);
  }
}

ByChance by_chance(double observed, std::vector<double> drawn) {
  TALUS_PROMISE(!drawn.empty(), "chance needs draws");
  std::ranges::sort(drawn);
  const auto quantile = [&](double p) {
    const auto [rank, fraction] = quantile_place(p, drawn.size());
    return fraction > 0 ? between(drawn[rank], drawn[rank + 1], fraction) : drawn[rank];
  };
  const auto as_far = static_cast<std::size_t>(drawn.end() - std::ranges::lower_bound(drawn, observed));
  return {quantile(0.5), quantile(0.95), static_cast<double>(1 + as_far) / static_cast<double>(1 + drawn.size()),
          drawn.size()};
}

}  // namespace talus
