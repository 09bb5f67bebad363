#include "talus/calibration/zone_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "talus/calibration/observed_places.hpp"

namespace talus::calibration {

namespace {

struct PlanExtent {
  Vec2 low = Vec2::all(INFINITY), high = Vec2::all(-INFINITY);
};

PlanExtent extent_of_zone(const ObservedZone& zone) {
  PlanExtent extent;
  for (const PlanPolygon& polygon : zone.polygons) {
    extent.low = extent.low.min(polygon.low());
    extent.high = extent.high.max(polygon.high());
  }
  return extent;
}

/// Whether a place of a grid has a property.
template <class Property>
bool is_anywhere(const PlanExtent& extent, Property&& has) {
  constexpr int places = 100;
  const Vec2 size = extent.high - extent.low;
  for (int i = 0; i < places; ++i) {
    for (int j = 0; j < places; ++j) {
      if (has(Vec2{extent.low.x() + size.x() * (i + 0.5) / places, extent.low.y() + size.y() * (j + 0.5) / places})) {
        return true;
      }
    }
  }
  return false;
}

bool overlap(const ObservedZone& one, const ObservedZone& other) {
  if (one.polygons.empty()) return std::min(one.to, other.to) > std::max(one.from, other.from);
  const PlanExtent a = extent_of_zone(one), b = extent_of_zone(other);
  const PlanExtent both{a.low.max(b.low), a.high.min(b.high)};
  return both.low.x() < both.high.x() && both.low.y() < both.high.y() &&
         is_anywhere(both, [&](const Vec2& p) { return one.contains(p) && other.contains(p); });
}

bool reaches_terrain(const ObservedZone& zone, const study::PreparedSite& site) {
  const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *site.model().surface);
  const Vec2 low = site.model().frame.global_from_local(box.low).xy();
  const Vec2 high = site.model().frame.global_from_local(box.high).xy();
  if (zone.polygons.empty()) return zone.from < high.x() && zone.to > low.x();
  return is_anywhere({low, high}, [&](const Vec2& p) { return zone.contains(p) && elevation_at(site, p); });
}

std::vector<Vec2> corners_of(const ObservedZone& zone) {
  if (zone.polygons.empty()) return {{zone.from, 0}, {zone.to, 0}};
  std::vector<Vec2> corners;
  for (const std::vector<Vec2>& outline : zone.outlines) corners.insert(corners.end(), outline.begin(), outline.end());
  return corners;
}

}  // namespace

void check_zone_places(const std::vector<ObservedZone>& zones, const std::vector<Problem>& places,
                       const study::PreparedSite& site, Problems& problems, Problems& warnings) {
  const auto add = [](Problems& list, Problem problem, std::string what, std::string why, std::string hint) {
    problem.what = std::move(what);
    problem.why = std::move(why);
    problem.hint = std::move(hint);
    list.add(std::move(problem));
  };
  for (std::size_t k = 0; k < zones.size(); ++k) {
    const ObservedZone& zone = zones[k];
    if (zone.polygons.empty() && !(zone.from < zone.to)) {
      add(problems, places[k], fmt::format("zone \"{}\" extends from {:g} to {:g} m", zone.name, zone.from, zone.to),
          "expected from_m below to_m", zone.from > zone.to ? "Exchange the two" : "");
      continue;
    }
    if (std::ranges::all_of(corners_of(zone), [&](const Vec2& p) { return elevation_at(site, p).has_value(); })) {
      continue;
    }
    if (!reaches_terrain(zone, site)) {
      add(problems, places[k], fmt::format("zone \"{}\" is off the terrain", zone.name), extent_of(site),
          "It may be in another coordinate system, or the terrain must be extended");
      continue;
    }
    Problem place = places[k];
    place.severity = Severity::warning;
    add(warnings, std::move(place), fmt::format("zone \"{}\" is partly off the terrain", zone.name),
        "simulated rocks that get there leave the model, and come to rest in no zone", "Extend the terrain");
  }
  for (std::size_t a = 0; a < zones.size(); ++a) {
    for (std::size_t b = a + 1; b < zones.size(); ++b) {
      if (!overlap(zones[a], zones[b])) continue;
      add(problems, places[b], fmt::format("zones \"{}\" and \"{}\" overlap", zones[a].name, zones[b].name),
          "a rock lies in one zone", "Draw zones that have only borders in common");
    }
  }
}

}  // namespace talus::calibration
