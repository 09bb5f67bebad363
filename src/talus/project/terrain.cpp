#include "talus/project/terrain.hpp"

namespace talus::project {

TerrainKind Terrain::kind() const {
  if (!section.vertices.empty() || !section.file.empty()) return std::cref(section);
  if (!mesh.files.empty()) return std::cref(mesh);
  if (!raster.file.empty()) return std::cref(raster);
  if (!survey.points.empty() || !survey.lines.empty()) return std::cref(survey);
  if (!polygons.polylines.empty() || !polygons.file.empty()) return std::cref(polygons);
  return std::cref(inline_mesh);
}

}  // namespace talus::project
