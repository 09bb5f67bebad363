#include "talus/model/build_survey.hpp"

#include <fmt/format.h>

#include "talus/import/survey_files.hpp"

namespace talus::project {
namespace {

std::filesystem::path in_project_folder(const Project& project, const std::filesystem::path& file) {
  return file.empty() ? file : project.file.parent_path() / file;
}

}  // namespace

ProjectCrs crs_of_project(const Project& project) {
  const std::string& words = project.terrain.crs;
  if (words.empty()) return {};
  if (words == "local") return {.crs = {}, .is_local = true};
  if (const auto crs = crs_in_words(words)) return {.crs = *crs, .is_local = false};
  throw BadInput(Problem{.file = project.file.string(),
                         .where = "[terrain]",
                         .what = fmt::format("crs is \"{}\"", words),
                         .why = "this coordinate system is not known",
                         .hint = "Use for example \"EPSG:31287\", or \"local\""});
}

SurveyedMesh survey_mesh(const Project& project, Problems& warnings) {
  const Terrain& terrain = project.terrain;
  SurveySources sources;
  sources.points = in_project_folder(project, terrain.points);
  sources.point_classes = terrain.point_classes;
  sources.points_layer = terrain.points_layer;
  sources.lines = in_project_folder(project, terrain.lines);
  sources.lines_layer = terrain.lines_layer;
  sources.elevation_attribute = terrain.elevation_attribute;
  sources.boundary = in_project_folder(project, terrain.boundary);
  sources.boundary_layer = terrain.boundary_layer;
  sources.project_crs = crs_of_project(project);
  SurveyFiles files = read_survey(sources, warnings);

  SurveyedMesh out;
  out.source = (terrain.points.empty() ? terrain.lines : terrain.points).string();
  SurveyOptions options;
  options.source = out.source;
  options.boundary = std::move(files.boundary);
  options.max_edge_m = terrain.max_edge_m;
  options.remove_spikes_m = terrain.remove_spikes_m;
  SurveySurface surface = surface_of(files.survey, options);
  out.mesh = std::move(surface.mesh);
  out.crs_wkt = std::move(files.crs_wkt);
  out.report = files.report + '\n' + surface.report.text();
  return out;
}

SurveyedMesh polygon_mesh(const Project& project, Problems& warnings) {
  const Terrain& terrain = project.terrain;
  SurveyedMesh out;
  std::vector<SpacePolygon> polygons;
  if (terrain.polygons.empty()) {
    out.source = project.file.string();
    out.crs_wkt = crs_wkt_of(project, warnings);
    for (std::size_t i = 0; i < terrain.polylines.size(); ++i) {
      std::vector<Vec3> ring;
      for (const auto& [x, y, z] : terrain.polylines[i]) ring.emplace_back(x, y, z);
      ring.pop_back();  // equal to the first
      polygons.push_back({fmt::format("polylines[{}]", i), {std::move(ring)}});
    }
  } else {
    out.source = terrain.polygons.string();
    PolygonFile file = read_polygon_file(in_project_folder(project, terrain.polygons), terrain.polygons_layer,
                                         crs_of_project(project), terrain.merge_tolerance_m, warnings);
    out.crs_wkt = std::move(file.crs_wkt);
    polygons = std::move(file.polygons);
  }
  PolygonReport report;
  out.mesh = triangulated(polygons, out.source, report);
  out.report = report.text();
  return out;
}

std::string crs_wkt_of(const Project& project, Problems& warnings) {
  const ProjectCrs said = crs_of_project(project);
  if (said.crs.is_known()) check_survey_crs(said.crs, std::nullopt, project.file, SurveyKind::text, warnings);
  return said.crs.wkt;
}

}  // namespace talus::project
