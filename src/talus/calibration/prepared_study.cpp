#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/calibration/calibrate.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/checksum.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"

namespace talus::calibration {

namespace {

constexpr double observations_per_parameter = 5;

Problem at_row(const Study& study, int line, std::string where) {
  return {.file = study.file.string(), .line = line, .where = std::move(where)};
}

/// Whether a parameter is at a site.
bool is_at(const StudyParameter& parameter, const std::string& site) {
  return parameter.sites.empty() || std::ranges::count(parameter.sites, site) > 0;
}

void add_group(const ObservedGroup& group, Checksum& checksum) {
  const auto add = [&](const auto& list, std::size_t size) {
    using Item = std::remove_cvref_t<decltype(list[0])>;
    checksum.add({reinterpret_cast<const char*>(list), size * sizeof(Item)});  // NOLINT: bytes of numbers
  };
  add(group.sample.rows.data(), static_cast<std::size_t>(group.sample.rows.size()));
  add(group.sample.strata.data(), group.sample.strata.size());
  add(group.sample.rocks.data(), group.sample.rocks.size());
  add(group.releases.of_rock.data(), group.releases.of_rock.size());
  add(group.releases.mass_bounds.data(), group.releases.mass_bounds.size());
  checksum.add(fmt::format("{} {} {} {}", group.name, group.weight, static_cast<int>(group.kind),
                           group.features.empty() ? 0 : group.features.front().accuracy));
  checksum.add(fmt::format("{} {} {} {}", group.zones.has_elsewhere, group.zones.relative_accuracy,
                           static_cast<int>(group.zones.amount), group.barrier.index));
  for (const ObservedZone& zone : group.zones.list) {
    checksum.add(fmt::format("{} {} {} {}", zone.name, zone.amount, zone.from, zone.to));
    for (const std::vector<Vec2>& outline : zone.outlines) add(outline.data(), outline.size());
  }
}

bool is_same(const study::SetOutcome& a, const study::SetOutcome& b) {
  const auto same_end = [](const study::RockEnd& x, const study::RockEnd& y) {
    return x.end == y.end && x.max_kinetic_energy == y.max_kinetic_energy;
  };
  return std::ranges::equal(a.ends, b.ends, same_end) && a.crossings.size() == b.crossings.size();
}

}  // namespace

study::ParameterSet PreparedStudy::AtSite::values(const study::ParameterSet& all) const {
  study::ParameterSet own;
  for (const std::size_t k : of) own.push_back(all[k]);
  return own;
}

PreparedStudy::PreparedStudy(Study study, const StudyModel* variant, Problems& warnings) : study_(std::move(study)) {
  if (variant != nullptr) overrides_ = variant->set;
  Problems problems;
  const std::filesystem::path folder = study_.file.parent_path();
  for (const StudySite& site : study_.sites) {
    stop_point();
    project::Overrides overrides{site.set, study_.rocks, study_.seed};
    overrides.settings.insert(overrides.settings.end(), overrides_.begin(), overrides_.end());
    try {
      project::Reading reading = project::read_project(folder / site.project, overrides);
      warnings.append(reading.warnings);
      sites_.emplace_back(std::move(reading.project), warnings);
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  find_parameters(problems);
  for (const StudyObservations& from : study_.observations) {
    const auto site =
        static_cast<std::size_t>(std::ranges::find(study_.sites, from.site, &StudySite::name) - study_.sites.begin());
    try {
      groups_.push_back(read_observations(study_, from, site, sites_[site], warnings));
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));

  std::size_t observations = 0;
  for (const ObservedGroup& group : groups_) observations += group.count();
  const auto parameters = static_cast<double>(parameters_.size());
  if (observations < parameters_.size()) {
    throw BadInput(
        Problem{.file = study_.file.string(),
                .what = fmt::format("{} parameters are sought from {} observations", parameters_.size(), observations),
                .why = "there must be at least as many observations",
                .hint = "Fix some parameters in the projects, or share them between materials and sites"});
  }
  if (static_cast<double>(observations) < observations_per_parameter * parameters) {
    warnings.add({Severity::warning, study_.file.string(), 0, "",
                  fmt::format("{} parameters are sought from {} observations", parameters_.size(), observations),
                  fmt::format("fewer than {:g} observations for each say little", observations_per_parameter),
                  "Seek fewer, or expect a posterior as wide as the prior"});
  }
  check_dependence(warnings);

  Checksum checksum;
  for (const study::PreparedSite& site : sites_) {
    checksum.add(project::fingerprint_of(project::echo(site.project()), site.model()));
    checksum.add(project::sample_of(site.model()));
  }
  for (const ObservedGroup& group : groups_) add_group(group, checksum);
  for (const SoughtParameter& parameter : parameters_)
    checksum.add(parameter.name + parameter.prior.text() +
                 fmt::format("{} {}", parameter.prior.value(0.1), parameter.prior.value(0.9)));
  checksum.add(fmt::format("{} {} {} {}", study_.seed, study_.rocks, study_.draws, study_.rounds));
  fingerprint_ = text_of(checksum.digest());
}

void PreparedStudy::find_parameters(Problems& problems) {
  at_site_.resize(sites_.size());
  for (const StudyParameter& from : study_.parameters) {
    const Problem about = at_row(study_, from.line, fmt::format("parameter \"{}\"", from.path));
    SoughtParameter sought;
    sought.name = from.path;
    sought.at_site.resize(sites_.size());
    bool is_good = true;
    const study::SettingNumber* first = nullptr;
    for (std::size_t site = 0; site < sites_.size(); ++site) {
      if (!is_at(from, study_.sites[site].name)) continue;
      auto number = study::SettingNumber::find(sites_[site].project(), from.path, about, problems);
      is_good = is_good && number.has_value();
      sought.at_site[site] = std::move(number);
      if (first == nullptr && sought.at_site[site]) first = &*sought.at_site[site];
    }
    if (!is_good || first == nullptr) continue;
    sought.unit = first->unit();
    const project::Range& legal = first->range();
    if (from.range.size() == 2 && (!legal.contains(from.range[0]) || !legal.contains(from.range[1]))) {
      Problem problem = about;
      problem.what = fmt::format("range is [{:g}, {:g}]", from.range[0], from.range[1]);
      problem.why = "the setting may be " + legal.text();
      problems.add(std::move(problem));
      continue;
    }
    if (from.prior) {
      if (const auto why = why_unusable(*from.prior, first->bounds())) {
        Problem problem = about;
        problem.what = "prior " + *why;
        problems.add(std::move(problem));
        continue;
      }
      sought.prior = study::Prior(*from.prior, first->bounds());
    } else {
      sought.prior = study::Prior::uniform(from.range[0], from.range[1]);
    }
    // What a project may not have anywhere within the prior is found before the first run.
    for (const double u : {0.0, 1.0}) {
      for (std::size_t site = 0; site < sites_.size(); ++site) {
        if (!sought.at_site[site]) continue;
        project::Project project = sites_[site].project();
        const auto why = sought.at_site[site]->set(project, sought.prior.value(u));
        if (!why) continue;
        Problem problem = about;
        problem.what = *why;
        problem.hint = "Narrow the range";
        problems.add(std::move(problem));
      }
    }
    if (!from.each_site) {
      parameters_.push_back(std::move(sought));
      continue;
    }
    for (std::size_t site = 0; site < sites_.size(); ++site) {
      if (!sought.at_site[site]) continue;
      SoughtParameter own = sought;
      for (std::size_t other = 0; other < sites_.size(); ++other) {
        if (other != site) own.at_site[other].reset();
      }
      own.name += "@" + study_.sites[site].name;
      parameters_.push_back(std::move(own));
    }
  }
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    for (std::size_t site = 0; site < sites_.size(); ++site) {
      if (!parameters_[k].at_site[site]) continue;
      at_site_[site].numbers.push_back(*parameters_[k].at_site[site]);
      at_site_[site].of.push_back(k);
    }
  }
}

void PreparedStudy::check_dependence(Problems& warnings) const {
  const Place middle(parameters_.size(), 0.5);
  std::vector<study::SetOutcome> reference;
  for (std::size_t site = 0; site < sites_.size(); ++site) {
    reference.push_back(sites_[site].run(at_site_[site].numbers, at_site_[site].values(values_at(middle))));
  }
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    bool depends = false;
    for (const double u : {0.02, 0.98}) {
      Place place = middle;
      place[k] = u;
      for (std::size_t site = 0; site < sites_.size() && !depends; ++site) {
        if (!parameters_[k].at_site[site]) continue;
        depends = !is_same(reference[site],
                           sites_[site].run(at_site_[site].numbers, at_site_[site].values(values_at(place))));
      }
    }
    if (depends) continue;
    warnings.add({Severity::warning, study_.file.string(), 0, fmt::format("parameter \"{}\"", parameters_[k].name),
                  "no rock depends on it", "all rocks move the same with its smallest and its largest value",
                  "Check that rocks reach ground of this material, or leave it out"});
  }
}

study::ParameterSet PreparedStudy::values_at(const Place& place) const {
  study::ParameterSet values;
  for (std::size_t k = 0; k < parameters_.size(); ++k) values.push_back(parameters_[k].prior.value(place[k]));
  return values;
}

}  // namespace talus::calibration
