#include "talus/layers/check_layers.hpp"

#include <fmt/format.h>

#include "talus/layers/layer_picture.hpp"
#include "talus/layers/layer_shapes.hpp"
#include "talus/layers/terrain_on_plan.hpp"
#include "talus/project/named_files.hpp"

#ifdef TALUS_HAS_GDAL
#include "talus/gdal/gdal_open.hpp"
#endif

namespace talus {

LayerKind kind_of_layer(const std::filesystem::path& file) {
#ifdef TALUS_HAS_GDAL
  GdalMessages messages;
  RasterProblems problems(file);
  if (!format_of_file(GdalKind::picture, messages, problems).empty()) return LayerKind::raster;
  if (format_of_file(GdalKind::vector, messages, problems).empty()) {
    problems.stop(
        "cannot be drawn", "it is neither a raster nor a vector file that Talus reads",
        fmt::format("Talus reads {}; {}", names_of_formats(GdalKind::picture), names_of_formats(GdalKind::vector)));
  }
#else
  static_cast<void>(file);  // the reader says that there is no GDAL
#endif
  return LayerKind::vector;
}

namespace project {

void with_layer(const Project& project, std::size_t layer, Problems& warnings,
                const std::function<void(const std::filesystem::path& file, Problems& warnings)>& draw) {
  const Layer& each = project.layers.at(layer);
  const std::string where = name_in_problems(project, "layer", each.name, layer);
  const std::filesystem::path file = project.file.parent_path() / each.file;
  Problems ignored;  // thrown, too
  locating_problems(project, where, ignored, warnings, [&](Problems&, Problems& doubts) {
    if (const std::string why = why_unreadable(project, each.file); !why.empty()) {
      throw BadInput(Problem{.file = file.string(),
                             .where = {},
                             .what = "cannot be read",
                             .why = why,
                             .hint = "The path is relative to the project file"});
    }
    draw(file, doubts);
    return true;
  });
}

void check_layers(const Project& project, const Model& model, Problems& warnings) {
  if (project.is_2d()) return;
  const TerrainOnPlan terrain = terrain_on_plan(model);
  Problems problems;
  for (std::size_t k = 0; k < project.layers.size(); ++k) {
    const Layer& layer = project.layers[k];
    try {
      with_layer(project, k, warnings, [&](const std::filesystem::path& file, Problems& doubts) {
        if (kind_of_layer(file) == LayerKind::raster) {
          check_picture(file, terrain, doubts);
        } else {
          static_cast<void>(shapes_of_layer(file, {layer.layer, layer.name_attribute}, terrain, doubts));
        }
      });
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  }
  if (problems.has_errors()) throw BadInput(problems);
}

}  // namespace project

}  // namespace talus
