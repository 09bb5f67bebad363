#include "talus/model/check_releases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "talus/campaign/release_survey.hpp"
#include "talus/campaign/rock_release.hpp"
#include "talus/seeding/release_height.hpp"

namespace talus::project {

namespace {

constexpr std::uint64_t sample = 2000;  // rocks; takes a few milliseconds
constexpr std::size_t most_rows_named = 5, most_seeders_named = 5;

/// A row by its name, or else by its number in the file, from 1.
std::string name_of_row(const ReleaseTable& table, std::size_t row) {
  const std::uint32_t number = table.number(row);
  const bool is_named = !table.names.empty() && !table.names[number - 1].empty();
  return is_named ? fmt::format("\"{}\"", table.names[number - 1]) : fmt::format("{}", number);
}

/// The rows from which rocks of a seeder start, `rows 3, 7 and 2 more`; empty if it has no table.
std::string rows_of(const talus::Seeder& seeder, std::uint64_t seed, std::span<const std::uint64_t> rocks) {
  const auto* table = std::get_if<ReleaseTable>(&*seeder.where);
  if (table == nullptr) return "";
  std::vector<std::size_t> rows;
  for (const std::uint64_t rock : rocks) rows.push_back(table->row_at(release_order(seeder, seed).place_of(rock)));
  std::ranges::sort(rows);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(rows.size(), most_rows_named); ++k)
    names.push_back(name_of_row(*table, rows[k]));
  const std::size_t more = rows.size() - names.size();
  return fmt::format("{} {}{}", rows.size() == 1 ? "row" : "rows", fmt::join(names, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

/// How the releases of a seeder are put onto the ground.
std::string way_onto_ground(const talus::Seeder& seeder) {
  if (std::holds_alternative<ReleaseTable>(*seeder.where))
    return "Compare z_m with the terrain; leave it empty to start on the ground, or give height_above_m instead";
  if (std::holds_alternative<Vec3>(*seeder.where))
    return "Compare z with the terrain; z = \"surface\" starts on the ground, height_above_m above it";
  if (std::holds_alternative<ReleaseLines>(*seeder.where))
    return "Compare z with the terrain, or give height_above_m instead";
  return "Lower height_above_m";
}

std::string named(const talus::Seeder& seeder) { return fmt::format("seeder \"{}\"", seeder.name); }

}  // namespace

void warn_of_high_releases(const Model& model, Problems& warnings) {
  const ReleaseSurvey survey = survey_releases(model, sample);
  if (survey.highest_m <= highest_release_m) return;
  const talus::Seeder& seeder = seeder_of(model, survey.highest);
  const std::string row = rows_of(seeder, model.seed, std::span(&survey.highest, 1));
  warnings.add({.severity = Severity::warning,
                .where = named(seeder),
                .what = fmt::format("a rock{} starts {:.4g} m above the ground", row.empty() ? "" : " of " + row,
                                    survey.highest_m),
                .why = "z is an elevation in the coordinate system of the terrain",
                .hint = way_onto_ground(seeder)});
}

void warn_of_buried_releases(const Model& model, Problems& warnings) {
  const ReleaseSurvey survey = survey_releases(model, sample);
  const bool is_all = survey.rocks == model.rocks();
  const std::span<const std::uint64_t> all(survey.in_ground);
  std::size_t seeders = 0;
  for (std::size_t first = 0; first < all.size();) {
    const talus::Seeder& seeder = seeder_of(model, all[first]);
    std::size_t end = first;
    while (end < all.size() && all[end] < seeder.first_rock + seeder.rocks) ++end;
    const auto rocks = all.subspan(first, end - first);
    first = end;
    if (++seeders > most_seeders_named) continue;
    const auto number = static_cast<std::size_t>(&seeder - model.seeders.data());
    const std::string rows = rows_of(seeder, model.seed, rocks);
    warnings.add({.severity = Severity::warning,
                  .where = named(seeder),
                  .what = fmt::format("{} of {}{} rocks start{} in the ground{}", rocks.size(),
                                      is_all ? "" : "a sample of ", survey.diameters[number].size(),
                                      rocks.size() == 1 ? "s" : "", rows.empty() ? "" : ", from " + rows),
                  .why = "a run lifts them onto the surface, or lowers them from a ceiling",
                  .hint = way_onto_ground(seeder)});
  }
  if (seeders <= most_seeders_named) return;
  warnings.add({.severity = Severity::warning,
                .where = "seeders",
                .what = fmt::format("so do rocks of {} more seeders", seeders - most_seeders_named)});
}

void warn_of_rocks_larger_than_cells(const Model& model, Problems& warnings) {
  const auto* raster = std::get_if<RasterSurface>(&*model.surface);
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
