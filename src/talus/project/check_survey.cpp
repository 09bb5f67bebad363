#include "talus/project/check_survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "talus/files/file_formats.hpp"
#include "talus/project/named_files.hpp"
#include "talus/project/values.hpp"

namespace talus::project {

void SurveyRules::check() const {
  check_files();
  check_polylines();
}

void SurveyRules::check_files() const {
  const SurveyTerrain& survey = project.terrain.survey;
  const std::array<std::pair<std::string_view, const std::filesystem::path*>, 4> files{
      {{"points", &survey.points},
       {"lines", &survey.lines},
       {"boundary", &survey.boundary},
       {"polygons", &project.terrain.polygons.file}}};
  for (const auto& [key, file] : files) {
    const auto* node = accepted(key);
    if (!node) continue;
    const std::string why = why_unreadable(project, *file);
    if (why.empty()) continue;
    report(node, fmt::format("{} is {}", key, quoted(*node)), why, "The path is relative to the project file",
           Severity::error);
  }
  if (!accepted("points")) return;
  if (const auto* classes = accepted("point_classes"); classes && !is_of_kind(survey.points, FileKind::las)) {
    report(classes, fmt::format("point_classes is given for {}", survey.points.filename().string()),
           "only LAS points have classes", "Leave it out", Severity::error);
  }
}

void SurveyRules::check_polylines() const {
  const auto* list = accepted("polylines");
  if (!list) return;
  const auto& polylines = project.terrain.polygons.polylines;
  if (polylines.empty()) report(list, "polylines is empty", "a terrain has at least one", "", Severity::error);
  std::size_t reported = 0;
  for (std::size_t i = 0; i < polylines.size() && reported < most_reported; ++i) {
    const auto& line = polylines[i];
    const toml::node* node = list->as_array()->get(i);
    const std::string name = fmt::format("polylines[{}]", i);
    if (line.size() < 4) {
      report(node, fmt::format("{} has {} vertices", name, line.size()),
             "a closed polyline has four or more, the last equal to the first", "", Severity::error);
      ++reported;
      continue;
    }
    const auto& [x0, y0, z0] = line.front();
    const auto& [x1, y1, z1] = line.back();
    const double apart = std::hypot(x1 - x0, y1 - y0, z1 - z0);
    if (apart <= project.terrain.merge_tolerance_m) continue;
    report(node, fmt::format("{} is not closed", name), fmt::format("its ends are {:.4g} m apart", apart),
           "Repeat its first vertex at its end", Severity::error);
    ++reported;
  }
}

}  // namespace talus::project
