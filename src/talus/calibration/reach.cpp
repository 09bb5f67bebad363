#include "talus/calibration/reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "talus/project/values.hpp"
#include "talus/statistics/without_rounding.hpp"

namespace talus::calibration {

namespace {

using Eigen::Index;

constexpr double errors = 3;  // accuracies by which an observation may be off

struct Extent {
  double least = std::numeric_limits<double>::infinity(), most = -least;
};

class Reach {
 public:
  Reach(const PreparedStudy& study, const std::vector<SetResult>& sets, std::size_t g)
      : group_(study.groups()[g]), g_(g), sets_(sets) {}

  std::vector<Unreached> find() {
    if (group_.kind == ObservationKind::zones) {
      of_zones();
    } else {
      for (Index f = 0; f < group_.sample.rows.cols(); ++f) of_feature(f);
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::vector<Extent> extents(Index f) const {
    std::vector<Extent> extents(group_.sample.stratum_count());
    for (const SetResult& set : sets_) {
      const Sample& sample = set.samples[g_];
      for (Index row = 0; row < sample.rows.rows(); ++row) {
        const std::size_t stratum = sample.has_strata() ? sample.strata[static_cast<std::size_t>(row)] : 0;
        if (stratum >= extents.size()) continue;
        extents[stratum].least = std::min(extents[stratum].least, sample.rows(row, f));
        extents[stratum].most = std::max(extents[stratum].most, sample.rows(row, f));
      }
    }
    return extents;
  }

  void of_feature(Index f) {
    const std::vector<Extent> simulated = extents(f);
    const Feature& feature = group_.features[static_cast<std::size_t>(f)];
    const double slack = errors * feature.accuracy;
    std::size_t beyond = 0, below = 0;
    std::vector<Extent> observed(simulated.size());
    for (Index row = 0; row < group_.sample.rows.rows(); ++row) {
      const std::size_t stratum = group_.sample.has_strata() ? group_.sample.strata[static_cast<std::size_t>(row)] : 0;
      const double value = group_.sample.rows(row, f);
      observed[stratum].least = std::min(observed[stratum].least, value);
      observed[stratum].most = std::max(observed[stratum].most, value);
      beyond += value > simulated[stratum].most + slack ? 1U : 0U;
      below += value < simulated[stratum].least - slack ? 1U : 0U;
    }
    const auto all = static_cast<std::size_t>(group_.sample.rows.rows());
    const bool is_whole = beyond == all || below == all;
    constexpr int most_releases = 3;
    int releases = 0;
    for (std::size_t s = 0; s < simulated.size() && releases < most_releases; ++s) {
      const std::string where = where_of(s);
      if (simulated[s].most < simulated[s].least) {
        found_.push_back({where, fmt::format("no set brings a rock to {}", line_or_place()), is_whole});
        if (f == 0) ++releases;
        continue;
      }
      const auto say = [&](const char* side, double reached, double seen) {
        found_.push_back(
            {where,
             fmt::format("no parameters within the ranges give {} {} of {} than {:.4g}{}; observed {:.4g}{}",
                         feature.name.starts_with('e') ? "an" : "a", feature.name, side,
                         without_rounding(reached, seen), unit(feature), without_rounding(seen, reached),
                         unit(feature)),
             is_whole});
        ++releases;
      };
      if (observed[s].most > simulated[s].most + slack) say("more", simulated[s].most, observed[s].most);
      if (observed[s].least < simulated[s].least - slack) say("less", simulated[s].least, observed[s].least);
    }
  }

  void of_zones() {
    const Eigen::VectorXd shares = zone_shares(group_.zones, group_.sample);
    Eigen::VectorXd reached = Eigen::VectorXd::Zero(shares.size());
    for (const SetResult& set : sets_) {
      const Sample& sample = set.samples[g_];
      for (Index row = 0; row < sample.rows.rows(); ++row) reached[static_cast<Index>(sample.rows(row, 0))] = 1;
    }
    const bool is_whole = shares.dot(reached) <= 0;
    for (Index k = 0; k < shares.size(); ++k) {
      if (shares[k] <= 0 || reached[k] > 0) continue;
      found_.push_back(
          {group_.name,
           fmt::format("no parameters within the ranges bring a rock to rest in zone \"{}\"; observed {:.3g} "
                       "% of the {}",
                       group_.zones.name_of(static_cast<std::size_t>(k)), 100 * shares[k],
                       group_.zones.amount == ZoneAmount::count ? "rocks" : "volume"),
           is_whole});
    }
  }

  [[nodiscard]] std::string where_of(std::size_t stratum) const {
    const std::string release = group_.releases.name_of(static_cast<std::uint32_t>(stratum));
    return release.empty() ? group_.name : group_.name + ", " + release;
  }
  [[nodiscard]] const char* line_or_place() const {
    return group_.kind == ObservationKind::values ? "this line" : "these observations";
  }
  static std::string unit(const Feature& feature) { return feature.unit.empty() ? "" : " " + feature.unit; }

  const ObservedGroup& group_;
  std::size_t g_;
  const std::vector<SetResult>& sets_;
  std::vector<Unreached> found_;
};

}  // namespace

std::vector<Unreached> unreached(const PreparedStudy& study, const std::vector<SetResult>& sets) {
  std::vector<Unreached> all;
  for (std::size_t g = 0; g < study.groups().size(); ++g) {
    std::vector<Unreached> here = Reach(study, sets, g).find();
    std::ranges::move(here, std::back_inserter(all));
  }
  return all;
}

void expect_reach(const PreparedStudy& study, const std::vector<SetResult>& sets) {
  Problems problems;
  for (Unreached& each : unreached(study, sets)) {
    if (!each.is_whole_group) continue;
    problems.add(
        {.file = study.study().file.string(),
         .where = std::move(each.where),
         .what = std::move(each.what),
         .why = fmt::format("no observation is reached by any of {}", project::counted(sets.size(), "set", "sets")),
         .hint = "Widen the ranges, let other parameters vary, or check the observations and the releases"});
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

}  // namespace talus::calibration
