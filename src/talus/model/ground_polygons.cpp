#include "talus/model/ground_polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "talus/core/nearest.hpp"
#include "talus/import/vector_file.hpp"
#include "talus/model/attribute_value.hpp"
#include "talus/model/ground_parts.hpp"

namespace talus::project {

namespace {

constexpr std::uint8_t nothing = 255;   // no polygon yet
constexpr std::size_t max_listed = 10;  // values or names in one problem

/// A list for a problem: the first items, and the number of the others.
std::string listed(const std::vector<std::string>& items) {
  std::string out;
  for (std::size_t i = 0; i < items.size() && i < max_listed; ++i) out += (i == 0 ? "" : ", ") + items[i];
  if (items.size() > max_listed) out += fmt::format(" and {} more", items.size() - max_listed);
  return out;
}

class Assignment {
 public:
  Assignment(const Project& project, const BuiltTerrain& terrain, Problems& warnings)
      : project_(project),
        terrain_(terrain),
        warnings_(warnings),
        parts_(terrain),
        layer_(read_vector_file(project.file.parent_path() / project.ground.polygons,
                                {.layer = project.ground.layer,
                                 .attributes = {project.ground.attribute},
                                 .kinds = {ShapeKind::polygon},
                                 .polygons_are_in_space = false,
                                 .heights_are_used = false,
                                 .terrain_crs_wkt = terrain.crs_wkt},
                                warnings)) {}

  std::vector<std::uint8_t> materials() {
    find_materials();
    assign();
    report_unused();
    report_overlaps();
    report_gaps();
    return std::move(of_part_);
  }

 private:
  [[nodiscard]] Problem about(std::string what, std::string why, std::string hint = "") const {
    return {.file = project_.file.string(),
            .where = "[ground]",
            .what = std::move(what),
            .why = std::move(why),
            .hint = std::move(hint)};
  }
  void warn(std::string what, std::string why, std::string hint = "") {
    Problem problem = about(std::move(what), std::move(why), std::move(hint));
    problem.severity = Severity::warning;
    warnings_.add(std::move(problem));
  }
  [[nodiscard]] std::string file() const { return fmt::format("polygons \"{}\"", project_.ground.polygons.string()); }
  /// The entry of `values` for a value of the attribute.
  [[nodiscard]] auto entry_of(const std::string& value) const {
    const auto& values = project_.ground.values;
    const auto same = values.find(value);
    if (same != values.end()) return same;
    return std::ranges::find_if(
        values, [&](const auto& entry) { return is_same_value(value, entry.first, layer_.are_numbers[0]); });
  }

  /// Finds the material of each feature. Throws BadInput if one has none.
  void find_materials() {
    const Ground& ground = project_.ground;
    std::map<std::string, std::uint64_t> unknown;
    std::vector<std::string> without, unused;
    std::vector<bool> used(project_.materials.size());
    std::map<std::string, bool> used_values;
    for (const auto& [value, material] : ground.values) used_values[value] = false;
    for (const VectorFeature& feature : layer_.features) {
      const std::optional<std::string>& value = feature.values[0];
      of_feature_.push_back(nothing);
      if (!value || value->empty()) {
        without.push_back(std::to_string(feature.id));
        continue;
      }
      std::optional<std::uint32_t> number;
      if (ground.values.empty()) {
        number = project_.number_of_material(*value);
      } else if (const auto known = entry_of(*value); known != ground.values.end()) {
        used_values[known->first] = true;
        number = project_.number_of_material(known->second);
      }
      if (number) {
        of_feature_.back() = static_cast<std::uint8_t>(*number);
        used[*number] = true;
      } else {
        ++unknown[*value];
      }
    }
    Problems problems;
    if (!without.empty()) {
      problems.add(about(
          fmt::format("{} of {} polygons have no {}", without.size(), layer_.features.size(), ground.attribute),
          fmt::format("feature {} of {}", listed(without), file()), "Give each a value, or remove it from the file"));
    }
    if (!unknown.empty()) problems.add(about_unknown(unknown));
    if (problems.has_errors()) throw BadInput(std::move(problems));
    for (const auto& [value, is_used] : used_values) {
      if (!is_used) unused.push_back('"' + value + '"');
    }
    if (!unused.empty()) {
      warn(fmt::format("values has {}, which no polygon has", listed(unused)),
           fmt::format("in {} of layer \"{}\"", ground.attribute, layer_.name));
    }
    used_ = std::move(used);
  }

  [[nodiscard]] Problem about_unknown(const std::map<std::string, std::uint64_t>& unknown) const {
    const Ground& ground = project_.ground;
    std::vector<std::string> values;
    for (const auto& [value, count] : unknown) values.push_back(fmt::format("\"{}\" in {}", value, count));
    std::vector<std::string_view> names;
    for (const auto& [value, material] : ground.values) names.push_back(value);
    if (ground.values.empty()) {
      for (const Material& material : project_.materials) names.push_back(material.name);
    }
    const std::string& first = unknown.begin()->first;
    const auto near = nearest(first, names);
    return about(fmt::format("{} has values of {} {}", file(), ground.attribute,
                             ground.values.empty() ? "that are not materials" : "that are not in values"),
                 fmt::format("{} of {} polygons", listed(values), layer_.features.size()),
                 near                    ? fmt::format("Did you mean \"{}\" instead of \"{}\"?", *near, first)
                 : ground.values.empty() ? fmt::format("Assign a material: values = {{ \"{}\" = \"{}\" }}", first,
                                                       project_.materials.front().name)
                                         : fmt::format("Add \"{}\" = \"...\" to values", first));
  }

  void assign() {
    of_part_.assign(parts_.count(), nothing);
    const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *terrain_.surface);
    const Vec2 south_west = terrain_.frame.global_from_local(box.low).xy();
    const Vec2 north_east = terrain_.frame.global_from_local(box.high).xy();
    Vec2 low = Vec2::all(std::numeric_limits<double>::infinity()), high = -low;
    std::uint64_t elsewhere = 0;
    for (std::size_t f = 0; f < layer_.features.size(); ++f) {
      bool touches = false;
      for (const VectorShape& part : layer_.features[f].parts) {
        const PlanPolygon polygon(part.lists);
        low = low.min(polygon.low());
        high = high.max(polygon.high());
        if (!polygon.low().is_at_most(north_east) || !south_west.is_at_most(polygon.high())) {
          continue;
        }
        touches = true;
        parts_.visit_within(polygon, [&](std::size_t at) { put(at, f); });
      }
      if (!touches) ++elsewhere;
    }
    if (elsewhere == layer_.features.size()) {
      throw BadInput(about(file() + " do not reach the terrain",
                           fmt::format("they lie within x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}; the terrain "
                                       "within x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}",
                                       low.x(), high.x(), low.y(), high.y(), south_west.x(), north_east.x(),
                                       south_west.y(), north_east.y()),
                           "Check their extent and coordinate system with ogrinfo"));
    }
    if (elsewhere > 0) {
      warn(fmt::format("{} of {} polygons do not reach the terrain", elsewhere, layer_.features.size()),
           fmt::format("{} covers more than is needed, or some polygons are misplaced", file()));
    }
  }

  void put(std::size_t part, std::size_t feature) {
    std::uint8_t& material = of_part_[part];
    const std::uint8_t wanted = of_feature_[feature];
    if (material != nothing && material != wanted && parts_.is_ground(part)) {
      if (overlaps_.empty()) {
        overlaps_.resize(of_part_.size());
        first_overlap_ = {part, feature};
      }
      overlaps_[part] = true;
    }
    material = wanted;
  }

  void report_unused() {
    std::vector<std::string> unused;
    for (const Area& area : project_.areas) used_[*project_.number_of_material(area.material)] = true;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      if (used_[i] || project_.materials[i].name == project_.ground.default_material) continue;
      unused.push_back('"' + project_.materials[i].name + '"');
    }
    if (unused.empty()) return;
    warn(fmt::format("{} {} not used", listed(unused), unused.size() == 1 ? "is" : "are"),
         "no polygon has this material, and it is not the default");
  }

  struct Sum {
    std::uint64_t parts = 0;
    double area = 0, of = 0;  // on plan [m2]
  };
  /// "120 of 4161 cells (12000 m2, 2.9 %)"
  template <class Is>
  [[nodiscard]] Sum sum(Is&& is) const {
    Sum total;
    for (std::size_t part = 0; part < of_part_.size(); ++part) {
      if (!parts_.is_ground(part)) continue;
      total.of += parts_.area(part);
      if (!is(part)) continue;
      ++total.parts;
      total.area += parts_.area(part);
    }
    return total;
  }

  void report_overlaps() {
    if (overlaps_.empty()) return;
    const Sum total = sum([&](std::size_t part) { return overlaps_[part]; });
    // The feature that was replaced there: the last earlier one with another material that contains the place.
    const auto& [part, later] = first_overlap_;
    const Vec2 at = parts_.centre(part);
    std::size_t earlier = later;
    const auto contains = [&](std::size_t f) {
      const auto& shapes = layer_.features[f].parts;
      return std::any_of(shapes.begin(), shapes.end(),
                         [&](const VectorShape& shape) { return PlanPolygon(shape.lists).contains(at); });
    };
    while (earlier > 0 && (--earlier, of_feature_[earlier] == of_feature_[later] || !contains(earlier))) {
    }
    warn(fmt::format("polygons of different materials overlap on {} {} of the terrain", total.parts, parts_.name()),
         fmt::format("{:.6g} m2, {:.2g} % of it; at ({:.10g}, {:.10g}) features {} and {}", total.area,
                     100 * total.area / total.of, at.x(), at.y(), layer_.features[earlier].id,
                     layer_.features[later].id),
         "The later one in the file applies");
  }

  void report_gaps() {
    const Sum total = sum([&](std::size_t part) { return of_part_[part] == nothing; });
    const auto default_material =
        static_cast<std::uint8_t>(*project_.number_of_material(project_.ground.default_material));
    std::replace(of_part_.begin(), of_part_.end(), nothing, default_material);
    if (total.parts == 0) return;
    warn(fmt::format("{} {} of the terrain are in no polygon", total.parts, parts_.name()),
         fmt::format("{:.6g} m2, {:.2g} % of it", total.area, 100 * total.area / total.of),
         fmt::format("They are given the default material, \"{}\"", project_.ground.default_material));
  }

  const Project& project_;
  const BuiltTerrain& terrain_;
  Problems& warnings_;
  GroundParts parts_;
  VectorLayer layer_;
  std::vector<std::uint8_t> of_feature_, of_part_;
  std::vector<bool> used_;                             // materials of at least one polygon
  std::vector<bool> overlaps_;                         // by part; empty if there is none
  std::pair<std::size_t, std::size_t> first_overlap_;  // the part, and the later feature there
};

}  // namespace

std::vector<std::uint8_t> materials_of_polygons(const Project& project, const BuiltTerrain& terrain,
                                                Problems& warnings) {
  return Assignment(project, terrain, warnings).materials();
}

}  // namespace talus::project
