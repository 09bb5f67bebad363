#include "talus/model/build_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "talus/import/class_raster.hpp"
#include "talus/import/filler_values.hpp"
#include "talus/model/ground_areas.hpp"
#include "talus/model/ground_forests.hpp"
#include "talus/model/ground_materials.hpp"
#include "talus/model/ground_parts.hpp"
#include "talus/model/ground_polygons.hpp"

namespace talus::project {

namespace {

constexpr std::size_t points_at_once = 1 << 20;

Problem about_ground(const Project& project, std::string what, std::string why, std::string hint = "") {
  return {.file = project.file.string(),
          .where = "[ground]",
          .what = std::move(what),
          .why = std::move(why),
          .hint = std::move(hint)};
}

/// Calls take(number, centre) for every cell with data, or every triangle. `number` is its source number in the
/// surface; `centre` is in the user's coordinates.
template <class Take>
void for_each_part(const BuiltTerrain& terrain, Take&& take) {
  if (const auto* raster = std::get_if<RasterSurface>(&*terrain.surface)) {
    const RasterGrid& grid = raster->grid();
    const double x = grid.x0 + terrain.frame.origin.x(), y = grid.y0 + terrain.frame.origin.y();
    std::size_t number = 0;
    for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
      for (std::uint32_t column = 0; column + 1 < grid.columns; ++column, ++number) {
        if (raster->has_data(column, row)) take(number, Vec2(x + (column + 0.5) * grid.dx, y + (row + 0.5) * grid.dy));
      }
    }
  } else {
    for (std::size_t k = 0; k < terrain.facet_centres.size(); ++k) take(k, terrain.facet_centres[k]);
  }
}

/// Assigns to each part of the terrain the material of its class.
class Classifier {
 public:
  Classifier(const Project& project, const BuiltTerrain& terrain, Problems& warnings)
      : project_(project),
        raster_(project.file.parent_path() / project.ground.raster, terrain.crs_wkt, warnings),
        default_(static_cast<std::uint8_t>(*project.number_of_material(project.ground.default_material))),
        of_part_(terrain.facet_centres.empty() ? terrain.parts : terrain.facet_centres.size(), default_) {
    for (const auto& [number, material] : project.ground.classes) {
      material_of_class_[number] = static_cast<std::uint8_t>(*project.number_of_material(material));
      unused_.insert(number);
    }
    for_each_part(terrain, [&](std::size_t number, const Vec2& centre) {
      numbers_.push_back(number);
      centres_.push_back(centre);
      if (centres_.size() == points_at_once) classify();
    });
    classify();
  }

  std::vector<std::uint8_t> materials(const BuiltTerrain& terrain, Problems& problems, Problems& warnings) {
    const std::string file = project_.ground.raster.string();
    const char* parts = std::holds_alternative<RasterSurface>(*terrain.surface) ? "cells" : "triangles";
    if (raster_.points_within() == 0) {
      const Box box = std::visit([](const auto& surface) { return surface.bounds(); }, *terrain.surface);
      const Vec3 low = terrain.frame.global_from_local(box.low), high = terrain.frame.global_from_local(box.high);
      problems.add(about_ground(project_, fmt::format("raster \"{}\" does not reach the terrain", file),
                                fmt::format("the terrain lies within x = {:.10g} to {:.10g}, y = {:.10g} to {:.10g}",
                                            low.x(), high.x(), low.y(), high.y()),
                                "Check its extent and coordinate system with gdalinfo"));
    } else if (without_ == parts_) {
      problems.add(about_ground(project_, fmt::format("raster \"{}\" has no class anywhere on the terrain", file),
                                fmt::format("none of {} {} has data in it", parts_, parts),
                                "Check it with gdalinfo -stats: its no-data value is not a class"));
    } else if (!unknown_.empty()) {
      constexpr std::size_t most_listed = 10;
      std::string list;
      std::size_t listed = 0;
      for (const auto& [number, count] : unknown_) {
        list += fmt::format("{}{} in {}", list.empty() ? "" : ", ", number, count);
        if (++listed == most_listed) break;
      }
      if (unknown_.size() > listed) list += fmt::format(" and {} other classes", unknown_.size() - listed);
      problems.add(about_ground(project_, fmt::format("raster \"{}\" has classes that are not in classes", file),
                                fmt::format("{} of the terrain's {}", list, parts), hint_for(unknown_.begin()->first)));
    } else if (without_ > 0) {
      Problem warning =
          about_ground(project_, fmt::format("{} of {} {} of the terrain have no class", without_, parts_, parts),
                       fmt::format("raster \"{}\" has no data there, or does not reach that far", file),
                       fmt::format("They are given the default material, \"{}\"", project_.ground.default_material));
      warning.severity = Severity::warning;
      warnings.add(std::move(warning));
    }
    if (!problems.has_errors()) warn_of_unused_classes(parts, warnings);
    return std::move(of_part_);
  }

 private:
  static std::string hint_for(std::int32_t unknown) {
    constexpr std::int32_t many_classes = 255;
    if (may_be_filler(unknown) && (unknown < 0 || unknown >= many_classes))
      return fmt::format("If {0} means no data, declare it: gdal_translate -a_nodata {0}", unknown);
    return fmt::format("Add {} = \"...\" to classes", unknown);
  }

  /// Warns of classes of the project that no part has; perhaps their numbers are mistyped.
  void warn_of_unused_classes(const char* parts, Problems& warnings) const {
    if (unused_.empty()) return;
    constexpr std::size_t most_listed = 10;
    std::string list;
    std::size_t listed = 0;
    for (const std::int32_t number : unused_) {
      if (listed == most_listed) break;
      list += fmt::format("{}{}", listed++ == 0 ? "" : ", ", number);
    }
    if (unused_.size() > listed) list += fmt::format(" and {} more", unused_.size() - listed);
    Problem warning = about_ground(
        project_, fmt::format("classes has {}, which no part of the terrain has", list),
        fmt::format("in raster \"{}\" at the centres of the terrain's {}", project_.ground.raster.string(), parts));
    warning.severity = Severity::warning;
    warnings.add(std::move(warning));
  }

  void classify() {
    const auto classes = raster_.at(centres_);
    for (std::size_t i = 0; i < classes.size(); ++i) {
      if (!classes[i]) {
        ++without_;
      } else if (const auto known = material_of_class_.find(*classes[i]); known != material_of_class_.end()) {
        of_part_[numbers_[i]] = known->second;
        unused_.erase(known->first);
      } else {
        ++unknown_[*classes[i]];
      }
    }
    parts_ += classes.size();
    numbers_.clear();
    centres_.clear();
  }

  const Project& project_;
  ClassRaster raster_;
  std::uint8_t default_;
  std::vector<std::uint8_t> of_part_;
  std::map<std::int32_t, std::uint8_t> material_of_class_;
  std::map<std::int32_t, std::uint64_t> unknown_;  // classes without a material, with their numbers of parts
  std::set<std::int32_t> unused_;                  // classes of the project that no part has
  std::uint64_t parts_ = 0, without_ = 0;
  std::vector<std::size_t> numbers_;
  std::vector<Vec2> centres_;
};

/// The material number of each cell or triangle, from a raster of classes or from polygons.
std::vector<std::uint8_t> from_gis(const Project& project, const BuiltTerrain& terrain, Problems& problems,
                                   Problems& warnings) {
  if (project.ground.raster.empty()) return materials_of_polygons(project, terrain, warnings);
  Classifier classifier(project, terrain, warnings);
  return classifier.materials(terrain, problems, warnings);
}

/// The materials listed by segments or triangles, in the order of the surface's source numbers.
std::vector<MaterialId> listed(const Project& project, const BuiltTerrain& terrain, Problems& problems) {
  const Ground& ground = project.ground;
  std::vector<MaterialId> of_part;
  of_part.reserve(terrain.parts);
  for (const std::string& name : ground.segments) of_part.push_back(MaterialId{*project.number_of_material(name)});
  if (project.terrain.section.runs_leftwards()) std::reverse(of_part.begin(), of_part.end());
  for (const std::int64_t number : ground.triangles) of_part.push_back(MaterialId{static_cast<std::uint32_t>(number)});
  if (of_part.size() != terrain.parts) {
    Problem problem = about_ground(project, fmt::format("triangles lists {} materials", of_part.size()),
                                   fmt::format("the terrain has {} triangles, and each needs one", terrain.parts));
    problem.where = "ground";
    problems.add(std::move(problem));
    return {};
  }
  if (terrain.part_of_facet->empty()) return of_part;
  std::vector<MaterialId> of_facet;
  of_facet.reserve(terrain.part_of_facet->size());
  for (const std::uint32_t part : *terrain.part_of_facet) of_facet.push_back(of_part[part]);
  return of_facet;
}

}  // namespace

talus::Ground build_ground(const Project& project, const BuiltTerrain& terrain, Problems& problems,
                           Problems& warnings) {
  const Ground& ground = project.ground;
  const bool is_gis = !ground.raster.empty() || !ground.polygons.empty();
  const bool is_listed = !ground.segments.empty() || !ground.triangles.empty();
  const MaterialId standard{*project.number_of_material(ground.default_material)};
  if (!is_gis && project.areas.empty() && project.forests.empty()) {
    std::vector<talus::Material> materials = materials_of(project, {});
    if (!is_listed) return talus::Ground(std::move(materials), standard);
    return talus::Ground(std::move(materials), listed(project, terrain, problems));
  }

  if (project.materials.size() > max_materials_of_parts) {
    const std::string_view what = !ground.raster.empty()   ? "raster"
                                  : is_gis                 ? "polygons"
                                  : !project.areas.empty() ? "an area"
                                                           : "a forest";
    const std::string_view which = is_gis ? "from a file" : !project.areas.empty() ? "with areas" : "with forests";
    problems.add(about_ground(project, fmt::format("{} is given with {} materials", what, project.materials.size()),
                              fmt::format("a ground {} has at most {}", which, max_materials_of_parts)));
    return {};
  }
  try {
    std::vector<std::uint8_t> of_part;
    const GroundParts parts(terrain);
    if (is_gis) {
      of_part = from_gis(project, terrain, problems, warnings);
    } else if (is_listed) {
      for (const MaterialId id : listed(project, terrain, problems)) {
        of_part.push_back(static_cast<std::uint8_t>(id.index));
      }
    } else {
      of_part.assign(parts.count(), static_cast<std::uint8_t>(standard.index));
    }
    if (problems.has_errors()) return {};
    paint_areas(project, parts, of_part, warnings);
    std::vector<LaidForest> laid;
    if (!project.forests.empty()) laid = lay_forests(project, parts, of_part, warnings);
    return talus::Ground(materials_of(project, laid), std::move(of_part));
  } catch (const BadInput& bad) {
    problems.append(bad.problems());
    return {};
  }
}

}  // namespace talus::project
