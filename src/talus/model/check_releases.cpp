#include "talus/model/check_releases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "talus/campaign/release_survey.hpp"
#include "talus/seeding/release_height.hpp"

namespace talus::project {

namespace {

constexpr std::uint64_t sample = 2000;  // rocks; takes a few milliseconds

}  // namespace

void warn_of_high_releases(const Model& model, Problems& warnings) {
  const ReleaseSurvey survey = survey_releases(model, sample);
  if (survey.highest_m <= highest_release_m) return;
  warnings.add({.severity = Severity::warning,
                .where = fmt::format("seeder \"{}\"", model.seeders[survey.highest_seeder.index].name),
                .what = fmt::format("a rock starts {:.4g} m above the ground", survey.highest_m),
                .why = "z is an elevation in the coordinate system of the terrain",
                .hint = "Use z = \"surface\" on the ground, height_above_m above it"});
}

void warn_of_buried_releases(const Model& model, Problems& warnings) {
  const ReleaseSurvey survey = survey_releases(model, sample);
  if (survey.in_ground == 0) return;
  const bool is_all = survey.rocks == model.rocks();
  warnings.add({.severity = Severity::warning,
                .where = "seeders",
                .what = fmt::format("{} of {}{} rocks start in the ground", survey.in_ground,
                                    is_all ? "" : "a sample of ", survey.rocks),
                .why = "a run lifts them onto the surface, or lowers them from a ceiling",
                .hint = "Compare their z with the terrain, or use z = \"surface\""});
}

void warn_of_rocks_larger_than_cells(const Model& model, Problems& warnings) {
  const auto* raster = std::get_if<RasterSurface>(&model.surface);
  if (raster == nullptr) return;
  const double cell = std::min(raster->grid().dx, raster->grid().dy);
  ReleaseSurvey survey = survey_releases(model, sample);
  for (std::size_t k = 0; k < model.seeders.size(); ++k) {
    std::vector<double>& diameters = survey.diameters[k];
    if (diameters.empty()) continue;
    // The diameter that one in twenty reaches, so that the tail of a distribution is no cause for a warning.
    const auto large = diameters.begin() + static_cast<std::ptrdiff_t>(diameters.size() * 19 / 20);
    std::ranges::nth_element(diameters, large);
    constexpr double by_rounding = 1e-6;  // of cell sizes in files
    if (*large <= cell * (1 + by_rounding)) continue;
    warnings.add({.severity = Severity::warning,
                  .where = fmt::format("seeder \"{}\"", model.seeders[k].name),
                  .what = fmt::format("rocks of {:.3g} m in diameter are larger than the terrain's cells of {:.3g} m",
                                      *large, cell),
                  .why = "a rock bridges bumps that are smaller than itself; a point mass or a sphere follows them all",
                  .hint = fmt::format("Average the elevations to cells of {:.2g} m or more, and give smaller bumps as "
                                      "roughness",
                                      std::max(*large, 2 * cell))});
  }
}

}  // namespace talus::project
