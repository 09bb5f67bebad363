#include "talus/sampling/empirical.hpp"

#include <algorithm>

#include "talus/core/check.hpp"

namespace talus {

EmpiricalSample::EmpiricalSample(std::vector<Value> values) {
  std::erase_if(values, [](const Value& v) { return !(v.weight > 0); });
  TALUS_PROMISE(!values.empty(), "a sample has a value");
  std::ranges::stable_sort(values, {}, &Value::value);
  const bool has_weights =
      std::ranges::any_of(values, [&](const Value& v) { return v.weight != values.front().weight; });
  double sum = 0;
  for (const auto& [value, weight] : values) {
    values_.push_back(value);
    if (has_weights) weights_up_to_.push_back(sum += weight);
  }
}

double EmpiricalSample::quantile(double u) const {
  const std::size_t last = values_.size() - 1;
  if (weights_up_to_.empty()) {
    return values_[std::min(static_cast<std::size_t>(u * static_cast<double>(values_.size())), last)];
  }
  const auto at = std::ranges::upper_bound(weights_up_to_, u * weights_up_to_.back());
  return values_[std::min(static_cast<std::size_t>(at - weights_up_to_.begin()), last)];
}

double EmpiricalSample::mean() const {
  double sum = 0, before = 0;
  for (std::size_t k = 0; k < values_.size(); ++k) {
    const double weight = weights_up_to_.empty() ? 1 : weights_up_to_[k] - before;
    before += weight;
    sum += weight * values_[k];
  }
  return sum / before;
}

}  // namespace talus
