#include "talus/calibration/best_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace talus::calibration {

std::string why_best_is_outside(const PreparedStudy& study, const CalibrationResult& result) {
  std::vector<double> weights;
  for (const SetResult& set : result.sets) weights.push_back(set.weight);
  std::vector<std::string> outside;
  for (std::size_t k = 0; k < study.parameters().size(); ++k) {
    std::vector<double> values;
    for (const SetResult& set : result.sets) values.push_back(set.values[k]);
    const double best = values[result.best];
    constexpr double low = 0.05, high = 0.95;
    const bool is_outside =
        best < weighted_quantile(values, weights, low) || best > weighted_quantile(values, weights, high);
    if (is_outside) outside.push_back(study.parameters()[k].name);
  }
  if (outside.empty()) return "";
  return fmt::format(
      "The best set lies outside the posterior's 5 to 95 % of {}: it has the least score, the distance of its rocks "
      "from the observed ones, while the posterior weights sets by their likelihood; predict with the posterior",
      fmt::join(outside, ", "));
}

}  // namespace talus::calibration
