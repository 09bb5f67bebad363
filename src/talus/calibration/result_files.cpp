#include "talus/calibration/result_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "talus/calibration/coverage.hpp"
#include "talus/calibration/doubts.hpp"
#include "talus/calibration/mixture.hpp"
#include "talus/calibration/result_figures.hpp"
#include "talus/calibration/saved_samples.hpp"
#include "talus/calibration/zone_prediction.hpp"
#include "talus/files/csv_text.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/output_file.hpp"
#include "talus/model/fixed_columns.hpp"
#include "talus/project/differences.hpp"
#include "talus/project/document.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"
#include "talus/study/saved_sets.hpp"

namespace talus::calibration {

namespace {

using Json = nlohmann::ordered_json;

/// A site's name as the name of a file.
std::string file_name(const std::string& name) {
  std::string safe = name;
  std::ranges::replace_if(
      safe,
      [](unsigned char c) {
        return c < ' ' || std::string_view("/\\:*?\"<>|").find(static_cast<char>(c)) != std::string_view::npos;
      },
      '_');
  return (safe.starts_with('.') ? "_" + safe : safe) + ".toml";
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json quantiles_of(const std::vector<double>& values, const std::vector<double>& weights) {
  Json quantiles;
  for (const auto& [name, q] : {std::pair{"p05", 0.05}, {"p25", 0.25}, {"p50", 0.5}, {"p75", 0.75}, {"p95", 0.95}}) {
    quantiles[name] = weighted_quantile(values, weights, q);
  }
  return quantiles;
}

Json zones_of(const ObservedGroup& group, std::size_t g, const CalibrationResult& result,
              const std::vector<double>& weights, std::uint64_t seed) {
  Json zones = Json::array();
  const Eigen::VectorXd observed = zone_shares(group.zones, group.sample);
  const std::vector<PredictedShare> predicted = predicted_shares(group, g, result.sets, weights, seed);
  for (std::size_t k = 0; k < predicted.size(); ++k) {
    zones.push_back(
        {{"name", group.zones.name_of(k)},
         {"observed_share", observed[static_cast<Eigen::Index>(k)]},
         {"predicted_share", {{"p05", predicted[k].p05}, {"p50", predicted[k].p50}, {"p95", predicted[k].p95}}}});
  }
  return zones;
}

Json histogram_json(std::size_t parameter, const PreparedStudy& study, const CalibrationResult& result) {
  const ParameterHistogram bins = histogram_of(parameter, study, result);
  return {{"edges", bins.edges}, {"prior", bins.prior}, {"posterior", bins.posterior}};
}

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

Json prediction_json(std::size_t group, std::size_t feature, const PreparedStudy& study,
                     const CalibrationResult& result) {
  const PredictedDistribution prediction = prediction_of(group, feature, study, result);
  const auto band = [](const DistributionBand& of) {
    return Json{{"low", of.low}, {"median", of.middle}, {"high", of.high}};
  };
  return {{"observed", prediction.observed},
          {"at", prediction.at},
          {"prior", band(prediction.prior)},
          {"posterior", band(prediction.posterior)}};
}

std::string summary_of(const PreparedStudy& study, const CalibrationResult& result) {
  std::vector<double> weights;
  std::size_t agreeing = 0;
  for (const SetResult& set : result.sets) {
    weights.push_back(set.weight);
    agreeing += agrees(set) ? 1U : 0U;
  }
  const bool has_posterior = result.effective_sets > 0;
  Json json;
  json["talus"] = TALUS_VERSION;
  json["study"] = study.study().name;
  json["seed"] = study.study().seed;
  json["fingerprint"] = study.fingerprint();
  json["sets"] = result.sets.size();
  json["rocks_per_set"] = study.study().rocks;
  json["agreeing_sets"] = agreeing;
  json["effective_sets"] = result.effective_sets;
  json["misfit"] = result.misfit;
  json["likelihood_noise"] = result.likelihood_noise ? Json(*result.likelihood_noise) : Json();
  json["best"] = {{"set", result.best}, {"score", result.sets[result.best].score}, {"values", Json::object()}};
  json["best"]["settings"] = best_settings_json(study, result);
  json["parameters"] = Json::array();
  for (std::size_t k = 0; k < study.parameters().size(); ++k) {
    const study::Parameter& parameter = study.parameters()[k];
    json["best"]["values"][parameter.name] = result.sets[result.best].values[k];
    std::vector<double> values;
    for (const SetResult& set : result.sets) values.push_back(set.values[k]);
    const Learned learned = learned_about(k, study, result);
    Json prior;
    for (const auto& [name, q] : {std::pair{"p05", 0.05}, {"p50", 0.5}, {"p95", 0.95}})
      prior[name] = parameter.prior.value(q);
    json["parameters"].push_back({{"name", parameter.name},
                                  {"unit", parameter.unit},
                                  {"prior", prior},
                                  {"posterior", has_posterior ? quantiles_of(values, weights) : Json()},
                                  {"width_of_prior", learned.width},
                                  {"histogram", has_posterior ? histogram_json(k, study, result) : Json()}});
  }
  json["correlations"] = has_posterior ? correlations_json(study, result) : Json();
  json["observations"] = Json::array();
  for (std::size_t g = 0; g < study.groups().size(); ++g) {
    const ObservedGroup& group = study.groups()[g];
    Json features = Json::array();
    for (std::size_t f = 0; f < group.features.size(); ++f) {
      const auto column = group.sample.rows.col(static_cast<Eigen::Index>(f));
      const double mean = column.mean();
      const auto n = static_cast<double>(column.size());
      Json feature{
          {"name", group.features[f].name},
          {"unit", group.features[f].unit},
          {"observed_mean", mean},
          {"observed_std_dev", n > 1 ? Json(std::sqrt((column.array() - mean).square().sum() / (n - 1))) : Json()}};
      if (has_posterior) {
        const Eigen::MatrixXd predicted = mixture_of(result.sets, weights, g, rows_like(group.sample, 2000)).rows;
        const auto of = predicted.col(static_cast<Eigen::Index>(f));
        feature["predicted_mean"] = of.mean();
        feature["predicted_std_dev"] = std::sqrt((of.array() - of.mean()).square().mean());
        feature["distribution"] = prediction_json(g, f, study, result);
      }
      features.push_back(std::move(feature));
    }
    json["observations"].push_back({{"name", group.name},
                                    {"site", study.study().sites[group.site].name},
                                    {"count", group.count()},
                                    {"threshold", result.thresholds[g]},
                                    {"best_distance", finite(result.sets[result.best].distances[g])},
                                    {"features", std::move(features)}});
    if (group.kind == ObservationKind::zones) {
      json["observations"].back()["zones"] = zones_of(group, g, result, weights, study.study().seed);
    }
  }
  json["held_out"] = Json::array();
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
    json["held_out"].push_back({{"name", held.name},
                                {"observations", held.observations},
                                {"posterior", held.posterior},
                                {"prior", held.prior},
                                {"constant", held.constant ? Json(*held.constant) : Json()},
                                {"features", std::move(features)}});
  }
  json["held_out_coverage"] = Json::array();
  for (const HeldOutCoverage& each : coverage_of(result.held_out)) {
    json["held_out_coverage"].push_back({{"observations", each.group},
                                         {"name", each.feature.name},
                                         {"count", each.observations},
                                         {"within_90", each.within_90},
                                         {"expected", {each.min_expected, each.max_expected}}});
  }
  json["warnings"] = Json::array();
  for (const Problem& problem : result.warnings.list()) json["warnings"].push_back(problem.text());
  return json.dump(2) + '\n';
}

}  // namespace

namespace {

/// What the projects of the sites had fixed, as columns of a sample (model/fixed_columns.hpp).
std::vector<project::FixedSetting> fixed_columns(const PreparedStudy& study) {
  std::map<std::string, std::map<std::string, std::vector<std::string>>> sites_of;  // by path and value
  for (std::size_t site = 0; site < study.sites().size(); ++site) {
    const study::PreparedSite& prepared = study.sites()[site];
    const study::PreparedSites::AtSite& here = study.prepared().at_site(site);
    const auto with = [&](double share) {
      return project::echo(
          prepared.with(here.numbers, here.values(study.values_at(Place(study.parameters().size(), share)))));
    };
    std::vector<std::string> varied;
    for (const project::Difference& each : project::differences(with(0.25), with(0.75))) varied.push_back(each.key);
    std::optional<project::Project> as_written;
    try {
      as_written = project::read_project(prepared.project().file).project;
    } catch (const BadInput&) {
      // Without the settings of the study it is no project: then all values of its materials and forests are the
      // study's.
    }
    for (const project::FixedSetting& each :
         project::fixed_settings(prepared.project(), as_written ? &*as_written : nullptr, varied))
      sites_of[each.path][each.value].push_back(study.study().sites[site].name);
  }
  std::vector<project::FixedSetting> columns;
  for (const auto& [path, values] : sites_of) {
    for (const auto& [value, sites] : values)
      columns.push_back({project::fixed_column(path, values.size() > 1 ? sites : std::vector<std::string>()), value});
  }
  return columns;
}

}  // namespace

std::string posterior_table(const PreparedStudy& study, const CalibrationResult& result) {
  constexpr double negligible = 1e-9;
  const std::vector<project::FixedSetting> fixed = fixed_columns(study);
  std::string text;
  CsvRow header(text);
  header << "weight"
         << "score";
  for (const study::Parameter& parameter : study.parameters()) header << std::string_view(parameter.name);
  for (const project::FixedSetting& each : fixed) header << std::string_view(each.path);
  header.end();
  for (const SetResult& set : result.sets) {
    if (set.weight < negligible) continue;
    CsvRow row(text);
    row << set.weight << set.score;
    for (const double value : set.values) row << value;
    for (const project::FixedSetting& each : fixed) row << std::string_view(each.value);
    row.end();
  }
  return text;
}

std::string sets_table(const PreparedStudy& study, const CalibrationResult& result) {
  std::string text;
  CsvRow header(text);
  header << "set"
         << "round"
         << "weight"
         << "score"
         << "log_likelihood"
         << "smoothed_log_likelihood"
         << "agrees";
  for (const study::Parameter& parameter : study.parameters()) header << std::string_view(parameter.name);
  header.end();
  for (std::size_t k = 0; k < result.sets.size(); ++k) {
    const SetResult& set = result.sets[k];
    CsvRow row(text);
    row << k << set.round << set.weight << set.score;
    for (const double value : {set.log_likelihood, set.smoothed_log_likelihood}) {
      if (std::isfinite(value)) {
        row << value;
      } else {
        row << "-inf";
      }
    }
    row << (agrees(set) ? "yes" : "no");
    for (const double value : set.values) row << value;
    row.end();
  }
  return text;
}

std::string project_with(const PreparedStudy& study, std::size_t site, const study::ParameterSet& values,
                         const std::filesystem::path& folder) {
  const study::PreparedSite& prepared = study.sites()[site];
  const study::PreparedSites::AtSite& here = study.prepared().at_site(site);
  const std::filesystem::path& file = prepared.project().file;
  project::Document document(project::text_of_file(file), file.string());
  Problems problems;
  for (const std::string& setting : study.study().sites[site].set) document.set(setting, problems);
  for (const std::string& setting : study.overrides()) document.set(setting, problems);
  const project::Project with = prepared.with(here.numbers, here.values(values));
  for (const project::SettingNumber& number : here.numbers) {
    for (const std::string& setting : number.overrides(with)) document.set(setting, problems);
  }
  const auto absolute = [](const std::filesystem::path& path) {
    return std::filesystem::absolute(path).lexically_normal();
  };
  for (const project::NamedFile& named : prepared.project().named_files) {
    const std::filesystem::path target = absolute(file.parent_path() / named.file);
    const std::filesystem::path relative = target.lexically_relative(absolute(folder));
    document.set(fmt::format("{}='{}'", named.path, (relative.empty() ? target : relative).generic_string()), problems);
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  std::ostringstream text;
  text << fmt::format("# The best fit of the study {}, written by talus calibrate.\n", study.study().name)
       << toml::toml_formatter(document.root()) << '\n';
  return std::move(text).str();
}

void write_results(const std::filesystem::path& folder, const PreparedStudy& study, const CalibrationResult& result) {
  write_file(folder / "posterior.csv", posterior_table(study, result));
  write_file(folder / "sets.csv", sets_table(study, result));
  const std::filesystem::path best = folder / "best";
  make_output_folder(best);
  for (std::size_t site = 0; site < study.sites().size(); ++site) {
    write_file(best / file_name(study.study().sites[site].name),
               project_with(study, site, result.sets[result.best].values, best));
  }
  write_file(folder / "report.html", report_of(study, result));
  write_file(folder / "summary.json", summary_of(study, result));
}

CalibrationResult calibrate_into(const std::filesystem::path& folder, const PreparedStudy& study,
                                 const FolderOptions& options) {
  make_output_folder(folder);
  const FolderLock lock = lock_output_folder(folder);
  const study::SavedSets saved(folder, study.fingerprint());
  const auto known = [&](std::size_t set) -> std::optional<std::vector<Sample>> {
    const auto bytes = saved.of(set);
    return bytes ? samples_in(*bytes) : std::nullopt;
  };
  const auto save = [&](std::size_t first, const std::vector<SetResult>& sets) {
    std::vector<std::string> results;
    for (const SetResult& set : sets) results.push_back(bytes_of(set.samples));
    saved.save(first, results);
  };
  CalibrationResult result = calibrate(study, {.threads = options.threads,
                                               .progress = options.progress,
                                               .phase = options.phase,
                                               .known = known,
                                               .finished = save});
  if (options.phase) options.phase("writing the results");
  write_results(folder, study, result);
  return result;
}

}  // namespace talus::calibration
