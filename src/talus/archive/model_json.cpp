#include "talus/archive/model_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "talus/archive/run_summary.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

TerrainSummary terrain_of(const Model& model, const Profile& profile) {
  TerrainSummary terrain{.kind = "section"};
  const auto point = [&](const Vec3& local) {
    const Vec3 p = model.frame.global_from_local(local);
    terrain.section.push_back({p.x(), p.z()});
  };
  for (std::uint32_t k = 0; k < profile.facet_count(); ++k) {
    const Outline outline = profile.outline({k});
    point(outline.edges[0].point);
    if (k + 1 == profile.facet_count()) point(outline.edges[1].point);
  }
  return terrain;
}

// The terrain as a coarse grid of elevations, for pictures.
template <class Surface>
Relief relief_of(const Model& model, const Surface& surface) {
  constexpr double most_cells_a_side = 160;
  const Vec3 size = surface.bounds().high - surface.bounds().low;
  const double cell = std::max(size.x(), size.y()) / most_cells_a_side;
  const auto columns = static_cast<int>(std::ceil(size.x() / cell - 1e-9));
  const auto rows = static_cast<int>(std::ceil(size.y() / cell - 1e-9));
  const Vec3 low = surface.bounds().low + Vec3(0.5 * cell, 0.5 * cell, 0);
  const Vec3 first = model.frame.global_from_local(low);
  Relief relief{.x0 = first.x(),
                .y0 = first.y(),
                .cell_m = cell,
                .columns = static_cast<std::uint64_t>(columns),
                .rows = static_cast<std::uint64_t>(rows)};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto ground = surface.elevation(low.x() + column * cell, low.y() + row * cell);
      std::optional<double>& z = relief.z_m.emplace_back();
      if (ground) z = std::round((*ground + model.frame.origin.z()) * 1000) / 1000;
    }
  }
  return relief;
}

template <class Surface>
TerrainSummary surface_of(const Model& model, const Surface& surface, const char* kind) {
  const Vec3 low = model.frame.global_from_local(surface.bounds().low);
  const Vec3 high = model.frame.global_from_local(surface.bounds().high);
  return {.kind = kind,
          .crs_wkt = model.crs_wkt,
          .bounds = {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}},
          .triangles = surface.facet_count(),
          .relief = relief_of(model, surface)};
}

TerrainSummary terrain_of(const Model& model, const TriangleMesh& mesh) { return surface_of(model, mesh, "mesh"); }
TerrainSummary terrain_of(const Model& model, const RasterSurface& raster) {
  return surface_of(model, raster, "raster");
}

/// The foot of a barrier on the ground; in a section, which has no plan, its point.
std::vector<std::array<double, 3>> foot_of(const Model& model, const Barrier& barrier) {
  std::vector<std::array<double, 3>> foot;
  const auto add = [&](const Vec3& local) {
    const Vec3 p = model.frame.global_from_local(local);
    foot.push_back({p.x(), p.y(), p.z()});
  };
  if (std::holds_alternative<Profile>(*model.surface)) {
    if (!barrier.panels().empty()) add(barrier.panels().front().foot.times(Vec3(1, 0, 1)));
    return foot;
  }
  for (const Panel& panel : barrier.panels()) add(panel.foot);
  if (!barrier.panels().empty())
    add(barrier.panels().back().foot + barrier.panels().back().length * barrier.panels().back().along);
  return foot;
}

/// The stations of the points of the foot along the line of the input, on plan; empty if they equal those along the
/// foot.
std::vector<double> stations_of(const Barrier& barrier) {
  constexpr double by_rounding = 1e-6;  // [m]
  std::vector<double> stations;
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
  if (is_as_far) stations.clear();
  return stations;
}

std::vector<SeederReleases> releases_of(const Model& model) {
  std::vector<SeederReleases> releases;
  for (const Seeder& seeder : model.seeders) {
    SeederReleases& of = releases.emplace_back(SeederReleases{release_order(seeder, model.seed)});
    for (const SourceRun& run : source_runs(seeder, model.seed))
      of.sources.push_back({run.first_place, run.source.index});
  }
  return releases;
}

std::vector<SourceRocks> sources_of(const Model& model, const std::vector<SeederReleases>& releases) {
  std::vector<SourceRocks> sources(model.sources.size());
  for (std::size_t k = 0; k < sources.size(); ++k) sources[k].name = model.sources[k];
  for (const SeederReleases& of : releases) {
    of.for_sources([&](std::uint64_t source, std::uint64_t begin, std::uint64_t end) {
      sources.at(source).rocks += of.rocks_from(begin, end, of.rocks);
    });
  }
  return sources;
}

/// The facts of a barrier that are known before the run.
BarrierPlace place_of(const Model& model, const Barrier& barrier) {
  BarrierPlace place{.name = barrier.name,
                     .kind = barrier.is_collector ? "collector" : "barrier",
                     .line_xyz = foot_of(model, barrier)};
  if (!std::holds_alternative<Profile>(*model.surface)) place.stations_m = stations_of(barrier);
  return place;
}

/// The origin of the local frame, without negative zeros.
Json origin_json(const LocalFrame& frame) {
  const Vec3 origin = frame.origin + Vec3{};
  return {origin.x(), origin.y(), origin.z()};
}

}  // namespace

TerrainSummary terrain_summary(const Model& model) {
  return std::visit([&](const auto& surface) { return terrain_of(model, surface); }, *model.surface);
}

Json model_json(const Model& model) {
  Json barriers = Json::array();
  for (const Barrier& barrier : model.barriers) barriers.push_back(json_of(place_of(model, barrier)));
  const std::vector<SeederReleases> releases = releases_of(model);
  Json json = {{"seed", model.seed},
               {"barriers", std::move(barriers)},
               {"sources", json_of(sources_of(model, releases))},
               {"releases", json_of(releases)},
               {"energy_datum_m", model.energy_datum},
               {"origin_m", origin_json(model.frame)},
               {"terrain", json_of(terrain_summary(model))}};
  if (!model.ensembles.empty())
    json["parameter_sets"] = std::set(model.drawn_parameters.begin(), model.drawn_parameters.end()).size();
  return json;
}

}  // namespace talus
