#include "talus/meshing/survey_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/meshing/survey_departures.hpp"
#include "talus/meshing/survey_diagonals.hpp"
#include "talus/meshing/survey_places.hpp"
#include "talus/meshing/survey_rim.hpp"

namespace talus {
namespace {

void check_extent(const SurveyPlaces& places, const std::string& source) {
  if (places.at.size() < 3) {
    refuse_survey(source, fmt::format("the survey has {}", counted(places.at.size(), "place", "places")),
                  "a surface needs three or more");
  }
  if (!Triangulation::span_a_plane(places.at)) {
    refuse_survey(source, fmt::format("all {} places of the survey lie on one line", places.at.size()),
                  "they span no surface", "For a 2D slope use section");
  }
}

// Removes some places, none of which is on a line.
SurveyPlaces without(const SurveyPlaces& places, const std::vector<std::uint32_t>& removed) {
  SurveyPlaces out;
  out.grid = places.grid;
  std::vector<std::uint32_t> number(places.at.size());
  auto next = removed.begin();
  for (std::uint32_t i = 0; i < places.at.size(); ++i) {
    if (next != removed.end() && *next == i) {
      ++next;
      continue;
    }
    number[i] = static_cast<std::uint32_t>(out.at.size());
    out.at.push_back(places.at[i]);
    out.height.push_back(places.height[i]);
    out.is_on_line.push_back(places.is_on_line[i]);
  }
  out.lines = places.lines;
  for (auto& line : out.lines) {
    for (std::uint32_t& vertex : line) vertex = number[vertex];
  }
  return out;
}

// Removes spikes in rounds, since each makes its neighbours depart, too.
Triangulation without_spikes(SurveyPlaces& places, const SurveyOptions& options, SurveyReport& report) {
  Triangulation triangulation(places.at);
  while (options.remove_spikes_m) {
    const auto found = spikes(triangulation, places, *options.remove_spikes_m);
    if (found.empty()) break;
    for (const std::uint32_t v : found) report.removed_spikes.add(places.place(v));
    places = without(places, found);
    check_extent(places, options.source);
    triangulation = Triangulation(places.at);
  }
  return triangulation;
}

// Lengths, angles and level triangles of the finished surface.
void report_shape(const RawMesh& mesh, const std::vector<std::uint8_t>& is_on_line, SurveyReport& report) {
  std::vector<float> sides;
  sides.reserve(3 * mesh.triangles.size());
  const double least = std::cos(sliver_angle_deg * std::numbers::pi / 180);
  for (const auto& corner : mesh.triangles) {
    std::array<Vec3, 3> p, along;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.vertices[corner[k]];
    bool is_sliver = false;
    for (std::size_t k = 0; k < 3; ++k) {
      along[k] = p[(k + 1) % 3] - p[k];
      const double length = along[k].xy().norm();
      sides.push_back(static_cast<float>(length));
      if (length <= report.longest_side_m) continue;
      report.longest_side_m = length;
      report.longest_side_at = p[k] + 0.5 * along[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 u = along[k].xy(), v = -along[(k + 2) % 3].xy();
      is_sliver = is_sliver || u.dot(v) > least * u.norm() * v.norm();
    }
    const Vec3 middle = (p[0] + p[1] + p[2]) / 3;
    if (is_sliver) report.slivers.add(middle);
    const bool on_lines = std::all_of(corner.begin(), corner.end(), [&](auto v) { return is_on_line[v] != 0; });
    if (on_lines && p[0].z() == p[1].z() && p[1].z() == p[2].z()) {
      report.flat.add(middle);
      report.flat_area_m2 += 0.5 * (along[0].x() * along[1].y() - along[0].y() * along[1].x());
    }
  }
  const auto median = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
  std::nth_element(sides.begin(), median, sides.end());
  report.median_side_m = double{*median};
  report.triangles = mesh.triangles.size();
}

}  // namespace

SurveySurface surface_of(const Survey& survey, const SurveyOptions& options) {
  SurveySurface surface;
  SurveyReport& report = surface.report;
  SurveyPlaces places = places_of(survey, options.source, report);
  check_extent(places, options.source);
  Triangulation triangulation = without_spikes(places, options, report);
  if (!survey.points.empty()) report_departures(triangulation, places, report);

  ConstrainedTriangulation lines(triangulation, places.height, places.grid);
  for (const auto& line : places.lines) {
    for (std::size_t k = 1; k < line.size(); ++k) {
      stop_point(k - 1);
      lines.add(line[k - 1], line[k]);
    }
  }
  report.constraints = lines.report();
  for (auto v = static_cast<std::uint32_t>(places.at.size()); v < triangulation.vertex_count(); ++v) {
    places.at.push_back(triangulation.point(v));  // where lines cross
    places.is_on_line.push_back(1);
  }

  choose_diagonals(triangulation, places);
  const auto kept = kept_triangles(triangulation, places.grid, options, report);
  RawMesh& mesh = surface.mesh;
  mesh.vertices.reserve(places.at.size());
  for (std::uint32_t v = 0; v < places.at.size(); ++v) mesh.vertices.push_back(places.place(v));
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    if (kept[i]) mesh.triangles.push_back(triangulation.triangles()[i].corner);
  }
  if (mesh.triangles.empty()) {
    refuse_survey(
        options.source, "no triangle of the survey remains",
        fmt::format("{} are beyond the boundary, {} at the rim have a side longer than max_edge_m, and {} at the "
                    "rim are almost a line",
                    report.beyond_boundary, report.with_long_sides, report.flat_at_rim));
  }
  report.holes = holes_in(triangulation, kept);
  report_rim(triangulation, places, kept, report);
  report_shape(mesh, places.is_on_line, report);
  return surface;
}

}  // namespace talus
