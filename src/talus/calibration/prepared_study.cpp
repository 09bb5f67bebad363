#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/calibration/calibrate.hpp"
#include "talus/calibration/touched_ground.hpp"
#include "talus/files/checksum.hpp"

namespace talus::calibration {

namespace {

constexpr double observations_per_parameter = 5;

std::string counts_of(std::size_t parameters, std::size_t observations) {
  return fmt::format("{} parameter{} sought from {} observation{}", parameters, parameters == 1 ? " is" : "s are",
                     observations, observations == 1 ? "" : "s");
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

}  // namespace

PreparedStudy::PreparedStudy(Study study, const StudyModel* variant, Problems& warnings)
    : study_(std::move(study)), overrides_(variant != nullptr ? variant->set : std::vector<std::string>()) {
  Problems problems = study::lacking_projects(study_);
  for (const StudyObservations& from : study_.observations) {
    const std::string where = fmt::format("observations \"{}\"", from.name);
    if (auto lacking = study::lacking_file(study_, from.file(), from.key(), from.line, where))
      problems.add(std::move(*lacking));
  }
  if (problems.has_errors()) throw BadInput(problems.in_order_of(study_.file.string()));
  sites_ = study::PreparedSites(study_, overrides_, problems, warnings);
  for (const StudyObservations& from : study_.observations) {
    const auto site = static_cast<std::size_t>(std::ranges::find(study_.sites, from.site, &study::GivenSite::name) -
                                               study_.sites.begin());
    try {
      groups_.push_back(read_observations(study_, from, site, sites()[site], warnings));
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));

  std::size_t observations = 0;
  for (const ObservedGroup& group : groups_) observations += group.count();
  const std::size_t sought = parameters().size();
  if (observations < sought) {
    throw BadInput(Problem{.file = study_.file.string(),
                           .what = counts_of(sought, observations),
                           .why = "there must be at least as many observations",
                           .hint = "Fix some parameters in the projects, or share them between materials and sites"});
  }
  if (static_cast<double>(observations) < observations_per_parameter * static_cast<double>(sought)) {
    warnings.add({Severity::warning, study_.file.string(), 0, "", counts_of(sought, observations),
                  fmt::format("fewer than {:g} observations for each say little", observations_per_parameter),
                  "Free what moves the result (talus sensitivity), and compare held-out scores with fewer and more"});
  }
  check_folds();
  check_dependence(warnings);

  Checksum checksum;
  sites_.add_to(checksum);
  for (const ObservedGroup& group : groups_) add_group(group, checksum);
  checksum.add(fmt::format("{} {} {} {}", study_.seed, study_.rocks, study_.draws, study_.rounds));
  fingerprint_ = text_of(checksum.digest());
}

void PreparedStudy::check_folds() const {
  std::size_t most = 0;  // of a file
  for (const ObservedGroup& group : groups_) most = std::max(most, group.sample.first_rows().size() - 1);
  if (study_.folds <= static_cast<std::int64_t>(most) || study_.hold_out_sites) return;
  throw BadInput(Problem{.file = study_.file.string(),
                         .what = fmt::format("folds is {}", study_.folds),
                         .why = most == 1 ? "there is one observation"
                                          : fmt::format("no file has more than {} observations to divide", most),
                         .hint = fmt::format("Use {} at most", most)});
}

void PreparedStudy::check_dependence(Problems& warnings) const {
  const std::vector<Dependence> all = dependence(*this, values_at(Place(parameters().size(), 0.5)));
  for (std::size_t k = 0; k < parameters().size(); ++k) {
    if (all[k].rocks > 0) continue;
    Problem problem = study::about_parameter(study_, parameters()[k].name, 0);
    const std::string ground = ground_of(parameters()[k].name);
    problem.severity = Severity::warning;
    problem.what = "no rock depends on it";
    problem.why = "all rocks move the same with its smallest and its largest value";
    problem.hint = ground.empty() ? "Leave it out" : fmt::format("Check that rocks reach {}, or leave it out", ground);
    warnings.add(std::move(problem));
  }
}

study::ParameterSet PreparedStudy::values_at(const Place& place) const {
  study::ParameterSet values;
  for (std::size_t k = 0; k < parameters().size(); ++k) values.push_back(parameters()[k].prior.value(place[k]));
  return values;
}

}  // namespace talus::calibration
