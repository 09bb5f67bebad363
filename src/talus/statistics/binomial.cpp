#include "talus/statistics/binomial.hpp"

#include <boost/math/distributions/binomial.hpp>

namespace talus {

std::array<double, 2> central_counts(std::uint64_t trials, double probability, double central) {
  using namespace boost::math::policies;
  using Outwards = policy<discrete_quantile<integer_round_outwards>>;
  const boost::math::binomial_distribution<double, Outwards> hits(static_cast<double>(trials), probability);
  const double tail = (1 - central) / 2;
  return {quantile(hits, tail), quantile(complement(hits, tail))};
}

}  // namespace talus
