#include "talus/calibration/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/calibration/coverage.hpp"
#include "talus/calibration/reach.hpp"
#include "talus/calibration/touched_ground.hpp"
#include "talus/project/values.hpp"

namespace talus::calibration {

namespace {

using project::counted;

constexpr double much_at_a_bound = 0.25;

class Doubts {
 public:
  Doubts(const PreparedStudy& study, CalibrationResult& result) : study_(study), result_(result) {}

  void warn(std::string where, std::string what, std::string why, std::string hint) {
    result_.warnings.add({Severity::warning, study_.study().file.string(), 0, std::move(where), std::move(what),
                          std::move(why), std::move(hint)});
  }

  void of_reach() {
    const bool any = std::ranges::any_of(result_.sets, [](const SetResult& set) { return agrees(set); });
    const std::vector<Unreached> out_of_reach = unreached(study_, result_.sets);
    for (const Unreached& each : out_of_reach)
      warn(each.where, each.what, "", "Widen the ranges, or let other parameters vary");
    if (!any && out_of_reach.empty()) {
      warn("", "no set agrees with the observations", "all scores are above what chance alone gives",
           "Let other parameters vary, or compare another model");
    }
    if (result_.misfit > 1) {
      warn("", "the posterior does not reproduce the observed distribution",
           fmt::format("the likelihood was widened by the factor {:.2g}, so that the posterior is not too narrow",
                       std::sqrt(result_.misfit)),
           "Compare the observed and predicted distributions in the report");
    }
  }

  void of_parameters() {
    for (std::size_t k = 0; k < study_.parameters().size(); ++k) {
      const study::Parameter& parameter = study_.parameters()[k];
      const Learned learned = learned_about(k, study_, result_);
      const std::string where = fmt::format("parameter \"{}\"", parameter.name);
      if (learned.is_nothing()) {
        warn(where, "the observations say nothing about this one", "its posterior is as wide as its prior", "");
      } else if (learned.at_least > much_at_a_bound || learned.at_most > much_at_a_bound) {
        warn(where,
             fmt::format("its posterior is at the {} end of its prior, {:.4g}",
                         learned.at_least > learned.at_most ? "lower" : "upper",
                         parameter.prior.value(learned.at_least > learned.at_most ? 0 : 1)),
             "", "Widen the range, if the parameter may be there");
      }
    }
  }

  void of_effort() {
    if (result_.effective_sets >= enough_effective_sets) return;
    warn("",
         fmt::format("the posterior is as accurate as {}",
                     counted(static_cast<std::size_t>(std::lround(result_.effective_sets)), "set", "sets")),
         fmt::format("expected at least {:g}", enough_effective_sets),
         "Increase most_draws (the same command continues), or rocks (their chance makes likelihoods uneven)");
  }

  /// Compares the scores of two halves of the rocks of the best set: of each release every other rock.
  void of_seed(const std::vector<GroupComparison>& comparisons) {
    const SetResult& best = result_.sets[result_.best];
    for (std::size_t g = 0; g < comparisons.size(); ++g) {
      const std::vector<Eigen::Index> first = best.samples[g].first_rows();
      if (first.size() <= 4) continue;
      std::vector<Eigen::Index> even, odd;
      std::vector<bool> is_odd(best.samples[g].stratum_count());
      for (std::size_t rock = 0; rock + 1 < first.size(); ++rock) {
        const std::size_t release =
            best.samples[g].has_strata() ? best.samples[g].strata[static_cast<std::size_t>(first[rock])] : 0;
        std::vector<Eigen::Index>& half = is_odd[release] ? odd : even;
        is_odd[release].flip();
        for (Eigen::Index row = first[rock]; row < first[rock + 1]; ++row) half.push_back(row);
      }
      const double change = std::abs(comparisons[g].distance(best.samples[g].part(even)) -
                                     comparisons[g].distance(best.samples[g].part(odd)));
      // (Of releases, the distance is a mean score, whose least value is not 0.)
      const double by_chance = study_.groups()[g].sample.has_strata()
                                   ? std::max(best.chances[g] - best.distances[g], 0.1 * best.chances[g])
                                   : best.chances[g];
      if (change <= by_chance) continue;
      warn(study_.groups()[g].name,
           fmt::format("the score of the best set changes by {:.2g} from one half of its rocks to the other", change),
           fmt::format("chance alone gives the observations {:.2g}", by_chance), "Increase rocks");
    }
  }

  void of_dependence() {
    constexpr double few = 0.02;
    const std::vector<Dependence> dependences = dependence(study_, result_.sets[result_.best].values);
    for (std::size_t k = 0; k < dependences.size(); ++k) {
      const Dependence& each = dependences[k];
      const std::string where = fmt::format("parameter \"{}\"", study_.parameters()[k].name);
      const std::string ground = ground_of(study_.parameters()[k].name);
      if (static_cast<double>(each.rocks) < few * static_cast<double>(each.all)) {
        warn(where,
             fmt::format("{} of {} rocks of the best set depend{} on it", each.rocks, each.all,
                         each.rocks == 1 ? "s" : ""),
             ground.empty() ? "" : fmt::format("hardly any rock touches {}", ground),
             each.rocks == 0 || ground.empty() ? "Leave it out" : "Observe rocks that do, or leave it out");
      } else if (static_cast<double>(each.near) < few * static_cast<double>(each.all_near)) {
        warn(where,
             fmt::format("{} of the {} simulated rocks that come nearest to the observed ones depend{} on it",
                         each.near, each.all_near, each.near == 1 ? "s" : ""),
             ground.empty() ? "" : fmt::format("it seems that no observed rock touched {}", ground),
             "Its values follow from rocks that were not observed; observe some there, or leave it out");
      }
    }
  }

  /// What the zones leave out.
  void of_zones() {
    for (const ObservedGroup& group : study_.groups()) {
      if (group.kind != ObservationKind::zones || group.zones.has_elsewhere) continue;
      const auto outcome = best_outcome(group.site);
      double all = 0, within = 0;
      for (const study::RockEnd& end : outcome.ends) {
        const double own = group.zones.amount_of(end);
        all += own;
        if (end.reason != EndReason::left_model && group.zones.of(end.end.xy()) < group.zones.list.size()) {
          within += own;
        }
      }
      constexpr double little = 0.9;
      if (within >= little * all) continue;
      warn(group.name,
           fmt::format("the zones hold {:.0f} % of what comes to rest with the best set", 100 * within / all),
           "the rest is not compared, since it is not known how much was released",
           "Write released = the volume or count of all rocks, if it is known");
    }
  }

  void of_predictions() {
    double posterior = 0, prior = 0;
    for (const HeldOut& held : result_.held_out) {
      posterior += static_cast<double>(held.observations) * held.posterior;
      prior += static_cast<double>(held.observations) * held.prior;
    }
    if (posterior >= prior && prior > 0) {
      warn("", "observations that were held out are predicted no better than with the prior",
           fmt::format("the score is {:.3g} times the prior's", posterior / prior),
           "This posterior predicts nothing; let other parameters vary, or observe more");
    }
    for (const HeldOutCoverage& each : coverage_of(result_.held_out)) {
      if (!each.is_too_narrow()) continue;
      warn(each.group,
           fmt::format("{} of {} observations that were held out lie{} within the central 90 % of their predicted {}",
                       each.within_90, each.observations, each.within_90 == 1 ? "s" : "", each.feature.name),
           fmt::format("expected at least {}: predictions are too narrow", each.min_expected),
           "Let a spread vary, such as roughness_deg or the std_dev of a property, or compare models with [[model]]");
    }
  }

  void of_ends() {
    // (A rock that leaves the model is compared at the edge.)
    for (std::size_t site = 0; site < study_.sites().size(); ++site) {
      const auto outcome = study_.prepared().run(site, result_.sets[result_.best].values);
      const auto left = std::ranges::count(outcome.ends, EndReason::left_model, &study::RockEnd::reason);
      const double share = static_cast<double>(left) / static_cast<double>(outcome.ends.size());
      constexpr double many = 0.02;
      if (share <= many) continue;
      warn(study_.study().sites[site].name,
           fmt::format("{:.0f} % of the rocks of the best set leave the model", 100 * share),
           "they are compared as if they stopped at its edge", "Extend the terrain");
    }
  }

 private:
  [[nodiscard]] study::SetOutcome best_outcome(std::size_t site) const {
    return study_.prepared().run(site, result_.sets[result_.best].values);
  }

  const PreparedStudy& study_;
  CalibrationResult& result_;
};

}  // namespace

Learned learned_about(std::size_t parameter, const PreparedStudy& study, const CalibrationResult& result) {
  const project::Prior& prior = study.parameters()[parameter].prior;
  constexpr double end = 0.05;
  double mean = 0, square = 0;
  Learned learned;
  for (const SetResult& set : result.sets) {
    if (!(set.weight > 0)) continue;
    const double u = prior.share_below(set.values[parameter]);
    mean += set.weight * u;
    square += set.weight * u * u;
    if (u < end) learned.at_least += set.weight;
    if (u > 1 - end) learned.at_most += set.weight;
  }
  learned.width = std::sqrt(std::max(square - mean * mean, 0.0) * 12);
  return learned;
}

void add_doubts(const PreparedStudy& study, const std::vector<GroupComparison>& comparisons,
                CalibrationResult& result) {
  Doubts doubts(study, result);
  doubts.of_reach();
  doubts.of_parameters();
  doubts.of_effort();
  doubts.of_seed(comparisons);
  doubts.of_dependence();
  doubts.of_zones();
  doubts.of_predictions();
  doubts.of_ends();
}

}  // namespace talus::calibration
