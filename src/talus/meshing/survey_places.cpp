#include "talus/meshing/survey_places.hpp"

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>

#include "talus/core/problems.hpp"
#include "talus/meshing/cleaning.hpp"

namespace talus {
namespace {

template <class Take>
void each_vertex(const Survey& survey, Take&& take) {
  for (const Vec3& p : survey.points) take(p);
  for (const auto& line : survey.lines) {
    for (const Vec3& p : line) take(p);
  }
}

ExactGrid grid_over(const Survey& survey, const std::string& source) {
  Vec2 low = Vec2::all(std::numeric_limits<double>::infinity()), high = -low;
  each_vertex(survey, [&](const Vec3& p) {
    if (!(p.abs().largest() < largest_coordinate_m)) {
      refuse_survey(source, fmt::format("({:.10g}, {:.10g}, {:.10g}) is too far from the origin", p.x(), p.y(), p.z()),
                    fmt::format("coordinates must be smaller than {:g} m", largest_coordinate_m),
                    "Are they in metres?");
    }
    low = low.min(p.xy());
    high = high.max(p.xy());
  });
  const double width = (high - low).largest();
  if (width > ExactGrid::widest_m) {
    refuse_survey(source, fmt::format("the survey is {:.0f} m wide", width),
                  fmt::format("Talus triangulates up to {:.0f} m", ExactGrid::widest_m),
                  "Is a point far from the others, or are they not in metres?");
  }
  return ExactGrid::over(low, high);
}

// A vertex of the survey, sorted by place.
struct VertexAt {
  GridPoint at;
  std::uint32_t vertex;
  bool operator<(const VertexAt& o) const { return at != o.at ? at < o.at : vertex < o.vertex; }
};

}  // namespace

void refuse_survey(const std::string& source, std::string what, std::string why, std::string hint) {
  throw BadInput(Problem{
      .file = source, .where = "terrain", .what = std::move(what), .why = std::move(why), .hint = std::move(hint)});
}

SurveyPlaces places_of(const Survey& survey, const std::string& source, SurveyReport& report) {
  report.points = survey.points.size();
  report.lines = survey.lines.size();
  for (const auto& line : survey.lines) report.line_vertices += line.size();
  const std::size_t count = report.points + report.line_vertices;
  if (count == 0) refuse_survey(source, "the survey has no points", "a surface needs three or more");
  if (count >= most_survey_places) {
    refuse_survey(source, fmt::format("the survey has {} points", count),
                  fmt::format("Talus triangulates fewer than {}", most_survey_places),
                  "Thin it or make a raster from it");
  }

  SurveyPlaces places;
  places.grid = grid_over(survey, source);
  report.grid_step_m = places.grid.spacing_m();
  std::vector<VertexAt> vertices;
  std::vector<double> heights;
  vertices.reserve(count);
  heights.reserve(count);
  each_vertex(survey, [&](const Vec3& p) {
    vertices.push_back({places.grid.snapped(p.x(), p.y()), static_cast<std::uint32_t>(vertices.size())});
    heights.push_back(p.z());
  });
  tbb::parallel_sort(vertices);

  // For each vertex the first vertex at its place; the entry of that one in `heights` becomes the place's height.
  std::vector<std::uint32_t> first(count);
  std::vector<std::uint8_t> is_on_line(count);
  const auto lines_from = static_cast<std::uint32_t>(report.points);
  for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
    while (end < count && vertices[end].at == vertices[begin].at) ++end;
    const std::uint32_t representative = vertices[begin].vertex;
    const bool on_line = vertices[end - 1].vertex >= lines_from;  // sorted: those of lines come last
    double low = std::numeric_limits<double>::infinity(), high = -low, sum = 0;
    std::size_t summed = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const double z = heights[vertices[k].vertex];
      first[vertices[k].vertex] = representative;
      low = std::min(low, z);
      high = std::max(high, z);
      if (on_line && vertices[k].vertex < lines_from) continue;
      sum += z;
      ++summed;
    }
    report.repeated += end - begin - 1;
    // Where all agree, the height is theirs to the bit.
    heights[representative] = low == high ? low : sum / static_cast<double>(summed);
    is_on_line[representative] = on_line;
    if (high - low < same_height_m) continue;
    const Vec2 plan = places.grid.place(vertices[begin].at);
    report.at_odds.add({plan.x(), plan.y(), heights[representative]});
    report.largest_difference_m = std::max(report.largest_difference_m, high - low);
  }

  std::vector<std::uint32_t> number(count);
  std::uint32_t vertex = 0;
  each_vertex(survey, [&](const Vec3& p) {
    if (first[vertex] == vertex) {
      number[vertex] = static_cast<std::uint32_t>(places.at.size());
      places.at.push_back(places.grid.snapped(p.x(), p.y()));
      places.height.push_back(heights[vertex]);
      places.is_on_line.push_back(is_on_line[vertex]);
    } else {
      number[vertex] = number[first[vertex]];
    }
    ++vertex;
  });
  vertex = lines_from;
  places.lines.reserve(survey.lines.size());
  for (const auto& line : survey.lines) {
    auto& numbers = places.lines.emplace_back();
    numbers.reserve(line.size());
    for (std::size_t k = 0; k < line.size(); ++k) numbers.push_back(number[vertex++]);
  }
  return places;
}

}  // namespace talus
