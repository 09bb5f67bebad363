#include "talus/lines/area_answer.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "talus/model/build_terrain.hpp"
#include "talus/model/design_plan.hpp"
#include "talus/trajectory/piece_maxima.hpp"

namespace talus {

namespace {

double area_of(std::span<const Vec2> ring) {
  double twice = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 a = ring[k] - ring.front(), b = ring[(k + 1) % ring.size()] - ring.front();
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice);
}

/// The times in (0, duration) at which a path crosses the line through an edge, near the edge.
void add_borders(const Vec2& from, const Vec2& to, const Parabola& path, double duration, std::vector<double>& times) {
  const Vec2 way = to - from, across(-way.y(), way.x());
  const double h = across.dot(path.p.xy() - from), v = across.dot(path.v.xy()), a = across.dot(path.a.xy());
  const auto add = [&](double t) {
    if (t > 0 && t < duration) times.push_back(t);
  };
  if (a == 0) {
    if (v != 0) add(-h / v);
    return;
  }
  const double discriminant = v * v - 2 * a * h;
  if (discriminant < 0) return;
  const double q = -(v + std::copysign(std::sqrt(discriminant), v));
  add(q / a);
  if (q != 0) add(2 * h / q);
}

PlanBounds bounds_of(const Parabola& path, double duration) {
  PlanBounds bounds;
  const auto grow = [&](double t) { bounds.grow(path.at(t).xy()); };
  grow(0);
  grow(duration);
  for (int k = 0; k < 2; ++k) {
    if (path.a[k] == 0) continue;
    const double turn = -path.v[k] / path.a[k];
    if (turn > 0 && turn < duration) grow(turn);
  }
  return bounds;
}

}  // namespace

AskedArea drawn_area(const Model& model, std::span<const PlanPlace> corners, std::string_view where,
                     Problems& warnings) {
  const auto refuse = [&](std::string what, std::string why, std::string hint = {}) {
    throw BadInput(
        Problem{.where = std::string(where), .what = std::move(what), .why = std::move(why), .hint = std::move(hint)});
  };
  if (std::holds_alternative<Profile>(*model.surface))
    refuse("is a polygon on plan", "this run is a section (2D)", "Ask for a line: a place on the section");
  Problems problems;
  check_places(corners, where, problems);
  if (problems.has_errors()) throw BadInput(problems);
  if (corners.size() > 1 && corners.front() == corners.back()) corners = corners.first(corners.size() - 1);
  if (corners.size() < 3)
    refuse(fmt::format("has {} corner{}", corners.size(), corners.size() == 1 ? "" : "s"), "expected at least 3");
  const Vec2 origin(model.frame.origin.x(), model.frame.origin.y());
  std::vector<Vec2> ring;
  std::vector<std::vector<Vec3>> rings(1);
  PlanBounds bounds;
  std::size_t off = 0;
  for (const PlanPlace& corner : corners) {
    const Vec2 place = Vec2(corner[0], corner[1]) - origin;
    ring.push_back(place);
    rings.front().emplace_back(place.x(), place.y(), 0);
    bounds.grow(place);
    if (!project::has_ground_at(model, place)) ++off;
  }
  if (const auto crossing = self_crossing(ring)) {
    const Vec2 at = *crossing + origin;
    refuse("crosses itself", fmt::format("at ({:.10g}, {:.10g})", at.x(), at.y()),
           "Give the corners in order along the outline");
  }
  const double area = area_of(ring);
  constexpr double smallest = 1e-6;  // [m2]
  if (!(area > smallest)) refuse(fmt::format("has an area of {:.3g} m2", area), "expected a polygon with an inside");
  const PlanBounds terrain = std::visit(
      [](const auto& surface) {
        const auto box = surface.bounds();
        PlanBounds on_plan;
        on_plan.grow(box.low.xy());
        on_plan.grow(box.high.xy());
        return on_plan;
      },
      *model.surface);
  if (off == ring.size() && !terrain.meet(bounds)) {
    refuse("does not touch the terrain", "rocks are only known there",
           is_on_ground_swapped(model, corners) ? project::swapped_hint : "Give it in the coordinates of the project");
  }
  if (off > 0) {
    warnings.add({.severity = Severity::warning,
                  .where = std::string(where),
                  .what = fmt::format("{} of {} corners are off the terrain", off, ring.size()),
                  .why = "rocks are only known on it"});
  }
  return {std::move(ring), PlanPolygon(rings), bounds, area};
}

void parts_inside(const AskedArea& area, const Parabola& path, double duration,
                  std::vector<std::pair<double, double>>& parts) {
  parts.clear();
  thread_local std::vector<double> times;
  times.assign({0, duration});
  for (std::size_t k = 0; k < area.ring.size(); ++k)
    add_borders(area.ring[k], area.ring[(k + 1) % area.ring.size()], path, duration, times);
  std::ranges::sort(times);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    if (times[k] == times[k + 1] && duration > 0) continue;
    if (!area.polygon.contains(path.at(0.5 * (times[k] + times[k + 1])).xy())) continue;
    if (!parts.empty() && parts.back().second == times[k]) {
      parts.back().second = times[k + 1];
    } else {
      parts.emplace_back(times[k], times[k + 1]);
    }
  }
}

std::optional<RockInside> rock_inside(const Model& model, const AskedArea& area, const RockPath& path) {
  thread_local std::vector<std::pair<double, double>> parts;
  const bool is_sphere = has_extent(model.laws.model);
  const Rock& body = path.record.body;
  std::optional<RockInside> inside;
  const double reach = reach_of(model.laws.model, body);
  double height = reach, squared_velocity = 0, translational = 0, total = 0;
  for (const PathPiece& piece : path.pieces) {
    if (!area.bounds.meet(bounds_of(piece.path, piece.duration))) continue;
    parts_inside(area, piece.path, piece.duration, parts);
    for (const auto& [from, to] : parts) {
      if (!inside) inside = RockInside{.rock = path.record.rock};
      const MaxMotion most = max_motion(piece, body, from, to);
      squared_velocity = std::max(squared_velocity, most.squared_velocity);
      translational = std::max(translational, most.energy_translational);
      total = std::max(total, most.energy_total);
      height = std::visit([&, from = from, to = to](
                              const auto& surface) { return max_height(surface, piece, is_sphere, from, to, height); },
                          *model.surface);
    }
  }
  const Motion& end = path.record.outcome.end;
  const EndReason reason = path.record.outcome.reason;
  const bool stays = reason != EndReason::left_model && reason != EndReason::lost && reason != EndReason::no_data;
  if (stays && area.polygon.contains(end.position.xy())) {
    if (!inside) inside = RockInside{.rock = path.record.rock};
    inside->stops = true;
  }
  if (inside) inside->maxima = {translational, total, std::sqrt(squared_velocity), lowest_point(height, reach)};
  return inside;
}

std::vector<std::uint64_t> AreaAnswer::stopping() const {
  std::vector<std::uint64_t> numbers;
  for (const RockInside& rock : entering) {
    if (rock.stops) numbers.push_back(rock.rock);
  }
  return numbers;
}

AreaAnswer ask_area(const Model& model, const project::DesignBasis& basis, const RockPaths& paths,
                    const AskedArea& area) {
  AreaAnswer answer{.plan = project::design_check(basis), .entering = {}, .rocks = paths.rocks().size()};
  const auto near = paths.near(area.bounds);
  constexpr std::size_t in_block = 64;
  std::vector<std::vector<RockInside>> found((near.size() + in_block - 1) / in_block);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t block) {
    RockPath path;
    for (std::size_t k = block * in_block; k < std::min(near.size(), (block + 1) * in_block); ++k) {
      paths.read(near[k], path);
      if (const auto inside = rock_inside(model, area, path)) found[block].push_back(*inside);
    }
  });
  for (const auto& block : found) answer.entering.insert(answer.entering.end(), block.begin(), block.end());
  return answer;
}

}  // namespace talus
