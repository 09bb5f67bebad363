#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "model_description.hpp"
#include "routes/numbers.hpp"
#include "routes/routes.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/meshing/polygon_mesh.hpp"
#include "talus/model/drawn.hpp"
#include "talus/project/settings.hpp"
#include "talus/project/words.hpp"

namespace talus::server {

namespace {

constexpr std::size_t most_polylines = 20'000, most_vertices = 200'000;
constexpr std::size_t intervals = 200;  // of a density curve

/// "polylines[2]" to "polylines.2"
std::string path_of(const SpacePolygon& polygon) {
  std::string path = polygon.name.substr(0, polygon.name.size() - 1);
  path[path.find('[')] = '.';
  return path;
}

/// Polylines as in project files: closed, with the last vertex equal to the first.
std::vector<SpacePolygon> polygons_of(const Call& call, Problems& problems) {
  const auto found = call.body.find("polylines");
  if (found == call.body.end() || !found->is_array() || found->empty() || found->size() > most_polylines)
    throw Refusal(400, "polylines", "is not valid", fmt::format("expected a list of 1 to {}", most_polylines));
  std::vector<SpacePolygon> polygons;
  std::size_t vertices = 0;
  for (std::size_t k = 0; k < found->size(); ++k) {
    SpacePolygon polygon{fmt::format("polylines[{}]", k), {}};
    std::vector<Vec3>& ring = polygon.rings.emplace_back();
    for (const auto& [x, y, z] : number_lists<3>((*found)[k], polygon.name, 1, most_vertices))
      ring.emplace_back(x, y, z);
    vertices += ring.size();
    if (vertices > most_vertices)
      throw Refusal(400, "polylines", "have too many vertices", fmt::format("at most {} are accepted", most_vertices));
    if (ring.size() < 2 || ring.front() != ring.back()) {
      problems.add(Problem{.what = polygon.name + " is not closed",
                           .why = "its last vertex is not its first",
                           .path = path_of(polygon)});
      continue;
    }
    ring.pop_back();
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

Json polygons_json(const Call& call) {
  const auto& range = project::setting("terrain", "merge_tolerance_m").range;
  const double tolerance = call.number("tolerance_m", project::Terrain().merge_tolerance_m);
  if (!range.contains(tolerance))
    throw Refusal(400, "tolerance_m", fmt::format("is {}", tolerance), fmt::format("expected {}", range.text()));
  Problems problems;
  const std::vector<SpacePolygon> polygons = polygons_of(call, problems);
  Json vertices = Json::array(), triangles = Json::array();
  std::string report;
  try {
    if (problems.has_errors()) throw BadInput(problems);
    PolygonReport cut;
    const CleanMesh mesh = clean(triangulated(polygons, "", cut), {.source = "", .weld_tolerance_m = tolerance});
    for (const Vec3& p : mesh.vertices) vertices.push_back(as_json(p));
    for (const auto& corners : mesh.triangles) triangles.push_back(corners);
    report = cut.text() + '\n' + mesh.report.text();
  } catch (const BadInput& bad) {
    problems = {};
    for (Problem problem : bad.problems().list()) {
      // A problem of a single polyline begins with its name.
      for (std::size_t k = 0; k < polygons.size() && problem.path.empty(); ++k)
        if (problem.what.starts_with(polygons[k].name + ' ')) problem.path = path_of(polygons[k]);
      problems.add(std::move(problem));
    }
  }
  return {{"problems", as_json(problems)},
          {"vertices", std::move(vertices)},
          {"triangles", std::move(triangles)},
          {"report", report}};
}

Distribution distribution_of(const Call& call) {
  Distribution given;
  given.mean = call.number("mean");
  const std::string word = call.text("distribution", "none");
  const auto kind = project::value_of<DistributionKind>(word);
  if (!kind)
    throw Refusal(400, "distribution", fmt::format("\"{}\" is not a distribution", word),
                  fmt::format("expected one of {}", fmt::join(project::words<DistributionKind>(), ", ")));
  given.kind = *kind;
  for (const auto& [key, member] : {std::pair("std_dev", &given.std_dev), std::pair("rel_min", &given.rel_min),
                                    std::pair("rel_max", &given.rel_max)}) {
    const auto value = call.body.find(key);
    if (value != call.body.end() && !value->is_null()) *member = call.number(key);
  }
  return given;
}

Json distribution_json(const Call& call) {
  project::Drawn drawn{distribution_of(call), {}};
  if (const std::string key = call.text("key", ""); !key.empty()) {
    const auto of_key = project::drawn(key, drawn.distribution);
    if (!of_key) throw Refusal(400, "key", fmt::format("\"{}\" is not a random property", key));
    drawn = *of_key;
  }
  Problems problems;
  Json list = Json::array();
  if (const auto why = why_unusable(drawn.distribution, drawn.bounds)) {
    problems.add(Problem{.what = *why});
  } else {
    for (const Density& each : density_of(drawn.distribution, drawn.bounds, intervals))
      list.push_back({each.value, each.density});
  }
  return {{"problems", as_json(problems)}, {"density", std::move(list)}};
}

}  // namespace

void add_shape_routes(Router& router) {
  router.post("/api/geometry/polygons", [](const Call& call) {
    call.only({"polylines", "tolerance_m"});
    return json_answer(polygons_json(call));
  });
  router.post("/api/distribution", [](const Call& call) {
    call.only({"key", "mean", "distribution", "std_dev", "rel_min", "rel_max"});
    return json_answer(distribution_json(call));
  });
}

}  // namespace talus::server
