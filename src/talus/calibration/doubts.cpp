#include "talus/calibration/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::calibration {

namespace {

constexpr double fewest_effective_sets = 40;
constexpr double much_at_a_bound = 0.25;

class Doubts {
 public:
  Doubts(const PreparedStudy& study, CalibrationResult& result) : study_(study), result_(result) {}

  void warn(std::string where, std::string what, std::string why, std::string hint) {
    result_.warnings.add({Severity::warning, study_.study().file.string(), 0, std::move(where), std::move(what),
                          std::move(why), std::move(hint)});
  }

  void of_reach() {
    const bool any = std::ranges::any_of(result_.sets, [&](const SetResult& set) { return agrees(set, result_); });
    bool explained = false;
    for (std::size_t g = 0; g < study_.groups().size(); ++g) {
      const ObservedGroup& group = study_.groups()[g];
      for (Eigen::Index f = 0; f < group.sample.rows.cols(); ++f) {
        double most = -std::numeric_limits<double>::infinity(), least = -most;
        for (const SetResult& set : result_.sets) {
          if (set.samples[g].rows.rows() == 0) continue;
          most = std::max(most, set.samples[g].rows.col(f).maxCoeff());
          least = std::min(least, set.samples[g].rows.col(f).minCoeff());
        }
        const Feature& feature = group.features[static_cast<std::size_t>(f)];
        if (!std::isfinite(most)) {
          warn(group.name, "no set brings a rock to this line", "its observations say nothing about the parameters",
               "Widen the ranges, or check the line");
          explained = true;
          break;
        }
        const double observed_most = group.sample.rows.col(f).maxCoeff();
        const double observed_least = group.sample.rows.col(f).minCoeff();
        if (observed_most > most) {
          warn(group.name,
               fmt::format("no parameters within the ranges give a {} of more than {:.4g} {}; observed {:.4g} {}",
                           feature.name, most, feature.unit, observed_most, feature.unit),
               "", "Widen the ranges, or let other parameters vary");
          explained = true;
        }
        if (observed_least < least) {
          warn(group.name,
               fmt::format("no parameters within the ranges give a {} of less than {:.4g} {}; observed {:.4g} {}",
                           feature.name, least, feature.unit, observed_least, feature.unit),
               "", "Widen the ranges, or let other parameters vary");
          explained = true;
        }
      }
    }
    if (!any && !explained) {
      warn("", "no set agrees with the observations", "all scores are above what chance alone gives",
           "Let other parameters vary, or compare another model");
    }
    if (result_.misfit > 1) {
      warn("", "no set reproduces the observed distribution",
           fmt::format("the likelihood was widened by the factor {:.2g}, so that the posterior is not too narrow",
                       std::sqrt(result_.misfit)),
           "Compare the observed and predicted distributions in the report");
    }
  }

  void of_parameters() {
    for (std::size_t k = 0; k < study_.parameters().size(); ++k) {
      const SoughtParameter& parameter = study_.parameters()[k];
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
    if (result_.effective_sets >= fewest_effective_sets) return;
    warn("", fmt::format("the posterior is as accurate as {:.0f} sets", result_.effective_sets),
         fmt::format("expected at least {:g}", fewest_effective_sets), "Increase draws, or rounds");
  }

  /// Compares the scores of the even and the odd rocks of the best set.
  void of_seed(const std::vector<Comparison>& comparisons) {
    const SetResult& best = result_.sets[result_.best];
    for (std::size_t g = 0; g < comparisons.size(); ++g) {
      const Eigen::MatrixXd& rows = best.samples[g].rows;
      if (rows.rows() < 4) continue;
      Eigen::MatrixXd even((rows.rows() + 1) / 2, rows.cols()), odd(rows.rows() / 2, rows.cols());
      for (Eigen::Index k = 0; k < rows.rows(); ++k) (k % 2 == 0 ? even : odd).row(k / 2) = rows.row(k);
      const double change = std::abs(comparisons[g].distance(even) - comparisons[g].distance(odd));
      if (change <= result_.thresholds[g]) continue;
      warn(study_.groups()[g].name,
           fmt::format("the score of the best set changes by {:.2g} from one half of its rocks to the other", change),
           fmt::format("chance alone gives the observations {:.2g}", result_.thresholds[g]), "Increase rocks");
    }
  }

  void of_ends() {
    // (A rock that leaves the model is compared at the edge.)
    for (std::size_t site = 0; site < study_.sites().size(); ++site) {
      const auto& here = study_.at_site(site);
      const auto outcome = study_.sites()[site].run(here.numbers, here.values(result_.sets[result_.best].values));
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
  const PreparedStudy& study_;
  CalibrationResult& result_;
};

}  // namespace

Learned learned_about(std::size_t parameter, const PreparedStudy& study, const CalibrationResult& result) {
  const study::Prior& prior = study.parameters()[parameter].prior;
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

void add_doubts(const PreparedStudy& study, const std::vector<Comparison>& comparisons, CalibrationResult& result) {
  Doubts doubts(study, result);
  doubts.of_reach();
  doubts.of_parameters();
  doubts.of_effort();
  doubts.of_seed(comparisons);
  doubts.of_ends();
}

}  // namespace talus::calibration
