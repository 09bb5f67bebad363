#include "talus/model/build_survey.hpp"

#include <fmt/format.h>

#include "talus/files/first_problems.hpp"
#include "talus/import/survey_files.hpp"
#include "talus/model/mesh_surface.hpp"

namespace talus::project {
namespace {

std::filesystem::path in_project_folder(const Project& project, const std::filesystem::path& file) {
  return file.empty() ? file : project.file.parent_path() / file;
}

/// Lines without heights are put on the surface of the points alone, with a vertex wherever that bends.
void add_soft_lines(SurveyFiles& files, const SurveyOptions& options) {
  const SurveyOptions of_points{
      .source = options.source, .boundary = {}, .max_edge_m = {}, .remove_spikes_m = options.remove_spikes_m};
  const CleanMesh mesh =
      clean(surface_of({.points = files.survey.points, .lines = {}}, of_points).mesh, {.source = options.source});
  const LocalFrame frame = LocalFrame::near(mesh.vertices.front());
  const TriangleMesh ground = mesh_surface(mesh, frame);
  FirstProblems problems(options.source, "lines");
  for (const SoftLine& line : files.soft_lines) {
    std::vector<Vec3> draped;
    for (std::size_t k = 0; k + 1 < line.vertices.size(); ++k) {
      const Vec3 from = frame.local_from_global(line.vertices[k]), to = frame.local_from_global(line.vertices[k + 1]);
      for (const Vec3& end : {from, to}) {
        if (ground.elevation(end.x(), end.y())) continue;
        const Vec3 at = frame.global_from_local(end);
        problems.add(0, fmt::format("{} of the lines has no heights", line.name),
                     fmt::format("it reaches beyond the points at ({:.10g}, {:.10g})", at.x(), at.y()),
                     "Cut it to the area of the points, or give it heights");
        break;
      }
      for (const Vec3& p : ground.draped(from.xy(), to.xy())) {
        const Vec3 at = frame.global_from_local(p);
        if (draped.empty() || draped.back().xy() != at.xy()) draped.push_back(at);
      }
    }
    files.survey.lines.push_back(std::move(draped));
  }
  problems.throw_if_any();
}

}  // namespace

ProjectCrs crs_of_project(const Project& project) {
  const std::string& words = project.terrain.crs;
  if (words.empty()) return {};
  if (words == "local") return {.crs = {}, .is_local = true};
  if (const auto file = file_in_crs_words(words)) {
    throw BadInput(Problem{.file = project.file.string(),
                           .where = "[terrain]",
                           .what = "crs names a file",
                           .why = *file + "; Talus reads no files that others name",
                           .hint = "Use for example \"EPSG:31287\""});
  }
  if (const auto crs = crs_in_words(words)) {
    if (crs->is_local) return {.crs = {}, .is_local = true};
    return {.crs = *crs, .is_local = false};
  }
  throw BadInput(Problem{.file = project.file.string(),
                         .where = "[terrain]",
                         .what = fmt::format("crs is \"{}\"", words),
                         .why = "this coordinate system is not known",
                         .hint = "Use for example \"EPSG:31287\", or \"local\""});
}

GivenMesh survey_mesh(const SurveyTerrain& survey, const Project& project, Problems& warnings) {
  SurveySources sources;
  sources.points = in_project_folder(project, survey.points);
  sources.point_classes = survey.point_classes;
  sources.points_layer = survey.points_layer;
  sources.lines = in_project_folder(project, survey.lines);
  sources.lines_layer = survey.lines_layer;
  sources.elevation_attribute = survey.elevation_attribute;
  sources.boundary = in_project_folder(project, survey.boundary);
  sources.boundary_layer = survey.boundary_layer;
  sources.project_crs = crs_of_project(project);
  SurveyFiles files = read_survey(sources, warnings);

  GivenMesh out;
  out.source = (survey.points.empty() ? survey.lines : survey.points).string();
  SurveyOptions options;
  options.source = out.source;
  options.boundary = std::move(files.boundary);
  options.max_edge_m = survey.max_edge_m;
  options.remove_spikes_m = survey.remove_spikes_m;
  if (!files.soft_lines.empty()) add_soft_lines(files, options);
  SurveySurface surface = surface_of(files.survey, options);
  out.mesh = std::move(surface.mesh);
  out.crs_wkt = std::move(files.crs_wkt);
  out.report = files.report + '\n' + surface.report.text();
  return out;
}

GivenMesh polygon_mesh(const PolygonTerrain& polygons, const Project& project, Problems& warnings) {
  const double tolerance_m = project.terrain.merge_tolerance_m;
  GivenMesh out;
  std::vector<SpacePolygon> rings;
  if (polygons.file.empty()) {
    out = own_mesh(project, warnings);
    for (std::size_t i = 0; i < polygons.polylines.size(); ++i) {
      std::vector<Vec3> ring;
      for (const auto& [x, y, z] : polygons.polylines[i]) ring.emplace_back(x, y, z);
      ring.pop_back();  // equal to the first
      rings.push_back({fmt::format("polylines[{}]", i), {std::move(ring)}});
    }
  } else {
    out.source = polygons.file.string();
    PolygonFile file = read_polygon_file(in_project_folder(project, polygons.file), polygons.layer,
                                         crs_of_project(project), tolerance_m, warnings);
    out.crs_wkt = std::move(file.crs_wkt);
    rings = std::move(file.polygons);
  }
  out.weld_tolerance_m = tolerance_m;
  PolygonReport report;
  out.mesh = triangulated(rings, out.source, report);
  out.report = report.text();
  return out;
}

GivenMesh own_mesh(const Project& project, Problems& warnings) {
  return {.source = project.file.string(), .crs_wkt = crs_wkt_of(project, warnings)};
}

std::string crs_wkt_of(const Project& project, Problems& warnings) {
  const ProjectCrs said = crs_of_project(project);
  if (said.crs.is_known()) check_survey_crs(said.crs, std::nullopt, project.file, SurveyKind::text, warnings);
  return said.crs.wkt;
}

}  // namespace talus::project
