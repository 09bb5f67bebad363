#pragma once
// The distinct places of a survey on plan, each with one height.

#include <cstdint>
#include <string>
#include <vector>

#include "talus/meshing/survey_report.hpp"
#include "talus/meshing/survey_surface.hpp"
#include "talus/meshing/triangulation_grid.hpp"

namespace talus {

struct SurveyPlaces {
  ExactGrid grid;
  std::vector<GridPoint> at;                      // distinct; in order of first appearance, points before lines
  std::vector<double> height;                     // [m]
  std::vector<std::uint8_t> is_on_line;           // whether a line has a vertex there
  std::vector<std::vector<std::uint32_t>> lines;  // for each line, the places of its vertices

  [[nodiscard]] Vec3 place(std::uint32_t i) const {
    const Vec2 plan = grid.place(at[i]);
    return {plan.x(), plan.y(), height[i]};
  }
};

/// Fills in the points and lines in `report`. Throws BadInput for a survey that is empty, too wide or too large.
[[nodiscard]] SurveyPlaces places_of(const Survey& survey, const std::string& source, SurveyReport& report);

/// Throws BadInput about the data of a survey.
[[noreturn]] void refuse_survey(const std::string& source, std::string what, std::string why, std::string hint = "");

}  // namespace talus
