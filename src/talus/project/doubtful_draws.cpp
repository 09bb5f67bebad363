#include "talus/project/doubtful_draws.hpp"

#include <fmt/format.h>

#include <cmath>

#include "talus/project/settings.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

std::optional<DoubtOfDraws> doubt_of_draws(const std::string& name, const Distribution& given, Bounds bounds) {
  if (given.kind == DistributionKind::none) return std::nullopt;
  const Truncation found = truncation_of(given, bounds);
  constexpr double few = 0.2;  // a normal distribution that is cut at a quarter of its deviation on either side
  if (found.kept < few) {
    return DoubtOfDraws{
        fmt::format("{} has a std_dev of {}, of which its limits leave little", name,
                    number_text(given.std_dev.value_or(0))),
        fmt::format(
            "only {:.2g} % of the {} distribution lie between {:.4g} and {:.4g}: draws are spread almost evenly "
            "there, about {:.4g}",
            100 * found.kept, word(given.kind), found.least, found.most,
            found.mean),
        "Give a smaller std_dev, or distribution = \"uniform\""};
  }
  constexpr double visible = 0.02;  // of the width of the draws
  if (std::abs(found.mean - given.mean) <= visible * (found.most - found.least)) return std::nullopt;
  return DoubtOfDraws{
      fmt::format("{} has the mean {}, but its draws have {:.4g}", name, number_text(given.mean), found.mean),
      fmt::format("they lie between {:.4g} and {:.4g}, which is not even about the mean", found.least, found.most),
      "Give limits that surround the mean evenly, or the mean that the draws are to have"};
}

}  // namespace talus::project
