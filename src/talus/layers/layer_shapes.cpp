#include "talus/layers/layer_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <unordered_map>

#include "talus/core/stop.hpp"
#include "talus/meshing/simplified_line.hpp"

namespace talus {

namespace {

constexpr double finest = 1e-5, coarsest = 2e-3;  // tolerances, as shares of the terrain's size

std::vector<Vec2> simplified(const std::vector<Vec2>& line, double tolerance) {
  std::vector<Vec2> points;
  for (const std::size_t k : vertices_to_keep(line, tolerance)) points.push_back(line[k]);
  return points;
}

PlanArea around(const std::vector<Vec2>& points) {
  PlanArea area{points.front(), points.front()};
  for (const Vec2& p : points) area = {area.low.min(p), area.high.max(p)};
  return area;
}

bool is_named_name(const std::string& attribute) {
  constexpr std::string_view name = "name";
  return std::ranges::equal(attribute, name,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// The shapes of a layer, with their names.
class Collector {
 public:
  explicit Collector(const TerrainOnPlan& terrain) : terrain_(terrain) { found_.names.emplace_back(); }

  void add(const VectorFeature& feature) {
    const std::string name = feature.values.empty() ? "" : feature.values.front().value_or("");
    for (const VectorShape& part : feature.parts) {
      for (const std::vector<Vec3>& list : part.lists) {
        LayerShape shape{.kind = part.kind, .name = 0, .points = {}};
        shape.points.reserve(list.size() + 1);
        for (const Vec3& p : list) shape.points.emplace_back(p.xy());
        if (part.kind == ShapeKind::polygon) shape.points.emplace_back(list.front().xy());
        if (shape.points.empty()) continue;
        const PlanArea area = around(shape.points);
        if (!area.touches(terrain_.area)) continue;
        shape.name = number_of(name);
        found_.shapes.push_back(std::move(shape));
      }
    }
  }

  [[nodiscard]] LayerShapes& found() { return found_; }

 private:
  std::uint32_t number_of(const std::string& name) {
    if (name.empty()) return 0;
    const auto [at, is_new] = numbers_.emplace(name, static_cast<std::uint32_t>(found_.names.size()));
    if (is_new) found_.names.push_back(name);
    return at->second;
  }

  const TerrainOnPlan& terrain_;
  LayerShapes found_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

void limit(LayerShapes& drawn, const LayerRequest& request, double size, const std::filesystem::path& file,
           Problems& warnings) {
  const std::size_t given = drawn.points();
  if (given <= request.most_points) return;
  const auto warn = [&](std::string what, std::string why, std::string hint) {
    warnings.add({.severity = Severity::warning,
                  .file = file.string(),
                  .where = {},
                  .what = std::move(what),
                  .why = std::move(why),
                  .hint = std::move(hint)});
  };
  double tolerance = finest * size;
  for (;; tolerance *= 2) {
    stop_point();
    for (LayerShape& shape : drawn.shapes)
      if (shape.points.size() > 2) shape.points = simplified(shape.points, tolerance);
    if (drawn.points() <= request.most_points || 2 * tolerance > coarsest * size) break;
  }
  warn(fmt::format("has {} points over the terrain", given),
       fmt::format("at most {} are drawn: lines are simplified by up to {:.2g} m", request.most_points, tolerance), "");
  std::size_t points = 0, kept = 0;
  while (kept < drawn.shapes.size() && points + drawn.shapes[kept].points.size() <= request.most_points)
    points += drawn.shapes[kept++].points.size();
  if (kept == drawn.shapes.size()) return;
  warn(fmt::format("has {} lines over the terrain", drawn.shapes.size()), fmt::format("the first {} are drawn", kept),
       "Cut it to the slope, for example with ogr2ogr -spat");
  drawn.shapes.resize(kept);
}

}  // namespace

double LayerShape::distance_to(const Vec2& place) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Vec2 way = points[k + 1] - points[k];
    const double length = way.squared_norm();
    const double share = length > 0 ? std::clamp((place - points[k]).dot(way) / length, 0.0, 1.0) : 0;
    least = std::min(least, (points[k] + share * way - place).norm());
  }
  return least;
}

std::size_t LayerShapes::points() const {
  std::size_t sum = 0;
  for (const LayerShape& shape : shapes) sum += shape.points.size();
  return sum;
}

const LayerShape* LayerShapes::nearest(const Vec2& place, double reach) const {
  const LayerShape* best = nullptr;
  for (const LayerShape& shape : shapes) {
    const double distance = shape.distance_to(place);
    if (distance > reach) continue;
    reach = distance;
    best = &shape;
  }
  return best;
}

LayerShapes shapes_of_layer(const std::filesystem::path& file, const LayerRequest& request,
                            const TerrainOnPlan& terrain, Problems& warnings) {
  VectorRequest wanted;
  wanted.layer = request.layer;
  wanted.terrain_crs_wkt = terrain.crs_wkt;
  wanted.within = std::array{terrain.area.low, terrain.area.high};
  wanted.choose = [&](const std::vector<std::string>& names) -> std::vector<std::string> {
    if (!request.name_attribute.empty()) return {request.name_attribute};
    const auto named = std::ranges::find_if(names, is_named_name);
    return named == names.end() ? std::vector<std::string>{} : std::vector<std::string>{*named};
  };
  const VectorLayer layer = read_vector_file(file, wanted, warnings);
  Collector collector(terrain);
  for (const VectorFeature& feature : layer.features) collector.add(feature);
  LayerShapes& found = collector.found();
  if (found.shapes.empty()) {  // close to the terrain, but beside it
    throw BadInput(Problem{.file = file.string(),
                           .where = {},
                           .what = "does not lie over the terrain",
                           .why = "the terrain covers " + in_words(terrain.area),
                           .hint = {}});
  }
  limit(found, request, terrain.area.size().norm(), file, warnings);
  return std::move(found);
}

std::vector<Vec2> simplified_to(std::vector<Vec2> line, std::size_t most) {
  if (line.size() <= most) return line;
  const Vec2 size = around(line).size();
  std::vector<Vec2> made = line;
  for (double tolerance = finest * size.norm(); made.size() > most && tolerance > 0; tolerance *= 1.5)
    made = simplified(line, tolerance);
  return made;
}

}  // namespace talus
