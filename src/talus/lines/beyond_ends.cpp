#include "talus/lines/beyond_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

#include "talus/archive/design_json.hpp"

namespace talus {

namespace {

/// A line's direction at an end is that of its chord over this share of its length: the last corner of a line that was
/// drawn by hand says little.
constexpr double share_of_chord = 0.1;
/// A line whose ends are closer than this share of its length surrounds a place.
constexpr double share_of_gap = 0.1;
/// More rocks than this share of those that cross matter.
constexpr double share_that_matters = 0.01;

/// The continuation of a line beyond the first of its corners; nullopt off the terrain.
std::optional<AskedLine> beyond_first(const Model& model, std::span<const Vec2> corners, double length) {
  const Vec2 end = corners.front();
  const auto inside = std::ranges::find_if(
      corners, [&](const Vec2& corner) { return (corner - end).norm() >= share_of_chord * length; });
  const Vec2 chord = end - (inside == corners.end() ? corners.back() : *inside);
  if (!(chord.norm() > 0)) return std::nullopt;
  const Vec2 far = end + chord * (length / chord.norm());
  const auto place = [&](const Vec2& p) {
    const Vec3 global = model.frame.global_from_local(Vec3(p.x(), p.y(), 0));
    return PlanPlace{global.x(), global.y()};
  };
  const std::array places{place(end), place(far)};
  return line_on_ground(model, places, asked_height);
}

}  // namespace

std::optional<std::array<std::uint64_t, 2>> rocks_beyond_ends(const Model& model, const project::DesignBasis& basis,
                                                              const RockPaths& paths, const AskedLine& line,
                                                              const LineAnswer& answer) {
  if (std::holds_alternative<Profile>(*model.surface)) return std::nullopt;
  std::vector<Vec2> corners;
  for (const Vec3& corner : foot_of(line.barrier)) corners.push_back(corner.xy());
  const double length = answer.plan.lines.front().length;
  if (corners.size() < 2 || (corners.front() - corners.back()).norm() < share_of_gap * length) return std::nullopt;

  std::vector<AskedLine> continuations;
  std::vector<std::size_t> ends;  // of the line, by continuation
  for (const std::size_t end : {0u, 1u}) {
    if (auto found = beyond_first(model, corners, length)) {
      continuations.push_back(std::move(*found));
      ends.push_back(end);
    }
    std::ranges::reverse(corners);
  }
  const std::vector<LineAnswer> found = ask_lines(model, without_kits(basis), paths, continuations);

  // A rock that crosses both continuations counts at the first.
  std::vector<std::uint64_t> known;
  for (const CrossingRock& crossing : answer.crossings) known.push_back(crossing.rock);
  std::array<std::uint64_t, 2> beyond{};
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (const CrossingRock& crossing : found[k].crossings) {
      const auto place = std::ranges::lower_bound(known, crossing.rock);
      if (place != known.end() && *place == crossing.rock) continue;
      known.insert(place, crossing.rock);
      ++beyond[ends[k]];
    }
  }
  return beyond;
}

void doubt_ends(const std::string& where, const std::array<std::uint64_t, 2>& beyond, const LineAnswer& answer,
                Problems& warnings) {
  const std::uint64_t all = beyond[0] + beyond[1];
  if (static_cast<double>(all) <= share_that_matters * static_cast<double>(answer.crossings.size())) return;
  warnings.add(
      {.severity = Severity::warning,
       .where = where,
       .what = fmt::format("{} of {} rocks pass beyond its ends, {} beyond the first point and {} beyond the last",
                           grouped(all), grouped(answer.rocks), grouped(beyond[0]), grouped(beyond[1])),
       .why = "they do not count as crossing",
       .hint = "Lengthen the line, unless nothing there needs protection",
       .kind = ProblemKind::beyond_ends});
}

}  // namespace talus
