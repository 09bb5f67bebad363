#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "model_shelf.hpp"
#include "routes/numbers.hpp"
#include "routes/routes.hpp"
#include "talus/terrain/section_along.hpp"

namespace talus::server {

namespace {

constexpr std::size_t most_points = 100'000;  // of one request for elevations
constexpr std::size_t most_bends = 1'000;     // of a line
constexpr std::size_t most_of_section = 5'000;

/// Points on plan, in local coordinates.
std::vector<Vec2> plan_points(const Call& call, const char* key, const LocalFrame& frame, std::size_t least,
                              std::size_t most) {
  std::vector<Vec2> points;
  for (const auto& [x, y] : number_lists<2>(call, key, least, most))
    points.emplace_back(x - frame.origin.x(), y - frame.origin.y());
  return points;
}

Json elevations_json(const Model& model, const std::vector<Vec2>& points) {
  Json list = Json::array();
  for (const Vec2& p : points) {
    const auto z = std::visit([&](const auto& surface) { return surface.elevation(p.x(), p.y()); }, *model.surface);
    list.push_back(z ? Json(*z + model.frame.origin.z()) : Json());
  }
  return {{"z", std::move(list)}};
}

/// The material of the ground half way between two points of a section; null where there is no ground, at a step, and
/// after the last point.
template <class Surface>
Json material_after(const Model& model, const Surface& surface, const std::vector<SectionPoint>& section,
                    std::size_t k) {
  if (!section[k].z || k + 1 == section.size() || section[k + 1].distance == section[k].distance) return {};
  const Vec2 middle = 0.5 * (section[k].place + section[k + 1].place);
  const auto ground = surface.ground_below({middle.x(), middle.y(), surface.bounds().high.z() + 1});
  return ground ? Json(model.ground.material_of(surface.source(ground->facet)).index) : Json();
}

template <class Surface>
Json section_json(const Model& model, const Surface& surface, const std::vector<Vec2>& line) {
  const std::vector<SectionPoint> section = section_along(surface, line, most_of_section);
  Json distances = Json::array(), heights = Json::array(), xs = Json::array(), ys = Json::array(),
       materials = Json::array();
  for (std::size_t k = 0; k < section.size(); ++k) {
    const SectionPoint& point = section[k];
    distances.push_back(point.distance);
    heights.push_back(point.z ? Json(*point.z + model.frame.origin.z()) : Json());
    xs.push_back(point.place.x() + model.frame.origin.x());
    ys.push_back(point.place.y() + model.frame.origin.y());
    materials.push_back(material_after(model, surface, section, k));
  }
  return {{"distance_m", std::move(distances)},
          {"z_m", std::move(heights)},
          {"x_m", std::move(xs)},
          {"y_m", std::move(ys)},
          {"materials", std::move(materials)}};
}

Json section_json(const Model& model, const std::vector<Vec2>& line) {
  if (const auto* mesh = std::get_if<TriangleMesh>(&*model.surface)) return section_json(model, *mesh, line);
  if (const auto* raster = std::get_if<RasterSurface>(&*model.surface)) return section_json(model, *raster, line);
  throw Refusal(404, "section", "this model is itself a section", "", "Request its profile");
}

}  // namespace

void add_model_query_routes(Router& router, const ModelShelf& shelf) {
  router.post("/api/models/([0-9a-f]+)/elevations", [&](const Call& call) {
    call.only({"points"});
    const ModelShelf::Held held = shelf.find(call.part(1));
    return json_answer(elevations_json(held->model, plan_points(call, "points", held->model.frame, 0, most_points)));
  });
  router.post("/api/models/([0-9a-f]+)/section", [&](const Call& call) {
    call.only({"line"});
    const ModelShelf::Held held = shelf.find(call.part(1));
    return json_answer(section_json(held->model, plan_points(call, "line", held->model.frame, 2, most_bends)));
  });
}

}  // namespace talus::server
