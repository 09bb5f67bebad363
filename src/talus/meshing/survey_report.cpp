#include "talus/meshing/survey_report.hpp"

#include <fmt/format.h>

namespace talus {
namespace {

// A side at the rim this many times as long as the median side spans a bay of the survey.
constexpr double bay_ratio = 20;

class Text {
 public:
  template <class... Parts>
  void line(fmt::format_string<Parts...> text, Parts&&... parts) {
    if (!out_.empty()) out_ += '\n';
    out_ += fmt::format(text, std::forward<Parts>(parts)...);
  }
  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

std::string at(const std::optional<Vec3>& place) {
  return place ? fmt::format(", at ({:.3f}, {:.3f}, {:.3f})", place->x(), place->y(), place->z()) : "";
}

}  // namespace

std::string SurveyReport::text() const {
  Text text;
  const std::string of_lines =
      fmt::format("{} of {}", counted(lines, "line", "lines"), counted(line_vertices, "vertex", "vertices"));
  const std::string of_points = counted(points, "point", "points");
  text.line("survey: {}{}{}, placed to {:.2g} mm", points > 0 ? of_points : "", points > 0 && lines > 0 ? " and " : "",
            lines > 0 ? of_lines : "", 500 * grid_step_m);
  text.line("triangulated: {}{}; median side {:.3g} m, longest {:.4g} m{}", counted(triangles, "triangle", "triangles"),
            holes > 0 ? fmt::format(" around {}", counted(holes, "hole", "holes")) : "", median_side_m, longest_side_m,
            at(longest_side_at));
  if (repeated > 0) {
    text.line("left out: {} at the same place as another", counted(repeated, "point or vertex", "points or vertices"));
  }
  if (beyond_boundary > 0) {
    text.line("left out: {} beyond the boundary", counted(beyond_boundary, "triangle", "triangles"));
  }
  if (with_long_sides > 0) {
    text.line("left out: {} at the rim with a side longer than max_edge_m",
              counted(with_long_sides, "triangle", "triangles"));
  }
  if (flat_at_rim > 0) {
    text.line("left out: {} at the rim that are almost a line", counted(flat_at_rim, "triangle", "triangles"));
  }
  if (removed_spikes.count > 0) {
    text.line("removed: {}{}", counted(removed_spikes.count, "spike", "spikes"), removed_spikes.places());
  }
  if (interior_points > 0) {
    text.line("departure of heights from the plane of their neighbours: median {:.2g} m, maximum {:.3g} m{}",
              median_departure_m, largest_departure_m, at(largest_departure_at));
  }
  if (outliers.count > 0) {
    text.line("{} out from smooth surroundings (remove_spikes_m removes such points){}",
              counted(outliers.count, "point stands", "points stand"), outliers.places());
  }
  const ConstraintReport& laid = constraints;
  if (laid.crossings.count > 0) {
    text.line("lines cross in {}{}", counted(laid.crossings.count, "place", "places"), laid.crossings.places());
  }
  if (laid.zero_length > 0) {
    text.line("left out: {} without length on plan", counted(laid.zero_length, "piece of a line", "pieces of lines"));
  }
  if (laid.overlapping > 0) {
    text.line("{} on another", counted(laid.overlapping, "piece of a line lies", "pieces of lines lie"));
  }
  if (slivers.count > 0) {
    text.line("{} an angle below {:g} degree on plan{}", counted(slivers.count, "triangle has", "triangles have"),
              sliver_angle_deg, slivers.places());
  }
  if (at_odds.count > 0) {
    text.line(
        "warning: {} several heights, up to {:.3g} m apart (their mean is used; heights of lines precede those of "
        "points){}",
        counted(at_odds.count, "place has", "places have"), largest_difference_m, at_odds.places());
  }
  if (laid.crossings_at_odds.count > 0) {
    text.line("warning: {} at different heights, up to {:.3g} m apart (their mean is used){}",
              counted(laid.crossings_at_odds.count, "crossing has lines", "crossings have lines"),
              laid.largest_difference_m, laid.crossings_at_odds.places());
  }
  if (laid.vertices_at_odds.count > 0) {
    text.line("warning: {} through a point at another height, up to {:.3g} m apart (the point's height is used){}",
              counted(laid.vertices_at_odds.count, "line passes", "lines pass"), laid.largest_vertex_difference_m,
              laid.vertices_at_odds.places());
  }
  if (flat.count > 0) {
    text.line(
        "warning: {} level, with all corners on lines at one height, {:.4g} m2 in all (contours give no heights "
        "between them; add spot heights or ridge and valley lines){}",
        counted(flat.count, "triangle is", "triangles are"), flat_area_m2, flat.places());
  }
  if (longest_rim_m > bay_ratio * median_side_m) {
    text.line(
        "warning: the longest side at the rim is {:.4g} m, {:.0f} times the median{} (max_edge_m or boundary leaves "
        "out triangles across a bay)",
        longest_rim_m, longest_rim_m / median_side_m, at(longest_rim_at));
  }
  return text.take();
}

}  // namespace talus
