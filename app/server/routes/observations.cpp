#include <memory>
#include <string>

#include "model_shelf.hpp"
#include "results/run_summary.hpp"
#include "routes/answer_read.hpp"
#include "routes/results.hpp"
#include "routes/routes.hpp"
#include "talus/archive/model_json.hpp"
#include "talus/report/observed_comparison.hpp"
#include "talus/report/uncertainty_json.hpp"

namespace talus::server {

namespace {

/// The observed places as [x, y, z, name, mass]; z is the ground there, or null next to the terrain.
Json observed_places(const ObservedStops& observed, const Model& model) {
  Json places = Json::array();
  for (const ObservedStop& stop : observed.stops) {
    const Vec3 local = model.frame.local_from_global({stop.x_m, stop.y_m, 0});
    const auto z =
        std::visit([&](const auto& surface) { return surface.elevation(local.x(), local.y()); }, *model.surface);
    places.push_back({stop.x_m, stop.y_m, z ? Json(*z + model.frame.origin.z()) : Json(), stop.name,
                      stop.mass_kg ? Json(*stop.mass_kg) : Json()});
  }
  return places;
}

}  // namespace

void add_observation_routes(Router& router, const Workplace& workplace, const ModelShelf& shelf, RunStore& runs,
                            ModelReading& reading) {
  router.get("/api/models/([0-9a-f]+)/observed", [&](const Call& call) {
    const ModelShelf::Held held = shelf.find(call.part(1));
    const std::filesystem::path file = workplace.existing(call.query("file"));
    return answer_read(reading, workplace, [held, file, folder = workplace.folder()] {
      RunSummary summary;
      summary.terrain = terrain_summary(held->model);
      Problems doubts;
      const ObservedStops observed = read_observed_stops(file, summary, doubts);
      return Json{{"places", observed_places(observed, held->model)}, {"problems", as_json(seen_from(folder, doubts))}};
    });
  });
  router.get(one_run + "/observed", [&](const Call& call) {
    const std::filesystem::path run = results_folder(runs.find(call.part(1)));
    const std::filesystem::path file = workplace.existing(call.query("file"));
    return answer_read(reading, workplace, [run, file, folder = workplace.folder()] {
      const RunFolder read = read_run_folder(run);
      Problems doubts;
      Json json = observed_json(read_observed_stops(file, read.summary, doubts), read);
      json["problems"] = as_json(seen_from(folder, doubts));
      return json;
    });
  });
  router.get(one_run + "/uncertainty", [&](const Call& call) {
    const std::filesystem::path run = results_folder(runs.find(call.part(1)));
    return answer_read(reading, workplace, [run] { return uncertainty_json(read_run_folder(run).uncertainty); });
  });
}

}  // namespace talus::server
