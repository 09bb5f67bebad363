#include "talus/archive/model_json.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

Json terrain_json(const Model& model, const Profile& profile) {
  Json section = Json::array();
  const auto point = [&](const Vec3& local) {
    const Vec3 p = model.frame.global_from_local(local);
    section.push_back({p.x(), p.z()});
  };
  for (std::uint32_t k = 0; k < profile.facet_count(); ++k) {
    const Outline outline = profile.outline({k});
    point(outline.edges[0].point);
    if (k + 1 == profile.facet_count()) point(outline.edges[1].point);
  }
  return {{"kind", "section"}, {"section", section}};
}

// The terrain from above as a coarse grid of elevations, for pictures.
template <class Surface>
Json relief_json(const Model& model, const Surface& surface) {
  constexpr double most_cells_a_side = 160;
  const Vec3 size = surface.bounds().high - surface.bounds().low;
  const double cell = std::max(size.x(), size.y()) / most_cells_a_side;
  const auto columns = static_cast<int>(std::ceil(size.x() / cell - 1e-9));
  const auto rows = static_cast<int>(std::ceil(size.y() / cell - 1e-9));
  const Vec3 low = surface.bounds().low + Vec3(0.5 * cell, 0.5 * cell, 0);
  Json z = Json::array();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto ground = surface.elevation(low.x() + column * cell, low.y() + row * cell);
      z.push_back(ground ? Json(std::round((*ground + model.frame.origin.z()) * 1000) / 1000) : Json(nullptr));
    }
  }
  const Vec3 first = model.frame.global_from_local(low);
  return {{"x0", first.x()}, {"y0", first.y()}, {"cell_m", cell}, {"columns", columns}, {"rows", rows}, {"z_m", z}};
}

template <class Surface>
Json surface_json(const Model& model, const Surface& surface, const char* kind) {
  const Vec3 low = model.frame.global_from_local(surface.bounds().low);
  const Vec3 high = model.frame.global_from_local(surface.bounds().high);
  Json json = {{"kind", kind}};
  if (!model.crs_wkt.empty()) json["crs_wkt"] = model.crs_wkt;
  json["bounds"] = {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
  json["triangles"] = surface.facet_count();
  json["relief"] = relief_json(model, surface);
  return json;
}

Json terrain_json(const Model& model, const TriangleMesh& mesh) { return surface_json(model, mesh, "mesh"); }
Json terrain_json(const Model& model, const RasterSurface& raster) { return surface_json(model, raster, "raster"); }

/// The foot of a barrier on the ground; in a section, which has no plan, where it stands.
Json foot_json(const Model& model, const Barrier& barrier) {
  Json foot = Json::array();
  const auto add = [&](const Vec3& local) {
    const Vec3 p = model.frame.global_from_local(local);
    foot.push_back({p.x(), p.y(), p.z()});
  };
  if (std::holds_alternative<Profile>(model.surface)) {
    if (!barrier.panels().empty()) add(barrier.panels().front().foot.cwiseProduct(Vec3(1, 0, 1)));
    return foot;
  }
  for (const Panel& panel : barrier.panels()) add(panel.foot);
  if (!barrier.panels().empty())
    add(barrier.panels().back().foot + barrier.panels().back().length * barrier.panels().back().along);
  return foot;
}

/// How far along the line as it was given each point of the foot is, on plan: nothing where it is as far along the
/// foot.
Json stations_json(const Barrier& barrier) {
  constexpr double by_rounding = 1e-6;  // [m]
  Json stations = Json::array();
  bool is_as_far = true;
  double along_foot = 0;
  const auto add = [&](double station) {
    stations.push_back(station);
    is_as_far = is_as_far && std::abs(station - along_foot) <= by_rounding;
  };
  for (const Panel& panel : barrier.panels()) {
    add(panel.station);
    along_foot += panel.length * std::hypot(panel.along.x(), panel.along.y());
  }
  if (!barrier.panels().empty()) add(barrier.panels().back().station + barrier.panels().back().plan_length);
  return is_as_far ? Json() : stations;
}

/// Which rocks come from which source: of each the first rock and the number of each unbroken row of them.
Json sources_json(const Model& model) {
  std::vector<Json> rocks(model.sources.size(), Json::array());
  for (const Seeder& seeder : model.seeders) {
    for (const SourceRun& run : source_runs(seeder, model.seed, model.sampling)) {
      Json& list = rocks.at(run.source.index);
      const bool goes_on =
          !list.empty() && list.back()[0].get<std::uint64_t>() + list.back()[1].get<std::uint64_t>() == run.first_rock;
      if (goes_on) {
        list.back()[1] = list.back()[1].get<std::uint64_t>() + run.rocks;
      } else {
        list.push_back({run.first_rock, run.rocks});
      }
    }
  }
  Json sources = Json::array();
  for (std::size_t k = 0; k < rocks.size(); ++k) {
    sources.push_back({{"name", model.sources[k]}, {"rocks", std::move(rocks[k])}});
  }
  return sources;
}

/// What is known of a barrier beforehand; its tally is added later.
Json barrier_json(const Model& model, const Barrier& barrier) {
  Json json{{"name", barrier.name},
            {"kind", barrier.is_collector ? "collector" : "barrier"},
            {"line_xyz", foot_json(model, barrier)}};
  if (std::holds_alternative<Profile>(model.surface)) return json;
  if (Json stations = stations_json(barrier); !stations.is_null()) json["stations_m"] = std::move(stations);
  return json;
}

/// The kernel's origin, next to which positions are counted. None of it is a negative zero.
Json origin_json(const LocalFrame& frame) {
  const Vec3 origin = frame.origin + Vec3::Zero();
  return {origin.x(), origin.y(), origin.z()};
}

}  // namespace

Json model_json(const Model& model) {
  Json barriers = Json::array();
  for (const Barrier& barrier : model.barriers) barriers.push_back(barrier_json(model, barrier));
  return {{"seed", model.seed},
          {"barriers", std::move(barriers)},
          {"sources", sources_json(model)},
          {"energy_datum_m", model.energy_datum},
          {"origin_m", origin_json(model.frame)},
          {"terrain", std::visit([&](const auto& surface) { return terrain_json(model, surface); }, model.surface)}};
}

}  // namespace talus
