#include "talus/results/line_crossing.hpp"

#include <algorithm>
#include <vector>

#include "talus/rocks/energy.hpp"
#include "talus/rocks/heights.hpp"

namespace talus {

const Passage* first_passage(const RockLog& log, std::uint32_t barrier) {
  const Passage* first = nullptr;
  for (const auto* passages : {&log.hits, &log.passed_above}) {
    for (const Passage& passage : *passages) {
      if (passage.barrier.index != barrier) continue;
      if (first == nullptr || passage.motion.time < first->motion.time) first = &passage;
    }
  }
  return first;
}

std::uint32_t first_sufficient(const std::vector<double>& ascending, double needed) {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(ascending, needed) - ascending.begin());
}

LineCrossing line_crossing(const DesignPlan& plan, const DesignLine& line, const Rock& rock, const Passage& crossing) {
  const double velocity = crossing.motion.velocity.norm();
  const double translational = 0.5 * rock.mass * velocity * velocity;
  const double total = translational + rotational_energy(rock, crossing.motion);
  const double energy = energy_to_check(plan.factors, translational, total, velocity);
  constexpr double by_rounding = 1e-6;  // lowest point of a rock that rolls on the ground [m]
  const double lowest = crossing.lowest > by_rounding ? crossing.lowest : 0;
  const double half_height = crossing.half_height_of(rock.radius);
  const double height = needed_height(plan.factors, lowest, radius_to_check(plan.factors, rock.mass, half_height));
  LineCrossing crosses{.section = line.section_at(crossing.station),
                       .values = {translational, total, velocity, top_over(lowest, half_height), height,
                                  line.lateral_of(crossing.station, crossing.motion.velocity)},
                       .diameter = 2 * rock.radius,
                       .needed_energy = needed_maximum_energy(plan.factors, energy)};
  crosses.height = first_sufficient(plan.heights, crosses.needed_height());
  crosses.energy = first_sufficient(plan.energies, crosses.needed_energy);
  return crosses;
}

}  // namespace talus
