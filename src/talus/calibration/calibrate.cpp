#include "talus/calibration/calibrate.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "talus/calibration/coverage.hpp"
#include "talus/calibration/doubts.hpp"
#include "talus/calibration/group_comparison.hpp"
#include "talus/calibration/mixture.hpp"
#include "talus/calibration/reach.hpp"
#include "talus/calibration/smoothed_likelihood.hpp"
#include "talus/core/random.hpp"
#include "talus/core/stop.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;

constexpr std::size_t sets_at_once = 96;  // between calls of `finished`
constexpr double impossible = -std::numeric_limits<double>::infinity();
constexpr auto fold_stream = static_cast<Stream>(1300);

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
      comparisons_.emplace_back(group, study.study().seed);
      keeps_marks_ = keeps_marks_ || group.kind == ObservationKind::marks;
      learns_from_.push_back(true);
    }
  }

  CalibrationResult calibrate() {
    const std::size_t first = first_round();
    run_round(0, first);
    expect_reach(study_, result_.sets);
    run_later_rounds();
    weigh();
    hold_out();
    say("checking the results");
    add_doubts(study_, comparisons_, result_);
    return std::move(result_);
  }

 private:
  /// The sets of each round after the first.
  [[nodiscard]] std::size_t later_round() const {
    const auto all = static_cast<std::size_t>(study_.study().draws),
               rounds = static_cast<std::size_t>(study_.study().rounds);
    return rounds > 1 ? all / 2 / (rounds - 1) : 0;
  }
  [[nodiscard]] std::size_t first_round() const {
    const auto all = static_cast<std::size_t>(study_.study().draws),
               rounds = static_cast<std::size_t>(study_.study().rounds);
    return all - later_round() * (rounds - 1);
  }

  void run_later_rounds() {
    const auto rounds = static_cast<std::size_t>(study_.study().rounds);
    const std::size_t most = study_.study().most_sets(), later = later_round();
    for (std::size_t round = 1; round < rounds; ++round) run_round(round, later);
    for (std::size_t round = rounds; is_too_coarse() && result_.sets.size() < most && later > 0; ++round)
      run_round(round, std::min(later, most - result_.sets.size()));
  }

  /// A calibration from the observations of the other sites alone. Its first round, which no observation changes, is
  /// the one of this calibration; all that follows from observations (misfit, noise, later rounds) is its own.
  [[nodiscard]] Calibration without_site(std::size_t site, const CalibrationOptions& options) const {
    Calibration others(study_, options);
    for (std::size_t g = 0; g < study_.groups().size(); ++g) others.learns_from_[g] = study_.groups()[g].site != site;
    static_cast<void>(others.sampler_.next_round(first_round()));
    const auto begin = result_.sets.begin();
    others.result_.sets.assign(begin, begin + static_cast<std::ptrdiff_t>(first_round()));
    others.fit_misfit();
    others.run_later_rounds();
    return others;
  }

  void say(const std::string& what) const {
    if (options_.phase) options_.phase(what);
  }

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
      set.chances.resize(study_.groups().size());
      result_.sets.push_back(std::move(set));
    }
    for (std::size_t k = first; k < result_.sets.size(); k += sets_at_once) {
      run_batch(k, std::min(k + sets_at_once, result_.sets.size()));
    }
    fit_misfit();
  }

  /// Whether the posterior stands on too few sets.
  [[nodiscard]] bool is_too_coarse() const { return effective_size(sampler_.weights()) < enough_effective_sets; }

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
    std::vector<study::ParameterSet> values;
    for (const std::size_t k : unknown) values.push_back(result_.sets[k].values);
    for (std::size_t site = 0; site < study_.sites().size() && !unknown.empty(); ++site) {
      study_.prepared().run(site, values, {.threads = options_.threads, .keep_marks = keeps_marks_},
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
    if (options_.progress)
      options_.progress(last, std::max(static_cast<std::size_t>(study_.study().draws), result_.sets.size()));
  }

  /// The comparison of one group; called by several threads for different sets.
  void compare(SetResult& set, std::size_t g) const {
    const Compared compared = comparisons_[g].compare(set.samples[g]);
    set.densities[g] = compared.density;
    set.distances[g] = compared.distance;
    set.chances[g] = compared.chance;
  }

  static void add_up(SetResult& set) {
    set.score =
        std::accumulate(set.distances.begin(), set.distances.end(), 0.0) / static_cast<double>(set.distances.size());
  }

  /// With the variances of all summaries increased by a factor.
  [[nodiscard]] double log_likelihood(const SetResult& set, double misfit) const {
    double sum = 0;
    for (std::size_t g = 0; g < set.densities.size(); ++g) {
      if (learns_from_[g])
        sum += options_.likelihood_power * study_.groups()[g].weight * widened(set.densities[g], misfit);
    }
    return sum;
  }

  static double widened(const LogDensity& density, double misfit) {
    if (!std::isfinite(density.value)) return impossible;
    return density.value + 0.5 * density.squared_distance - 0.5 * density.squared_distance / misfit;
  }
  [[nodiscard]] double widened(const LogDensity& density) const { return widened(density, result_.misfit); }

  /// Weighs the sets with variances of summaries that are increased by the least factor with which the posterior's
  /// squared distance from the observations is one that chance gives. (The dispersion of a quasi-likelihood: P.
  /// McCullagh, J. A. Nelder, "Generalized linear models", 2nd ed. (1989), section 9.2.)
  void fit_misfit() {
    double summaries = 0;
    for (std::size_t g = 0; g < comparisons_.size(); ++g)
      if (learns_from_[g]) summaries += static_cast<double>(comparisons_[g].summary_count());
    constexpr double improbable = 0.99;
    const double most = boost::math::quantile(boost::math::chi_squared(summaries), improbable);
    constexpr int tries = 20;
    result_.misfit = 1;
    weigh_with_misfit();
    for (int k = 1; k < tries && squared_distance() > most * result_.misfit; ++k) {
      result_.misfit = squared_distance() / summaries;
      weigh_with_misfit();
    }
  }

  void weigh_with_misfit() {
    std::vector<double> likelihoods;
    for (SetResult& set : result_.sets) likelihoods.push_back(set.log_likelihood = log_likelihood(set, result_.misfit));
    const SmoothedLikelihoods smoothed = smoothed_likelihoods(sampler_.places(), likelihoods);
    for (std::size_t k = 0; k < result_.sets.size(); ++k) result_.sets[k].smoothed_log_likelihood = smoothed.values[k];
    sampler_.set(smoothed.values);
  }

  /// Of the observed summaries from those of the posterior's sets: the mean [standard deviations, squared].
  [[nodiscard]] double squared_distance() const {
    const std::vector<double> weights = sampler_.weights();
    double sum = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      if (!(weights[k] > 0)) continue;
      for (std::size_t g = 0; g < comparisons_.size(); ++g)
        if (learns_from_[g]) sum += weights[k] * result_.sets[k].densities[g].squared_distance;
    }
    return sum;
  }

  void weigh() {
    const std::vector<double> weights = sampler_.weights();
    for (std::size_t k = 0; k < weights.size(); ++k) {
      result_.sets[k].weight = weights[k];
      if (result_.sets[k].score < result_.sets[result_.best].score) result_.best = k;
    }
    result_.effective_sets = effective_size(weights);
    result_.likelihood_noise = simulation_noise(weights);
    result_.thresholds = result_.sets[result_.best].chances;
  }

  /// The logarithm of the likelihood from half of the rocks has twice the variance by chance, and the difference of two
  /// halves four times that of the whole. Its mean over sets is what all have in common and does not count.
  [[nodiscard]] std::optional<double> simulation_noise(const std::vector<double>& weights) const {
    constexpr std::size_t most = 60;  // of the sets with the greatest weights
    std::vector<std::size_t> sets(weights.size());
    std::iota(sets.begin(), sets.end(), std::size_t{0});
    std::ranges::stable_sort(sets, std::greater{}, [&](std::size_t k) { return weights[k]; });
    sets.resize(std::min(sets.size(), most));
    Eigen::VectorXd differences = Eigen::VectorXd::Zero(static_cast<Index>(sets.size()));
    tbb::parallel_for(std::size_t{0}, sets.size(), [&](std::size_t i) {
      for (std::size_t g = 0; g < comparisons_.size(); ++g) {
        const ObservedGroup& group = study_.groups()[g];
        const auto [even, odd] = halves(result_.sets[sets[i]].samples[g]);
        differences[static_cast<Index>(i)] += group.weight * (widened(comparisons_[g].density(even, group.sample)) -
                                                              widened(comparisons_[g].density(odd, group.sample)));
      }
    });
    if (!differences.allFinite() || sets.size() < 2) return std::nullopt;
    return moments_of(differences).std_dev / 2;
  }

  /// Every other rock of each stratum.
  [[nodiscard]] static std::pair<Sample, Sample> halves(const Sample& sample) {
    const std::vector<Index> first = sample.first_rows();
    std::vector<std::size_t> rocks(sample.stratum_count());
    std::pair<std::vector<Index>, std::vector<Index>> rows;
    for (std::size_t rock = 0; rock + 1 < first.size(); ++rock) {
      const std::size_t stratum = sample.has_strata() ? sample.strata[static_cast<std::size_t>(first[rock])] : 0;
      auto& half = rocks[stratum]++ % 2 == 0 ? rows.first : rows.second;
      for (Index row = first[rock]; row < first[rock + 1]; ++row) half.push_back(row);
    }
    return {sample.part(rows.first), sample.part(rows.second)};
  }

  void hold_out() {
    if (study_.study().hold_out_sites) {
      for (std::size_t site = 0; site < study_.sites().size(); ++site) hold_out_site(site);
    } else {
      for (std::int64_t fold = 0; fold < study_.study().folds; ++fold) hold_out_fold(fold);
    }
  }

  /// The fold of each rock of a group, by a random permutation: folds differ by one rock at most.
  [[nodiscard]] std::pair<std::vector<Index>, std::vector<Index>> split(std::size_t g, std::int64_t fold) const {
    const std::vector<Index> first = study_.groups()[g].sample.first_rows();
    const std::uint64_t n = first.size() - 1;
    const auto key = philox(study_.study().seed, g, static_cast<std::uint32_t>(fold_stream), 0);
    std::pair<std::vector<Index>, std::vector<Index>> parts;  // rows learned from, held out
    for (std::uint64_t rock = 0; rock < n; ++rock) {
      const auto own = static_cast<std::int64_t>(permuted(rock, n, {key[0], key[1]})) % study_.study().folds;
      for (Index row = first[rock]; row < first[rock + 1]; ++row)
        (own == fold ? parts.second : parts.first).push_back(row);
    }
    return parts;
  }

  void hold_out_fold(std::int64_t fold) {
    stop_point();
    say(fmt::format("predicting observations that were held out: fold {} of {}", fold + 1, study_.study().folds));
    std::vector<Sample> learned, predicted;
    for (std::size_t g = 0; g < study_.groups().size(); ++g) {
      const auto [train, test] = split(g, fold);
      learned.push_back(study_.groups()[g].sample.part(train));
      predicted.push_back(study_.groups()[g].sample.part(test));
    }
    std::vector<double> likelihoods(result_.sets.size(), 0);
    tbb::parallel_for(std::size_t{0}, result_.sets.size(), [&](std::size_t k) {
      for (std::size_t g = 0; g < study_.groups().size(); ++g) {
        if (learned[g].rows.rows() == 0) continue;
        const LogDensity density = comparisons_[g].density(result_.sets[k].samples[g], learned[g]);
        likelihoods[k] += study_.groups()[g].weight * widened(density);
      }
    });
    std::vector<std::optional<Sample>> constant;
    for (Sample& part : learned) {
      part.strata.clear();  // other rocks of the same release may not be there
      constant.push_back(part.rows.rows() > 0 ? std::optional(std::move(part)) : std::nullopt);
    }
    score_prediction(fmt::format("fold {}", fold + 1), likelihoods, predicted, constant);
  }

  void hold_out_site(std::size_t site) {
    say(fmt::format("predicting observations that were held out: site {} of {}", site + 1, study_.sites().size()));
    std::vector<Sample> predicted;
    std::vector<std::optional<Sample>> constant;
    for (const ObservedGroup& group : study_.groups()) {
      predicted.push_back(group.site == site ? group.sample : group.sample.part({}));
      constant.push_back(observed_elsewhere(group));
    }
    // Sets of other calibrations have numbers of their own.
    const std::size_t first = (site + 1) << 40U;
    CalibrationOptions options{.threads = options_.threads, .likelihood_power = options_.likelihood_power};
    if (options_.known) options.known = [&, first](std::size_t set) { return options_.known(first + set); };
    if (options_.finished)
      options.finished = [&, first](std::size_t set, const std::vector<SetResult>& sets) {
        options_.finished(first + set, sets);
      };
    Calibration others = without_site(site, options);
    std::vector<double> likelihoods;
    for (const SetResult& set : others.result_.sets) likelihoods.push_back(set.log_likelihood);
    others.score_prediction(study_.study().sites[site].name, likelihoods, predicted, constant);
    for (HeldOut& held : others.result_.held_out) result_.held_out.push_back(std::move(held));
  }

  /// The same quantities observed at other sites. Zones are never the same.
  [[nodiscard]] std::optional<Sample> observed_elsewhere(const ObservedGroup& group) const {
    std::vector<Eigen::VectorXd> rows;
    for (const ObservedGroup& other : study_.groups()) {
      if (other.site == group.site || other.kind != group.kind || other.kind == ObservationKind::zones ||
          other.features.size() != group.features.size()) {
        continue;
      }
      for (Index row = 0; row < other.sample.rows.rows(); ++row) rows.emplace_back(other.sample.rows.row(row));
    }
    if (rows.empty()) return std::nullopt;
    Sample joined;
    joined.rows.resize(static_cast<Index>(rows.size()), group.sample.rows.cols());
    for (std::size_t k = 0; k < rows.size(); ++k) joined.rows.row(static_cast<Index>(k)) = rows[k].transpose();
    return joined;
  }

  /// `likelihoods`: of all sets, as they were simulated.
  void score_prediction(std::string name, const std::vector<double>& likelihoods, const std::vector<Sample>& predicted,
                        const std::vector<std::optional<Sample>>& constant) {
    constexpr std::size_t rows = 1000, of_release = 200;  // of a mixture, and of each release at least
    const std::vector<double> posterior = sampler_.weights(smoothed_likelihoods(sampler_.places(), likelihoods).values);
    const std::vector<double> prior = sampler_.weights(std::vector<double>(result_.sets.size(), 0));
    HeldOut held;
    held.name = std::move(name);
    double with_constant = 0;
    for (std::size_t g = 0; g < predicted.size(); ++g) {
      const auto count = static_cast<double>(predicted[g].rows.rows());
      if (count == 0) continue;
      held.observations += static_cast<std::size_t>(count);
      const auto score = [&](const Sample& of) { return count * comparisons_[g].score(of, predicted[g]); };
      std::vector<std::size_t> wanted = rows_like(predicted[g], rows);
      const Sample shown = mixture_of(result_.sets, posterior, g, wanted);
      for (std::size_t& each : wanted) each = each > 0 ? std::max(each, of_release) : 0;
      const Sample forecast = mixture_of(result_.sets, posterior, g, wanted);
      for (std::size_t f = 0; f < study_.groups()[g].features.size(); ++f) {
        const auto column = static_cast<Index>(f);
        held.features.push_back({study_.groups()[g].name, study_.groups()[g].features[f],
                                 moments_of(predicted[g].rows.col(column)), moments_of(shown.rows.col(column)),
                                 static_cast<std::size_t>(count), within_90(predicted[g], forecast, column)});
      }
      held.posterior += score(forecast);
      const std::vector<Index> first = predicted[g].first_rows();
      for (std::size_t rock = 0; rock + 1 < first.size(); ++rock) {
        std::vector<Index> own(static_cast<std::size_t>(first[rock + 1] - first[rock]));
        std::iota(own.begin(), own.end(), first[rock]);
        const auto n = static_cast<double>(own.size());
        held.scores.push_back({n * comparisons_[g].score(forecast, predicted[g].part(own)), n});
      }
      held.prior += score(mixture_of(result_.sets, prior, g, wanted));
      if (!constant[g]) continue;
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
  std::vector<GroupComparison> comparisons_;  // by group
  std::vector<bool> learns_from_;             // by group
  CalibrationResult result_;
};

}  // namespace

CalibrationResult calibrate(const PreparedStudy& study, const CalibrationOptions& options) {
  return Calibration(study, options).calibrate();
}

bool agrees(const SetResult& set) {
  for (std::size_t g = 0; g < set.distances.size(); ++g) {
    if (set.distances[g] > set.chances[g]) return false;
  }
  return true;
}

}  // namespace talus::calibration
