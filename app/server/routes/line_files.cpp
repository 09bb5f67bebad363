#include <string>
#include <vector>

#include "model_shelf.hpp"
#include "routes/answer_read.hpp"
#include "routes/routes.hpp"
#include "talus/import/vector_file.hpp"

namespace talus::server {

namespace {

Json shape(const char* kind, const std::vector<Vec3>& places) {
  Json points = Json::array();
  for (const Vec3& p : places) points.push_back({p.x(), p.y()});
  return {{"kind", kind}, {"points", std::move(points)}};
}

/// The lines and the outer rings of the polygons of a vector file.
Json shapes_of(const VectorLayer& layer) {
  Json shapes = Json::array();
  for (const VectorFeature& feature : layer.features)
    for (const VectorShape& part : feature.parts)
      shapes.push_back(shape(part.kind == ShapeKind::polygon ? "polygon" : "line", part.lists.front()));
  return shapes;
}

}  // namespace

void add_line_file_routes(Router& router, const Workplace& workplace, const ModelShelf& shelf, ModelReading& reading) {
  router.get("/api/models/([0-9a-f]+)/lines", [&](const Call& call) {
    const ModelShelf::Held held = shelf.find(call.part(1));
    const std::filesystem::path file = workplace.existing(call.query("file"));
    return answer_read(reading, workplace, [held, file, folder = workplace.folder()] {
      VectorRequest request;
      request.kinds = {ShapeKind::line, ShapeKind::polygon};
      request.terrain_crs_wkt = held->model.crs_wkt;
      Problems doubts;
      Json shapes = shapes_of(read_vector_file(file, request, doubts));
      return Json{{"shapes", std::move(shapes)}, {"problems", as_json(seen_from(folder, doubts))}};
    });
  });
}

}  // namespace talus::server
