#include "talus/lines/side_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "talus/project/words.hpp"
#include "talus/terrain/section_along.hpp"

namespace talus::what_if {

namespace {

using Json = nlohmann::ordered_json;

/// The vertical plane on which paths are drawn; local.
struct Plane {
  Vec2 origin, along{1, 0};
  double first = 0, last = 0;  // of all paths, from the origin [m]

  [[nodiscard]] double of(const Vec2& place) const { return (place - origin).dot(along); }
};

Plane plane_of(const std::vector<Paths>& sets, bool is_section) {
  Plane plane;
  if (!is_section) {
    Vec2 start(0, 0), way(0, 0);
    std::size_t rocks = 0;
    for (const auto& path : sets.front()) {
      if (path.empty()) continue;
      start += path.front().xy();
      way += path.back().xy() - path.front().xy();
      ++rocks;
    }
    if (rocks > 0) plane.origin = start / static_cast<double>(rocks);
    if (way.norm() > 0) plane.along = way / way.norm();
  }
  bool is_first = true;
  for (const Paths& paths : sets) {
    for (const auto& path : paths) {
      for (const Vec3& point : path) {
        const double s = plane.of(point.xy());
        plane.first = is_first ? s : std::min(plane.first, s);
        plane.last = is_first ? s : std::max(plane.last, s);
        is_first = false;
      }
    }
  }
  const double margin = 0.05 * (plane.last - plane.first);
  plane.first -= margin;
  plane.last += margin;
  return plane;
}

/// Numbers to the centimetre.
double rounded(double metres) { return std::round(100 * metres) / 100; }

/// The places of the plane in the user's coordinates: x in 2D, otherwise from the mean release.
class View {
 public:
  View(const WhatIf& what_if, bool is_section)
      : model_(what_if.model()), plane_(plane_of(what_if.paths(), is_section)), is_section_(is_section) {}

  /// Points nearer to each other than can be seen are left out.
  [[nodiscard]] Json path(const std::vector<Vec3>& points) const {
    const double least = (plane_.last - plane_.first) / 600;
    Json drawn = Json::array();
    Vec3 last;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bool is_end = k == 0 || k + 1 == points.size();
      if (!is_end && (points[k] - last).norm() < least) continue;
      last = points[k];
      drawn.push_back(place(plane_.of(points[k].xy()), points[k].z()));
    }
    return drawn;
  }

  [[nodiscard]] Json ground() const {
    return std::visit([&](const auto& surface) { return ground_of(surface); }, *model_.surface);
  }

 private:
  [[nodiscard]] Json ground_of(const Profile& section) const {
    Json line = Json::array();
    const auto put = [&](const Vec3& point) { line.push_back(place(point.x(), point.z())); };
    const auto last = static_cast<std::uint32_t>(section.facet_count() - 1);
    for (std::uint32_t k = 0; k <= last; ++k) put(section.point_of(FacetId{k}));
    put(section.ridge(FacetId{last}, 1).from);
    return line;
  }

  template <class Surface>
  [[nodiscard]] Json ground_of(const Surface& surface) const {
    constexpr std::size_t max_points = 800;
    const std::array<Vec2, 2> ends{plane_.origin + plane_.first * plane_.along,
                                   plane_.origin + plane_.last * plane_.along};
    Json line = Json::array();
    for (const SectionPoint& point : section_along(surface, std::span<const Vec2>(ends), max_points))
      line.push_back(point.z ? place(plane_.first + point.distance, *point.z) : Json());
    return line;
  }

  [[nodiscard]] Json place(double s, double z) const {
    return {rounded(s + (is_section_ ? model_.frame.origin.x() : 0)), rounded(z + model_.frame.origin.z())};
  }

  const Model& model_;
  const Plane plane_;
  const bool is_section_;
};

/// At most 201 of ascending values, the first and the last among them.
Json even_ranks(const std::vector<double>& ascending) {
  constexpr std::size_t max_parts = 200;
  Json few = Json::array();
  if (ascending.empty()) return few;
  const std::size_t parts = std::clamp<std::size_t>(ascending.size() - 1, 1, max_parts);
  for (std::size_t k = 0; k <= parts; ++k) few.push_back(rounded(ascending[k * (ascending.size() - 1) / parts]));
  return few;
}

}  // namespace

Json side_view(const WhatIf& what_if) {
  const auto& sets = what_if.paths();
  if (sets.front().empty()) return nullptr;
  const bool is_section = std::holds_alternative<Profile>(*what_if.model().surface);
  const View view(what_if, is_section);
  Json json{{"is_section", is_section}, {"ground", view.ground()}, {"sets", Json::array()}};
  const auto add = [&](RockModel model, std::size_t set) {
    Json drawn = Json::array();
    for (const auto& path : sets[set]) drawn.push_back(view.path(path));
    json["sets"].push_back(
        {{"model", project::word(model)}, {"paths", std::move(drawn)}, {"runout_m", even_ranks(what_if.runouts(set))}});
  };
  add(what_if.rock_model(), 0);
  for (std::size_t k = 0; k < what_if.variations().size(); ++k)
    if (const auto& model = what_if.variations()[k].model) add(*model, k + 1);
  return json;
}

}  // namespace talus::what_if
