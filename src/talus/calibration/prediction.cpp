#include "talus/calibration/prediction.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "talus/calibration/observation_table.hpp"
#include "talus/calibration/sampler.hpp"
#include "talus/core/check.hpp"
#include "talus/core/nearest.hpp"
#include "talus/core/random.hpp"
#include "talus/core/stop.hpp"
#include "talus/project/parameter.hpp"
#include "talus/project/read.hpp"
#include "talus/statistics/binomial.hpp"
#include "talus/statistics/proper_scores.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus::validation {

namespace {

using calibration::CalibrationResult;
using calibration::PreparedStudy;
using calibration::Study;

constexpr std::size_t replicas = 500;  // of the held-out runs
constexpr auto replica_stream = static_cast<Stream>(1500);

/// The study with these sites alone, and `rocks` at each.
Study with_sites(const Study& study, const std::function<bool(const std::string&)>& has, std::int64_t rocks) {
  Study part = study;
  part.rocks = rocks;
  part.folds = 0;
  part.hold_out_sites = false;
  std::erase_if(part.sites, [&](const auto& site) { return !has(site.name); });
  std::erase_if(part.observations, [&](const auto& each) { return !has(each.site); });
  std::erase_if(part.parameters, [&](auto& parameter) {
    if (parameter.sites.empty()) return false;
    std::erase_if(parameter.sites, [&](const auto& site) { return !has(site); });
    return parameter.sites.empty();
  });
  return part;
}

std::size_t rows_of_releases(const Model& model) {
  std::size_t rows = 0;
  for (const Seeder& seeder : model.seeders) {
    if (const auto* table = std::get_if<ReleaseTable>(&*seeder.where)) rows += table->count();
  }
  return rows;
}

/// The rock of each row of the tables of releases, by the row's name. Expects one rock for each row. With another seed
/// the same rows have other rocks.
std::map<std::string, std::uint64_t> rocks_by_name(const Model& model, std::uint64_t seed) {
  std::map<std::string, std::uint64_t> rocks;
  for (const Seeder& seeder : model.seeders) {
    const auto* table = std::get_if<ReleaseTable>(&*seeder.where);
    if (table == nullptr || table->names.empty()) continue;
    const ReleaseOrder order = release_order(seeder, seed);
    for (std::uint64_t rock = seeder.first_rock; rock < seeder.first_rock + seeder.rocks; ++rock) {
      rocks.emplace(table->names[table->number(table->row_at(order.place_of(rock))) - 1], rock);
    }
  }
  return rocks;
}

/// A site of a study whose releases have one rock each.
study::PreparedSite with_one_rock_each(const Study& study, std::size_t site) {
  const auto& given = study.sites[site];
  Problems doubts;  // the calibrations repeat them
  std::optional<std::int64_t> rocks;
  for (;;) {
    project::Reading reading =
        project::read_project(study.file.parent_path() / given.project, {given.set, rocks, study.seed});
    study::PreparedSite prepared(std::move(reading.project), doubts);
    const std::size_t rows = rows_of_releases(prepared.model());
    if (rocks || rows == 0) return prepared;
    rocks = static_cast<std::int64_t>(rows);
  }
}

/// One site with its runs, prepared to simulate each once.
class TargetSite {
 public:
  TargetSite(const Study& study, std::size_t site) : site_(with_one_rock_each(study, site)) {
    const std::string& name = study.sites[site].name;
    const auto from = std::ranges::find_if(study.observations,
                                           [&](const auto& each) { return each.site == name && !each.stops.empty(); });
    TALUS_PROMISE(from != study.observations.end(), "each site of an experiment has stops");
    match(study.file.parent_path() / from->stops);
  }

  [[nodiscard]] const std::vector<ObservedRun>& runs() const { return runs_; }

  /// The stops of all runs with each set of the parameters of `learned`, each with its own draws: a row for each run.
  [[nodiscard]] std::vector<std::vector<Vec2>> simulate(const PreparedStudy& learned,
                                                        const std::vector<study::ParameterSet>& sets, int threads,
                                                        std::uint64_t seed) const {
    std::vector<project::SettingNumber> numbers;
    Problems problems;
    for (const auto& parameter : learned.parameters()) {
      const Problem about{.file = site_.project().file.string(),
                          .where = fmt::format("parameter \"{}\"", parameter.name)};
      if (auto number = project::SettingNumber::find(site_.project(), parameter.name, about, problems))
        numbers.push_back(std::move(*number));
    }
    if (problems.has_errors()) throw BadInput(std::move(problems));
    std::vector<std::uint64_t> seeds;
    for (std::uint64_t k = 0; k < sets.size(); ++k) {
      const auto words = philox(seed, k, static_cast<std::uint32_t>(replica_stream), 0);
      seeds.push_back(std::uint64_t{words[0]} << 32U | words[1]);
    }
    std::vector<std::vector<Vec2>> stops(runs_.size(), std::vector<Vec2>(sets.size()));
    site_.run(numbers, sets, {.threads = threads, .seeds = seeds}, [&](std::size_t k, study::SetOutcome&& outcome) {
      const auto rocks = rocks_by_name(site_.model(), seeds[k]);
      for (std::size_t run = 0; run < runs_.size(); ++run)
        stops[run][k] = outcome.ends[rocks.at(runs_[run].name)].end.xy();
    });
    return stops;
  }

 private:
  void match(const std::filesystem::path& file) {
    const calibration::ObservationTable table(file);
    const auto rocks = rocks_by_name(site_.model(), site_.model().seed);
    auto column = table.find({"release"});
    if (!column) column = table.find({"name"});
    const auto x = table.find({"x_m"}), y = table.find({"y_m"}), group = table.find({"group"});
    if (!column || !x || (!y && !site_.project().is_2d()) || rocks.empty()) {
      throw BadInput(Problem{
          .file = file.string(),
          .line = 1,
          .what = !column         ? "there is no column name or release"
                  : rocks.empty() ? "the releases have no names"
                                  : fmt::format("there is no column {}", !x ? "x_m" : "y_m"),
          .why = "each stop is predicted from its own release",
          .hint = "Release the rocks from a table with a column name (type = \"table\"), and give the stops a column "
                  "name with the same names, x_m and y_m"});
    }
    const study::SetOutcome once = site_.run({}, {});
    std::vector<std::string_view> known;
    for (const auto& [name, rock] : rocks) known.push_back(name);
    Problems problems;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const std::string& name = table.text(row, *column);
      const Vec2 stop(table.number(row, *x, problems).value_or(0), y ? table.number(row, *y, problems).value_or(0) : 0);
      const auto rock = rocks.find(name);
      if (rock == rocks.end()) {
        Problem problem = table.at(row);
        problem.what = fmt::format("there is no release \"{}\"", name);
        problem.why = "it is to be the name of a row of the table of releases";
        if (const auto near = nearest(name, known)) problem.hint = fmt::format("Did you mean \"{}\"?", *near);
        problems.add(std::move(problem));
        continue;
      }
      runs_.push_back({name, group ? table.text(row, *group) : "", once.ends[rock->second].release.xy(), stop});
    }
    if (problems.has_errors()) throw BadInput(std::move(problems));
  }

  study::PreparedSite site_;
  std::vector<ObservedRun> runs_;
};

std::vector<double> runouts_of(const std::vector<ObservedRun>& runs) {
  std::vector<double> runouts;
  for (const ObservedRun& run : runs) runouts.push_back(run.runout());
  return runouts;
}

Moments moments(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, n > 1 ? std::sqrt(squares / (n - 1)) : 0};
}

double share(std::vector<double> values, double q) {
  std::ranges::sort(values);
  const auto [rank, fraction] = quantile_place(q, values.size());
  return between(values[rank], values[std::min<std::size_t>(rank + 1, values.size() - 1)], fraction);
}

/// Sets of a posterior, as many as there are replicas, by systematic resampling.
std::vector<study::ParameterSet> draws_of(const CalibrationResult& result) {
  std::vector<study::ParameterSet> draws;
  double below = 0;
  for (const calibration::SetResult& set : result.sets) {
    below += set.weight;
    while (draws.size() < replicas && (static_cast<double>(draws.size()) + 0.5) / replicas <= below) {
      draws.push_back(set.values);
    }
  }
  while (draws.size() < replicas) draws.push_back(draws.empty() ? result.sets[result.best].values : draws.back());
  return draws;
}

std::vector<study::ParameterSet> prior_draws(const PreparedStudy& study) {
  std::vector<study::ParameterSet> draws;
  calibration::Sampler sampler(study.parameters().size(), study.study().seed);
  for (const calibration::Place& place : sampler.next_round(replicas)) draws.push_back(study.values_at(place));
  return draws;
}

/// Mean scores over the runs of forecasts of their stops.
Scores scores_of(const std::vector<ObservedRun>& runs, const std::vector<std::vector<Vec2>>& stops) {
  std::vector<Scores> each(runs.size());
  tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t k) {
    std::vector<double> runouts;
    for (const Vec2& stop : stops[k]) runouts.push_back((stop - runs[k].release).norm());
    each[k] = {crps(LineSample(runouts), runs[k].runout(), SpreadOf::population),
               energy_score(PlaneSample(stops[k]), runs[k].stop, SpreadOf::population)};
  });
  Scores mean;
  for (const Scores& one : each) {
    mean.runout += one.runout / static_cast<double>(runs.size());
    mean.place += one.place / static_cast<double>(runs.size());
  }
  return mean;
}

/// Of the runouts and stops of other runs, the same for every run.
Scores scores_of_constant(const std::vector<ObservedRun>& runs, const std::vector<ObservedRun>& others) {
  std::vector<Vec2> stops;
  for (const ObservedRun& other : others) stops.push_back(other.stop);
  const LineSample line(runouts_of(others));
  const PlaneSample plane(stops);
  Scores mean;
  for (const ObservedRun& run : runs) {
    mean.runout += crps(line, run.runout(), SpreadOf::population) / static_cast<double>(runs.size());
    mean.place += energy_score(plane, run.stop, SpreadOf::population) / static_cast<double>(runs.size());
  }
  return mean;
}

void add_runs(const std::vector<ObservedRun>& runs, std::vector<std::vector<Vec2>> stops, SitePrediction& site) {
  std::vector<double> all;
  std::vector<std::vector<double>> of_replica(replicas);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    std::vector<double> runouts;
    for (std::size_t r = 0; r < replicas; ++r) {
      runouts.push_back((stops[k][r] - runs[k].release).norm());
      of_replica[r].push_back(runouts.back());
    }
    all.insert(all.end(), runouts.begin(), runouts.end());
    PredictedRun run{.observed = runs[k], .stops = std::move(stops[k])};
    run.mean = moments(runouts).mean;
    run.p05 = share(runouts, 0.05);
    run.p25 = share(runouts, 0.25);
    run.median = share(runouts, 0.5);
    run.p75 = share(runouts, 0.75);
    run.p95 = share(runouts, 0.95);
    const auto below = std::ranges::count_if(runouts, [&](double x) { return x < runs[k].runout(); });
    run.share_below = static_cast<double>(below) / replicas;
    site.runs.push_back(std::move(run));
  }
  site.observed = moments(runouts_of(runs));
  site.predicted = moments(all);
  std::vector<double> means, spreads;
  for (const std::vector<double>& runouts : of_replica) {
    const Moments one = moments(runouts);
    means.push_back(one.mean);
    spreads.push_back(one.std_dev);
  }
  site.mean_90 = {share(means, 0.05), share(means, 0.95)};
  site.std_dev_90 = {share(spreads, 0.05), share(spreads, 0.95)};
}

Coverage coverage(const SitePrediction& site, double part) {
  Coverage coverage;
  for (const PredictedRun& run : site.runs) {
    if (std::abs(run.share_below - 0.5) <= part / 2) ++coverage.count;
  }
  constexpr double central = 0.95;
  const auto [least, most] = central_counts(site.runs.size(), part, central);
  coverage.expected = {least, most};
  return coverage;
}

void add_errors(SitePrediction& site) {
  const std::vector<double> others = runouts_of(site.learned_from);
  const double mean = moments(others).mean, median = share(others, 0.5);
  const auto n = static_cast<double>(site.runs.size());
  for (const PredictedRun& run : site.runs) {
    const double runout = run.observed.runout();
    site.rmse += (run.mean - runout) * (run.mean - runout) / n;
    site.rmse_constant += (mean - runout) * (mean - runout) / n;
    site.mae += std::abs(run.median - runout) / n;
    site.mae_constant += std::abs(median - runout) / n;
  }
  site.rmse = std::sqrt(site.rmse);
  site.rmse_constant = std::sqrt(site.rmse_constant);
}

void add_parameters(const PreparedStudy& learned, const CalibrationResult& result, SitePrediction& site) {
  std::vector<double> weights;
  for (const calibration::SetResult& set : result.sets) weights.push_back(set.weight);
  for (std::size_t k = 0; k < learned.parameters().size(); ++k) {
    const auto& parameter = learned.parameters()[k];
    std::vector<double> values;
    for (const calibration::SetResult& set : result.sets) values.push_back(set.values[k]);
    const auto q = [&](double part) { return calibration::weighted_quantile(values, weights, part); };
    site.parameters.push_back({parameter.name, parameter.unit, parameter.prior.value(0.05), parameter.prior.value(0.95),
                               q(0.05), q(0.5), q(0.95)});
  }
}

std::vector<TargetSite> targets_of(const Study& study) {
  std::vector<TargetSite> targets;
  targets.reserve(study.sites.size());
  for (std::size_t site = 0; site < study.sites.size(); ++site) targets.emplace_back(study, site);
  return targets;
}

/// The study of all sites but one.
PreparedStudy without_site(const Study& study, std::size_t site, Problems& warnings) {
  const auto is_other = [&](const std::string& name) { return name != study.sites[site].name; };
  return {with_sites(study, is_other, study.rocks), nullptr, warnings};
}

/// Rocks of predictions have other draws than those of the sets.
std::uint64_t prediction_seed(const Study& study) { return study.seed + 1; }

Scores prior_scores_of(const TargetSite& target, const PreparedStudy& learned, const Study& study, int threads) {
  return scores_of(target.runs(), target.simulate(learned, prior_draws(learned), threads, prediction_seed(study)));
}

}  // namespace

std::vector<Scores> prior_scores(const Study& study, int threads) {
  const std::vector<TargetSite> targets = targets_of(study);
  std::vector<Scores> scores;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    Problems warnings;
    scores.push_back(prior_scores_of(targets[k], without_site(study, k, warnings), study, threads));
  }
  return scores;
}

std::vector<SitePrediction> predict_sites(const Study& study, const PredictionOptions& options) {
  const std::vector<TargetSite> targets = targets_of(study);
  std::vector<SitePrediction> predictions;
  const auto draws = static_cast<std::size_t>(study.draws);
  for (std::size_t k = 0; k < targets.size(); ++k) {
    stop_point();
    SitePrediction site;
    site.site = study.sites[k].name;
    std::vector<std::string> others;
    for (std::size_t other = 0; other < targets.size(); ++other) {
      if (other == k) continue;
      others.push_back(study.sites[other].name);
      site.learned_from.insert(site.learned_from.end(), targets[other].runs().begin(), targets[other].runs().end());
    }
    site.from = fmt::format("{}", fmt::join(others, ", "));
    const PreparedStudy learned = without_site(study, k, site.warnings);
    const CalibrationResult result =
        calibration::calibrate(learned, {.threads = options.threads, .progress = [&](std::size_t done, std::size_t) {
                                           if (options.progress)
                                             options.progress(k * draws + done, targets.size() * draws);
                                         }});
    site.warnings.append(result.warnings);
    site.misfit = result.misfit;
    site.effective_sets = result.effective_sets;
    add_parameters(learned, result, site);
    const TargetSite& target = targets[k];
    auto stops = target.simulate(learned, draws_of(result), options.threads, prediction_seed(study));
    site.posterior = scores_of(target.runs(), stops);
    site.prior = prior_scores_of(target, learned, study, options.threads);
    site.constant = scores_of_constant(target.runs(), site.learned_from);
    add_runs(target.runs(), std::move(stops), site);
    site.in_50 = coverage(site, 0.5);
    site.in_90 = coverage(site, 0.9);
    add_errors(site);
    predictions.push_back(std::move(site));
  }
  return predictions;
}

}  // namespace talus::validation
