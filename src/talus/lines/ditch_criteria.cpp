#include "talus/lines/ditch_criteria.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace talus {

namespace {

constexpr double foot = 0.3048;  // [m]
constexpr double least_height = 40 * foot, most_height = 80 * foot;
constexpr double least_angle = std::numbers::pi / 4;  // 1H:1V
constexpr double rounding = 1e-6;                     // of places in coordinates of millions [m], and of angles

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

const char* const tests = "tested were slopes of 12.2 to 24.4 m (40 to 80 ft), from 1H:1V (45 degrees) to vertical";

/// W = 0.2 H + 4.5 m, H: height of the bench [m].
DitchCriterion modified_ritchie(const SlopeAbove& slope) {
  DitchCriterion criterion{.name = "Modified Ritchie criterion",
                           .source =
                               "as given by Warren et al. (2025), Preliminary expansion of the Modified Ritchie "
                               "Criterion, SSIM 2025, Australian Centre for Geomechanics, abstract",
                           .width = std::nullopt,
                           .text = {}};
  if (!is_in_tested_range(slope)) {
    criterion.text = fmt::format("outside of the tested range: {}", tests);
    return criterion;
  }
  criterion.width = 0.2 * slope.height + 4.5;
  constexpr double usual_face = 65;  // [deg]
  const double face = degrees(slope.angle);
  criterion.text = fmt::format("{:.1f} m: catch benches of mines, W = 0.2 H + 4.5 m; for about 90 % of the rocks, {}",
                               *criterion.width,
                               face > usual_face ? "less suffices on faces steeper than 65 degrees, as here"
                                                 : "more is needed on faces flatter than 65 degrees, as here");
  return criterion;
}

DitchCriterion oregon(const SlopeAbove& slope) {
  const char* const source =
      "Pierson, Gullixson and Chassie (2001), Rockfall Catchment Area Design Guide, FHWA-OR-RD-02-04";
  if (!is_in_tested_range(slope)) {
    return {.name = "Oregon design guide",
            .source = source,
            .width = std::nullopt,
            .text = fmt::format("outside of the chart: {}", tests)};
  }
  return {
      .name = "Oregon design guide",
      .source = source,
      .width = std::nullopt,
      .text = fmt::format("within the tested range: look up its chart for {:.0f} ft and {:.2f}H:1V, and compare the "
                          "share retained; the values of the charts are not in Talus",
                          slope.height / foot, 1 / std::tan(slope.angle))};
}

DitchCriterion ritchie() {
  return {.name = "Ritchie's table",
          .source = "Ritchie (1963), Evaluation of rockfall and its control, Highway Research Record 17",
          .width = std::nullopt,
          .text = "width and depth by height and angle: not in Talus, because the table itself could not be read"};
}

}  // namespace

bool is_in_tested_range(const SlopeAbove& slope) {
  return slope.height >= least_height - rounding && slope.height <= most_height + rounding &&
         slope.angle >= least_angle - rounding && slope.angle <= std::numbers::pi / 2 + rounding;
}

std::vector<DitchCriterion> ditch_criteria(const SlopeAbove& slope) {
  return {modified_ritchie(slope), oregon(slope), ritchie()};
}

}  // namespace talus
