#include "talus/model/check_releases.hpp"

#include <fmt/format.h>

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

}  // namespace talus::project
