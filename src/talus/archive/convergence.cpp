#include "talus/archive/convergence.hpp"

#include <algorithm>

#include "talus/core/random.hpp"

namespace talus {

ConvergenceCount::ConvergenceCount(std::uint64_t rocks, std::vector<std::string> lines)
    : rocks_(rocks), lines_(std::move(lines)), last_rock_(lines_.size()) {
  for (std::size_t line = 0; line < lines_.size(); ++line) line_of_.emplace(lines_[line], line);
  for (std::uint64_t size = rocks; size > 0 && sizes_.size() < most_steps; size /= 2) {
    if (size < fewest && !sizes_.empty()) break;
    sizes_.push_back(size);
    choices_.emplace_back(lines_.size(), size);
  }
}

template <class Visit>
void ConvergenceCount::for_choices(std::uint64_t rock, const Visit& visit) {
  constexpr std::array<std::uint32_t, 2> key{0x436f6e76, 0x65726765};  // any
  if (rock >= rocks_) return;
  const std::uint64_t place = permuted(rock, rocks_, key);
  for (std::size_t i = 0; i < sizes_.size() && place < sizes_[i]; ++i) visit(choices_[i]);
}

void ConvergenceCount::add_end(std::uint64_t rock, const RockValues& values) {
  for_choices(rock, [&](FigureTally& tally) { tally.add(values); });
}

void ConvergenceCount::add_arrival(std::uint64_t rock, std::string_view line, const ArrivalValues& values) {
  const auto found = line_of_.find(line);
  if (found == line_of_.end() || last_rock_[found->second] == rock) return;
  last_rock_[found->second] = rock;
  for_choices(rock, [&](FigureTally& tally) { tally.add(found->second, values); });
}

Convergence ConvergenceCount::result() const {
  Convergence all;
  if (sizes_.size() < 2) return all;
  for (const RunFigure& figure : usual_figures(lines_.size())) {
    FigureConvergence each{
        .figure = figure, .line = figure.is_at_line() ? lines_[figure.line] : "", .steps = {}, .rocks_needed = {}};
    for (std::size_t i = sizes_.size(); i-- > 0;) {
      // Tables may have end points of only some of the rocks, but they have all arrivals.
      const std::uint64_t rocks = figure.is_at_line() ? sizes_[i] : choices_[i].rocks();
      if (rocks == 0) continue;
      each.steps.push_back({rocks, choices_[i].estimate(figure, Convergence::confidence, rocks)});
    }
    if (each.steps.empty()) continue;
    if (const ConvergenceStep& whole = each.steps.back(); whole.estimate) {
      const std::uint64_t values = figure.of == FigureOf::share ? whole.rocks : choices_.front().count(figure);
      each.rocks_needed =
          rocks_needed(figure, *whole.estimate, whole.rocks, values, Convergence::confidence, Convergence::tolerance);
    }
    all.figures.push_back(std::move(each));
  }
  return all;
}

}  // namespace talus
