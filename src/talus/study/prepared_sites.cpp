#include "talus/study/prepared_sites.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "talus/core/stop.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::study {

namespace {

/// Nullopt if a number cannot vary as given.
std::optional<project::Prior> prior_of(const GivenParameter& given, const project::SettingNumber& number,
                                       const Problem& about, Problems& problems) {
  const auto refuse = [&](std::string what, std::string why) {
    Problem problem = about;
    problem.what = std::move(what);
    problem.why = std::move(why);
    problems.add(std::move(problem));
    return std::nullopt;
  };
  if (given.prior) {
    if (const auto why = why_unusable(*given.prior, number.bounds())) return refuse("prior " + *why, "");
    return project::Prior(*given.prior, number.bounds());
  }
  const double least = given.range[0], greatest = given.range[1];
  if (!number.range().contains(least) || !number.range().contains(greatest)) {
    return refuse(fmt::format("range is [{:g}, {:g}]", least, greatest), "the setting may be " + number.range().text());
  }
  return project::Prior::uniform(least, greatest);
}

}  // namespace

Problem about_parameter(const StudyFile& study, const std::string& name, int line) {
  return {.file = study.file.string(), .line = line, .where = fmt::format("parameter \"{}\"", name)};
}

ParameterSet PreparedSites::AtSite::values(const ParameterSet& all) const {
  ParameterSet own;
  for (const std::size_t k : of) own.push_back(all[k]);
  return own;
}

PreparedSites::PreparedSites(const StudyFile& study, const std::vector<std::string>& overrides, Problems& problems,
                             Problems& warnings) {
  read_sites(study, overrides, warnings);
  for (const GivenParameter& given : study.parameters) add_parameter(study, given, problems);
  at_site_.resize(sites_.size());
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    for (std::size_t site = 0; site < sites_.size(); ++site) {
      if (!parameters_[k].at_site[site]) continue;
      at_site_[site].numbers.push_back(*parameters_[k].at_site[site]);
      at_site_[site].of.push_back(k);
    }
  }
}

void PreparedSites::read_sites(const StudyFile& study, const std::vector<std::string>& overrides, Problems& warnings) {
  Problems problems = lacking_projects(study);
  if (problems.has_errors()) throw BadInput(std::move(problems));
  for (const GivenSite& site : study.sites) {
    stop_point();
    project::Overrides all{site.set, study.rocks, study.seed};
    all.settings.insert(all.settings.end(), overrides.begin(), overrides.end());
    try {
      project::Reading reading = project::read_project(study.file.parent_path() / site.project, all);
      warnings.append(reading.warnings);
      sites_.emplace_back(std::move(reading.project), warnings);
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

void PreparedSites::add_parameter(const StudyFile& study, const GivenParameter& given, Problems& problems) {
  const Problem about = about_parameter(study, given.path, given.line);
  Parameter parameter;
  parameter.name = given.path;
  parameter.line = given.line;
  parameter.at_site.resize(sites_.size());
  bool is_good = true;
  const project::SettingNumber* first = nullptr;
  for (std::size_t site = 0; site < sites_.size(); ++site) {
    if (!given.sites.empty() && std::ranges::count(given.sites, study.sites[site].name) == 0) continue;
    auto number = project::SettingNumber::find(sites_[site].project(), given.path, about, problems);
    is_good = is_good && number.has_value();
    parameter.at_site[site] = std::move(number);
    if (first == nullptr && parameter.at_site[site]) first = &*parameter.at_site[site];
  }
  if (!is_good || first == nullptr) return;
  parameter.unit = first->unit();
  const auto prior = prior_of(given, *first, about, problems);
  if (!prior) return;
  parameter.prior = *prior;
  // What a project may not have anywhere within the prior is found before the first run.
  for (const double u : {0.0, 1.0}) {
    for (std::size_t site = 0; site < sites_.size(); ++site) {
      if (!parameter.at_site[site]) continue;
      project::Project project = sites_[site].project();
      const auto why = parameter.at_site[site]->set(project, parameter.prior.value(u));
      if (!why) continue;
      Problem problem = about;
      problem.what = *why;
      problem.hint = given.prior ? "Narrow the prior" : "Narrow the range";
      problems.add(std::move(problem));
    }
  }
  if (!given.each_site) {
    // Other sites have another parameter of this path.
    if (std::ranges::count(study.parameters, given.path, &GivenParameter::path) > 1) {
      for (const std::string& site : given.sites) parameter.name += "@" + site;
    }
    parameters_.push_back(std::move(parameter));
    return;
  }
  for (std::size_t site = 0; site < sites_.size(); ++site) {
    if (!parameter.at_site[site]) continue;
    Parameter own = parameter;
    for (std::size_t other = 0; other < sites_.size(); ++other) {
      if (other != site) own.at_site[other].reset();
    }
    own.name += "@" + study.sites[site].name;
    parameters_.push_back(std::move(own));
  }
}

void PreparedSites::run(std::size_t site, std::span<const ParameterSet> sets, const SetRuns& how,
                        const std::function<void(std::size_t, SetOutcome&&)>& take) const {
  std::vector<ParameterSet> own;
  for (const ParameterSet& set : sets) own.push_back(at_site_[site].values(set));
  sites_[site].run(at_site_[site].numbers, own, how, take);
}

SetOutcome PreparedSites::run(std::size_t site, const ParameterSet& set, const SetRuns& how) const {
  return sites_[site].run(at_site_[site].numbers, at_site_[site].values(set), how);
}

void PreparedSites::add_to(Checksum& checksum) const {
  for (const PreparedSite& site : sites_) {
    checksum.add(project::fingerprint_of(project::echo(site.project()), site.model()));
    checksum.add(project::sample_of(site.model()));
  }
  for (const Parameter& parameter : parameters_) {
    checksum.add(parameter.name + parameter.prior.text() +
                 fmt::format("{} {}", parameter.prior.value(0.1), parameter.prior.value(0.9)));
  }
}

}  // namespace talus::study
