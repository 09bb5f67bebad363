#include "talus/meshing/survey_report.hpp"

#include <fmt/format.h>

namespace talus {
namespace {

// A side at the rim that is so many times as long as the middle side spans a bay of the survey.
constexpr double bay = 20;

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
  text.line("triangulated: {}{}; sides of {:.3g} m in the middle, at most {:.4g} m{}",
            counted(triangles, "triangle", "triangles"),
            holes > 0 ? fmt::format(" around {}", counted(holes, "hole", "holes")) : "", median_side_m, longest_side_m,
            at(longest_side_at));
  if (repeated > 0) {
    text.line("left out: {} where another lies", counted(repeated, "point or vertex", "points or vertices"));
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
  if (judged > 0) {
    text.line("heights depart from the plane of their neighbours by {:.2g} m in the middle, by {:.3g} m at most{}",
              median_departure_m, greatest_departure_m, at(greatest_departure_at));
  }
  if (stand_out.count > 0) {
    text.line("{} out where the neighbours are smooth (remove_spikes_m removes such){}",
              counted(stand_out.count, "point stands", "points stand"), stand_out.places());
  }
  const ConstraintReport& laid = lines_laid;
  if (laid.crossings.count > 0) {
    text.line("lines cross in {}{}", counted(laid.crossings.count, "place", "places"), laid.crossings.places());
  }
  if (laid.without_length > 0) {
    text.line("left out: {} without length on plan",
              counted(laid.without_length, "piece of a line", "pieces of lines"));
  }
  if (laid.upon_another > 0) {
    text.line("{} upon another", counted(laid.upon_another, "piece of a line lies", "pieces of lines lie"));
  }
  if (slivers.count > 0) {
    text.line("{} an angle below {:g} degree on plan{}", counted(slivers.count, "triangle has", "triangles have"),
              sliver_angle_deg, slivers.places());
  }
  if (at_odds.count > 0) {
    text.line(
        "warning: {} several heights, up to {:.3g} m apart (their mean is taken, that of lines before that of "
        "points){}",
        counted(at_odds.count, "place has", "places have"), greatest_odds_m, at_odds.places());
  }
  if (laid.crossings_at_odds.count > 0) {
    text.line("warning: {} at different heights, up to {:.3g} m apart (their mean is taken){}",
              counted(laid.crossings_at_odds.count, "crossing has lines", "crossings have lines"), laid.greatest_odds_m,
              laid.crossings_at_odds.places());
  }
  if (laid.vertices_beside.count > 0) {
    text.line("warning: {} through a point at another height, up to {:.3g} m apart (the point's is taken){}",
              counted(laid.vertices_beside.count, "line passes", "lines pass"), laid.greatest_beside_m,
              laid.vertices_beside.places());
  }
  if (flat.count > 0) {
    text.line(
        "warning: {} level, with all corners on lines at one height, {:.4g} m2 in all (contours say nothing between "
        "them; "
        "add spot heights or ridge and valley lines){}",
        counted(flat.count, "triangle is", "triangles are"), flat_area_m2, flat.places());
  }
  if (longest_rim_m > bay * median_side_m) {
    text.line(
        "warning: the longest side at the rim is {:.4g} m, {:.0f} times the middle one{} (max_edge_m or boundary "
        "leaves out "
        "what spans a bay)",
        longest_rim_m, longest_rim_m / median_side_m, at(longest_rim_at));
  }
  return text.take();
}

}  // namespace talus
