#include "talus/calibration/touched_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

namespace talus::calibration {

namespace {

using Eigen::Index;

/// Whether each rock is among those that come nearest to the observations of a group.
void mark_near(const ObservedGroup& group, const study::SetOutcome& outcome, std::vector<bool>& near) {
  if (group.kind == ObservationKind::values) {
    for (const study::Crossing& crossing : outcome.crossings) {
      if (crossing.barrier.index == group.barrier.index) near[crossing.rock] = true;
    }
    return;
  }
  if (group.kind == ObservationKind::zones) {
    const Eigen::VectorXd shares = zone_shares(group.zones, group.sample);
    for (const study::RockEnd& end : outcome.ends) {
      const std::size_t zone = group.zones.of(end.end.xy());
      if (zone < group.zones.list.size() && shares[static_cast<Index>(zone)] > 0) near[end.rock] = true;
    }
    return;
  }
  ObservedGroup named = group;
  named.sample.rocks = {0};  // so that simulated rows have the numbers of their rocks
  const Sample simulated = simulated_sample(named, outcome);
  for (Index k = 0; k < group.sample.rows.rows(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t nearest = 0;
    for (Index row = 0; row < simulated.rows.rows(); ++row) {
      const auto at = static_cast<std::size_t>(row);
      if (group.sample.has_strata() && simulated.strata[at] != group.sample.strata[static_cast<std::size_t>(k)]) {
        continue;
      }
      const double distance = (simulated.rows.row(row) - group.sample.rows.row(k)).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = simulated.rocks[at];
    }
    if (least < std::numeric_limits<double>::infinity()) near[nearest] = true;
  }
}

std::vector<bool> changed_rocks(const study::SetOutcome& a, const study::SetOutcome& b) {
  std::vector<bool> changed(a.ends.size());
  for (std::size_t k = 0; k < changed.size(); ++k) {
    changed[k] = a.ends[k].end != b.ends[k].end || a.ends[k].max_kinetic_energy != b.ends[k].max_kinetic_energy;
  }
  const auto only_in = [&](const study::SetOutcome& one, const study::SetOutcome& other) {
    std::vector<int> crossings(changed.size(), 0);
    for (const study::Crossing& crossing : one.crossings) ++crossings[crossing.rock];
    for (const study::Crossing& crossing : other.crossings) --crossings[crossing.rock];
    for (std::size_t k = 0; k < changed.size(); ++k) changed[k] = changed[k] || crossings[k] != 0;
  };
  only_in(a, b);
  return changed;
}

study::SetOutcome outcome_of(const PreparedStudy& study, std::size_t site, const study::ParameterSet& set,
                             bool keep_marks) {
  return study.prepared().run(site, set, {.keep_marks = keep_marks});
}

}  // namespace

std::vector<Dependence> dependence(const PreparedStudy& study, const study::ParameterSet& set) {
  const bool has_marks =
      std::ranges::any_of(study.groups(), [](const ObservedGroup& g) { return g.kind == ObservationKind::marks; });
  std::vector<Dependence> all(study.parameters().size());
  for (std::size_t site = 0; site < study.sites().size(); ++site) {
    const study::SetOutcome reference = outcome_of(study, site, set, has_marks);
    std::vector<bool> near(reference.ends.size(), false);
    for (const ObservedGroup& group : study.groups()) {
      if (group.site == site) mark_near(group, reference, near);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (!study.parameters()[k].at_site[site]) continue;
      std::vector<bool> depends(reference.ends.size(), false);
      for (const double u : {0.02, 0.98}) {
        study::ParameterSet moved = set;
        moved[k] = study.parameters()[k].prior.value(u);
        const std::vector<bool> changed = changed_rocks(reference, outcome_of(study, site, moved, false));
        for (std::size_t rock = 0; rock < changed.size(); ++rock) depends[rock] = depends[rock] || changed[rock];
      }
      all[k].all += depends.size();
      for (std::size_t rock = 0; rock < depends.size(); ++rock) {
        all[k].rocks += depends[rock] ? 1U : 0U;
        all[k].all_near += near[rock] ? 1U : 0U;
        all[k].near += near[rock] && depends[rock] ? 1U : 0U;
      }
    }
  }
  return all;
}

std::string ground_of(const std::string& parameter) {
  constexpr std::string_view table = "material.";
  const std::size_t end = parameter.find('.', table.size());
  if (!parameter.starts_with(table) || end == std::string::npos) return "";
  const std::string material = parameter.substr(table.size(), end - table.size());
  return material == "*" ? "" : fmt::format("the ground \"{}\"", material);
}

}  // namespace talus::calibration
