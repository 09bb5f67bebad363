#include "talus/sensitivity/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "talus/core/nearest.hpp"
#include "talus/project/parameter.hpp"
#include "talus/project/read.hpp"
#include "talus/sensitivity/doubts.hpp"
#include "talus/study/prepared_site.hpp"

namespace talus::sensitivity {

namespace {

using project::Prior;
using project::SettingNumber;

Problem about(const Study& study, int line, std::string where) {
  return {.file = study.file.string(), .line = line, .where = std::move(where)};
}

project::Reading read_project_of(const Study& study) {
  const std::filesystem::path file = study.file.parent_path() / study.project;
  return project::read_project(file, {.settings = study.set, .rocks = study.rocks, .seed = study.seed});
}

Prior prior_of(const StudyInput& input, const SettingNumber& number, const Problem& where, Problems& problems) {
  const auto refuse = [&](std::string what, std::string why) {
    Problem problem = where;
    problem.what = std::move(what);
    problem.why = std::move(why);
    problems.add(std::move(problem));
    return Prior();
  };
  if (!input.range.empty()) {
    for (const double end : input.range) {
      if (!number.range().contains(end))
        return refuse(fmt::format("range contains {:g}", end), fmt::format("expected {}", number.range().text()));
    }
    return Prior::uniform(input.range[0], input.range[1]);
  }
  if (const auto why = why_unusable(*input.prior, number.bounds())) return refuse(fmt::format("prior: {}", *why), "");
  return Prior(*input.prior, number.bounds());
}

/// The share of the probability below which an input is at a point of the design. Grids of a screening include 0 and 1:
/// for distributions without ends these are the 1st and the 99th percentile.
double share_at(const Study& study, const StudyInput& input, double u) {
  constexpr double tail = 0.01;
  return study.method == Method::morris && input.prior ? tail + (1 - 2 * tail) * u : u;
}

}  // namespace

std::optional<Estimate> Effect::size() const {
  if (elementary) return elementary->magnitude;
  if (index) return index->total;
  return std::nullopt;
}

struct PreparedStudy::Parts {
  Study study;
  Problems warnings;
  std::optional<study::PreparedSite> site;
  std::vector<SettingNumber> numbers;
  std::vector<Prior> priors;
  std::vector<RunFigure> figures;
  std::vector<std::size_t> line_of_barrier;  // by barrier; none if no result is at it
  std::size_t lines = 0;

  explicit Parts(const Study& given) : study(given) {
    project::Reading reading = read_project_of(study);
    Problems problems;
    for (std::size_t k = 0; k < study.inputs.size(); ++k) {
      const StudyInput& input = study.inputs[k];
      const Problem where = about(study, input.line, fmt::format("[[parameter]] {}", k + 1));
      const auto number = SettingNumber::find(reading.project, input.path, where, problems);
      if (!number) continue;
      priors.push_back(prior_of(input, *number, where, problems));
      numbers.push_back(*number);
    }
    for (std::size_t k = 0; k < study.results.size(); ++k) find_line(k, reading.project, problems);
    if (problems.has_errors()) throw BadInput(std::move(problems));
    warnings = std::move(reading.warnings);
    warnings.append(problems);
    site.emplace(std::move(reading.project), warnings);
    check_ends();
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  void find_line(std::size_t k, const project::Project& project, Problems& problems) {
    const StudyResult& result = study.results[k];
    RunFigure figure{result.of, result.percentile, 0};
    line_of_barrier.resize(project.barriers.size(), none);
    if (figure.is_at_line()) {
      const auto found = std::ranges::find(project.barriers, result.at, &project::Barrier::name);
      if (found == project.barriers.end()) {
        std::vector<std::string_view> names;
        for (const project::Barrier& barrier : project.barriers) names.push_back(barrier.name);
        const auto near = nearest(result.at, names);
        Problem problem = about(study, result.line, fmt::format("[[result]] {}", k + 1));
        problem.what = fmt::format("there is no collector or barrier \"{}\"", result.at);
        problem.why =
            names.empty() ? "the project has none" : fmt::format("the project has {}", fmt::join(names, ", "));
        problem.hint = near ? fmt::format("Did you mean \"{}\"?", *near) : "";
        return problems.add(std::move(problem));
      }
      std::size_t& line = line_of_barrier[static_cast<std::size_t>(found - project.barriers.begin())];
      if (line == none) line = lines++;
      figure.line = line;
    }
    figures.push_back(figure);
  }

  /// That every input may have its extreme values, before hours of runs.
  void check_ends() {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      for (const double u : {0.0, 1.0}) {
        project::Project project = site->project();
        const auto why = numbers[k].set(project, priors[k].value(share_at(study, study.inputs[k], u)));
        if (!why) continue;
        Problem problem = about(study, study.inputs[k].line, fmt::format("[[parameter]] {}", k + 1));
        problem.what = *why;
        problem.hint = "Narrow its range or prior";
        throw BadInput(std::move(problem));
      }
    }
  }

  [[nodiscard]] std::vector<std::optional<double>> results_of(const study::SetOutcome& outcome) const {
    FigureTally tally(lines, outcome.ends.size());
    for (const study::RockEnd& end : outcome.ends) tally.add({end.runout(), end.max_kinetic_energy, end.max_bounce});
    std::vector<std::optional<std::uint64_t>> last(lines);
    for (const study::Crossing& crossing : outcome.crossings) {
      const std::size_t line = line_of_barrier[crossing.barrier.index];
      if (line == none || last[line] == crossing.rock) continue;
      last[line] = crossing.rock;
      tally.add(line, {crossing.translational_energy + crossing.rotational_energy, crossing.speed, crossing.height});
    }
    std::vector<std::optional<double>> values;
    for (const RunFigure& figure : figures) values.push_back(tally.value(figure));
    return values;
  }
};

PreparedStudy::PreparedStudy(const Study& study) : parts_(std::make_unique<Parts>(study)) {}
PreparedStudy::~PreparedStudy() = default;
const Problems& PreparedStudy::warnings() const { return parts_->warnings; }

Analysis PreparedStudy::run(const AnalysisOptions& options) const {
  const Parts& parts = *parts_;
  const Study& study = parts.study;
  const std::size_t inputs = parts.numbers.size();
  Analysis all;
  std::optional<MorrisDesign> morris;
  std::optional<SobolDesign> sobol;
  if (study.method == Method::morris) {
    morris.emplace(MorrisPlan{
        .inputs = inputs + 1, .trajectories = static_cast<std::size_t>(study.trajectories), .seed = study.seed});
  } else {
    sobol.emplace(SobolPlan{.inputs = inputs + 1, .rows = static_cast<std::size_t>(study.rows), .seed = study.seed});
  }
  const auto& points = morris ? morris->points() : sobol->points();

  std::vector<study::ParameterSet> sets;
  study::SetRuns how{.threads = options.threads};
  for (const std::vector<double>& point : points) {
    StudyRun& run = all.runs.emplace_back();
    for (std::size_t k = 0; k < inputs; ++k)
      run.inputs.push_back(parts.priors[k].value(share_at(study, study.inputs[k], point[k])));
    sets.push_back(run.inputs);
    // Any other seed for another coordinate.
    how.seeds.push_back(study.seed + static_cast<std::uint64_t>(std::floor(point[inputs] * 0x1p32)));
    run.inputs.push_back(static_cast<double>(how.seeds.back()));
  }
  std::mutex counting;
  std::uint64_t done = 0;
  parts.site->run(parts.numbers, sets, how, [&](std::size_t k, study::SetOutcome&& outcome) {
    all.runs[k].results = parts.results_of(outcome);
    const std::lock_guard lock(counting);
    ++done;
    if (options.progress) options.progress(done);
  });

  for (std::size_t k = 0; k < inputs; ++k)
    all.inputs.push_back({parts.numbers[k].path(), parts.numbers[k].unit(), parts.priors[k].text()});
  all.inputs.push_back({seed_name, "", "any"});
  const Bootstrap bootstrap{.confidence = study.confidence, .seed = study.seed};
  for (std::size_t r = 0; r < study.results.size(); ++r) {
    ResultEffects& effects = all.results.emplace_back();
    effects.name = study.results[r].name;
    effects.unit = quantity_of(study.results[r].of).unit;
    effects.of_inputs.resize(inputs + 1);
    std::vector<std::optional<double>> values;
    double sum = 0;
    for (const StudyRun& run : all.runs) {
      const auto& value = values.emplace_back(run.results[r]);
      if (!value) continue;
      ++effects.defined;
      sum += *value;
      effects.least = std::min(effects.least.value_or(*value), *value);
      effects.most = std::max(effects.most.value_or(*value), *value);
    }
    if (effects.defined > 0) effects.mean = sum / static_cast<double>(effects.defined);
    if (morris) {
      auto found = morris->effects(values, bootstrap);
      for (std::size_t k = 0; k <= inputs; ++k) effects.of_inputs[k].elementary = std::move(found[k]);
    } else if (const auto found = sobol->indices(values, bootstrap)) {
      effects.mean = found->mean;
      for (std::size_t k = 0; k < found->inputs.size(); ++k) effects.of_inputs[k].index = found->inputs[k];
    }
  }
  all.warnings = doubts_about(study, all);
  return all;
}

}  // namespace talus::sensitivity
