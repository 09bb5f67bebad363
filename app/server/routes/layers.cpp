#include <cstdint>
#include <string>
#include <vector>

#include "drawn_layers.hpp"
#include "http/arrays.hpp"
#include "routes/numbers.hpp"
#include "routes/routes.hpp"
#include "run_model.hpp"
#include "talus/layers/contour_line.hpp"

namespace talus::server {

namespace {

constexpr std::size_t most_draped = 300'000;  // points of the lines of one layer
constexpr std::size_t most_of_contour = 500;  // points

Json plan_json(const Vec2& p) { return {p.x(), p.y()}; }

Json plan_json(const std::vector<Vec2>& line) {
  Json list = Json::array();
  for (const Vec2& p : line) list.push_back(plan_json(p));
  return list;
}

const char* word(ShapeKind kind) {
  return kind == ShapeKind::point ? "point" : kind == ShapeKind::line ? "line" : "polygon";
}

Json description(const DrawnLayer& layer, const Workplace& workplace) {
  const bool is_raster = layer.kind == LayerKind::raster;
  Json json{{"kind", is_raster ? "raster" : "vector"},
            {"key", layer.key},
            {"problems", as_json(seen_from(workplace.folder(), layer.warnings))}};
  if (!is_raster) {
    json["shapes"] = layer.shapes.shapes.size();
    return json;
  }
  const LayerPicture& picture = layer.picture;
  json["area"] = {plan_json(picture.area.low), plan_json(picture.area.high)};
  json["columns"] = picture.columns;
  json["rows"] = picture.rows;
  json["ramp"] =
      picture.ramp.empty() ? Json() : Json{{"least", picture.least}, {"most", picture.most}, {"colours", picture.ramp}};
  return json;
}

/// The shapes on the terrain, as arrays.
Answer draped(const Model& model, const LayerShapes& shapes) {
  double length = 0;
  for (const LayerShape& shape : shapes.shapes)
    for (std::size_t k = 0; k + 1 < shape.points.size(); ++k) length += (shape.points[k + 1] - shape.points[k]).norm();
  const double spacing = spacing_on_terrain(model, length, most_draped);
  const Vec3& origin = model.frame.origin;
  std::vector<float> positions;
  std::vector<std::uint32_t> starts, names;
  std::vector<std::uint8_t> kinds;
  for (const LayerShape& shape : shapes.shapes) {
    for (const std::vector<Vec3>& part : on_terrain(model, shape.points, spacing)) {
      starts.push_back(static_cast<std::uint32_t>(positions.size() / 3));
      names.push_back(shape.name);
      kinds.push_back(static_cast<std::uint8_t>(shape.kind));
      for (const Vec3& p : part)
        for (const double value : coordinates(p - origin)) positions.push_back(static_cast<float>(value));
    }
  }
  Arrays arrays({{"origin", {origin.x(), origin.y(), origin.z()}},
                 {"names", shapes.names},
                 {"kinds", {word(ShapeKind::point), word(ShapeKind::line), word(ShapeKind::polygon)}}});
  arrays.add("positions", positions);
  arrays.add("starts", starts);
  arrays.add("names", names);
  arrays.add("kinds", kinds);
  return arrays.answer();
}

Vec2 place_of(const Call& call) {
  const auto found = call.body.find("place");
  const auto [x, y] = number_lists<2>(Json::array({found == call.body.end() ? Json() : *found}), "place", 1, 1).front();
  return {x, y};
}

}  // namespace

void add_layer_routes(Router& router, const Workplace& workplace, const ModelShelf& shelf, DrawnLayers& layers,
                      ModelReading& reading) {
  const auto layer_of = [&](const ModelShelf::Held& model, const Call& call) {
    try {
      return layers.of(model, std::stoul(call.part(2)));
    } catch (const BadInput& bad) {
      throw BadInput(seen_from(workplace.folder(), bad.problems()));
    }
  };
  // The number of digits is limited so that no number overflows.
  router.get("/api/models/([0-9a-f]+)/layers/([0-9]{1,6})", [&workplace, &shelf, layer_of](const Call& call) {
    return json_answer(description(*layer_of(shelf.find(call.part(1)), call), workplace));
  });
  router.get("/api/models/([0-9a-f]+)/layers/([0-9]{1,6})/picture", [&shelf, layer_of](const Call& call) {
    const DrawnLayers::Held layer = layer_of(shelf.find(call.part(1)), call);
    if (layer->kind != LayerKind::raster)
      throw Refusal(404, "picture", "this layer has lines", "", "Request its lines");
    return Answer{.type = layer->picture.type, .body = layer->picture.bytes};
  });
  router.get("/api/models/([0-9a-f]+)/layers/([0-9]{1,6})/lines", [&shelf, layer_of](const Call& call) {
    const ModelShelf::Held model = shelf.find(call.part(1));
    const DrawnLayers::Held layer = layer_of(model, call);
    if (layer->kind != LayerKind::vector) throw Refusal(404, "lines", "this layer is a picture", "", "Request it");
    return draped(model->model, layer->shapes);
  });
  router.post("/api/models/([0-9a-f]+)/layers/([0-9]{1,6})/nearest", [&shelf, layer_of](const Call& call) {
    call.only({"place", "reach_m"});
    const DrawnLayers::Held layer = layer_of(shelf.find(call.part(1)), call);
    const Vec2 place = place_of(call);
    const LayerShape* const found = layer->shapes.nearest(place, call.number("reach_m"));
    if (found == nullptr) return json_answer({{"shape", nullptr}});
    return json_answer({{"shape",
                         {{"kind", word(found->kind)},
                          {"name", layer->shapes.names[found->name]},
                          {"distance_m", found->distance_to(place)},
                          {"points", plan_json(found->points)}}}});
  });
  router.post("/api/models/([0-9a-f]+)/contour", [&shelf, &reading](const Call& call) {
    call.only({"place", "elevation_m"});
    const ModelShelf::Held model = shelf.find(call.part(1));
    const Vec2 place = place_of(call);
    std::optional<double> elevation;
    if (call.body.contains("elevation_m")) elevation = call.number("elevation_m");
    const auto found = reading.read<std::optional<ContourLine>>(
        "", [model, place, elevation] { return contour_through(model->model, place, elevation, most_of_contour); });
    if (!*found)
      throw Refusal(422, "contour", "there is no contour",
                    "the place is off the terrain, or the elevation is beyond it");
    return json_answer({{"elevation_m", (*found)->elevation}, {"points", plan_json((*found)->points)}});
  });
}

}  // namespace talus::server
