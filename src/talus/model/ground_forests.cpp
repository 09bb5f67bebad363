#include "talus/model/ground_forests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "talus/import/vector_file.hpp"
#include "talus/model/attribute_value.hpp"
#include "talus/project/named_files.hpp"

namespace talus::project {

namespace {

using ForestNumber = std::uint16_t;
constexpr ForestNumber no_forest = std::numeric_limits<ForestNumber>::max();

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
  constexpr std::size_t most_materials = std::numeric_limits<std::uint8_t>::max();
  const Stands stands(project, parts, warnings);
  const auto is_wooded = [&](std::size_t part) { return stands.of(part) != no_forest && parts.is_ground(part); };
  std::map<std::pair<ForestNumber, std::uint8_t>, std::size_t> numbers;  // by forest and by the material below it
  for (std::size_t part = 0; part < of_part.size(); ++part)
    if (is_wooded(part)) numbers[{stands.of(part), of_part[part]}] = 0;
  std::vector<LaidForest> laid;
  for (auto& [place, number] : numbers) {
    number = project.materials.size() + laid.size();
    laid.push_back({.material = place.second, .forest = place.first});
  }
  if (project.materials.size() + laid.size() > most_materials) {
    throw BadInput(Problem{
        .file = project.file.string(),
        .where = "[[forest]]",
        .what = fmt::format("{} materials lie in {} forests", project.materials.size(), project.forests.size()),
        .why = fmt::format("with each material in each of its forests there are {}, and the ground has at most {}",
                           project.materials.size() + laid.size(), most_materials),
        .hint = "Give forests of the same density and height one entry"});
  }
  for (std::size_t part = 0; part < of_part.size(); ++part)
    if (is_wooded(part)) of_part[part] = static_cast<std::uint8_t>(numbers.at({stands.of(part), of_part[part]}));
  return laid;
}

}  // namespace talus::project
