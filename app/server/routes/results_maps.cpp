#include <algorithm>
#include <cmath>

#include "http/arrays.hpp"
#include "results/run_summary.hpp"
#include "routes/results.hpp"
#include "talus/maps/map_reading.hpp"

namespace talus::server {

namespace {

/// The limits of each class (null at the end of the last one) and its colour.
Json classes_of(const MapFile& map) {
  Json classes = Json::array();
  for (const MapClass& each : map_classes(map.limits)) {
    classes.push_back(
        {{"from", each.from}, {"to", std::isfinite(each.to) ? Json(each.to) : Json()}, {"colour", each.colour}});
  }
  return classes;
}

/// As the page knows it: it shows shares in percent.
std::string unit_of(const MapFile& map) { return map.is_share ? "share" : map.unit; }

}  // namespace

void add_map_routes(Router& router, RunStore& runs) {
  router.get(one_run + "/maps", [&runs](const Call& call) {
    Json list = Json::array();
    for (const MapFile& map : maps_of_run(results_folder(runs.find(call.part(1)))))
      list.push_back({{"name", map.name},
                      {"meaning", map.meaning},
                      {"unit", unit_of(map)},
                      {"least", map.range.least},
                      {"most", map.range.greatest},
                      {"classes", classes_of(map)},
                      {"source", map.source.empty() ? Json() : Json(map.source)}});
    return json_answer({{"maps", std::move(list)}});
  });
  router.get(one_run + "/maps/(.+)", [&runs](const Call& call) {
    constexpr int most_pixels = 8192;
    const auto folder = results_folder(runs.find(call.part(1)));
    const auto pixels = static_cast<int>(call.query_number("pixels", 1024, most_pixels));
    // Only listed names are served, so that none leads out of the folder.
    const auto maps = maps_of_run(folder);
    const auto map = std::ranges::find(maps, call.part(2), &MapFile::name);
    if (map == maps.end()) throw Refusal(404, call.part(2), "this run has no such map");
    const MapValues values = read_map(folder, *map, std::max(pixels, least_pixels));
    Arrays arrays({{"origin", values.origin},
                   {"cell", values.cell},
                   {"columns", values.columns},
                   {"rows", values.rows},
                   {"unit", unit_of(*map)},
                   {"least", map->range.least},
                   {"most", map->range.greatest},
                   {"classes", classes_of(*map)}});
    arrays.add("values", std::span<const float>(values.values));
    return arrays.answer();
  });
}

}  // namespace talus::server
