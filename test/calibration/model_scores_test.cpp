// Models compared and pooled by their predictions of what was held out.

#include "talus/calibration/model_scores.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/dice.hpp"

namespace talus::calibration {
namespace {

/// Scores of 60 rocks: common to all models, about `mean`, with a part of the model's own.
std::vector<HeldOut> parts(double mean, double own, std::uint64_t seed, Moments predicted = {}) {
  testing_tools::Dice common(5), of_model(seed);
  std::vector<HeldOut> all(2);
  for (HeldOut& part : all) {
    part.name = "site";
    part.features = {{"stops", {"runout", "m"}, {50, 10}, predicted, 30, 27}};
    for (int rock = 0; rock < 30; ++rock)
      part.scores.push_back({mean + common.between(-0.5, 0.5) + of_model.between(-own, own), 1});
  }
  return all;
}

TEST(ModelScores, TellModelsApartByTheirDifferences) {
  const std::vector<std::vector<HeldOut>> models{parts(1, 0.05, 1), parts(1.1, 0.05, 2), parts(1, 0.05, 3)};
  const std::vector<ModelScore> scores = compare_models(models, 7);
  ASSERT_EQ(scores.size(), 3u);
  double weights = 0;
  for (const ModelScore& each : scores) {
    EXPECT_LT(*each.score.low, each.score.value);
    EXPECT_GT(*each.score.high, each.score.value);
    weights += each.weight;
  }
  EXPECT_NEAR(weights, 1, 1e-12);
  // The intervals of the scores overlap, since all models share the chance of the rocks. That of the difference does
  // not hold 0.
  EXPECT_GT(*scores[0].score.high, *scores[1].score.low);
  EXPECT_GT(*scores[1].difference.low, 0);
  EXPECT_LT(scores[1].weight, 0.01);
  const ModelScore& tied = scores[0].difference.value > 0 ? scores[0] : scores[2];
  EXPECT_LE(*tied.difference.low, 0);
  EXPECT_GT(tied.weight, 0.01);
}

TEST(ModelScores, CountRocksByTheirObservations) {
  std::vector<HeldOut> one(1), other(1);
  one[0].scores = {{4, 4}, {3, 1}};    // a mean of 7/5
  other[0].scores = {{8, 4}, {1, 1}};  // 9/5
  const std::vector<std::vector<HeldOut>> models{one, other};
  const std::vector<ModelScore> scores = compare_models(models, 1);
  EXPECT_DOUBLE_EQ(scores[0].score.value, 1.4);
  EXPECT_DOUBLE_EQ(scores[1].difference.value, 1.8 - 1.4);
  EXPECT_EQ(scores[0].difference.value, 0);
}

TEST(ModelScores, PoolTheirPredictions) {
  const std::vector<std::vector<HeldOut>> models{parts(1, 0, 1, {40, 6}), parts(1, 0, 2, {60, 8})};
  const std::vector<ModelScore> scores{{.score = {}, .difference = {}, .weight = 0.25},
                                       {.score = {}, .difference = {}, .weight = 0.75}};
  const std::vector<HeldOut> pool = pooled(models, scores);
  ASSERT_EQ(pool.size(), 2u);
  const Moments& mixed = pool[0].features[0].predicted;
  EXPECT_DOUBLE_EQ(mixed.mean, 55);
  // The mean of the variances, and the variance of the means.
  EXPECT_NEAR(mixed.std_dev, std::sqrt(0.25 * 36 + 0.75 * 64 + 0.25 * 0.75 * 400), 1e-12);
  EXPECT_TRUE(pooled_table(pool).starts_with(
      "held_out,observations,quantity,unit,observed_mean,observed_std_dev,predicted_mean,predicted_std_dev\n"
      "site,stops,runout,m,50,10,55,"));
}

TEST(ModelScores, AreRowsOfATable) {
  const std::vector<ModelScore> scores{{{1.5, 1, 2}, {0, 0, 0}, 0.75}, {{2, 1.5, 3}, {0.5, -0.25, 1}, 0.25}};
  const std::vector<ModelFacts> models{{"lumped mass", "model-1", 3, 50}, {"rigid sphere", "model-2", 4, 60}};
  EXPECT_EQ(models_table(models, scores),
            "model,folder,held_out_score,held_out_low,held_out_high,difference,difference_low,difference_high,weight,"
            "prior_score,effective_sets\n"
            "lumped mass,model-1,1.5,1,2,0,0,0,0.75,3,50\n"
            "rigid sphere,model-2,2,1.5,3,0.5,-0.25,1,0.25,4,60\n");
}

}  // namespace
}  // namespace talus::calibration
