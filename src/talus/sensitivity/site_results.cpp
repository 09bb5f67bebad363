#include "talus/sensitivity/site_results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "talus/core/nearest.hpp"

namespace talus::sensitivity {

namespace {

void refuse_line(std::size_t result, const Study& study, const project::Project& project, Problems& problems) {
  const StudyResult& given = study.results[result];
  std::vector<std::string_view> names;
  for (const project::Barrier& barrier : project.barriers) names.push_back(barrier.name);
  const auto near = nearest(given.at, names);
  problems.add({.file = study.file.string(),
                .line = given.line,
                .where = fmt::format("[[result]] {}", result + 1),
                .what = fmt::format("there is no collector or barrier \"{}\"", given.at),
                .why = names.empty()
                           ? fmt::format("{} has none", project.file.filename().string())
                           : fmt::format("{} has {}", project.file.filename().string(), fmt::join(names, ", ")),
                .hint = near ? fmt::format("Did you mean \"{}\"?", *near) : ""});
}

}  // namespace

void SiteResults::add(std::size_t result, const Study& study, const project::Project& project, Problems& problems) {
  const StudyResult& given = study.results[result];
  RunFigure figure{given.of, given.percentile, 0};
  line_of_barrier_.resize(project.barriers.size(), none);
  if (figure.is_at_line()) {
    const auto found = std::ranges::find(project.barriers, given.at, &project::Barrier::name);
    if (found == project.barriers.end()) return refuse_line(result, study, project, problems);
    std::size_t& line = line_of_barrier_[static_cast<std::size_t>(found - project.barriers.begin())];
    if (line == none) line = lines_++;
    figure.line = line;
  }
  figures_.push_back(figure);
  of_.push_back(result);
}

std::vector<std::optional<double>> SiteResults::values(const study::SetOutcome& outcome) const {
  FigureTally tally(lines_, outcome.ends.size());
  for (const study::RockEnd& end : outcome.ends) tally.add({end.runout(), end.max_kinetic_energy, end.max_bounce});
  std::vector<std::optional<std::uint64_t>> last(lines_);
  for (const study::Crossing& crossing : outcome.crossings) {
    const std::size_t line = line_of_barrier_[crossing.barrier.index];
    if (line == none || last[line] == crossing.rock) continue;
    last[line] = crossing.rock;
    tally.add(line, {crossing.translational_energy + crossing.rotational_energy, crossing.speed, crossing.top});
  }
  std::vector<std::optional<double>> values;
  for (const RunFigure& figure : figures_) values.push_back(tally.value(figure));
  return values;
}

}  // namespace talus::sensitivity
