#include "talus/model/ground_forests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "talus/import/vector_file.hpp"
#include "talus/model/attribute_value.hpp"
#include "talus/project/named_files.hpp"

namespace talus::project {

namespace {

using ForestNumber = std::uint8_t;
constexpr std::size_t max_forests = 255;
constexpr ForestNumber no_forest = max_forests;
constexpr const char* fewer_forests = "Give forests of the same density and height one entry, with a file of polygons";

Problem about(const Project& project, const ForestArea& forest) {
  return {.file = project.file.string(), .line = forest.line, .where = fmt::format("forest \"{}\"", forest.name)};
}

/// The forest of each part.
class Stands {
 public:
  Stands(const Project& project, const GroundParts& parts, Problems& warnings)
      : project_(project), parts_(parts), warnings_(warnings), of_part_(parts.count(), no_forest) {
    Problems problems;
    for (std::size_t k = 0; k < project.forests.size(); ++k) {
      const ForestArea& forest = project.forests[k];
      const std::string where = name_in_problems(project, "forest", forest.name, k);
      try {
        lay(locating_problems(project, where, problems, warnings,
                              [&](Problems&, Problems& doubts) { return polygons_of(forest, doubts); }),
            static_cast<ForestNumber>(k));
      } catch (const BadInput& bad) {
        problems.append(bad.problems());
      }
    }
    if (problems.has_errors()) throw BadInput(std::move(problems));
  }

  [[nodiscard]] ForestNumber of(std::size_t part) const { return of_part_[part]; }

 private:
  void lay(const std::vector<PlanPolygon>& polygons, ForestNumber number) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Vec2 low(infinite, infinite), high = -low;
    bool has_effect = false;
    for (const PlanPolygon& polygon : polygons) {
      low = low.min(polygon.low());
      high = high.max(polygon.high());
      parts_.visit_within(polygon, [&](std::size_t part) {
        of_part_[part] = number;
        has_effect = has_effect || parts_.is_ground(part);
      });
    }
    if (!has_effect && !polygons.empty())
      warnings_.add(about_no_effect(about(project_, project_.forests[number]), parts_, low, high));
  }

  [[nodiscard]] std::vector<PlanPolygon> polygons_of(const ForestArea& forest, Problems& warnings) const {
    if (forest.polygons.empty()) return {plan_polygon(forest.polygon)};
    VectorRequest request{
        .layer = forest.layer, .kinds = {ShapeKind::polygon}, .terrain_crs_wkt = parts_.terrain().crs_wkt};
    if (!forest.attribute.empty()) request.attributes = {forest.attribute};
    const VectorLayer layer = read_vector_file(project_.file.parent_path() / forest.polygons, request, warnings);
    std::vector<bool> used(forest.values.size());
    std::vector<PlanPolygon> polygons;
    for (const VectorFeature& feature : layer.features) {
      if (!forest.attribute.empty() && !is_chosen(feature.values[0], layer.are_numbers[0], forest.values, used))
        continue;
      for (const VectorShape& part : feature.parts) polygons.emplace_back(part.lists);
    }
    warn_of_unused(forest, used, warnings);
    return polygons;
  }

  static bool is_chosen(const std::optional<std::string>& value, bool is_number, const std::vector<std::string>& chosen,
                        std::vector<bool>& used) {
    if (!value) return false;
    bool found = false;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      if (!is_same_value(*value, chosen[k], is_number)) continue;
      used[k] = found = true;
    }
    return found;
  }

  void warn_of_unused(const ForestArea& forest, const std::vector<bool>& used, Problems& warnings) const {
    for (std::size_t k = 0; k < used.size(); ++k) {
      if (used[k]) continue;
      Problem warning = about(project_, forest);
      warning.severity = Severity::warning;
      warning.what = fmt::format("values has \"{}\", which no polygon has", forest.values[k]);
      warning.why = fmt::format("in {} of polygons \"{}\"", forest.attribute, forest.polygons.string());
      warnings.add(std::move(warning));
    }
  }

  const Project& project_;
  const GroundParts& parts_;
  Problems& warnings_;
  std::vector<ForestNumber> of_part_;
};

}  // namespace

std::vector<LaidForest> lay_forests(const Project& project, const GroundParts& parts,
                                    std::vector<std::uint8_t>& of_part, Problems& warnings) {
  const auto refuse = [&](std::string what, std::string why) {
    throw BadInput(Problem{.file = project.file.string(),
                           .where = "[[forest]]",
                           .what = std::move(what),
                           .why = std::move(why),
                           .hint = fewer_forests});
  };
  if (project.forests.size() > max_forests) {
    refuse(fmt::format("there are {} forests", project.forests.size()),
           fmt::format("expected at most {}", max_forests));
  }
  const Stands stands(project, parts, warnings);
  // The number in the ground of each pair of a forest and the material below it; 0: there is none.
  constexpr std::size_t materials_below = max_materials_of_parts + 1;
  std::vector<std::size_t> numbers(project.forests.size() * materials_below);
  const auto number_at = [&](std::size_t part) -> std::size_t* {
    if (stands.of(part) == no_forest || !parts.is_ground(part)) return nullptr;
    return &numbers[stands.of(part) * materials_below + of_part[part]];
  };
  for (std::size_t part = 0; part < of_part.size(); ++part)
    if (std::size_t* const number = number_at(part)) *number = 1;
  std::vector<LaidForest> laid;
  for (std::size_t pair = 0; pair < numbers.size(); ++pair) {
    if (numbers[pair] == 0) continue;
    numbers[pair] = project.materials.size() + laid.size();
    laid.push_back({.material = static_cast<std::uint32_t>(pair % materials_below),
                    .forest = static_cast<std::uint32_t>(pair / materials_below)});
  }
  const std::size_t count = project.materials.size() + laid.size();
  if (count > max_materials_of_parts) {
    refuse(fmt::format("{} materials lie in {} forests", project.materials.size(), project.forests.size()),
           fmt::format("with each material in each of its forests there are {}, and the ground has at most {}", count,
                       max_materials_of_parts));
  }
  for (std::size_t part = 0; part < of_part.size(); ++part)
    if (const std::size_t* const number = number_at(part)) of_part[part] = static_cast<std::uint8_t>(*number);
  return laid;
}

}  // namespace talus::project
