#include "talus/calibration/calibrate.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "talus/calibration/comparison.hpp"
#include "talus/calibration/doubts.hpp"
#include "talus/core/random.hpp"
#include "talus/core/stop.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::size_t sets_at_once = 96;  // between calls of `finished`
constexpr double chance = 0.95;           // of the thresholds
constexpr double impossible = -std::numeric_limits<double>::infinity();
constexpr auto fold_stream = static_cast<Stream>(1300);

/// Some rows of the observations of a group.
struct Part {
  MatrixXd rows;
  std::vector<std::uint32_t> strata;
};

Part part_of(const ObservedGroup& group, const std::vector<Index>& which) {
  Part part;
  part.rows.resize(static_cast<Index>(which.size()), group.sample.rows.cols());
  for (std::size_t k = 0; k < which.size(); ++k) {
    part.rows.row(static_cast<Index>(k)) = group.sample.rows.row(which[k]);
    if (!group.sample.strata.empty()) part.strata.push_back(group.sample.strata[static_cast<std::size_t>(which[k])]);
  }
  return part;
}

Moments moments_of(const Eigen::VectorXd& values) {
  const double mean = values.mean();
  const auto n = static_cast<double>(values.size());
  return {mean, n > 1 ? std::sqrt((values.array() - mean).square().sum() / (n - 1)) : 0};
}

class Calibration {
 public:
  Calibration(const PreparedStudy& study, const CalibrationOptions& options)
      : study_(study), options_(options), sampler_(study.parameters().size(), study.study().seed) {
    for (const ObservedGroup& group : study.groups()) {
      comparisons_.emplace_back(group.sample.rows, group.kind != ObservationKind::values);
      keeps_marks_ = keeps_marks_ || group.kind == ObservationKind::marks;
      result_.thresholds.push_back(comparisons_.back().distance_by_chance(chance, study.study().seed));
      summaries_.push_back(summaries_of(group.sample.rows));
    }
  }

  CalibrationResult calibrate() {
    const auto all = static_cast<std::size_t>(study_.study().draws);
    const auto rounds = static_cast<std::size_t>(study_.study().rounds);
    result_.sets.reserve(all);
    for (std::size_t round = 0; round < rounds; ++round) {
      const std::size_t later = rounds > 1 ? all / 2 / (rounds - 1) : 0;
      const std::size_t count = round == 0 ? all - later * (rounds - 1) : later;
      run_round(round, count);
    }
    weigh();
    hold_out();
    add_doubts(study_, comparisons_, result_);
    return std::move(result_);
  }

 private:
  void run_round(std::size_t round, std::size_t count) {
    const std::vector<Place> places = sampler_.next_round(count);
    const std::size_t first = result_.sets.size();
    for (const Place& place : places) {
      SetResult set;
      set.round = round;
      set.values = study_.values_at(place);
      set.samples.resize(study_.groups().size());
      set.densities.resize(study_.groups().size());
      set.distances.resize(study_.groups().size());
      result_.sets.push_back(std::move(set));
    }
    for (std::size_t k = first; k < result_.sets.size(); k += sets_at_once) {
      run_batch(k, std::min(k + sets_at_once, result_.sets.size()));
    }
    result_.misfit = misfit();
    std::vector<double> likelihoods;
    for (SetResult& set : result_.sets) {
      set.log_likelihood = log_likelihood(set, result_.misfit);
      likelihoods.push_back(set.log_likelihood);
    }
    sampler_.set(likelihoods);
  }

  void run_batch(std::size_t first, std::size_t last) {
    stop_point();
    std::vector<std::size_t> unknown;
    for (std::size_t k = first; k < last; ++k) {
      auto known = options_.known ? options_.known(k) : std::nullopt;
      if (known) {
        result_.sets[k].samples = std::move(*known);
        for (std::size_t g = 0; g < study_.groups().size(); ++g) compare(result_.sets[k], g);
      } else {
        unknown.push_back(k);
      }
    }
    for (std::size_t site = 0; site < study_.sites().size() && !unknown.empty(); ++site) {
      const PreparedStudy::AtSite& here = study_.at_site(site);
      std::vector<study::ParameterSet> values;
      for (const std::size_t k : unknown) values.push_back(here.values(result_.sets[k].values));
      study_.sites()[site].run(here.numbers, values, {.threads = options_.threads, .keep_marks = keeps_marks_},
                               [&](std::size_t k, study::SetOutcome&& outcome) {
                                 SetResult& set = result_.sets[unknown[k]];
                                 for (std::size_t g = 0; g < study_.groups().size(); ++g) {
                                   if (study_.groups()[g].site != site) continue;
                                   set.samples[g] = simulated_sample(study_.groups()[g], outcome);
                                   compare(set, g);
                                 }
                               });
    }
    for (std::size_t k = first; k < last; ++k) add_up(result_.sets[k]);
    if (options_.finished && !unknown.empty()) {
      options_.finished(first, {result_.sets.begin() + static_cast<std::ptrdiff_t>(first),
                                result_.sets.begin() + static_cast<std::ptrdiff_t>(last)});
    }
    if (options_.progress) options_.progress(last, static_cast<std::size_t>(study_.study().draws));
  }

  /// The comparison of one group; called by several threads for different sets.
  void compare(SetResult& set, std::size_t g) const {
    const ObservedGroup& group = study_.groups()[g];
    const Sample& sample = set.samples[g];
    set.densities[g] = density_of(group, sample, summaries_[g], static_cast<std::size_t>(group.sample.rows.rows()),
                                  group.sample.strata);
    // Without a single value, the distance is that of a distribution infinitely far away: a large number.
    constexpr double nothing_arrives = 1e3;
    set.distances[g] = sample.rows.rows() == 0 ? nothing_arrives : comparisons_[g].distance(sample.rows);
  }

  [[nodiscard]] LogDensity density_of(const ObservedGroup& group, const Sample& sample, const Eigen::VectorXd& observed,
                                      std::size_t count, const std::vector<std::uint32_t>& strata) const {
    constexpr Index fewest = 5;  // values of which a distribution can be estimated
    if (sample.rows.rows() < fewest) return {impossible, std::numeric_limits<double>::infinity()};
    return log_density(observed, expected_summaries(sample, count, strata, group.features, study_.study().seed));
  }

  static void add_up(SetResult& set) {
    set.score =
        std::accumulate(set.distances.begin(), set.distances.end(), 0.0) / static_cast<double>(set.distances.size());
  }

  /// With the variances of all summaries increased by a factor.
  [[nodiscard]] double log_likelihood(const SetResult& set, double misfit) const {
    double sum = 0;
    for (std::size_t g = 0; g < set.densities.size(); ++g) {
      const auto& [value, squared] = set.densities[g];
      if (!std::isfinite(value)) return impossible;
      const double widened = value + 0.5 * squared - 0.5 * squared / misfit;
      sum += options_.likelihood_power * study_.groups()[g].weight * widened;
    }
    return sum;
  }

  /// The factor by which variances of summaries are increased, so that the nearest set agrees; 1: one does.
  [[nodiscard]] double misfit() const {
    double least = std::numeric_limits<double>::infinity();
    for (const SetResult& set : result_.sets) {
      double squared = 0;
      for (const LogDensity& density : set.densities) squared += density.squared_distance;
      least = std::min(least, squared);
    }
    double summaries = 0;
    for (const Eigen::VectorXd& each : summaries_) summaries += static_cast<double>(each.size());
    constexpr double improbable = 0.99;
    const double most = boost::math::quantile(boost::math::chi_squared(summaries), improbable);
    return least > most && std::isfinite(least) ? least / summaries : 1;
  }

  void weigh() {
    const std::vector<double> weights = sampler_.weights();
    for (std::size_t k = 0; k < weights.size(); ++k) {
      result_.sets[k].weight = weights[k];
      if (result_.sets[k].score < result_.sets[result_.best].score) result_.best = k;
    }
    result_.effective_sets = effective_size(weights);
  }

  void hold_out() {
    if (study_.study().hold_out_sites) {
      for (std::size_t site = 0; site < study_.sites().size(); ++site) hold_out_site(site);
    } else {
      for (std::int64_t fold = 0; fold < study_.study().folds; ++fold) hold_out_fold(fold);
    }
  }

  /// The fold of each row of a group, by a random permutation: folds differ in size by one at most.
  [[nodiscard]] std::pair<std::vector<Index>, std::vector<Index>> split(std::size_t g, std::int64_t fold) const {
    const auto n = static_cast<std::uint64_t>(study_.groups()[g].sample.rows.rows());
    const auto key = philox(study_.study().seed, g, static_cast<std::uint32_t>(fold_stream), 0);
    std::pair<std::vector<Index>, std::vector<Index>> parts;  // learned from, held out
    for (std::uint64_t row = 0; row < n; ++row) {
      const auto own = static_cast<std::int64_t>(permuted(row, n, {key[0], key[1]})) % study_.study().folds;
      (own == fold ? parts.second : parts.first).push_back(static_cast<Index>(row));
    }
    return parts;
  }

  void hold_out_fold(std::int64_t fold) {
    stop_point();
    std::vector<Part> learned, predicted;
    std::vector<Eigen::VectorXd> summaries;
    for (std::size_t g = 0; g < study_.groups().size(); ++g) {
      const auto [train, test] = split(g, fold);
      learned.push_back(part_of(study_.groups()[g], train));
      predicted.push_back(part_of(study_.groups()[g], test));
      summaries.push_back(train.empty() ? Eigen::VectorXd() : summaries_of(learned.back().rows));
    }
    std::vector<double> likelihoods(result_.sets.size(), 0);
    tbb::parallel_for(std::size_t{0}, result_.sets.size(), [&](std::size_t k) {
      for (std::size_t g = 0; g < study_.groups().size(); ++g) {
        const ObservedGroup& group = study_.groups()[g];
        const auto count = static_cast<std::size_t>(learned[g].rows.rows());
        if (count == 0) continue;
        const LogDensity density =
            density_of(group, result_.sets[k].samples[g], summaries[g], count, learned[g].strata);
        likelihoods[k] += group.weight * (density.value + 0.5 * density.squared_distance -
                                          0.5 * density.squared_distance / result_.misfit);
        if (!std::isfinite(density.value)) likelihoods[k] = impossible;
      }
    });
    std::vector<const MatrixXd*> constant;
    for (const Part& part : learned) constant.push_back(part.rows.rows() > 0 ? &part.rows : nullptr);
    score_prediction(fmt::format("fold {}", fold + 1), likelihoods, predicted, constant);
  }

  void hold_out_site(std::size_t site) {
    std::vector<Part> predicted;
    std::vector<MatrixXd> others(study_.groups().size());
    std::vector<const MatrixXd*> constant;
    for (std::size_t g = 0; g < study_.groups().size(); ++g) {
      const ObservedGroup& group = study_.groups()[g];
      predicted.push_back(group.site == site ? Part{group.sample.rows, group.sample.strata} : Part{});
      for (const ObservedGroup& other : study_.groups()) {
        if (other.site == site || other.kind != group.kind || other.features.size() != group.features.size()) continue;
        MatrixXd joined(others[g].rows() + other.sample.rows.rows(), other.sample.rows.cols());
        if (others[g].rows() > 0) joined.topRows(others[g].rows()) = others[g];
        joined.bottomRows(other.sample.rows.rows()) = other.sample.rows;
        others[g] = std::move(joined);
      }
    }
    for (const MatrixXd& each : others) constant.push_back(each.rows() > 0 ? &each : nullptr);
    std::vector<double> likelihoods;
    for (const SetResult& set : result_.sets) {
      double sum = 0;
      for (std::size_t g = 0; g < set.densities.size(); ++g) {
        const auto& [value, squared] = set.densities[g];
        if (study_.groups()[g].site == site) continue;
        sum += std::isfinite(value)
                   ? study_.groups()[g].weight * (value + 0.5 * squared - 0.5 * squared / result_.misfit)
                   : impossible;
      }
      likelihoods.push_back(sum);
    }
    score_prediction(study_.study().sites[site].name, likelihoods, predicted, constant);
  }

  void score_prediction(std::string name, const std::vector<double>& likelihoods, const std::vector<Part>& predicted,
                        const std::vector<const MatrixXd*>& constant) {
    constexpr std::size_t rows = 1000;  // of a mixture
    const std::vector<double> posterior = sampler_.weights(likelihoods);
    const std::vector<double> prior = sampler_.weights(std::vector<double>(result_.sets.size(), 0));
    HeldOut held;
    held.name = std::move(name);
    double with_constant = 0;
    for (std::size_t g = 0; g < predicted.size(); ++g) {
      const auto count = static_cast<double>(predicted[g].rows.rows());
      if (count == 0) continue;
      held.observations += static_cast<std::size_t>(count);
      const auto score = [&](const MatrixXd& forecast) {
        return count * comparisons_[g].score(forecast, predicted[g].rows);
      };
      const MatrixXd forecast = mixture_of(result_.sets, posterior, g, rows);
      held.posterior += score(forecast);
      for (Index f = 0; f < forecast.cols(); ++f) {
        held.features.push_back({study_.groups()[g].name, study_.groups()[g].features[static_cast<std::size_t>(f)],
                                 moments_of(predicted[g].rows.col(f)), moments_of(forecast.col(f))});
      }
      held.prior += score(mixture_of(result_.sets, prior, g, rows));
      if (constant[g] == nullptr) continue;
      held.constant = held.constant.value_or(0) + score(*constant[g]);
      with_constant += count;
    }
    if (held.observations == 0) return;
    held.posterior /= static_cast<double>(held.observations);
    held.prior /= static_cast<double>(held.observations);
    if (held.constant) held.constant = *held.constant / with_constant;
    result_.held_out.push_back(std::move(held));
  }

  const PreparedStudy& study_;
  const CalibrationOptions& options_;
  Sampler sampler_;
  bool keeps_marks_ = false;
  std::vector<Comparison> comparisons_;     // by group
  std::vector<Eigen::VectorXd> summaries_;  // of the observations, by group
  CalibrationResult result_;
};

}  // namespace

CalibrationResult calibrate(const PreparedStudy& study, const CalibrationOptions& options) {
  return Calibration(study, options).calibrate();
}

bool agrees(const SetResult& set, const CalibrationResult& result) {
  for (std::size_t g = 0; g < set.distances.size(); ++g) {
    if (set.distances[g] > result.thresholds[g]) return false;
  }
  return true;
}

MatrixXd mixture_of(const std::vector<SetResult>& sets, std::span<const double> weights, std::size_t group,
                    std::size_t count) {
  // Systematic resampling: row i is from the set at the share (i + 1/2) / count of the cumulated weights, and the rows
  // of a set are taken in turn.
  std::vector<std::pair<std::size_t, Index>> chosen;
  double below = 0, all = 0;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (sets[k].samples[group].rows.rows() > 0) all += weights[k];
  }
  constexpr std::uint64_t step = 7919;  // a prime: rocks of a set are spread over its seeders
  for (std::size_t k = 0; k < sets.size(); ++k) {
    const Index rows = sets[k].samples[group].rows.rows();
    if (rows == 0) continue;
    below += weights[k] / all;
    while (chosen.size() < count && (static_cast<double>(chosen.size()) + 0.5) / static_cast<double>(count) <= below) {
      chosen.emplace_back(k, static_cast<Index>(chosen.size() * step % static_cast<std::uint64_t>(rows)));
    }
  }
  MatrixXd mixture(static_cast<Index>(chosen.size()), sets.front().samples[group].rows.cols());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    mixture.row(static_cast<Index>(i)) = sets[chosen[i].first].samples[group].rows.row(chosen[i].second);
  }
  return mixture;
}

}  // namespace talus::calibration
