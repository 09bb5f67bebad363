#include "talus/calibration/model_scores.hpp"

#include <algorithm>
#include <cmath>

#include "talus/core/check.hpp"
#include "talus/files/csv_text.hpp"
#include "talus/statistics/bootstrap.hpp"

namespace talus::calibration {

std::vector<ModelScore> compare_models(std::span<const std::vector<HeldOut>> models, std::uint64_t seed) {
  std::vector<std::vector<ObservedScore>> scores;  // by model and rock
  for (const std::vector<HeldOut>& parts : models) {
    std::vector<ObservedScore>& own = scores.emplace_back();
    for (const HeldOut& part : parts) own.insert(own.end(), part.scores.begin(), part.scores.end());
  }
  if (scores.empty() || scores.front().empty())
    return std::vector<ModelScore>(models.size(),
                                   {.score = {}, .difference = {}, .weight = 1.0 / static_cast<double>(models.size())});
  const std::size_t count = scores.size(), rocks = scores.front().size();
  TALUS_PROMISE(std::ranges::all_of(scores, [&](const auto& each) { return each.size() == rocks; }),
                "models predict the same observations");
  const auto means_of = [&](std::span<const std::size_t> rows) {
    std::vector<double> means;
    for (const auto& own : scores) {
      ObservedScore all;
      for (const std::size_t row : rows) {
        all.sum += own[row].sum;
        all.count += own[row].count;
      }
      means.push_back(all.sum / all.count);
    }
    return means;
  };
  std::vector<std::size_t> all(rocks);
  for (std::size_t k = 0; k < rocks; ++k) all[k] = k;
  const std::vector<double> means = means_of(all);
  const auto best = static_cast<std::size_t>(std::ranges::min_element(means) - means.begin());
  // Scores, differences, and whether the model has the least score; ties count for the first.
  std::vector<double> wins(count);
  const Bootstrap bootstrap{.replicas = 1000, .confidence = 0.95, .seed = seed};
  const std::vector<Estimate> estimates = bootstrap_estimates(
      rocks,
      [&](std::span<const std::size_t> rows) {
        std::vector<double> values = means_of(rows);
        wins[static_cast<std::size_t>(std::ranges::min_element(values) - values.begin())] += 1;
        for (std::size_t k = 0; k < count; ++k) values.push_back(values[k] - values[best]);
        return values;
      },
      bootstrap);
  double sum = 0;
  for (const double each : wins) sum += each;
  std::vector<ModelScore> results;
  for (std::size_t k = 0; k < count; ++k) results.push_back({estimates[k], estimates[count + k], wins[k] / sum});
  return results;
}

std::vector<HeldOut> pooled(std::span<const std::vector<HeldOut>> models, std::span<const ModelScore> scores) {
  if (models.empty()) return {};
  std::vector<HeldOut> pool = models.front();
  for (std::size_t part = 0; part < pool.size(); ++part) {
    pool[part].scores.clear();
    for (std::size_t f = 0; f < pool[part].features.size(); ++f) {
      double mean = 0, square = 0;
      for (std::size_t k = 0; k < models.size(); ++k) {
        const Moments& own = models[k][part].features[f].predicted;
        mean += scores[k].weight * own.mean;
        square += scores[k].weight * (own.std_dev * own.std_dev + own.mean * own.mean);
      }
      pool[part].features[f].predicted = {mean, std::sqrt(std::max(0.0, square - mean * mean))};
    }
  }
  return pool;
}

std::string models_table(std::span<const ModelFacts> models, std::span<const ModelScore> scores) {
  std::string text;
  CsvRow header(text);
  for (const char* name : {"model", "folder", "held_out_score", "held_out_low", "held_out_high", "difference",
                           "difference_low", "difference_high", "weight", "prior_score", "effective_sets"})
    header << name;
  header.end();
  for (std::size_t k = 0; k < models.size(); ++k) {
    CsvRow row(text);
    row << std::string_view(models[k].name) << std::string_view(models[k].folder);
    for (const Estimate& each : {scores[k].score, scores[k].difference})
      row << each.value << each.low.value_or(each.value) << each.high.value_or(each.value);
    row << scores[k].weight << models[k].prior_score << models[k].effective_sets;
    row.end();
  }
  return text;
}

std::string pooled_table(std::span<const HeldOut> parts) {
  std::string text;
  CsvRow header(text);
  for (const char* name : {"held_out", "observations", "quantity", "unit", "observed_mean", "observed_std_dev",
                           "predicted_mean", "predicted_std_dev"})
    header << name;
  header.end();
  for (const HeldOut& part : parts) {
    for (const PredictedFeature& each : part.features) {
      CsvRow row(text);
      row << std::string_view(part.name) << std::string_view(each.group) << std::string_view(each.feature.name)
          << std::string_view(each.feature.unit);
      for (const double value :
           {each.observed.mean, each.observed.std_dev, each.predicted.mean, each.predicted.std_dev})
        row << value;
      row.end();
    }
  }
  return text;
}

}  // namespace talus::calibration
