#include "talus/lines/asked_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "talus/model/build_terrain.hpp"

namespace talus {

namespace {

constexpr double largest = 1e9;  // of a coordinate [m], as in a project

/// The names of the model's barriers and collectors, for a message.
std::string names_of(const Model& model) {
  std::vector<std::string_view> names;
  for (const Barrier& barrier : model.barriers) names.push_back(barrier.name);
  if (names.empty()) return "it has none";
  return fmt::format("it has \"{}\"", fmt::join(names, "\", \""));
}

AskedLine collector_on(const project::BarrierFoot& foot, double height) {
  AskedLine asked;
  asked.barrier.is_collector = true;
  asked.barrier.set_panels(project::panels_along(foot, height, 0));
  return asked;
}

}  // namespace

void check_places(std::span<const PlanPlace> places, std::string_view where, Problems& problems) {
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto [x, y] = places[k];
    const std::string what = fmt::format("point {} is ({:g}, {:g})", k + 1, x, y);
    if (!std::isfinite(x) || !std::isfinite(y)) {
      problems.add({.where = std::string(where), .what = what, .why = "expected numbers"});
    } else if (std::max(std::abs(x), std::abs(y)) > largest) {
      problems.add({.where = std::string(where),
                    .what = what,
                    .why = fmt::format("coordinates are in metres, up to {:g}", largest)});
    }
  }
}

bool is_on_ground_swapped(const Model& model, std::span<const PlanPlace> places) {
  if (std::holds_alternative<Profile>(*model.surface)) return false;
  const Vec2 origin(model.frame.origin.x(), model.frame.origin.y());
  return std::ranges::any_of(
      places, [&](const PlanPlace& p) { return project::has_ground_at(model, Vec2(p[1], p[0]) - origin); });
}

AskedLine drawn_line(const Model& model, std::span<const PlanPlace> line, double height, std::string_view where,
                     Problems& warnings) {
  const bool in_section = std::holds_alternative<Profile>(*model.surface);
  const std::size_t fewest = in_section ? 1 : 2;
  Problems problems;
  if (line.size() < fewest) {
    problems.add({.where = std::string(where),
                  .what = fmt::format("has {} point{}", line.size(), line.size() == 1 ? "" : "s"),
                  .why = in_section ? "in 2D a line is a place on the section, expected its x"
                                    : "expected at least 2, from one end to the other"});
  }
  if (in_section && line.size() > 1) {
    problems.add({.where = std::string(where),
                  .what = fmt::format("has {} points", line.size()),
                  .why = "in 2D a line is a place on the section, expected its x alone"});
  }
  check_places(line, where, problems);
  if (problems.has_errors()) throw BadInput(problems);

  const project::BarrierFoot foot = project::foot_of(model, line);
  AskedLine asked = collector_on(foot, height);
  if (!in_section && foot.given < project::shortest_line) {
    throw BadInput(Problem{.where = std::string(where),
                           .what = fmt::format("is {:.3g} m long", foot.given),
                           .why = fmt::format("expected at least {:g} m", project::shortest_line)});
  }
  if (asked.barrier.panels().empty()) {
    throw BadInput(Problem{.where = std::string(where),
                           .what = "does not touch the terrain",
                           .why = "rocks are only known there",
                           .hint = is_on_ground_swapped(model, line) ? project::swapped_hint
                                                                     : "Give it in the coordinates of the project"});
  }
  constexpr double by_rounding = 1e-3;  // [m]
  if (const double off = foot.given - foot.on_ground; off > by_rounding) {
    warnings.add({.severity = Severity::warning,
                  .where = std::string(where),
                  .what = fmt::format("{:.6g} of {:.6g} m are off the terrain", off, foot.given),
                  .why = "its ends are cut there, and it crosses a gap in a straight line"});
  }
  return asked;
}

std::optional<AskedLine> line_on_ground(const Model& model, std::span<const PlanPlace> line, double height) {
  AskedLine asked = collector_on(project::foot_of(model, line), height);
  return asked.barrier.panels().empty() ? std::nullopt : std::optional(std::move(asked));
}

AskedLine line_of_barrier(const Model& model, std::string_view name, std::string_view where) {
  const auto found = std::ranges::find(model.barriers, name, &Barrier::name);
  if (found == model.barriers.end()) {
    throw BadInput(Problem{.where = std::string(where),
                           .what = fmt::format("the run has no barrier or collector \"{}\"", name),
                           .why = names_of(model)});
  }
  return {*found, static_cast<std::uint32_t>(found - model.barriers.begin())};
}

std::vector<Vec3> foot_of(const Barrier& barrier) {
  std::vector<Vec3> foot;
  for (const Panel& panel : barrier.panels()) {
    if (foot.empty() || (foot.back() - panel.foot).squared_norm() > 1e-12) foot.push_back(panel.foot);
    foot.emplace_back(panel.foot + panel.length * panel.along);
  }
  return foot;
}

}  // namespace talus
