#include "talus/lines/line_answer.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "talus/lines/line_follower.hpp"
#include "talus/model/design_plan.hpp"

namespace talus {

namespace {

/// The first crossing of a line by a rock.
struct Found {
  std::uint32_t line;
  CrossingRock crossing;
};

/// The places of the rocks that come near any of the lines.
std::vector<std::size_t> rocks_near(const RockPaths& paths, std::span<const AskedLine> lines, bool is_sphere) {
  constexpr double by_rounding = 1e-3;  // [m]
  std::vector<std::size_t> places;
  for (const AskedLine& line : lines) {
    double lean = 0;  // how far the top is from above the foot [m]
    std::vector<Vec2> foot;
    for (const Vec3& p : foot_of(line.barrier)) foot.emplace_back(p.xy());
    for (const Panel& panel : line.barrier.panels()) lean = std::max(lean, panel.height * panel.up.xy().norm());
    const auto near = paths.near(foot, lean + (is_sphere ? paths.largest_radius() : 0) + by_rounding);
    std::vector<std::size_t> both;
    std::ranges::set_union(places, near, std::back_inserter(both));
    places = std::move(both);
  }
  return places;
}

}  // namespace

DesignPlan plan_of_line(const project::DesignBasis& basis, const Model& model, const AskedLine& line,
                        std::uint32_t number) {
  const bool in_section = std::holds_alternative<Profile>(*model.surface);
  DesignPlan plan = project::design_check(basis);
  plan.lines = {project::line_along(line.barrier, number, basis.design.section_m, in_section)};
  return plan;
}

std::vector<LineAnswer> ask_lines(const Model& model, const project::DesignBasis& basis, const RockPaths& paths,
                                  std::span<const AskedLine> lines) {
  const AskedBarriers barriers(model, lines);
  std::vector<LineAnswer> answers;
  std::vector<DesignTally> tallies;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    DesignPlan plan = plan_of_line(basis, model, lines[k], barriers.numbers[k]);
    tallies.emplace_back(plan, paths.planned());
    answers.push_back({.plan = std::move(plan),
                       .result = {},
                       .demands = KitDemands(0, 0),
                       .crossings = {},
                       .rocks = paths.rocks().size()});
  }

  const auto near = rocks_near(paths, lines, has_extent(model.laws.model));
  constexpr std::size_t in_block = 64;
  std::vector<std::vector<Found>> found((near.size() + in_block - 1) / in_block);
  struct Reader {
    LineFollower follower;
    RockPath path;  // read into
  };
  tbb::enumerable_thread_specific<Reader> readers([&] { return Reader{LineFollower(model, barriers), {}}; });
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t block) {
    auto& [follower, path] = readers.local();
    const std::size_t last = std::min(near.size(), (block + 1) * in_block);
    for (std::size_t k = block * in_block; k < last; ++k) {
      paths.read(near[k], path);
      const RockRecord& record = path.record;
      const RockLog& log = follower.follow(path);
      for (std::uint32_t line = 0; line < lines.size(); ++line) {
        const Passage* const crossing = first_passage(log, barriers.numbers[line]);
        if (crossing == nullptr) continue;
        const DesignPlan& plan = answers[line].plan;
        found[block].push_back({line, {record.rock, line_crossing(plan, plan.lines.front(), record.body, *crossing)}});
      }
    }
  });

  for (const std::vector<Found>& block : found) {
    for (const auto& [line, crossing] : block) {
      DesignTally::Line& tally = tallies[line].lines.front();
      tally.sections[crossing.at.section].add(crossing.at);
      tally.demands.add(crossing.at.height, crossing.at.energy);
      answers[line].crossings.push_back(crossing);
    }
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    tallies[k].rocks = paths.rocks().size();
    answers[k].demands = tallies[k].lines.front().demands;
    answers[k].result = evaluate(answers[k].plan, tallies[k]).lines.front();
  }
  return answers;
}

project::DesignBasis without_kits(project::DesignBasis basis) {
  basis.kits.clear();
  basis.design.heights_m.clear();
  return basis;
}

std::optional<CrossingMaxima> LineAnswer::maxima(std::optional<std::uint32_t> section) const {
  std::optional<CrossingMaxima> most;
  for (const CrossingRock& crossing : crossings) {
    if (section && crossing.at.section != *section) continue;
    if (!most) most.emplace();
    for (std::size_t q = 0; q < most->size(); ++q) (*most)[q] = std::max((*most)[q], crossing.at.values[q]);
  }
  return most;
}

std::optional<std::uint32_t> LineAnswer::worst_section() const {
  std::optional<std::uint32_t> worst;
  for (std::uint32_t s = 0; s < result.sections.size(); ++s) {
    const auto& demand = result.sections[s].demand;
    if (!demand) continue;
    if (!worst || demand->maximum_energy > result.sections[*worst].demand->maximum_energy) worst = s;
  }
  return worst;
}

bool stops(double height, double maximum_energy, const LineCrossing& crossing) {
  return crossing.needed_height() <= height && crossing.needed_energy <= maximum_energy;
}

KitAnswer judge_kit(const LineAnswer& answer, double height, double maximum_energy) {
  KitAnswer kit{.height = height, .maximum_energy = maximum_energy};
  std::uint64_t stopped = 0;
  for (const CrossingRock& crossing : answer.crossings) {
    if (stops(height, maximum_energy, crossing.at)) {
      ++stopped;
    } else if (crossing.at.needed_height() > height) {
      ++kit.above;
    } else {
      ++kit.through;
    }
  }
  kit.stopped = share_of(stopped, answer.crossings.size(), answer.plan.confidence);
  return kit;
}

}  // namespace talus
