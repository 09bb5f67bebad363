#pragma once
// Several models of the same study, compared and pooled by how well they predict observations that were held out.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "talus/calibration/calibrate.hpp"
#include "talus/statistics/order_statistics.hpp"

namespace talus::calibration {

/// A model's held-out score, with the interval that other observations of the same kind would give (bootstrap.hpp, rock
/// by rock; the predictions stay as they are).
struct ModelScore {
  Estimate score;
  Estimate difference;  // from the least score, of the same observations; 0 for that itself
  /// In the pool: the share of resampled observations in which the model has the least score. Models that cannot be
  /// told apart have nearly equal weights.
  double weight = 0;
};

/// `models`: the parts of each that were held out, which are the same for all. With nothing held out all
/// weights are equal.
[[nodiscard]] std::vector<ModelScore> compare_models(std::span<const std::vector<HeldOut>> models, std::uint64_t seed);

/// The parts as predicted by the mixture of the models with these weights (a linear pool: M. Stone, "The opinion pool",
/// Annals of Mathematical Statistics 32 (1961) 1339-1342): means and standard deviations; no scores.
[[nodiscard]] std::vector<HeldOut> pooled(std::span<const std::vector<HeldOut>> models,
                                          std::span<const ModelScore> scores);

struct ModelFacts {
  std::string name, folder;
  double prior_score = 0, effective_sets = 0;
};
/// models.csv: a row for each model.
[[nodiscard]] std::string models_table(std::span<const ModelFacts> models, std::span<const ModelScore> scores);
/// pooled.csv: a row for each feature that was held out.
[[nodiscard]] std::string pooled_table(std::span<const HeldOut> parts);

}  // namespace talus::calibration
