#include "talus/calibration/result_figures.hpp"

#include <algorithm>
#include <cmath>

#include "talus/calibration/mixture.hpp"
#include "talus/calibration/redraw.hpp"
#include "talus/core/random.hpp"

namespace talus::calibration {

namespace {

constexpr int histogram_bins = 20;
constexpr int band_places = 80;

std::vector<double> weights_of(const CalibrationResult& result) {
  std::vector<double> weights;
  for (const SetResult& set : result.sets) weights.push_back(set.weight);
  return weights;
}

DistributionBand band_of(std::size_t group, Eigen::Index feature, const std::vector<double>& weights,
                         const std::vector<double>& places, const PreparedStudy& study,
                         const CalibrationResult& result) {
  constexpr std::size_t replicas = 200;
  constexpr auto stream = static_cast<Stream>(1400);
  const std::uint64_t seed = study.study().seed;
  const Sample& observed = study.groups()[group].sample;
  std::vector<double> cumulated;
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    cumulated.push_back(sum += result.sets[k].samples[group].rows.rows() > 0 ? weights[k] : 0);
  }
  std::vector<std::vector<double>> shares(places.size());
  std::vector<Eigen::Index> rows;
  for (std::size_t r = 0; r < replicas; ++r) {
    const double pick = uniform_pair(seed, r, stream, 0)[0] * sum;
    const auto set = static_cast<std::size_t>(std::ranges::upper_bound(cumulated, pick) - cumulated.begin());
    const Sample& sample = result.sets[std::min(set, cumulated.size() - 1)].samples[group];
    const Redraw redraw(sample, observed);
    if (!redraw.has_at_least(1)) continue;
    redraw.rows(seed, static_cast<std::uint32_t>(r), rows);
    std::vector<double> drawn;
    for (const Eigen::Index row : rows) drawn.push_back(sample.rows(row, feature));
    std::ranges::sort(drawn);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto below = std::ranges::upper_bound(drawn, places[k]) - drawn.begin();
      shares[k].push_back(static_cast<double>(below) / static_cast<double>(drawn.size()));
    }
  }
  DistributionBand band;
  for (std::vector<double>& each : shares) {
    std::ranges::sort(each);
    const auto at = [&](double q) {
      return each.empty() ? 0 : each[static_cast<std::size_t>(q * static_cast<double>(each.size() - 1))];
    };
    band.low.push_back(at(0.05));
    band.middle.push_back(at(0.5));
    band.high.push_back(at(0.95));
  }
  return band;
}

}  // namespace

ParameterHistogram histogram_of(std::size_t parameter, const PreparedStudy& study, const CalibrationResult& result) {
  const project::Prior& prior = study.parameters()[parameter].prior;
  const double least = prior.value(0.001), most = prior.value(0.999);
  const double width = (most - least) / histogram_bins;
  ParameterHistogram histogram;
  for (int b = 0; b <= histogram_bins; ++b) histogram.edges.push_back(least + b * width);
  for (int b = 0; b < histogram_bins; ++b) {
    const auto at = static_cast<std::size_t>(b);
    histogram.prior.push_back(prior.share_below(histogram.edges[at + 1]) - prior.share_below(histogram.edges[at]));
  }
  histogram.posterior.resize(histogram_bins, 0);
  for (const SetResult& set : result.sets) {
    const double place = std::clamp((set.values[parameter] - least) / width, 0.0, histogram_bins - 1.0);
    histogram.posterior[static_cast<std::size_t>(place)] += set.weight;
  }
  return histogram;
}

double correlation_of(std::size_t a, std::size_t b, const CalibrationResult& result) {
  double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  for (const SetResult& set : result.sets) {
    ma += set.weight * set.values[a];
    mb += set.weight * set.values[b];
  }
  for (const SetResult& set : result.sets) {
    const double da = set.values[a] - ma, db = set.values[b] - mb;
    aa += set.weight * da * da;
    bb += set.weight * db * db;
    ab += set.weight * da * db;
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

PredictedDistribution prediction_of(std::size_t group, std::size_t feature, const PreparedStudy& study,
                                    const CalibrationResult& result) {
  constexpr std::size_t mixed = 1000;
  const auto f = static_cast<Eigen::Index>(feature);
  const auto column = study.groups()[group].sample.rows.col(f);
  const std::vector<double> weights = weights_of(result);
  const Eigen::MatrixXd predicted =
      mixture_of(result.sets, weights, group, rows_like(study.groups()[group].sample, mixed)).rows;
  if (predicted.rows() == 0) return {};
  PredictedDistribution prediction;
  prediction.observed.assign(column.begin(), column.end());
  std::ranges::sort(prediction.observed);
  const double least = std::min(prediction.observed.front(), predicted.col(f).minCoeff());
  const double most = std::max(prediction.observed.back(), predicted.col(f).maxCoeff());
  for (int k = 0; k <= band_places; ++k) prediction.at.push_back(least + (most - least) * k / band_places);
  std::vector<double> prior;
  for (const SetResult& set : result.sets) prior.push_back(set.round == 0 ? 1 : 0);
  prediction.prior = band_of(group, f, prior, prediction.at, study, result);
  prediction.posterior = band_of(group, f, weights, prediction.at, study, result);
  return prediction;
}

}  // namespace talus::calibration
