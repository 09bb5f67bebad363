#include "talus/sensitivity/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "talus/core/stop.hpp"
#include "talus/files/checksum.hpp"
#include "talus/sensitivity/doubts.hpp"
#include "talus/sensitivity/site_results.hpp"
#include "talus/study/prepared_sites.hpp"

namespace talus::sensitivity {

std::optional<Estimate> Effect::size() const {
  if (elementary) return elementary->magnitude;
  if (index) return index->total;
  return std::nullopt;
}

struct PreparedStudy::Parts {
  Study study;
  study::PreparedSites sites;
  std::vector<SiteResults> results;  // by site
  std::optional<MorrisDesign> morris;
  std::optional<SobolDesign> sobol;
  std::string fingerprint;

  Parts(const Study& given, Problems& warnings) : study(given), results(study.sites.size()) {
    Problems problems;
    sites = study::PreparedSites(study, {}, problems, warnings);
    for (std::size_t site = 0; site < results.size(); ++site) {
      for (std::size_t k = 0; k < study.results.size(); ++k) {
        const std::vector<std::string>& named = study.results[k].sites;
        if (named.empty() || std::ranges::count(named, study.sites[site].name) > 0)
          results[site].add(k, study, sites.sites()[site].project(), problems);
      }
    }
    if (problems.has_errors()) throw BadInput(std::move(problems));
    warnings.append(problems);
    const std::size_t inputs = sites.parameters().size() + 1;  // and the seed
    if (study.method == Method::morris) {
      morris.emplace(MorrisPlan{
          .inputs = inputs, .trajectories = static_cast<std::size_t>(study.trajectories), .seed = study.seed});
    } else {
      sobol.emplace(SobolPlan{.inputs = inputs, .rows = static_cast<std::size_t>(study.rows), .seed = study.seed});
    }
    identify();
  }

  void identify() {
    Checksum checksum;
    sites.add_to(checksum);
    checksum.add(fmt::format("{} {} {} {}", name(study.method), points().size(), study.seed, study.rocks));
    for (const SiteResults& site : results) {
      for (const std::size_t k : site.of()) {
        const StudyResult& result = study.results[k];
        checksum.add(fmt::format("{} {} {};", result.quantity, result.percentile, result.at));
      }
      checksum.add("|");
    }
    fingerprint = text_of(checksum.digest());
  }

  [[nodiscard]] const std::vector<std::vector<double>>& points() const {
    return morris ? morris->points() : sobol->points();
  }

  /// The value of an input at a point of the design. Grids of a screening include 0 and 1: for distributions without
  /// ends these are the 1st and the 99th percentile.
  [[nodiscard]] double value(std::size_t input, double u) const {
    constexpr double tail = 0.01;
    const project::Prior& prior = sites.parameters()[input].prior;
    const bool is_range = prior.distribution().kind == DistributionKind::uniform;
    return prior.value(morris && !is_range ? tail + (1 - 2 * tail) * u : u);
  }

  /// Any other seed for another coordinate.
  [[nodiscard]] std::uint64_t seed(double u) const {
    return study.seed + static_cast<std::uint64_t>(std::floor(u * 0x1p32));
  }

  [[nodiscard]] ResultEffects effects(std::size_t column, const std::vector<StudyRun>& runs) const {
    ResultEffects effects;
    std::vector<std::optional<double>> values;
    double sum = 0;
    for (const StudyRun& run : runs) {
      const auto& value = values.emplace_back(run.results[column]);
      if (!value) continue;
      ++effects.defined;
      sum += *value;
      effects.least = std::min(effects.least.value_or(*value), *value);
      effects.most = std::max(effects.most.value_or(*value), *value);
    }
    if (effects.defined > 0) effects.mean = sum / static_cast<double>(effects.defined);
    effects.of_inputs.resize(sites.parameters().size() + 1);
    const Bootstrap bootstrap{.confidence = study.confidence, .seed = study.seed};
    if (morris) {
      auto found = morris->effects(values, bootstrap);
      for (std::size_t k = 0; k < found.size(); ++k) effects.of_inputs[k].elementary = std::move(found[k]);
    } else if (const auto found = sobol->indices(values, bootstrap)) {
      effects.mean = found->mean;
      for (std::size_t k = 0; k < found->inputs.size(); ++k) effects.of_inputs[k].index = found->inputs[k];
    }
    return effects;
  }
};

/// Makes the runs, or takes those that are known.
class PreparedStudy::Runs {
 public:
  Runs(const Parts& parts, const AnalysisOptions& options) : parts_(parts), options_(options) {
    std::size_t columns = 0;
    for (const SiteResults& site : parts.results) columns += site.of().size();
    for (const std::vector<double>& point : parts.points()) {
      StudyRun& run = runs_.emplace_back();
      for (std::size_t k = 0; k + 1 < point.size(); ++k) run.inputs.push_back(parts.value(k, point[k]));
      sets_.push_back(run.inputs);
      seeds_.push_back(parts.seed(point.back()));
      run.inputs.push_back(static_cast<double>(seeds_.back()));
      run.results.resize(columns);
    }
  }

  std::vector<StudyRun> all() {
    constexpr std::size_t runs_at_once = 96;  // between calls of `finished`
    for (std::size_t first = 0; first < runs_.size(); first += runs_at_once)
      run_batch(first, std::min(first + runs_at_once, runs_.size()));
    return std::move(runs_);
  }

 private:
  void run_batch(std::size_t first, std::size_t last) {
    stop_point();
    std::vector<std::size_t> unknown;
    for (std::size_t k = first; k < last; ++k) {
      auto known = options_.known ? options_.known(k) : std::nullopt;
      if (!known || known->size() != runs_[k].results.size()) {
        unknown.push_back(k);
      } else {
        runs_[k].results = std::move(*known);
        add_done(parts_.results.size());
      }
    }
    if (unknown.empty()) return;
    run(unknown);
    if (options_.finished) options_.finished(first, std::span(runs_).subspan(first, last - first));
  }

  void run(const std::vector<std::size_t>& which) {
    std::vector<study::ParameterSet> sets;
    study::SetRuns how{.threads = options_.threads};
    for (const std::size_t k : which) {
      sets.push_back(sets_[k]);
      how.seeds.push_back(seeds_[k]);
    }
    std::ptrdiff_t column = 0;
    for (std::size_t site = 0; site < parts_.results.size(); ++site) {
      parts_.sites.run(site, sets, how, [&](std::size_t k, study::SetOutcome&& outcome) {
        std::ranges::copy(parts_.results[site].values(outcome), runs_[which[k]].results.begin() + column);
        add_done(1);
      });
      column += static_cast<std::ptrdiff_t>(parts_.results[site].of().size());
    }
  }

  void add_done(std::size_t site_runs) {
    const std::lock_guard lock(counting_);
    done_ += site_runs;
    if (options_.progress) options_.progress(done_);
  }

  const Parts& parts_;
  const AnalysisOptions& options_;
  std::vector<StudyRun> runs_;
  std::vector<study::ParameterSet> sets_;  // by run
  std::vector<std::uint64_t> seeds_;       // by run
  std::mutex counting_;
  std::uint64_t done_ = 0;  // runs at one site
};

PreparedStudy::PreparedStudy(const Study& study, Problems& warnings)
    : parts_(std::make_unique<Parts>(study, warnings)) {}
PreparedStudy::~PreparedStudy() = default;
const std::string& PreparedStudy::fingerprint() const { return parts_->fingerprint; }
std::uint64_t PreparedStudy::runs() const { return parts_->points().size(); }

Analysis PreparedStudy::run(const AnalysisOptions& options) const {
  const Parts& parts = *parts_;
  const Study& study = parts.study;
  const std::vector<study::Parameter>& parameters = parts.sites.parameters();
  Analysis all;
  all.runs = Runs(parts, options).all();

  for (const study::Parameter& parameter : parameters)
    all.inputs.push_back({parameter.name, parameter.unit, parameter.prior.text(), parameter.line});
  all.inputs.push_back({seed_name, "", "any"});
  for (std::size_t site = 0; site < study.sites.size(); ++site) {
    for (const std::size_t result : parts.results[site].of()) {
      ResultEffects& effects = all.results.emplace_back(parts.effects(all.results.size(), all.runs));
      effects.result = result;
      effects.site = site;
      effects.title = study.results[result].name;
      if (study.sites.size() > 1) effects.title += "@" + study.sites[site].name;
      effects.unit = quantity_of(study.results[result].of).unit;
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        if (!parameters[k].at_site[site]) effects.of_inputs[k] = {};
      }
    }
  }
  all.warnings = doubts_about(study, all);
  return all;
}

}  // namespace talus::sensitivity
