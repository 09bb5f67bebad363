#include "talus/calibration/result_summary.hpp"

#include <algorithm>
#include <cmath>

#include "talus/calibration/best_set.hpp"
#include "talus/calibration/coverage.hpp"
#include "talus/calibration/doubts.hpp"
#include "talus/calibration/mixture.hpp"
#include "talus/calibration/result_figures.hpp"
#include "talus/calibration/zone_prediction.hpp"
#include "talus/project/differences.hpp"

namespace talus::calibration {

namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// The settings of each site's project with the best set, as `--set` takes them.
Json best_settings_json(const PreparedStudy& study, const CalibrationResult& result) {
  Json sites = Json::object();
  for (std::size_t site = 0; site < study.sites().size(); ++site) {
    const study::PreparedSites::AtSite& here = study.prepared().at_site(site);
    const project::Project with = study.sites()[site].with(here.numbers, here.values(result.sets[result.best].values));
    Json settings = Json::array();
    for (const project::SettingNumber& number : here.numbers) {
      for (const std::string& setting : number.overrides(with)) settings.push_back(setting);
    }
    sites[study.study().sites[site].name] = std::move(settings);
  }
  return sites;
}

/// A row for each parameter, with the parameters before it.
Json correlations_json(const PreparedStudy& study, const CalibrationResult& result) {
  Json rows = Json::array();
  for (std::size_t a = 0; a < study.parameters().size(); ++a) {
    Json row = Json::array();
    for (std::size_t b = 0; b < a; ++b) row.push_back(correlation_of(a, b, result));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The parts of the summary that are about one parameter or one group of observations.
class Parts {
 public:
  Parts(const PreparedStudy& study, const CalibrationResult& result) : study_(study), result_(result) {
    for (const SetResult& set : result.sets) {
      posterior_.push_back(set.weight);
      prior_.push_back(set.round == 0 ? 1 : 0);
    }
  }

  [[nodiscard]] Json parameter(std::size_t k) const {
    const study::Parameter& parameter = study_.parameters()[k];
    const Learned learned = learned_about(k, study_, result_);
    Json prior;
    for (const auto& [name, q] : {std::pair{"p05", 0.05}, {"p50", 0.5}, {"p95", 0.95}})
      prior[name] = parameter.prior.value(q);
    return {{"name", parameter.name},
            {"unit", parameter.unit},
            {"prior", prior},
            {"posterior", has_posterior() ? quantiles(k) : Json()},
            {"width_of_prior", learned.width},
            {"learned_nothing", learned.is_nothing()},
            {"histogram", has_posterior() ? histogram(k) : Json()}};
  }

  [[nodiscard]] Json observations(std::size_t g) const {
    const ObservedGroup& group = study_.groups()[g];
    Json features = Json::array();
    for (std::size_t f = 0; f < group.features.size(); ++f) features.push_back(feature(g, f));
    Json json{{"name", group.name},
              {"site", study_.study().sites[group.site].name},
              {"count", group.count()},
              {"threshold", result_.thresholds[g]},
              {"best_distance", finite(result_.sets[result_.best].distances[g])},
              {"distance", group.sample.has_strata() ? "mean energy score" : "energy distance"},
              {"features", std::move(features)}};
    if (group.kind != ObservationKind::zones) return json;
    json["zones"] = zones(g);
    json["deposits"] = {{"unit", group.zones.unit()},
                        {"in_zones", group.zones.amount == ZoneAmount::share ? Json() : Json(group.zones.total)},
                        {"released", group.zones.released ? Json(*group.zones.released) : Json()},
                        {"elsewhere_observed", group.zones.has_elsewhere},
                        {"independent_rocks", effective_rocks(group.zones, group.sample)}};
    return json;
  }

  [[nodiscard]] bool has_posterior() const { return result_.effective_sets > 0; }

 private:
  [[nodiscard]] Json quantiles(std::size_t parameter) const {
    std::vector<double> values;
    for (const SetResult& set : result_.sets) values.push_back(set.values[parameter]);
    Json quantiles;
    for (const auto& [name, q] : {std::pair{"p05", 0.05}, {"p25", 0.25}, {"p50", 0.5}, {"p75", 0.75}, {"p95", 0.95}})
      quantiles[name] = weighted_quantile(values, posterior_, q);
    return quantiles;
  }

  [[nodiscard]] Json histogram(std::size_t parameter) const {
    const ParameterHistogram bins = histogram_of(parameter, study_, result_);
    return {{"edges", bins.edges}, {"prior", bins.prior}, {"posterior", bins.posterior}};
  }

  [[nodiscard]] Json feature(std::size_t g, std::size_t f) const {
    const ObservedGroup& group = study_.groups()[g];
    const auto column = group.sample.rows.col(static_cast<Eigen::Index>(f));
    const double mean = column.mean();
    const auto n = static_cast<double>(column.size());
    Json json{{"name", group.features[f].name},
              {"unit", group.features[f].unit},
              {"observed_mean", mean},
              {"observed_std_dev", n > 1 ? Json(std::sqrt((column.array() - mean).square().sum() / (n - 1))) : Json()}};
    if (!has_posterior()) return json;
    const Eigen::MatrixXd predicted = mixture_of(result_.sets, posterior_, g, rows_like(group.sample, 2000)).rows;
    const auto of = predicted.col(static_cast<Eigen::Index>(f));
    json["predicted_mean"] = of.mean();
    json["predicted_std_dev"] = std::sqrt((of.array() - of.mean()).square().mean());
    json["distribution"] = distribution(g, f);
    return json;
  }

  [[nodiscard]] Json distribution(std::size_t group, std::size_t feature) const {
    const PredictedDistribution prediction = prediction_of(group, feature, study_, result_);
    const auto band = [](const DistributionBand& of) {
      return Json{{"low", of.low}, {"median", of.middle}, {"high", of.high}};
    };
    return {{"observed", prediction.observed},
            {"at", prediction.at},
            {"prior", band(prediction.prior)},
            {"posterior", band(prediction.posterior)}};
  }

  [[nodiscard]] Json zones(std::size_t g) const {
    const ObservedGroup& group = study_.groups()[g];
    const Eigen::VectorXd observed = zone_shares(group.zones, group.sample);
    const auto shares = [&](const std::vector<double>& weights) {
      return predicted_shares(group, g, result_.sets, weights, study_.study().seed);
    };
    const auto range = [](const PredictedShare& of) { return Json{{"p05", of.p05}, {"p50", of.p50}, {"p95", of.p95}}; };
    const std::vector<PredictedShare> posterior = shares(posterior_), prior = shares(prior_);
    Json zones = Json::array();
    for (std::size_t k = 0; k < posterior.size(); ++k) {
      zones.push_back({{"name", group.zones.name_of(k)},
                       {"observed_amount", observed_amount(group.zones, k)},
                       {"observed_share", observed[static_cast<Eigen::Index>(k)]},
                       {"predicted_share", range(posterior[k])},
                       {"prior_share", range(prior[k])}});
    }
    return zones;
  }

  /// Of the last category, elsewhere: what was released and is in no zone; null if only shares are known.
  static Json observed_amount(const ObservedZones& zones, std::size_t k) {
    if (k < zones.list.size()) return zones.list[k].amount;
    return zones.released ? Json(std::max(*zones.released - zones.total, 0.0)) : Json();
  }

  const PreparedStudy& study_;
  const CalibrationResult& result_;
  std::vector<double> posterior_, prior_;  // weights of the sets
};

Json held_out_json(const CalibrationResult& result) {
  Json all = Json::array();
  for (const HeldOut& held : result.held_out) {
    Json features = Json::array();
    for (const PredictedFeature& each : held.features) {
      features.push_back({{"observations", each.group},
                          {"name", each.feature.name},
                          {"unit", each.feature.unit},
                          {"observed_mean", each.observed.mean},
                          {"observed_std_dev", each.observed.std_dev},
                          {"predicted_mean", each.predicted.mean},
                          {"predicted_std_dev", each.predicted.std_dev},
                          {"within_90", each.within_90}});
    }
    all.push_back({{"name", held.name},
                   {"observations", held.observations},
                   {"posterior", held.posterior},
                   {"prior", held.prior},
                   {"constant", held.constant ? Json(*held.constant) : Json()},
                   {"features", std::move(features)}});
  }
  return all;
}

Json coverage_json(const CalibrationResult& result) {
  Json all = Json::array();
  for (const HeldOutCoverage& each : coverage_of(result.held_out)) {
    all.push_back({{"observations", each.group},
                   {"name", each.feature.name},
                   {"count", each.observations},
                   {"within_90", each.within_90},
                   {"expected", {each.min_expected, each.max_expected}}});
  }
  return all;
}

}  // namespace

Json summary_of(const PreparedStudy& study, const CalibrationResult& result) {
  const Parts parts(study, result);
  const SetResult& best = result.sets[result.best];
  Json json;
  json["talus"] = TALUS_VERSION;
  json["study"] = study.study().name;
  json["seed"] = study.study().seed;
  json["fingerprint"] = study.fingerprint();
  json["sets"] = result.sets.size();
  json["rocks_per_set"] = study.study().rocks;
  json["agreeing_sets"] = std::ranges::count_if(result.sets, [](const SetResult& set) { return agrees(set); });
  json["effective_sets"] = result.effective_sets;
  json["misfit"] = result.misfit;
  json["likelihood_noise"] = result.likelihood_noise ? Json(*result.likelihood_noise) : Json();
  json["best"] = {{"set", result.best}, {"score", best.score}, {"values", Json::object()}};
  json["best"]["settings"] = best_settings_json(study, result);
  json["best"]["note"] = why_best_is_outside(study, result);
  json["parameters"] = Json::array();
  for (std::size_t k = 0; k < study.parameters().size(); ++k) {
    json["best"]["values"][study.parameters()[k].name] = best.values[k];
    json["parameters"].push_back(parts.parameter(k));
  }
  json["correlations"] = parts.has_posterior() ? correlations_json(study, result) : Json();
  json["observations"] = Json::array();
  for (std::size_t g = 0; g < study.groups().size(); ++g) json["observations"].push_back(parts.observations(g));
  json["held_out"] = held_out_json(result);
  json["held_out_coverage"] = coverage_json(result);
  json["warnings"] = Json::array();
  for (const Problem& problem : result.warnings.list()) json["warnings"].push_back(problem.text());
  return json;
}

Json posterior_sets(const CalibrationResult& result) {
  constexpr double faint = 1e-3;  // of the heaviest set
  double heaviest = 0;
  for (const SetResult& set : result.sets) heaviest = std::max(heaviest, set.weight);
  Json sets = Json::array();
  for (const SetResult& set : result.sets) {
    if (set.weight <= faint * heaviest) continue;
    Json row = Json::array({set.weight});
    for (const double value : set.values) row.push_back(value);
    sets.push_back(std::move(row));
  }
  return sets;
}

}  // namespace talus::calibration
