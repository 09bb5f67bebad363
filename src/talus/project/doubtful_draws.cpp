#include "talus/project/doubtful_draws.hpp"

#include <fmt/format.h>

#include <cmath>

#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

std::optional<DoubtOfDraws> doubt_of_draws(const std::string& name, const Distribution& given, Bounds bounds) {
  if (given.kind == DistributionKind::none || given.kind == DistributionKind::empirical) return std::nullopt;
  const Truncation found = truncation_of(given, bounds);
  constexpr double few = 0.2;  // a normal distribution truncated at a quarter of its standard deviation on either side
  if (found.kept < few) {
    return DoubtOfDraws{
        fmt::format("{} has a std_dev of {}, but its limits cut off most of the distribution", name,
                    number_text(given.std_dev.value_or(0))),
        fmt::format(
            "only {:.2g} % of the {} distribution lies between {:.4g} and {:.4g}: draws are almost uniform there, with "
            "mean {:.4g}",
            100 * found.kept, word(given.kind), found.least, found.most, found.mean),
        "Give a smaller std_dev, or distribution = \"uniform\""};
  }
  constexpr double visible = 0.02;  // of the width of the draws
  if (std::abs(found.mean - given.mean) <= visible * (found.most - found.least)) return std::nullopt;
  return DoubtOfDraws{
      fmt::format("{} has the mean {}, but its draws have the mean {:.4g}", name, number_text(given.mean), found.mean),
      fmt::format("they lie between {:.4g} and {:.4g}, not symmetrically about the mean", found.least, found.most),
      "Give limits that are symmetric about the mean, or the mean that the draws should have"};
}

}  // namespace talus::project
