#include "talus/sensitivity/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace talus::sensitivity {

namespace {

constexpr double wide_index = 0.1, wide_effect = 0.25;  // of an index; of the largest effect
constexpr double much_noise = 0.1, much_noise_effect = 0.33;
constexpr double negligible_index = 0.02, negligible_effect = 0.05;

/// The longer side of an interval.
double reach_of(const Estimate& estimate) {
  return std::max(estimate.high.value_or(estimate.value) - estimate.value,
                  estimate.value - estimate.low.value_or(estimate.value));
}

class Doubts {
 public:
  Doubts(const Study& study, const Analysis& analysis) : study_(study), analysis_(analysis) {}

  Problems all() {
    for (const ResultEffects& result : analysis_.results) {
      if (check_values(result)) check_effects(result);
    }
    for (std::size_t k = 0; k + 1 < analysis_.inputs.size(); ++k) check_input(k);
    return std::move(problems_);
  }

 private:
  [[nodiscard]] bool is_morris() const { return study_.method == Method::morris; }

  void warn(int line, std::string where, std::string what, std::string why, std::string hint) {
    problems_.add({.severity = Severity::warning,
                   .file = study_.file.string(),
                   .line = line,
                   .where = std::move(where),
                   .what = std::move(what),
                   .why = std::move(why),
                   .hint = std::move(hint)});
  }
  void warn_result(const ResultEffects& result, std::string what, std::string why, std::string hint) {
    warn(study_.results[result.result].line, fmt::format("[[result]] {}", result.result + 1),
         fmt::format("{}: {}", result.title, what), std::move(why), std::move(hint));
  }

  /// Whether it has effects.
  bool check_values(const ResultEffects& result) {
    const std::size_t runs = analysis_.runs.size();
    if (result.defined == 0) {
      warn_result(result, "no run has a value", "no rock reaches the line in any run", "Check the line and the ranges");
      return false;
    }
    if (result.defined < runs) {
      warn_result(result,
                  fmt::format("{} of {} runs ha{} no value", runs - result.defined, runs,
                              runs - result.defined == 1 ? "s" : "ve"),
                  "no rock reaches the line in these; the effects are those in the others",
                  "Look at the share of rocks as well");
    }
    if (!(*result.least < *result.most)) {
      warn_result(result, fmt::format("is {:.6g} in all runs", *result.least), "nothing varies it", "");
      return false;
    }
    return true;
  }

  void check_effects(const ResultEffects& result) {
    double largest = 0, reach = 0;
    for (const Effect& effect : result.of_inputs) {
      if (!effect.size()) continue;
      largest = std::max(largest, effect.size()->value);
      reach = std::max(reach, reach_of(*effect.size()));
    }
    if (!(largest > 0)) return;
    const double wide = is_morris() ? wide_effect * largest : wide_index;
    if (reach > wide) {
      const double factor = (reach / wide) * (reach / wide);
      warn_result(result, fmt::format("intervals reach {:.2g} to a side", reach),
                  is_morris() ? "the order of inputs is uncertain" : "an index is a share from 0 to 1",
                  runs_hint(factor));
    }
    const auto seed = result.of_inputs.back().size();
    const double share = seed ? seed->value / (is_morris() ? largest : 1.0) : 0;
    const double much = is_morris() ? much_noise_effect : much_noise;
    if (share > much) {
      // The variance of a percentile or share falls as the number of rocks; an elementary effect is its square root.
      const double factor = is_morris() ? (share / much) * (share / much) : share / much;
      warn_result(
          result,
          fmt::format("the choice of rocks causes {:.0f} % of {}", 100 * share,
                      is_morris() ? "the largest effect" : "the variance"),
          fmt::format("{} rocks are few for it", study_.rocks),
          fmt::format("Write rocks = {:.0f} or more", std::ceil(factor * static_cast<double>(study_.rocks) / 50) * 50));
    }
  }

  [[nodiscard]] std::string runs_hint(double factor) const {
    if (is_morris())
      return fmt::format("Write trajectories = {:.0f}",
                         std::ceil(factor * static_cast<double>(study_.trajectories) / 10) * 10);
    const double rows = factor * static_cast<double>(study_.rows);
    return fmt::format("Write rows = {}", std::bit_ceil(static_cast<std::uint64_t>(std::min(rows, 1e12))));
  }

  void check_input(std::size_t k) {
    bool is_known = false;
    for (const ResultEffects& result : analysis_.results) {
      const auto size = result.of_inputs[k].size();
      if (!size) continue;
      is_known = true;
      double largest = 0;
      for (const Effect& effect : result.of_inputs) {
        if (effect.size()) largest = std::max(largest, effect.size()->value);
      }
      if (size->value > (is_morris() ? negligible_effect * largest : negligible_index)) return;
    }
    if (!is_known) return;
    warn(analysis_.inputs[k].line, fmt::format("parameter \"{}\"", analysis_.inputs[k].name), "no result depends on it",
         is_morris() ? "its effects are less than a twentieth of the largest" : "its total index is 0.02 at most",
         "Leave it at its value");
  }

  const Study& study_;
  const Analysis& analysis_;
  Problems problems_;
};

}  // namespace

Problems doubts_about(const Study& study, const Analysis& analysis) { return Doubts(study, analysis).all(); }

}  // namespace talus::sensitivity
